"""From a table to its record: DH tables, upright or turned, as Markdown or set as an array, and tables of joint origins."""

from __future__ import annotations

import re
from dataclasses import replace

from armproof.verification.document import Display, Table
from armproof.verification.document.arrays import ArrayTable, array_in
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.errors import EvaluationError, NotSampled, TooComplex
from armproof.verification.findings import Kind, finding_of, say
from armproof.verification.patterns import regex
from armproof.verification.tables.cells import UnreadableCell
from armproof.verification.tables.columns import read_columns
from armproof.verification.tables.dh import DHTableCheck
from armproof.verification.tables.origins import check_origins
from armproof.verification.verdict import Record, Verdict

TWIST = regex(r"alpha|α|twist|torsi", re.IGNORECASE)  # no DH table without that column


def read_array(display: Display) -> ArrayTable | None:
    """Return the DH table of a display that holds one array and nothing else, or None."""
    return array_in(display) if TWIST.search(display.latex) else None


def check_table(checker: ChainChecker, table: Table) -> Record | None:
    """Return the record of a table of DH parameters or joint origins, or None where it is neither: it claims nothing."""
    if (found := _check_upright(checker, table)) is not None:
        return found
    other = turned(table)
    if other is None or (found := _check_upright(checker, other)) is None:
        return None
    entries = tuple(
        replace(e, row=e.column - 1, column=e.row + 1) if e.row is not None and e.column is not None else e
        for e in found.entries
    )
    return replace(found, latex=_latex(table), entries=entries)


def check_array_table(checker: ChainChecker, display: Display) -> Record | None:
    """Return the record of a display that is a DH table set as an array, or None where it is not."""
    array = read_array(display)
    if array is None or (found := check_table(checker, array.table)) is None:
        return None
    entries = [replace(entry, span=array.span(entry.row, entry.column, entry.printed)) for entry in found.entries]
    return replace(found, latex=display.latex, entries=tuple(entries))


def _check_upright(checker: ChainChecker, table: Table) -> Record | None:
    record = Record(
        table.line,
        _latex(table),
        Verdict.UNCHECKED,
        table.erratum,
        cell=table.cell,
        section=table.section,
        file=table.file,
    )
    try:
        if (columns := read_columns(table.header)) is not None:
            return DHTableCheck(checker, table, columns, record).record()
        return check_origins(checker, table, record)
    except UnreadableCell as problem:
        return replace(record, verdict=Verdict.UNREADABLE, findings=(finding_of(problem),))
    except (TooComplex, RecursionError) as problem:
        return replace(record, findings=(say(Kind.TOO_LARGE, problem=finding_of(problem)),))
    except (EvaluationError, NotSampled) as problem:
        return replace(record, findings=(finding_of(problem),))


def turned(table: Table) -> Table | None:
    """Return a table that has a column a joint, turned."""
    grid = (table.header, *table.rows)
    if len({len(row) for row in grid}) != 1 or len(table.header) < 2:
        return None
    header, *rows = zip(*grid, strict=True)
    return replace(table, header=header, rows=tuple(rows))


def _latex(table: Table) -> str:
    return " \\\\\n".join(" & ".join(row) for row in (table.header, *table.rows))
