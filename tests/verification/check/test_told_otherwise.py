"""What a display says by words that change the arm, the quantity, the force or the order before it: each with a twin that is decided."""

from __future__ import annotations

import pytest

from tests.labelled.judging import verify_text

FRONT = "---\narm: planar_2r\n---\n"
WHOLE = "$$ x = l_1 c_1 + l_2 c_{12} $$"
TURNED = "$$ y = -l_1 s_1 - l_2 s_{12} $$"
J = r"$$ J = \begin{bmatrix} -l_1 s_1 - l_2 s_{12} & -l_2 s_{12} \\ l_1 c_1 + l_2 c_{12} & l_2 c_{12} \end{bmatrix} $$"


def last_of(*lines: str, front: str = FRONT) -> str:
    return verify_text(front + "\n\n".join(lines) + "\n").equations[-1].verdict.value


@pytest.mark.parametrize(
    ("said", "verdict"),
    [
        ("Turning the whole arm by half a turn we have", "unchecked"),
        ("If we mirror the joint angles,", "unchecked"),
        ("En échangeant les deux angles,", "unchecked"),
        ("Half a turn of the arm takes this point to", "unchecked"),
        ("and another one to", "unchecked"),
        ("This simplifies to", "refuted"),
        ("The turning arm has the height", "refuted"),
    ],
)
def test_what_holds_of_the_arm_once_it_is_changed_is_not_refuted(said: str, verdict: str) -> None:
    assert last_of(said, TURNED) == verdict


@pytest.mark.parametrize(
    ("said", "verdict"),
    [
        ("Keeping the direction of the forearm fixed,", "unchecked"),
        ("En gardant l'inclinaison de la main constante,", "unchecked"),
        ("The first entry of the first column is", "refuted"),
    ],
)
def test_a_derivative_with_something_else_held_is_not_refuted(said: str, verdict: str) -> None:
    assert last_of(WHOLE, said, r"$$ \frac{\partial x}{\partial \theta_1} = -l_1 s_1 $$") == verdict


@pytest.mark.parametrize(
    ("said", "verdict"),
    [
        ("$x$ and $y$ count from where the hand was before.", "unchecked"),
        ("$x$ and $y$ are counted from the base.", "proved"),
    ],
)
def test_coordinates_from_the_start_are_others(said: str, verdict: str) -> None:
    assert last_of(said, WHOLE) == verdict


@pytest.mark.parametrize(
    ("said", "verdict"),
    [
        ("The joints are numbered from zero, as in C.", "unchecked"),
        ("Die Gelenke werden ab 0 nummeriert.", "unchecked"),
        ("The frames are numbered from zero, as usual.", "proved"),
        ("The joints are numbered from one.", "proved"),
    ],
)
def test_joints_that_are_numbered_from_zero_are_others(said: str, verdict: str) -> None:
    assert last_of(said, WHOLE) == verdict


@pytest.mark.parametrize(
    ("said", "verdict"),
    [
        ("$J$ gives the joint speeds for a velocity of the hand that is wanted.", "unchecked"),
        ("With $J$ we find how fast the motors must turn:", "unchecked"),
        ("Using $J$ one computes what force the torques make at the hand:", "unchecked"),
        ("How fast must the motors turn? This is what $J$ answers:", "unchecked"),
        ("$J$ gives the velocity of the hand for given joint speeds.", "proved"),
        ("With $J$ we find how fast the hand moves:", "proved"),
        ("How fast does the hand move for given joint speeds? This is what $J$ answers:", "proved"),
    ],
)
def test_a_jacobian_that_maps_the_other_way_is_not_decided(said: str, verdict: str) -> None:
    assert last_of(said, J) == verdict


