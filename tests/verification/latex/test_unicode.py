"""Formulas typed in Unicode signs are read as their LaTeX; a word's accents are its own."""

from __future__ import annotations

import pytest

from armproof.verification.latex.unicode import normalise_unicode, original_offset


@pytest.mark.parametrize(
    ("typed", "read"),
    [
        ("ẏ = J q\u0307", r"\dot{y} = J \dot{q}"),
        ("\u03b8\u0307_2 + ẍ", r"\dot{\theta }_2 + \ddot{x}"),
        ("q\u0308 = \u03b8\u03081", r"\ddot{q} = \ddot{\theta }1"),
        ("v\u20d7 x\u0302_1", r"\vec{v} \hat{x}_1"),
        ("fu\u0308r e\u0302tre", "fu\u0308r e\u0302tre"),
        ("für être", "für être"),
    ],
)
def test_points_and_hats_above_a_letter_are_its_commands_but_in_words(typed: str, read: str) -> None:
    assert normalise_unicode(typed) == read


def test_a_place_behind_a_marked_letter_is_found_again() -> None:
    typed = "ẏ = q\u0307 + s"
    assert typed[original_offset(typed, normalise_unicode(typed).index("s"))] == "s"
