r"""What sentences say of joint variables, lengths, origins, points and turns of an arm: told otherwise than the arm has them nothing is decided, and in the usual words all is."""

from __future__ import annotations

import pytest

from armproof import verify_text

PLANAR = "---\narm: planar_2r\n---\n\n# A page\n\n"
ABSCISSA = r"x = l_1 c_1 + l_2 c_{12}"
RATE = r"\dot y = l_1 c_1 \dot\theta_1 + l_2 c_{12} (\dot\theta_1 + \dot\theta_2)"
POINT = r"p = \begin{bmatrix} l_1 c_1 + l_2 c_{12} \\ l_1 s_1 + l_2 s_{12} \\ 0 \end{bmatrix}"
TURN = r"\varphi = \theta_1 + \theta_2"
OMEGA = r"\omega = \dot\theta_1 + \dot\theta_2"


def _verdict(said: str, display: str, front: str = PLANAR) -> str:
    return verify_text(f"{front}{said}\n\n$$ {display} $$\n").equations[-1].verdict.value


@pytest.mark.parametrize(
    ("otherwise", "usual"),
    [
        (r"$\theta_2$ is the angle of the servo.", r"$\theta_2$ is the angle of the second joint."),
        (r"$\theta_2$ is what the dial of the winch shows.", r"$\theta_2$ is the rotation about the second axis."),
        (r"$\theta_1$ is the angle of the second joint.", r"$\theta_1$ is the angle of the first joint."),
        (r"- $\theta_2$: slope of the second link", r"- $\theta_2$: angle of the second joint"),
        ("| letter | meaning |\n|---|---|\n| $\\theta_2$ | angle of the forearm with $x_0$ |", "| letter | meaning |\n|---|---|\n| $\\theta_1$ | angle of the upper arm with $x_0$ |"),
        (r"$l_1$ désigne la moitié de la longueur de la première barre.", r"$l_1$ désigne la longueur de la première barre."),
        (r"$l_2$ ist die Länge des ersten Glieds.", r"$l_2$ ist die Länge des zweiten Glieds."),
        (r"The link at the base has the length $l_2$.", r"The link at the base has the length $l_1$."),
        (r"Un encodeur et une courroie mènent le second axe.", r"Un opérateur mène le second axe."),
        ("A toothed belt runs from the base to the second pulley.", "The gears have no backlash and little friction."),
        ("In the zero posture the forearm stands perpendicular to the upper arm.", "In the zero posture the forearm lies along the upper arm."),
        (r"For $\theta_2 = 0$ the arm is folded.", r"For $\theta_2 = 0$ the arm is stretched."),
        ("The joint at the elbow is numbered joint 1.", "The joint at the elbow is numbered joint 2."),
    ],
)  # fmt: skip
def test_a_variable_of_other_words_is_left_open(otherwise: str, usual: str) -> None:
    assert _verdict(otherwise, ABSCISSA) == "unchecked"
    assert _verdict(usual, ABSCISSA) == "proved"


def test_a_title_tells_of_angles() -> None:
    assert (
        _verdict("", ABSCISSA, PLANAR.replace("arm:", "title: An arm with absolute link angles\narm:")) == "unchecked"
    )
    assert _verdict("", ABSCISSA, PLANAR.replace("arm:", "title: An arm with relative link angles\narm:")) == "proved"


def test_a_rate_in_other_units_is_left_open() -> None:
    assert _verdict(r"$\dot\theta_i$ is counted in turns a minute.", RATE) == "unchecked"
    assert _verdict(r"$\dot\theta_i$ is counted in radians a second.", RATE) == "proved"


def test_what_is_told_of_a_letter_leaves_others_decided() -> None:
    assert _verdict(r"$\theta_2$ is the angle of the servo.", r"x_1 = l_1 c_1") == "proved"


def test_a_bent_arm_may_be_bent_at_zero() -> None:
    height = r"z = l_1 + l_2 s_2 - l_3 c_{23}"
    bent = r"At $\theta_3 = 0$ the forearm stands at a right angle to the upper arm."
    assert _verdict(bent, height, PLANAR.replace("planar_2r", "spatial_rrr")) == "proved"


@pytest.mark.parametrize(
    ("otherwise", "usual"),
    [
        ("The coordinates are counted from the edge of the bench.", "The coordinates are counted from the shoulder."),
        (
            "The origin of the coordinates lies in the gripper.",
            "The origin of the coordinates lies in the first joint.",
        ),
        ("The base is at $(a, -h)$.", "The base is at $(0, 0)$."),
        ("L'origine du repère est située au plafond.", "L'origine du repère est située à l'épaule."),
        ("The hinge of the two links has the coordinates", "The end of the two links has the coordinates"),
    ],
)
def test_coordinates_from_elsewhere_are_left_open(otherwise: str, usual: str) -> None:
    assert _verdict(otherwise, ABSCISSA) == "unchecked"
    assert _verdict(usual, ABSCISSA) == "proved"


@pytest.mark.parametrize(
    ("otherwise", "usual"),
    [
        ("The vector from the gripper to the base is", "The vector from the base to the gripper is"),
        ("Le vecteur de la pince à l'épaule est", "Le vecteur de l'épaule à la pince est"),
        ("The vector from the knee to the gripper is", "The vector from the base to the gripper is now"),
    ],
)
def test_a_vector_leads_from_the_base_to_the_tool(otherwise: str, usual: str) -> None:
    assert _verdict(otherwise, POINT) == "unchecked"
    assert _verdict(usual, POINT) == "proved"


@pytest.mark.parametrize(
    ("display", "otherwise", "usual"),
    [
        (
            TURN,
            "The angle between the gripper and the vertical is",
            "The angle between the gripper and the horizontal is",
        ),
        (TURN, "The gripper makes with the first link the angle", "The gripper makes with $x_0$ the angle"),
        (TURN, "L'angle que fait le stylo avec la main est", "L'angle que fait la main avec la base est"),
        (OMEGA, "Relative to the first link the forearm turns with", "In the base frame the gripper turns with"),
        (OMEGA, "The fingers open with the angular velocity", "The gripper turns with the angular velocity"),
    ],
)
def test_a_turn_is_that_of_the_hand_in_the_base(display: str, otherwise: str, usual: str) -> None:
    assert _verdict(otherwise, display) == "unchecked"
    assert _verdict(usual, display) == "proved"
