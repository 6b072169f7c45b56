"""Sections that speak of none of a document's arm are judged as they are without one."""

from __future__ import annotations

from armproof.verification.check import verify_text

ARM = r"""# Two links
$$ A_1 = \begin{bmatrix} c_1 & -s_1 & 0 & l_1 c_1 \\ s_1 & c_1 & 0 & l_1 s_1 \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix} $$
$$ A_2 = \begin{bmatrix} c_2 & -s_2 & 0 & l_2 c_2 \\ s_2 & c_2 & 0 & l_2 s_2 \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix} $$
$$ x = l_1 c_1 + l_2 c_{12} $$
"""
EULER = r"""
## Angles of Euler
$$ R = R_z(\phi) R_y(\theta) = \begin{bmatrix} c_\phi c_\theta & -s_\phi & c_\phi s_\theta \\ s_\phi c_\theta & c_\phi & s_\phi s_\theta \\ -s_\theta & 0 & c_\theta \end{bmatrix} $$
"""


def last(text: str) -> str:
    return verify_text(text).equations[-1].verdict.value


def test_angles_of_euler_beside_an_arm_are_decided() -> None:
    assert last(ARM + EULER) == "proved"
    assert last(ARM + EULER.replace(r"-s_\theta & 0", r"s_\theta & 0")) == "refuted"


def test_what_is_written_with_the_letters_of_the_arm_is_not_judged_without_it() -> None:
    of_arm = r"$$ P + Q = l_1 + l_2 $$"
    assert last(ARM + "\n## Sums\n" + of_arm) == "unchecked"


def test_a_law_that_holds_of_no_letters_is_not_refuted() -> None:
    assert last(ARM + "\n## Sums\n" + r"$$ A \cos\beta + B \sin\beta = D $$") == "unchecked"
