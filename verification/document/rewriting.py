"""Change a document's text in a few places and leave every other character as it is."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass

from armproof.verification.document.model import Display, Table
from armproof.verification.document.notebook_text import rewrite_cells

Place = tuple[int, int]  # line from 1, column from 0


@dataclass(frozen=True)
class Change:
    """What is to stand from `start` up to `end`, places in the file or in a notebook's cell."""

    start: Place
    end: Place
    text: str
    cell: int | None = None


def change_of(display: Display, start: int, end: int, text: str, *, in_notebook: bool) -> Change | None:
    """Return the change that replaces a part of a display's LaTeX; None where its place in the file is not known."""
    begins = _place(display, start, after=end > start)
    ends = _place(display, end, after=False) if end > start else begins
    if begins is None or ends is None:
        return None
    return Change(begins, ends, " ".join(text.split("\n")), display.cell if in_notebook else None)


def change_of_cell(table: Table, row: int, column: int, text: str, *, in_notebook: bool) -> Change | None:
    """Return the change that gives a table's cell another text, row 0 the header's; None where its place is not known."""
    place = table.pieces[row][column] if row < len(table.pieces) else None
    if place is None:
        return None
    needs_dollars = not place.in_dollars and re.search(r"[\\_^{]", text) is not None
    start, end = (place.line, place.column), (place.line, place.column + place.length)
    return Change(start, end, f"${text}$" if needs_dollars else text, table.cell if in_notebook else None)


def _place(display: Display, offset: int, *, after: bool) -> Place | None:
    """Return the place in the file before (or behind) the character after (or before) a place in the LaTeX."""
    for piece in display.pieces:
        if not piece.at <= offset <= piece.at + piece.length or (after and offset == piece.at + piece.length):
            continue
        if piece.end is None:
            return piece.line, piece.column + offset - piece.at
        if offset == piece.at:
            return piece.line, piece.column
        if offset == piece.at + piece.length:
            return piece.end
        return None  # within what a macro stands for
    return None


def rewrite(suffix: str, text: str, changes: Sequence[Change]) -> str:
    """Return a document's text with the changes made; raises ValueError where two of them overlap."""
    if suffix == ".ipynb":
        cells = {change.cell for change in changes if change.cell is not None}
        return rewrite_cells(
            text, {cell: _edits_by_place([c for c in changes if c.cell == cell]) for cell in sorted(cells)}
        )
    return apply_edits(text, offsets_of(text, _edits_by_place(changes)))


PlacedEdit = tuple[Place, Place, str]
Edit = tuple[int, int, str]


def _edits_by_place(changes: Sequence[Change]) -> list[PlacedEdit]:
    return sorted((change.start, change.end, change.text) for change in changes)


def offsets_of(text: str, edits: Sequence[PlacedEdit]) -> list[Edit]:
    """Return edits with their offsets in a text for lines and columns."""
    starts = [0]
    for line in text.split("\n"):
        starts.append(starts[-1] + len(line) + 1)
    return [(starts[a[0] - 1] + a[1], starts[b[0] - 1] + b[1], new) for a, b, new in edits]


def apply_edits(text: str, edits: Sequence[Edit]) -> str:
    """Return a text with its edits made; they come from left to right."""
    pieces: list[str] = []
    position = 0
    for start, end, new in edits:
        if start < position:
            raise ValueError("two corrections overlap")
        pieces += [text[position:start], new]
        position = end
    return "".join([*pieces, text[position:]])
