r"""What the words before a display say besides: another arm, origin, unit or branch, a size; each beside a sentence that says nothing of the kind."""

from __future__ import annotations

import pytest

from armproof.verification.check import verify_text

PLANAR = "---\narm: planar_2r\n---\n"
ELBOW = """---
arm:
  dh: classic
  rows:
    - {a: 0, alpha: pi/2, d: d_1, theta: theta_1}
    - {a: a_2, alpha: 0, d: 0, theta: theta_2}
    - {a: a_3, alpha: 0, d: 0, theta: theta_3}
---
"""
X = r"x = l_1 c_1 + l_2 c_{12}"
POINT = X + r", \quad y = l_1 s_1 + l_2 s_{12}"
SQUARE = r"= x^2 + y^2 = l_1^2 + l_2^2 + 2 l_1 l_2 c_2"
DET = r"w = \det J = l_1 l_2 s_2"
ARCCOS = r"\arccos\frac{x^2 + y^2 - l_1^2 - l_2^2}{2 l_1 l_2}"
HEIGHT = r"z = a_2 \sin\theta_2 + a_3 \sin(\theta_2 + \theta_3)"
FROM_BASE = HEIGHT.replace("= ", "= d_1 + ")
FROM_REST = r"\ddot x = -l_1 s_1 \ddot\theta_1 - l_2 s_{12} (\ddot\theta_1 + \ddot\theta_2)"


def last_verdict(front: str, sentence: str, display: str, before: str = POINT) -> str:
    """Return what becomes of a display behind a sentence."""
    return verify_text(f"{front}\n$$ {before} $$\n\n{sentence}\n\n$$ {display} $$\n").equations[-1].verdict.value


@pytest.mark.parametrize(
    ("sentence", "display", "verdict"),
    [
        ("From this we find how far the hand is from the shoulder:", f"d {SQUARE}", "unchecked"),
        ("Pythagoras gives the distance", f"d {SQUARE}", "unchecked"),
        ("La portée du bras vaut", rf"\rho {SQUARE}", "unchecked"),
        ("The squared distance of the hand from the shoulder is", f"d {SQUARE}", "proved"),
        ("The sum of both squares is", f"d {SQUARE}", "proved"),
        ("The measure of dexterity is the absolute value", DET, "unchecked"),
        ("The volume of the ellipsoid is proportional to", DET, "unchecked"),
        ("The determinant is", DET, "proved"),
        ("Without the forearm the hand would be at", X, "unchecked"),
        ("A forearm that is twice as long gives", X, "unchecked"),
        ("A forearm that is twice as long gives", X.replace("l_2", "2 l_2"), "unchecked"),
        ("We now mount the tool at the middle of the forearm:", X.replace("l_2", r"\tfrac12 l_2"), "unchecked"),
        ("The tool is mounted at the end of the forearm:", X.replace("l_2", r"\tfrac12 l_2"), "refuted"),
        ("With $l_2$ replaced by $l_2 + t$ the tip is at", X, "unchecked"),
        ("With $c_{12}$ replaced by its value the tip is at", X, "proved"),
        ("The angle $\\theta_2$ is driven over a belt:", X, "unchecked"),
        ("Both motors sit in the base.", X, "unchecked"),
        ("The angle $\\theta_2$ counts in the opposite sense:", X, "unchecked"),
        ("The joint $\\theta_2$ now turns in the opposite direction.", X, "unchecked"),
        ("A negative $\\theta_2$ turns the forearm in the opposite direction.", X, "proved"),
        ("We count $\\theta_1$ from the $x$ axis:", X, "proved"),
        ("The acceleration of the hand from rest is", FROM_REST, "proved"),
        ("The acceleration of the hand from rest is", FROM_REST.replace("- l_2", "+ l_2"), "refuted"),
        ("The acceleration of the hand is", FROM_REST, "refuted"),
        ("In the elbow-up posture", rf"\theta_2 = -{ARCCOS}", "confirmed"),
        ("In the elbow-up posture", rf"\theta_2 = {ARCCOS}", "unchecked"),
        ("Coude en bas :", rf"\theta_2 = {ARCCOS}", "confirmed"),
        ("Coude en bas :", rf"\theta_2 = -{ARCCOS}", "unchecked"),
        ("For the elbow-up and the elbow-down posture", rf"\theta_2 = {ARCCOS}", "confirmed"),
    ],
)
def test_what_a_sentence_says_of_a_planar_arm(sentence: str, display: str, verdict: str) -> None:
    assert last_verdict(PLANAR, sentence, display) == verdict


@pytest.mark.parametrize(
    ("sentence", "display", "verdict"),
    [
        ("Measured from the shoulder, the tool is at the height", HEIGHT, "unchecked"),
        ("Measured from the shoulder, the tool is at the height", FROM_BASE, "unchecked"),
        ("With the origin in the shoulder,", HEIGHT, "unchecked"),
        ("Depuis l'épaule, on mesure", HEIGHT, "unchecked"),
        ("The height of the tool is", HEIGHT, "refuted"),
        ("The height of the tool is", FROM_BASE, "proved"),
        ("The wrist, at the end of link 2, is at", FROM_BASE, "unchecked"),
        ("The tool, at the end of link 3, is at", FROM_BASE, "proved"),
        ("The tip of the upper arm is at", FROM_BASE, "unchecked"),
        ("The tip of the arm is at", FROM_BASE, "proved"),
        ("With a tool of 10 cm in the hand, its tip is at the height", FROM_BASE, "unchecked"),
        ("With the tool in the hand, its tip is at the height", FROM_BASE, "proved"),
    ],
)
def test_what_a_sentence_says_of_an_arm_with_a_column(sentence: str, display: str, verdict: str) -> None:
    assert last_verdict(ELBOW, sentence, display, FROM_BASE) == verdict


