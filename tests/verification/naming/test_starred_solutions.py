"""A star tells a second solution from the first where an equation says what it is by the plain name."""

import pytest

from armproof import verify_text
from armproof.verification.naming.dresses import starred_names
from armproof.verification.verdict import Verdict

HOLDS = (Verdict.PROVED, Verdict.CONFIRMED)
ARM = r"""---
arm:
  dh: classic
  rows:
    - {a: l_1, alpha: 0, d: 0, theta: theta_1}
    - {a: l_2, alpha: 0, d: 0, theta: theta_2}
---
$$ x = l_1 c_1 + l_2 c_{12} $$

"""


def test_a_formula_of_the_plain_name_tells_them_apart():
    assert starred_names([r"\theta_2^* = -\theta_2"]) == {"theta_2"}
    assert starred_names([r"\theta_1^* = \theta_1 + \pi"]) == {"theta_1"}
    assert starred_names([r"\theta_1^* = q_1", r"x = l_1 \cos\theta_1"]) == set()


def test_a_star_that_marks_joint_variables_tells_nothing():
    assert starred_names([r"A_1(\theta_1^*) = R_z(\theta_1)", r"c_1 = \cos\theta_1^*"]) == set()


@pytest.mark.parametrize(("sign", "holds"), [("+", True), ("-", False)])
def test_the_second_solution_reaches_the_same_point(sign, holds):
    page = rf"""{ARM}
$$ \theta_2^* = -\theta_2 $$

$$ \theta_1^* = \theta_1 {sign} 2 \operatorname{{atan2}}(l_2 s_2, l_1 + l_2 c_2) $$

$$ x = l_1 \cos\theta_1^* + l_2 \cos(\theta_1^* + \theta_2^*) $$
"""
    equations = verify_text(page).equations
    assert (equations[-1].verdict in HOLDS) is holds
    assert (equations[2].verdict is Verdict.DEFINED) is holds


@pytest.mark.parametrize(("sign", "holds"), [("-", True), ("", False)])
def test_its_sine_is_another(sign, holds):
    page = rf"""{ARM}
$$ \theta_2^* = -\theta_2 $$

$$ \sin\theta_2^* = {sign}\sin\theta_2 $$
"""
    assert (verify_text(page).equations[-1].verdict in HOLDS) is holds
