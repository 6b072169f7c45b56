"""The formula of a Python function: what it computes, entry by entry, with symbols for its arguments."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from armproof.verification.functions.tracing.expressions import FromDrake, FromSympy, sympy_is_loaded
from armproof.verification.functions.tracing.number import TracedNumber, Untraceable, as_traced, symbol
from armproof.verification.functions.tracing.rebuild import rebuild

# Calls a function with the arguments that it takes, each made from the name of its symbol; returns what it returns.
Caller = Callable[[Callable[..., Any], Callable[[str], Any]], Any]


def trace_function(function: Callable[..., Any], call: Caller) -> Any:
    """Return the formulas that a function computes.

    The function is called with symbols: with traced numbers, on stand-ins for `math` and NumPy; where that fails with
    Drake's symbolic expressions; where that fails and SymPy is in use, with SymPy's symbols. The function, its module and
    what it refers to stay untouched.

    Args:
        function: anything that can be called.
        call: makes the call, see Caller.

    Returns:
        what the function returns, arrays and nested lists, with a TracedNumber for each number.

    Raises:
        Untraceable: the function branches on a value of its arguments, draws random numbers, or calls what takes no
            symbols; the message says what the first attempt met.
    """
    routes: list[Callable[[], Any]] = [lambda: _map(call(rebuild(function), symbol), as_traced)]
    routes += [lambda: _by_expressions(function, call, FromSympy)] if sympy_is_loaded() else []
    routes.append(lambda: _by_expressions(function, call, FromDrake))
    first: Exception | None = None
    for route in routes:
        try:
            return route()
        except Exception as problem:  # whatever a function does with symbols, it is not what it does with numbers
            first = first or problem
    text, *_ = str(first).splitlines() or [""]
    reason = text if isinstance(first, Untraceable) else f"{type(first).__name__}: {text}"
    raise Untraceable(reason) from None


def _by_expressions(function: Callable[..., Any], call: Caller, kind: type[FromDrake | FromSympy]) -> Any:
    route = kind()
    return _map(call(function, route.variable), route.convert)


def _map(value: Any, convert: Callable[[Any], TracedNumber]) -> Any:
    """Return a number, an array or a nested list with each number converted."""
    if isinstance(value, list | tuple) or hasattr(value, "__next__"):
        items = [_map(item, convert) for item in value]
        return tuple(items) if isinstance(value, tuple) else items
    if not isinstance(value, np.ndarray) and hasattr(value, "tolist") and hasattr(value, "shape"):
        value = np.array(value.tolist(), dtype=object).reshape(value.shape)  # a matrix of SymPy's
    if isinstance(value, np.ndarray):
        value = np.asarray(value)  # a np.matrix stays two-dimensional whatever is done to it
        flat = [convert(item) for item in value.ravel()]
        array = np.empty(len(flat), dtype=object)
        array[:] = flat
        return array.reshape(value.shape)
    return convert(value)
