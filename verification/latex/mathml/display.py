"""A whole display in MathML: lines of pieces, so that a long chain of equations wraps at its relations on any page."""

from __future__ import annotations

from collections.abc import Sequence

from armproof.verification.latex import nodes as n
from armproof.verification.latex.mathml import box
from armproof.verification.latex.mathml.box import Box
from armproof.verification.latex.mathml.breaking import packed
from armproof.verification.latex.mathml.marks import Mark, find_marks
from armproof.verification.latex.mathml.writer import WIDEST, MathWriter, Read
from armproof.verification.latex.unicode import normalise_unicode
from armproof.verification.patterns import regex

_SEPARATOR = regex(r"(?<!\\)[,;]")
_SHORT = 6.0  # em of a left side that stays with its right side

Statement = tuple[Box, ...]  # the pieces of one statement
Line = tuple[Statement, ...]


def write_display(
    latex: str, read: Read, spans: Sequence[tuple[int, int]] = (), mark: Mark | None = None, widest: float = WIDEST
) -> tuple[Line, ...]:
    """Return a display as lines of statements, each of pieces, and each piece the inside of one <math> element.

    Args:
        latex: the display's LaTeX.
        read: reads LaTeX with the letters of the document.
        spans: the places of the parts to mark, in the LaTeX without Unicode signs.
        mark: how they are marked.
        widest: the width (em) beyond which a piece is broken where it can be.

    Raises:
        ReadError: the display cannot be read.
    """
    statements = read(latex)
    text = normalise_unicode(latex)
    writer = MathWriter(text, read, find_marks(statements, spans, mark) if mark else {}, widest)
    lines: list[list[Statement]] = [[]]
    end = 0
    for statement in statements:
        between = text[end : statement.span[0]]
        if lines[-1] and "\\\\" in between:
            lines.append([])
        elif lines[-1] and (comma := _SEPARATOR.search(between)):
            lines[-1][-1] = (*lines[-1][-1][:-1], box.joined([lines[-1][-1][-1], box.mark(comma.group())]))
        if isinstance(statement, n.Chain):
            lines[-1].append(tuple(_pieces(writer, statement)))
        else:
            lines[-1].append((writer.write(statement),))
        end = max(end, statement.span[1])
    return tuple(tuple(line) for line in lines if line)


def pieces(lines: tuple[Line, ...]) -> list[Box]:
    """Return all pieces of a display."""
    return [piece for line in lines for statement in line for piece in statement]


def _pieces(writer: MathWriter, chain: n.Chain) -> list[Box]:
    """Return a chain in pieces: its first member, then each relation with the member after it."""
    found: list[Box] = []
    for relation, member in zip(("", *chain.relations), chain.members, strict=False):
        parts = _parts(writer, member)
        if relation:
            parts[0] = box.joined([writer.relation(relation), parts[0]])
        found.extend(parts)
    together = found[0].width + found[1].width if len(found) > 1 else writer.widest
    if together < (writer.widest if found[0].width < _SHORT else writer.widest / 2):  # T = … is one piece
        found[:2] = [box.joined(found[:2])]
    return [piece for piece in found if piece.markup]


def _parts(writer: MathWriter, member: n.Node) -> list[Box]:
    """Return a member whole, or in pieces at its plus signs or factors where it is too wide for a line."""
    whole = writer.write(member)
    if whole.width <= writer.widest:
        return [whole]
    if isinstance(member, n.Sum):
        found = packed(writer.terms(member), writer.widest)
    elif isinstance(member, n.Product):
        found = packed(writer.factors(member), writer.widest)
    else:
        return [whole]
    mark = writer.marks.get(id(member))
    return [mark.around(piece) for piece in found] if mark is not None else found
