"""A notebook as one text: its Markdown cells one below the other, so that what a sentence says of a section has lines in which it holds."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import TypeVar

from armproof.verification.document.cells import notebook_cells, percent_cells
from armproof.verification.document.model import CodeRobot, Display, Document, Table

_Part = TypeVar("_Part", Display, Table, CodeRobot)


def as_one_text(text: str, suffix: str) -> tuple[str, Mapping[int, int]]:
    """Return what a source says as one text, and how many lines of it stand above each cell of a notebook."""
    if suffix == ".ipynb" and text:
        return _flat_text(text)
    return (_spoken_text(text) if suffix == ".py" else text), {}


def _flat_text(text: str) -> tuple[str, Mapping[int, int]]:
    """Return the text of a notebook's Markdown cells, a blank line between two and blank lines for what is code, and how many lines stand above each cell."""
    lines: list[str] = []
    above: dict[int, int] = {}
    for number, cell in enumerate(notebook_cells(text)):
        above[number] = len(lines)
        own = cell.text.split("\n")
        lines += [*(own if cell.kind == "markdown" else [""] * len(own)), ""]
    return "\n".join(lines), above


def _spoken_text(text: str) -> str:
    """Return the text of a py:percent file on its own lines, without comment marks, blank where it is code."""
    lines = [""] * (text.count("\n") + 1)
    for cell in percent_cells(text):
        if cell.kind == "markdown":
            own = cell.text.split("\n")
            lines[cell.line - 1 : cell.line - 1 + len(own)] = own
    return "\n".join(lines)


def on_flat_lines(document: Document, above: Mapping[int, int], sign: int = 1) -> Document:
    """Return a notebook whose parts stand on the lines of its one text; with sign -1 on those of their cells again."""
    if not above:
        return document
    return replace(
        document,
        displays=tuple(_moved(each, above, sign) for each in document.displays),
        tables=tuple(_moved(each, above, sign) for each in document.tables),
        in_code=tuple(_moved(each, above, sign) for each in document.in_code),
        robots=tuple(_moved(each, above, sign) for each in document.robots),
    )


def _moved(part: _Part, above: Mapping[int, int], sign: int) -> _Part:
    return replace(part, line=part.line + sign * above.get(part.cell or 0, 0))
