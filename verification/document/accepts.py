"""Comments by which an author accepts a finding: `<!-- armproof: accept: the reason -->` before a display or a table.

In LaTeX it is `% armproof: accept: the reason`, in reStructuredText `.. armproof: accept: the reason`.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import replace
from pathlib import Path

from markdown_it.token import Token

from armproof.verification.document.cells import percent_cells
from armproof.verification.document.front_matter import split_front_matter
from armproof.verification.document.markdown import markdown_reader, without_labels
from armproof.verification.document.model import Accept, Display, Document, Table
from armproof.verification.document.notebook import read_cells, split_cells
from armproof.verification.patterns import regex

MARK = "armproof:"  # in the text of a document with such comments
FARTHEST = 3  # lines between a comment's last and the display or table that it is about
_ACCEPT = r"armproof:\s*accept\b[ \t:]*"
_LINES = {
    ".tex": regex(rf"(?<!\\)%+\s*{_ACCEPT}([^\n]*)"),
    ".rst": regex(rf"^[ \t]*\.\.\s+{_ACCEPT}([^\n]*)", re.MULTILINE),
}
_HTML = regex(rf"<!--\s*{_ACCEPT}(.*?)-->", re.DOTALL)


def with_accepts(document: Document, text: str, suffix: str) -> Document:
    """Return a document with its author's comments, each with the place of what it is about, if anything is there."""
    parts: list[Display | Table] = [*document.displays, *document.tables]
    places = [(part.cell, part.line) for part in parts]
    found = _of_lines(text, _LINES[suffix]) if suffix in _LINES else _of_markdown(document.path, text, suffix)
    return replace(document, accepts=tuple(replace(each, target=_target(each, places)) for each in found))


def _target(accept: Accept, places: Iterable[tuple[int | None, int]]) -> tuple[int | None, int] | None:
    last = accept.line + FARTHEST + 1
    near = [place for place in places if place[0] == accept.cell and accept.line <= place[1] <= last]
    return min(near, key=lambda place: place[1], default=None)


def _of_lines(text: str, pattern: re.Pattern[str]) -> Iterator[Accept]:
    for found in pattern.finditer(text):
        yield Accept(text.count("\n", 0, found.end()) + 1, None, found[1].strip())


def _of_markdown(path: Path, text: str, suffix: str) -> Iterator[Accept]:
    """Yield the comments of Markdown that are comments there: one in a listing is none."""
    for body, first, cell in _texts(path, text, suffix):
        for token in _html(markdown_reader().parse(without_labels(body))):
            source = token.content
            for found in _HTML.finditer(source):
                line = first + (token.map[0] if token.map else 0) + source.count("\n", 0, found.end())
                yield Accept(line, cell, " ".join(found[1].split()))


def _texts(path: Path, text: str, suffix: str) -> list[tuple[str, int, int | None]]:
    if suffix in (".ipynb", ".py"):
        return [*split_cells(path, read_cells(path, text) if suffix == ".ipynb" else percent_cells(text))[1]]
    _, body, first = split_front_matter(path, text)
    return [(body, first, None)]


def _html(tokens: Iterable[Token]) -> Iterator[Token]:
    """Yield what may hold comments, with its place: blocks of HTML, and paragraphs with HTML in them."""
    for token in tokens:
        inside = any(child.type == "html_inline" for child in token.children or ())
        if token.type == "html_block" or (token.type == "inline" and inside):
            yield token
