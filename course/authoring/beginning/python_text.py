"""Write Python: a formula's tree, with cosines and sines of a module and names as they are; values, and LaTeX as strings."""

from __future__ import annotations

import json
import keyword
from collections.abc import Iterator, Mapping
from typing import Any

from armproof.models.errors import ArmproofError
from armproof.verification.latex import nodes as n

_SUM, _PRODUCT, _UNARY, _POWER, _ATOM = range(5)  # how strongly the written term holds together
_FUNCTIONS = ("cos", "sin", "sqrt")


class NotPython(ArmproofError):
    """A formula holds what is not written as Python here."""


def write_python(node: n.Node) -> str:
    """Return a formula as Python; functions are those of `m`: m.cos(theta_1).

    Raises:
        NotPython: it holds something else than sums, products, quotients, powers, cosines, sines and roots.
    """
    return _written(node)[0]


def names_in(node: n.Node) -> Iterator[str]:
    """Yield the letters of a formula, π left out."""
    for below in n.walk(node):
        if isinstance(below, n.Name) and below.key != "pi":
            yield below.key


def _written(node: n.Node) -> tuple[str, int]:
    if isinstance(node, n.Number):
        return _number(node)
    if isinstance(node, n.Name):
        return ("m.pi", _ATOM) if node.key == "pi" else (_identifier(node.key), _ATOM)
    if isinstance(node, n.Group):
        return _written(node.inner)
    if isinstance(node, n.Sum):
        return _sum(node)
    if isinstance(node, n.Product) and "×" not in node.operators:
        return " * ".join(_at_least(factor, _UNARY) for factor in node.factors), _PRODUCT
    if isinstance(node, n.Quotient):
        return f"{_at_least(node.numerator, _PRODUCT)} / {_at_least(node.denominator, _POWER)}", _PRODUCT
    if isinstance(node, n.Power) and isinstance(node.exponent, n.Number):
        return f"{_at_least(node.base, _ATOM)}**{_at_least(node.exponent, _ATOM)}", _POWER
    if n.is_call(node, *_FUNCTIONS) and len(node.arguments) == 1:
        return f"m.{node.function}({_written(node.arguments[0])[0]})", _ATOM
    raise NotPython("no Python for a {type}", type=type(node).__name__)


def _at_least(node: n.Node, strength: int) -> str:
    text, own = _written(node)
    return text if own >= strength else f"({text})"


def _sum(node: n.Sum) -> tuple[str, int]:
    text = ""
    for sign, term in node.terms:
        if sign not in "+-":
            raise NotPython("no Python for the sign {sign}", sign=sign)
        written = _at_least(term, _PRODUCT)
        text = f"{text} {sign} {written}" if text else ("-" if sign == "-" else "") + written
    return text, _SUM


def _number(node: n.Number) -> tuple[str, int]:
    if node.value.denominator == 1:
        return str(node.value.numerator), _ATOM
    return (node.text, _ATOM) if "." in node.text else (f"{node.value.numerator} / {node.value.denominator}", _PRODUCT)


def _identifier(key: str) -> str:
    if not key.isidentifier() or keyword.iskeyword(key) or key in ("q", "m"):
        raise NotPython("'{key}' is no Python name", key=key)
    return key


def written(value: Any) -> str:
    """Return texts, numbers, lists and mappings as Python writes them, with double quotes."""
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False)
    if isinstance(value, Mapping):
        return "{" + ", ".join(f"{written(key)}: {written(item)}" for key, item in value.items()) + "}"
    if isinstance(value, list):
        return "[" + ", ".join(map(written, value)) + "]"
    if isinstance(value, tuple):
        return "(" + ", ".join(map(written, value)) + ("," if len(value) == 1 else "") + ")"
    return repr(value)


def raw_string(text: str) -> str:
    """Return LaTeX as a raw string where it can be one."""
    can_be = not (set(text) & {'"', "\n"}) and not text.endswith("\\")
    return f'r"{text}"' if can_be else written(text)
