"""In which order tests meet a mutant: those that are likely to kill it, and are quick, before all others."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Set
from random import Random

from tests.mutation.source.mutants import Mutant
from tests.mutation.source.reach import DERIVED, LABELLED, reaching, seconds
from tests.mutation.source.trusted import selection

QUICK = 1  # seconds
MOST_DERIVED = (
    400  # documents made of others that reach a line which most of them do: it is seen by some of these, or by none
)
DRAWN = 50  # labelled displays that are judged although they do not reach a line: what was cached when they were recorded hides it


def tests_of(file: str, mutant: Mutant, collected: Iterable[str]) -> list[str]:
    """Return the tests that a mutant meets, in their order: what reaches it, what is about its file, and what is not on record."""
    own, took, there = set(selection(file)[0]), seconds(), list(collected)
    tests = Random(1).sample(there, len(there))  # another kind of display each time: what is wrong shows early
    met = reaching(file, mutant.line)
    if met is not None:
        of_others = [test for test in tests if test in met and test.startswith(f"{LABELLED}::{DERIVED}")]
        met = met - {*of_others[MOST_DERIVED:]}
        drawn = {test for test in tests if test.startswith(LABELLED)}
        about = {test for test in tests if _file(test) in own or test not in took}
        met = met | about | set(sorted(drawn)[:: max(1, len(drawn) // DRAWN)])
    return in_order([test for test in tests if met is None or test in met], own, took, there)


def in_order(tests: list[str], own: Set[str], took: dict[str, float], collected: list[str]) -> list[str]:
    """Return quick tests of one's own first, then labelled displays, then the files of all others, the quickest first."""
    first = [test for test in tests if _file(test) in own and took.get(test, 0) < QUICK]
    labelled = [test for test in tests if test.startswith(LABELLED)]
    rest, place = set(tests) - {*first, *labelled}, {test: k for k, test in enumerate(collected)}
    length: defaultdict[str, float] = defaultdict(float)
    for test in rest:
        length[_file(test)] += took.get(test, 0)
    others = sorted(rest, key=lambda test: (length[_file(test)], _file(test), place[test]))
    return [*sorted(first, key=place.__getitem__), *labelled, *others]


def _file(test: str) -> str:
    return test.partition("::")[0]
