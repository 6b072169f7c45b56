r"""What sentences tell of the displays behind them: tasks, joints that are locked or turned round, other machines, other counting."""

from __future__ import annotations

from pathlib import Path

import pytest

from armproof.verification.document import parse_document

TOLD = [
    (r"The task is the pair $(y, \varphi)$; its Jacobian is", r"task y;\varphi"),
    (r"La tâche $(r, z)$ a pour jacobienne", "task r;z"),
    (r"Geregelt werden $x$ und $y$, und zwar in der Reihenfolge $(\varphi, x, y)$.", r"task \varphi;x;y"),
    (r"Only $x$ and $\varphi = \theta_1 + \theta_2$ are to be controlled.", r"task of x;\varphi"),
    (r"Se controlan la abscisa $x$ y la orientación $\varphi$.", r"task of x;\varphi"),
    (r"In this lab the first row of $J$ belongs to $y$ and the second to $x$.", "task y;x"),
    (r"La première ligne de $J$ est celle de $y$, la deuxième celle de $x$.", "task y;x"),
    ("The brake holds the elbow.", "locked"),
    (r"Only $\theta_1$ moves.", "locked"),
    (r"Seul $\theta_1$ varie.", "locked"),
    ("Der Schub ist gebremst.", "locked"),
    (r"$\theta_2$ garde sa valeur.", r"locked \theta_2"),
    (r"$d_2$ bleibt konstant.", "locked d_2"),
    (r"Les variables sont $\theta_1$ et $d_3$ ; $d_2$ est une constante.", "locked d_2"),
    (r"$\theta_2$ and $d_3$ are constant.", r"locked \theta_2"),
    (r"Wenn nun $\theta_2$ konstant bleibt, folgt", r"locked \theta_2"),
    (r"Let $\theta_2$ be kept constant from here on: it is held fixed.", "locked"),
    (r"The elbow keeps its value.", "locked"),
    ("La segunda articulación está bloqueada.", "locked"),
    ("Il secondo giunto è bloccato.", "locked"),
    ("The second axis is now turned round.", "turned round 2"),
    (
        r"On inverse maintenant le sens du second moteur : un $\theta_2$ positif plie le coude.",
        r"turned round \theta_2",
    ),
    ("Der zweite Motor ist jetzt umgepolt.", "turned round 2"),
    ("Ahora se invierte el sentido del segundo motor.", "turned round 2"),
    (
        r"From now on the scale runs in the opposite direction: a positive $d_2$ is on the other side.",
        "turned round d_2",
    ),
    ("From now on the second joint, seen from above, turns the other way.", "turned round 2"),
    (r"The rows of $J$ are $(\omega_z, \dot x, \dot y)$.", r"task by \omega_z;x;y"),
    (r"Les lignes de $J$ sont dans l'ordre $(\dot p_z, \dot p_x)$.", "task by p_z;p_x"),
    ("The second robot has the same bars.", "other build"),
    ("Un autre bras a les mêmes segments.", "other build"),
    ("Der zweite Roboter hat einen Riemen.", "other build"),
    ("The robot is put on a table of height $H$.", "other build"),
    ("It is then moved on by $b$ along $x$:", "other build"),
    ("On suspend ce robot au plafond, la tête en bas.", "other build"),
    ("On pose le robot sur un socle de hauteur $H$.", "other build"),
    ("Der Roboter wird an der Decke aufgehängt.", "other build"),
    ("With a screwdriver of length $e$ in the gripper", "other build"),
    ("On fixe au bout de l'avant-bras un stylo de longueur $e$.", "other build"),
    ("All lengths are multiplied by $k$.", "other build"),
    ("On double toutes les longueurs du robot.", "other build"),
    (r"Si l'on rallonge l'avant-bras de $\varepsilon$", "other build"),
    ("The base frame is frame 1.", "counted from one"),
    ("Das Basissystem heißt bei uns $1$.", "counted from one"),
    (r"Here frame $i + 1$ is fixed to link $i$.", "counted from one"),
    (r"Le repère de base est $R_1$.", "counted from one"),
    ("The table lists the joints beginning with the tool.", "from tool"),
    ("Die Zeilen der Tabelle zählen wir vom Werkzeug aus.", "from tool"),
    ("Row 1 is the last joint.", "from tool"),
]
NOT_TOLD = [
    r"The Jacobian with respect to $(\alpha, \beta)$ is",
    r"The tool is at $(x, y)$.",
    r"The Jacobian is a function of $(\theta_1, \theta_2)$.",
    r"The entry $(i, j)$ of the Jacobian is",
    r"The Jacobian has the size $(m, n)$.",
    r"We control $\theta_1$ and $\theta_2$.",
    "Only the determinant matters.",
    "The matrix is constant.",
    "Axis $Z_i$ lies along joint $i$, and frame $i$ is fixed to link $i$.",
    "A joint does not move its own axis.",
    r"There are no others: the target fixes $\theta_2$ up to its sign, and this is all.",
    r"Does only $\theta_1$ move?",
    "The inverse model has two solutions.",
    "The force acts in the opposite direction.",
    r"The motors count the other way round: $q_1 = \theta_1$ and $q_2 = -\theta_2$.",
    "The second link is longer.",
    "Note the minus: seen from above, the second joint turns the other way.",
    r"The joint vector is $q = (\alpha, \gamma)$, in this order.",
    "The last step is a loop over the rows, from the tool to the base.",
    "Une boucle sur les lignes, à partir de l'outil, multiplie les matrices.",
    r"The rows of $J$ are $(v_x, v_y, v_z, \omega_x, \omega_y, \omega_z)$.",
    "The robot can be mounted on a table.",
    "What changes if the robot hangs from the ceiling?",
    "In the table the arm is placed so that",
    "The angle between both links is doubled.",
    "Multiplying both sides by the length $l_1$",
    "We write the transformation of each link before multiplying them to obtain $p_e$.",
    "The tip moves by $b$.",
    "The gripper of length $a$ moves.",
    r"The robot is turned by $\theta_1$.",
    "The base frame is frame 0.",
    r"The frames are numbered from $0$ to $n$.",
    "The links are numbered from 1 to 6.",
    "The table has a row for each joint.",
    "The table of the tool is given.",
]
PAGE = "# A page\n\n$$ a = 1 $$\n\n{}\n\n$$ b = 2 $$\n"
KINDS = ("task", "locked", "turned round", "other build", "counted from one", "from tool")


def _told(text: str) -> list[str]:
    last = parse_document(Path("x.md"), PAGE.format(text)).displays[-1]
    return [each for each in last.meant if each.startswith(KINDS)]


@pytest.mark.parametrize(("text", "told"), TOLD)
def test_what_holds_of_the_displays_behind_is_heard(text: str, told: str) -> None:
    assert told in _told(text)


@pytest.mark.parametrize("text", NOT_TOLD)
def test_what_tells_nothing_is_not_heard(text: str) -> None:
    assert _told(text) == []


def test_what_is_told_of_a_section_ends_with_it() -> None:
    text = "# A\n\n## B\n\nThe brake holds the elbow.\n\n$$ a = 1 $$\n\n## C\n\n$$ b = 2 $$\n"
    inside, behind = parse_document(Path("x.md"), text).displays
    assert "locked" in inside.meant and "locked" not in behind.meant
