"""Which of the scripts before a letter is the reference, the text says: transforms compose so, and not the other way round."""

from __future__ import annotations

import pytest

from armproof import verify_text
from armproof.verification.verdict import Verdict

BEFORE = (r"{}^P_RT = {}^P_QT \, {}^Q_RT", r"{}^P_RT = {}^Q_RT \, {}^P_QT")
AROUND = (r"{}^PT_R = {}^PT_Q \, {}^QT_R", r"{}^PT_R = {}^QT_R \, {}^PT_Q")
UPPER = "The transform ${}^P_QT$ turns coordinates in $Q$ into coordinates in $P$."
LOWER = "The transform ${}^P_QT$ turns coordinates in $P$ into coordinates in $Q$."


def verdict(sentence: str, latex: str) -> Verdict:
    return verify_text(f"{sentence}\n\n$$ {latex} $$\n").equations[-1].verdict


def test_the_law_of_transforms_is_that_of_the_told_scripts() -> None:
    usual, turned = BEFORE
    assert (verdict(UPPER, usual), verdict(LOWER, turned)) == (Verdict.PROVED, Verdict.PROVED)
    assert (verdict(UPPER, turned), verdict(LOWER, usual)) == (Verdict.UNCHECKED, Verdict.UNCHECKED)


@pytest.mark.parametrize("latex", AROUND)
def test_what_is_told_of_scripts_around_a_letter_is_left_open(latex: str) -> None:
    lower = "The left upper index names the frame that is described."
    assert verdict(lower, latex) is Verdict.UNCHECKED
    assert verdict("The transforms compose:", AROUND[0]) is Verdict.PROVED
