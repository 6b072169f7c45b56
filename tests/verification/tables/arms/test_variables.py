"""q_i beside θ_i: the variable of a joint, and the angle of its row in the DH table."""

from __future__ import annotations

import pytest

from armproof import verify_text
from armproof.verification.verdict import Verdict

HEAD = "| i | a | alpha | d | theta |\n|---|---|---|---|---|\n| 1 | $l_1$ | 0 | 0 | $q_1$ |\n"
OFFSET = HEAD + "| 2 | $l_2$ | 0 | 0 | $q_2 + \\pi/2$ |\n\n"
ANGLES = OFFSET.replace("q_1", "\\theta_1").replace("q_2 + \\pi/2", "\\theta_2")
X = "$$ x = l_1 \\cos q_1 - l_2 \\sin(q_1 + q_2) $$\n\n"
Y = "$$ y = l_1 \\sin\\theta_1 + l_2 \\sin(\\theta_1 + \\theta_2) $$\n\n"
TOLD = "$$ \\theta_2 = q_2 + \\frac{\\pi}{2} $$\n\n"


def verdicts(text: str) -> list[str]:
    return [record.verdict.value for record in verify_text(text).equations]


def test_beside_q_the_other_letter_is_the_angle_of_the_table() -> None:
    assert verdicts(OFFSET + X + Y) == ["proved", "proved"]
    assert verdicts(OFFSET + X + Y.replace("\\theta_1 + \\theta_2", "\\theta_1 - \\theta_2"))[1] != "proved"
    assert verdicts(OFFSET + TOLD + X + Y.replace("+ l_2 \\sin", "+ l_2 \\cos"))[2] == "refuted"


def test_where_nobody_says_what_the_angle_is_it_may_be_the_variable() -> None:
    loose = Y.replace("+ l_2 \\sin", "+ l_2 \\cos")
    assert verdicts(OFFSET + X + loose) == ["proved", "unchecked"]
    assert verdicts(OFFSET + X + loose.replace("l_1 \\sin", "l_1 \\cos"))[1] in ("unchecked", "refuted")


@pytest.mark.parametrize(
    "said", [TOLD, "where $\\theta_2 = q_2 + \\pi/2$,\n\n", "with $q_2 = \\theta_2 - \\pi/2$,\n\n"]
)
def test_an_arm_whose_table_has_the_angles_has_the_variables_that_the_document_tells(said: str) -> None:
    result = verify_text(ANGLES + said + Y + X)
    assert "theta: q_2 + pi/2" in result.arms[0].front_matter
    assert [record.verdict.value for record in result.equations][-2:] == ["proved", "proved"]
    assert verdicts(ANGLES + said + Y + X.replace("- l_2", "+ l_2"))[-1] == "refuted"
    assert verdicts(ANGLES + said + Y.replace("l_2 \\sin", "l_2 \\cos") + X)[-2] == "refuted"


def test_a_relation_that_differs_from_the_table_is_refuted_only_beside_what_confirms_the_row() -> None:
    wrong = TOLD.replace("+", "-")
    link = "$$ T_1^0 = \\begin{bmatrix} \\cos q_1 & -\\sin q_1 & 0 & l_1 \\cos q_1 \\\\ \\sin q_1 & \\cos q_1 & 0 & l_1 \\sin q_1 \\\\ 0 & 0 & 1 & 0 \\\\ 0 & 0 & 0 & 1 \\end{bmatrix} $$\n\n"
    assert verdicts(OFFSET + link + TOLD) == ["proved", "proved"]
    assert verdicts(OFFSET + link + wrong) == ["proved", "unchecked"]
    assert verdicts(OFFSET + X + wrong) == ["proved", "refuted"]


