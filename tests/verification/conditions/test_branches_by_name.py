"""Branches that a text names, and what it says of joints that the arm has not; each with what is said otherwise."""

from __future__ import annotations

import pytest

from armproof import verify_text

ARM = r"$$ x = l_1 c_1 + l_2 c_{12}, \quad y = l_1 s_1 + l_2 s_{12} $$"
BOTH = r"There are two postures: elbow-down ($\theta_2 > 0$) and elbow-up ($\theta_2 < 0$)."
PLUS = r"$$ \theta_2 = \arccos\frac{x^2+y^2-l_1^2-l_2^2}{2 l_1 l_2} $$"
MINUS = PLUS.replace(r"\arccos", r"-\arccos")
TABLE = r"""
| $i$ | $\alpha_{i-1}$ | $a_{i-1}$ | $d_i$ | $\theta_i$ |
|---|---|---|---|---|
| 1 | 0 | 0 | 0 | $\theta_1$ |
| 2 | 0 | $a_1$ | 0 | $\theta_2$ |
"""
RATES = r"$$ {}^2\omega_2 = {}^2_1R\,{}^1\omega_1 + (\dot\theta_2 + \dot\theta_3)\,{}^2\hat Z_2 = \begin{bmatrix} 0 \\ 0 \\ \dot\theta_1 + \dot\theta_2 \end{bmatrix} $$"


@pytest.mark.parametrize(
    ("said", "display", "verdict"),
    [
        (f"{BOTH} We keep the elbow-up posture:", MINUS, "confirmed"),
        (f"{BOTH} We keep the elbow-up posture:", PLUS, "unchecked"),
        (f"{BOTH} We keep the elbow-down posture:", PLUS, "confirmed"),
        (f"{BOTH} We keep the elbow-down posture:", MINUS, "unchecked"),
        (r"Here $\theta_2 > 0$.", MINUS, "unchecked"),
    ],
)
def test_a_branch_that_is_named_is_told_by_its_name(said: str, display: str, verdict: str) -> None:
    assert verify_text(f"# A page\n\n{ARM}\n\n{said}\n\n{display}\n").equations[-1].verdict.value == verdict


@pytest.mark.parametrize(
    ("behind", "verdict"),
    [
        (r"There is no third joint, so $\dot\theta_3 = 0$.", "proved"),
        ("There is a third joint.", "unchecked"),
        (r"There $\dot\theta_3 = 1$.", "unchecked"),
        (r"Note that $\dot\theta_2 = 0$.", "unchecked"),
    ],
)
def test_a_joint_that_the_arm_has_not_may_be_said_to_rest(behind: str, verdict: str) -> None:
    text = f"---\narm: planar_2r\n---\n# A page\n\n{RATES}\n\n{behind}\n"
    assert verify_text(text).equations[-1].verdict.value == verdict


@pytest.mark.parametrize(
    ("heading", "verdict"),
    [("Subproblem 2: the planar 2R part", "refuted"), ("Example 2: a planar 2R arm", "unchecked")],
)
def test_a_subproblem_is_of_the_same_arm(heading: str, verdict: str) -> None:
    table = "| 3 | 0 | $a_2$ | 0 | $\\theta_3$ |\n| 4 | 0 | $a_3$ | 0 | 0 |\n"
    wrong = r"$$ p_x = a_1 c_1 + a_2 c_{12} - a_3 c_{123} $$"
    right = r"$$ p_x = a_1 c_1 + a_2 c_{12} + a_3 c_{123} $$"
    for each, expected in ((right, "proved"), (wrong, verdict)):
        text = f"# A page\n{TABLE}{table}\n{right}\n\n## {heading}\n\n{each}\n"
        assert verify_text(text).equations[-1].verdict.value == expected


@pytest.mark.parametrize(
    ("said", "verdict"),
    [
        ("Differentiating with respect to the joint angles, the Jacobian is", "refuted"),
        ("Seen with respect to the elbow joint, the Jacobian is", "unchecked"),
    ],
)
def test_what_is_differentiated_by_the_joint_angles_is_seen_from_no_joint(said: str, verdict: str) -> None:
    wrong = r"$$ J = \begin{bmatrix} -l_1 s_1 - l_2 s_{12} & l_2 s_{12} \\ l_1 c_1 + l_2 c_{12} & l_2 c_{12} \end{bmatrix} $$"
    text = f"---\narm: planar_2r\n---\n# A page\n\n{said}\n\n{wrong}\n"
    assert verify_text(text).equations[-1].verdict.value == verdict
