"""Numbers that remember how they were computed: a Python function called with them yields its formula."""

from __future__ import annotations

import math
from collections.abc import Callable
from fractions import Fraction
from functools import total_ordering
from typing import Any, NoReturn

import numpy as np

from armproof.models.errors import ArmproofError, Sentence

Real = int | float | Fraction
_LARGEST = 1e300
_NEARLY = 1e-12  # of a quarter turn

FUNCTIONS: dict[str, Callable[..., float]] = {
    "cos": math.cos,
    "sin": math.sin,
    "tan": math.tan,
    "acos": math.acos,
    "asin": math.asin,
    "atan": math.atan,
    "atan2": math.atan2,
    "sqrt": math.sqrt,
    "abs": abs,
}

METHODS: dict[str, Callable[..., TracedNumber]] = {}  # by the names that NumPy has for them; functions.py fills it


class Untraceable(ArmproofError):
    """A function asks of a symbol what only a number has: its value, its sign, its digits."""


@total_ordering
class TracedNumber:
    """A node of a formula: a constant, a symbol, or an operation on other nodes; shared nodes stay shared.

    Attributes:
        operation: "constant", "symbol", "add", "subtract", "multiply", "divide", "negative", "power" (of a node and an
            integer constant), or the name of one of FUNCTIONS.
        arguments: the nodes it is made of; of a symbol its name.
        value: its number where it holds no symbol, else None.

    It has the operators of a float and the methods that NumPy's functions call on the entries of object arrays. What
    needs a value (a comparison, int(), rounding) raises Untraceable, unless the node holds no symbol.
    """

    __slots__ = ("arguments", "operation", "value")

    def __init__(self, operation: str, arguments: tuple[Any, ...], value: Real | None = None) -> None:
        self.operation, self.arguments, self.value = operation, arguments, value

    @property
    def is_constant(self) -> bool:
        """Whether it is a plain number, and not a function of numbers such as cos(0.3)."""
        return self.operation == "constant"

    # -- arithmetic --------------------------------------------------------------------------------------------------

    def __add__(self, other: Any) -> Any:
        return add(self, other) if type(other) is TracedNumber else _binary(self, other, add)

    def __radd__(self, other: Any) -> Any:
        return _binary(other, self, add)

    def __sub__(self, other: Any) -> Any:
        return subtract(self, other) if type(other) is TracedNumber else _binary(self, other, subtract)

    def __rsub__(self, other: Any) -> Any:
        return _binary(other, self, subtract)

    def __mul__(self, other: Any) -> Any:
        return multiply(self, other) if type(other) is TracedNumber else _binary(self, other, multiply)

    def __rmul__(self, other: Any) -> Any:
        return _binary(other, self, multiply)

    def __truediv__(self, other: Any) -> Any:
        return _binary(self, other, divide)

    def __rtruediv__(self, other: Any) -> Any:
        return _binary(other, self, divide)

    def __pow__(self, exponent: Any, modulus: None = None) -> Any:
        return _binary(self, exponent, power)

    def __rpow__(self, base: Any) -> Any:
        return _binary(base, self, power)

    def __neg__(self) -> TracedNumber:
        return negative(self)

    def __pos__(self) -> TracedNumber:
        return self

    def __abs__(self) -> TracedNumber:
        return function("abs", self)

    # -- what only a number has --------------------------------------------------------------------------------------

    def number(self, what: str) -> Real:
        """Return the value of a node without symbols; raises Untraceable, naming what was asked, for any other."""
        if self.value is None:
            raise Untraceable("{what} depends on a joint variable or a length", what=what)
        return self.value

    def __float__(self) -> float:
        return float(self.number(Sentence("a float")))

    def __int__(self) -> int:
        return int(self.number(Sentence("an integer")))

    def __complex__(self) -> complex:
        return complex(self.number(Sentence("a complex number")))

    def __bool__(self) -> bool:
        return bool(self.number(Sentence("a condition")))

    def __round__(self, digits: int | None = None) -> Any:
        return round(self.number(Sentence("a rounded number")), digits)  # type: ignore[arg-type]

    def __lt__(self, other: Any) -> bool:
        return bool(self.number(Sentence("a comparison")) < as_traced(other).number(Sentence("a comparison")))

    def __eq__(self, other: object) -> bool:
        return other is self or bool(
            self.number(Sentence("a comparison")) == as_traced(other).number(Sentence("a comparison"))
        )

    def __ne__(self, other: object) -> bool:
        return not self == other

    __hash__ = object.__hash__

    def __repr__(self) -> str:
        if self.operation in ("constant", "symbol"):
            return str(self.arguments[0])
        return f"{self.operation}({', '.join(map(repr, self.arguments))})"

    def __format__(self, spec: str) -> str:
        return format(self.value, spec) if self.value is not None else self.operation

    def __copy__(self) -> TracedNumber:
        return self

    def __deepcopy__(self, memo: Any) -> TracedNumber:
        return self

    # -- what NumPy calls on the entries of an object array ------------------------------------------------------------

    @property
    def real(self) -> TracedNumber:
        """The number itself."""
        return self

    @property
    def imag(self) -> int:
        """Zero."""
        return 0

    def conjugate(self) -> TracedNumber:
        """Return the number itself."""
        return self

    def item(self) -> TracedNumber:
        """Return the number itself, as a NumPy scalar would return a float."""
        return self

    def __getattr__(self, name: str) -> Any:
        """Return the method that a NumPy function of that name looks for: x.cos(), y.arctan2(x), x.radians()."""
        found = METHODS.get(name)
        if found is None:
            raise AttributeError(f"a traced number has no '{name}'")
        return lambda *others: found(self, *others)


