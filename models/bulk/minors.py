"""Determinants of matrices of terms: the volume that the rows of a matrix span."""

from __future__ import annotations

from itertools import combinations

from armproof.models.bulk.graph import ONE, Graph, Matrix, Term


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