@pytest.mark.parametrize(
    ("said", "verdict"),
    [
        ("The force $F$ is given along the axes of the gripper.", "unchecked"),
        ("A sensor measures the wrench $F$ in the tool frame.", "unchecked"),
        ("The load pulls at the elbow with the force $F$.", "unchecked"),
        ("The force $F$ is given along the axes of the base.", "proved"),
        ("A sensor in the hand measures the force $F$ on the tool in the base.", "proved"),
    ],
)
def test_a_force_in_other_axes_or_at_another_place_is_not_decided(said: str, verdict: str) -> None:
    assert last_of(said, "The torques are", r"$$ \tau = J^T F $$", front="") == verdict


ROTATION = r"$$ R = R_{}({}) R_{}({}) $$"


@pytest.mark.parametrize(
    "said",
    [
        "A body turns first about the fixed axis $x$ by $\\alpha$, then about the fixed axis $y$ by $\\beta$.",
        "It is turned about $x$ by $\\alpha$ and the result is turned about $y$ by $\\beta$, both axes being those of the room.",
        "Roll $\\alpha$ about $x$, yaw $\\beta$ about $y$; it turns about the fixed axes in the order roll, yaw.",
    ],
)
def test_rotations_about_fixed_axes_stand_from_the_right(said: str) -> None:
    value = r" = \begin{{bmatrix}} c_\beta & s_\alpha s_\beta & c_\alpha s_\beta \\ 0 & c_\alpha & {}s_\alpha \\ -s_\beta & s_\alpha c_\beta & c_\alpha c_\beta \end{{bmatrix}} $$"
    right = ROTATION.format("y", r"\beta", "x", r"\alpha").removesuffix(" $$")
    assert last_of(said, right + value.format("-"), front="") in ("proved", "defined")
    assert last_of(said, right + value.format(""), front="") == "refuted"
    turned = ROTATION.format("x", r"\alpha", "y", r"\beta").removesuffix(" $$")
    other = r" = \begin{bmatrix} c_\beta & 0 & s_\beta \\ s_\alpha s_\beta & c_\alpha & -s_\alpha c_\beta \\ -c_\alpha s_\beta & s_\alpha & c_\alpha c_\beta \end{bmatrix} $$"
    assert last_of(said, turned + other, front="") == "unchecked"


@pytest.mark.parametrize(
    ("said", "verdict"),
    [
        ("The average of the abscissa is", "unchecked"),
        ("When $\\theta_1$ takes all values, the smallest abscissa is", "unchecked"),
        ("Half the abscissa is", "unchecked"),
        ("The increment of $x$ since then is", "unchecked"),
        ("Das Doppelte der Abszisse ist", "unchecked"),
        ("The abscissa is", "proved"),
        ("From the square of the distance we have the abscissa", "proved"),
        ("With the mean of both encoders the abscissa is", "proved"),
    ],
)
def test_another_function_of_a_quantity_is_not_decided_by_its_value(said: str, verdict: str) -> None:
    assert last_of(said, WHOLE) == verdict


def test_the_logarithm_that_is_printed_is_decided() -> None:
    assert last_of("The logarithm of the determinant is", r"$$ \ln \det J = \ln (l_1 l_2 s_2) $$") != "refuted"
    assert last_of("The logarithm of the determinant is", r"$$ \det J = l_1 l_2 s_2 $$") == "unchecked"


@pytest.mark.parametrize(
    ("side", "sign", "verdict"),
    [
        ("above the line from the base to the tool, which is to the right", "-", "confirmed"),
        ("above the line from the base to the tool, which is to the right", "+", "unchecked"),
        ("below the line from the base to the tool, which is to the right", "+", "confirmed"),
        ("above the line from the base to the tool, which is on the left", "+", "confirmed"),
        ("above the pipe", "+", "unchecked"),
    ],
)
def test_the_side_of_the_elbow_tells_the_sign(side: str, sign: str, verdict: str) -> None:
    target = r"Let $D = \dfrac{x^2 + y^2 - l_1^2 - l_2^2}{2 l_1 l_2}$."
    solved = rf"$$ \theta_2 = {sign}\operatorname{{atan2}}(\sqrt{{1 - D^2}}, D) $$"
    assert last_of(target, f"We take the posture with the elbow {side}:", solved) == verdict
