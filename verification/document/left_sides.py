"""A left side that stands in the text above its display: `T_0_1 =` on a line, and the matrix alone below it."""

from __future__ import annotations

import re
from dataclasses import replace

from armproof.verification.document.model import Display, Document
from armproof.verification.patterns import regex

MAY_LEAD = regex(r"=[ \t]*(?:\$[ \t]*)?(?:\*\*|__)?[ \t]*\\{0,2}$", re.MULTILINE)
_SAYS = regex(r"=|\\(?:approx|equiv|[lg]eq?|neq?|to|rightarrow)(?![A-Za-z])|[<>≈≠≤≥]")
_PLAIN = r"[A-Za-z](?:[_^](?:\{\w+\}|[A-Za-z0-9]+))*"  # T_0_1, T_{01}, T^0_1, J
_LEFT = regex(
    rf"\s*(?:[-*+]\s+|\d+[.)]\s+)?(?:\*\*|__)?(?:(?P<plain>{_PLAIN})\s*:?=|\$(?P<within>[^$=]+?):?=\s*\$|\$(?P<before>[^$=]+)\$\s*:?=)"
    r"\s*(?:\*\*|__)?[ \t]*\\{0,2}"
)
_SUBSCRIPTS = regex(r"(?:_(?:\{\w+\}|[A-Za-z0-9]+)){2,}")
_LINES = 2  # above the display, of which all but the one with the left side are empty


def with_left_sides(document: Document, text: str) -> Document:
    """Return a document whose matrices that state nothing have the left side that the line above them ends in; that is no display by itself."""
    lines = text.replace("\r\n", "\n").split("\n")
    found = {each: left for each in document.displays if (left := _left_side(each, lines)) is not None}
    taken = {line for line, _ in found.values()}
    kept = (each for each in document.displays if not (each.line in taken and each.latex.rstrip().endswith("=")))
    return replace(document, displays=tuple(_with(found[each][1], each) if each in found else each for each in kept))


def _left_side(display: Display, lines: list[str]) -> tuple[int, str] | None:
    """Return the left side above a matrix alone, with its line; None where none leads to it."""
    if display.file or display.cell is not None or _SAYS.search(display.latex) or "matri" not in display.latex:
        return None
    first = max(0, display.line - 1 - _LINES)
    above = [(number, line) for number, line in enumerate(lines[first : display.line - 1], first + 1) if line.strip()]
    found = _LEFT.fullmatch(above[-1][1].rstrip()) if above else None
    if found is None:
        return None
    return above[-1][0], _joined(found["plain"]) if found["plain"] else (found["within"] or found["before"]).strip()


def _with(name: str, display: Display) -> Display:
    left = f"{name} = "
    pieces = tuple(replace(each, at=each.at + len(left)) for each in display.pieces)
    return replace(display, latex=left + display.latex, pieces=pieces)


def _joined(name: str) -> str:
    """Return a name in LaTeX: T_0_1 as T_{01}."""
    name = re.sub(r"([_^])([A-Za-z0-9]{2,})", r"\1{\2}", name)
    return _SUBSCRIPTS.sub(lambda found: "_{" + re.sub(r"[_{}]", "", found[0]) + "}", name)
