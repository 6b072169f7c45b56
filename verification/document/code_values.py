"""Entries of DH tables that stand in code, `np.pi/2`, `L1 + d2`, `q(3)`, as the LaTeX of a cell; nothing is executed."""

from __future__ import annotations

import ast
from collections.abc import Mapping
from decimal import Decimal
from types import MappingProxyType

from armproof.verification.patterns import regex

MOST = 200  # characters of an entry
_DEGREES = ("deg2rad", "radians")
_PLAIN = ("float", "Rational", "sympify", "S", "nsimplify")
_GREEK = {
    "th": "theta",
    "theta": "theta",
    "t": "theta",
    "q": "q",
    "alp": "alpha",
    "alpha": "alpha",
    "phi": "phi",
    "beta": "beta",
}
_NAME = regex(r"([A-Za-z]+?)_?(\d{1,2})_?(?:_var|_sym)?")
_OPERATORS: dict[type[ast.operator], str] = {ast.Add: " + ", ast.Sub: " - ", ast.Mult: r" \cdot "}

Values = Mapping[str, ast.expr]


class NoEntry(ValueError):
    """What is no sum of letters, numbers and parts of π."""


def parsed(text: str) -> ast.expr:
    """Return the tree of an expression in code, Matlab's `q(1)` and `2^3` too; raises NoEntry."""
    try:
        if len(text) > MOST:
            raise NoEntry
        return ast.parse(text.strip().replace("^", "**"), mode="eval").body
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        raise NoEntry from None


def entry(node: ast.expr, values: Values = MappingProxyType({}), depth: int = 0) -> str:
    """Return an entry as LaTeX, a name that has a number in the code by that where it has no index; raises NoEntry."""
    match node:
        case ast.Constant(value) if type(value) in (int, float):
            return f"{Decimal(repr(value)):f}"
        case ast.UnaryOp(ast.USub(), inner):
            return f"-{_within(inner, values, depth)}"
        case ast.UnaryOp(ast.UAdd(), inner):
            return entry(inner, values, depth)
        case ast.BinOp(left, ast.Div(), right):
            return rf"\frac{{{entry(left, values, depth)}}}{{{entry(right, values, depth)}}}"
        case ast.BinOp(left, operator, right) if type(operator) in _OPERATORS:
            return _within(left, values, depth, operator) + _OPERATORS[type(operator)] + _within(right, values, depth)
        case ast.Call(function, [argument]) if _last(function) in _DEGREES:
            return rf"{_within(argument, values, depth)} \cdot \frac{{\pi}}{{180}}"
        case ast.Call(function, [argument]) if _last(function) in _PLAIN:
            return entry(argument, values, depth)
        case ast.Call(ast.Name(letter), [ast.Constant(int(number))]):  # Matlab counts from 1
            return name(f"{letter}{number}")
        case ast.Subscript(inner, ast.Constant(int(number))) if _last(inner):
            return name(f"{_last(inner)}{number + 1}")
        case ast.Name() | ast.Attribute():
            key = _last(node)
            if key in ("pi", "PI"):
                return r"\pi"
            if key in values and depth < 4 and not _NAME.fullmatch(key):
                return entry(values[key], values, depth + 1)
            return name(key)
    return _none()


def name(key: str) -> str:
    """Return a letter with its index as LaTeX, theta1 as \\theta_{1}; raises NoEntry."""
    found = _NAME.fullmatch(key)
    if found is None:
        return key if len(key) == 1 else _none()
    letter = _GREEK.get(found[1], found[1])
    return f"\\{letter}_{{{found[2]}}}" if letter in ("theta", "alpha", "phi", "beta") else f"{letter}_{{{found[2]}}}"


def _within(node: ast.expr, values: Values, depth: int, operator: ast.operator | None = None) -> str:
    text = entry(node, values, depth)
    is_sum = isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add | ast.Sub)
    return f"({text})" if (is_sum and not isinstance(operator, ast.Add | ast.Sub)) or text.startswith("-") else text


def _last(node: ast.expr) -> str:
    return node.attr if isinstance(node, ast.Attribute) else node.id if isinstance(node, ast.Name) else ""


def _none() -> str:
    raise NoEntry
