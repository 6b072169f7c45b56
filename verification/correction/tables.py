"""What mends a refuted table: its wrong cells, replaced and checked again."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from armproof.verification.correction.record import ELLIPSIS, applied
from armproof.verification.document import Display, Table
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.tables import check_array_table, check_table
from armproof.verification.verdict import Correction, Record, Verdict, WrongEntry

Place = tuple[int, int]  # row, the header's being 0, and column from 0


def correct_table(checker: ChainChecker, table: Table, record: Record) -> tuple[Correction, ...]:
    """Return what mends a Markdown table, at places of its record's LaTeX, or nothing where its entries do not tell."""
    cells = dict(_cells(table, record))
    if not cells:
        return ()
    mended = replace(
        table,
        header=tuple(cells.get((0, k), text) for k, text in enumerate(table.header)),
        rows=tuple(
            tuple(cells.get((r, k), text) for k, text in enumerate(row)) for r, row in enumerate(table.rows, start=1)
        ),
    )
    if not _passes(check_table(checker, mended)):
        return ()
    spans = cell_spans(table)
    return tuple(Correction(*spans[place], text) for place, text in sorted(cells.items()))


def correct_array(checker: ChainChecker, display: Display, record: Record) -> tuple[Correction, ...]:
    """Return what mends a table set as an array, at places of its LaTeX, or nothing where its entries do not tell."""
    if not all(_is_usable(entry) and entry.span is not None for entry in record.entries):
        return ()
    found = {Correction(*entry.span, entry.correct) for entry in record.entries if entry.span is not None}
    corrections = tuple(sorted(found, key=lambda correction: correction.start))
    latex = applied(display.latex, corrections)
    mended = _passes(check_array_table(checker, replace(display, latex=latex)))
    return corrections if mended else ()


def cell_spans(table: Table) -> dict[Place, tuple[int, int]]:
    """Return the places of the cells in the LaTeX that a record gives of its table."""
    spans: dict[Place, tuple[int, int]] = {}
    at = 0
    for r, row in enumerate((table.header, *table.rows)):
        for k, text in enumerate(row):
            spans[r, k] = (at, at + len(text))
            at += len(text) + (3 if k + 1 < len(row) else 0)  # " & "
        at += len(" \\\\\n")
    return spans


def _cells(table: Table, record: Record) -> Iterator[tuple[Place, str]]:
    """Yield the wrong cells with their correct text; nothing where one of them is not known."""
    if not all(_is_usable(entry) for entry in record.entries):
        return
    for entry in record.entries:
        if entry.row is not None and entry.column is not None:
            yield (entry.row, entry.column - 1), entry.correct
        elif entry.printed in table.header:
            yield (0, table.header.index(entry.printed)), entry.correct


def _is_usable(entry: WrongEntry) -> bool:
    return bool(entry.correct) and ELLIPSIS not in entry.correct


def _passes(record: Record | None) -> bool:
    return record is not None and record.verdict not in (Verdict.REFUTED, Verdict.UNREADABLE)
