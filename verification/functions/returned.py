"""What a function returned, as arrays of floats of the shape that its quantity has."""

from __future__ import annotations

import warnings
from dataclasses import dataclass
from typing import Any

import numpy as np

from armproof.models.errors import ArmproofError, Sentence, written
from armproof.verification.findings import Kind


class NotNumbers(ArmproofError):
    """A function returned something that is no number, vector or matrix."""

    kind = Kind.NO_NUMBERS


class NotAttempted(ArmproofError):
    """A function is a stub: it returns nothing."""

    kind = Kind.NOT_ATTEMPTED


@dataclass(frozen=True)
class Fitted:
    """A result in the shape of its quantity, and what was taken for granted to bring it there."""

    values: np.ndarray
    note: str = ""


def read_returned(value: Any, count: int) -> list[np.ndarray]:
    """Return the arrays of a result: `count` of them.

    Raises:
        NotAttempted: None or an ellipsis stands where a result is expected.
        NotNumbers: the result holds no numbers, or is another number of matrices.
    """
    if count == 1:
        if isinstance(value, tuple) and len(value) == 1 and np.ndim(value[0]) == 2:
            value = value[0]
        return [_read_array(value)]
    if _is_stub(value):
        raise NotAttempted("the function returns nothing yet")
    try:
        items = list(value)
    except TypeError:
        items = []
    if len(items) != count:
        found = f"{len(items)} values" if items else f"a {type(value).__name__}"
        raise NotNumbers("the function returns {found}; it is to return {count}, one a quantity", found=found, count=count)  # fmt: skip
    return [_read_array(item) for item in items]


def _is_stub(value: Any) -> bool:
    return value is None or value is Ellipsis or value is NotImplemented


def _read_array(value: Any) -> np.ndarray:
    if _is_stub(value) or (isinstance(value, list | tuple) and value and all(_is_stub(item) for item in value)):
        raise NotAttempted("the function returns nothing yet")
    for method in ("GetAsMatrix4", "as_matrix"):  # Drake's RigidTransform, SciPy's Rotation
        if hasattr(value, method):
            value = getattr(value, method)()
    if type(value).__name__ == "RotationMatrix" and hasattr(value, "matrix"):
        value = value.matrix()
    if isinstance(value, str | bytes | dict | set) or callable(value):
        raise NotNumbers("the function returns a {type}, not a number, a vector or a matrix", type=type(value).__name__)
    if not isinstance(value, np.ndarray) and hasattr(value, "tolist") and hasattr(value, "shape"):
        value = value.tolist()  # a matrix of SymPy's
    return _as_floats(_stacked(value))


def _stacked(value: Any) -> np.ndarray:
    """Return nested lists, or rows that are themselves arrays, as one array."""
    try:
        return np.asarray(value)
    except ValueError:
        raise NotNumbers("the function returns rows of different lengths") from None
    except OverflowError as problem:
        raise NotNumbers("the function returns what is no number: {reason}", reason=problem) from None


def _as_floats(array: np.ndarray) -> np.ndarray:
    if array.dtype.kind not in "fiubcO":
        raise NotNumbers("the function returns {dtype} values, not numbers", dtype=array.dtype)
    try:
        if array.dtype == object:
            array = np.array([_as_complex(item) for item in array.ravel()]).reshape(array.shape)
    except (TypeError, ValueError, OverflowError) as problem:
        raise NotNumbers("the function returns what is no number: {reason}", reason=problem) from None
    if array.dtype.kind == "c":
        with np.errstate(all="ignore"), warnings.catch_warnings():
            largest = np.max(np.abs(array.imag), initial=0.0)
        if largest > 1e-12:
            raise NotNumbers("the function returns complex numbers; the entries are real")
        array = array.real
    with np.errstate(over="ignore"):  # a long double of more than a double holds
        return np.array(array, dtype=float)


def _as_complex(item: Any) -> complex:
    return complex(item.Evaluate() if hasattr(item, "Evaluate") else item)  # an expression of Drake's without variables


def fit(values: np.ndarray, shape: tuple[int, int]) -> Fitted | None:
    """Return a result in the shape (rows, columns) of its quantity; None where it has another number of entries.

    A vector may be flat, a column or a row; a point may have its fourth coordinate 1.
    """
    rows, columns = shape
    is_flat = 1 in shape and values.shape == (rows * columns,)
    if values.shape == shape or is_flat or (shape == (1, 1) and values.size == 1):
        return Fitted(values.reshape(shape))
    if columns == 1 and values.shape == (1, rows):
        return Fitted(values.reshape(shape), written("the vector is returned as a row"))
    if shape == (3, 1) and values.shape in ((4,), (4, 1)) and values.ravel()[3] in (0.0, 1.0):
        return Fitted(values.ravel()[:3].reshape(shape), written("the vector is returned in homogeneous coordinates"))
    return None


def shape_words(values: np.ndarray) -> str:
    """Return the shape of a result as one says it: 3×4, a vector of 3, a number."""
    if values.ndim == 0:
        return Sentence("a number")
    if values.ndim == 1:
        return Sentence("a vector of {size}", size=values.size)
    return "×".join(map(str, values.shape))
