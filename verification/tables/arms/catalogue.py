"""An arm of the catalogue that a document's text names, compared with the arm of its table: a remark names the rows that differ."""

from __future__ import annotations

from contextlib import suppress

from armproof.verification.document import Document, Table
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.findings import Finding, Kind, say
from armproof.verification.tables.arms.inference import dh_tables
from armproof.verification.tables.check import check_table
from armproof.verification.verdict import Verdict

SECONDS = 2.0


def table_of_named(document: Document) -> Table | None:
    """Return the first DH table of a document whose text names an arm of the catalogue."""
    return next(dh_tables(document), None) if document.named else None


def difference(checker: ChainChecker, name: str, table: Table) -> Finding | None:
    """Say in which rows a table differs from an arm, whose checker this is; None where it does not, or nobody can tell."""
    with suppress(Exception), checker.exact.budget.of(SECONDS):  # a remark must not cost the document its verdicts
        record = check_table(checker, table)
        if record is not None and record.verdict is Verdict.REFUTED:
            rows = sorted({entry.row for entry in record.entries if entry.row})
            return say(Kind.UNLIKE_CATALOGUE, arm=name, line=table.line, rows=rows)
    return None
