"""Whether both sides of an implication hold at a configuration as nearly as their decimals allow; loaded where one is refuted."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction
from math import remainder, tau

import numpy as np

from armproof.verification.algebra.matrix import as_scalar
from armproof.verification.conditions.implication import Alternatives, Implication
from armproof.verification.equations.alignment import align
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.equations.sampled_errors import entry_errors
from armproof.verification.errors import EvaluationError
from armproof.verification.evaluation.evaluator import Evaluator
from armproof.verification.evaluation.sampled import SampledAlgebra
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare_key, has_branches

DRAWN = 1e-6  # a configuration is found by iteration
NEAR = 0.1  # from a configuration at which a rounded number holds to the one that is meant: s_2 = 0.87 and 60°


def nearly_holds(checker: ChainChecker, implication: Implication, point: Mapping[str, float]) -> bool:
    """Whether an alternative of either side holds there, each printed decimal being half a unit off: det J = 0.433 at 60°.

    Or at a configuration beside it that a side states.
    """
    sides, sampled = (implication.before, implication.behind), checker.sampled()
    try:
        stated = [near for side in sides for near in _beside(checker, side, _at(sampled, point), point)]
        return any(all(_holds(checker, side, _at(sampled, each)) for side in sides) for each in (point, *stated))
    except EvaluationError:
        return False


def _at(sampled: SampledAlgebra, point: Mapping[str, float]) -> SampledAlgebra:
    return sampled.at({name: np.full(sampled.samples, value) for name, value in point.items()})


def _beside(
    checker: ChainChecker, side: Alternatives, there: SampledAlgebra, point: Mapping[str, float]
) -> Iterator[dict[str, float]]:
    """Yield the configurations beside a point that alternatives give by values: θ_2 = 60°."""
    evaluator = Evaluator(checker.names, there, 1)
    for chains in side:
        told = {
            symbol: float(np.ravel(as_scalar(evaluator.evaluate(chain.members[1])))[0])
            for chain in chains
            if (symbol := checker.names.known_symbol(bare_key(chain.members[0]) or "") or "") in point
        }
        if told and all(abs(remainder(value - point[name], tau)) < NEAR for name, value in told.items()):
            yield {**point, **told}


def _holds(checker: ChainChecker, side: Alternatives, there: SampledAlgebra) -> bool:
    return any(all(_nearly_equal(checker, chain, there) for chain in chains) for chains in side)


def _nearly_equal(checker: ChainChecker, chain: n.Chain, there: SampledAlgebra) -> bool:
    """Whether the sides of a chain are equal on one branch, as nearly as its decimals allow."""
    if set(chain.relations) != {"="}:
        return False
    first, *others = chain.members
    branches = (1, -1) if has_branches(chain) else (1,)
    return any(all(_is_near(Evaluator(checker.names, there, b), first, other) for other in others) for b in branches)


def _is_near(evaluator: Evaluator, one: n.Node, other: n.Node) -> bool:
    apart = _error(evaluator, one, other)
    slack = np.zeros_like(apart)
    for node in (one, other):
        for number in (each for each in n.walk(node) if isinstance(each, n.Number) and each.decimals):
            off = n.Number(number.value + Fraction(1, 2 * 10**number.decimals), "", span=number.span)
            slack += np.abs(_error(evaluator, node, n.substitute(node, number, off)))
    return bool((apart <= slack + DRAWN).all())


def _error(evaluator: Evaluator, one: n.Node, other: n.Node) -> np.ndarray:
    """The entries of |a − b|, up to whole turns: (rows, columns, samples)."""
    a, b = (as_scalar(evaluator.evaluate(node)) for node in (one, other))
    return entry_errors(next(align(a, b, evaluator.algebra)), lambda _row, _column: True)
