"""Whether one condition follows from another: decided by unique factors, or refuted at a configuration.

A condition is a set of configurations, its equations split into irreducible sets (verification/singularities). One follows
from another when each irreducible set of the first lies in a set of the second: its equations vanish there. No bound on
powers is needed, and factors that have no real zeros for positive lengths are left out.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass
from functools import cached_property

from armproof.verification.algebra.calculus import substitute
from armproof.verification.algebra.ring import Scalar
from armproof.verification.conditions.postures import quarter_turns
from armproof.verification.conditions.system import Condition, System, Undecided
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.errors import EvaluationError, WhereDefined
from armproof.verification.findings import Kind, finding_of, say
from armproof.verification.naming.conventions import reads_as_length
from armproof.verification.singularities.decomposition import Decomposer, Lengths
from armproof.verification.singularities.elimination import BeyondReach
from armproof.verification.singularities.half_angles import HalfAngles, Polynomial
from armproof.verification.singularities.variety import Variety
from armproof.verification.singularities.writing import write_condition

LONGEST = 120  # characters of the families that are named
MOST_PRODUCTS = 32
SCALES = (1.0, 4.0, 0.25)  # of the lengths: what holds for an arm of any size is refuted by one


@dataclass(frozen=True, eq=False)
class _System:
    """A system in half-angle coordinates."""

    zero: tuple[Polynomial, ...]
    not_all_zero: tuple[tuple[Polynomial, ...], ...]


class Entailment:
    """One condition, and another that is said to follow from it."""

    def __init__(self, checker: ChainChecker, premise: Condition, conclusion: Condition) -> None:
        self.checker = checker
        self.premise, self.conclusion = premise, conclusion
        self._families: list[Variety] = []
        self._met = 0  # irreducible sets of the premise that were looked at
        self.half = HalfAngles(checker.exact.ring, (s for system in (*premise, *conclusion) for s in _scalars(system)))
        self.positive = _lengths(checker, self.half)
        self.decomposer = Decomposer(self.half, self.positive, lengths=Lengths.ALL, budget=checker.exact.budget)

    def counterexample(self) -> dict[str, float] | None:
        """Return a configuration at which the premise holds and the conclusion does not; None where there is none, proved.

        Raises:
            Undecided: neither could be shown, or the premise holds at no configuration.
        """
        failing = self._failing()
        first = next(failing, None)
        if first is None:
            return None
        point = self._point(*first)
        with suppress(EvaluationError):  # the others are named where there is time
            self._families = [first[0], *(variety for variety, *_ in failing)]
        return point

    def families(self, in_any_case: bool) -> str:
        """Return where the premise holds and the conclusion does not, as conditions; empty where that is too long.

        What is all of the premise is told in any case alone.
        """
        if len(self._families) == self._met and not in_any_case:
            return ""
        written = (r" \wedge ".join(map(write_condition, variety.conditions)) for variety in self._families)
        text = r",\; ".join(written)
        return text if len(text) <= LONGEST else ""

    def _failing(self) -> Iterator[tuple[Variety, _System, list[_System]]]:
        """Yield the irreducible sets of the premise on which the conclusion fails, with both sides' systems."""
        premise, conclusion = ([self._polynomials(s) for s in side] for side in (self.premise, self.conclusion))
        for given, system in zip(self.premise, premise, strict=True):
            if self._follows_by_substitution(given):
                self._met += 1
                continue
            for variety in self._decompose(system.zero):
                if any(_within(variety, others) for others in system.not_all_zero):
                    continue
                self._met += 1
                lies = any(self._lies_in(variety, system, other) for other in conclusion)
                if not lies and not self._lies_in_union(variety):
                    yield variety, system, conclusion
        if not self._met:
            raise Undecided(say(Kind.CONDITION_NEVER_MET))

    def _follows_by_substitution(self, given: System) -> bool:
        """Whether a system that does nothing but fix angles makes the equations of one conclusion zero.

        It serves for angles such as π/4, whose cosine is a root: conjugate conditions are then one irreducible set.
        """
        if not given.values or len(given.values) != len(given.zero) or given.not_all_zero:
            return False
        values = dict(given.values)
        return any(
            not system.not_all_zero and all(self._vanishes(scalar, values) for scalar in system.zero)
            for system in self.conclusion
        )

    def _vanishes(self, scalar: Scalar, values: dict[str, Scalar]) -> bool:
        """Whether a scalar is zero where angles have given values; the sign of a root is that for any lengths."""
        ring = self.checker.exact.ring
        before, ring.signs_chosen = ring.signs_chosen, False
        zero, chosen = substitute(scalar, values).is_zero(), ring.signs_chosen
        ring.signs_chosen = before or chosen
        if not (zero and chosen):
            return zero
        sampled = self.checker.sampled()
        from armproof.verification.equations.sampled_errors import vanishes_for_lengths

        return vanishes_for_lengths(sampled, self.checker.names.state.stated, scalar, values)

    def _lies_in_union(self, variety: Variety) -> bool:
        """Whether a set lies in the systems of the conclusion together: every product of one equation of each is zero there."""
        if any(system.not_all_zero for system in self.conclusion):
            return False
        choices = itertools.product(*(system.zero for system in self.conclusion))
        for number, choice in enumerate(choices):
            product = self.checker.exact.ring.one
            for scalar in choice:
                product = product * scalar
            if number >= MOST_PRODUCTS or not self.half.holds(product):
                return False
            if not variety.vanishes(self.half.polynomial(product)):
                return False
        return True

    def _decompose(self, equations: tuple[Polynomial, ...], within: Variety | None = None) -> list[Variety]:
        try:
            return self.decomposer.decompose(equations, within)
        except BeyondReach as problem:
            raise Undecided(say(Kind.BEYOND_REACH, problem=finding_of(problem))) from None

    def _polynomials(self, system: System) -> _System:
        polynomial = self.half.polynomial
        others = tuple(tuple(polynomial(s) for s in scalars) for scalars in system.not_all_zero)
        return _System(tuple(polynomial(s) for s in system.zero), others)

    def _lies_in(self, variety: Variety, premise: _System, other: _System) -> bool:
        """Whether a set, less what the premise leaves out, lies in a system."""
        if not _within(variety, other.zero):
            return False
        for excluded in other.not_all_zero:
            for part in self._decompose(excluded, variety):
                if not any(_within(part, left_out) for left_out in premise.not_all_zero):
                    return False
        return True

    # -- counterexamples -----------------------------------------------------------------------------------------------

    def _point(self, variety: Variety, premise: _System, conclusion: list[_System]) -> dict[str, float]:
        """Return a configuration of a set at which no system of the conclusion holds.

        Raises:
            Undecided: none was found.
        """
        found = self._quarter_turns() or self._drawn(variety, premise, conclusion)
        if not found:
            raise Undecided(say(Kind.NOT_SHOWN))
        return found

    def _drawn(self, variety: Variety, premise: _System, conclusion: list[_System]) -> dict[str, float] | None:
        """Return a configuration drawn on a set, for an arm of any size."""
        if any(kind not in ("symbol", "sqrt") for kind, _ in self.half.others):
            return None
        self.checker.sampled()  # raises where nothing may be drawn
        with self.checker.exact.budget.paused():
            from armproof.verification.conditions.drawn_points import DrawnPoints

        drawn = DrawnPoints(self.half, self.checker.names.arm, self.positive, self._named)
        others = [(system.zero, system.not_all_zero) for system in conclusion]
        for scale in SCALES:
            self.checker.exact.budget.check()
            if point := drawn.point(variety, premise.not_all_zero, others, scale):
                return point
        return None

    @cached_property
    def _named(self) -> tuple[set[str], set[str]]:
        """The angles and the symbols that occur."""
        return set(self.half.angles), {name for kind, name in self.half.others if kind == "symbol"}

    def _quarter_turns(self) -> dict[str, float] | None:
        """Return a configuration of quarter turns at which the premise holds and the conclusion does not, exactly."""
        arm = self.checker.names.arm
        if arm is None:
            return None
        angles, symbols = self._named
        joints = [joint for joint in arm.joints if joint.symbol in angles | symbols]
        for values, numbers in quarter_turns(self.checker.exact, joints):
            with WhereDefined():  # tan θ has no value at π/2
                holds = any(_holds(system, values) for system in self.premise)
                if holds and not any(_holds(system, values) for system in self.conclusion):
                    return numbers
        return None


def _scalars(system: System) -> list[Scalar]:
    return [*system.zero, *(scalar for scalars in system.not_all_zero for scalar in scalars)]


def _holds(system: System, values: dict[str, Scalar]) -> bool:
    """Whether a system holds where its symbols have values."""

    def is_zero(scalar: Scalar) -> bool:
        return substitute(scalar, values).is_zero()

    return all(map(is_zero, system.zero)) and not any(all(map(is_zero, scalars)) for scalars in system.not_all_zero)


def _within(variety: Variety, polynomials: tuple[Polynomial, ...]) -> bool:
    return all(variety.vanishes(polynomial) for polynomial in polynomials)


def _lengths(checker: ChainChecker, half: HalfAngles) -> frozenset[str]:
    """The symbols taken as positive: the arm's lengths, or without an arm what reads as one."""
    arm = checker.names.arm
    if arm is not None:
        return frozenset(arm.lengths) | frozenset(checker.names.state.adopted)
    names = {name for kind, name in half.others if kind == "symbol"}
    return frozenset(filter(reads_as_length, names))