def test_a_value_of_the_angle_is_that_of_the_variable_and_the_offset() -> None:
    given = OFFSET + X + Y + "$$ \\theta_1 = 0, \\quad \\theta_2 = 0 $$\n\n"
    assert verdicts(given + "$$ x = l_1 + l_2 $$\n")[-1] == "confirmed"
    assert verdicts(given + "$$ x = l_1 $$\n")[-1] != "confirmed"
    there = "$$ x|_{\\theta_2 = 0} = (l_1 + l_2) \\cos q_1 $$\n"
    assert verdicts(OFFSET + X + Y + there)[-1] == "proved"
    assert verdicts(OFFSET + X + Y + there.replace("+ l_2", "- l_2"))[-1] == "refuted"
    zero = "$$ \\det J = 0 \\iff \\theta_2 = 0 \\text{ or } \\theta_2 = \\pi $$\n"
    assert verdicts(OFFSET + X + Y + zero)[-1] == "proved"
    assert verdicts(OFFSET + X + Y + zero.replace("\\theta_2", "q_2"))[-1] != "proved"


def test_rates_and_derivatives_by_an_angle_that_turns_against_its_variable() -> None:
    told = ANGLES + "$$ \\theta_2 = -q_2 $$\n\n" + Y
    for right, wrong in (("\\theta_2", "q_2"),):
        display = "$$ \\frac{\\partial y}{\\partial %s} = l_2 \\cos(\\theta_1 + \\theta_2) $$\n"
        assert verdicts(told + display % right)[-1] == "proved"
        assert verdicts(told + display % wrong)[-1] == "refuted"
    rate = "$$ \\dot y = l_1 \\cos\\theta_1 \\dot\\theta_1 + l_2 \\cos(\\theta_1 + \\theta_2)(\\dot\\theta_1 + \\dot %s) $$\n"
    assert [verdicts(told + rate % each)[-1] for each in ("\\theta_2", "q_2")] == ["proved", "refuted"]


def test_front_matter_in_angles_leaves_the_variables_open() -> None:
    front = "---\narm:\n  dh: classic\n  rows:\n    - {a: l_1, alpha: 0, d: 0, theta: theta_1}\n    - {a: l_2, alpha: 0, d: 0, theta: theta_2}\n---\n"
    found = verify_text(front + TOLD + Y + X).equations
    assert Verdict.REFUTED not in [record.verdict for record in found] and found[1].verdict == "proved"
    same = TOLD.replace(" + \\frac{\\pi}{2}", "")
    assert verdicts(front + same + Y + X.replace("- l_2 \\sin", "+ l_2 \\cos"))[1:] == ["proved", "proved"]


ABSOLUTE = r"""
# Relative and absolute angles

For a planar arm with links $l_1$, $l_2$ and joint angles $\theta_1$, $\theta_2$ we use the absolute angles

$$ \phi_1 = \theta_1, \quad \phi_2 = \theta_1 + \theta_2 $$

$$ x = l_1 \cos\phi_1 + l_2 \cos\phi_2 $$

$$ y = l_1 \sin\phi_1 + l_2 \sin\phi_2 $$

$$ \frac{\partial x}{\partial\theta_2} = -l_2 \sin\phi_2 $$
"""


def test_absolute_angles_that_are_sums_leave_those_of_the_joints_relative() -> None:
    held = [each.verdict.value for each in verify_text(ABSOLUTE).equations]
    assert held[1:] == ["proved"] * 3
    slip = ABSOLUTE.replace(r"\theta_2} = -l_2", r"\theta_2} = l_2")
    assert verify_text(slip).equations[-1].verdict.value == "refuted"
    told = ABSOLUTE.replace("# Relative and absolute angles", "").replace(
        r"\phi_1 = \theta_1, \quad \phi_2 = \theta_1 + \theta_2", r"\theta_1 = 0.2, \quad \theta_2 = 0.3"
    )
    assert {each.verdict.value for each in verify_text(told.replace(r"\phi", r"\theta")).equations[1:]}.isdisjoint(
        {"refuted"}
    )
