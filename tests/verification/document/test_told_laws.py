r"""What sentences tell of branches, of the size of J and of what it maps, of a force on the tool and of quantities."""

from __future__ import annotations

from pathlib import Path

import pytest

from armproof.verification.document import parse_document

TOLD = [
    (r"The elbow bends to one side only: $\theta_2$ is never positive.", r"branch \theta_2 < 0"),
    (r"Every target has a negative $x$.", "branch x < 0"),
    (r"donc $x$ est négatif et", "branch x < 0"),
    (r"Second cas, $\sin\theta_2$ négatif.", r"branch \sin\theta_2 < 0"),
    (r"On impose une valeur négative de $\theta_3$.", r"branch \theta_3 < 0"),
    (r"The angle $\theta_5$ of this robot is always negative.", r"branch \theta_5 < 0"),
    (r"$\theta_2$ ist immer negativ.", r"branch \theta_2 < 0"),
    (r"In the second posture, $\sin\theta_2 = -\sqrt{1 - c_2^2}$.", r"branch \sin\theta_2 < 0"),
    (r"The wrist has $\theta_5$ between $-180^\circ$ and $0$.", r"branch -180^\circ < \theta_5 < 0"),
    ("We keep the negative root,", "branch root -"),
    (r"Avec le signe plus pour $\theta_2$ on choisit", "branch root +"),
    ("Solution « coude négatif » :", "branch"),
    ("For the left-handed posture", "branch"),
    ("If it reaches backward over its head,", "branch"),
    (r"Soit $J$ une matrice de taille $2 \times 3$.", "size of J <"),
    ("La jacobienne d'un robot à sept axes a six lignes et sept colonnes.", "size of J <"),
    (r"The arm has more joints than the task has coordinates ($n > m$).", "size of J <"),
    (r"Dans le cas inverse ($n < m$), la solution des moindres carrés est", "size of J >"),
    ("The task has two coordinates, the arm three joints.", "size of J <"),
    (r"An arm with three joints moves in space, so $J$ is a $6\times 3$ matrix.", "size of J >"),
    ("For a redundant arm", "size of J <"),
    (r"If $J$ is square,", "size of J ="),
    (
        r"As usual there, the matrix $J$ gives the rates of the actuators from the velocity of the platform:",
        "J maps otherwise",
    ),
    (r"Ici $J$ désigne la jacobienne inverse.", "J maps otherwise"),
    (r"Dans ce polycopié, les lignes de $J$ correspondent aux articulations.", "J maps otherwise"),
    (r"Some write the Jacobian with one row a joint.", "J maps otherwise"),
    (r"The force $f$ acts on the tool from outside; the motors hold the arm at rest.", "reaction f"),
    (r"Un opérateur exerce sur l'outil l'effort $F$. Les moteurs doivent s'y opposer.", "reaction F"),
    (r"Let $\rho$ be the distance between the shoulder and the tool.", "of a quantity"),
    (r"La hauteur du coude est", "of a quantity"),
    (r"The angle $\theta_2$ is the angle between the second link and the first one.", r"relative angle \theta_2"),
    (r"$q_2$ mesure la rotation du deuxième segment par rapport au premier.", "relative angle q_2"),
]
NOT_TOLD = [
    "All turns are positive counter-clockwise.",
    r"A positive $\theta_2$ lowers the arm.",
    r"$\theta_2$ is positive when the elbow is up.",
    r"The turn $\theta_1$ is counted from the positive $x$ axis.",
    r"The bars $l_1$ and $l_2$ are positive.",
    r"$\theta_2$ may be positive or negative.",
    "The two signs belong to elbow up and elbow down.",
    r"The Jacobian $J$ maps joint velocities to end-effector velocities.",
    r"The inverse of $J$ gives the joint rates from the tool velocity.",
    r"$J^{-1}$ gives the joint rates from the tool velocity.",
    r"Each column of $J$ belongs to one joint, each row to a coordinate.",
    r"The torques that balance a force $F$ at the tool are",
    r"The tool pushes on the wall with the force $F$.",
    r"We put $D$ for the sum of these angles.",
    r"The two turns are measured from the vertical.",
    "It is the transpose of the rotation matrix, and its rows are the axes of the joints.",
    "For the inverse, square and add:",
    "Le carré de la manipulabilité s'en déduit,",
    "The minus sign in the formula is due to the down axis.",
    "Le signe moins vient du sens horaire.",
    "Half of the class forgot the flip and wrote",
    "There are two solutions (left and right shoulder),",
    "Le poids est dirigé vers les $z$ positifs.",
]
PAGE = "# A page\n\n$$ a = 1 $$\n\n{}\n\n$$ b = 2 $$\n"
KINDS = ("branch", "size of J", "J maps", "reaction", "of a quantity", "relative angle")


def _told(text: str) -> list[str]:
    last = parse_document(Path("x.md"), PAGE.format(text)).displays[-1]
    return [each for each in last.meant if each.startswith(KINDS)]


@pytest.mark.parametrize(("text", "told"), TOLD)
def test_what_is_told_of_the_display_behind_is_heard(text: str, told: str) -> None:
    assert told in _told(text)


@pytest.mark.parametrize("text", NOT_TOLD)
def test_what_tells_no_such_thing_is_not_heard(text: str) -> None:
    assert _told(text) == []


def test_a_branch_is_told_up_to_where_its_letter_is_told_anew() -> None:
    text = "# A\n\nFirst, $q_2$ is positive.\n\n$$ a = 1 $$\n\nThen $q_2$ is negative.\n\n$$ b = 2 $$\n\n# B\n\n$$ c = 3 $$\n"
    told = [[m for m in each.meant if m.startswith("branch")] for each in parse_document(Path("x.md"), text).displays]
    assert told == [["branch q_2 > 0"], ["branch q_2 < 0"], []]
