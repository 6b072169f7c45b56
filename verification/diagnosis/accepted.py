"""What an author accepts with a reason: shown, counted apart, and never counted as right."""

from __future__ import annotations

from dataclasses import replace

from armproof.verification.document import Document
from armproof.verification.findings import Kind, say
from armproof.verification.verdict import DocumentResult, Record, Verdict


def accepted(document: Document, record: Record) -> Record:
    """Return a record with what its author's comment says of it: accepted, without a reason, or of nothing to accept."""
    reasons = [each.reason for each in document.accepts if each.target == (record.cell, record.line)]
    if not reasons or record.accept is not None:
        return record
    settled = record.passes and (record.verdict is not Verdict.UNCHECKED or record.is_remark)
    kind = Kind.ACCEPTS_NOTHING if settled else Kind.ACCEPTED if reasons[-1] else Kind.ACCEPTED_WITHOUT_REASON
    return _with(record, kind, reasons[-1])


def with_accepted(document: Document, result: DocumentResult) -> DocumentResult:
    """Return the result of a document with what is accepted in it; a comment that is about nothing is said at the last display."""
    equations = [accepted(document, record) for record in result.equations]
    for lost in document.accepts:
        if lost.target is None and equations:
            equations[-1] = _with(equations[-1], Kind.ACCEPTS_NO_DISPLAY, lost.line)
    tables = tuple(accepted(document, record) for record in result.tables)
    return replace(result, equations=tuple(equations), tables=tables)


def _with(record: Record, kind: Kind, said: object) -> Record:
    term = "line" if kind is Kind.ACCEPTS_NO_DISPLAY else "reason"
    return replace(record, findings=(*record.findings, say(kind, **{term: said})))
