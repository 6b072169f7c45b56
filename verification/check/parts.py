"""The parts of a document, each of an arm of its own: the verdicts of one, and of all of them together."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import accumulate

from armproof.verification.check.document_checker import DocumentChecker, load_arm_of
from armproof.verification.document import Document
from armproof.verification.findings import Kind, say
from armproof.verification.tables.arms import Inference
from armproof.verification.verdict import HOLDS, DocumentResult, Record, Verdict


def plainly(part: Inference) -> DocumentResult:
    """Return the verdicts of a part of a document, and nothing that takes time to find out besides."""
    return DocumentChecker(part.document, load_arm_of(part.document), False, False, True, part).run()


def unless_of_another_arm(place: int, parts: Sequence[Inference], result: DocumentResult) -> DocumentResult:
    """Leave open what is refuted in the part of one arm, and holds of another that the document shows."""
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
