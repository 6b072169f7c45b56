"""Inequalities and approximations, decided on samples; loaded where one is met."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from armproof.verification.algebra.matrix import Identity, Matrix, as_scalar
from armproof.verification.equations.alignment import Pair
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.equations.decimals import fewest_decimals
from armproof.verification.equations.outcome import Outcome
from armproof.verification.equations.sampled_errors import errors_between, with_lengths
from armproof.verification.equations.second_route import TOLERANCE
from armproof.verification.errors import EvaluationError
from armproof.verification.evaluation.evaluator import Evaluator
from armproof.verification.evaluation.sampled import SampledAlgebra
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.verdict import Verdict

HOLDS = {"≤": lambda a, b: a <= b + 1e-9, "<": lambda a, b: a < b - 1e-6, "≥": lambda a, b: a >= b - 1e-9,
         ">": lambda a, b: a > b + 1e-6}  # fmt: skip
ENOUGH = 100
# How far each search goes from the nearest samples: rad and m, and the logarithm of what stretches lengths and slides.
STEPS = ((0.5, 4.0), (0.5, 0.5), (0.2, 0.2), (0.1, 0.1), (0.05, 0.05), (0.02, 0.02))
NEAREST = 20
MAGNITUDES = (-3, 3)  # powers of ten
CLEARLY = 1e-6
Sides = tuple[n.Node, n.Node]
Comparison = tuple[n.Node, str, n.Node]


def check_inequality(
    checker: ChainChecker, sampled: SampledAlgebra, sides: Sides, relation: str, outcome: Outcome
) -> Outcome:
    """Confirm what holds at every sample, refute what fails at every one; the rest is a condition."""
    try:
        with np.errstate(all="ignore"):
            a, b = _values(checker, sampled, sides)
            if any(isinstance(value, Matrix | Identity | list) for value in (a, b)):
                return outcome
            good = HOLDS[relation](a, b)[np.isfinite(a) & np.isfinite(b)]
            if good.size and good.all() and not _at_other_sizes(checker, sampled, sides, relation).all():
                return outcome
            if good.size and good.all() and _is_exceeded(checker, sampled, sides, relation, np.abs(a - b)):
                return outcome
            if good.size and not good.any() and _at_other_sizes(checker, sampled, sides, relation).any():
                return outcome
    except (EvaluationError, KeyError):
        return outcome
    if good.size < ENOUGH or (good.any() and not good.all()):
        checker.names.state.compares_lengths = True
        return outcome
    verdict, kind = (
        (Verdict.CONFIRMED, Kind.INEQUALITY_HOLDS) if good.all() else (Verdict.REFUTED, Kind.INEQUALITY_FAILS)
    )
    return replace(outcome, verdict=verdict, findings=(say(kind),), samples=int(good.size))


def holds_where(
    checker: ChainChecker,
    sampled: SampledAlgebra,
    sides: Sides,
    exact: Pair | None,
    where: Sequence[Comparison],
) -> int:
    """Return at how many configurations an equation holds, of all where comparisons do; 0 where it fails at one.

    Lengths without a value are drawn as well.
    """
    count = 0
    for right in _right_where(checker, sampled, sides, exact, where):
        if right is None or not right.all():
            return 0
        count = max(count, right.size)
    return count if count >= ENOUGH else 0


def holds_anywhere(
    checker: ChainChecker,
    sampled: SampledAlgebra,
    sides: Sides,
    exact: Pair | None,
    where: Sequence[Comparison],
) -> bool:
    """Whether an equation holds at a configuration where comparisons do, whatever the lengths."""
    found = [*_right_where(checker, sampled, sides, exact, where)]
    return bool(found) and all(each is not None and each.any() for each in found)


def fails_everywhere(checker: ChainChecker, sampled: SampledAlgebra, sides: Sides, exact: Pair | None) -> bool:
    """Whether an equation fails at each of many configurations, whatever the lengths."""
    found = [*_right_where(checker, sampled, sides, exact, [])]
    return max((each.size for each in found if each is not None), default=0) >= ENOUGH and not any(
        each is None or each.any() for each in found
    )


def _right_where(
    checker: ChainChecker,
    sampled: SampledAlgebra,
    sides: Sides,
    exact: Pair | None,
    where: Sequence[Comparison],
) -> Iterator[np.ndarray | None]:
    """Yield, for each drawing of the lengths, at which of the configurations where comparisons hold an equation does; None where that cannot be told."""
    for lengths in _arms(checker, sampled):
        errors = errors_between(checker.names, lengths, *sides, exact, False)
        if errors is None:
            yield None
            return
        try:
            with np.errstate(all="ignore"):
                at = errors.counted & errors.at_random & where_all_hold(checker, lengths, where)
        except (EvaluationError, TypeError):
            yield None
            return
        worst = errors.scaled[..., at]
        yield np.asarray((worst <= TOLERANCE).all(axis=tuple(range(worst.ndim - 1))))


def _arms(checker: ChainChecker, sampled: SampledAlgebra) -> Iterator[SampledAlgebra]:
    """Yield the samples of the arm of the lengths that the document states, and of others where it states none."""
    stated = checker.names.state.stated
    own = {name: np.full(sampled.samples, stated[name]) for name in checker.names.lengths if name in stated}
    yield sampled.at(own) if own else sampled
    yield from with_lengths(sampled, stated)


def hold_everywhere(checker: ChainChecker, sampled: SampledAlgebra, where: Sequence[Comparison]) -> bool:
    """Whether comparisons say nothing: they hold at every configuration, whatever the lengths."""
    try:
        arms = _arms(checker, sampled)
        return all(bool(where_all_hold(checker, each, where)[each.random].all()) for each in arms)
    except (EvaluationError, TypeError):
        return False


def holds_somewhere(checker: ChainChecker, sampled: SampledAlgebra, bound: Comparison) -> bool:
    """Whether a comparison holds at a configuration, or nothing tells: |cos θ_3| > 1 says where there is no solution."""
    try:
        return any(bool(where_all_hold(checker, each, [bound]).any()) for each in _arms(checker, sampled))
    except (EvaluationError, TypeError):
        return True


def where_all_hold(checker: ChainChecker, sampled: SampledAlgebra, where: Sequence[Comparison]) -> np.ndarray:
    """Return the samples at which comparisons are clearly so; an angle between two bounds is so up to whole turns."""
    evaluator = Evaluator(checker.names, sampled)
    at = np.ones(sampled.samples, dtype=bool)
    bounds: dict[n.Node, dict[bool, np.ndarray]] = {}
    for left, relation, right in where:
        is_above = relation in ">≥"
        name, bound = (left, right) if _is_angle(left, checker) else (right, left)
        one, other = (as_scalar(evaluator.evaluate(side)) for side in (left, right))
        if _is_angle(name, checker) and not _is_angle(bound, checker):
            bounds.setdefault(name, {})[is_above is (name is left)] = other if name is left else one
        else:
            at &= (one - other if is_above else other - one) > CLEARLY
    for name, each in bounds.items():
        low, high = each.get(True, -np.pi), each.get(False, np.pi)
        turned = np.remainder(evaluator.evaluate(name) - low, 2 * np.pi)
        at &= (np.minimum(turned, high - low - turned) > CLEARLY) | (high - low >= 2 * np.pi - CLEARLY)
    return at


def _is_angle(node: n.Node, checker: ChainChecker) -> bool:
    symbol = checker.names.known_symbol(node.key) if isinstance(node, n.Name) else None
    return checker.names.is_angle(symbol)


def check_approximation(
    checker: ChainChecker, sampled: SampledAlgebra, sides: Sides, constant: bool, outcome: Outcome
) -> Outcome:
    """Confirm sides that agree, rounded to the decimals printed, at every sample; only numbers that do not are refuted.

    sin θ ≈ θ has its place, and 3.1415 for π is cut off.
    """
    unit = 10.0 ** -fewest_decimals(sides)
    try:
        with np.errstate(all="ignore"):
            a, b = _values(checker, sampled, sides)
            if not all(isinstance(value, np.ndarray) for value in (a, b)):
                return outcome
            errors = np.abs(a - b)
            if np.isnan(errors).all():
                return outcome  # a square root of a negative number, say
            error = float(np.nanmax(errors))
    except EvaluationError:
        return outcome
    close = error <= 0.5 * unit + 1e-9
    if not close and (not constant or error < unit):
        return outcome
    verdict = Verdict.CONFIRMED if close else Verdict.REFUTED
    return replace(outcome, verdict=verdict, findings=(say(Kind.APPROXIMATION),), samples=len(a))


def _drawn(checker: ChainChecker, sampled: SampledAlgebra) -> dict[str, np.ndarray]:
    """Return lengths: the values that the document gives, others drawn at random, all 1 in every fourth sample."""
    given = checker.names.state.stated
    random = np.random.default_rng(sampled.seed)
    lengths: dict[str, np.ndarray] = {}
    for name, value in checker.names.lengths.items():
        if name in given:
            lengths[name] = np.full(sampled.samples, given[name])
        else:
            lengths[name] = random.uniform(0.1, 2.0, sampled.samples)
            lengths[name][::4] = 1.0
            lengths[name] *= np.sign(value) or 1.0
    return lengths


def _values(checker: ChainChecker, sampled: SampledAlgebra, sides: Sides) -> list[Any]:
    lengths = _drawn(checker, sampled)
    return _values_at(checker, sampled.at(lengths) if lengths else sampled, sides)


def _values_at(checker: ChainChecker, algebra: SampledAlgebra, sides: Sides) -> list[Any]:
    return [as_scalar(Evaluator(checker.names, algebra).evaluate(node)) for node in sides]


def _at_other_sizes(checker: ChainChecker, sampled: SampledAlgebra, sides: Sides, relation: str) -> Any:
    """Return where an inequality holds when letters without a value are much smaller or greater: |ω| ≤ 2.5 at all samples is a bound."""
    given, random = checker.names.state.stated.keys(), np.random.default_rng(sampled.seed)
    drawn = {name: sampled.free[name] * random.choice((-1, 1), sampled.samples) for name in sorted(sampled.free)}
    drawn |= _drawn(checker, sampled)
    for name in sorted(drawn.keys() - given):
        drawn[name] = drawn[name] * 10 ** random.uniform(*MAGNITUDES, sampled.samples)
    a, b = _values_at(checker, sampled.at(drawn), sides)
    rounding = 1e-9 * (np.abs(a) + np.abs(b)) * (1 if relation in "≤<" else -1)
    return HOLDS[relation](a, b + rounding)[np.isfinite(a) & np.isfinite(b)]


def _is_exceeded(checker: ChainChecker, sampled: SampledAlgebra, sides: Sides, relation: str, gap: Any) -> bool:
    """Whether an inequality that holds at all samples fails near those where its sides are closest: a maximum is sought."""
    arm = checker.names.arm
    if arm is None:
        return False
    random = np.random.default_rng(sampled.seed)
    at = {joint.symbol: sampled.q[:, k] for k, joint in enumerate(arm.joints)} | _drawn(checker, sampled)
    given = checker.names.state.stated.keys()
    turns = {joint.symbol for joint in arm.joints if joint.kind == "revolute"}
    for step, stretch in STEPS:
        near = np.resize(np.argsort(np.where(np.isfinite(gap), gap, np.inf))[:NEAREST], sampled.samples)
        for name, values in at.items():
            noise = random.standard_normal(sampled.samples) * (name not in given)
            at[name] = values[near] + step * noise if name in turns else values[near] * np.exp(stretch * noise)
        a, b = _values_at(checker, sampled.at(at), sides)
        rounding = 1e-9 * (np.abs(a) + np.abs(b)) * (1 if relation in "≤<" else -1)
        if (np.isfinite(a) & np.isfinite(b) & ~HOLDS[relation](a, b + rounding)).any():
            return True
        gap = np.abs(a - b)
    return False
