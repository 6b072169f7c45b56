"""What a text calls the arms that it speaks of."""

from __future__ import annotations

import pytest

from armproof.verification.document.arms_called import arms_called

CALLED = [
    ("Back to robot A:", ["A"]),
    ("For robot $B$ we have", ["B"]),
    ("Pour le premier robot, on avait", ["1"]),
    ("L'altitude de l'outil du robot 1 est", ["1"]),
    ("The second arm is longer.", ["2"]),
    ("For the planar arm we have", ["planar"]),
    ("As for the planar arm we get", []),
    ("The robot arm moves.", []),
    ("Le robot a trois liaisons.", []),
]


@pytest.mark.parametrize(("text", "names"), CALLED)
def test_what_a_sentence_calls_an_arm_is_heard(text: str, names: list[str]) -> None:
    assert [name for each in arms_called(text) for name in sorted(each)] == names
