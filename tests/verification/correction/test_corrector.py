"""What mends a refuted display: verified with the document, the smallest change first, nothing where nothing does."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from armproof.verification.check import check_document
from armproof.verification.correction import corrected, corrected_latex, edits
from armproof.verification.correction.corrector import Corrector, joined
from armproof.verification.document import parse_document, read_document
from armproof.verification.verdict import Correction, Record, Verdict
from tests.sweeps.correct import HANDOUTS

FRONT = """---
arm: planar_2r
quantities:
  p_1: {origin: 1}
  p_2: {origin: 2}
  J_v: {jacobian: 2, rows: [1, 2]}
  J_L: {jacobian: 2, rows: [1, 2]}
  J_W: {jacobian: 2, rows: [1, 2, 6]}
  J_T: {jacobian: 2, rows: [1, 2, 3]}
  x: {origin: 2, component: x}
  y: {origin: 2, component: y}
---
"""
J = r"\begin{bmatrix} -l_1 S_1 - l_2 S_{12} & -l_2 S_{12} \\ l_1 C_1 + l_2 C_{12} & l_2 C_{12} \end{bmatrix}"
WRONG_J = J.replace("& -l_2 S_{12}", "& l_2 S_{12}")
P = r"\begin{bmatrix} l_1 C_1 + l_2 C_{12} \\ l_1 S_1 + l_2 S_{12} \\ 0 \end{bmatrix}"


def records(*displays: str) -> tuple[Record, ...]:
    text = FRONT + "".join(f"\n$$ {display} $$\n" for display in displays)
    return check_document(parse_document(Path("page.md"), text), correct=True).equations


def record(display: str) -> Record:
    return records(display)[-1]


# A wrong display and the right one that is nearest to it.
SLIPS = {
    "a sign in a cell": (f"J_v = {WRONG_J}", f"J_v = {J}"),
    "a formula beside an angle": (r"\cos\theta_2 = \frac{x^2 + y^2 - l_1^2 + l_2^2}{2 l_1 l_2}",
                                  r"\cos\theta_2 = \frac{x^2 + y^2 - l_1^2 - l_2^2}{2 l_1 l_2}"),
    "a scalar": (r"\det J_v = l_1 l_2 \cos\theta_2", r"\det J_v = l_1 l_2 \sin\theta_2"),
    "two equations": (r"l_1 + C_1^2 = l_1 + S_1^2 + 1, \quad S_2^2 = 1 + C_2^2", None),
    "a dot for a cross": (r"p_1 \cdot p_2 = \begin{bmatrix} 0 \\ 0 \\ l_1 l_2 S_2 \end{bmatrix}",
                          r"p_1 \times p_2 = \begin{bmatrix} 0 \\ 0 \\ l_1 l_2 S_2 \end{bmatrix}"),
    "an identity of another size": (r"J_v J_v^{-1} = I_3", r"J_v J_v^{-1} = I_2"),
    "unequal though equal": (r"C_{12}^2 + S_{12}^2 \neq 1", r"C_{12}^2 + S_{12}^2 = 1"),
    "the wrong way round": (r"C_1^2 \geq 2", None),
    "a coordinate too few": (rf"p_2 = {P[:-13]} \\ 0 \end{{bmatrix}}", None),
    "a determinant of no square": (r"\det J_T = 0 \iff \sin\theta_2 = 0", r"\det (J_T^T J_T) = 0 \iff \sin\theta_2 = 0"),
    "a size under a brace": (rf"\underbrace{{{J}}}_{{2 \times 3}} = J_v", rf"\underbrace{{{J}}}_{{2 \times 2}} = J_v"),
    "a transpose": (rf"J_v^T = {J}", None),
    "a Unicode letter": ("det J_v = l_1 l_2 · cos θ_2", None),
    "a row of zeros too many": (r"\begin{bmatrix} J_v^T J_v \\ 0 & 0 \end{bmatrix} = J_v^T J_v", r"\begin{bmatrix} J_v^T J_v \end{bmatrix} = J_v^T J_v"),
    "a row too few": (r"p_2 = \begin{bmatrix} l_1 C_1 + l_2 C_{12} \end{bmatrix}", f"p_2 = {P}"),
}  # fmt: skip


@pytest.mark.parametrize("name", SLIPS)
def test_a_slip_is_mended_and_what_is_offered_verifies(name: str) -> None:
    wrong, right = SLIPS[name]
    found = record(wrong)
    assert found.verdict is Verdict.REFUTED, (found.verdict, found.message)
    latex = corrected_latex(found)
    assert latex is not None and latex != found.latex, found.message
    again = record(latex)
    assert again.verdict in (Verdict.PROVED, Verdict.CONFIRMED), (latex, again.verdict, again.message)
    if right is not None:
        assert latex.split() == right.split()


@pytest.mark.parametrize(
    "display",
    [
        r"l_1 l_2 S_2 = \det(J_v J_v^T)",
        r"\det(J_W) = l_1 l_2 S_2",
        r"\det(J_W) = 0",
        r"\det(J_v J_v^T) = \det J_v",
        r"\det J_v = l_1 l_2 \cos\theta_2",
        r"l_1 l_2 C_2 = \det J_v",
        r"p_2 = p_1",
    ],
)
def test_the_quantity_itself_is_never_changed(display: str) -> None:
    found = record(display)
    assert found.verdict is Verdict.REFUTED
    left, right = display.split(" = ")
    latex = corrected_latex(found) or display
    kept = next(side for side in (left, right) if "J" in side or "p_" in side)
    new = latex.split(" = ")
    assert kept in (each.strip() for each in new) and new[0].strip() != new[1].strip()


@pytest.mark.parametrize(
    "display",
    [
        r"l_1 l_2 S_2 = l_1 l_2 C_2",
        r"S_1 = C_1",
        "1 = 0",
        r"\det J_v \neq \det(J_v)",
        r"\det J_v = l_1 l_2 \sin\theta_2 = l_1 l_2 \cos\theta_2",
        rf"J_v = {WRONG_J} = {J}",
    ],
)
def test_no_tautology_is_offered(display: str) -> None:
    found = record(display)
    assert found.verdict is Verdict.REFUTED
    assert found.corrections == ()


def test_what_would_become_the_left_side_itself_is_mended_otherwise() -> None:
    latex = corrected_latex(record(r"\det(J_v) = \det(J_v^T J_v)"))
    assert latex is not None
    left, right = (side.strip() for side in latex.split(" = "))
    assert left == r"\det(J_v)" != right


@pytest.mark.parametrize(
    "display",
    [
        r"J_v J_v^{-1} = J_v",
        r"z_0 \times p_2 = p_2",
        r"\left. p_2 \right|_{\theta_1 = 0} = p_2",
        r"\begin{bmatrix} \dot x \\ \dot y \end{bmatrix} = J_v \begin{bmatrix} \dot\theta_2 \\ \dot\theta_1 \end{bmatrix}",
        r"\det J_W = 0 \iff \sin\theta_2 = 0",
    ],
)
def test_what_is_on_the_left_of_another_quantity_is_not_replaced_by_its_value(display: str) -> None:
    found = record(display)
    assert found.verdict is Verdict.REFUTED, found.message
    assert found.corrections == ()


def test_only_the_wrong_cell_changes() -> None:
    found = record(f"J_v = {WRONG_J}")
    [change] = edits(found)
    assert (found.latex[change.start : change.end], change.text) == ("l_2 S_{12}", "-l_2 S_{12}")
    made = corrected(found)
    assert made is not None
    [(start, end)] = made.spans
    assert made.latex[start:end] == "-l_2 S_{12}"


def test_what_is_right_and_what_cannot_be_read_have_no_correction() -> None:
    for display in (f"J_v = {J}", "C_{12} = k_9", "C_{12} = }"):
        assert corrected(record(display)) is None


def test_a_condition_that_no_small_slip_explains_is_left_alone() -> None:
    found = record(r"\det J_v = 0 \iff \cos\theta_1 \sin\theta_1 \cos\theta_2 = 1")
    assert found.corrections in ((), None)


def test_corrections_are_sought_only_when_asked_for() -> None:
    text = f"{FRONT}\n$$ J_v = {WRONG_J} $$\n"
    [found] = check_document(parse_document(Path("page.md"), text)).equations
    assert found.corrections is None
    assert [change.text for change in edits(found)] == ["-l_2 S_{12}"]  # as its entries tell


def test_a_correction_that_does_not_verify_is_not_offered(monkeypatch: pytest.MonkeyPatch) -> None:
    def spoil(*_: object) -> Callable[[], object]:
        return iter([(Correction(0, 1, "x"),), (Correction(0, 3, r"\frac{"),), ()])  # type: ignore[return-value]

    monkeypatch.setattr(Corrector, "_candidates", spoil)
    assert record(f"J_v = {WRONG_J}").corrections == ()


def test_a_correction_may_not_turn_a_claim_into_a_definition(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Corrector, "_candidates", lambda *_: iter([(Correction(0, 3, "Q_{new}"),)]))
    assert record(f"J_v = {WRONG_J}").corrections == ()


def test_a_correction_within_another_counts_once() -> None:
    outer, inner, twin = Correction(2, 9, "x"), Correction(3, 4, "y"), Correction(12, 13, "z")
    assert joined([(inner,), (outer, twin), (twin,)]) == (outer, twin)


@pytest.mark.parametrize("name", ["jacobian-revolute-002", "jacobian-general-002", "scara-000"])
def test_what_is_tried_for_a_correction_gives_no_name_a_meaning(name: str) -> None:
    document = read_document(HANDOUTS / f"{name}.md")
    plain, tried = (check_document(document, correct=each).equations for each in (False, True))
    assert [record.verdict for record in tried] == [record.verdict for record in plain]
    assert any(record.corrections is not None for record in tried)
