"""Change the sources of a notebook's cells in its JSON text: indents, escapes and outputs stay as they are."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping, Sequence
from json.decoder import scanstring  # type: ignore[attr-defined]
from json.scanner import py_make_scanner  # type: ignore[attr-defined]
from typing import Any

from armproof.verification.document.cells import raw_cells
from armproof.verification.patterns import regex

PlacedEdit = tuple[tuple[int, int], tuple[int, int], str]
_CHARACTER = regex(r"\\u[dD][89abAB][0-9a-fA-F]{2}\\u[dD][c-fC-F][0-9a-fA-F]{2}|\\u[0-9a-fA-F]{4}|\\.|.", re.DOTALL)


class _Placed(str):
    """A string of the JSON with the places of its first character and of its closing quote."""

    start: int
    end: int


class _Decoder(json.JSONDecoder):
    """Decodes JSON; each string knows its place."""

    def __init__(self) -> None:
        super().__init__()
        self.parse_string = _placed
        self.scan_once = py_make_scanner(self)


def _placed(text: str, begin: int, strict: bool = True) -> tuple[_Placed, int]:
    value, end = scanstring(text, begin, strict)
    placed = _Placed(value)
    placed.start, placed.end = begin, end - 1
    return placed, end


def rewrite_cells(text: str, edits: Mapping[int, Sequence[PlacedEdit]]) -> str:
    """Return a notebook's JSON with the edits of its cells' sources made, given by lines (from 1) and columns (from 0)."""
    cells = raw_cells(_Decoder().decode(text))
    found: list[tuple[int, int, str]] = []
    for cell, placed in edits.items():
        source: Any = cells[cell]["source"]
        places = _places(text, [source] if isinstance(source, _Placed) else source)
        whole = source if isinstance(source, str) else "".join(source)
        starts = [0]
        for line in whole.split("\n"):
            starts.append(starts[-1] + len(line) + 1)
        for (a, b), (c, d), new in placed:
            first, last = starts[a - 1] + b, starts[c - 1] + d
            end = places[last - 1][1] if last > first else places[first][0]
            found.append((places[first][0], end, _escaped(new, text)))
    for start, end, new in sorted(found, reverse=True):
        text = text[:start] + new + text[end:]
    return text


def _places(text: str, strings: Sequence[_Placed]) -> list[tuple[int, int]]:
    """Return the place in the JSON of each character of the strings joined, and of the end behind them."""
    places: list[tuple[int, int]] = []
    for string in strings:
        places.extend(found.span() for found in _CHARACTER.finditer(text, string.start, string.end))
    last = strings[-1].end if strings else 0
    return [*places, (last, last)]


def _escaped(new: str, text: str) -> str:
    return json.dumps(new, ensure_ascii=text.isascii())[1:-1]
