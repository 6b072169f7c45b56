"""Traced formulas as LaTeX, so that a function's result can be checked as a display is."""

from __future__ import annotations

from fractions import Fraction

import numpy as np

from armproof.verification.errors import TooComplex
from armproof.verification.functions.formulas import exact_constant
from armproof.verification.functions.tracing.number import TracedNumber
from armproof.verification.latex.writer import symbol_as_latex

MOST_CHARACTERS = 20_000  # shared nodes are written out: a long formula is checked in another way
_SUM, _PRODUCT, _ATOM = range(3)  # how strongly the written term holds together
_WRITTEN = {  # the template, how strongly its arguments have to hold together, and how strongly it does
    "add": ("{} + {}", (_SUM, _PRODUCT), _SUM),
    "subtract": ("{} - {}", (_SUM, _PRODUCT), _SUM),
    "multiply": (r"{} \cdot {}", (_PRODUCT, _PRODUCT), _PRODUCT),
    "divide": (r"\frac{{{}}}{{{}}}", (_SUM, _SUM), _ATOM),
    "negative": ("-{}", (_PRODUCT,), _SUM),
    "sqrt": (r"\sqrt{{{}}}", (_SUM,), _ATOM),
    "abs": (r"\left|{}\right|", (_SUM,), _ATOM),
}
_FUNCTIONS = {"acos": r"\arccos", "asin": r"\arcsin", "atan": r"\arctan", "atan2": r"\operatorname{atan2}"}


def write_matrix(values: np.ndarray) -> str:
    """Return an array of traced numbers as LaTeX: a scalar, a column or a matrix.

    Raises:
        TooComplex: it would be longer than `MOST_CHARACTERS`.
    """
    writer = _Writer()
    if values.ndim == 0:
        return writer.write(values.item(), _SUM)
    rows = values[:, None] if values.ndim == 1 else values
    lines = (" & ".join(writer.write(cell, _SUM) for cell in row) for row in rows)
    return r"\begin{bmatrix} " + r" \\ ".join(lines) + r" \end{bmatrix}"


class _Writer:
    def __init__(self) -> None:
        self._known: dict[int, tuple[str, int]] = {}
        self._written = 0

    def write(self, node: TracedNumber, strength: int) -> str:
        """Return a node as LaTeX, in brackets where it holds together less than asked."""
        text, own = self._term(node)
        self._written += len(text)
        if self._written > MOST_CHARACTERS * 50 or len(text) > MOST_CHARACTERS:
            raise TooComplex("the formula is too long to be written")
        return text if own >= strength else f"({text})"

    def _term(self, node: TracedNumber) -> tuple[str, int]:
        if id(node) not in self._known:
            self._known[id(node)] = self._write(node)
        return self._known[id(node)]

    def _write(self, node: TracedNumber) -> tuple[str, int]:
        operation, arguments = node.operation, node.arguments
        if operation == "constant":
            return _constant(arguments[0])
        if operation == "symbol":
            return symbol_as_latex(arguments[0]), _ATOM
        if operation == "power":
            return f"{self.write(arguments[0], _ATOM)}^{{{arguments[1]}}}", _PRODUCT
        if operation in _WRITTEN:
            template, inner, own = _WRITTEN[operation]
            return template.format(*map(self.write, arguments, inner)), own
        inside = ", ".join(self.write(argument, _SUM) for argument in arguments)
        return f"{_FUNCTIONS.get(operation, chr(92) + operation)}({inside})", _PRODUCT


def _constant(value: int | float | Fraction) -> tuple[str, int]:
    number, times = exact_constant(float(value)) if isinstance(value, float) else (Fraction(value), "")
    size = abs(number)
    if times == "sqrt":
        text = rf"\sqrt{{{_fraction(size)}}}"
    elif times == "pi":
        text = r"\pi" if size == 1 else rf"{_fraction(size)} \cdot \pi"
    else:
        text = _fraction(size)
    return (f"-{text}", _SUM) if number < 0 else (text, _PRODUCT if times == "pi" else _ATOM)


def _fraction(size: Fraction) -> str:
    return str(size.numerator) if size.denominator == 1 else rf"\frac{{{size.numerator}}}{{{size.denominator}}}"
