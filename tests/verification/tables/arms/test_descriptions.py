"""An arm that a text tells of in words is taken where equations hold for it, and refutes nothing that another reading allows."""

from __future__ import annotations

import re

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


def with_slips(text: str) -> list[str]:
    """Return the copies of a text in which one «right¦wrong» each is wrong, the first all right."""
    marks = re.findall("«(.*?)¦(.*?)»", text)
    copies = []
    for slip in range(-1, len(marks)):
        copy = text
        for k, (right, wrong) in enumerate(marks):
            copy = copy.replace(f"«{right}¦{wrong}»", wrong if k == slip else right, 1)
        copies.append(copy)
    return copies


HOLDS = {"proved", "confirmed"}
NUMBERS = r"""
A planar robot has two revolute joints. The first link is 0.4 m long and the second 0.3 m.

$$ x = 0.4 \cos\theta_1 + 0.3 «\cos(\theta_1+\theta_2)¦\cos\theta_2» $$

$$ y = 0.4 \sin\theta_1 + 0.3 \sin(\theta_1+\theta_2) $$

$$ \det J = «0.12 \sin\theta_2¦0.12 \cos\theta_2» $$

$$ x^2 + y^2 = «0.25¦0.35» + 0.24 \cos\theta_2 $$
"""
CENTIMETRES = r"""
Un robot plan 2R a deux segments de 40 cm et 25 cm de long. On travaille en mètres.

$$ x = 0.4 \cos q_1 + 0.25 «\cos(q_1+q_2)¦\cos q_2» $$

$$ y = 0.4 \sin q_1 + 0.25 \sin(q_1+q_2) $$

$$ x^2 + y^2 = 0.2225 «+¦-» 0.2 \cos q_2 $$

$$ \det J = 0.1 \sin q_2 $$
"""
NAMED = r"""
A planar two-link arm has links of lengths $l_1$ and $l_2$. It stands 0.35 m above the floor.

$$ x = l_1 c_1 + «l_2 c_{12}¦l_2 c_2» $$

$$ y = 0.35 + l_1 s_1 + l_2 s_{12} $$

$$ \det J = «l_1 l_2 s_2¦l_1 l_2 c_2» $$

$$ x^2 + (y - 0.35)^2 = l_1^2 + l_2^2 + 2 l_1 l_2 c_2 $$
"""
FROM_VERTICAL = r"""
The boom has length $l_1$, the stick has length $l_2$. The angle $\theta_1$ is measured from the vertical $z$ axis; $\theta_2$ is the angle of the stick relative to the boom.

$$ x = l_1 \sin\theta_1 + l_2 «\sin(\theta_1+\theta_2)¦\cos(\theta_1+\theta_2)» $$

$$ z = l_1 \cos\theta_1 + l_2 «\cos(\theta_1+\theta_2)¦\cos\theta_2» $$

$$ \dot x = l_1 \dot\theta_1 \cos\theta_1 + l_2 (\dot\theta_1 + \dot\theta_2) \cos(\theta_1+\theta_2) $$

$$ \dot z = «-¦+» l_1 \dot\theta_1 \sin\theta_1 - l_2 (\dot\theta_1 + \dot\theta_2) \sin(\theta_1+\theta_2) $$
"""
SPHERICAL = r"""
Joint 1 turns by $\theta_1$ about the vertical, joint 2 raises the boom by the elevation $\theta_2$ above the horizontal, joint 3 extends it to the length $d_3$. The shoulder is at height $h$.

$$ x = d_3 \cos\theta_1 «\cos\theta_2¦\sin\theta_2» $$

$$ y = d_3 \sin\theta_1 \cos\theta_2 $$

$$ z = h + d_3 \sin\theta_2 $$

$$ d_3 = \sqrt{x^2 + y^2 + «(z-h)^2¦z^2»} $$
"""
GANTRY = r"""
The gantry moves along $x$ by $d_1$, along $y$ by $d_2$ and downwards by $d_3$; the gripper turns by $\theta_4$ about the vertical. The rails lie at height $h$.

$$ T = \begin{bmatrix} \cos\theta_4 & «-\sin\theta_4¦\sin\theta_4» & 0 & d_1 \\ \sin\theta_4 & \cos\theta_4 & 0 & d_2 \\ 0 & 0 & 1 & h - d_3 \\ 0 & 0 & 0 & 1 \end{bmatrix} $$

$$ x = d_1, \quad y = d_2, \quad z = h «-¦+» d_3 $$

$$ J = \begin{bmatrix} 1 & 0 & 0 & 0 \\ 0 & 1 & 0 & 0 \\ 0 & 0 & «-1¦1» & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix} $$
"""


