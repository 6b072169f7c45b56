"""Numbers behind a sentence that lists values and nothing else: they are those there, and a wrong one is refuted."""

from __future__ import annotations

import pytest

from armproof.verification.check import verify_text
from armproof.verification.document.sentences import FROM_VALUES, said_below
from armproof.verification.verdict import Verdict

VALUES = r"$l_1 = 0.5$ m, $l_2 = 0.3$ m, $\theta_2 = 90^\circ$, $\dot\theta_1 = 2$ rad/s, $\dot\theta_2 = -1$ rad/s"


@pytest.mark.parametrize(
    ("text", "leads"),
    [
        (f"Numbers: {VALUES}. The speed of the hand is", True),
        (f"**(f) Numbers** (2 points). {VALUES}. Then", True),
        (f"Exemple. Avec {VALUES} :", True),
        (f"Numbers: {VALUES}. Elsewhere the speed is", False),
        ("The angles $a$, $b$ and $c$ are measured. Then", False),
        (f"Numbers: {VALUES}. In general the speed is", False),
    ],
)
def test_a_sentence_of_values_alone_leads_to_what_is_there(text: str, leads: bool) -> None:
    assert (FROM_VALUES in [each.latex for each in said_below(text, 1, "")]) is leads


@pytest.mark.parametrize(
    ("speed", "verdict"),
    [
        (r"\sqrt{1.0^2 + 0.3^2} = 1.044", Verdict.CONFIRMED),  # at any theta_1, which has no value
        (r"\sqrt{1.0^2 + 0.6^2} = 1.166", Verdict.REFUTED),
    ],
)
def test_a_speed_needs_no_value_of_the_first_joint(speed: str, verdict: Verdict) -> None:
    text = f"---\narm: planar_2r\nquantities: {{v: {{velocity: 2, rows: [1, 2]}}}}\n---\n\nNumbers: {VALUES}. The speed of the hand is\n\n$$ |v| = {speed} $$\n"
    assert verify_text(text).equations[-1].verdict is verdict


def test_a_coordinate_needs_the_value_of_the_first_joint() -> None:
    text = f"---\narm: planar_2r\nquantities: {{x: {{origin: 2, component: x}}}}\n---\n\nNumbers: {VALUES}. The abscissa of the hand is\n\n$$ x = 0.5 $$\n"
    assert verify_text(text).equations[-1].verdict is Verdict.UNCHECKED
