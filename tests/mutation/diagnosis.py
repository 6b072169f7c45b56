"""Whether the report of a slip points at the cell that was changed, and offers what mends it."""

from __future__ import annotations

import random
from collections.abc import Collection, Iterator
from dataclasses import dataclass
from pathlib import Path

from tests.mutation.mutants import Mutant, mutants_of
from tests.mutation.place import Place, proved_places
from verification.matrix import Matrix
from verification.trig import Scalar
from verification.verdict import Verdict

KINDS = ("sign", "index", "function", "length")
EACH = 3  # of a display


@dataclass(frozen=True)
class Diagnosis:
    """What the report said of one slip: whether at its cell and nowhere else, and whether `correct` mends it."""

    where: str
    kind: str
    located: bool
    mended: bool
    named: bool
    words: str
    text: str
    message: str


def diagnoses(path: Path, seed: int = 0, each: int = EACH, indices: Collection[int] | None = None) -> Iterator[Diagnosis]:
    """Yield the diagnoses of some slips of each of a document's proved displays, or of those with the numbers given."""
    for place in proved_places(path, indices):
        mutants = [mutant for mutant in mutants_of(place, seed) if _is_clear(place, mutant)]
        chance = random.Random(f"{seed} {place.where}")
        for mutant in chance.sample(mutants, min(each, len(mutants))):
            found = diagnose(place, mutant)
            if found is not None:
                yield found


def _is_clear(place: Place, mutant: Mutant) -> bool:
    """Whether one printed scalar is wrong, a cell of a matrix written out or a formula, by a slip of those kinds."""
    site = mutant.site
    if mutant.kind not in KINDS or mutant.node is None or not site.whole or not site.printed:
        return False
    with place.altered():
        value = place.checker.checker.member(site.side).value
    if site.matrix is None:
        return isinstance(value, Scalar)
    return isinstance(value, Matrix) and value.shape == (len(site.matrix.rows), len(site.matrix.rows[0]))


def diagnose(place: Place, mutant: Mutant) -> Diagnosis | None:
    """Return what the report says of a mutant; None where it is no mistake."""
    record = place.check(mutant.latex, diagnose=True)
    if record.verdict is not Verdict.REFUTED:
        return None
    entries = record.entries
    located = {(entry.row, entry.column) for entry in entries} == {(mutant.site.row, mutant.site.column)}
    start, end = mutant.site.node.span
    latex = place.display.latex
    mended = located and place.check(f"{latex[:start]}{entries[0].correct}{latex[end:]}").verdict is Verdict.PROVED
    named = bool(entries) and bool(entries[0].change)
    return Diagnosis(place.where, mutant.kind, located, mended, named, mutant.words, mutant.text, record.message)
