"""What stands for `math` and `numpy` while a function is traced: the same names, but open to symbols."""

from __future__ import annotations

import builtins
import functools
import math
import types
from collections.abc import Callable
from typing import Any

import numpy as np

import armproof.verification.functions.tracing.arrays as arrays
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
    power,
)

_CREATE = (
    "array asarray asanyarray ascontiguousarray asfarray zeros ones empty full eye identity zeros_like ones_like empty_like"
    " full_like diag diagflat copy matrix asmatrix mat block hstack vstack dstack stack column_stack concatenate append"
    " insert tile repeat linspace arange atleast_1d atleast_2d"
).split()
_SAME = {"acos": "arccos", "asin": "arcsin", "atan": "arctan", "atan2": "arctan2", "absolute": "fabs", "abs": "fabs"}
_OF_MATH = "cos sin tan acos asin atan atan2 sqrt fabs radians degrees".split()


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


class Replacements:
    """The stand-ins for modules, functions and built-ins, by the identity of what they stand for."""

    def __init__(self) -> None:
        self._by_id: dict[int, Any] = {}
        self._kept: list[Any] = []  # an id stays valid while its object lives
        linalg = self._module(
            np.linalg,
            {name: _linear(getattr(np.linalg, name), getattr(arrays, name)) for name in
             ("det", "inv", "norm", "solve", "matrix_power", "multi_dot")},
        )  # fmt: skip
        functions: dict[str, Any] = {name: _elementwise(name) for name in METHODS}
        functions |= {name: _elementwise(same) for name, same in _SAME.items() if hasattr(np, name)}
        functions |= {name: _creating(getattr(np, name)) for name in _CREATE if hasattr(np, name)}
        functions |= {"float64": traced_float, "power": np.frompyfunc(_power, 2, 1), "linalg": linalg}
        self.numpy = self._module(np, functions)
        ours = {name: _scalar(METHODS[_SAME.get(name, name)]) for name in _OF_MATH}
        ours |= {"hypot": hypot, "pow": _power, "fsum": sum, "prod": _product, "dist": _distance}
        self.math = self._module(math, ours)
        self.builtins = {**vars(builtins), "float": traced_float, "__import__": self._import}
        self._remember(float, traced_float)

    def find(self, value: Any) -> Any | None:
        """Return what stands for a value, or None."""
        return self._by_id.get(id(value))

    def _remember(self, value: Any, replacement: Any) -> None:
        self._by_id[id(value)] = replacement
        self._kept.append(value)

    def _module(self, module: types.ModuleType, replaced: dict[str, Any]) -> types.ModuleType:
        stand_in = _Module(module, replaced)
        self._remember(module, stand_in)
        for name, replacement in replaced.items():
            if name != "linalg":
                self._remember(getattr(module, name), replacement)
        return stand_in

    def _import(self, name: str, *args: Any, **kwargs: Any) -> Any:
        found = builtins.__import__(name, *args, **kwargs)
        replacement = self.find(found)
        return found if replacement is None else replacement


class _Module(types.ModuleType):
    """A module of which some names are replaced."""

    def __init__(self, module: types.ModuleType, replaced: dict[str, Any]) -> None:
        super().__init__(module.__name__)
        self.__dict__.update(replaced)
        self.__dict__["_original"] = module

    def __getattr__(self, name: str) -> Any:
        return getattr(self.__dict__["_original"], name)


class _FloatType(type):
    def __instancecheck__(cls, instance: Any) -> bool:
        return isinstance(instance, float | TracedNumber)


class traced_float(float, metaclass=_FloatType):
    """The built-in float, which leaves a symbol as it is."""

    def __new__(cls, value: Any = 0.0) -> Any:
        """Return the number itself where it is traced."""
        if isinstance(value, np.ndarray) and value.dtype == object and value.size == 1:
            value = value.item()
        return value if isinstance(value, TracedNumber) else float(value)


def _scalar(method: Callable[..., TracedNumber]) -> Callable[..., TracedNumber]:
    def call(*arguments: Any) -> TracedNumber:
        return method(*(a.item() if isinstance(a, np.ndarray) else a for a in arguments))

    return call


def _elementwise(name: str) -> Any:
    """Return a NumPy function that takes each number by itself."""
    method = METHODS[name]
    two = name in ("arctan2", "hypot")
    ufunc = np.frompyfunc(
        (lambda y, x: method(as_traced(y), x)) if two else (lambda x: method(as_traced(x))), 1 + two, 1
    )

    def call(*arguments: Any) -> Any:
        return arrays.as_objects(ufunc(*arguments))

    return call


def _creating(original: Any) -> Any:
    """Return a function that makes arrays, open to symbols: of floats it makes arrays of objects."""

    @functools.wraps(original, updated=())
    def call(*args: Any, **kwargs: Any) -> Any:
        wanted = kwargs.get("dtype")
        floats = arrays.is_float(wanted)
        if floats:
            kwargs = {**kwargs, "dtype": object}
        elif any(arrays.is_float(arg) for arg in args[1:] if isinstance(arg, type | np.dtype)):
            args = tuple(object if isinstance(arg, type | np.dtype) and arrays.is_float(arg) else arg for arg in args)
        return arrays.as_objects(original(*args, **kwargs))

    return call


def _linear(original: Any, traced: Any) -> Any:
    """Return a function of linear algebra: of symbols, or else of floats as it was."""

    @functools.wraps(original)
    def call(*args: Any, **kwargs: Any) -> Any:
        if any(arrays.holds_symbols(arg) for arg in args):
            return traced(*args, **kwargs)
        return arrays.as_objects(original(*(arrays.as_floats(arg) for arg in args), **kwargs))

    return call


def _power(base: Any, exponent: Any) -> TracedNumber:
    return power(as_traced(base), as_traced(exponent))


def _product(values: Any, *, start: Any = 1) -> Any:
    for value in values:
        start = start * value
    return start


def _distance(p: Any, q: Any) -> TracedNumber:
    return hypot(*(a - b for a, b in zip(p, q, strict=True)))
