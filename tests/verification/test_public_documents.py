r"""Documents as public ones are: what they say of joints and Euler's angles, arms by a Jacobian, rates as dx/dt, laws of any arm.

Each right line has a wrong twin, which is refuted or left open.
"""

from __future__ import annotations

import pytest

from armproof.verification.check import verify_text

PLANAR = (
    r"x = l_1 \cos\theta_1 + l_2 \cos(\theta_1+\theta_2)",
    r"y = l_1 \sin\theta_1 + l_2 \sin(\theta_1+\theta_2)",
)
JACOBIAN = r"J = \begin{bmatrix} -a_1 s_1 - a_2 s_{12} & -a_2 s_{12} \\ a_1 c_1 + a_2 c_{12} & a_2 c_{12} \end{bmatrix}"
RATES = r"\begin{bmatrix} a_2 c_{12} & a_2 s_{12} \\ -a_1 c_1 - a_2 c_{12} & -a_1 s_1 - a_2 s_{12} \end{bmatrix} \begin{bmatrix} \dot x \\ \dot y \end{bmatrix}"
LETTERS = r"A = \begin{bmatrix} n_x(q) & o_x(q) & a_x(q) & p_1(q) \\ n_y(q) & o_y(q) & a_y(q) & p_2(q) \\ n_z(q) & o_z(q) & a_z(q) & p_3(q) \\ 0 & 0 & 0 & 1 \end{bmatrix}"


def document(*lines: str) -> str:
    """Return a document of displays, and of text where a line begins with a blank."""
    return "# Arm\n\n" + "\n\n".join(each[1:] if each[:1] == " " else f"$$ {each} $$" for each in lines)


def verdicts(*lines: str) -> list[str]:
    """Return the verdicts of the displays."""
    return [str(each.verdict) for each in verify_text(document(*lines)).equations if each.latex.strip() in lines]


@pytest.mark.parametrize("text", ["Since the joint is rotary and turns freely,", "The first joint is prismatic."])
def test_a_kind_of_joint_is_no_value_of_one(text: str) -> None:
    assert verdicts(f" {text}", *PLANAR, r"x^2 + y^2 = l_1^2 + l_2^2 + 2 l_1 l_2 c_2") == ["proved"] * 3


def test_straight_links_are_no_posture() -> None:
    text = " The arm has two straight links."
    assert verdicts(*PLANAR, text, r"x = l_1 c_1 + l_2 c_{12}")[-1] == "proved"
    assert verdicts(*PLANAR, text, r"\det J = l_1 l_2 c_2")[-1] == "refuted"


def test_where_a_determinant_vanishes_limits_no_line_above() -> None:
    wrong = r"J = \begin{bmatrix} -l_1 s_1 - l_2 s_{12} & l_2 s_{12} \\ l_1 c_1 + l_2 c_{12} & l_2 c_{12} \end{bmatrix}"
    law = r"x^2 + y^2 = l_1^2 + l_2^2 + 2 l_1 l_2 c_2"
    assert verdicts(*PLANAR, law, wrong, r" $\det(J) = 0$ when the arm is fully stretched or folded.")[-1] == "refuted"
    assert verdicts(*PLANAR, law, wrong, " When the arm is fully stretched or folded, this is so.")[-1] == "unchecked"


def test_angles_in_letters_are_no_words() -> None:
    text = " Le passage de l'espace (θ₁, θ₂) à celui de (x, y) est"
    assert verdicts(*PLANAR, text, r"x = l_1 c_1 + l_2 c_{12}")[-1] == "proved"


def test_angles_of_euler_are_no_angles_of_joints() -> None:
    about = " Euler angles provide the rotations which relate the tool to the x-axis in the base frame."
    assert verdicts(*PLANAR, about, r"x = l_1 c_1 + l_2 c_{12}")[-1] == "proved"
    level = " The angles are measured from the horizontal."
    assert verdicts(*PLANAR, level, r"x = l_1 c_1 + l_2 c_{12}")[-1] != "proved"


def test_another_meaning_begins_with_the_section_of_a_rule() -> None:
    text = "Arm\n===\n\n.. math:: {0}\n\n.. math:: {1}\n\n.. math:: {2}\n\nOther\n=====\n\nThe angles are measured from the horizontal.\n\n.. math:: {2}\n"
    equations = verify_text(
        text.format(*PLANAR, r"x^2 + y^2 = l_1^2 + l_2^2 + 2 l_1 l_2 c_2"), path="document.rst"
    ).equations
    assert [str(each.verdict) for each in equations] == ["proved", "proved", "proved", "unchecked"]


def test_an_inverse_in_letters_shows_a_jacobian_to_be_meant() -> None:
    inverse = rf"\dot q = \frac{{1}}{{a_1 a_2 s_2}} {RATES}"
    assert verdicts(JACOBIAN, inverse) == ["proved", "proved"]
    assert verdicts(JACOBIAN, inverse.replace("& a_2 s_{12} \\\\", "& -a_2 s_{12} \\\\")) == ["unchecked"] * 2


@pytest.mark.parametrize(
    "text",
    [
        " Consider a planar arm with two revolute joints.",
        " Un bras plan à deux liaisons rotoïdes est donné.",
        " This is a **2-DOF planar robot**.",
        " El manipulador planar 2R se ve en la figura.",
        " For the two-link arm this is so.",
    ],
)
def test_a_planar_arm_in_words_has_the_jacobian_that_stands_alone(text: str) -> None:
    assert verdicts(text, JACOBIAN) == ["defined"]
    assert verdicts(text, JACOBIAN, r"\det J = a_1 a_2 s_2") == ["proved", "proved"]
    assert verdicts(text, JACOBIAN, r"\det J = a_1 a_2 c_2") == ["defined", "refuted"]


