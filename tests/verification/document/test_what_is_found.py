"""What a text holds: each display and table with its line, its section, and the place of every part in the file."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from armproof.verification.document import parse_document
from armproof.verification.document.model import Display, Piece, Table

_, *_PARTS = re.split(
    r"^===== (.*): (.*)\n", (Path(__file__).parent / "found.txt").read_text("utf-8"), flags=re.MULTILINE
)
CASES = list(zip(_PARTS[::3], _PARTS[1::3], _PARTS[2::3], strict=True))


def shown(name: str, text: str) -> str:
    """Return a line for each display and table of a document, with what stands at the places that it names."""
    document = parse_document(Path(name), text)
    lines = text.split("\n")
    found = [_display(each, lines) for each in document.displays] + [_table(each, lines) for each in document.tables]
    return "\n".join([*(f"front {key} {line}" for key, line in document.lines.items()), *found])


def _display(display: Display, lines: list[str]) -> str:
    marks = (
        ["erratum"] * display.erratum
        + ["open"] * (not display.closed)
        + [f"[{display.section}]"] * bool(display.section)
    )
    said = [f"said {' '.join(display.said)} ({display.said_above}, {display.said_outside})"] * bool(display.said)
    behind = [f"behind {' '.join(display.said_behind)}"] * bool(display.said_behind)
    places = " ".join(_place(piece, display.latex, lines) for piece in display.pieces)
    return " ".join([f"{display.line} {display.opening} {display.latex!r}", *marks, *said, *behind, places]).rstrip()


def _table(table: Table, lines: list[str]) -> str:
    marks = ["erratum"] * table.erratum + [f"[{table.section}]"] * bool(table.section)
    rows = zip((table.header, *table.rows), table.pieces, strict=True)
    cells = (
        " | ".join(f"{cell}{_cell(piece, cell, lines)}" for cell, piece in zip(row, pieces, strict=True))
        for row, pieces in rows
    )
    return " ".join([f"{table.line} table", *marks, " / ".join(cells)])


def _place(piece: Piece, latex: str, lines: list[str]) -> str:
    there = lines[piece.line - 1][piece.column : piece.column + piece.length]
    return f"{piece.line}:{piece.column}+{piece.length}" + "!" * (there != latex[piece.at : piece.at + piece.length])


def _cell(piece: Piece | None, cell: str, lines: list[str]) -> str:
    return f"@{_place(piece, cell, lines)}" + "$" * piece.in_dollars if piece is not None else "@nowhere"


@pytest.mark.parametrize(
    ("name", "case"), [(name, case) for name, _, case in CASES], ids=[about for _, about, _ in CASES]
)
def test_what_a_text_holds_stands_where_it_is_said_to(name: str, case: str) -> None:
    text, found = case.split("----- holds\n")
    assert shown(name, text) == found.strip("\n")