def symbol(name: str) -> TracedNumber:
    """Return a symbol: a joint variable or a length."""
    return TracedNumber("symbol", (name,))


def constant(value: Real) -> TracedNumber:
    """Return a constant."""
    return TracedNumber("constant", (value,), value)


ZERO, ONE = constant(0), constant(1)


def as_traced(value: Any) -> TracedNumber:
    """Return a node for a real number of any type; raises Untraceable for what is none."""
    if type(value) is TracedNumber:
        return value
    if type(value) is float and -_LARGEST < value < _LARGEST:
        return TracedNumber("constant", (value,), value)
    if isinstance(value, np.ndarray) and value.ndim == 0:
        return as_traced(value.item())
    if isinstance(value, np.generic):
        value = value.item()
    if isinstance(value, bool):
        return constant(int(value))
    if isinstance(value, int | Fraction):
        return constant(value)
    if isinstance(value, float):
        if not math.isfinite(value):
            _refuse(Sentence("the number {value}", value=str(value)))
        return constant(value)
    _refuse(Sentence("a {type} in a formula", type=type(value).__name__))


def _refuse(what: str) -> NoReturn:
    raise Untraceable("{what} cannot be traced", what=what)


def _binary(left: Any, right: Any, operation: Callable[[TracedNumber, TracedNumber], TracedNumber]) -> Any:
    if not (isinstance(left, _NUMBERS) and isinstance(right, _NUMBERS)):
        return NotImplemented
    return operation(as_traced(left), as_traced(right))


_NUMBERS = (TracedNumber, int, float, Fraction, np.generic)


def _is(node: TracedNumber, value: int) -> bool:
    return node.operation == "constant" and node.value == value


def add(a: TracedNumber, b: TracedNumber) -> TracedNumber:
    """Return a + b."""
    if a.is_constant and b.is_constant:
        return constant(a.value + b.value)  # type: ignore[operator]
    if _is(a, 0):
        return b
    if _is(b, 0):
        return a
    return TracedNumber("add", (a, b), _both(a, b, lambda x, y: x + y))


def subtract(a: TracedNumber, b: TracedNumber) -> TracedNumber:
    """Return a − b."""
    if a.is_constant and b.is_constant:
        return constant(a.value - b.value)  # type: ignore[operator]
    if _is(b, 0):
        return a
    if _is(a, 0):
        return negative(b)
    return TracedNumber("subtract", (a, b), _both(a, b, lambda x, y: x - y))


def negative(a: TracedNumber) -> TracedNumber:
    """Return −a."""
    if a.is_constant:
        return constant(-a.value)  # type: ignore[operator]
    if a.operation == "negative":
        return a.arguments[0]  # type: ignore[no-any-return]
    return TracedNumber("negative", (a,), None if a.value is None else -a.value)


def multiply(a: TracedNumber, b: TracedNumber) -> TracedNumber:
    """Return a b."""
    if a.is_constant and b.is_constant:
        return constant(a.value * b.value)  # type: ignore[operator]
    for one, other in ((a, b), (b, a)):
        if one.operation != "constant":
            continue
        if one.value == 0:
            return ZERO
        if one.value == 1:
            return other
        if one.value == -1:
            return negative(other)
    return TracedNumber("multiply", (a, b), _both(a, b, lambda x, y: x * y))


def divide(a: TracedNumber, b: TracedNumber) -> TracedNumber:
    """Return a/b; raises ZeroDivisionError where b is the number 0."""
    if _is(b, 1):
        return a
    if a.is_constant and b.is_constant:
        exact = isinstance(a.value, int | Fraction) and isinstance(b.value, int | Fraction)
        return constant(Fraction(a.value) / Fraction(b.value) if exact else a.value / b.value)  # type: ignore
    if b.value == 0:
        raise ZeroDivisionError("division by zero")
    return TracedNumber("divide", (a, b), _both(a, b, lambda x, y: x / y))


def power(a: TracedNumber, b: TracedNumber) -> TracedNumber:
    """Return a^b for an exponent b that is a whole number or a half."""
    exponent = b.number(Sentence("an exponent"))
    if a.is_constant:
        return constant(a.value**exponent)  # type: ignore
    whole = round(2 * exponent)
    if whole != 2 * exponent or abs(whole) > 64:
        _refuse(Sentence("the power {exponent}", exponent=str(exponent)))
    if whole % 2:
        return power(function("sqrt", a), constant(whole))
    if whole == 2:
        return a
    if whole == 0:
        return ONE
    return TracedNumber("power", (a, whole // 2), None if a.value is None else a.value**exponent)


def function(name: str, *arguments: Any) -> TracedNumber:
    """Return a function of FUNCTIONS; cos(0.3) stays a node of its own, so that it is no rounded number."""
    nodes = tuple(as_traced(argument) for argument in arguments)
    values = [node.value for node in nodes]
    if any(value is None for value in values):
        return TracedNumber(name, nodes)
    value = FUNCTIONS[name](*values)  # type: ignore[arg-type]
    if name in ("cos", "sin") and abs(2 * values[0] / math.pi - round(2 * values[0] / math.pi)) < _NEARLY:  # type: ignore
        return constant(round(value))
    if value == 0 or abs(value) == 1:
        return constant(round(value))
    return TracedNumber(name, nodes, value)


def _both(a: TracedNumber, b: TracedNumber, operation: Callable[[Any, Any], Real]) -> Real | None:
    return None if a.value is None or b.value is None else operation(a.value, b.value)