@pytest.mark.parametrize("text", [NUMBERS, CENTIMETRES, NAMED, FROM_VERTICAL, SPHERICAL, GANTRY])
def test_what_the_words_tell_proves_what_is_right_and_refutes_each_slip(text: str) -> None:
    right, *slips = with_slips(text)
    assert {*verdicts(right)} <= HOLDS
    for each in slips:
        found = verdicts(each)
        assert found.count("refuted") == 1 and {*found} - {"refuted"} <= HOLDS, each


def test_a_base_of_which_the_words_do_not_tell_is_that_of_the_formulas() -> None:
    text = r"""
The planar arm of lengths $l_1$ and $l_2$ stands with its first joint at the point $(x_0, y_0)$ of the workshop frame. With relative angles $\theta_1$ and $\theta_2$ we have

$$ x = x_0 + l_1 \cos\theta_1 + l_2 \cos(\theta_1+\theta_2) $$

$$ y = y_0 + l_1 \sin\theta_1 + l_2 \sin(\theta_1+\theta_2) $$

$$ (x - x_0)^2 + (y - y_0)^2 = l_1^2 + l_2^2 + 2 l_1 l_2 \cos\theta_2 $$

$$ \det J = «l_1 l_2 \sin\theta_2¦l_1 l_2 \cos\theta_2» $$
"""
    right, slip = with_slips(text)
    assert verdicts(right) == ["proved"] * 4
    assert verdicts(slip)[-1] == "refuted"


def test_an_angle_from_the_vertical_that_the_formulas_have_from_the_horizontal_is_left_open() -> None:
    text = r"""
The boom has length $l_1$, the stick length $l_2$. The angle $\theta_1$ is measured from the vertical $z$ axis; $\theta_2$ is relative to the boom.

$$ x = l_1 \cos\theta_1 + l_2 \cos(\theta_1+\theta_2) $$

$$ z = l_1 \sin\theta_1 + l_2 \sin(\theta_1+\theta_2) $$

$$ \dot x = -l_1 \dot\theta_1 \sin\theta_1 - l_2 (\dot\theta_1+\dot\theta_2) \sin(\theta_1+\theta_2) $$
"""
    assert "refuted" not in verdicts(text)
    assert verdicts(text)[-1] in ("proved", "unchecked")


def test_numbers_of_other_things_are_no_lengths() -> None:
    text = NUMBERS.replace("and the second 0.3 m.", "and the second 0.3 m. The payload of 3 kg is 0.24 m from the tip.")
    assert {*verdicts(with_slips(text)[0])} <= {"proved", "unchecked"}
    absolute = r"""
A planar two-link arm has links 0.5 m and 0.3 m long. Both joint angles are measured from the x axis of the base.

$$ x = 0.5 \cos\theta_1 + 0.3 \cos\theta_2 $$

$$ y = 0.5 \sin\theta_1 + 0.3 \sin\theta_2 $$

$$ x^2 + y^2 = 0.34 + 0.3 \cos(\theta_2-\theta_1) $$
"""
    assert "refuted" not in verdicts(absolute)


@pytest.mark.parametrize(
    "told",
    [
        r"Each angle is measured from the downward vertical: $\theta_1$ for the upper rod and $\theta_2$ for the lower rod.",
        r"The angles $\theta_1$ and $\theta_2$ of the upper and the lower rod are measured from the vertical.",
        r"$\theta_1$ is the angle of the upper rod from the vertical, $\theta_2$ that of the lower rod from the vertical.",
    ],
)
def test_angles_that_all_count_from_the_vertical_are_those_of_no_chain(told: str) -> None:
    text = rf"""
Two rods of lengths $l_1$ and $l_2$ hang from the ceiling. {told} The $y$ axis points up.

$$ x_1 = l_1 \sin\theta_1, \qquad y_1 = -l_1 \cos\theta_1 $$

$$ x_2 = l_1 \sin\theta_1 + l_2 \sin\theta_2 $$

$$ y_2 = -l_1 \cos\theta_1 - l_2 \cos\theta_2 $$

$$ \dot x_2 = l_1 \dot\theta_1 \cos\theta_1 + l_2 \dot\theta_2 \cos\theta_2 $$
"""
    result = verify_text(text)
    assert not result.arms
    assert verdicts(text)[-1] == "proved"
