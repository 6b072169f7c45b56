"""A Jacobian of functions f_x and f_y is that of the coordinates."""

from __future__ import annotations

import pytest

from armproof import verify_text

PAGE = r"""---
arm: planar_2r
---

$$ J = \begin{bmatrix} \frac{\partial f_x}{\partial \theta_1} & \frac{d f_x}{d \theta_2} \\ \frac{\partial FIRST}{\partial \theta_1} & \frac{\partial f_y}{\partial \theta_2} \end{bmatrix} = \begin{bmatrix} -l_1 s_1 - l_2 s_{12} & -l_2 s_{12} \\ l_1 c_1 + l_2 c_{12} & SIGN l_2 c_{12} \end{bmatrix} $$
"""


@pytest.mark.parametrize(
    ("first", "sign", "verdict"),
    [("f_y", "", "proved"), ("f_y", "-", "refuted"), ("f_x", "", "refuted"), ("g_y", "", "unchecked")],
)
def test_functions_with_the_names_of_axes_are_the_coordinates(first: str, sign: str, verdict: str) -> None:
    [record] = verify_text(PAGE.replace("FIRST", first).replace("SIGN", sign)).equations
    assert record.verdict == verdict


def test_a_force_is_none() -> None:
    front = PAGE.partition("$$")[0]
    [record] = verify_text(front + r"$$ \tau_1 = \frac{\partial f_x}{\partial \theta_1} + f_x $$" + "\n").equations
    assert record.verdict == "unchecked"
