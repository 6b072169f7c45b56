"""SymPy's expressions as traced numbers. SymPy is the user's: it is read here by the names of its classes, not imported."""

from __future__ import annotations

import math
import sys
from collections.abc import Callable
from fractions import Fraction
from typing import Any

from armproof.verification.functions.tracing.number import (
    FUNCTIONS,
    ONE,
    ZERO,
    TracedNumber,
    Untraceable,
    as_traced,
    constant,
    function,
    power,
    symbol,
)

_NAMES = {"Abs": "abs"}


def is_loaded() -> bool:
    """Whether the program at hand uses SymPy at all."""
    return "sympy" in sys.modules


def is_expression(value: Any) -> bool:
    """Whether a value is one of SymPy's expressions."""
    return type(value).__module__.partition(".")[0] == "sympy" and hasattr(value, "args") and hasattr(value, "func")


class FromSympy:
    """Turns SymPy expressions into traced numbers; equal subexpressions become one node.

    `rename` gives the name of a symbol that is the user's own; without it only those of `variable` are known.
    """

    def __init__(self, rename: Callable[[str], str] | None = None) -> None:
        self._known: dict[Any, TracedNumber] = {}
        self._rename = rename

    def variable(self, name: str) -> Any:
        """Return the SymPy symbol that stands for a symbol."""
        found = sys.modules["sympy"].Symbol(name, real=True)
        self._known[found] = symbol(name)
        return found

    def convert(self, expression: Any) -> TracedNumber:
        """Return the formula of an expression; raises Untraceable for a function that is not traced."""
        if expression not in self._known:
            self._known[expression] = self._convert(expression)
        return self._known[expression]

    def _convert(self, expression: Any) -> TracedNumber:
        name = type(expression).__name__
        if expression.is_Symbol and self._rename is not None:
            return symbol(self._rename(str(expression.name)))
        if expression.is_Rational:
            return constant(Fraction(int(expression.p), int(expression.q)))
        if expression.is_Float:
            return as_traced(float(expression))
        if name == "Pi":
            return constant(math.pi)
        nodes = [self.convert(argument) for argument in expression.args]
        if name == "Add":
            return sum(nodes, ZERO)
        if name == "Mul":
            product = ONE
            for node in nodes:
                product = product * node
            return product
        if name == "Pow":
            return power(*nodes)
        name = _NAMES.get(name, name)
        if name not in FUNCTIONS:
            raise Untraceable("SymPy's {name} cannot be traced", name=name)
        return function(name, *nodes)
