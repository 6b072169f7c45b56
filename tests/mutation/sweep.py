"""The mutation sweep of a document: no slip in a proved equation may be proved, and most are refuted."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from armproof.models.errors import ArmproofError
from armproof.verification.errors import ReadError
from armproof.verification.latex import nodes as n
from armproof.verification.verdict import Verdict
from tests.mutation.mutants import Mutant, mutants_of
from tests.mutation.numeric import Opinion, compare, compare_conditions
from tests.mutation.place import Place, proved_places
from tests.mutation.sites import are_conditions

REFUTED, IDENTICAL, OPEN, UNTOLD = "refuted", "identical", "left open", "holds, not compared"
SURVIVED, FALSE_ALARM = "survived", "refuted though equal"
CRASHED = "crashed"


@dataclass(frozen=True)
class Trial:
    """What became of one mutant.

    fate: refuted; identical (proved, and equal at random configurations of random arms too); left open, as words or another
    meaning ask for; proved where numbers could not be compared; survived, proved though it differs there, or a crash; or
    refuted though it is equal there.
    """

    where: str
    kind: str
    fate: str
    words: str
    text: str
    verdict: str
    message: str


def sweep(path: Path, seed: int = 0) -> Iterator[Trial]:
    """Yield the trials of all mutants of a document's proved equations."""
    for place in proved_places(path):
        yield from try_mutants(place, list(mutants_of(place, seed)))


def try_mutants(place: Place, mutants: list[Mutant]) -> Iterator[Trial]:
    """Yield what becomes of each mutant in its place."""
    for mutant, opinion in zip(mutants, _second_opinions(place, mutants), strict=True):
        try:
            record = place.check(mutant.latex)
            verdict, message = record.verdict.value, record.message
        except Exception as error:  # a crash is reported as a survivor, with its place
            verdict, message = CRASHED, repr(error)
        yield Trial(place.where, mutant.kind, _fate(verdict, opinion), mutant.words, mutant.text, verdict, message)


def _fate(verdict: str, opinion: Opinion) -> str:
    if verdict == Verdict.REFUTED.value:
        return FALSE_ALARM if opinion is Opinion.EQUAL else REFUTED
    if verdict in (Verdict.PROVED.value, Verdict.CONFIRMED.value):
        return {Opinion.DIFFERENT: SURVIVED, Opinion.UNKNOWN: UNTOLD}.get(opinion, IDENTICAL)
    return SURVIVED if verdict == CRASHED else OPEN


def _second_opinions(place: Place, mutants: list[Mutant]) -> list[Opinion]:
    """Return how each mutant compares with the original numerically."""
    statements = place.read(place.display.latex)
    implication = are_conditions(statements)
    with place.altered():
        place.outcomes(statements)  # so that names which the display itself defines are known
        return [_second_opinion(place, mutant, implication, statements) for mutant in mutants]


def _second_opinion(place: Place, mutant: Mutant, implication: bool, statements: list[n.Statement]) -> Opinion:
    site = mutant.site
    try:
        changed, original = place.read(mutant.latex)[site.statement], statements[site.statement]
    except (ReadError, IndexError):
        return Opinion.UNKNOWN
    if (
        not isinstance(changed, n.Chain)
        or not isinstance(original, n.Chain)
        or len(changed.members) != len(original.members)
    ):
        return Opinion.UNKNOWN
    if implication:
        return compare_conditions(place, original.members, changed.members)
    opinion = compare(place, original.members[site.member], changed.members[site.member])
    if opinion is Opinion.UNKNOWN and mutant.node is not None:
        try:
            return compare(place, site.node, place.checker.names.reader.read_expression(mutant.text))
        except ArmproofError:
            return Opinion.UNKNOWN
    return opinion
