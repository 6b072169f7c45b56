"""The equations of a drop in rank: the determinant, or all minors of the size of the rank."""

from __future__ import annotations

import itertools
from math import comb

from armproof.verification.algebra.matrix import Matrix
from armproof.verification.algebra.ring import Scalar
from armproof.verification.singularities.elimination import BeyondReach

MOST_MINORS = 400


def maximal_minors(matrix: Matrix, size: int) -> list[Scalar]:
    """Return the minors of a size that are not zero everywhere: their common zeros are where the rank is below it.

    Raises:
        BeyondReach: there are too many.
    """
    rows, columns = matrix.shape
    if comb(rows, size) * comb(columns, size) > MOST_MINORS:
        raise BeyondReach("{count} minors", count=comb(rows, size) * comb(columns, size))
    found = []
    for chosen in itertools.combinations(range(rows), size):
        matrix.rows[0][0].ring.budget.check()
        found += [minor for minor in matrix.minors(size, chosen).values() if not minor.is_zero()]
    return found
