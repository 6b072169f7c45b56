"""Arrays of traced numbers, and the linear algebra that NumPy does not do on arrays of objects."""

from __future__ import annotations

from functools import reduce
from typing import Any

import numpy as np

from armproof.verification.algebra.matrix import Matrix
from armproof.verification.functions.tracing.number import (
    ZERO,
    TracedNumber,
    Untraceable,
    as_traced,
    function,
    multiply,
)

MOST_ROWS = 6


class TracedArray(np.ndarray):
    """An array of traced numbers and floats, of dtype object; `astype(float)` keeps its symbols."""

    def astype(self, dtype: Any, *args: Any, **kwargs: Any) -> Any:
        """Return a copy: of the same symbols where floats are asked for."""
        return self.copy() if is_float(dtype) and self.dtype == object else super().astype(dtype, *args, **kwargs)


def is_float(dtype: Any) -> bool:
    """Whether a dtype argument asks for real numbers."""
    if dtype is None or dtype is object:
        return False
    if isinstance(dtype, type) and issubclass(dtype, float):
        return True
    try:
        return np.dtype(dtype).kind == "f"
    except TypeError:
        return False


def as_objects(value: Any) -> Any:
    """Return an array of floats as one that can hold symbols; anything else as it is."""
    if isinstance(value, np.matrix):
        return value.astype(object) if value.dtype.kind == "f" else value  # its product is another
    if isinstance(value, np.ndarray) and value.dtype.kind == "f":
        return value.astype(object).view(TracedArray)
    if isinstance(value, np.ndarray) and value.dtype == object and type(value) is np.ndarray:
        return value.view(TracedArray)
    return value


def holds_symbols(value: Any) -> bool:
    """Whether an argument is, or holds, a traced number that is not a plain one."""
    if isinstance(value, TracedNumber):
        return True
    if isinstance(value, np.ndarray):
        return value.dtype == object and any(isinstance(item, TracedNumber) for item in value.flat)
    return isinstance(value, list | tuple) and any(holds_symbols(item) for item in value)


def as_floats(value: Any) -> Any:
    """Return an array of objects that are all plain numbers as an array of floats."""
    if isinstance(value, np.ndarray) and value.dtype == object:
        return np.array(value.tolist(), dtype=float)
    return value


def _square(matrix: Any) -> np.ndarray:
    rows = np.asarray(matrix, dtype=object)
    if rows.ndim != 2 or rows.shape[0] != rows.shape[1]:
        raise np.linalg.LinAlgError("Last 2 dimensions of the array must be square")
    if len(rows) > MOST_ROWS:
        raise Untraceable("the determinant of a {rows_given}×{rows_given} matrix is not traced", rows_given=len(rows))
    return rows


def det(matrix: Any) -> TracedNumber:
    """Return the determinant."""
    return as_traced(_matrix(_square(matrix)).determinant())


def _matrix(rows: np.ndarray) -> Matrix:
    return Matrix(tuple(tuple(map(as_traced, row)) for row in rows))


def inv(matrix: Any) -> np.ndarray:
    """Return the inverse: of a homogeneous transform block by block, of any other by its adjugate."""
    rows = _square(matrix)
    if rows.shape == (4, 4) and [as_traced(cell).value for cell in rows[3]] == [0, 0, 0, 1]:
        inverse = as_objects(np.eye(4))
        inverse[:3, :3] = inv(rows[:3, :3])
        inverse[:3, 3] = -(inverse[:3, :3] @ rows[:3, 3])
        return inverse  # type: ignore[no-any-return]
    return np.array(_matrix(rows).adjugate().rows, dtype=object).view(TracedArray) / det(rows)


def solve(matrix: Any, right: Any) -> Any:
    """Return the solution x of A x = b."""
    return inv(matrix) @ np.asarray(right, dtype=object)


def norm(vector: Any, ord: Any = None, axis: Any = None, keepdims: bool = False) -> TracedNumber:
    """Return the Euclidean norm of all entries."""
    if ord not in (None, 2, "fro") or axis is not None or keepdims:
        raise Untraceable("a norm of another kind than the Euclidean one is not traced")
    if ord == 2 and np.ndim(vector) != 1:
        raise Untraceable("the spectral norm is not traced")
    total = ZERO
    for cell in np.asarray(vector, dtype=object).flat:
        total = total + multiply(as_traced(cell), as_traced(cell))
    return function("sqrt", total)


def matrix_power(matrix: Any, exponent: int) -> np.ndarray:
    """Return an integer power of a square matrix."""
    rows = _square(matrix)
    base: np.ndarray = inv(rows) if exponent < 0 else rows
    return reduce(np.matmul, [base] * abs(exponent), as_objects(np.eye(len(rows))))


def multi_dot(matrices: Any) -> Any:
    """Return the product of matrices, from the left."""
    return reduce(np.matmul, (np.asarray(matrix, dtype=object) for matrix in matrices))
