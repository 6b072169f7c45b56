"""Expressions of Drake and of SymPy as traced numbers; equal subexpressions become one node.

SymPy is the user's: it is read here by the names of its classes, not imported.
"""

from __future__ import annotations

import math
import sys
from collections.abc import Callable
from fractions import Fraction
from functools import partial
from typing import Any

from armproof.verification.functions.tracing.number import (
    FUNCTIONS,
    ONE,
    ZERO,
    TracedNumber,
    Untraceable,
    as_traced,
    constant,
    divide,
    function,
    power,
    symbol,
)

_OPERATIONS: dict[str, Callable[..., TracedNumber]] = {
    **{name: partial(function, name) for name in FUNCTIONS},
    "add": lambda *nodes: sum(nodes, ZERO),
    "mul": lambda *nodes: math.prod(nodes, start=ONE),
    "div": divide,
    "pow": power,
}


class FromDrake:
    """Turns pydrake.symbolic.Expression into traced numbers."""

    def __init__(self) -> None:
        self._variables: dict[int, TracedNumber] = {}
        self._known: dict[str, list[tuple[Any, TracedNumber]]] = {}

    def variable(self, name: str) -> Any:
        """Return the expression that stands for a symbol."""
        from pydrake.symbolic import Expression, Variable

        variable = Variable(name)
        self._variables[variable.get_id()] = symbol(name)
        return Expression(variable)

    def convert(self, value: Any) -> TracedNumber:
        """Return the formula of an expression, or of a number; raises Untraceable for a function that is not traced."""
        if not hasattr(value, "Unapply"):
            return as_traced(value)
        alike = self._known.setdefault(str(value), [])  # Drake's expressions cannot be hashed
        for other, node in alike:
            if value.EqualTo(other):
                return node
        alike.append((value, self._convert(value)))
        return alike[-1][1]

    def _convert(self, expression: Any) -> TracedNumber:
        operation, arguments = expression.Unapply()
        name = expression.get_kind().name.lower()
        if name == "var":
            return self._variables[arguments[0].get_id()]
        if name == "constant":
            return as_traced(arguments[0])
        if name not in _OPERATIONS:
            raise Untraceable("Drake's {operation} cannot be traced", operation=operation)
        return _OPERATIONS[name](*map(self.convert, arguments))


def sympy_is_loaded() -> bool:
    """Whether the program at hand uses SymPy at all."""
    return "sympy" in sys.modules


class FromSympy:
    """Turns SymPy expressions into traced numbers.

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

    def convert(self, value: Any) -> TracedNumber:
        """Return the formula of an expression, or of a number; raises Untraceable for a function that is not traced."""
        if not is_sympy(value):
            return as_traced(value)
        if value not in self._known:
            self._known[value] = self._convert(value)
        return self._known[value]

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
        operation = name.lower() if name in ("Add", "Mul", "Pow", "Abs") else name
        if operation not in _OPERATIONS:
            raise Untraceable("SymPy's {name} cannot be traced", name=operation)
        return _OPERATIONS[operation](*nodes)


def is_sympy(value: Any) -> bool:
    """Whether a value is one of SymPy's expressions."""
    return type(value).__module__.partition(".")[0] == "sympy" and hasattr(value, "args") and hasattr(value, "func")
