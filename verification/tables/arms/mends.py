"""Link matrices with one wrong entry, or two rows or columns exchanged: what would be a DH link with that mended is none as printed."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations

from armproof.verification.algebra.calculus import derivative, substitute, symbols_in
from armproof.verification.algebra.matrix import Matrix
from armproof.verification.algebra.ring import Scalar

_LAST = (0, 0, 0, 1)


def mended(matrix: Matrix, angles: Sequence[str]) -> Iterator[Matrix]:
    """Yield a printed pose with one other entry: another sign, the other function, another angle or letter, 0 or ±1 for a number.

    Behind them, with two of its first three rows, or columns, exchanged.
    """
    letters = sorted(symbols_in(cell.normal() for cell in matrix.cells) - {*angles})
    for r, c in matrix.places:
        entry = matrix.rows[r][c]
        others = _others(entry, angles, letters) if r < len(_LAST) - 1 else (entry.ring.rational(_LAST[c]),)
        yield from (_with(matrix, (r, c), other) for other in others if not (other - entry).is_zero())
    for one, other in combinations(range(len(_LAST) - 1), 2):
        order = [{one: other, other: one}.get(k, k) for k in range(len(_LAST))]
        yield Matrix(tuple(matrix.rows[r] for r in order))
        yield Matrix(tuple(tuple(row[c] for c in order) for row in matrix.rows))


def _others(entry: Scalar, angles: Sequence[str], letters: Sequence[str]) -> Iterator[Scalar]:
    """Yield what a slip may have made of another entry."""
    ring = entry.ring
    if entry.as_fraction() is not None:
        yield from map(ring.rational, (0, 1, -1))
        return
    yield -entry
    for angle in angles:
        turned = derivative(entry, ring.symbol(angle)).normal()
        yield from (sign * turned for sign in (1, -1) if not turned.is_zero())
    for names in (angles, letters):
        for name in names:
            own = [other for other in names if other != name and other in symbols_in([entry.normal()])]
            yield from (substitute(entry, {other: ring.symbol(name)}) for other in own)


def _with(matrix: Matrix, place: tuple[int, int], entry: Scalar) -> Matrix:
    """Return a matrix with another entry at a place."""
    rows = [[entry if (r, c) == place else cell for c, cell in enumerate(row)] for r, row in enumerate(matrix.rows)]
    return Matrix(tuple(map(tuple, rows)))
