"""A display whose matrix is wrong as a whole, as a case on samples: its likely mistake is found as that of a function."""

from __future__ import annotations

from dataclasses import replace
from functools import partial

import numpy as np

from armproof.models.errors import ArmproofError
from armproof.verification.algebra.matrix import Matrix
from armproof.verification.algebra.quantity import Quantity
from armproof.verification.algebra.quantity_kinds import kind_of
from armproof.verification.diagnosis.causes.case import Case
from armproof.verification.diagnosis.causes.probes import Configurations, partners, probes
from armproof.verification.diagnosis.counterexample import count_terms
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.equations.outcome import Outcome
from armproof.verification.evaluation.exact import ExactAlgebra
from armproof.verification.evaluation.sampled import SampledAlgebra

_MOST_TERMS = 5000  # of a printed matrix that is sampled


def display_case(checker: ChainChecker, outcome: Outcome) -> Case | None:
    """Return a refuted equation on a quantity of the arm as a case; None where it is none, or too long."""
    arm, quantity = checker.names.arm, _quantity(checker, outcome)
    if arm is None or quantity is None or outcome.pair is None:
        return None
    printed, at, there = outcome.pair.printed, probes(arm), partners(arm)
    if sum(map(count_terms, printed.cells)) > _MOST_TERMS:
        return None
    try:
        with np.errstate(all="ignore"):
            obtained = _at(checker.exact, printed, at)
            true = at.true(quantity)
            if obtained.shape != true.shape or not np.isfinite(obtained).all():
                return None
            obtained_there = partial(_at, checker.exact, printed, there)
            return Case(arm, quantity, at.numeric, true, obtained, there.numeric, obtained_there, is_printed=True)
    except ArmproofError:
        return None


def _quantity(checker: ChainChecker, outcome: Outcome) -> Quantity | None:
    """Return the quantity of the arm, with the rows that are compared."""
    if outcome.pair is None or outcome.true is None or outcome.sampled_only:
        return None
    quantity = checker.quantity_of(outcome.true.node)
    if quantity is None or quantity.scalar or not (kind_of(quantity).matrix or quantity.kind == "difference"):
        return None
    rows = outcome.pair.true_rows
    return quantity if rows is None else replace(quantity, rows=tuple(row + 1 for row in rows))


def _at(exact: ExactAlgebra, value: Matrix, at: Configurations) -> np.ndarray:
    sampled = SampledAlgebra(exact, at.q)
    return sampled.stacked(sampled.from_exact(value))
