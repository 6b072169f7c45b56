"""Lengths that are said to be equal, and a part of a letter, are a condition and no slip."""

from __future__ import annotations

import pytest

from armproof import verify_text
from armproof.verification.verdict import Verdict

PAGE = "$$ x = l_1 c_1 + l_2 c_{12}, \\quad y = l_1 s_1 + l_2 s_{12} $$\n\n$$ w = l_1 l_2 |\\sin\\theta_2| $$\n\nFor $l_1 + l_2 = L$ it is largest with\n\n$$ %s $$\n"


@pytest.mark.parametrize("latex", [r"l_1 = l_2 = \frac{L}{2}", r"l_1 = l_2 = \tfrac12 L", "l_1 = l_2 = l"])
def test_equal_lengths_are_a_condition(latex: str) -> None:
    assert verify_text(PAGE % latex).equations[-1].verdict is not Verdict.REFUTED


@pytest.mark.parametrize("latex", [r"w = l_1 \cdot 2 l_2 |\sin\theta_2|", "x = l_1 c_1 + l_1 c_{12}"])
def test_what_is_no_equality_of_lengths_is_still_refuted(latex: str) -> None:
    assert verify_text(PAGE % latex).equations[-1].verdict is Verdict.REFUTED
