r"""A name that convention binds is what the document has shown it to be: the rate of a coordinate, the third of a column, a sign in a square."""

from __future__ import annotations

import pytest

from armproof import verify_text
from armproof.verification.verdict import Verdict

PLANAR = r"""---
arm: planar_2r
---

## Position

$$ x_P = l_1 c_1 + l_2 c_{12} $$

$$ y_P = l_1 s_1 + l_2 s_{12} $$

## Geschwindigkeit

$$ \dot y_P = {rate} $$
"""
ANTHROPOMORPHIC = """---
arm:
  dh: classic
  rows:
    - {a: 0, alpha: pi/2, d: d_1, theta: theta_1}
    - {a: a_2, alpha: 0, d: 0, theta: theta_2}
    - {a: a_3, alpha: 0, d: 0, theta: theta_3}
---

"""
COLUMN = r"$$ \begin{pmatrix} x \\ y \\ z \end{pmatrix} = \begin{pmatrix} c_1 (a_2 c_2 + a_3 c_{23}) \\ s_1 (a_2 c_2 + a_3 c_{23}) \\ HEIGHT \end{pmatrix} $$"
RATES = r"""$$ \dot x = -s_1 (a_2 c_2 + a_3 c_{23}) \dot\theta_1 - c_1 (a_2 s_2 + a_3 s_{23}) \dot\theta_2 - a_3 c_1 s_{23} \dot\theta_3 $$

$$ \dot z = RATE $$
"""


def last(text: str) -> Verdict:
    return verify_text(text).equations[-1].verdict


@pytest.mark.parametrize(
    ("rate", "verdict"),
    [
        (r"l_1 c_1 \dot\theta_1 + l_2 c_{12} (\dot\theta_1 + \dot\theta_2)", Verdict.PROVED),
        (r"l_1 c_1 \dot\theta_1 + l_2 c_{12} \dot\theta_2", Verdict.REFUTED),
        (r"l_1 c_1 \dot\theta_1", Verdict.UNCHECKED),  # of the elbow
        (r"l_2 c_{12} \dot\theta_2", Verdict.UNCHECKED),  # the part of joint 2
        (r"l_1 c_1 \dot\theta_1 + l_2 c_2 \dot\theta_2", Verdict.UNCHECKED),  # by angles from the base
    ],
)
def test_a_coordinate_has_no_other_rate_than_its_own(rate: str, verdict: Verdict) -> None:
    assert last(PLANAR.replace("{rate}", rate)) is verdict


@pytest.mark.parametrize(
    ("height", "verdict"),
    [
        ("d_1 + a_2 s_2 + a_3 s_{23}", Verdict.PROVED),
        ("d_1 - a_2 s_2 - a_3 s_{23}", Verdict.REFUTED),
        ("d_1 + a_2 s_2", Verdict.REFUTED),
    ],
)
def test_the_third_of_a_column_is_of_the_point_of_the_two_others(height: str, verdict: Verdict) -> None:
    assert last(ANTHROPOMORPHIC + COLUMN.replace("HEIGHT", height)) is verdict


def test_a_column_of_another_point_is_left_open() -> None:
    wrist = COLUMN.replace("a_2 c_2 + a_3 c_{23}", "a_2 c_2")
    assert last(ANTHROPOMORPHIC + wrist.replace("HEIGHT", "d_1 + a_2 s_2")) is not Verdict.REFUTED
    assert last(ANTHROPOMORPHIC + wrist.replace("HEIGHT", "d_1 + a_3 s_2")) is not Verdict.REFUTED


@pytest.mark.parametrize(
    ("rate", "verdict"),
    [
        (r"(a_2 c_2 + a_3 c_{23}) \dot\theta_2 + a_3 c_{23} \dot\theta_3", Verdict.PROVED),
        (r"a_2 c_2 \dot\theta_2 + a_3 c_{23} \dot\theta_3", Verdict.REFUTED),
        (r"a_2 c_2 \dot\theta_2 + a_3 c_3 \dot\theta_3", Verdict.UNCHECKED),  # by angles from the horizontal
        (r"2 a_2 c_2 \dot\theta_2 + a_3 c_{23} \dot\theta_3", Verdict.REFUTED),
    ],
)
def test_a_rate_beside_the_others_of_its_point_is_of_it(rate: str, verdict: Verdict) -> None:
    assert last(ANTHROPOMORPHIC + RATES.replace("RATE", rate)) is verdict


@pytest.mark.parametrize(("sign", "verdict"), [("-", Verdict.PROVED), ("+", Verdict.REFUTED)])
def test_a_sign_in_a_square_is_a_misprint_and_no_term_of_the_other_side(sign: str, verdict: Verdict) -> None:
    table = r"| 1 | $\theta_1$ | 0 | 0 | $-90^\circ$ |" + "\n" + r"| 2 | $\theta_2$ | $d_2$ | 0 | $90^\circ$ |" + "\n" + r"| 3 | 0 | $d_3$ | 0 | 0 |"  # fmt: skip
    head = "| $i$ | $\\theta_i$ | $d_i$ | $a_i$ | $\\alpha_i$ |\n|---|---|---|---|---|\n"
    page = "{}{}\n\n$$ d_3^2 = x^2 + y^2 + z^2 {} d_2^2 $$\n\n$$ c_1 y - s_1 x = d_2 $$\n\n$$ z = d_3 c_2 $$\n"
    assert verify_text(page.format(head, table, sign)).equations[0].verdict is verdict
