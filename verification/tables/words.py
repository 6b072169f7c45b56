"""The correct entries of a DH table in the document's own notation, and what is wrong with the printed ones in words."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable
from fractions import Fraction

from verification.tables.row import in_radians, rational_part
from verification.latex import nodes as n
from verification.latex.reader import key_as_latex
from verification.names import Names
from verification.tables.cells import Cell
from verification.trig import Scalar

LETTERS = {"alpha": "α", "theta": "θ", "sigma": "σ"}


class Notation:
    """Writes values as the cells of a table do: its letters, its fractions, its degrees."""

    def __init__(self, names: Names, cells: Iterable[Cell]) -> None:
        self._symbols: dict[str, str] = {}
        joined = []
        for cell in cells:
            joined.append(cell.text)
            for tree in cell.trees:
                for node in n.walk(tree):
                    symbol = names.known_symbol(node.key) if isinstance(node, n.Name) else None
                    if symbol is not None and isinstance(node, n.Name):
                        self._symbols.setdefault(symbol, latex_name(node.key))
        for key, symbol in names.symbols.items():
            self._symbols.setdefault(symbol, latex_name(key))
        text = " ".join(joined)
        self._slash = "\\pi/" in text or "π/" in text or re.search(r"(?<!\\)\bpi\s*/", text) is not None
        self._fraction = "\\dfrac" if "\\dfrac" in text else "\\frac"

    def symbol(self, name: str) -> str:
        """Return the document's spelling of a symbol of the arm."""
        return self._symbols.get(name) or latex_name(name)

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
        factors = [
            self._generator(kind, name) + (f"^{power}" if power > 1 else "") for (kind, name), power in powers.items()
        ]
        if not factors:
            return sign + _number(size)
        product = " ".join(factors)
        if size == 1:
            return sign + product
        if size.denominator == 1 or ("pi", "") not in powers:
            return f"{sign}{_number(size)} {product}"
        above = product if size.numerator == 1 else f"{size.numerator}{product}"
        return (
            f"{sign}{above}/{size.denominator}"
            if self._slash
            else f"{sign}{self._fraction}{{{above}}}{{{size.denominator}}}"
        )

    def _generator(self, kind: str, name: str) -> str:
        if kind == "pi":
            return "\\pi"
        if kind == "sqrt":
            return f"\\sqrt{{{name}}}"
        if kind in ("cos", "sin"):
            return f"\\{kind} {self.symbol(name)}"
        return self.symbol(name)


def latex_name(key: str) -> str:
    """Return the LaTeX of a key such as theta_1, d_12 or l_alpha."""
    return key_as_latex(key)


def _rank(powers: dict[tuple[str, str], int]) -> tuple[int, str]:
    kinds = {kind for kind, _ in powers}
    return (2 if not kinds else 1 if kinds == {"pi"} else 0, " ".join(sorted(name for _, name in powers)))


def _number(value: Fraction) -> str:
    if value.denominator == 1:
        return str(value.numerator)
    if 10**6 % value.denominator == 0:
        return f"{float(value):.6f}".rstrip("0").rstrip(".")
    return f"{value.numerator}/{value.denominator}"


def change_of_length(printed: Scalar, right: Scalar) -> str:
    """Return what is wrong with a printed length, in words; empty where it is nothing short."""
    if (printed + right).is_zero():
        return "the sign"
    if printed.is_zero():
        return "it is missing"
    if right.is_zero():
        return "it should vanish"
    return _change_of_terms(printed, right)


def change_of_angle(printed: Scalar, right: Scalar) -> str:
    """Return what is wrong with a printed angle, in words; `right` as a sum of symbols and a multiple of π."""
    ring = printed.ring

    def same(a: Scalar, b: Scalar) -> bool:
        cosine, sine = ring.cos_sin(a - b)
        return (cosine - 1).is_zero() and sine.is_zero()

    if same(printed, -right):
        return "the sign"
    if rational_part(printed) and same(in_radians(printed), right):
        return "it is in degrees, the header says radians"
    difference = (printed - right).normal()
    if difference.denominator.is_one():
        parts = {
            next(iter(powers), ("", ""))[0]: c
            for powers, c in ring.terms(difference.numerator)
            if sum(powers.values()) <= 1
        }
        if set(parts) == {"", "pi"} and abs(float(parts[""]) + math.pi * float(parts["pi"])) < 5e-3:
            return "a rounded number, which no equation can match"
    if printed.is_zero():
        return "it is missing"
    if right.is_zero():
        return "it should vanish"
    if symbols_of(printed) == symbols_of(right):
        return (
            "the constant offset"
            if symbols_of(printed) and _signs(printed) == _signs(right)
            else _change_of_terms(printed, right)
        )
    return _change_of_terms(printed, right)


def _change_of_terms(printed: Scalar, right: Scalar) -> str:
    one, other = symbols_of(printed), symbols_of(right)
    gone, more = sorted(other - one), sorted(one - other)
    if len(gone) == len(more) == 1:
        return (
            "the index"
            if letter_of(gone[0]) == letter_of(more[0])
            else f"{latex_name(more[0])} for {latex_name(gone[0])}"
        )
    if len(gone) == 1 and not more:
        return f"{latex_name(gone[0])} is missing"
    if len(more) == 1 and not gone:
        return f"{latex_name(more[0])} does not belong"
    if one == other and one:
        return "a sign" if _signs(printed) != _signs(right) else "a factor"
    return ""


def letter_of(symbol: str) -> str:
    """Return a symbol without its index."""
    return symbol.partition("_")[0]


def symbols_of(value: Scalar) -> set[str]:
    """Return the symbols of a sum."""
    return {name for powers, _ in value.ring.terms(value.numerator) for kind, name in powers if kind == "symbol"}


def _signs(value: Scalar) -> dict[str, bool]:
    return {
        " ".join(sorted(name for _, name in powers)): c < 0
        for powers, c in value.ring.terms(value.numerator)
        if powers and ("pi", "") not in powers
    }
