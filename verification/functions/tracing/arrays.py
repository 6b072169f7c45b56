"""Arrays of traced numbers, and the linear algebra that NumPy does not do on arrays of objects."""

from __future__ import annotations

from itertools import combinations
from typing import Any

import numpy as np

from armproof.verification.functions.tracing.number import (
    ONE,
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
    """Return the determinant, by expansion over column subsets."""
    rows = _square(matrix)
    size = len(rows)
    minors: dict[tuple[int, ...], TracedNumber] = {(): ONE}
    for count in range(1, size + 1):
        row = rows[count - 1]
        minors = {columns: _expand(row, columns, minors) for columns in combinations(range(size), count)}
    return minors[tuple(range(size))]


def _expand(row: np.ndarray, columns: tuple[int, ...], minors: dict[tuple[int, ...], TracedNumber]) -> TracedNumber:
    total = ZERO
    for place, column in enumerate(columns):
        rest = columns[:place] + columns[place + 1 :]
        term = multiply(as_traced(row[column]), minors[rest])
        total = total + term if (len(columns) - 1 + place) % 2 == 0 else total - term
    return total


def inv(matrix: Any) -> np.ndarray:
    """Return the inverse: of a homogeneous transform block by block, of any other by its adjugate."""
    rows = _square(matrix)
    if rows.shape == (4, 4) and [_plain(cell) for cell in rows[3]] == [0, 0, 0, 1]:
        inverse = as_objects(np.eye(4))
        inverse[:3, :3] = inv(rows[:3, :3])
        inverse[:3, 3] = -(inverse[:3, :3] @ rows[:3, 3])
        return inverse  # type: ignore[no-any-return]
    size, determinant = len(rows), det(rows)
    inverse = np.empty((size, size), dtype=object).view(TracedArray)
    for r in range(size):
        for c in range(size):
            minor = det(np.delete(np.delete(rows, r, 0), c, 1))
            inverse[c, r] = (minor if (r + c) % 2 == 0 else -minor) / determinant
    return inverse


def _plain(cell: Any) -> Any:
    return as_traced(cell).value


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
    base = inv(rows) if exponent < 0 else rows
    result: np.ndarray = as_objects(np.eye(len(rows)))
    for _ in range(abs(exponent)):
        result = result @ base
    return result


def multi_dot(matrices: Any) -> Any:
    """Return the product of matrices, from the left."""
    product, *rest = [np.asarray(matrix, dtype=object) for matrix in matrices]
    for matrix in rest:
        product = product @ matrix
    return product
