"""The correct entries of a table in the document's own notation."""

from __future__ import annotations

import re
from collections.abc import Iterable
from fractions import Fraction

from armproof.verification.algebra.ring import Scalar
from armproof.verification.latex import nodes as n
from armproof.verification.latex.reader import key_as_latex
from armproof.verification.naming.names import Names
from armproof.verification.tables.cells import Cell


class Notation:
    """Writes values as the cells of a table do: its letters, its fractions, its degrees."""

    def __init__(self, names: Names, cells: Iterable[Cell]) -> None:
        cells = list(cells)
        nodes = (node for cell in cells for tree in cell.trees for node in n.walk(tree))
        keys = [node.key for node in nodes if isinstance(node, n.Name)]
        self._symbols: dict[str, str] = {}
        for key in (*keys, *names.symbols):
            if (symbol := names.known_symbol(key)) is not None:
                self._symbols.setdefault(symbol, key_as_latex(key))
        text = " ".join(cell.text for cell in cells)
        self._slash = re.search(r"(?:\\pi|π|\bpi\s*)/", text) is not None
        self._fraction = "\\dfrac" if "\\dfrac" in text else "\\frac"

    def symbol(self, name: str) -> str:
        """Return the document's spelling of a symbol of the arm."""
        return self._symbols.get(name) or key_as_latex(name)

    def value(self, value: Scalar, degrees: str | None = None) -> str:
        """Return a value; `degrees` is the sign after a number of degrees, or None for radians."""
        value = value.normal()
        if not value.denominator.is_one():
            return str(value)
        ring = value.ring
        terms = sorted(ring.terms(value.numerator), key=lambda term: _rank(term[0]))
        written = [self._term(dict(powers), coefficient, degrees) for powers, coefficient in terms]
        text = " + ".join(written).replace("+ -", "- ")
        return text or ("0" + degrees if degrees else "0")

    def _term(self, powers: dict[tuple[str, str], int], coefficient: Fraction, degrees: str | None) -> str:
        sign = "-" if coefficient < 0 else ""
        size = abs(coefficient)
        if degrees is not None and powers == {("pi", ""): 1}:
            return f"{sign}{_number(size * 180)}{degrees}"
        product = " ".join(
            self._generator(kind, name) + (f"^{power}" if power > 1 else "") for (kind, name), power in powers.items()
        )
        if ("pi", "") in powers and size.denominator > 1:
            above = product if size.numerator == 1 else f"{size.numerator}{product}"
            below = size.denominator
            return sign + (f"{above}/{below}" if self._slash else f"{self._fraction}{{{above}}}{{{below}}}")
        return sign + " ".join(
            [*([_number(size)] if size != 1 or not product else []), *([product] if product else [])]
        )

    def _generator(self, kind: str, name: str) -> str:
        if kind == "pi":
            return "\\pi"
        if kind == "sqrt":
            return f"\\sqrt{{{name}}}"
        if kind in ("cos", "sin"):
            return f"\\{kind} {self.symbol(name)}"
        return self.symbol(name)


def _rank(powers: dict[tuple[str, str], int]) -> tuple[int, str]:
    kinds = {kind for kind, _ in powers}
    return (2 if not kinds else 1 if kinds == {"pi"} else 0, " ".join(sorted(name for _, name in powers)))


def _number(value: Fraction) -> str:
    if value.denominator == 1:
        return str(value.numerator)
    if 10**6 % value.denominator == 0:
        return f"{float(value):.6f}".rstrip("0").rstrip(".")
    return f"{value.numerator}/{value.denominator}"
