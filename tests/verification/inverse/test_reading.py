"""The front matter's `inverse` and the steps in the displays: what is read, and what is refused with the valid choices."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from armproof.verification.check import verify
from armproof.verification.document import Display, Document
from armproof.verification.errors import DocumentError
from armproof.verification.inverse import read_inverse
from armproof.verification.inverse.conditions import read_conditions
from armproof.verification.report.text import text_report
from tests.verification.inverse.test_proof import ELBOW, SHOULDER, TWO_LINKS, XY, D, K

STEPS = (D, ELBOW, K, SHOULDER)


def document(*displays: str, **front: Any) -> Document:
    """Return a document on the two-link arm."""
    matter = {"arm": TWO_LINKS, "quantities": XY, "inverse": {"target": ["X", "Y"]}, **front}
    found = tuple(Display(line, latex) for line, latex in enumerate(displays, 1))
    return Document(Path("page.md"), matter, found, (), {"inverse": 7})


@pytest.mark.parametrize(
    ("inverse", "words"),
    [
        (None, r"must say what is given, as target: \[X, Y, psi\]"),
        ({"solve": ["theta_1", "theta_2"]}, "must say what is given"),
        ({"target": ["X", "Y"], "order": []}, "unknown option order; the options are target, solve"),
        ({"target": []}, "a target is a list of names"),
        ({"target": ["X", 3]}, "a target is a list of names"),
        ({"target": ["X", "X"]}, "stands twice in the target"),
        ({"target": ["X", r"\frac{1}{2}"]}, "is not a name"),
        ({"target": ["X", "W"]}, "'W' of the target is neither in `quantities` nor defined by a display"),
        ({"target": {"jacobian": 2}}, "a target is one of pose, rotation, origin"),
        ({"target": {"pose": 9}}, "no frame '9'.*its frames are 0, 1, 2"),
        ({"target": ["X", "J"]}, "is a jacobian; a target is made of pose, rotation, origin, axis"),
        (
            {"target": ["X", "Y"], "solve": ["theta_1"]},
            "must name each joint.*they are theta_1, theta_2, it is theta_1",
        ),
        ({"target": ["X", "Y"], "solve": ["theta_1", "theta_3"]}, "must name each joint"),
        ({"target": ["X", "Y"], "solve": "theta_1"}, "solve is a list of joints, of theta_1, theta_2"),
    ],
)
def test_a_claim_that_cannot_be_read_is_refused_with_the_line(inverse: Any, words: str) -> None:
    quantities = {**XY, "J": {"jacobian": 2}}
    with pytest.raises(DocumentError, match=rf"page\.md:7: .*{words}"):
        read_inverse(document(*STEPS, quantities=quantities, inverse=inverse))


def test_a_document_without_an_arm_has_no_inverse(check: Callable[..., Any]) -> None:
    with pytest.raises(DocumentError, match="the front matter names no arm"):
        check("a = a", arm=None, inverse={"target": ["X"]})


def test_a_document_without_the_key_is_refused() -> None:
    with pytest.raises(DocumentError, match="no 'inverse' in the front matter"):
        read_inverse(Document(Path("page.md"), {"arm": TWO_LINKS}, (), ()))


def test_the_steps_and_the_names_on_the_way_are_read() -> None:
    derivation = read_inverse(document(*STEPS)).derivation
    assert [(step.joint, step.formula.line) for step in derivation.steps] == [("theta_2", 2), ("theta_1", 4)]
    assert {"D", "k_1", "k_2"} <= set(derivation.choice)
    assert derivation.branches == ({"theta_2": 1}, {"theta_2": -1})


def test_independent_signs_multiply() -> None:
    signs = [rf"\sigma_{k} = \pm 1" for k in (1, 2)]
    elbow = r"\theta_2 = \sigma_1 \sigma_2 \arccos D"
    assert len(read_inverse(document(D, *signs, elbow, K, SHOULDER)).branches) == 4


def test_too_many_signs_are_refused() -> None:
    signs = [rf"\sigma_{k} = \pm 1" for k in range(1, 8)]
    elbow = r"\theta_2 = " + " ".join(rf"\sigma_{k}" for k in range(1, 8)) + r" \arccos D"
    with pytest.raises(DocumentError, match="7 independent signs; at most 6 are read"):
        read_inverse(document(D, *signs, elbow, K, SHOULDER))


def test_the_documents_own_letters_are_known(check: Callable[..., Any]) -> None:
    displays = [text.replace("theta", "varphi") for text in STEPS]
    symbols = {"varphi_1": "theta_1", "varphi_2": "theta_2"}
    result = check(*displays, arm=TWO_LINKS, quantities=XY, symbols=symbols, inverse={"target": ["X", "Y"]})
    assert result.inverse.verdict.value == "proved", result.inverse.message


def test_an_angle_that_a_display_defines_is_a_target() -> None:
    inverse = read_inverse(
        document(
            r"\psi = \theta_1 + \theta_2",
            r"\theta_2 = \psi - \theta_1",
            r"\theta_1 = \operatorname{atan2}(Y - l_2\sin\psi, X - l_2\cos\psi)",
            inverse={"target": ["X", "Y", "psi"]},
        )
    )
    q = np.random.default_rng(1).uniform(-3, 3, (50, 2))
    found = inverse.solve(inverse.forward(q))
    np.testing.assert_allclose(np.sin(found.q[:, 0] - q), 0.0, atol=1e-12)
    # X, Y and ψ are three numbers for two joints: proved for the targets that the arm has, and not for every other
    assert inverse.proof.verdict.value == "proved" and not inverse.proof.general


def test_a_target_that_the_formulas_overlook_is_out_of_reach() -> None:
    inverse = read_inverse(
        document(
            r"\psi = \theta_1 + \theta_2",
            r"\theta_2 = \psi - \theta_1",
            r"\theta_1 = \operatorname{atan2}(Y - l_2\sin\psi, X - l_2\cos\psi)",
            inverse={"target": ["X", "Y", "psi"]},
        )
    )
    target = inverse.forward([[0.3, 0.4]])
    assert inverse.solve(target).mark[0] == 0
    assert inverse.solve(np.add(target, [[0.01, 0.0, 0.0]])).mark[0] == 3


def test_conditions_are_said_in_the_documents_own_words() -> None:
    conditions = read_conditions(read_inverse(document(*STEPS)).compiled())
    assert conditions.edges == ("1 - D^2",)
    assert conditions.degenerate == ("Y = X = 0", "k_2 = k_1 = 0")


def test_the_verdict_stands_in_text_and_json(tmp_path: Path) -> None:
    page = tmp_path / "page.md"
    front = (
        "arm: planar_2r\nquantities:\n  X: {origin: 2, component: x}\n  Y: {origin: 2, component: y}\n"
        "inverse: {target: [X, Y]}\n"
    )
    page.write_text(f"---\n{front}---\n\n" + "\n\n".join(f"$$ {latex} $$" for latex in STEPS), encoding="utf-8")
    result = verify(page)
    text = "\n".join("".join(part for part, _ in line) for line in text_report([result]))
    assert "inverse kinematics proved: FK(IK(x)) = x proved on each of 2 branches" in text
    record = result.as_json()["inverse"]
    assert (record["verdict"], record["line"], record["samples"]) == ("proved", 6, 1000)
    assert len(result.as_json()["equations"]) == len(STEPS)  # no record of a display of its own
    assert "inverse" not in verify(Path("course/handouts/scara-000.md")).as_json()


def test_a_refuted_inverse_fails_its_document(check: Callable[..., Any]) -> None:
    result = check(
        D, r"\theta_2 = \arccos D", K, SHOULDER, arm=TWO_LINKS, quantities=XY, inverse={"target": ["X", "Y"]}
    )
    assert not result.passed
    text = "\n".join("".join(part for part, _ in line) for line in text_report([result]))
    assert "inverse kinematics refuted" in text and "no branch gives back theta_2" in text
