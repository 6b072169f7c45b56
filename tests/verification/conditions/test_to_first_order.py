"""Where a text writes to first order, what differs by the second is not wrong."""

from __future__ import annotations

import pytest

from armproof import verify_text
from armproof.verification.document.first_order import is_to_first_order
from armproof.verification.document.hearing import words_of
from armproof.verification.verdict import Verdict

PAGE = "# Wrist\n\n%s\n\n$$ R_x(\\alpha) = \\begin{bmatrix} 1 & 0 & 0 \\\\ 0 & c_\\alpha & -s_\\alpha \\\\ 0 & s_\\alpha & c_\\alpha \\end{bmatrix} $$\n\nNow\n\n$$ R_y(\\beta) = \\begin{bmatrix} 1 & 0 & %s \\\\ 0 & 1 & 0 \\\\ -\\beta & 0 & 1 \\end{bmatrix} $$\n"
SAID = [
    "We write all to first order in the three angles.",
    "On développe au premier ordre.",
    "The errors are small angles.",
]


@pytest.mark.parametrize("said", SAID)
@pytest.mark.parametrize(("entry", "verdict"), [("\\beta", Verdict.UNCHECKED), ("-\\beta", Verdict.REFUTED)])
def test_what_differs_by_the_second_order_is_left_open(said: str, entry: str, verdict: Verdict) -> None:
    assert verify_text(PAGE % (said, entry)).equations[-1].verdict is verdict


@pytest.mark.parametrize("said", ["The angles are any.", "These angles are not small.", "In order to see this"])
def test_without_such_words_it_is_refuted(said: str) -> None:
    assert verify_text(PAGE % (said, "\\beta")).equations[-1].verdict is Verdict.REFUTED


@pytest.mark.parametrize(
    ("text", "heard"),
    [
        ("To first order,", True),
        ("In erster Ordnung gilt", True),
        ("Neglecting terms of higher order", True),
        ("The first order of business", True),
        ("without a first-order approximation", False),
        ("in the order of the joints", False),
    ],
)
def test_words_of_first_order_are_heard(text: str, heard: bool) -> None:
    assert is_to_first_order(words_of(text)) is heard