@pytest.mark.parametrize(
    "slip", [("l_2 \\sin", "l_2 \\cos"), ("l_1 \\sin", "l_2 \\sin"), ("+ l_2 \\sin", "- l_2 \\sin")]
)
def test_a_planar_arm_in_words_tells_which_coordinate_has_a_slip(slip: tuple[str, str]) -> None:
    x, y = PLANAR
    text = " A planar arm with two revolute joints:"
    assert verdicts(text, x, y.replace(*slip)) == ["defined", "refuted"]
    assert verdicts(x, y.replace(*slip)) == ["unchecked", "unchecked"]


def test_a_planar_arm_in_words_tells_which_entry_of_a_jacobian_has_a_slip() -> None:
    text = " A planar arm with two revolute joints:"
    assert verdicts(text, JACOBIAN.replace("& -a_2", "& a_2")) == ["refuted"]
    assert verdicts(text, JACOBIAN.replace("& a_2 c_{12} ", "& a_1 c_{12} ")) == ["refuted"]
    assert verdicts(JACOBIAN.replace("& -a_2", "& a_2")) == ["unchecked"]


def test_an_arm_of_other_joints_in_words_tells_nothing_of_a_jacobian() -> None:
    assert verdicts(" Consider a planar arm with three revolute joints.", JACOBIAN) == ["unchecked"]
    assert verdicts(" Consider a planar arm with two prismatic joints.", JACOBIAN) == ["unchecked"]


@pytest.mark.parametrize(
    "law", [r"J = \frac{\partial \mathbf{x}}{\partial \mathbf{q}}", r"J(q) = \frac{\partial f(q)}{\partial q}"]
)
def test_a_jacobian_is_the_derivative_by_all_joints(law: str) -> None:
    assert verdicts(law) == ["proved"]
    assert verdicts(r"J = \frac{\partial \mathbf{q}}{\partial \mathbf{x}}") == ["unchecked"]
    assert verdicts(r"J_\omega = \frac{\partial \mathbf{x}}{\partial \mathbf{q}}") == ["unchecked"]


def test_rates_are_written_with_a_slash() -> None:
    rate = r"dx/dt = -(l_1 s_1 + l_2 s_{12}) d\theta_1/dt - l_2 s_{12} d\theta_2/dt"
    assert verdicts(*PLANAR, rate)[-1] == "proved"
    assert verdicts(*PLANAR, rate.replace("- l_2", "+ l_2"))[-1] == "refuted"


def test_what_undoes_itself_is_left_open() -> None:
    assert verdicts(*PLANAR, r"\theta_2 = \arccos(\cos\theta_2)")[-1] == "unchecked"
    assert verdicts(*PLANAR, r"\theta_2 = \arccos(\sin\theta_2)")[-1] == "refuted"


def test_a_vector_has_the_letter_of_its_first_coordinate() -> None:
    value = r"\begin{bmatrix} l_1 c_1 + l_2 c_{12} \\ l_1 s_1 + l_2 s_{12} \end{bmatrix}"
    vector = rf"\mathbf{{x}} = \begin{{bmatrix}} x \\ y \end{{bmatrix}} = {value}"
    assert verdicts(*PLANAR, vector)[-1] == "proved"
    assert verdicts(*PLANAR, vector.replace("l_2 s_{12}", "l_2 s_2"))[-1] == "refuted"
    assert verdicts(*PLANAR, vector.replace(r"\mathbf{x}", "x"))[-1] != "proved"


def test_what_stands_behind_this_begins_no_sentence() -> None:
    text = " Ce MGD permet d'obtenir le modèle cinématique direct."
    assert verdicts(*PLANAR, r"x = l_1 c_1 + l_2 c_{12}", text)[-1] == "proved"
    assert verdicts(*PLANAR, r"x = l_1 c_1 + l_2 c_{12}", " Ce MGD vaut des clopinettes.")[-1] == "unchecked"


def test_a_letter_of_other_coordinates_may_be_d() -> None:
    both = r"\begin{align} d &= l_2 c_2 + l_3 c_{23} \\ x &= d c_1 \\ y &= d s_1 \\ z &= l_1 + l_2 s_2 + l_3 s_{23} \end{align}"
    assert verdicts(both, r"z = l_1 + l_2 s_2 + l_3 s_{23}")[-1] == "proved"
    assert verdicts(both, r"z = l_1 + l_2 s_2 + l_3 c_{23}")[-1] != "proved"


def test_letters_of_a_pose_that_are_functions_of_the_joints_are_no_points() -> None:
    links = [
        rf"A_{k} = \begin{{bmatrix}} c_{k} & -s_{k} & 0 & a_{k} c_{k} \\ s_{k} & c_{k} & 0 & a_{k} s_{k} \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{{bmatrix}}"
        for k in (1, 2)
    ]
    product = r"A = A_1 A_2 = \begin{bmatrix} c_{12} & -s_{12} & 0 & a_1 c_1 + a_2 c_{12} \\ s_{12} & c_{12} & 0 & a_1 s_1 + a_2 s_{12} \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}"
    assert "refuted" not in verdicts(*links, product, LETTERS)
