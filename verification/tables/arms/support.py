"""What an inferred arm was taken from is data: it is defined where a decided claim rests on it, and refutes only what else confirms it."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace

from armproof.verification.algebra.quantity import Quantity
from armproof.verification.document import Document
from armproof.verification.equations.outcome import Outcome
from armproof.verification.equations.sides import Member, Members
from armproof.verification.findings import Finding, Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.naming.quantities import numbered_frames
from armproof.verification.verdict import EquationResult, Record, Role, TakenArm, Verdict, worst

_HOLDS = (Verdict.PROVED, Verdict.CONFIRMED)


@dataclass(frozen=True)
class Inference:
    """A document whose front matter names the arm that it shows, and what that was taken from; or why there is none."""

    document: Document
    arm: TakenArm | None = None
    problem: Finding | None = None
    line: int | None = None  # of what gives no arm, or not one


def links_of(outcome: Outcome, members: Members) -> frozenset[int]:
    """Return the links of the arm that an equation tells of: those that its quantities span, beside a formula without any."""
    if outcome.true is None or outcome.printed is None or _quantities(outcome.printed, members):
        return frozenset()
    return frozenset(link for quantity in _quantities(outcome.true, members) for link in _span(quantity, members))


def _quantities(side: Member, members: Members) -> list[Quantity]:
    return [quantity for node in n.walk(side.node) if (quantity := members.quantity_of(node)) is not None]


def _span(quantity: Quantity, members: Members) -> Iterable[int]:
    arm = members.names.arm
    if arm is None or quantity.kind in ("joint", "link", "vector"):
        return ()
    frames = numbered_frames(arm)
    ends = [frames.index(f) if f in frames else len(frames) - 1 for f in (quantity.frame, quantity.reference)]
    return range(min(ends) + 1, max(ends) + 1)


def settle_data(
    inferred: Inference, equations: Iterable[Record], tables: Iterable[Record]
) -> tuple[tuple[Record, ...], tuple[Record, ...]]:
    """Return the records of displays and tables, what the arm was taken from as data among them."""
    equations, tables, taken = tuple(equations), tuple(tables), inferred.arm
    if taken is None:
        return _told(inferred, equations), _told(inferred, tables)
    results = [each for record in equations if not _is_data(taken, record) for each in record.outcomes]
    confirmed = frozenset(link for each in results if each.verdict in _HOLDS for link in each.links)
    named = {key: each.links for each in results for key in each.defines}
    settled = _Settled(taken, confirmed, any(each.is_decided and each.links for each in results), named)
    return tuple(map(settled.display, equations)), tuple(map(settled.table, tables))


def _told(inferred: Inference, records: tuple[Record, ...]) -> tuple[Record, ...]:
    """Say of a table why no arm was taken from it."""
    if (problem := inferred.problem) is None:
        return records
    tells = [record.line == inferred.line and record.says(Kind.NO_ARM_FOR_TABLE) for record in records]
    return tuple(replace(r, findings=(problem,)) if told else r for r, told in zip(records, tells, strict=True))


def _is_data(taken: TakenArm, record: Record) -> bool:
    return (record.cell, record.line) in taken.lines


class _Settled:
    """The records of a document whose arm was taken from a part of it."""

    def __init__(
        self, taken: TakenArm, confirmed: frozenset[int], is_used: bool, named: dict[tuple[str, int], frozenset[int]]
    ) -> None:
        self.taken, self.confirmed, self.is_used, self.named = taken, confirmed, is_used, named
        self.source: dict[str, object] = {"source": taken.source, "line": taken.line}

    def table(self, record: Record) -> Record:
        """Return the record of a table: data, or another table, which is not refuted by this one."""
        if _is_data(self.taken, record):
            return self._data(record)
        if record.verdict is Verdict.REFUTED and not record.erratum:
            return _unchecked(record, say(Kind.SECOND_TABLE, line=self.taken.line))
        return record

    def display(self, record: Record) -> Record:
        """Return the record of a display."""
        if not record.outcomes:  # a table that is set as an array, or what was not read
            return self.table(record) if record.verdict in (*_HOLDS, Verdict.REFUTED) else record
        if _is_data(self.taken, record):
            links = frozenset(link for each in record.outcomes for link in each.links)
            is_whole = bool(links) and links <= self.confirmed
            return record if is_whole or record.verdict not in _HOLDS else self._data(record)
        outcomes = tuple(self._outcome(each, record.erratum) for each in record.outcomes)
        said = [say(Kind.FOR_ARM_OF, **self.source)] if any(each.is_decided and each.links for each in outcomes) else []
        verdict = worst([each.verdict for each in outcomes])
        if verdict is record.verdict:
            return replace(record, findings=(*record.findings, *said))
        findings = [finding for each in outcomes if each.verdict is verdict for finding in each.findings]
        return replace(record, outcomes=outcomes, verdict=verdict, findings=(*findings, *said), corrections=None)

    def _outcome(self, result: EquationResult, erratum: bool) -> EquationResult:
        """Return an equation's result; unchecked where it differs from the source in what nothing else confirms."""
        links = result.links.union(*(self.named.get(key, ()) for key in result.uses))
        is_sure = self.taken.source != "table" or links <= self.confirmed
        if result.verdict is not Verdict.REFUTED or is_sure or erratum:
            return result
        doubt = say(Kind.OTHER_THAN_SOURCE, **self.source)
        return replace(result, verdict=Verdict.UNCHECKED, findings=(doubt.at(result.index), *result.findings))

    def _data(self, record: Record) -> Record:
        verdict = Verdict.DEFINED if self.is_used else Verdict.UNCHECKED
        findings = (say(Kind.GIVES_ARM, convention=self.taken.convention),)
        outcomes = (EquationResult(1, Role.DATA, verdict, findings=findings),)
        return Record(
            record.line,
            record.latex,
            verdict,
            record.erratum,
            findings,
            outcomes,
            cell=record.cell,
            section=record.section,
        )


def _unchecked(record: Record, finding: Finding) -> Record:
    return replace(record, verdict=Verdict.UNCHECKED, findings=(finding, *record.findings), corrections=None)
