"""What holds the tool to a surface, and what is always negative."""

from __future__ import annotations

import pytest

from armproof import verify_text
from armproof.verification.document.hearing import formulas_of, words_of
from armproof.verification.document.told_constraints import constrains_tool, is_negative
from armproof.verification.verdict import Verdict

CONSTRAINING = [
    "The tool slides along a vertical wall $x = b$.",
    "L'outil glisse le long du sol, $y$ est constant.",
    "The gripper moves with $y$ so that $y$ is constant.",
]
FREE = [
    "The third link slides along $z_2$.",
    "The carriage slides along a rail.",
    r"The angle $\theta_2$ is constant.",
    "Does the tool slide along the wall?",
    "The tool moves along a curve.",
    "A bridge travels along the floor axis $X$ by $q_1$.",
]
NEGATIVE = [
    "Every target has a negative $x$.",
    r"The wrist angle $\theta_5$ of this robot is always negative.",
    r"The second joint stays between $-90^\circ$ and $0$.",
]
NOT_NEGATIVE = [
    "If $x$ is negative, the other branch is taken.",
    "The discriminant $D$ is negative.",
    "$x$ is positive or negative.",
    r"The joint turns between $-90^\circ$ and $90^\circ$.",
    "The negative sign of $x$",
]
ARM = (
    "$$ x = l_1 c_1 + l_2 c_{12}, \\quad y = l_1 s_1 + l_2 s_{12} $$\n\n$$ \\det J = l_1 l_2 s_2 $$\n\n%s\n\n$$ %s $$\n"
)


@pytest.mark.parametrize(("text", "holds"), [*((e, True) for e in CONSTRAINING), *((e, False) for e in FREE)])
def test_what_constrains_the_tool_is_heard(text: str, holds: bool) -> None:
    assert constrains_tool(words_of(text), formulas_of(text)) is holds


@pytest.mark.parametrize(("text", "holds"), [*((e, True) for e in NEGATIVE), *((e, False) for e in NOT_NEGATIVE)])
def test_what_is_always_negative_is_heard(text: str, holds: bool) -> None:
    assert is_negative(words_of(text), formulas_of(text)) is holds


@pytest.mark.parametrize(
    ("said", "latex", "verdict"),
    [
        (CONSTRAINING[0], r"(l_1 s_1 + l_2 s_{12}) \dot\theta_1 + l_2 s_{12} \dot\theta_2 = 0", Verdict.UNCHECKED),
        ("The tool moves.", r"(l_1 s_1 + l_2 s_{12}) \dot\theta_1 + l_2 s_{12} \dot\theta_2 = 0", Verdict.REFUTED),
        (CONSTRAINING[0], "x = l_1 c_1 - l_2 c_{12}", Verdict.REFUTED),
        (NEGATIVE[1], r"s_1 = \sqrt{1 - c_1^2}", Verdict.UNCHECKED),
        ("The arm moves.", r"s_1 = \sqrt{1 - c_1^2}", Verdict.CONFIRMED),
    ],
)
def test_what_follows_from_it_is_left_open(said: str, latex: str, verdict: Verdict) -> None:
    assert verify_text(ARM % (said, latex)).equations[-1].verdict is verdict
