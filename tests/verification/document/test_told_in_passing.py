"""What sentences tell of letters in passing, by kinds of words, leaves open what is written with them in the section, and nothing else."""

from __future__ import annotations

from pathlib import Path

import pytest

from armproof.verification.check import verify_text
from armproof.verification.verdict import Verdict

TABLE = r"""# A planar arm

| $i$ | $\theta_i$ | $d_i$ | $a_i$ | $\alpha_i$ |
|---|---|---|---|---|
| 1 | $\theta_1$ | 0 | $l_1$ | 0 |
| 2 | $\theta_2$ | 0 | $l_2$ | 0 |

"""
HAND = r"x = l_1 \cos\theta_1 + l_2 \cos(\theta_1+\theta_2)"
RATE = r"\dot x = -(l_1 s_1 + l_2 s_{12})\,\dot\theta_1 - l_2 s_{12}\,\dot\theta_2"
JACOBIAN = r"J = \begin{bmatrix} -l_1 s_1 - l_2 s_{12} & -l_2 s_{12} \\ l_1 c_1 + l_2 c_{12} & l_2 c_{12} \end{bmatrix}"
ROTATION = r"R = \begin{bmatrix} c_{12} & -s_{12} & 0 \\ s_{12} & c_{12} & 0 \\ 0 & 0 & 1 \end{bmatrix}"
POINT = r"p = \begin{bmatrix} l_1 c_1 + l_2 c_{12} \\ l_1 s_1 + l_2 s_{12} \\ 0 \end{bmatrix}"
TURN = r"\varphi = \theta_1 + \theta_2"
TOLD = [
    (JACOBIAN, "We put the speed of lifting into the upper row of $J$ and the speed of reaching into the lower one."),
    (JACOBIAN, "Oben steht die Geschwindigkeit des Hebens und darunter die des Vorschubs."),
    (JACOBIAN, r"En haut de $\dot q$ se trouve la vitesse du coude, et en bas celle de l'épaule."),
    (JACOBIAN, r"The gyroscopes on the bars show two numbers, which stand in $\dot q$."),
    (HAND, r"Auf jedem Stab liegt eine Wasserwaage, und sie zeigt die Winkel $\theta_1$ und $\theta_2$."),
    (HAND, r"Cada barra tiene un inclinómetro, que mide los ángulos $\theta_1$ y $\theta_2$."),
    (ROTATION, "The matrix $R$ converts the components of a vector in the base into those in the tool."),
    (ROTATION, "A matriz $R$ converte as componentes de um vetor na base nas componentes do mesmo vetor na garra."),
    (ROTATION, "La matrice $R$ convertit les coordonnées dans la base en celles dans la pince."),
    (RATE, r"The camera follows the elbow. The camera delivers $\dot x$."),
    (HAND, "Die Kamera sieht den Ellbogen und misst $x$ und $y$."),
    (HAND, "La caméra suit le coude. Le capteur donne $x$ et $y$."),
    (POINT, "The arrow $p$ starts at the hand and ends at the shoulder."),
    (POINT, "Der Pfeil $p$ beginnt am Greifer und endet an der Schulter."),
    (POINT, "La flèche $p$ part de la pince et arrive à l'épaule."),
    (TURN, r"The direction $\varphi$ is given as on a compass."),
    (TURN, r"La direction $\varphi$ est celle d'une boussole."),
    (HAND, "A model is built at the scale 1:2, and $x$ and $y$ are measured there."),
    (HAND, r"Ab hier zählen wir den Winkel $\theta_2$ nach rechts."),
    (HAND, r"L'angle $\theta_2$ croît vers la droite."),
    (HAND, r"El ángulo $\theta_2$ crece hacia la derecha."),
    (HAND, r"The elbow is bent by $30^\circ$ there, so $\theta_2$ is zero there."),
    (HAND, r"Dort ist der Arm um $30^\circ$ gebeugt, und $\theta_2$ ist null."),
    (HAND, r"Le bras est plié de $30^\circ$ là où $\theta_2$ est nul."),
    (HAND, "Here $c_{12}$ is the cosine of the difference of both angles."),
]
HARMLESS = [
    (JACOBIAN, "The upper row of $J$ gives the velocity along $x$ and the lower one that along $y$."),
    (JACOBIAN, r"The rate of the shoulder stands at the top of $\dot q$, and that of the elbow below."),
    (JACOBIAN, "The upper arm turns with the speed of the shoulder, the forearm below it follows."),
    (HAND, r"The arm is a double pendulum, whose angles $\theta_1$ and $\theta_2$ are given."),
    (ROTATION, "The matrix $R$ converts the components of a vector in the tool into those in the base."),
    (ROTATION, "La matrice $R$ convertit les coordonnées dans la pince en celles dans la base."),
    (RATE, r"The camera follows the hand. The camera delivers $\dot x$."),
    (POINT, "The arrow $p$ starts at the shoulder and ends at the hand."),
    (HAND, "The camera follows the hand, and it measures $x$ and $y$."),
    (HAND, r"Wir zählen den Winkel $\theta_2$ nach links."),
    (HAND, r"The elbow is straight there, so $\theta_2$ is zero there."),
    (HAND, "Here $c_{12}$ is the cosine of the sum of both angles."),
]
OTHER_ARM = [
    "Now we take the two bars and put each in the place of the other.",
    "Wir vertauschen die beiden Glieder.",
    "On échange les deux barres.",
    r"The foot of the robot is fixed turned by the angle $\beta$.",
    "We look at the arm in a mirror.",
    "Wir sehen den Roboter im Spiegel.",
    "L'avant-bras a une rallonge.",
    "Nella variante il secondo membro ha una prolunga.",
]


