"""What a text tells of directions, of indices and of units is heard, and what only sounds so is not."""

from __future__ import annotations

import pytest

from armproof.verification.document.index_directions import told_indices
from armproof.verification.document.lengths_in_units import lengths_in_two_units
from armproof.verification.document.orientations import told_orientations


@pytest.mark.parametrize(
    ("sentence", "told"),
    [
        ("Here $x$ points to the right and $y$ points down on the sheet.", "axis down y"),
        ("Here $x$ points to the right and $y$ points up on the sheet.", ""),
        ("L'axe $z_0$ pointe vers le bas.", "axis down z"),
        ("Die $y$-Achse zeigt nach unten.", "axis down y"),
        ("The axis $z_3$ points down.", ""),
        ("The $z$ axis of the tool points down.", ""),
        ("Gravity acts along the $y$ axis downwards.", ""),
        ("Das zweite Gelenk hebt den Arm um $\\theta_2$ über die Waagerechte.", "rises \\theta_2"),
        ("El ángulo $q_2$ se mide desde la horizontal hacia arriba.", "rises q_2"),
        ("$\\theta_2$ is the angle of depression of the boom.", "falls \\theta_2"),
        ("We find $\\theta_2$ by splitting the angle of elevation into two.", ""),
        ("For negative $\\theta_2$ the arm hangs below the horizontal.", ""),
        ("Wenn alle Winkel null sind, zeigt der Arm nach oben, entlang der $y$-Achse.", "at zero y"),
        ("When all joint angles are zero, the arm points straight up.", "at zero up"),
        ("When all angles are zero, the $z$ axis of the tool points along the $x$ axis.", ""),
    ],
)
def test_directions_are_heard(sentence: str, told: str) -> None:
    assert {each.partition("\n")[0] for each in told_orientations(sentence)} == ({told} if told else set())


@pytest.mark.parametrize(
    ("sentence", "told"),
    [
        ("Here $R_0^3$ turns the coordinates of the base into those of the hand.", "reference upper"),
        ("$T_i^j$ expresa el sistema j en el sistema i.", "reference lower"),
        ("$T_1^0$ décrit le repère 1 par rapport au repère 0.", "reference upper"),
        ("The columns of $R_{12}$ are the axes of frame 1 seen from frame 2.", "reference second"),
        ("For any point, $p_0 = T_{01} p_1$.", "reference first"),
        ("$T_0^1$ is the transformation from frame 0 to frame 1.", ""),  # of what, nobody can tell
        ("Here ${}^P_QT$ turns coordinates in $P$ into coordinates in $Q$.", "left lower"),
        ("Here ${}^P_QT$ turns coordinates in $Q$ into coordinates in $P$.", "left upper"),
        ("${}^PR_Q$ gives the frame P in the frame Q.", "left lower"),
        ("${}^PR_Q$ gives the frame Q in the frame P.", "left upper"),
        ("The left upper index names the frame that is described.", "left lower"),
        ("The left upper index names the frame in which the other one is described.", ""),
        ("The subscript is the frame of reference.", "reference lower"),
        ("In this course points are rows.", "rows"),
        ("Points are not rows here.", ""),
        ("The matrices are multiplied from the right.", ""),
    ],
)
def test_indices_are_heard(sentence: str, told: str) -> None:
    assert {each.partition("\n")[0] for each in told_indices(sentence)} == ({told} if told else set())


@pytest.mark.parametrize(
    ("sentence", "letters"),
    [
        ("$l_1$ is given in feet, the forearm $l_2$ in inches.", ["l_1", "l_2"]),
        ("Le bras $l_1$ est en pieds, l'avant-bras $l_2$ en pouces.", ["l_1", "l_2"]),
        ("$l_1$ and $l_2$ are in mm, $x$ in m.", []),
    ],
)
def test_lengths_in_two_units_are_heard(sentence: str, letters: list[str]) -> None:
    assert [*lengths_in_two_units(sentence)] == letters
