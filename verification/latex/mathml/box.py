"""Boxes of MathML: a piece of markup and an estimate of its width, by which long lines are broken and fitted to paper.

Widths are in em of the surrounding text, on the generous side: a formula that is estimated to fit does fit.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from html import escape

SCRIPT = 0.76  # the size of a script beside its base
_GAP = 1.0  # between the columns of a table
_NARROW = frozenset("ijlt.,;:'′|()[]{}fIr ")


@dataclass(frozen=True, slots=True)
class Box:
    """Markup of MathML and its estimated width (em)."""

    markup: str
    width: float


EMPTY = Box("", 0.0)
_NOTHING = "<mrow></mrow>"


def letter(text: str, *, upright: bool = False) -> Box:
    """Return an identifier: one letter in italics, several upright."""
    variant = ' mathvariant="normal"' if upright and len(text) == 1 else ""
    return Box(f"<mi{variant}>{escape(text)}</mi>", _text_width(text))


def number(text: str) -> Box:
    """Return a number."""
    return Box(f"<mn>{escape(text)}</mn>", _text_width(text))


def words(text: str) -> Box:
    """Return words, set off by blanks."""
    text = text.strip()
    return Box(f"<mtext>\u2002{escape(text)}\u2002</mtext>", _text_width(text) + 1.2) if text else EMPTY


def operator(sign: str) -> Box:
    """Return an operator between two operands, or before one."""
    wide = 1.45 if sign in "=≈≤≥≠∈∉⊂∝<>" else 2.2 if sign in "⇒⇔⇐" else 0.9 if sign in "⋅/" else 1.35
    return Box(f"<mo>{escape(sign)}</mo>", wide)


def mark(sign: str) -> Box:
    """Return a sign without space around it: a comma, an ellipsis, an integral."""
    return Box(f"<mo>{escape(sign)}</mo>", 1.1 if sign in "⋯…⋱∏∑∫" else 0.6)


def thin_space() -> Box:
    """Return the space before and after a function's name."""
    return Box('<mspace width="0.17em"/>', 0.17)


def row(*boxes: Box) -> Box:
    """Return boxes side by side, as one element."""
    filled = [box for box in boxes if box.markup]
    if len(filled) < 2:
        return filled[0] if filled else EMPTY
    return Box(f"<mrow>{''.join(box.markup for box in filled)}</mrow>", sum(box.width for box in filled))


def joined(boxes: Iterable[Box]) -> Box:
    """Return boxes side by side without an element around them, for the inside of one."""
    boxes = list(boxes)
    return Box("".join(box.markup for box in boxes), sum(box.width for box in boxes))


def fenced(opening: str, inner: Box, closing: str) -> Box:
    """Return an expression in brackets that grow with it."""
    before = f'<mo fence="true" form="prefix">{escape(opening)}</mo>' if opening else ""
    after = f'<mo fence="true" form="postfix">{escape(closing)}</mo>' if closing else ""
    return Box(f"<mrow>{before}{inner.markup}{after}</mrow>", inner.width + 0.55 * (bool(opening) + bool(closing)))


def scripted(base: Box, sub: Box = EMPTY, sup: Box = EMPTY) -> Box:
    """Return a base with what stands below and above it on its right."""
    wide = base.width + SCRIPT * max(sub.width, sup.width)
    if sub.markup and sup.markup:
        return Box(f"<msubsup>{_one(base)}{_one(sub)}{_one(sup)}</msubsup>", wide)
    if sub.markup:
        return Box(f"<msub>{_one(base)}{_one(sub)}</msub>", wide)
    return Box(f"<msup>{_one(base)}{_one(sup)}</msup>", wide) if sup.markup else base


def prescripted(base: Box, pre_sub: Box, pre_sup: Box, sub: Box, sup: Box) -> Box:
    """Return a base with scripts on both sides: {}^0T_4."""
    after, before = f"{_one(sub)}{_one(sup)}", f"{_one(pre_sub)}{_one(pre_sup)}"
    wide = base.width + SCRIPT * (max(sub.width, sup.width) + max(pre_sub.width, pre_sup.width))
    return Box(f"<mmultiscripts>{_one(base)}{after}<mprescripts/>{before}</mmultiscripts>", wide)


def fraction(above: Box, below: Box) -> Box:
    """Return a fraction."""
    return Box(f"<mfrac>{_one(above)}{_one(below)}</mfrac>", max(above.width, below.width) + 0.3)


def root(inner: Box) -> Box:
    """Return a square root."""
    return Box(f"<msqrt>{inner.markup}</msqrt>", inner.width + 0.95)


def over(base: Box, sign: str) -> Box:
    """Return a base under an accent."""
    return Box(f'<mover accent="true">{_one(base)}<mo>{sign}</mo></mover>', max(base.width, 0.4))


def limits(base: Box, below: Box, above: Box) -> Box:
    """Return a base with what stands below and above it: the brace of a label, the limits of a product."""
    wide = max(base.width, SCRIPT * max(below.width, above.width))
    if below.markup and above.markup:
        return Box(f"<munderover>{_one(base)}{_one(below)}{_one(above)}</munderover>", wide)
    if below.markup:
        return Box(f"<munder>{_one(base)}{_one(below)}</munder>", wide)
    return Box(f"<mover>{_one(base)}{_one(above)}</mover>", wide) if above.markup else base


def table(rows: Sequence[Sequence[tuple[Box, str]]], kind: str = "") -> Box:
    """Return rows of cells, each with its attributes; `kind` is the table's class."""
    width = max((len(cells) for cells in rows), default=0)
    attribute = f' class="{kind}"' if kind else ""
    lines = []
    for cells in rows:
        filled = [f"<mtd{attributes}>{box.markup}</mtd>" for box, attributes in cells]
        lines.append(f"<mtr>{''.join(filled)}{'<mtd></mtd>' * (width - len(cells))}</mtr>")
    columns = [max((cells[k][0].width for cells in rows if k < len(cells)), default=0.0) for k in range(width)]
    return Box(f"<mtable{attribute}>{''.join(lines)}</mtable>", sum(columns) + _GAP * width)


def _one(box: Box) -> str:
    """Return a box's markup as exactly one element."""
    return box.markup or _NOTHING


def _text_width(text: str) -> float:
    return sum(0.42 if c in _NARROW else 0.64 if c.islower() or c.isdigit() else 0.84 for c in text)
