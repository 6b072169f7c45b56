"""Read a notebook or its py:percent source: the displays of its Markdown cells."""

from __future__ import annotations

import json
from collections.abc import Iterable, Sequence
from dataclasses import replace
from pathlib import Path

from armproof.verification.document.cells import Cell, comment_width, notebook_cells, percent_cells
from armproof.verification.document.front_matter import FrontMatter, split_front_matter
from armproof.verification.document.markdown import read_markdown
from armproof.verification.document.model import CODE, Display, Document, Piece
from armproof.verification.errors import DocumentError
from armproof.verification.findings import Kind, say


def read_notebook(path: Path, text: str) -> Document:
    """Return the document of a notebook's JSON, each display at its line of the cell; raises DocumentError."""
    return _read_cells(path, read_cells(path, text))


def read_cells(path: Path, text: str) -> tuple[Cell, ...]:
    """Return the cells of a notebook; raises DocumentError."""
    try:
        return notebook_cells(text) if text else ()  # a new file; who grades takes it for none
    except json.JSONDecodeError as error:
        raise DocumentError(say(Kind.NOT_JSON, reason=error.msg), path=path, line=error.lineno) from None
    except ValueError as error:
        raise DocumentError(say(Kind.NOT_A_NOTEBOOK, reason=str(error)), path=path, line=1) from None


def read_percent(path: Path, text: str) -> Document:
    """Return the document of a py:percent file, each display at its own line of the file."""
    document = _read_cells(path, percent_cells(text))
    margins = [comment_width(line) for line in text.replace("\r\n", "\n").split("\n")]
    displays = tuple(
        replace(display, pieces=tuple(_moved(piece, margins) for piece in display.pieces))
        for display in document.displays
    )
    tables = tuple(
        replace(table, pieces=tuple(tuple(piece and _moved(piece, margins) for piece in row) for row in table.pieces))
        for table in document.tables
    )
    return replace(document, displays=displays, tables=tables)


def _moved(piece: Piece, margins: list[int]) -> Piece:
    return replace(piece, column=piece.column + margins[piece.line - 1])


def _read_cells(path: Path, cells: Sequence[Cell]) -> Document:
    front, texts = split_cells(path, cells)
    read = [read_markdown(*text) for text in texts]
    code = (
        Display(cell.line, cell.text, cell=number, opening=CODE)
        for number, cell in enumerate(cells)
        if cell.kind == "code"
    )
    displays = (*code, *(display for found, _ in read for display in found))
    tables = tuple(table for _, found in read for table in found)
    return Document(path, front.values, displays, tables, front.lines, remarks=front.remarks)


def split_cells(path: Path, cells: Iterable[Cell]) -> tuple[FrontMatter, list[tuple[str, int, int]]]:
    """Return the front matter of cells, and their Markdown: texts with their first lines and cells.

    The front matter stands in the first Markdown or raw cell that has one.
    """
    front: FrontMatter | None = None
    texts: list[tuple[str, int, int]] = []
    for number, cell in enumerate(cells):
        body, first = cell.text, cell.line
        bare = body.lstrip()
        if front is None and cell.kind in ("markdown", "raw") and bare.startswith("---"):
            blank = body.count("\n", 0, len(body) - len(bare))
            front, body, first = split_front_matter(path, bare, first + blank)
        if cell.kind == "markdown":
            texts.append((body, first, number))
    return front or FrontMatter(), texts
