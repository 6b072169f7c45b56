"""Some of the sentences round displays in every run; `make sweep` draws three thousand."""

from __future__ import annotations

import pytest

from tests.laws import SWEEP
from tests.sweeps.sentences import Trial, judged, trials

SEED, COUNT = 5, 700 if SWEEP else 60


def test_no_sentence_makes_a_verdict_false() -> None:
    found = [judged(each) for each in trials(SEED, COUNT)]
    assert not (false := [each for each in found if each.fault]), "\n".join(
        f"{each.fault}: {each.words} | {each.latex}" for each in false
    )
    assert {each.effect for each in found} == {
        "denied",
        "asked",
        "world",
        "where",
        "only",
        "nearly",
        "nothing",
        "strange",
    }
    assert sum(each.verdict == "proved" for each in found) > COUNT / 10


@pytest.mark.parametrize(
    ("effect", "is_right", "is_true", "verdict", "alone", "fault"),
    [
        ("denied", True, True, "proved", "", "passes"),
        ("denied", False, False, "refuted", "", "refuted"),
        ("asked", False, False, "refuted", "", "refuted"),
        ("world", True, False, "proved", "", "passes"),
        ("where", False, True, "refuted", "", "refuted"),
        ("nothing", True, True, "unchecked", "proved", "lost"),
        ("nothing", True, True, "proved", "proved", ""),
        ("strange", True, True, "unchecked", "proved", ""),
        ("strange", False, False, "proved", "", "passes"),
    ],
)
def test_a_false_verdict_is_noticed(
    effect: str, is_right: bool, is_true: bool, verdict: str, alone: str, fault: str
) -> None:
    assert Trial(effect, "", "lead", "md", "front", "x", is_right, is_true, verdict, alone).fault == fault
