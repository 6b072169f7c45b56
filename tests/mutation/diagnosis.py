"""Whether the report of a slip points at the cell that was changed, and offers what mends it."""

from __future__ import annotations

import random
from collections.abc import Collection, Iterator
from dataclasses import dataclass
from pathlib import Path

from armproof.verification.algebra.matrix import Matrix
from armproof.verification.algebra.ring import Scalar
from armproof.verification.latex import nodes as n
from armproof.verification.verdict import Verdict
from tests.mutation.mutants import Mutant, mutants_of
from tests.mutation.place import Place, proved_places

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


def diagnoses(
    path: Path, seed: int = 0, each: int = EACH, indices: Collection[int] | None = None
) -> Iterator[Diagnosis]:
    """Yield the diagnoses of some slips of each of a document's proved displays, or of those with the numbers given."""
    for place in proved_places(path, indices):
        values = _values(place)
        mutants = [mutant for mutant in mutants_of(place, seed) if _is_clear(mutant, values[mutant.site.statement])]
        chance = random.Random(f"{seed} {place.where}")
        for mutant in chance.sample(mutants, min(each, len(mutants))):
            found = diagnose(place, mutant)
            if found is not None:
                yield found


def _values(place: Place) -> list[list[object]]:
    """Return the value of each side of each chain of a display."""
    statements = place.read(place.display.latex)
    with place.altered():
        place.outcomes(statements)
        return [[place.member(m).value for m in s.members] if isinstance(s, n.Chain) else [] for s in statements]


def _is_clear(mutant: Mutant, values: list[object]) -> bool:
    """Whether one printed scalar is wrong, a cell of a matrix written out or a formula, by a slip of those kinds."""
    site = mutant.site
    if mutant.kind not in KINDS or mutant.node is None or not site.whole or not site.printed:
        return False
    if site.matrix is None:
        return all(isinstance(value, Scalar) for value in values)
    value = values[site.member]
    return isinstance(value, Matrix) and value.shape == (len(site.matrix.rows), len(site.matrix.rows[0]))


def diagnose(place: Place, mutant: Mutant) -> Diagnosis | None:
    """Return what the report says of a mutant; None where it is no mistake."""
    record = place.check(mutant.latex, diagnose=True)
    if record.verdict is not Verdict.REFUTED:
        return None
    entries = record.entries
    place_of_slip = (mutant.site.row, mutant.site.column)
    places = {(entry.row, entry.column) for entry in entries}
    located = place_of_slip in places and places <= {
        place_of_slip,
        (None, None),
    }  # the label of a brace is a claim of its own
    start, end = mutant.site.node.span
    latex = place.display.latex
    correct = next((entry.correct for entry in entries if (entry.row, entry.column) == place_of_slip), "")
    mended = located and place.check(f"{latex[:start]}{correct}{latex[end:]}").verdict is Verdict.PROVED
    named = any(entry.change for entry in entries)
    return Diagnosis(place.where, mutant.kind, located, mended, named, mutant.words, mutant.text, record.message)
