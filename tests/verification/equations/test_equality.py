"""Equations that are rarely written as tests write them: decimals, identities, blocks, sizes, spaces, conditions."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from armproof.verification.verdict import DocumentResult

FRONT = {"arm": "planar_2r", "quantities": {
    "p": {"origin": 2}, "T": {"pose": 2}, "R": {"rotation": 2}, "J": {"jacobian": 2, "rows": [1, 2]}}}  # fmt: skip
TRANS = r"\mathrm{Trans}(1, 2, 3) = \begin{bmatrix} 1&0&0&1\\0&1&0&2\\0&0&1&%s\\0&0&0&1\end{bmatrix}"
REACH = r"p = \begin{bmatrix} l_1 %s l_2 \\ 0 \\ 0 \end{bmatrix}"


def verdicts(check: Callable[..., DocumentResult], *displays: str, **front: object) -> str:
    return " ".join(record.verdict.value for record in check(*displays, **{**FRONT, **front}).equations)


@pytest.mark.parametrize(
    ("right", "wrong"),
    [
        (r"\sqrt{2} = 1.41", r"\sqrt{2} = 1.42"),
        (r"-\sqrt{2} = -1.414", r"-\sqrt{2} = -1.415"),
        (r"100 \sqrt{2} = 141.421", r"100 \sqrt{2} = 141.452"),  # half a unit, however large the number
        (r"\frac{\pi}{2} = 1.57", r"\frac{\pi}{2} = 1.58"),
        (r"\pi = 3.1416", r"\pi = 3.1415"),
        (r"\frac{2}{3} = 0.67", r"\frac{2}{3} = 0.66"),
        (r"\frac{1}{3} = 0.3", r"\frac{1}{3} = 0.4"),
        (r"\arctan 2 = 63.43^\circ", r"\arctan 2 = 63.53^\circ"),
        (r"45^\circ = 0.79", r"45^\circ = 0.80"),
        (r"\frac{2499995}{10000000} = 0.2", r"\frac{2500005}{10000000} = 0.2"),  # and no hair more
        (r"\sqrt{1.5^2 + 0.054^2} = 1.501", r"\sqrt{1.5^2 + 0.054^2} = 1.502"),
    ],
)
def test_a_decimal_holds_to_half_a_unit_of_its_last(
    check: Callable[..., DocumentResult], right: str, wrong: str
) -> None:
    assert verdicts(check, right, wrong) == "confirmed refuted"


@pytest.mark.parametrize("wrong", [r"\sqrt{2} = 1", "2 = 1.99", r"\sqrt{2} = 2", "0.5 + 0.25 = 0.8"])
def test_a_whole_number_and_a_sum_of_decimals_are_exact(check: Callable[..., DocumentResult], wrong: str) -> None:
    assert verdicts(check, wrong) == "refuted"


@pytest.mark.parametrize(
    ("right", "wrong"),
    [
        (r"T(\Theta) = T", r"T(\Theta) = 2 T"),
        (r"\theta_2 \neq 0, \pi \Rightarrow \operatorname{rank} J = 2", r"\theta_2 \neq 0, \pi \Rightarrow \operatorname{rank} J = 1"),
        ("I I = I", "2 I I = I"),
        ("I + I = 2 I", "I + I = I"),
        ("I - I = 0", "I - I = 1"),
        ("R R^T = I I", "R R^T = 2 I"),
        ("R I = R", "R I = 2 R"),
        ("p + 0 = p", "p + 1 = p"),
        (r"\det(3) = 3", r"\det(3) = 2"),
        (r"\operatorname{tr}(3) = 3", r"\operatorname{tr}(3) = 2"),
        (r"l_1^{1/2} l_1^{\frac{1}{2}} = l_1", r"l_1^{1/2} l_1^{\frac{1}{2}} = l_2"),
        (TRANS % 3, TRANS % 2),
        (r"\frac{\partial l_2 s_2}{\partial \theta_2} = l_2 c_2", r"\frac{\partial l_2 s_2}{\partial \theta_2} = l_2 s_2"),
        (r"\partial l_2 s_2 / \partial \theta_2 = l_2 c_2", r"\partial l_2 s_2 / \partial \theta_2 = l_1 c_2"),
        (r"\frac{\delta}{\delta\theta_2} (l_2 s_2) = l_2 c_2", r"\frac{\delta}{\delta\theta_2} (l_2 s_2) = l_1 c_2"),
        (r"\frac{\delta (l_2 s_2)}{\delta\theta_2} = l_2 c_2", r"\frac{\delta (l_2 s_2)}{\delta\theta_2} = -l_2 c_2"),
        (r"\frac{d l_1 l_2 s_2}{d \theta_2} = l_1 l_2 c_2", r"\frac{d l_1 l_2 s_2}{d \theta_2} = l_2 c_2"),
        (r"\dot{(l_1 c_1)} = -l_1 s_1 \dot\theta_1", r"\dot{(l_1 c_1)} = l_1 s_1 \dot\theta_1"),
        (r"\ddot{(l_1 c_1)} = -l_1 c_1 \dot\theta_1^2 - l_1 s_1 \ddot\theta_1", r"\ddot{(l_1 c_1)} = -l_1 s_1 \dot\theta_1"),
        (r"2/3 l_1 = \frac{2}{3} l_1", r"2/3 l_1 = \frac{2}{3 l_1}"),
        (r"l_1/2/l_2 = \frac{l_1}{2 l_2}", r"l_1/2/l_2 = \frac{l_1 l_2}{2}"),
        (r"\textcolor{red}{l_1} c_1 = c_1 l_1", r"\textcolor{red}{l_1} c_1 = s_1 l_1"),
        (r"90\text{deg} = \frac{\pi}{2}", r"90\text{deg} = \pi"),
        (r"\operatornamewithlimits{rank} J = 2", r"\operatornamewithlimits{rank} J = 1"),
        (r"0_{3 \times 1} = p - p", r"0_{3 \times 2} = p - p"),
        (r"R \in SO(3)", r"2 R \in SO(3)"),
        (r"J \in \mathbb{R}^{2 \times 2}", r"J \in \mathbb{R}^{2 \times 3}"),
        (r"p \in \mathbb{R}^3", r"p \in \mathbb{R}^2"),
        (rf"\theta_1 = \theta_2 = 0 \Rightarrow {REACH % '+'}", rf"\theta_1 = \theta_2 = 0 \Rightarrow {REACH % '-'}"),
        (r"\det(J J^T) = 0 \iff s_2 = 0", r"\det(J J^T) = 0 \iff c_2 = 0"),
        (r"\det(J^T J) = 0 \iff s_2 = 0", r"\det(J^T J) = 0 \iff c_2 = 0"),
        (r"\operatorname{rank} J \neq 2 \iff s_2 = 0", r"\operatorname{rank} J \neq 2 \iff c_2 = 0"),
        (r"\operatorname{rank} J < 2 \iff s_2 = 0", r"\operatorname{rank} J < 3 \iff s_2 = 0"),
        (r"\operatorname{rank} J \leq 1 \iff s_2 = 0", r"\operatorname{rank} J = 0 \iff s_2 = 0"),
        (r"\theta_2 \in \{0, \pi\} \iff \det J = 0", r"\theta_2 \in \{0, \frac{\pi}{2}\} \iff \det J = 0"),
    ],
)  # fmt: skip
def test_what_is_rarely_written_is_told_apart(check: Callable[..., DocumentResult], right: str, wrong: str) -> None:
    assert verdicts(check, right, wrong) == "proved refuted"


@pytest.mark.parametrize(
    "display",
    [
        r"\operatorname{rank}(3) = 1",
        r"R^{1/2} = R",
        r"\mathrm{Trans}(l_1, 0) = I",
        rf"\theta_1 \neq \theta_2 = 0 \Rightarrow {REACH % '-'}",
        r"\operatorname{rank} J \neq 1 \iff s_2 = 0",
        r"R \in SO(2)",
        r"T \in SE(2)",
        r"p \leq p",
        r"T(\alpha, \beta) = T",  # what it is given is not dropped
        r"R(\varphi) = R",
        r"\theta_2 \neq 0 \text{ or } \pi \Rightarrow \operatorname{rank} J = 2",
    ],
)
def test_what_is_not_understood_is_left_open(check: Callable[..., DocumentResult], display: str) -> None:
    assert verdicts(check, display) == "unchecked"


def test_a_zero_stands_for_a_block_of_zeros(check: Callable[..., DocumentResult]) -> None:
    column = r"J_3 = \begin{bmatrix} %s \\ %s \end{bmatrix}"
    displays = [column % cells for cells in (("z_2", "0"), ("0", "z_2"), ("z_2", "z_2"), ("z_2", "1"))]
    found = verdicts(check, *displays, arm="scara", quantities={"J": {"jacobian": 4}})
    assert found == "proved refuted refuted refuted"


@pytest.mark.parametrize(
    ("display", "verdict"),
    [
        (r"18.106 - 8 \cdot 0.643 = 12.964", "unchecked"),  # 8 times half a thousandth
        (
            r"\begin{bmatrix} 18.106 - 8 \cdot 0.643 \\ 2 \end{bmatrix} = \begin{bmatrix} 12.964 \\ 2 \end{bmatrix}",
            "unchecked",
        ),
        (r"18.106 - 8 \cdot 0.643 = 12.974", "refuted"),
        (r"0.5 \cdot 3 = 1.6", "refuted"),  # a length of 0.5 is exact
    ],
)
def test_a_sum_of_rounded_numbers_is_as_near_as_they_are(
    check: Callable[..., DocumentResult], display: str, verdict: str
) -> None:
    assert verdicts(check, display) == verdict
