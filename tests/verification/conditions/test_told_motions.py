"""Accelerations where the text tells how the joints move: at constant rates, or from rest."""

from __future__ import annotations

import pytest

from tests.labelled.judging import verify_text

FRONT = "---\narm: planar_2r\n---\n$$ x = l_1 c_1 + l_2 c_{12}, \\qquad y = l_1 s_1 + l_2 s_{12} $$\n\n"
OF_SQUARES = r"\ddot y = -l_1 s_1 \dot\theta_1^2 {} l_2 s_{{12}} (\dot\theta_1 + \dot\theta_2)^2"
OF_ACCELERATIONS = r"\ddot y = l_1 c_1 \ddot\theta_1 {} l_2 c_{{12}} (\ddot\theta_1 + \ddot\theta_2)"


def verdict_of(said: str, display: str, between: str = "") -> str:
    return verify_text(f"{FRONT}{said}\n\n{between}$$ {display} $$\n").equations[-1].verdict.value


@pytest.mark.parametrize(("sign", "verdict"), [("-", "proved"), ("+", "refuted")])
@pytest.mark.parametrize(
    "said",
    [
        "At uniform joint rates the acceleration is",
        "With both axes turning steadily we have",
        "À vitesses articulaires constantes,",
        "Bei konstanten Winkelgeschwindigkeiten ist",
    ],
)
def test_at_constant_rates_no_joint_accelerates(said: str, sign: str, verdict: str) -> None:
    assert verdict_of(said, OF_SQUARES.format(sign)) == verdict


@pytest.mark.parametrize(("sign", "verdict"), [("+", "proved"), ("-", "refuted")])
@pytest.mark.parametrize(
    "said", ["While the motors stand still,", "The joint rates are all zero.", "At the moment of starting it is"]
)
def test_from_rest_no_joint_has_a_rate(said: str, sign: str, verdict: str) -> None:
    assert verdict_of(said, OF_ACCELERATIONS.format(sign)) == verdict


@pytest.mark.parametrize(
    "said",
    [
        "The hand moves at constant speed:",  # which no joint does then
        "With the first motor running steadily,",  # of the other one nothing is said
        "Unless the joint rates are constant, the acceleration is",
        "At constant rates it was so; now, with changing ones,",
    ],
)
def test_what_may_be_of_another_motion_is_left_open(said: str) -> None:
    assert verdict_of(said, OF_SQUARES.format("-")) != "proved"


def test_what_a_section_says_of_rates_leaves_open_what_holds_with_them() -> None:
    between = "$$ \\det J = l_1 l_2 s_2 $$\n\nThe height has the acceleration\n\n"
    assert verdict_of("The joint rates are constant in this section.", OF_SQUARES.format("-"), between) == "unchecked"
    assert verdict_of("The joint rates are constant in this section.", OF_SQUARES.format("+"), between) == "refuted"


def test_without_a_word_of_the_motion_all_terms_are_asked_for() -> None:
    assert verdict_of("The acceleration is", OF_SQUARES.format("-")) == "refuted"


def test_what_leads_to_a_display_goes_before_what_its_section_says() -> None:
    between = f"$$ {OF_SQUARES.format('-')} $$\n\nWhile all joints stand still,\n\n"
    assert verdict_of("At constant joint rates it is", OF_ACCELERATIONS.format("+"), between) == "proved"
    assert verdict_of("At constant joint rates it is", OF_ACCELERATIONS.format("-"), between) == "refuted"
