"""Read a jupytext py:percent lesson: its Markdown cells, at their own lines of the file."""

from __future__ import annotations

import re
from dataclasses import replace
from itertools import pairwise
from pathlib import Path
from typing import Any

from armproof.verification.document.front_matter import split_front_matter
from armproof.verification.document.markdown import read_markdown
from armproof.verification.document.model import Display, Document, Piece, Table

_COMMENT = re.compile(r"# ?")


def read_percent(path: Path, text: str) -> Document:
    """Return the document of a py:percent file; its cells are counted from 0."""
    front: dict[str, Any] | None = None
    lines: dict[str, int] = {}
    displays: list[Display] = []
    tables: list[Table] = []
    source = text.replace("\r\n", "\n").split("\n")
    starts = [k for k, line in enumerate(source) if line.startswith("# %%")] + [len(source)]
    for number, (start, end) in enumerate(pairwise(starts)):
        if not re.match(r"# %%.*\[(?:markdown|md|raw)\]", source[start]):
            continue
        body = "\n".join(line[_margin(line) :] for line in source[start + 1 : end])
        first = start + 2
        if front is None and body.startswith("---"):
            front, lines, body, first = split_front_matter(path, body, first)
        more, more_tables = read_markdown(body, first, number)
        displays += [_with_margins(display, source) for display in more]
        tables += [_table_with_margins(table, source) for table in more_tables]
    return Document(path, front or {}, tuple(displays), tuple(tables), lines)


def _margin(line: str) -> int:
    """Return how many characters of a line make it a comment."""
    return found.end() if (found := _COMMENT.match(line)) else 0


def _with_margins(display: Display, source: list[str]) -> Display:
    return replace(display, pieces=tuple(_moved(piece, source) for piece in display.pieces))


def _table_with_margins(table: Table, source: list[str]) -> Table:
    rows = (tuple(piece and _moved(piece, source) for piece in row) for row in table.pieces)
    return replace(table, pieces=tuple(rows))


def _moved(piece: Piece, source: list[str]) -> Piece:
    return replace(piece, column=piece.column + _margin(source[piece.line - 1]))
