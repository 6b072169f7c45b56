r"""What sentences tell of an arm's build, letter by letter: "de longueur $l_1$" is a length, "turns by $\theta_1$ about $z_0$" an upright axis."""

from __future__ import annotations

import pytest

from armproof.verification.document.told_chains import told_parts

TOLD = [
    (
        r"Le premier segment, de longueur $l_1$, fait l'angle $\theta_1$ avec l'axe $x_0$ ;",
        [("length", "l_1"), ("turn", r"\theta_1", "absolute")],
    ),
    (
        r"the second, of length $l_2$, makes the angle $\theta_2$ with the first.",
        [("length", "l_2"), ("turn", r"\theta_2", "relative")],
    ),
    (
        r"The column turns by $\theta_1$ about $z_0$, the carriage rises by $d_2$ along the column.",
        [("turn", r"\theta_1", "upright"), ("slide", "d_2", "up")],
    ),
    (
        r"A planar arm has three links of lengths $l_1$, $l_2$ and $l_3$.",
        [("length", "l_1"), ("length", "l_2"), ("length", "l_3")],
    ),
    (r"The upper arm has length $l_2$ and the forearm $l_3$.", [("length", "l_2"), ("length", "l_3")]),
    (r"L'épaule est à la hauteur $h$.", [("height", "h")]),
    (r"L'outil descend d'une hauteur $d$.", [("slide", "d", "down")]),
    (r"The carriage moves up and down the column by a height $h$.", [("slide", "h", "up")]),
    (r"Ein Schubgelenk fährt den Arm auf die Länge $d_3$ aus.", [("slide", "d_3")]),
    (r"Un outil est décalé de $e$ suivant l'axe $y_1$.", [("offset", "e", "y")]),
    (r"On note $P$ l'extrémité du second segment.", [("end", "P", "2")]),
    (
        r"El brazo se mueve en el plano vertical $(x, z)$.",
        [("plane", "xz")],
    ),
    (
        r"The elbow (angle $\theta_3$, measured from the upper arm) has a horizontal axis.",
        [("turn", r"\theta_3", "relative")],
    ),
    (r"The mass $m_1$ of length unknown hangs at $P$.", []),
    (r"Let $x$ and $y$ be the coordinates.", []),
]


@pytest.mark.parametrize(("sentence", "told"), TOLD)
def test_words_tell_what_a_letter_is(sentence: str, told: list[tuple[str, ...]]) -> None:
    assert [(each.kind, each.letter, *sorted(each.marks)) for each in told_parts(sentence, (None, 1), (0, 2))] == told
