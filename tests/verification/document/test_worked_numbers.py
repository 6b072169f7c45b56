"""What is worked out in numbers: of a target that is reached, and of angles that the text gives."""

from __future__ import annotations

import pytest

from armproof import verify_text

TABLE = """
| i | a_i | alpha_i | d_i | theta_i |
|---|---|---|---|---|
| 1 | 0 | 90° | 0.3 | θ_1 |
| 2 | 0.5 | 0 | 0 | θ_2 |
| 3 | 0.4 | 0 | 0 | θ_3 |
"""
TARGET = (
    TABLE
    + r"""
The target is $x = 0.4$, $y = 0.3$, $z = 0.6$.

$$\theta_1 = \text{atan2}(y, x) = \text{atan2}(0.3, 0.4) = 36.87°$$

$$r = \sqrt{x^2+y^2} = \sqrt{0.16+0.09} = 0.5$$

$$D = \frac{r^2 + (z - 0.3)^2 - 0.25 - 0.16}{0.4} = -0.175$$

$$\theta_3 = \text{atan2}(\sqrt{1-D^2}, D) = 100.08°$$

$$\theta_2 = \text{atan2}(z - 0.3, r) - \text{atan2}(0.4\sin\theta_3, 0.5 + 0.4\cos\theta_3) = -11.52°$$
"""
)
GIVEN = (
    TABLE
    + r"""
Find the pose at $\theta_1 = 30°$, $\theta_2 = 45°$, $\theta_3 = -30°$.

$$^0P_3 = {}^0_1R\begin{bmatrix}0.7399\\0.4571\\0\end{bmatrix}+\begin{bmatrix}0\\0\\0.3\end{bmatrix} = \begin{bmatrix}0.6408\\0.3700\\0.7571\end{bmatrix}$$
"""
)


def verdicts(text: str) -> list[str]:
    return [str(each.verdict) for each in verify_text(text).equations]


def test_numbers_worked_out_of_a_target_are_those_of_what_reaches_it() -> None:
    assert set(verdicts(TARGET)) <= {"confirmed", "proved"}


@pytest.mark.parametrize(("right", "wrong"), [("100.08", "110.08"), ("-11.52", "11.52"), ("36.87", "63.87")])
def test_a_misprint_among_them_is_no_pass(right: str, wrong: str) -> None:
    found = verdicts(TARGET.replace(right + "°", wrong + "°"))
    assert not set(found) <= {"confirmed", "proved", "defined"}


def test_numbers_made_of_a_matrix_and_rounded_numbers_are_those_of_the_angles_given() -> None:
    assert verdicts(GIVEN)[-1] == "confirmed"
    assert verdicts(GIVEN.replace("0.7571", "0.7751"))[-1] != "confirmed"


def test_a_matrix_at_the_end_of_a_line_of_text_is_a_display_unless_it_is_given_in_numbers() -> None:
    link = r"The first link: $T = \begin{bmatrix} c_1 & -s_1 \\ s_1 & c_1 \end{bmatrix}$"
    assert len(verdicts(f"Links.\n\n{link}\nand so on.\n")) == 1
    given = r"Let $v = \begin{bmatrix} 0 \\ 3 \end{bmatrix}$."
    assert verdicts(f"{given}\nand so on.\n") == []
