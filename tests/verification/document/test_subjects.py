"""Of what a sentence says the display to be that it leads to: a point, a link or frame, a quantity, an order of rows or rotations."""

from __future__ import annotations

from pathlib import Path

import pytest

from armproof.verification.check import check_document, verify_text
from armproof.verification.document import parse_document
from armproof.verification.document.hearing import FORMULA, words_of
from armproof.verification.document.named_quantities import NAMED
from armproof.verification.document.subjects import ACCELERATION, LINK, OPERATED, OTHER_BASE, OTHER_PLACE, subjects
from armproof.verification.document.told_turns import OTHER_TURN

HEARD = [
    ("The velocity of the centre of mass is", [OTHER_PLACE]),
    ("The velocity of the centre of the gripper is", []),
    ("La vitesse du centre de gravité est", [OTHER_PLACE]),
    ("La position du centre de l'outil est", []),
    ("Die Geschwindigkeit des Ellenbogens ist", [OTHER_PLACE]),
    ("Die Geschwindigkeit des Endeffektors ist", []),
    ("Il gomito si trova in", [OTHER_PLACE]),
    ("The elbow is bent, and the tip is at", []),
    ("The elbow moves with", [OTHER_PLACE]),
    ("The camera is fixed to the elbow, and its position is", [OTHER_PLACE]),
    ("The camera is fixed to the hand, and its position is", []),
    ("The orientation of link 1 is", [f"{LINK} 1"]),
    ("La vitesse du deuxième corps est", [f"{LINK} 2"]),
    ("The position of the point $O_1$ is", [f"{LINK} 1"]),
    ("The coordinates of the point $P$ are", []),
    ("The middle of the second bar has the coordinates", [OTHER_PLACE]),
    ("The tip of the arm has the coordinates", []),
    ("The last link has the coordinates", []),
    ("The arm has two joints, and its tip has the coordinates", []),
    ("Le bout du premier segment a pour ordonnée", [f"{LINK} 1"]),
    ("Le bout du bras a pour ordonnée", []),
    ("A quarter of the way from the elbow to the tip,", [OTHER_PLACE]),
    ("On the way from joint space to the plane we get", []),
    ("The second bar turns relative to the first one with", [OTHER_BASE, OTHER_TURN]),
    ("The second bar turns relative to the base with", []),
    ("The angle between the two bars is", [OTHER_PLACE, OTHER_TURN]),
    ("The angle between the last bar and the x-axis is", []),
    ("The angle between the two bars is $\\theta_2$, and the tip is at", []),
    ("On the way from the elbow to the tip we add", []),
    ("The projections of the first and the second bar add up to", []),
    ("L'angle que font les deux segments est", [OTHER_PLACE, OTHER_TURN]),
    ("The projection of the first bar on the horizontal axis is", [OTHER_PLACE]),
    ("The projection of the arm on the horizontal axis is", []),
    ("The rotation from frame 0 to frame 1 is", [f"{LINK} 1"]),
    ("The velocity of the tip relative to the elbow is", [OTHER_BASE]),
    ("The velocity of the tip relative to the base is", []),
    (r"Consider an arm with shoulder angle $\theta_1$ and elbow angle $\theta_2$ (relative to link 1):", []),
    (r"The angle of the tip relative to link 1 is", [OTHER_BASE, OTHER_TURN]),
    ("The position of the hand with respect to frame $R_0$ is", []),
    ("Exprimée dans $R_1$, la vitesse est", [OTHER_BASE]),
    ("The transpose of the Jacobian is", [f"{OPERATED} J"]),
    ("La jacobienne inverse est", [f"{OPERATED} J"]),
    ("The derivative of the position gives the Jacobian", []),
    ("The acceleration of the tip is", [ACCELERATION]),
    ("To find the acceleration we first need the velocity:", []),
]


@pytest.mark.parametrize(("sentence", "heard"), HEARD)
def test_a_sentence_tells_of_what_it_is(sentence: str, heard: list[str]) -> None:
    formulas = [found.group().strip("$") for found in FORMULA.finditer(sentence)]
    assert [each for each in subjects(words_of(sentence), formulas) if not each.startswith(NAMED)] == heard


J2 = r"J = \begin{bmatrix} -l_1 s_1 - l_2 s_{12} & -l_2 s_{12} \\ l_1 c_1 + l_2 c_{12} & l_2 c_{12} \end{bmatrix}"
J6 = J2.replace(r" \end", r" \\ 0 & 0 \\ 0 & 0 \\ 0 & 0 \\ 1 & 1 \end")
TURNED = J2.replace(r"{bmatrix}", r"{bmatrix} 0 & 0 \\ 0 & 0 \\ 1 & 1 \\", 1).replace(r" \end", r" \\ 0 & 0 \end")
R = r"R = \begin{bmatrix} c_{12} & -s_{12} & 0 \\ s_{12} & c_{12} & 0 \\ 0 & 0 & 1 \end{bmatrix}"
V = r"\dot x = -l_1 s_1 \dot\theta_1 - l_2 s_{12} (\dot\theta_1 + \dot\theta_2)"


def verdicts(text: str, display: str, head: str = "---\narm: planar_2r\n---\n") -> list[str]:
    document = parse_document(Path("a.md"), f"{head}{text}\n\n$$ {display} $$\n")
    return [str(record.verdict) for record in check_document(document).equations]


