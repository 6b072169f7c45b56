"""What the text says of a notation, of a force and of every configuration changes what is decided beside it; what is near it does not."""

import pytest

from armproof import verify_text
from armproof.verification.document.denials import denies_above
from armproof.verification.document.in_words import said_in_words
from armproof.verification.document.told_notation import (
    ABSCISSA_FIRST,
    ORDINATE_FIRST,
    REACTION,
    RECIPROCAL,
    notations_told,
)
from armproof.verification.verdict import Verdict

PLANAR = r"""---
arm:
  dh: classic
  rows:
    - {a: l_1, alpha: 0, d: 0, theta: theta_1}
    - {a: l_2, alpha: 0, d: 0, theta: theta_2}
---
$$ J = \begin{bmatrix} -l_1 s_1 - l_2 s_{12} & -l_2 s_{12} \\ l_1 c_1 + l_2 c_{12} & l_2 c_{12} \end{bmatrix} $$

"""
OPEN = (Verdict.UNCHECKED,)
HOLDS = (Verdict.PROVED, Verdict.CONFIRMED)


def verdict_behind(said, latex):
    return verify_text(f"{PLANAR}{said}\n\n$$ {latex} $$\n").equations[-1].verdict


@pytest.mark.parametrize(
    ("sentence", "told"),
    [
        ("Here atan2 takes the abscissa first.", [ABSCISSA_FIRST]),
        (r"As in Excel, we write $\operatorname{atan2}(x, y)$.", [ABSCISSA_FIRST]),
        ("Bei arctan2 steht $x$ vorn.", [ABSCISSA_FIRST]),
        ("Dans le tableur, l'abscisse vient en premier dans atan2.", [ABSCISSA_FIRST]),
        (r"where $\operatorname{atan2}(y, x)$ is the angle of the point $(x, y)$.", [ORDINATE_FIRST]),
        ("On convient que atan2 prend l'ordonnée comme premier argument et l'abscisse comme second.", [ORDINATE_FIRST]),
        ("On convient que atan2 prend l'abscisse comme premier argument et l'ordonnée comme second.", [ABSCISSA_FIRST]),
        ("We agree that atan2 takes the ordinate first, the abscissa second.", [ORDINATE_FIRST]),
        ("In atan2 first comes the abscissa, then the ordinate.", [ABSCISSA_FIRST]),
        ("In atan2 the abscissa comes second, the ordinate first.", [ORDINATE_FIRST]),
        ("The function atan2 does not take the abscissa first.", []),
        (r"It follows that $\theta_1 = \operatorname{atan2}(x, y)$.", []),
        (r"Here $\sin^{-1}\theta$ means the reciprocal $1/\sin\theta$.", [RECIPROCAL]),
        (r"Hier ist $\sin^{-1}$ der Kehrwert.", [RECIPROCAL]),
        (r"Here $\sin^{-1}\theta$ is not the reciprocal.", []),
        (r"Here $\sin^{-1}\theta$ is the arc sine.", []),
        ("The environment pushes against the tool with the force $F$.", [f"{REACTION} F"]),
        ("Sea $F$ la fuerza que la pieza ejerce sobre la herramienta.", [f"{REACTION} F"]),
        ("La force $f$ exercée sur la pince par le mur est connue.", [f"{REACTION} f"]),
        ("Die Kraft $F$, die die Wand auf das Werkzeug ausübt, ist bekannt.", [f"{REACTION} F"]),
        (
            r"The spring scale pulls on the tip with the force $f$ (the force the \emph{scale exerts on the arm}).",
            [f"{REACTION} f"],
        ),
        ("La force $F$ exercée sur la pince par un ressort est connue.", [f"{REACTION} F"]),
        ("The tool pushes against the wall with the force $F$.", []),
        ("The second link pushes on the tool with the force $F$.", []),
        ("The motors exert on the arm the torques that hold $F$.", []),
        ("The force $F$ that the hand exerts on the spring is known.", []),
        ("Sea $F$ la fuerza que la herramienta ejerce sobre la pieza.", []),
        ("The force $F$ is applied at the end effector.", []),
    ],
)
def test_a_sentence_tells_what_a_notation_is(sentence, told):
    assert [each.strip() for each in notations_told(sentence)] == told


