"""The quantity that a sentence says the display beside it to be."""

from __future__ import annotations

import pytest

from armproof.verification.document.hearing import words_of
from armproof.verification.document.named_quantities import named_quantity

NAMED = [
    ("The velocity of the tip along $x$ is", "velocity"),
    ("For the vertical coordinate of the end effector we obtain", "ordinate"),
    ("L'ordonnée de l'effecteur vaut", "ordinate"),
    ("Die Geschwindigkeit des Greifers lautet", "velocity"),
    ("It is the abscissa of the tip.", "abscissa"),
    ("The expression gives the distance of the tip from the base.", "distance"),
    ("The orientation of the gripper is", "orientation"),
    ("La velocità della pinza è", "velocity"),
    # what names none, or more than one, or speaks of it without saying that the display is it
    ("The position of the tip is", ""),
    ("The position and the velocity of the tip are", ""),
    ("The abscissa and the ordinate are", ""),
    ("To find the velocity of the tip we need", ""),
    ("The velocity of the tip is the derivative of", ""),
    ("Before we turn to velocities, we write", ""),
    ("The velocity follows later, first we need", ""),
    ("The distance of the tip along the $x$ axis is", ""),
]


@pytest.mark.parametrize(("sentence", "named"), NAMED)
def test_a_sentence_names_one_quantity_or_none(sentence: str, named: str) -> None:
    assert named_quantity(words_of(sentence).lower().split()) == named
