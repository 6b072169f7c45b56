"""Link matrices with one wrong entry: a sign, a sine for a cosine. What would be a DH link with that entry mended is none as printed."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from armproof.verification.algebra.calculus import derivative
from armproof.verification.algebra.matrix import Matrix
from armproof.verification.algebra.ring import Scalar


def mended(matrix: Matrix, angles: Sequence[str]) -> Iterator[Matrix]:
    """Yield a printed pose with another sign in one entry, or with the other function of an angle there."""
    ring = matrix.rows[0][0].ring
    for place in ((r, c) for r, c in matrix.places if r < 3):
        entry = matrix.rows[place[0]][place[1]]
        turned = [derivative(entry, ring.symbol(angle)).normal() for angle in angles]
        others = [-entry, *(sign * each for each in turned for sign in (1, -1))]
        yield from (_with(matrix, place, other) for other in others if not other.is_zero())


def _with(matrix: Matrix, place: tuple[int, int], entry: Scalar) -> Matrix:
    """Return a matrix with another entry at a place."""
    rows = [[entry if (r, c) == place else cell for c, cell in enumerate(row)] for r, row in enumerate(matrix.rows)]
    return Matrix(tuple(map(tuple, rows)))
