"""A sample of the mutation sweep and of the rewrites in every run; `make mutation` runs them all."""

from __future__ import annotations

import random
from collections.abc import Iterator
from pathlib import Path

import pytest

from armproof.verification.verdict import Verdict
from tests.mutation import sweep
from tests.mutation.diagnosis import diagnoses
from tests.mutation.mutants import Mutant, mutants_of
from tests.mutation.numeric import Opinion, compare
from tests.mutation.place import HANDOUTS, Place, handouts, load, proved_indices, proved_places
from tests.mutation.rewrites import Rewrite, chosen_rewrites, try_rewrites
from tests.mutation.sites import find_sites

PLACES, MUTANTS, REWRITES = 2, 3, 2  # of a document, of a place

every_handout = pytest.mark.parametrize("path", handouts(), ids=lambda path: path.stem)


def sample(path: Path) -> Iterator[Place]:
    """Yield some proved displays of a document."""
    indices = proved_indices(path)
    return proved_places(path, random.Random(path.name).sample(indices, min(PLACES, len(indices))))


def first_place(name: str, line: str) -> Place:
    """Return the first proved display of a handout that holds a piece of LaTeX."""
    path = HANDOUTS / name
    index = next(index for index in proved_indices(path) if line in load(path).displays[index].latex)
    return next(proved_places(path, [index]))


@every_handout
def test_slips_are_refuted(path: Path) -> None:
    tried = 0
    for place in sample(path):
        found = list(mutants_of(place, seed=9))
        chosen = random.Random(place.where).sample(found, min(MUTANTS, len(found)))
        for trial in sweep.try_mutants(place, chosen):
            tried += 1
            is_of_a_branch = trial.verdict == "confirmed" and "is meant" in trial.message  # and says on which share
            assert is_of_a_branch or trial.fate in (sweep.REFUTED, sweep.IDENTICAL), trial
    assert tried


@every_handout
def test_equivalent_rewrites_are_proved(path: Path) -> None:
    tried = 0
    for place in sample(path):
        for answer in try_rewrites(place, chosen_rewrites(place, seed=1, each=REWRITES)):
            tried += 1
            assert answer.proved, answer
    assert tried


def test_an_unchanged_display_is_no_mutant() -> None:
    place = first_place("planar-2r-002.md", r"\det")
    site = find_sites(place, place.read(place.display.latex))[0]
    [trial] = sweep.try_mutants(place, [Mutant(place.display.latex, "none", "nothing", site, None, "")])
    assert trial.fate == sweep.IDENTICAL


def test_a_condition_of_a_rank_has_no_slips_of_signs_and_factors() -> None:
    place = first_place("rx90-001.md", "C_3 = 0 \\Rightarrow")
    assert {mutant.kind for mutant in mutants_of(place, seed=1)} == {"function", "index"}
    place = first_place("rx90-001.md", r"\operatorname{rank}\left(\left. J \right|_{\theta_3")
    assert "sign" in {mutant.kind for mutant in mutants_of(place, seed=1)}


def test_an_unreadable_mutant_is_left_open() -> None:
    place = first_place("planar-2r-002.md", r"\det")
    site = find_sites(place, place.read(place.display.latex))[0]
    [trial] = sweep.try_mutants(place, [Mutant(place.display.latex + r" \frac{", "none", "torn", site, None, "")])
    assert trial.fate == sweep.OPEN


def test_a_wrong_rewrite_is_not_proved() -> None:
    place = first_place("rx90-001.md", "P_z = C_{23}d_3")
    [answer] = try_rewrites(place, [Rewrite("wrong", place.display.latex.replace("C_{23}", "C_{3}"))])
    assert not answer.proved


def test_equality_at_random_lengths_is_not_fooled_by_a_length_of_one() -> None:
    place = first_place("rx90-001.md", "P_z = C_{23}d_3")
    read = place.checker.names.reader.read_expression
    assert compare(place, read("C_{23}d_3"), read("d_3 (C_2C_3 - S_2S_3)")) is Opinion.EQUAL
    assert compare(place, read("C_{23}d_3"), read("C_{23}")) is Opinion.DIFFERENT
    assert compare(place, read(r"\arccos C_2"), read(r"2\pi + \arccos C_2")) is Opinion.TURN_APART


def test_checking_elsewhere_leaves_no_trace() -> None:
    place = first_place("scara-004.md", r"\arccos")
    before = dict(place.checker.names.state.definitions)
    place.check(r"N_e = \sqrt{X + \frac{\theta_1^*}{2} - \arctan(Y)}")
    assert place.checker.names.state.definitions == before
    assert place.check(place.display.latex).verdict is Verdict.PROVED


@pytest.mark.parametrize("name", ["rx90-001.md", "scara-000.md"])
def test_a_slip_is_located_and_mended(name: str) -> None:
    """`correct`, put back in the place of the reported cell, verifies."""
    indices = proved_indices(HANDOUTS / name)[::6]
    found = [
        diagnosis
        for diagnosis in diagnoses(HANDOUTS / name, seed=1, each=1, indices=indices)
        if "constant" not in diagnosis.words
    ]
    assert found
    assert [diagnosis for diagnosis in found if not (diagnosis.located and diagnosis.mended)] == []
