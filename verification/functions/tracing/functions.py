"""The functions of one number, or of two, by the names that NumPy has for them."""

from __future__ import annotations

import math
from typing import Any

from armproof.verification.functions.tracing.number import (
    METHODS,
    ONE,
    ZERO,
    TracedNumber,
    add,
    as_traced,
    constant,
    divide,
    function,
    multiply,
)


def hypot(*legs: Any) -> TracedNumber:
    """Return the square root of the sum of squares."""
    total = ZERO
    for leg in legs:
        total = add(total, multiply(as_traced(leg), as_traced(leg)))
    return function("sqrt", total)


def radians(degrees: Any) -> TracedNumber:
    """Return degrees in radians."""
    return multiply(as_traced(degrees), constant(math.pi / 180))


def degrees(angle: Any) -> TracedNumber:
    """Return radians in degrees."""
    return multiply(as_traced(angle), constant(180 / math.pi))


METHODS |= {
    **{name: lambda *x, _name=name: function(_name, *x) for name in ("cos", "sin", "tan", "sqrt")},
    "arccos": lambda x: function("acos", x),
    "arcsin": lambda x: function("asin", x),
    "arctan": lambda x: function("atan", x),
    "arctan2": lambda y, x: function("atan2", y, x),
    "fabs": lambda x: function("abs", x),
    "hypot": hypot,
    "radians": radians,
    "deg2rad": radians,
    "degrees": degrees,
    "rad2deg": degrees,
    "square": lambda x: multiply(as_traced(x), as_traced(x)),
    "reciprocal": lambda x: divide(ONE, as_traced(x)),
}
