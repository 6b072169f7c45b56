"""Statements that documents rarely make, each with its verdict and what is said of it."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

from armproof import verify_text
from armproof.verification.verdict import Record, Verdict

Judge = Callable[..., Record]
BOUND: dict[str, Any] = {
    "arm": "planar_2r",
    "quantities": {"P_x": {"origin": 2, "component": "x"}, "p": {"origin": 2}, "T": {"pose": 2}, "J": {"jacobian": 2, "rows": [1, 2]}},
}  # fmt: skip


@pytest.mark.parametrize(
    ("display", "verdict", "says"),
    [
        (r"l_1 c_1 \propto s_1", Verdict.UNCHECKED, "a condition"),
        (r"\dot P_x = p", Verdict.UNCHECKED, "dot P_x is a vector here"),
        (r"\dot p = c_1", Verdict.UNCHECKED, "dot p is a vector here"),
        (r"\dot p = \begin{bmatrix} 1 \\ 2 \end{bmatrix} c_1", Verdict.REFUTED, ""),
        (r"J_1 = \theta_{12}", Verdict.UNCHECKED, "J_1"),
        (r"l_1 c_1 = P_x \iff l_2 c_{12} = 0", Verdict.UNCHECKED, "what it follows from does not hold of the arm"),
        (r"s_2 = 0 \Rightarrow \operatorname{rank} J < 0", Verdict.REFUTED, ""),
        (r"\text{as above}", Verdict.UNCHECKED, "states no equation"),
        (r"l_1^{0.5} l_1^{0.5} = l_1", Verdict.PROVED, ""),
        (r"l_1^{0.5} l_1^{0.5} = l_2", Verdict.REFUTED, ""),
        (r"l_1^{0.6} l_1^{0.4} = l_1", Verdict.UNCHECKED, "exponent is not an integer"),
        (r"T(2) = 2 T", Verdict.PROVED, ""),
        (r"T(2) = 3 T", Verdict.REFUTED, ""),
        (r"\frac{\partial q}{\partial \theta_2} = (0, 2)^T", Verdict.REFUTED, "entry (2, 1)"),
        (r"\sqrt{l_1^2 (0.5 - \cos\frac{\pi}{5})^2} = l_1 \cos\frac{\pi}{5} - 0.5 l_1", Verdict.PROVED, ""),
        (r"\sqrt{l_1^2 (\cos\frac{\pi}{5} - 0.5)^2} = 0.5 l_1 - l_1 \cos\frac{\pi}{5}", Verdict.REFUTED, ""),
        (r"\sqrt{l_1^2 (\cos 0.5 - 0.9)^2} = 0.9 l_1 - l_1 \cos 0.5", Verdict.PROVED, ""),
        (r"\sqrt{l_1^2 (0.9 - \cos 0.5)^2} = l_1 \cos 0.5 - 0.9 l_1", Verdict.REFUTED, ""),
    ],
)  # fmt: skip
def test_rare_statements_have_their_verdict(judge: Judge, display: str, verdict: Verdict, says: str) -> None:
    record = judge(display, **BOUND)
    assert (record.verdict, says in record.message) == (verdict, True), record.message


@pytest.mark.parametrize(("entry", "verdict"), [("c_{12}", Verdict.PROVED), ("s_{12}", Verdict.REFUTED)])
def test_a_translation_by_three_amounts_takes_a_bound_letter_for_one(
    judge: Judge, entry: str, verdict: Verdict
) -> None:
    matrix = rf"\begin{{bmatrix}} 1&0&0&l_1 c_1 + l_2 {entry} \\ 0&1&0&0\\0&0&1&2\\0&0&0&1\end{{bmatrix}}"
    bound = {"x": {"origin": 2, "component": "x"}}
    record = judge(rf"\operatorname{{Trans}}(x, 0, 2) = {matrix}", arm="planar_2r", quantities=bound)
    assert record.verdict is verdict


def test_a_name_with_two_meanings_is_free_again_in_the_next_section() -> None:
    text = "---\narm: planar_2r\n---\n# A\n$$k = l_1 c_1$$\n\n$$k = l_2 s_2$$\n\n# B\n\n$$k = l_2$$\n\n$$2 k = 2 l_2$$\n\n$$2 k = 2 l_1$$\n"
    verdicts = [record.verdict.value for record in verify_text(text).equations]
    assert verdicts == ["unchecked", "unchecked", "defined", "proved", "refuted"]


@pytest.mark.parametrize("second", [r"\dot u = 0", r"\frac{\partial u}{\partial \theta_1} = 0"])
def test_an_identity_matrix_without_a_size_has_no_derivative(judge: Judge, second: str) -> None:
    record = judge("u = 3 I", second, arm="planar_2r")
    assert record.verdict is Verdict.UNCHECKED
    assert record.message.startswith("an identity matrix whose size cannot be told")
