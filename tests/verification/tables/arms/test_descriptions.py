"""An arm that a text tells of in words is taken where equations hold for it, and refutes nothing that another reading allows."""

from __future__ import annotations

import pytest

from armproof import verify_text

PLANAR = r"""
Le premier segment, de longueur $l_1$, fait l'angle $\theta_1$ avec l'axe $x_0$ ; le second, de longueur $l_2$, fait l'angle $\theta_2$ avec le premier.
"""
RATES = r"""
$$ \dot x = -l_1 \dot\theta_1 \sin\theta_1 - l_2 (\dot\theta_1 + \dot\theta_2) \sin(\theta_1 + \theta_2) $$

$$ \dot y = l_1 \dot\theta_1 \cos\theta_1 + l_2 (\dot\theta_1 + \dot\theta_2) \cos(\theta_1 + \theta_2) $$
"""
QUILL = r"""
The column has height $h$. The first link, of length $l_1$, turns by $\theta_1$ about the vertical axis, the second, of length $l_2$, turns by $\theta_2$ relative to the first. The quill goes down by $d_3$.

$$ x = l_1 \cos\theta_1 + l_2 \cos(\theta_1 + \theta_2) $$

$$ y = l_1 \sin\theta_1 + l_2 \sin(\theta_1 + \theta_2) $$

$$ z = h + d_3 $$

$$ \dot z = \dot d_3 $$

$$ d_3 = z - h $$
"""


def verdicts(text: str) -> list[str]:
    return [record.verdict.value for record in verify_text(text).equations]


def test_words_and_two_equations_give_an_arm() -> None:
    (arm,) = verify_text(PLANAR + RATES).arms
    assert (arm.source, arm.line, arm.convention) == ("description", 2, "classic")
    assert verdicts(PLANAR + RATES) == ["proved", "proved"]


def test_no_words_give_none() -> None:
    assert not verify_text(RATES).arms


def test_one_equation_does_not_show_that_an_arm_is_meant() -> None:
    assert not verify_text(PLANAR + RATES.split("\n\n")[0]).arms


def test_a_slip_beside_them_is_refuted() -> None:
    text = PLANAR + RATES + r"$$ \det J = l_1 l_2 \cos\theta_2 $$"
    assert verdicts(text)[-1] == "refuted"
    assert verdicts(text.replace(r"\cos\theta_2 $$", r"\sin\theta_2 $$"))[-1] == "proved"


def test_a_slip_in_a_coordinate_is_refuted() -> None:
    y = r"$$ y = l_1 \sin\theta_1 + l_2 \sin(\theta_1 + \theta_2) $$"
    assert verdicts(PLANAR + RATES + y)[-1] == "proved"
    assert verdicts(PLANAR + RATES + y.replace("l_2", "l_1"))[-1] == "refuted"


def test_what_the_formulas_turn_round_is_left_open() -> None:
    found = verdicts(QUILL)
    assert found[:2] == ["proved", "proved"]
    assert {*found[2:]} == {"unchecked"}
    turned = QUILL.replace("h + d_3", "h - d_3").replace(r"= \dot d_3", r"= -\dot d_3").replace("z - h", "h - z")
    assert verdicts(turned) == ["proved"] * 5


def test_the_name_of_the_tools_point_is_told() -> None:
    text = (
        PLANAR + "On note $P$ l'extrémité du second segment.\n" + RATES.replace("x =", "x_P =").replace("y =", "y_P =")
    )
    assert verdicts(text) == ["proved", "proved"]


@pytest.mark.parametrize(
    "text",
    [
        r"""
The first link, of length $l_1$, makes the angle $\theta_1$ with the $x$ axis; the second, of length $l_2$, makes the angle $\theta_2$ with the $x$ axis.

$$ \dot x = -l_1 \dot\theta_1 \sin\theta_1 - l_2 \dot\theta_2 \sin\theta_2 $$

$$ \dot y = l_1 \dot\theta_1 \cos\theta_1 + l_2 \dot\theta_2 \cos\theta_2 $$

$$ \det J = l_1 l_2 \sin(\theta_2 - \theta_1) $$
""",
        r"""
A planar arm has links of lengths $l_1$, $l_2$ and a hand of length $l_3$. The first link makes the angle $\theta_1$ with the $x$ axis, the second the angle $\theta_2$ with the first, and the hand the angle $\theta_3$ with the second link.

The wrist is at

$$ x = l_1 \cos\theta_1 + l_2 \cos(\theta_1 + \theta_2) $$

$$ y = l_1 \sin\theta_1 + l_2 \sin(\theta_1 + \theta_2) $$

$$ x^2 + y^2 = l_1^2 + l_2^2 + 2 l_1 l_2 \cos\theta_2 $$

$$ \phi = \theta_1 + \theta_2 + \theta_3 $$
""",
        r"""
A mobile robot turns by $\theta$ about the vertical axis; its wheels, of radius $r$, stand at a distance $d$ from the axis and turn by $\phi_1$ and $\phi_2$.

$$ \dot x = \frac{r}{2} (\dot\phi_1 + \dot\phi_2) \cos\theta $$

$$ \dot y = \frac{r}{2} (\dot\phi_1 + \dot\phi_2) \sin\theta $$
""",
        r"""
The crank of length $a$ turns by $\theta_2$, the coupler of length $b$ makes the angle $\theta_3$ with the $x$ axis, the rocker of length $c$ makes the angle $\theta_4$ with the $x$ axis.

$$ x = a \cos\theta_2 + b \cos\theta_3 $$

$$ y = a \sin\theta_2 + b \sin\theta_3 $$

$$ a \sin\theta_2 + b \sin\theta_3 = c \sin\theta_4 $$
""",
        r"""
The first bar, of length $l_1$, makes the angle $\theta_1$ with the downward vertical; the second, of length $l_2$, makes the angle $\theta_2$ with the first.

$$ x = l_1 \sin\theta_1 + l_2 \sin(\theta_1 + \theta_2) $$

$$ y = -l_1 \cos\theta_1 - l_2 \cos(\theta_1 + \theta_2) $$

$$ x^2 + y^2 = l_1^2 + l_2^2 + 2 l_1 l_2 \cos\theta_2 $$

$$ \det J = l_1 l_2 \sin\theta_2 $$
""",
    ],
    ids=["absolute", "wrist", "mobile", "four-bar", "pendulum"],
)
def test_nothing_right_is_refuted_of_another_mechanism(text: str) -> None:
    assert "refuted" not in verdicts(text)
