"""Definitions that are the one mistake of a document: with one slip mended there, and nowhere else, lines that differ in kind hold, and none fails that held.

One line against a definition leaves both open: which of the two has the slip, nothing tells. What is derived with a slip has it, too: lines of rates count
once, and so do those of squares; a line that a slip of its own mends, be it all through a side, is no witness; and what holds with the slip alone clears it.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

from armproof.verification.findings.kinds import MISPRINTS, OTHER_ANGLES
from armproof.verification.latex import nodes as n
from armproof.verification.naming.settled import Key, rests_through
from armproof.verification.verdict import HOLDS, EquationResult, Record, Role, SlipBefore, Verdict, WrongEntry

MOST_TRIALS = 8  # of slips that explain as much
MOST_MISTAKES = 3  # of a document
SEVERAL = 2
Place = tuple[int, int]  # of an equation: which display, and which of its equations
Mends = Mapping[Key, SlipBefore]
Read = Callable[[str], Iterable[n.Node]]


@dataclass(frozen=True)
class Judged:
    """What became of all displays, what is read in one, and with which slips before it one holds that none of its own mends."""

    records: Sequence[Record]
    slips: Mapping[int, Sequence[SlipBefore]]
    read: Read


def told(slips: Iterable[SlipBefore]) -> frozenset[tuple[str, int, str]]:
    """Return of what slips are and what is meant, by which two documents are judged alike."""
    return frozenset(map(_said, slips))


def _said(slip: SlipBefore) -> tuple[str, int, str]:
    return slip.name, slip.line, slip.correct


def mistakes(judged: Judged, judge: Callable[[Mends], Judged]) -> dict[Key, SlipBefore]:
    """Return the definitions that are mistakes, each with its slip; the document is judged again with each that may be one mended."""
    found: dict[Key, SlipBefore] = {}
    while len(found) < MOST_MISTAKES and (slip := _mistake(judged, found, judge)) is not None:
        found[slip.name, slip.line] = slip
        judged = judge(found)
    return found


def with_mistakes(records: Iterable[Record], found: Mends) -> tuple[Record, ...]:
    """Return the records of a document that was judged with its mistakes mended: they are refuted where they stand."""
    return tuple(_refuted(each, found) if found and not each.erratum else each for each in records)


def _mistake(judged: Judged, found: Mends, judge: Callable[[Mends], Judged]) -> SlipBefore | None:
    """Return the slip that explains all that any other does, and more, or contradicts nothing where that one does."""
    slips = _likely(judged.slips)
    if not any(_may_be_mistake(slip, judged.records) for slip in slips) or len(slips) > MOST_TRIALS:
        return None
    trials = [_Trial(each, judged, judge({**found, (each.name, each.line): each})) for each in slips]
    best = (one for one in trials if all(one is other or one.explains_more(other) for other in trials))
    return next((one.slip for one in best if one.shows_mistake), None)


def _likely(slips: Mapping[int, Sequence[SlipBefore]]) -> list[SlipBefore]:
    """Return the slips that mend the most displays."""
    each_of = {_said(each): each for found in slips.values() for each in found}
    counts = Counter(_said(each) for found in slips.values() for each in found)
    most = max(counts.values(), default=0)
    return [slip for said, slip in each_of.items() if counts[said] == most]


def _may_be_mistake(slip: SlipBefore, records: Iterable[Record]) -> bool:
    """Whether a slip is a misprint in a definition of a display; a term or an angle more or less may well mean something else."""
    key = {(slip.name, slip.line)}
    defining = [each for record in records if not record.erratum for each in record.outcomes if each.defines & key]
    is_one = len(defining) == 1 and defining[0].defines == key and defining[0].role is Role.DEFINITION
    return is_one and defining[0].verdict is Verdict.DEFINED and slip.change.kind in MISPRINTS - OTHER_ANGLES


@dataclass(frozen=True)
class _Trial:
    """A document as it is, and with one slip in it mended."""

    slip: SlipBefore
    before: Judged
    after: Judged

    @property
    def shows_mistake(self) -> bool:
        """Whether more lines hold for it than fail, of several kinds, one of which no slip of its own mends, and all still hold that did."""
        shown = [self.before.records[at] for at in sorted({at for at, _ in self.gained})]
        is_plain = any(each.line in self.before.slips for each in shown)
        ways = {self._way(each) for each in shown}
        may_be = _may_be_mistake(self.slip, self.before.records)
        return may_be and is_plain and len(ways) >= SEVERAL and not self.lost and len(self._failing) < len(shown)

    def explains_more(self, other: _Trial) -> bool:
        """Whether all holds that holds with another slip mended, and more, or without making something wrong that was right."""
        return other.gained < self.gained or (other.gained == self.gained and bool(other.lost) and not self.lost)

    @cached_property
    def gained(self) -> frozenset[Place]:
        """The equations that rest on the definition and hold only where it is mended."""
        return frozenset(self._holding(self.after.records)) - frozenset(self._holding(self.before.records, of_all=True))

    @cached_property
    def lost(self) -> frozenset[Place]:
        """The equations that hold only where it is not."""
        return frozenset(self._holding(self.before.records)) - frozenset(self._holding(self.after.records, of_all=True))

    def _holding(self, records: Sequence[Record], of_all: bool = False) -> Iterator[Place]:
        rest = {id(each) for each in self._resting_on(records)[1]}
        for at, record in enumerate(records):
            for each in () if record.erratum else record.outcomes:
                if each.verdict in HOLDS and (of_all or id(each) in rest):
                    yield at, each.index

    @property
    def _failing(self) -> set[int]:
        """The displays that rest on the definition and are wrong where it is mended."""
        records = self.after.records
        wrong = {id(each) for each in self._resting_on(records)[1] if each.verdict is Verdict.REFUTED}
        return {at for at, each in enumerate(records) if any(id(one) in wrong for one in each.outcomes)}

    def _way(self, record: Record) -> str:
        """Return in which way a display tells of the definition: what moves is derived from one line, what is squared from another."""
        told = [*self._told(record)]
        if any(_is_of_rates(each) for each in told):
            return "rates"
        resting = self._resting | {self.slip.name}
        return "squares" if any(_is_square_of(each, resting) for each in told) else record.latex

    @cached_property
    def _resting(self) -> set[str]:
        return {name for name, _ in self._resting_on(self.before.records)[0]} - {self.slip.name}

    def _resting_on(self, records: Sequence[Record]) -> tuple[set[Key], list[EquationResult]]:
        """Return the definitions and the equations that rest on the one with the slip."""
        return rests_through((self.slip.name, self.slip.line), [one for each in records for one in each.outcomes])

    def _told(self, record: Record) -> Iterator[n.Node]:
        """Yield what stands in a display, and in the definitions on which it and the other one rest both."""
        own = (self.slip.name, self.slip.line)
        keys = {key for each in record.outcomes for key in each.uses} - {own}
        yield from self.before.read(record.latex)
        for other in self.before.records:
            if any(each.defines & keys and own in each.uses for each in other.outcomes):
                yield from self.before.read(other.latex)


def _is_of_rates(node: n.Node) -> bool:
    return isinstance(node, n.Derivative) or (isinstance(node, n.Name) and (bool(node.dots) or node.base == "J"))


def _is_square_of(node: n.Node, names: set[str]) -> bool:
    return isinstance(node, n.Power) and any(each.key in names for each in n.names(node.base))


def _refuted(record: Record, found: Mends) -> Record:
    slips = {each.index: found[key] for each in record.outcomes for key in each.defines & found.keys()}
    if not slips:
        return record
    outcomes = tuple(_with_slip(each, slips[each.index]) if each.index in slips else each for each in record.outcomes)
    wrong = [each for each in outcomes if each.verdict is Verdict.REFUTED]
    entries = [WrongEntry(k, None, None, slip.printed, slip.correct, slip.change) for k, slip in slips.items()]
    return replace(
        record, verdict=Verdict.REFUTED, outcomes=outcomes, entries=(*record.entries, *entries),
        findings=tuple(finding for each in wrong for finding in each.findings), corrections=None,
    )  # fmt: skip


def _with_slip(result: EquationResult, slip: SlipBefore) -> EquationResult:
    return replace(result, verdict=Verdict.REFUTED, findings=(slip.change.at(result.index), *result.findings))