def test_the_shoulder_of_a_planar_arm_is_its_base() -> None:
    assert last_verdict(PLANAR, "Measured from the shoulder, the hand is at", X) == "proved"


NUMBERS = r"$l_1 = l_2 = 1$, $\theta_1 = 0$ and $\theta_2 = \pi/2$"


@pytest.mark.parametrize(
    ("sentence", "display", "verdict"),
    [
        (rf"The shoulder turns at 30 degrees per second, $\dot\theta_1 = 30$, and $\dot\theta_2 = 0$. With {NUMBERS}", r"\dot x = -30", "unchecked"),
        (rf"Le moteur fait 10 tours par minute ($\dot\theta_1 = 10$, $\dot\theta_2 = 0$). Avec {NUMBERS}", r"\dot x = -10", "unchecked"),
        (rf"The shoulder turns at $\dot\theta_1 = 0.5$, and $\dot\theta_2 = 0$. With {NUMBERS}", r"\dot x = -0.5", "confirmed"),
        (r"With $l_1 = 30$ and $l_2 = 20$ (both in centimetres), $\theta_1 = 0$ and $\theta_2 = \pi/2$. In millimetres,", "x = 30, \\quad y = 20", "unchecked"),
        (r"With $l_1 = 30$ and $l_2 = 20$ (both in centimetres), $\theta_1 = 0$ and $\theta_2 = \pi/2$, it is at", "x = 30, \\quad y = 20", "confirmed"),
        (r"With $l_1 = 3$, $l_2 = 2$, $\theta_1 = 90$ and $\theta_2 = 90$ degrees it is at", "x = -2, \\quad y = 3", "confirmed"),
        (r"With $l_1 = 3$, $l_2 = 2$, $\theta_1 = 90$ and $\theta_2 = 90$ degrees it is at", "x = 2, \\quad y = 3", "refuted"),
    ],
)  # fmt: skip
def test_numbers_in_the_units_that_the_text_has_for_them(sentence: str, display: str, verdict: str) -> None:
    assert last_verdict(PLANAR, sentence, display) == verdict


ACROSS = "The first link, of length $l_1$, turns by $\\theta_1$. At its end a slide moves perpendicular to the link by $d_2$."
GANTRY = "Three slides carry the tool along $x$ by $d_1$, along $y$ by $d_2$ and down by $d_3$."
BARS = "The first bar, of length $a$, turns by the angle $\\alpha$ about the $z$ axis; the second, of length $b$, makes the angle $\\beta$ with {}."
COLUMN = "A column turns by $\\theta_1$ about the vertical axis. A carriage on it is raised by $d_2$, and the arm{} is extended horizontally by $d_3$."
ABSOLUTE = [r"x = a\cos\alpha + b\cos(\alpha + \beta)", r"y = a\sin\alpha + b\sin(\alpha + \beta)"]
CYLINDER = [r"x = d_3\cos\theta_1, \quad y = d_3\sin\theta_1, \quad z = d_2"]


@pytest.mark.parametrize(
    ("arm", "displays", "passes"),
    [
        (ACROSS, [r"x = l_1 c_1 - d_2 s_1", r"y = l_1 s_1 + d_2 c_1"], None),
        (ACROSS, [r"x = (l_1 + d_2) c_1", r"y = (l_1 + d_2) s_1"], False),
        (GANTRY, ["x = d_1, \\quad y = d_2, \\quad z = -d_3"], True),
        (GANTRY, ["x = d_1", "y = d_2", "z = d_3"], False),
        (BARS.format("the first"), ABSOLUTE, True),
        (BARS.format("a fixed direction"), ABSOLUTE, False),
        (COLUMN.format(""), CYLINDER, True),
        (COLUMN.format(", which points along the $y$ axis at $\\theta_1 = 0$,"), CYLINDER, False),
    ],
)
def test_an_arm_told_in_words_has_the_directions_that_these_tell(
    arm: str, displays: list[str], passes: bool | None
) -> None:
    """The last of the displays holds, or must not pass."""
    text = f"# An arm\n\n{arm}\n\n" + "".join(f"$$ {each} $$\n\n" for each in displays)
    last = verify_text(text).equations[-1].verdict.value
    assert last != "refuted" if passes is None else (last in ("proved", "confirmed")) is passes


@pytest.mark.parametrize(
    ("words", "verdict"),
    [
        ("With the elbow locked,", "unchecked"),
        ("Again,", "confirmed"),
        (r"With the elbow locked, $\dot\theta_2 = 0$,", "confirmed"),
    ],
)
def test_rates_that_the_text_gave_before_are_none_of_a_joint_that_is_locked(words: str, verdict: str) -> None:
    text = r"""# Numbers

$$ x = l_1\cos\theta_1 + l_2\cos(\theta_1+\theta_2) $$

$$ y = l_1\sin\theta_1 + l_2\sin(\theta_1+\theta_2) $$

Let $l_1 = 2$ and $l_2 = 1$. The joints turn at $\dot\theta_1 = 1$ and $\dot\theta_2 = -1$ rad/s. At $\theta_1 = 0$, $\theta_2 = 90^\circ$:

$$ \dot x = 0, \qquad \dot y = 2 $$

With $\dot\theta_2 = 1$ instead,

$$ \dot x = -2, \qquad \dot y = 2 $$

%s

$$ \dot x = %d, \qquad \dot y = 2 $$
"""
    number = -1 if "= 0" in words else -2
    assert verify_text(text % (words, number)).equations[-1].verdict.value == verdict
