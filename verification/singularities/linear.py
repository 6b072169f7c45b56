"""The rank of a matrix: its drop, by minors; on a set of configurations it and the null vectors, by exact elimination."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property, reduce
from itertools import combinations
from math import comb, gcd, lcm

from flint import fmpq

from armproof.verification.algebra.matrix import Matrix
from armproof.verification.algebra.ring import Scalar
from armproof.verification.singularities.elimination import BeyondReach
from armproof.verification.singularities.half_angles import HalfAngles, Polynomial
from armproof.verification.singularities.variety import Variety

MOST_TERMS = 4_000
MOST_MINORS = 400

Rows = tuple[tuple[Polynomial, ...], ...]


def maximal_minors(matrix: Matrix, size: int) -> list[Scalar]:
    """Return the minors of a size that are not zero everywhere: their common zeros are where the rank is below it.

    Raises:
        BeyondReach: there are too many.
    """
    rows, columns = matrix.shape
    if comb(rows, size) * comb(columns, size) > MOST_MINORS:
        raise BeyondReach("{count} minors", count=comb(rows, size) * comb(columns, size))
    found = []
    for chosen in combinations(range(rows), size):
        matrix.rows[0][0].ring.budget.check()
        found += [minor for minor in matrix.minors(chosen).values() if not minor.is_zero()]
    return found


def polynomial_rows(half: HalfAngles, matrix: Matrix) -> Rows:
    """Return the numerators of a matrix without denominators, all times the same Π (t² + u²)^d."""
    degrees = half.degrees(matrix.cells)
    return tuple(tuple(half.polynomial(cell, degrees) for cell in row) for row in matrix.rows)


@dataclass(frozen=True, eq=False)
class Echelon:
    """A matrix on a variety in reduced echelon form.

    Attributes:
        variety: the configurations.
        rows: the rows that are not zero, each with a pivot where the others are zero.
        pivots: the column of each pivot.
        width: the number of columns.
    """

    variety: Variety
    rows: Rows
    pivots: tuple[int, ...]
    width: int

    @property
    def rank(self) -> int:
        """The rank at a generic configuration of the set, for generic lengths."""
        return len(self.pivots)

    @cached_property
    def null_vectors(self) -> tuple[tuple[Polynomial, ...], ...]:
        """A basis of the vectors x with A x = 0, each freed of common factors."""
        free = [c for c in range(self.width) if c not in self.pivots]
        return tuple(self._null_vector(c) for c in free)

    def _null_vector(self, free: int) -> tuple[Polynomial, ...]:
        half = self.variety.half
        involved = [k for k, row in enumerate(self.rows) if not row[free].is_zero()]
        pivots = {k: self.rows[k][self.pivots[k]] for k in involved}
        common = reduce(lambda a, b: a * divmod(b, a.gcd(b))[0], pivots.values(), half.one)
        vector = [half.zero] * self.width
        vector[free] = common
        for k in involved:
            vector[self.pivots[k]] = -self.rows[k][free] * divmod(common, pivots[k])[0]
        return primitive(half, vector)


def primitive(half: HalfAngles, vector: Sequence[Polynomial]) -> tuple[Polynomial, ...]:
    """Return a vector divided by the common factor of its entries, the first entry that is not zero positive."""
    entries = [entry for entry in vector if not entry.is_zero()]
    if not entries:
        return tuple(vector)
    common = reduce(lambda a, b: a.gcd(b), entries)
    divided = [divmod(entry, common)[0] for entry in vector]
    content = rational_content(k for entry in divided for k in entry.coeffs())
    first = next(entry for entry in divided if not entry.is_zero())
    scale = -content if first.leading_coefficient() < 0 else content
    return tuple(entry / scale for entry in divided)


def rational_content(coefficients: Iterable[fmpq]) -> fmpq:
    """Return the positive number that leaves coprime integers when the coefficients are divided by it."""
    numbers = list(coefficients)
    return fmpq(gcd(*(int(k.p) for k in numbers)), lcm(*(int(k.q) for k in numbers)))


def eliminate(variety: Variety, rows: Rows) -> Echelon:
    """Return the reduced echelon form of a matrix on a variety, without division: every step is exact there.

    Raises:
        BeyondReach: an entry grows too large.
    """
    rest = [_cleared(variety, row) for row in rows]
    done: list[tuple[Polynomial, ...]] = []
    pivots: list[int] = []
    width = len(rows[0])
    while True:
        candidates = [
            (len(row[c]), sum(map(len, row)), r, c)
            for r, row in enumerate(rest)
            for c in range(width)
            if c not in pivots and not row[c].is_zero()
        ]
        if not candidates:
            break
        _, _, r, c = min(candidates)
        pivot = rest.pop(r)
        rest = [_cleared(variety, _without(row, pivot, c)) for row in rest]
        done = [_cleared(variety, _without(row, pivot, c)) for row in done]
        done.append(pivot)
        pivots.append(c)
    order = sorted(range(len(pivots)), key=pivots.__getitem__)
    return Echelon(variety, tuple(done[k] for k in order), tuple(pivots[k] for k in order), width)


def _without(row: tuple[Polynomial, ...], pivot: tuple[Polynomial, ...], column: int) -> tuple[Polynomial, ...]:
    """Return p·row − e·pivot, zero in the pivot's column, p and e freed of their common factor."""
    if row[column].is_zero():
        return row
    common = pivot[column].gcd(row[column])
    p, e = divmod(pivot[column], common)[0], divmod(row[column], common)[0]
    return tuple(p * a - e * b for a, b in zip(row, pivot, strict=True))


def _cleared(variety: Variety, row: Sequence[Polynomial]) -> tuple[Polynomial, ...]:
    """Return the row on the variety: entries that vanish there are zero, a common factor is divided out."""
    entries = [variety.substituted(entry) for entry in row]
    if variety.chain:
        entries = [variety.half.zero if variety.vanishes(entry) else entry for entry in entries]
    if max(len(entry) for entry in entries) > MOST_TERMS:
        raise BeyondReach("an elimination with too many terms")
    return primitive(variety.half, entries)


def as_scalars(half: HalfAngles, vector: Sequence[Polynomial]) -> tuple[Scalar, ...]:
    """Return a vector that is homogeneous in each pair (t, u) in cosines and sines, up to a common factor.

    Where a degree is odd every entry is multiplied by cos(θ/2).
    """
    entries = list(vector)
    for angle in half.angles:
        degree = max((half.degree(entry, angle) for entry in entries if not entry.is_zero()), default=0)
        if degree % 2:
            _, u = half.pair(angle)
            entries = [entry * u for entry in entries]
    scalars = []
    for entry in entries:
        value = half.scalar(entry)
        assert value is not None
        scalars.append(value)
    numbers = [k for value in scalars for k in value.numerator.coeffs()]
    scale = rational_content(numbers) if numbers else fmpq(1)
    return tuple(half.ring.scalar(value.numerator / scale) for value in scalars)