@pytest.mark.parametrize(
    ("display", "right", "wrong"),
    [
        (J2, "The Jacobian of the hand is", "The Jacobian of the shoulder is"),
        (J2, "The Jacobian is", "The inverse Jacobian is"),
        (J2, "La jacobienne de l'outil est", "La jacobienne du milieu du second segment est"),
        (J2, "In frame 0 the Jacobian is", "The body Jacobian is"),
        (J2, "The columns are those of joint 1 and joint 2:", "The columns stand in reverse order:"),
        (R, "The orientation of link 2 is", "The orientation of link 1 is"),
        (R, "L'orientation du second corps est", "L'orientation du second corps par rapport au premier est"),
        (V, "The velocity is", "The acceleration is"),
        (V, "## Velocity of the tool", "## Velocity of the centre of mass"),
        (V, "## Jacobian of the elbow manipulator", "## In the frame of link 2"),
        (V, "Tool:", "**Elbow.**"),
        (V, "Question 2. Give the velocity of the tip.", "Question 2. Give the velocity of the elbow."),
        (V, "The rate at which the hand moves is", "The rate at which the elbow moves is"),
        (V, "Along the axes of the base the velocity is", "Along the axes of the hand the velocity is"),
        (V, "La velocità della pinza è", "La velocità del baricentro è"),
    ],
)
def test_what_is_of_another_point_frame_or_quantity_is_left_open(display: str, right: str, wrong: str) -> None:
    assert [verdicts(each, display) for each in (right, wrong)] == [["proved"], ["unchecked"]]


@pytest.mark.parametrize(
    ("right", "wrong"),
    [
        (r"\quad \text{(tip)}", r"\quad \text{(elbow)}"),
        (r"\tag{tip}", r"\tag{elbow}"),
        ("$$\n\nThis is the velocity of the tip.\n\n$$ a = a", "$$\n\nThis is the velocity of the centre of mass.\n\n$$ a = a"),
    ],
)  # fmt: skip
def test_words_in_a_display_and_behind_it_tell_of_what_it_is(right: str, wrong: str) -> None:
    assert [verdicts("", f"{V} {each}")[0] for each in (right, wrong)] == ["proved", "unchecked"]


@pytest.mark.parametrize(
    ("above", "below"),
    [
        ("With the angular velocity on top,", "With the linear velocity on top,"),
        ("Avec la partie angulaire en haut,", "Avec la partie linéaire en haut,"),
        ("Zuerst die Winkelgeschwindigkeiten, dann die linearen:", "Zuerst die linearen, dann die Winkelgeschwindigkeiten:"),
        (r"In the order $[\omega; v]$", r"In the order $[v; \omega]$"),
    ],
)  # fmt: skip
def test_the_text_tells_which_rows_of_a_jacobian_are_above(above: str, below: str) -> None:
    assert verdicts(above, TURNED) == verdicts(below, J6) == ["proved"]
    assert verdicts(above, J6) == verdicts(below, TURNED) == ["unchecked"]
    assert verdicts(above, TURNED.replace("1 & 1", "1 & 0")) == ["refuted"]


TWIST = "$$ \\begin{bmatrix} \\omega \\\\ v \\end{bmatrix} = J \\dot q $$"


def test_a_twist_tells_which_rows_of_a_jacobian_are_above() -> None:
    assert verdicts(TWIST, TURNED) == ["proved", "proved"]
    assert verdicts(TWIST, J6) == ["proved", "unchecked"]
    assert verdicts(TWIST, J2) == ["proved", "proved"]
    assert verdicts(TWIST, TURNED.replace("1 & 1", "1 & 0")) == ["proved", "refuted"]


@pytest.mark.parametrize(
    ("told", "right", "wrong"),
    [
        ("The rotation about the fixed axes $x$, then $y$, then $z$ is", "R_z(c) R_y(b) R_x(a)", "R_x(a) R_y(b) R_z(c)"),
        ("The rotation about the moving axes $x$, then $y$, then $z$ is", "R_x(a) R_y(b) R_z(c)", "R_z(c) R_y(b) R_x(a)"),
        ("Rotations successives autour des axes courants $z$, $y$, $z$ de", "R_z(a) R_y(b) R_z(c)", "R_z(c) R_y(b) R_z(a)"),
    ],
)  # fmt: skip
def test_the_text_tells_the_order_of_rotations(told: str, right: str, wrong: str) -> None:
    angles = {"a": r"\alpha", "b": r"\beta", "c": r"\gamma"}
    right, wrong = ("".join(angles.get(each, each) for each in side) for side in (right, wrong))
    told += " " + ", ".join(f"${each}$" for each in angles.values()) + ":"
    assert verdicts(f"{told}\n\n$$ R = {right} $$", r"R^T R = I", head="") == ["defined", "proved"]
    assert verdicts(f"{told}\n\n$$ R = {wrong} $$", r"R^T R = I", head="") == ["unchecked", "unchecked"]


@pytest.mark.parametrize(
    ("solution", "verdict"),
    [(r"\operatorname{atan2}(y, x)", "confirmed"), (r"\operatorname{atan2}(x, y)", "unchecked")],
)
def test_what_is_solved_for_a_joint_is_of_no_point(solution: str, verdict: str) -> None:
    text = f"---\narm: spatial_rrr\n---\n**Rotation of the base:**\n\n$$ \\theta_1 = {solution} $$\n"
    assert [record.verdict.value for record in verify_text(text).equations] == [verdict]