@pytest.mark.parametrize(
    "said",
    [
        "In every posture of the arm we have",
        "Quelle que soit la configuration, on a",
        "En todas las configuraciones, sin excepción, el rango es",
        "In allen Stellungen gilt",
        "So the arm is never singular:",
        r"For all $\theta_1$ and $\theta_2$ we have",
    ],
)
def test_a_rank_said_to_be_so_everywhere_is_no_generic_one(said):
    assert verdict_behind(said, r"\operatorname{rank} J = 2") in OPEN
    assert verdict_behind(said, r"\operatorname{rank} J = 1") is Verdict.REFUTED
    assert (
        verdict_behind(said, r"\operatorname{rank} \begin{bmatrix} c_1 & -s_1 \\ s_1 & c_1 \end{bmatrix} = 2") in HOLDS
    )


@pytest.mark.parametrize(
    "said",
    [
        "In general we have",
        "En général, on a",
        "In almost every posture we have",
        r"For all $\theta_2 \neq 0, \pi$ we have",
    ],
)
def test_a_rank_said_to_be_so_almost_everywhere_is_the_generic_one(said):
    assert verdict_behind(said, r"\operatorname{rank} J = 2") in HOLDS


@pytest.mark.parametrize(
    "said", ["The wall pushes against the tool with the force $F$.", "La pared ejerce la fuerza $F$ sobre la pinza."]
)
def test_the_torques_of_a_force_on_the_tool_are_not_decided(said):
    assert verdict_behind(said, r"\tau = J^T F") in OPEN
    assert verdict_behind(said, r"F = J^{-T} \tau") in OPEN
    assert verdict_behind(said, r"\dot x = J \dot q") in HOLDS


def test_the_torques_of_a_force_of_the_tool_are_a_law():
    assert verdict_behind("The tool pushes against the wall with the force $F$.", r"\tau = J^T F") in HOLDS
    on_tool = "The wall exerts the force $f$ on the tool."
    assert verdict_behind(on_tool, r"\tau = J^T F") in HOLDS  # F is another one


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (r"We write $\theta_{12}$ for the difference $\theta_1 - \theta_2$.", r"\theta_{12} = \theta_1 - \theta_2"),
        (r"On note $\theta_{12}$ la différence $\theta_1 - \theta_2$.", r"\theta_{12} = \theta_1 - \theta_2"),
        (r"Wir schreiben $\theta_{12}$ für die Summe $\theta_1 + \theta_2$.", r"\theta_{12} = \theta_1 + \theta_2"),
        (r"Here $\theta_{12}$ is the difference $\theta_1 - \theta_2$.", r"\theta_{12} = \theta_1 - \theta_2"),
        (r"Add $\theta_{12}$ for the difference $\theta_1 - \theta_2$.", None),
    ],
)
def test_a_shorthand_is_said_to_be_a_difference(text, said):
    assert said_in_words(text, text.index("$")) == said


def test_twice_as_fast_denies_nothing():
    assert not denies_above("A gear makes the second joint turn twice as fast as the first, and the other way round.")
    assert denies_above("The last term stands there twice.")


def test_what_is_told_of_atan2_decides():
    told = "Here atan2 takes the abscissa first."
    assert verdict_behind(told, r"\theta_2 = \operatorname{atan2}(c_2, s_2)") in HOLDS
    assert verdict_behind(told, r"\theta_2 = \operatorname{atan2}(s_2, c_2)") in OPEN
    assert verdict_behind(told, r"\theta_2 = \operatorname{atan2}(c_1, s_2)") in OPEN
    told = "Here atan2 takes the ordinate as its first argument and the abscissa as the second."
    assert verdict_behind(told, r"\theta_2 = \operatorname{atan2}(s_2, c_2)") in HOLDS
    assert verdict_behind(told, r"\theta_2 = \operatorname{atan2}(c_2, s_2)") is Verdict.REFUTED
    assert verdict_behind("Here is the angle.", r"\theta_2 = \operatorname{atan2}(c_2, s_2)") in OPEN


def test_a_reciprocal_sine_is_not_decided():
    told = r"Here $\sin^{-1}\theta$ means the reciprocal $1/\sin\theta$."
    assert verdict_behind(told, r"\frac{1}{\det J} = \frac{\sin^{-1}\theta_2}{l_1 l_2}") in OPEN
    assert (
        verdict_behind("Here the sine is a ratio.", r"\frac{1}{\det J} = \frac{\sin^{-1}\theta_2}{l_1 l_2}")
        is Verdict.REFUTED
    )
