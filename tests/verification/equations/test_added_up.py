"""A sum of rounded numbers is what they add up to, though not the rounded sum."""

from __future__ import annotations

import pytest

from armproof import verify_text
from armproof.verification.verdict import Verdict


@pytest.mark.parametrize(
    ("numbers", "verdict"),
    [
        ("0.2294 + 0.2954 = 0.5248", Verdict.CONFIRMED),
        ("0.2294 + 0.2954 = 0.5249", Verdict.CONFIRMED),
        ("0.2294 + 0.2954 = 0.5246", Verdict.REFUTED),
        ("0.2293 + 0.2955 = 0.5248", Verdict.REFUTED),
        ("0.5248", Verdict.REFUTED),
    ],
)
def test_each_number_is_compared_with_those_printed_before_it(numbers: str, verdict: Verdict) -> None:
    latex = rf"$$ 0.4 \sin 35^\circ + 0.3 \sin 80^\circ = {numbers} $$"
    verdicts = {each.verdict for each in verify_text(latex).equations}
    assert verdict in verdicts and (verdict is Verdict.REFUTED or Verdict.REFUTED not in verdicts)
