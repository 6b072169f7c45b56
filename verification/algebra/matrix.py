"""Matrices of any scalar that adds and multiplies, exact or sampled; lists that stand for columns, identities without a size."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from functools import cached_property
from itertools import chain, product
from typing import Any

from armproof.verification.errors import EvaluationError, ShapeError
from armproof.verification.findings import Kind, say

Cell = Any  # a Scalar of the exact ring, or a NumPy array over the samples


@dataclass(frozen=True)
class Matrix:
    """Rows of scalars, at least 1×1."""

    rows: tuple[tuple[Cell, ...], ...]

    @cached_property
    def shape(self) -> tuple[int, int]:
        """(number of rows, number of columns)."""
        return len(self.rows), len(self.rows[0])

    @property
    def size(self) -> str:
        """The shape as one says it: 4×4."""
        return f"{self.shape[0]}×{self.shape[1]}"

    @property
    def cells(self) -> tuple[Cell, ...]:
        """The entries, row by row."""
        return tuple(chain.from_iterable(self.rows))

    @property
    def places(self) -> Iterator[tuple[int, int]]:
        """The row and the column (from 0) of each of its cells."""
        return product(range(self.shape[0]), range(self.shape[1]))

    def map(self, function: Callable[[Cell], Cell]) -> Matrix:
        """Apply a function to every entry."""
        return Matrix(tuple(tuple(function(cell) for cell in row) for row in self.rows))

    def block(self, rows: Iterable[int], columns: Iterable[int]) -> Matrix:
        """Return the entries at these rows and columns (counted from 0)."""
        columns = tuple(columns)
        return Matrix(tuple(tuple(self.rows[r][c] for c in columns) for r in rows))

    @property
    def transpose(self) -> Matrix:
        """The transposed matrix."""
        return Matrix(tuple(zip(*self.rows, strict=True)))

    def __add__(self, other: Matrix) -> Matrix:
        if self.shape != other.shape:
            raise ShapeError(say(Kind.SUM_OF_SIZES, one=self.size, other=other.size))
        return Matrix(
            tuple(tuple(a + b for a, b in zip(r, s, strict=True)) for r, s in zip(self.rows, other.rows, strict=True))
        )

    def __neg__(self) -> Matrix:
        return self.map(lambda cell: -cell)

    def __matmul__(self, other: Matrix) -> Matrix:
        if self.shape[1] != other.shape[0]:
            homogeneous = (self.shape, other.shape) == ((4, 4), (3, 1))
            kind = EvaluationError if homogeneous else ShapeError
            said = Kind.PRODUCT_OF_POSE if homogeneous else Kind.PRODUCT_OF_SIZES
            raise kind(say(said, one=self.size, other=other.size))
        columns = other.transpose.rows
        return Matrix(tuple(tuple(_dot(row, column) for column in columns) for row in self.rows))

    def cross(self, other: Matrix) -> Matrix:
        """Return the cross product of two 3-vectors."""
        a, b = self.vector(3), other.vector(3)
        return column([a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]])

    def vector(self, length: int | None = None) -> tuple[Cell, ...]:
        """Return the entries of a row or a column."""
        if 1 not in self.shape or (length is not None and max(self.shape) != length):
            if length:
                raise EvaluationError(say(Kind.NO_VECTOR_OF_LENGTH, length=length, size=self.size))
            raise EvaluationError(say(Kind.NO_VECTOR, size=self.size))
        return self.cells

    def minors(self, rows: tuple[int, ...]) -> dict[tuple[int, ...], Cell]:
        """Return the determinants of the given rows with every choice of as many columns, by columns."""
        found: dict[tuple[int, ...], Cell] = {(c,): self.rows[rows[0]][c] for c in range(self.shape[1])}
        for row in rows[1:]:
            grown: dict[tuple[int, ...], Cell] = {}
            for columns, minor in found.items():
                for c in range(self.shape[1]):
                    if c in columns:
                        continue
                    chosen = tuple(sorted((*columns, c)))
                    after = sum(1 for other in columns if other > c)
                    term = self.rows[row][c] * minor
                    term = -term if after % 2 else term
                    grown[chosen] = grown[chosen] + term if chosen in grown else term
            found = grown
        return found

    def determinant(self) -> Cell:
        """Return the determinant, by expansion over column subsets (exact in any ring, no division)."""
        size, width = self.shape
        if size != width:
            raise ShapeError(say(Kind.NO_DETERMINANT, size=self.size))
        if size > 8:
            raise EvaluationError(say(Kind.LARGE_DETERMINANT, size=self.size))
        return self.minors(tuple(range(size)))[tuple(range(size))]

    def adjugate(self) -> Matrix:
        """Return the transposed matrix of cofactors."""
        return self.cofactors().transpose

    def cofactors(self) -> Matrix:
        """Return the comatrix: the matrix of cofactors."""
        size, width = self.shape
        if size != width:
            raise ShapeError(say(Kind.NO_COFACTORS, size=self.size))
        if size > 7:
            raise EvaluationError(say(Kind.LARGE_COFACTORS, size=self.size))
        if size == 1:
            return Matrix(((self.rows[0][0] * 0 + 1,),))
        everything = range(size)
        rows = []
        for r in everything:
            others = tuple(row for row in everything if row != r)
            minors = self.minors(others)
            row = [minors[tuple(c for c in everything if c != k)] for k in everything]
            rows.append(tuple(-cell if (r + k) % 2 else cell for k, cell in enumerate(row)))
        return Matrix(tuple(rows))


def _dot(row: Iterable[Cell], column_: Iterable[Cell]) -> Cell:
    total = None
    for a, b in zip(row, column_, strict=True):
        total = a * b if total is None else total + a * b
    return total


def inverse_pose(pose: Matrix) -> Matrix:
    """Return the inverse of a pose, [R^T, -R^T p; 0, 1], without dividing."""
    turned = pose.block(range(3), range(3)).transpose
    back = -(turned @ pose.block(range(3), [3]))
    return pose_of(turned, back, *pose.rows[3][2:])


def pose_of(rotation: Matrix, origin: Matrix, zero: Cell, one: Cell) -> Matrix:
    """Return the pose [R, p; 0, 1], 4×4, of a rotation and the column of an origin."""
    rows = ((*row, *cell) for row, cell in zip(rotation.rows, origin.rows, strict=True))
    return Matrix((*rows, (zero, zero, zero, one)))


def column(cells: Iterable[Cell]) -> Matrix:
    """Return a column vector."""
    return Matrix(tuple((cell,) for cell in cells))


def exact_rank(matrix: Matrix) -> int:
    """Return the rank over the field of quotients: the size of the largest minor that is not zero (bordering)."""
    size, width = matrix.shape
    largest: tuple[tuple[int, ...], tuple[int, ...]] | None = (), ()
    while largest is not None:
        rows, columns = largest
        largest = next(
            (
                ((*rows, r), (*columns, c))
                for r in range(size)
                if r not in rows
                for c in range(width)
                if c not in columns and not matrix.block((*rows, r), (*columns, c)).determinant().is_zero()
            ),
            None,
        )
    return len(rows)


@dataclass(frozen=True)
class Identity:
    """An identity matrix times a scalar, as in λ²I, whose size is left to its surroundings."""

    scale: Any


def no_size() -> Any:
    """Refuse an identity matrix of unknown size where the size matters."""
    raise EvaluationError(say(Kind.IDENTITY_OF_NO_SIZE))


def stacked(value: Any) -> Any:
    """Return a list of values as the column that it stands for."""
    if not isinstance(value, list):
        return value
    if any(isinstance(cell, Matrix | Identity | list) for cell in value):
        raise EvaluationError(say(Kind.MATRICES_FOR_VALUE))
    return column(value)


def sized(value: Any) -> Any:
    """Return a value of which the size is known."""
    return no_size() if isinstance(value, Identity) else stacked(value)


def as_scalar(value: Any) -> Any:
    """Return the entry of a 1×1 matrix, anything else as it is."""
    return value.rows[0][0] if isinstance(value, Matrix) and value.shape == (1, 1) else value


def as_matrix(value: Any) -> Matrix:
    """Return a scalar as a 1×1 matrix, a matrix as it is."""
    return value if isinstance(value, Matrix) else Matrix(((value,),))


def is_zero(value: Any) -> bool:
    """Whether a scalar of either algebra, or a matrix of such, vanishes everywhere."""
    if isinstance(value, Matrix):
        return all(map(is_zero, value.cells))
    if hasattr(value, "is_zero"):
        return bool(value.is_zero())
    return bool((value == 0).all())