def _last(display: str, sentence: str) -> Verdict:
    text = f"{TABLE}$$ {HAND} $$\n\n## Here\n\n{sentence} The table is long. We get\n\n$$ {display} $$\n"
    return verify_text(text, path=Path("x.md")).equations[-1].verdict


def _wrong(display: str) -> str:
    return display.replace("l_2", "2 l_2") if "l_2" in display else display.replace("+ \\theta_2", "- \\theta_2").replace("-s_", "2 s_")  # fmt: skip


@pytest.mark.parametrize(("display", "sentence"), TOLD)
def test_what_is_told_in_passing_leaves_its_letter_open(display: str, sentence: str) -> None:
    assert _last(display, sentence) is Verdict.UNCHECKED
    assert _last(_wrong(display), sentence) is Verdict.UNCHECKED


@pytest.mark.parametrize(("display", "sentence"), HARMLESS)
def test_the_same_words_said_of_what_is_usual_cost_nothing(display: str, sentence: str) -> None:
    assert _last(display, sentence) is Verdict.PROVED


@pytest.mark.parametrize("sentence", OTHER_ARM)
def test_an_arm_that_is_another_in_plain_words_is_left_open(sentence: str) -> None:
    assert _last(HAND, sentence) is Verdict.UNCHECKED
    assert _last(HAND.replace("l_1", "l").replace("l_2", "l_1").replace("l ", "l_2 "), sentence) is Verdict.UNCHECKED


@pytest.mark.parametrize(
    "sentence",
    [
        "The two bars stand in the place of the old ones.",
        "The forearm makes an angle with the extension of the upper arm.",
        "The mirror of the robot is clean.",
    ],
)
def test_harmless_words_of_parts_leave_the_arm_what_it_is(sentence: str) -> None:
    assert _last(HAND, sentence) is Verdict.PROVED


def test_lengths_of_other_links_and_a_bent_zero_contradict_a_closed_form() -> None:
    page = "# A planar arm\n\n{} Both turn about parallel axes.\n\nThe hand is at\n\n$$ x = l_1 \\cos\\theta_1 + l_2 \\cos(\\theta_1+\\theta_2) $$\n\n$$ y = l_1 \\sin\\theta_1 + l_2 \\sin(\\theta_1+\\theta_2) $$\n\nSo\n\n$$ \\dot x = -y \\dot\\theta_1 - l_2 \\sin(\\theta_1+\\theta_2) \\dot\\theta_2 $$\n"  # fmt: skip
    lengths = "The robot consists of an upper arm (length ${}$) and a forearm (length ${}$). The shoulder turns by $\\theta_1$ and the elbow by $\\theta_2$."  # fmt: skip
    for told, verdict in ((("l_1", "l_2"), Verdict.PROVED), (("l_2", "l_1"), Verdict.UNCHECKED)):
        assert verify_text(page.format(lengths.format(*told)), path=Path("x.md")).equations[-1].verdict is verdict
    zero = "With both scales at zero the lamp is right under the hinge. It has the angles $\\theta_1$ and $\\theta_2$."
    assert all(
        each.verdict is Verdict.UNCHECKED for each in verify_text(page.format(zero), path=Path("x.md")).equations
    )
