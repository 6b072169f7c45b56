"""Arms of which a sentence is, and whether they are others than the document's."""

from __future__ import annotations

import pytest

from armproof.models.catalogue import load_arm
from armproof.verification.document.hearing import words_of
from armproof.verification.document.other_arms import arms_named, is_other_arm

NAMED = [
    ("For the SCARA robot in the next room we find", ["scara"]),
    ("Below is the formula of the three-link arm.", ["three"]),
    ("For the arm with three links we get", ["three"]),
    ("Pour le robot cartésien de la salle B, on a", ["cartésien"]),
    ("Für den SCARA-Roboter gilt", ["scara"]),
    ("For the planar 2R arm we get", []),  # its size is told otherwise
    ("Unlike the Cartesian robot, our arm bends, and so", []),
    ("As for the three-link arm, we have", []),
    ("The three-link arm comes next.", []),
]


@pytest.mark.parametrize(("sentence", "named"), NAMED)
def test_a_sentence_is_of_an_arm_or_compares_with_one(sentence: str, named: list[str]) -> None:
    assert arms_named(words_of(sentence)) == named


@pytest.mark.parametrize(
    ("named", "arm", "is_other"),
    [
        ("two", "planar_2r", False),
        ("three", "planar_2r", True),
        ("scara", "planar_2r", True),
        ("scara", "scara", False),
        ("cartesian", "scara", True),
        ("3", "planar_3r", False),
    ],
)
def test_the_joints_tell_whether_it_is_another_arm(named: str, arm: str, is_other: bool) -> None:
    assert is_other_arm(named, load_arm(arm)) == is_other
