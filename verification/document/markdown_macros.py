r"""Macros that a Markdown document or notebook defines in its formulas: as in MathJax, they hold from there on."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import partial

from armproof.verification.document.model import Display, Document
from armproof.verification.document.tex_definitions import find_macros
from armproof.verification.document.tex_macros import Macro, Macros


def with_macros(document: Document) -> Document:
    """Return a document with its displays' own macros expanded, each part still with its place in the file."""
    known: dict[str, Sequence[Macro]] = {}
    displays: list[Display] = []
    for display in document.displays:
        found, visible = find_macros(display.latex)
        known.update({name: [replace(defined[-1], begin=-1, end=None)] for name, defined in found.macros.items()})
        latex, pieces = Macros(known).expanded(visible, 0, partial(_place, display))
        displays.append(replace(display, latex=latex, pieces=pieces if display.pieces else ()))
    return replace(document, displays=tuple(displays))


def _place(display: Display, offset: int) -> tuple[int, int]:
    """Return the line and the column in the file of a place in a display."""
    for piece in display.pieces:
        if piece.at <= offset <= piece.at + piece.length:
            return piece.line, piece.column + offset - piece.at
    return display.line, 0
