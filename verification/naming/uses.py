"""Which definitions count: those that a decided claim uses, itself or through other definitions."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

from armproof.verification.findings import Kind, say
from armproof.verification.verdict import EquationResult, Record, Verdict, worst

Key = tuple[str, int]  # a name and the line of the display that defines it


def settle_definitions(records: Iterable[Record]) -> tuple[Record, ...]:
    """Return the records of a document; a definition that no decided claim uses is unchecked: nothing rests on it."""
    records = tuple(records)
    used = used_names([each for record in records if not record.erratum for each in record.outcomes])
    return tuple(_settled(record, used) for record in records)


def used_names(results: Iterable[EquationResult]) -> frozenset[Key]:
    """Return the names that decided equations rest on, those of the definitions between included."""
    results = list(results)
    through = [each for each in results if each.defines]
    used: set[Key] = set()
    new = {key for each in results if each.is_decided for key in each.uses}
    while new:
        used |= new
        new = {key for each in through if each.defines & new for key in each.uses} - used
    return frozenset(used)


def _settled(record: Record, used: frozenset[Key]) -> Record:
    if not any(_rests(each, used) for each in record.outcomes):
        return record
    outcomes = tuple(_unused(each) if _rests(each, used) else each for each in record.outcomes)
    verdict = worst([each.verdict for each in outcomes])
    if verdict is not Verdict.UNCHECKED:
        return replace(record, outcomes=outcomes, verdict=verdict)
    findings = tuple(finding for each in outcomes if each.verdict is verdict for finding in each.findings)
    return replace(record, outcomes=outcomes, verdict=verdict, findings=findings)


def _rests(result: EquationResult, used: frozenset[Key]) -> bool:
    return result.verdict is Verdict.DEFINED and not result.defines & used


def _unused(result: EquationResult) -> EquationResult:
    names = sorted(name for name, _ in result.defines)
    found = (say(Kind.NEVER_USED, names=names).at(result.index),) if names else ()
    return replace(result, verdict=Verdict.UNCHECKED, findings=(*result.findings, *found))
