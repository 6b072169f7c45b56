"""What a document without an arm defines under one stage of its derivation holds under the next, and under no other heading."""

from __future__ import annotations

import pytest

from armproof.verification.check import verify_text

CRANE = r"""# {title}

## {first}

$$ r = a \cos\alpha + b \cos\beta $$

$$ h = a \sin\alpha + b \sin\beta $$

## {then}

$$ \dot r = -a \dot\alpha \sin\alpha - b \dot\beta \sin\beta $$

$$ r^2 + h^2 = a^2 + b^2 {sign} 2 a b \cos(\alpha - \beta) $$
"""


def verdicts(first: str, then: str, sign: str = "+") -> list[str]:
    text = CRANE.format(title="A crane", first=first, then=then, sign=sign)
    return [record.verdict.value for record in verify_text(text).equations]


@pytest.mark.parametrize(
    ("first", "then"),
    [
        ("Direct kinematics", "2. Velocities and singularities"),
        ("1. Modèle géométrique direct", "2. Modèle cinématique inverse"),
        ("Vorwärtskinematik", "Geschwindigkeit der Hand"),
    ],
)
def test_a_stage_uses_what_the_one_before_it_defines(first: str, then: str) -> None:
    assert verdicts(first, then) == ["defined", "defined", "proved", "proved"]
    assert verdicts(first, then, "-")[-1] == "refuted"


@pytest.mark.parametrize(
    ("first", "then"),
    [("Direct kinematics", "The second crane: velocities"), ("The mast", "Velocities"), ("Exercise 1", "Exercise 2")],
)
def test_another_heading_may_mean_other_things(first: str, then: str) -> None:
    assert verdicts(first, then, "-")[-1] == "unchecked"
