"""The cells of a notebook and of its jupytext py:percent source: read here for verifying, for lessons and for grading."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from io import StringIO
from itertools import pairwise
from tokenize import TokenError, generate_tokens
from typing import Any

from armproof.verification.patterns import regex

# jupytext's rule, and "# %%[markdown]" as editors take it; "# %%time" is a magic in a cell
_MARKER = regex(r"#\s*%%(?:%*\s|$|(?=\[(?:markdown|md|raw)\]))")
_KIND = regex(r"\[(markdown|md|raw)\]")
_OPTION = regex(r"(\w+)=(\[.*?\]|\"[^\"]*\"|true|false|\d+)")
_MAGIC = regex(r"^(\s*)# (?=(?:!|%%?)[A-Za-z])", re.MULTILINE)
_COMMENT = regex(r"# ?")


@dataclass(frozen=True)
class Cell:
    """One cell: `code`, `markdown` or `raw`, its text, the line of the file on which the text begins, its metadata.

    A text cell of a py:percent file has lost its comment marks; `marker` is the line of its `# %%`, and `title` what stands
    there besides its kind and its options.
    """

    kind: str
    text: str
    line: int = 1
    metadata: Mapping[str, Any] = field(default_factory=dict)
    marker: int = 0
    title: str = ""

    @property
    def source(self) -> str:
        """The text as a notebook holds it: magics, which a Python file holds as comments, are none there."""
        return _MAGIC.sub(r"\1", self.text) if self.kind == "code" else self.text


def notebook_cells(text: str) -> tuple[Cell, ...]:
    """Return the cells of a notebook's JSON.

    Nothing in it is trusted. Raises json.JSONDecodeError where it is no JSON, another ValueError where it is no notebook.
    """
    try:
        return tuple(_cell(cell) for cell in raw_cells(json.loads(text)))
    except json.JSONDecodeError:
        raise
    except (AttributeError, KeyError, TypeError, ValueError, RecursionError, MemoryError):
        raise ValueError("it has no list of cells with a type and a source") from None


def raw_cells(notebook: dict[str, Any]) -> list[dict[str, Any]]:
    """Return the cells of a notebook as its JSON has them; those of version 3 stand in worksheets."""
    if "cells" in notebook or "worksheets" not in notebook:
        return list(notebook["cells"])
    return [cell for sheet in notebook["worksheets"] for cell in sheet.get("cells", ())]


def _cell(cell: dict[str, Any]) -> Cell:
    """Return one cell; a heading of version 3 as Markdown has it."""
    kind, text = str(cell["cell_type"]), _joined(cell.get("source", cell.get("input", "")))
    return Cell("markdown", f"{'#' * int(cell.get('level', 1))} {text}") if kind == "heading" else Cell(kind, text)


def _joined(source: Any) -> str:
    if isinstance(source, list) and all(isinstance(line, str) for line in source):
        return "".join(source)
    if not isinstance(source, str):
        raise TypeError
    return source


def percent_cells(text: str) -> tuple[Cell, ...]:
    """Return the cells of a py:percent file's text; what stands before the first, a jupytext header, is none."""
    lines = text.replace("\r\n", "\n").split("\n")
    return tuple(_percent_cells(lines))


def _percent_cells(lines: list[str]) -> Iterator[Cell]:
    quoted = _quoted(lines)
    starts = [number for number, line in enumerate(lines) if _MARKER.match(line) and number not in quoted]
    for start, end in pairwise([*starts, len(lines)]):
        first, last = start + 1, end
        while first < last and not lines[first].strip():
            first += 1
        while first < last and not lines[last - 1].strip():
            last -= 1
        kind, metadata, title = _read_marker(lines[start])
        body = lines[first:last] if kind == "code" else [line[comment_width(line) :] for line in lines[first:last]]
        yield Cell(kind, "\n".join(body), first + 1, metadata, start + 1, title)


def _quoted(lines: list[str]) -> set[int]:
    """Return the lines, from 0, that begin within a string: a program may hold the text of a lesson."""
    quoted: set[int] = set()
    try:
        for token in generate_tokens(StringIO("\n".join(lines)).readline):
            quoted.update(range(token.start[0], token.end[0]))  # one line ends where it begins, but for a string
    except (TokenError, SyntaxError):  # no Python from there on: a student's cell, a magic
        pass
    return quoted


def comment_width(line: str) -> int:
    """Return how many characters of a line of a text cell make it a comment."""
    return found.end() if (found := _COMMENT.match(line)) else 0


def _read_marker(line: str) -> tuple[str, dict[str, Any], str]:
    """Return the kind of a cell, its options and what else stands in its marker."""
    found = _KIND.search(line)
    kind = "code" if found is None else {"md": "markdown"}.get(found[1], found[1])
    rest = line[found.end() :] if found else line.lstrip("# \t").lstrip("%")
    metadata: dict[str, Any] = {}
    for option in _OPTION.finditer(rest):
        try:
            metadata[option[1]] = json.loads(option[2])
        except (ValueError, RecursionError):
            continue
        rest = rest.replace(option[0], "", 1)
    return kind, metadata, rest.strip()
