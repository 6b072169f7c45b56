"""Find the places of displays in the lines of a file, line by line: block quotes and indents are no part of the LaTeX."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace

from armproof.verification.document.model import Display, Piece, Table

_BAR = re.compile(r"(?<!\\)\|")
_BLANK = re.compile(r"[\s>]*")
_OPTIONS = re.compile(r"[\s>]*(?::[\w-]+:.*|---.*|[\w-]+:.*)?")
FARTHEST = 12  # lines between the opening of a display and its LaTeX: blank, or a directive's options


def place_displays(displays: Sequence[Display], lines: Sequence[str], first: int) -> list[Display]:
    """Return the displays with their places; `lines` begin on line `first`, the displays come in their order.

    A display is sought from its line on, behind its opening mark and behind the display before it.
    """
    placed: list[Display] = []
    row, column = 0, 0
    for display in displays:
        if display.line - first > row:
            row, column = display.line - first, 0
        mark = display.opening
        found = _find(display, lines, row, column, mark) if display.closed else None
        if found is None:
            placed.append(display)
            continue
        pieces, row, column = found
        if mark == "$$" and (closing := lines[row].find(mark, column)) >= 0:
            column = closing + len(mark)
        placed.append(replace(display, pieces=tuple(replace(p, line=p.line + first) for p in pieces)))
    return placed


def place_table(table: Table, lines: Sequence[str], first: int) -> Table:
    """Return a table with the places of its cells; `lines` begin on line `first`."""
    rows = (table.header, *table.rows)
    numbers = [table.line - first + k + (k > 0) for k in range(len(rows))]  # the rule below the header is no row
    placed = (
        _place_row(row, lines[number], number + first) if number < len(lines) else (None,) * len(row)
        for row, number in zip(rows, numbers, strict=True)
    )
    return replace(table, pieces=tuple(placed))


def _place_row(row: Sequence[str], line: str, number: int) -> tuple[Piece | None, ...]:
    start = len(line) - len(line.lstrip(" \t>"))
    bars = [found.start() for found in _BAR.finditer(line, start)]
    edges = [*([] if bars and bars[0] == start else [start - 1]), *bars, len(line)]
    placed: list[Piece | None] = []
    for k, text in enumerate(row):
        if k + 1 >= len(edges):
            placed.append(None)
            continue
        begin, end = edges[k] + 1, edges[k + 1]
        at = line.find(text, begin, end) if text else min(begin + 1, end)
        placed.append(Piece(0, len(text), number, at, "$" in line[begin:end]) if at >= 0 else None)
    return tuple(placed)


def _find(
    display: Display, lines: Sequence[str], row: int, column: int, mark: str
) -> tuple[list[Piece], int, int] | None:
    """Return the pieces of a display, and the row and column behind it."""
    if row >= len(lines):
        return None
    opening = lines[row].find(mark, column)
    while opening >= 0:
        skipped = _BLANK if mark == "$$" else _OPTIONS
        if (found := _follow(display.latex, lines, row, opening + len(mark), skipped)) is not None:
            return found
        opening = lines[row].find(mark, opening + len(mark))
    return None


def _follow(
    latex: str, lines: Sequence[str], row: int, column: int, skipped: re.Pattern[str]
) -> tuple[list[Piece], int, int] | None:
    """Return the pieces of a display that begins behind a place, or None where it does not."""
    pieces: list[Piece] = []
    at = 0
    for text in latex.split("\n"):
        if bare := text.strip():
            start = at + text.index(bare)
            for ahead in range(FARTHEST if not pieces else 1 + FARTHEST):
                if row + ahead >= len(lines):
                    return None
                found = lines[row + ahead].find(bare, column if ahead == 0 else 0)
                if found >= 0 and _nothing_between(lines[row + ahead][column if ahead == 0 else 0 : found]):
                    break
                if not skipped.fullmatch(lines[row + ahead], column if ahead == 0 else 0):
                    return None
            else:
                return None
            row, column = row + ahead, found + len(bare)
            pieces.append(Piece(start, len(bare), row, found))
        at += len(text) + 1
    return (pieces, row, column) if pieces else None


def _nothing_between(text: str) -> bool:
    return not text.strip(" \t>")
