"""Inequalities and approximations, decided on samples; loaded where one is met."""

from __future__ import annotations

import numpy as np

from armproof.verification.algebra.matrix import Identity, Matrix, as_scalar
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.equations.outcome import Outcome
from armproof.verification.errors import EvaluationError
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.verdict import Verdict

HOLDS = {"≤": lambda a, b: a <= b + 1e-9, "<": lambda a, b: a < b + 1e-9, "≥": lambda a, b: a >= b - 1e-9,
         ">": lambda a, b: a > b - 1e-9, "=": lambda a, b: np.abs(a - b) < 1e-9}  # fmt: skip


def check_inequality(checker: ChainChecker, chain: n.Chain, outcome: Outcome, samples: int) -> Outcome:
    """Return whether a chain of inequalities holds wherever its members have a value."""
    try:
        with np.errstate(all="ignore"):
            values = [as_scalar(checker.sampled_value(node)) for node in chain.members]
            if any(isinstance(value, Matrix | Identity | list) for value in values):
                return outcome
            good = np.ones(samples, dtype=bool)
            for relation, a, b in zip(chain.relations, values, values[1:], strict=False):
                good &= HOLDS[relation](a, b) | ~np.isfinite(a) | ~np.isfinite(b)
    except (EvaluationError, KeyError):
        return outcome
    outcome.samples = samples
    if good.all():
        outcome.verdict, outcome.findings = Verdict.CONFIRMED, (say(Kind.INEQUALITY_HOLDS),)
    else:
        outcome.verdict, outcome.findings = Verdict.REFUTED, (say(Kind.INEQUALITY_FAILS),)
    return outcome


def check_approximation(checker: ChainChecker, chain: n.Chain, outcome: Outcome, samples: int) -> Outcome:
    """Return whether the members of a chain are near the first."""
    try:
        with np.errstate(all="ignore"):
            first, *others = [as_scalar(checker.sampled_value(node)) for node in chain.members]
            if not all(isinstance(value, np.ndarray) for value in (first, *others)):
                return outcome
            close = all(np.allclose(first, other, rtol=1e-2, atol=1e-3) for other in others)
    except EvaluationError:
        return outcome
    outcome.samples = samples
    outcome.verdict = Verdict.CONFIRMED if close else Verdict.REFUTED
    outcome.findings = (say(Kind.APPROXIMATION),)
    return outcome
