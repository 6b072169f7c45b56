"""Which operation a sentence says to be done to what the next display prints."""

from __future__ import annotations

import pytest

from armproof.verification.document.hearing import words_of
from armproof.verification.document.told_operations import told_operation
from armproof.verification.verdict import Verdict

ARM = """---
arm: planar_2r
---

"""


@pytest.mark.parametrize(
    ("sentence", "kind"),
    [
        ("The manipulability is", "never negative"),
        ("The absolute value of the determinant is", "never negative"),
        ("Half of the trace is", "scaled"),
        ("Das Doppelte davon ist", "scaled"),
        ("Le carré de la distance vaut", "square"),
        ("The distance of the tip from the base is", "length"),
        ("La somme des deux coordonnées vaut", "composed"),
        ("The square root of the sum is", ""),
        ("The sum of the angles is", ""),
        ("We take the double of it later, and now", ""),
        ("The determinant is", ""),
    ],
)
def test_the_operation_of_a_sentence_is_heard(sentence: str, kind: str) -> None:
    assert told_operation(words_of(sentence)) == kind


@pytest.mark.parametrize(
    ("text", "verdict"),
    [
        (r"The manipulability is $$ w = \det J = l_1 l_2 \sin\theta_2 $$", Verdict.UNCHECKED),
        (r"The determinant is $$ w = \det J = l_1 l_2 \sin\theta_2 $$", Verdict.PROVED),
        (r"Its square is $$ t = \sqrt{x^2+y^2} = \sqrt{l_1^2+l_2^2+2 l_1 l_2 c_2} $$", Verdict.UNCHECKED),
        (r"Its square is $$ t = x^2+y^2 = l_1^2+l_2^2+2 l_1 l_2 c_2 $$", Verdict.PROVED),
    ],
)
def test_what_lacks_the_operation_shows_nothing_of_its_result(text: str, verdict: Verdict) -> None:
    from armproof.verification.check import verify_text

    (record,) = verify_text(ARM + text.replace("$$", "\n$$", 1)).equations
    assert record.verdict is verdict
