"""Read the cells of a jupytext py:percent file, each with its line."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from itertools import pairwise
from pathlib import Path
from typing import Any

from armproof.course.authoring.errors import AuthoringError, SourceError

MARKER = re.compile(r"# %%(?:\s|$)")
_KIND = re.compile(r"\[(markdown|md|raw)\]")
_OPTION = re.compile(r"(\w+)=(\[.*?\]|\"[^\"]*\"|true|false|\d+)")
_MAGIC = re.compile(r"^(\s*)# (?=[!%][A-Za-z])", re.MULTILINE)


@dataclass(frozen=True)
class Cell:
    """One cell: `code`, `markdown` or `raw`, its text, the line of the file on which the text begins, its metadata."""

    kind: str
    text: str
    line: int
    metadata: Mapping[str, Any] = field(default_factory=dict)

    @property
    def source(self) -> str:
        """The text as a notebook holds it: magics, which a Python file holds as comments, are none there."""
        return _MAGIC.sub(r"\1", self.text) if self.kind == "code" else self.text


def read_cells(path: Path) -> tuple[Cell, ...]:
    """Return the cells of a py:percent file; its jupytext header is none of them.

    Raises:
        AuthoringError: the file cannot be read.
        SourceError: it holds no cells, text before the first, or Markdown that is no comment.
    """
    try:
        text = path.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        reason = error.strerror if isinstance(error, OSError) else "it is not UTF-8"
        raise AuthoringError(f"{path}: cannot be read: {reason}") from None
    return parse_cells(path, text)


def parse_cells(path: Path, text: str) -> tuple[Cell, ...]:
    """Return the cells of a py:percent text; `path` is for messages."""
    lines = text.replace("\r\n", "\n").split("\n")
    starts = [number for number, line in enumerate(lines) if MARKER.match(line)]
    if not starts:
        raise SourceError(path, 1, "no cell; a lesson is a py:percent file, whose cells begin with '# %%'")
    for number, line in enumerate(lines[: starts[0]]):
        if line.strip() and not line.startswith("#"):
            raise SourceError(path, number + 1, f"'{line.strip():.40}' stands before the first cell, '# %%'")
    return tuple(_cells(path, lines, [*starts, len(lines)]))


def _cells(path: Path, lines: list[str], starts: list[int]) -> Iterator[Cell]:
    for start, end in pairwise(starts):
        kind, metadata = _read_marker(path, start + 1, lines[start])
        first, last = start + 1, end
        while first < last and not lines[first].strip():
            first += 1
        while first < last and not lines[last - 1].strip():
            last -= 1
        body = lines[first:last]
        if kind != "code":
            body = [_uncommented(path, first + k + 1, line) for k, line in enumerate(body)]
        yield Cell(kind, "\n".join(body), first + 1, metadata)


def _read_marker(path: Path, line: int, text: str) -> tuple[str, dict[str, Any]]:
    found = _KIND.search(text)
    kind = {None: "code", "md": "markdown"}.get(found and found.group(1), found and found.group(1))
    options = text[found.end() if found else len("# %%") :].strip()
    metadata = {key: json.loads(value) for key, value in _OPTION.findall(options)}
    if left := _OPTION.sub("", options).strip():
        raise SourceError(path, line, f"'{left}' in the head of a cell; expected [markdown], [raw] or options such as tags=[\"wide\"]")  # fmt: skip
    return str(kind), metadata


def _uncommented(path: Path, line: int, text: str) -> str:
    if text.strip() and not text.startswith("#"):
        raise SourceError(
            path, line, f"'{text.strip():.40}' in a text cell; expected a comment: '# ' before every line"
        )
    return text.removeprefix("# ") if text.startswith("# ") else text.removeprefix("#")
