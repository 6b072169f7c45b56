"""The likely mistake behind a display whose matrix is wrong as a whole, found on samples as that of a function."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from models.errors import ArmproofError
from verification.causes.case import Case, Explanation
from verification.causes.find import find_cause
from verification.causes.probes import Configurations, partners, probes
from verification.equation import ChainChecker
from verification.exact_algebra import ExactAlgebra
from verification.matrix import Matrix
from verification.outcome import Outcome
from verification.quantities import Quantity
from verification.sampled_algebra import SampledAlgebra

_MOST_TERMS = 5000  # of a printed matrix that is sampled
_KINDS = ("pose", "rotation", "origin", "axis", "jacobian")


def display_cause(checker: ChainChecker, outcome: Outcome) -> Explanation:
    """Return the likely mistake behind a refuted equation; without words where none explains it."""
    arm, quantity = checker.names.arm, _quantity(checker, outcome)
    if arm is None or quantity is None or outcome.pair is None:
        return Explanation()
    printed, at, there = outcome.pair.printed, probes(arm), partners(arm)
    if sum(len(cell.numerator) + len(cell.denominator) for row in printed.rows for cell in row) > _MOST_TERMS:
        return Explanation()
    try:
        with np.errstate(all="ignore"):
            obtained = _at(checker.exact, printed, at)
            true = at.true(quantity)
            if obtained.shape != true.shape or not np.isfinite(obtained).all():
                return Explanation()
            return find_cause(
                Case(
                    arm, quantity, at.numeric, true, obtained, there.numeric, lambda: _at(checker.exact, printed, there)
                )
            )
    except ArmproofError:
        return Explanation()


def _quantity(checker: ChainChecker, outcome: Outcome) -> Quantity | None:
    """Return the quantity of the arm, with the rows that are compared."""
    if outcome.pair is None or outcome.true is None or outcome.sampled_only:
        return None
    quantity = checker.quantity_of(outcome.true.node)
    if quantity is None or quantity.kind not in _KINDS or quantity.scalar:
        return None
    rows = outcome.pair.true_rows
    return quantity if rows is None else replace(quantity, rows=tuple(row + 1 for row in rows))


def _at(exact: ExactAlgebra, value: Matrix, at: Configurations) -> np.ndarray:
    sampled = SampledAlgebra(exact, at.q).from_exact(value)
    return np.moveaxis(np.array([list(row) for row in sampled.rows]), -1, 0)
