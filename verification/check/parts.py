"""The parts of a document, each of an arm of its own: the verdicts of one, and of all of them together."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from itertools import accumulate

from armproof.verification.document import Display, Document, Table
from armproof.verification.document.arms_called import called_in
from armproof.verification.document.hearing import words_of
from armproof.verification.document.sentences import not_known_in
from armproof.verification.findings import Kind, say
from armproof.verification.tables.arms import Inference
from armproof.verification.verdict import DECIDED, HOLDS, DocumentResult, Record, TakenArm, Verdict


def unless_of_another_arm(
    place: int, parts: Sequence[Inference], result: DocumentResult, plainly: Callable[[Inference], DocumentResult]
) -> DocumentResult:
    """Leave open what is refuted in the part of one arm, and holds of another that the document shows.

    `plainly` gives the verdicts of a part.
    """
    refuted = any(each.verdict is Verdict.REFUTED and not each.erratum for each in result.equations)
    others = [(part, part.arm) for k, part in enumerate(parts) if k != place and part.arm is not None]
    if parts[place].arm is None or not refuted:
        return result
    for part, arm in others:
        there = replace(part.document, displays=parts[place].document.displays, tables=())
        records = plainly(replace(part, document=there))
        holding = {each.place for each in records.equations if each.verdict in HOLDS}
        doubt = say(Kind.HOLDS_OF_OTHER_ARM, line=arm.line)
        found = (
            each.left_open(doubt, lambda one: one.verdict is Verdict.REFUTED) if each.place in holding else each
            for each in result.equations
        )
        result = replace(result, equations=tuple(found))
    return result


def unless_called_another(place: int, parts: Sequence[Inference], result: DocumentResult) -> DocumentResult:
    """Leave open what is decided in the part of one arm, where the text says that it is of another: "Back to robot A:"."""
    of_arms = [part for part in parts if part.arm is not None]
    arm = parts[place].arm
    if arm is None or len(of_arms) < 2 or not parts[place].document.called:
        return result
    own = {id(part): _own_names(k, of_arms) for k, part in enumerate(of_arms)}
    here = own.pop(id(parts[place]))
    others = frozenset[str]().union(*own.values()) - here
    records = []
    for record in result.equations:
        names = _names_at(record, parts[place].document, _place(arm), here | others)
        is_of_other = bool(names & others) and names.isdisjoint(here) and not record.erratum
        doubt = say(Kind.OF_OTHER_ARM)
        records.append(record.left_open(doubt, lambda one: one.verdict in DECIDED) if is_of_other else record)
    return replace(result, equations=tuple(records))


def _own_names(place: int, parts: Sequence[Inference]) -> frozenset[str]:
    """Return what an arm is called above what shows it, by its heading too; a number it has by its place, if by nothing else."""
    arm, document = parts[place].arm, parts[place].document
    assert arm is not None
    before = parts[place - 1].arm if place else None
    begin = _place(before) if before is not None else (0, 0)
    above = [each for each in document.called if begin < each.place <= _place(arm)]
    shown: list[Display | Table] = [*document.displays, *document.tables]
    sections = {each.section for each in shown if each.line == arm.line}
    names = {*(above[-1].names if above else ()), *(name for each in sections for name in called_in(words_of(each)))}
    return frozenset(names if any(map(str.isdigit, names)) else {*names, str(place + 1)})


def _names_at(record: Record, document: Document, begin: tuple[int, int], known: frozenset[str]) -> frozenset[str]:
    """Return what the last sentence under a record's heading, behind what shows the arm, calls an arm, or the heading does; that may be the name of an arm alone, "Anna"."""
    at = (record.cell or 0, record.line)
    told = [each for each in document.called if each.section == record.section and begin < each.place <= at]
    if told:
        return told[-1].names
    called = called_in(words_of(record.section))
    return called or frozenset(word.lower() for word in not_known_in(record.section) if word[:1].isupper()) & known


def _place(arm: TakenArm) -> tuple[int, int]:
    return arm.cell or 0, arm.line


def joined(document: Document, results: Sequence[DocumentResult]) -> DocumentResult:
    """Return the results of a document's parts as one: each record keeps the index of its arm among all of them."""
    before = list(accumulate((len(result.arms) for result in results), initial=0))
    counted = list(zip(results, before, strict=False))
    return replace(
        next((result for result in results if result.arms), results[0]),
        equations=tuple(_moved(record, first) for result, first in counted for record in result.equations),
        tables=tuple(_moved(record, first) for result, first in counted for record in result.tables),
        seconds=sum(result.seconds for result in results),
        arms=tuple(arm for result in results for arm in result.arms),
        front=document.front,
        remarks=tuple(dict.fromkeys(remark for result in results for remark in result.remarks)),
    )


def _moved(record: Record, first: int) -> Record:
    return record if record.arm_index is None else replace(record, arm_index=record.arm_index + first)
