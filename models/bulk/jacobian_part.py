"""A part of a Jacobian: the rows and columns of a task, such as the velocity in the plane of a planar arm."""

from __future__ import annotations

import operator
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations
from math import comb

from armproof.models.arm import Arm
from armproof.models.bulk.graph import ONE, Graph, Matrix, Term
from armproof.models.errors import Fault, ModelError


def maximal_minors(graph: Graph, matrix: Matrix) -> list[Term]:
    """Return the maximal minors of a matrix of terms with no more rows than columns.

    They are expanded along their rows, from the last row up, so that they share their smaller minors; zeros are skipped.
    """
    height, width = len(matrix), len(matrix[0])
    minors: dict[tuple[int, ...], Term] = {(): ONE}

    def minor(columns: tuple[int, ...]) -> Term:
        """Return the minor of the given columns and as many of the last rows."""
        if columns not in minors:
            row = matrix[height - len(columns)]
            parts = []
            for place, column in enumerate(columns):
                if row[column].factor:
                    below = minor((*columns[:place], *columns[place + 1 :]))
                    parts.append(graph.scale(graph.multiply(row[column], below), (-1) ** place))
            minors[columns] = graph.add(*parts)
        return minors[columns]

    return [minor(columns) for columns in combinations(range(width), height)]


@dataclass(frozen=True)
class JacobianPart:
    """Rows and columns of the geometric Jacobian [v; ω] of a frame, expressed in the axes of another, both from 0."""

    frame: str
    expressed_in: str
    rows: tuple[int, ...]
    columns: tuple[int, ...]

    @property
    def size(self) -> tuple[int, int]:
        """The smaller and the larger of the numbers of rows and columns."""
        return min(len(self.rows), len(self.columns)), max(len(self.rows), len(self.columns))

    @property
    def maximal_minors(self) -> int:
        """The number of minors that have as many rows, or as many columns, as the part."""
        return comb(max(self.size), min(self.size))

    def of_terms(self, J: Matrix) -> Matrix:
        """Return the part of a 6×n Jacobian of terms, transposed if it has more rows than columns."""
        part = [[J[row][column] for column in self.columns] for row in self.rows]
        return part if len(self.rows) <= len(self.columns) else [list(column) for column in zip(*part, strict=True)]


def read_part(
    arm: Arm,
    frame: str,
    rows: Sequence[int] | None = None,
    columns: Sequence[int] | None = None,
    expressed_in: str | None = None,
) -> JacobianPart:
    """Return the part of the Jacobian of a frame with rows and columns counted from 1, all of them where none are given.

    Raises:
        ModelError: the arm has no such frame, row or column, or one is named twice.
    """
    frame, expressed_in = arm.frame_names(frame, expressed_in)
    return JacobianPart(frame, expressed_in, _indices("rows", rows, 6), _indices("columns", columns, len(arm.joints)))


def _indices(what: str, indices: Sequence[int] | None, most: int) -> tuple[int, ...]:
    """Return the rows or columns meant, counted from 0."""
    if indices is None:
        return tuple(range(most))
    try:
        chosen = [index - 1 for index in map(operator.index, indices)]
    except TypeError:
        chosen = []
    if not chosen or len(set(chosen)) < len(chosen) or min(chosen) < 0 or max(chosen) >= most:
        raise ModelError(Fault.NOT_DIFFERENT_NUMBERS, what=what, most=most, given=repr(indices))
    return tuple(chosen)
