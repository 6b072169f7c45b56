"""Numbers of an example whose configuration the text tells: each right one is confirmed, each wrong one refuted, and what nothing gives is left open."""

from __future__ import annotations

import pytest

from armproof.verification.check import verify_text

ARM = r"""# A planar robot with numbers

The robot has the link lengths $l_1 = 0.5$ m and $l_2 = 0.3$ m. Its forward kinematics is

$$ \begin{aligned} x &= l_1 \cos\theta_1 + l_2 \cos(\theta_1+\theta_2) \\ y &= l_1 \sin\theta_1 + l_2 \sin(\theta_1+\theta_2) \end{aligned} $$

For $\theta_1 = 30^\circ$ and $\theta_2 = 45^\circ$ we get

$$ x = 0.5\cos 30^\circ + 0.3\cos 75^\circ = 0.5107 $$

"""
JACOBIAN = r"""The Jacobian in this pose is

$$ J = \begin{bmatrix} -0.5398 & -0.2898 \\ 0.5107 & 0.0776 \end{bmatrix} $$

"""
DETERMINANT = r"""with the determinant

$$ \det J = l_1 l_2 \sin\theta_2 = %s $$
"""
RATES = r"""With the joint velocities $\dot\theta_1 = 1$ rad/s and $\dot\theta_2 = 2$ rad/s the tip moves with

$$ \begin{bmatrix} \dot x \\ \dot y \end{bmatrix} = J \begin{bmatrix} 1 \\ 2 \end{bmatrix} = \begin{bmatrix} %s \\ 0.6659 \end{bmatrix} $$
"""
FORCE = r"""A force $F = [10, 5]^T$ N on the tip needs the torques

$$ \tau = J^T F = \begin{bmatrix} %s \\ -2.510 \end{bmatrix} $$
"""


def last(text: str) -> str:
    """Return the verdict on the last display."""
    return verify_text(text).equations[-1].verdict.value


@pytest.mark.parametrize(
    ("text", "right", "wrong"),
    [
        pytest.param(DETERMINANT, "0.1061", "0.0750", id="what a formula comes to"),
        pytest.param(RATES, "-1.1193", "-0.5398", id="rates leave the arm where it is"),
        pytest.param(FORCE, "-2.844", "-0.291", id="a force of numbers"),
    ],
)
def test_a_number_is_decided_at_the_values_that_the_text_tells(text: str, right: str, wrong: str) -> None:
    assert last(ARM + JACOBIAN + text % right) == "confirmed"
    assert last(ARM + JACOBIAN + text % wrong) == "refuted"


def test_torques_of_a_force_that_nothing_gives_are_not_confirmed() -> None:
    """They would be compared with themselves: the display has just said what τ is."""
    text = FORCE.replace("$F = [10, 5]^T$ N", "$F$")
    assert last(ARM + JACOBIAN + text % "-0.291") == "unchecked"


ARTICULATED = r"""# An articulated arm

| $i$ | $a_i$ | $\alpha_i$ | $d_i$ | $\theta_i$ |
|---|---|---|---|---|
| 1 | 0 | $90^\circ$ | $d_1$ | $\theta_1$ |
| 2 | $a_2$ | $0^\circ$ | 0 | $\theta_2$ |
| 3 | $a_3$ | $0^\circ$ | 0 | $\theta_3$ |

The base has the height $d_1 = 0.4$ m, the links the lengths $a_2 = 0.5$ m and $a_3 = 0.3$ m. The tool is at

$$ \begin{aligned} x &= \cos\theta_1 (a_2\cos\theta_2 + a_3\cos(\theta_2+\theta_3)) \\ y &= \sin\theta_1 (a_2\cos\theta_2 + a_3\cos(\theta_2+\theta_3)) \\ z &= d_1 + a_2\sin\theta_2 + a_3\sin(\theta_2+\theta_3) \end{aligned} $$

For $\theta_1 = 30^\circ$, $\theta_2 = 45^\circ$, $\theta_3 = -30^\circ$ this gives

$$ z = 0.4 + 0.5\sin 45^\circ + 0.3\sin 15^\circ = 0.831 $$

The homogeneous matrix of the tool at this configuration is

$$ T = \begin{bmatrix} 0.837 & -0.224 & %s & 0.557 \\ 0.483 & %s & -0.866 & 0.322 \\ 0.259 & 0.966 & 0 & %s \\ 0 & 0 & 0 & 1 \end{bmatrix} $$
"""


@pytest.mark.parametrize(
    ("entries", "verdict"),
    [
        (("0.500", "-0.129", "0.831"), "confirmed"),
        (("0.866", "-0.129", "0.831"), "refuted"),
        (("0.500", "0.129", "0.831"), "refuted"),
        (("0.500", "-0.129", "0.431"), "refuted"),
        (("0.866", "0.129", "0.431"), "unchecked"),
    ],
)
def test_a_matrix_with_one_wrong_number_is_what_its_name_usually_is(entries: tuple[str, ...], verdict: str) -> None:
    assert last(ARTICULATED % entries) == verdict
