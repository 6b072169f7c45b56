r"""What sentences tell of the arm, and do not limit: an elevation counted from the vertical, a length that is constant, a question of singular configurations."""

from __future__ import annotations

import pytest

from armproof import verify_text
from armproof.verification.verdict import Verdict

TURRET = r"""{sentence}

| $i$ | $\theta_i$ | $d_i$ | $a_i$ | $\alpha_i$ |
|---|---|---|---|---|
| 1 | $\theta_1$ | $d_1$ | 0 | $\pi/2$ |
| 2 | {angle} | 0 | $a_2$ | 0 |

$$ x = a_2 {radius} \cos\theta_1 $$

$$ z = d_1 {height} $$
"""
UPRIGHT = {"angle": r"$\theta_2 + \pi/2$", "radius": r"(-\sin\theta_2)"}
STANFORD = r"""Classic DH parameters:

| $i$ | $\theta_i$ | $d_i$ | $a_i$ | $\alpha_i$ |
|---|---|---|---|---|
| 1 | $\theta_1$ | 0 | 0 | $-90^\circ$ |
| 2 | $\theta_2$ | $d_2$ | 0 | $90^\circ$ |
| 3 | 0 | $d_3$ | 0 | 0 |

{sentence}

$$ \dot z = -d_3 \sin\theta_2 \dot\theta_2 {sign} \cos\theta_2 \dot d_3 $$
"""
PLANAR = "---\narm: planar_2r\n---\n\n$$ \\det J = l_1 l_2 {factor} $$\n\n{question}\n"


def last(text: str) -> Verdict:
    return verify_text(text).equations[-1].verdict


@pytest.mark.parametrize(
    "sentence",
    [
        r"The base turns about the vertical by $\theta_1$, then comes an elevation $\theta_2$. The zero of $\theta_2$ is chosen with the arm vertical.",
        r"La base tourne de $\theta_1$, puis vient une élévation $\theta_2$. Le zéro de $\theta_2$ est choisi bras vertical.",
    ],
)
def test_an_elevation_may_be_counted_from_the_vertical(sentence: str) -> None:
    assert last(TURRET.format(sentence=sentence, **UPRIGHT, height=r"+ a_2 \cos\theta_2")) is Verdict.PROVED
    assert last(TURRET.format(sentence=sentence, **UPRIGHT, height=r"- a_2 \cos\theta_2")) is Verdict.REFUTED
    level = sentence.split(". ")[0].replace("elevation", "elevation above the horizontal").replace("élévation", "élévation au-dessus de l'horizontale") + ". " + sentence.split(". ")[1]  # fmt: skip
    assert last(TURRET.format(sentence=level, **UPRIGHT, height=r"+ a_2 \cos\theta_2")) is Verdict.UNCHECKED


@pytest.mark.parametrize(
    ("length", "joint"),
    [
        ("Here $d_2$ is constant.", "Here $d_3$ is constant."),
        ("Les variables sont $\\theta_1$, $\\theta_2$ et $d_3$ ; $d_2$ est une constante.", "Désormais $d_3$ est une constante."),
        ("Dabei ist $d_2$ konstant.", "Dabei ist nun $d_3$ konstant."),
        ("Aquí $d_2$ es constante.", "Aquí $d_3$ es constante."),
        ("Qui $d_2$ è costante.", "Qui $d_3$ è costante."),
    ],
)  # fmt: skip
def test_a_length_that_is_constant_locks_no_joint(length: str, joint: str) -> None:
    assert last(STANFORD.format(sentence=length, sign="+")) is Verdict.PROVED
    assert last(STANFORD.format(sentence=length, sign="-")) is Verdict.REFUTED
    assert last(STANFORD.format(sentence=joint, sign="-")) is Verdict.UNCHECKED


@pytest.mark.parametrize(
    ("of_the_arm", "of_the_display"),
    [
        ("*Question.* At which configurations is the arm singular?", "*Question.* For which configurations does this hold?"),
        ("Pour quelles configurations le bras est-il singulier ?", "Pour quelles configurations est-ce vrai ?"),
        ("Bei welchen Stellungen ist der Arm singulär?", "Bei welchen Stellungen gilt das?"),
        ("¿En qué configuraciones es singular el brazo?", "¿Es correcto?"),
        ("In quali configurazioni il braccio è singolare?", "**Domanda 2.** È vero?"),
        ("Em que configurações o braço é singular?", "Em que configurações é verdade?"),
    ],
)  # fmt: skip
def test_a_question_of_singular_configurations_limits_nothing(of_the_arm: str, of_the_display: str) -> None:
    assert last(PLANAR.format(factor=r"\sin\theta_2", question=of_the_arm)) is Verdict.PROVED
    assert last(PLANAR.format(factor=r"\cos\theta_2", question=of_the_arm)) is Verdict.REFUTED
    assert last(PLANAR.format(factor=r"\cos\theta_2", question=of_the_display)) is Verdict.UNCHECKED


def test_a_column_that_turns_about_its_axis_is_not_turned_round() -> None:
    column = r"Eine Säule der Höhe $h$ dreht sich um die senkrechte Achse mit dem Winkel $\theta_1$."
    turned = r"Die zweite Achse dreht sich jetzt um."
    page = "---\narm: planar_2r\n---\n\n$$ x = l_1 c_1 + l_2 c_{{12}} $$\n\n{sentence}\n\nEs gilt\n\n$$ y = l_1 s_1 + l_2 s_{{12}} $$\n"
    assert last(page.format(sentence=column)) is Verdict.PROVED
    assert last(page.format(sentence=turned)) is Verdict.UNCHECKED
