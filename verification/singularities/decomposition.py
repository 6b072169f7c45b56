"""From equations to families: the irreducible sets on which a system of polynomials vanishes."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from enum import Enum

from armproof.models.exact.numbers import is_number
from armproof.verification.algebra.budget import Budget
from armproof.verification.singularities.elimination import BeyondReach, arrange, resultant, variables
from armproof.verification.singularities.factors import Factor, Kind
from armproof.verification.singularities.half_angles import HalfAngles, Polynomial
from armproof.verification.singularities.variety import Variety, solve_angle, solve_length

MOST_VARIETIES = 200


class Lengths(Enum):
    """Which conditions on the lengths are followed: none, those linear in a length such as a_1 = a_2, or all."""

    GENERIC = "generic"
    LINEAR = "linear"
    ALL = "all"


class Decomposer:
    """Splits systems of equations, branching on irreducible factors, the simplest equation first.

    A factor that fixes an angle is substituted. Other factors become a triangular chain of relations; where two of them bind
    the same variables, one variable is eliminated by a resultant.
    """

    def __init__(
        self,
        half: HalfAngles,
        positive: frozenset[str],
        *,
        lengths: Lengths = Lengths.GENERIC,
        budget: Budget | None = None,
    ) -> None:
        """Take the coordinates, the symbols that are positive, and the time for all that is decomposed."""
        self.half, self.positive, self.lengths = half, positive, lengths
        self.budget = Budget() if budget is None else budget
        self.constant = frozenset(half.slot(g) for g in half.others if g[1] in positive or g[0] == "sqrt") | frozenset(
            half.slots(angle)[0] for angle in half.angles if is_number(angle)
        )
        self._factors: dict[str, list[Factor]] = {}

    def decompose(
        self, equations: Sequence[Polynomial], within: Variety | None = None, seconds: float = math.inf
    ) -> list[Variety]:
        """Return the sets on which all equations vanish (inside a set, where one is given), none inside another.

        Raises:
            BeyondReach: the system is too large, takes longer than `seconds`, or binds the same variables in a way that is
                not split.
        """
        budget = self.budget.share(seconds)
        found: list[Variety] = []
        start = Variety(self.half) if within is None else within
        pending: list[tuple[Variety, tuple[Polynomial, ...]]] = [(start, tuple(equations))]
        while pending:
            if budget.is_spent:
                raise BeyondReach("more time than the analysis may take")
            if len(found) + len(pending) > MOST_VARIETIES:
                raise BeyondReach("more than {most_varieties} families", most_varieties=MOST_VARIETIES)
            variety, rest = pending.pop()
            split = self._split(variety, rest)
            if split is None:
                found.append(variety)
            else:
                pending.extend(split)
        return _largest(found)

    def factors(self, polynomial: Polynomial) -> list[Factor]:
        """Return the factors that can vanish, the simplest first."""
        key = str(polynomial)
        if key not in self._factors:
            found = [Factor(self.half, f, self.positive) for f, _ in self.half.factors(polynomial)]
            kept = [
                f
                for f in found
                if f.kind is not Kind.NEVER and (self.lengths is not Lengths.GENERIC or f.kind is not Kind.LENGTHS)
            ]
            self._factors[key] = sorted(kept, key=_effort)
        return self._factors[key]

    def _split(
        self, variety: Variety, equations: tuple[Polynomial, ...]
    ) -> list[tuple[Variety, tuple[Polynomial, ...]]] | None:
        """Return the branches of the simplest equation that does not hold yet; None where all hold."""
        open_ones = [p for p in (variety.reduced(e) for e in equations) if not p.is_zero()]
        if not open_ones:
            return None
        equation = min(open_ones, key=self._difficulty)
        rest = tuple(open_ones)
        return [branch for factor in self.factors(equation) for branch in self._with(variety, factor, rest)]

    def _difficulty(self, polynomial: Polynomial) -> tuple[int, int]:
        if len(polynomial) > 400:
            return 9, len(polynomial)
        return max((_effort(f)[0] for f in self.factors(polynomial)), default=-1), len(polynomial)

    def _with(
        self, variety: Variety, factor: Factor, equations: tuple[Polynomial, ...]
    ) -> list[tuple[Variety, tuple[Polynomial, ...]]]:
        """Return the set with one more condition, and the equations that are to hold on it."""
        relations = tuple(relation.polynomial for relation in variety.chain)
        if factor.kind is Kind.ANGLE:
            return [(variety.with_values(factor, solve_angle(factor)), (*relations, *equations))]
        if factor.kind is Kind.LENGTHS:
            values = solve_length(factor)
            if values is None and self.lengths is Lengths.ALL:
                raise BeyondReach("a relation between the lengths that is not linear")
            if values is None:
                return []  # a relation such as a_1² = a_2² + a_3²: no family of its own is sought for such lengths
            return [(variety.with_values(factor, values, lengths=True), (*relations, *equations))]
        return self._with_relation(variety, factor, equations)

    def _with_relation(
        self, variety: Variety, factor: Factor, equations: tuple[Polynomial, ...]
    ) -> list[tuple[Variety, tuple[Polynomial, ...]]]:
        relations = [relation.factor for relation in variety.chain]
        chain = arrange(self.half, [*relations, factor], self.constant)
        if chain is not None:
            return [(replace(variety, chain=chain), equations)]
        simpler = self.factors(self._eliminate(relations, factor))
        again = (*(relation.polynomial for relation in relations), factor.polynomial, *equations)
        return [branch for f in simpler for branch in self._with(replace(variety, chain=()), f, again)]

    def _eliminate(self, relations: Sequence[Factor], factor: Factor) -> Polynomial:
        """Return a consequence of the relations and the factor with one variable fewer."""
        own = variables(self.half, factor.polynomial, self.constant)
        shared = [
            (relation.polynomial, slot)
            for relation in relations
            for slot in variables(self.half, relation.polynomial, self.constant) & own
        ]
        polynomial, slot = min(shared, key=lambda pair: (pair[0].degrees()[pair[1]], -pair[1]))
        eliminated = resultant(self.half, polynomial, factor.polynomial, slot)
        if eliminated.is_zero():
            raise BeyondReach("two relations between the same variables")
        return eliminated


def _effort(factor: Factor) -> tuple[int, int]:
    order = {Kind.NEVER: 0, Kind.ANGLE: 1, Kind.LENGTHS: 2, Kind.EQUATION: 3}
    return order[factor.kind] + len(factor.half.used(factor.polynomial)[0]), len(factor.polynomial)


def _largest(found: list[Variety]) -> list[Variety]:
    """Leave out sets that lie inside another."""
    kept: list[Variety] = []
    for variety in sorted(found, key=lambda v: (len(v.lengths), v.codimension)):
        if not any(variety.is_within(other) for other in kept):
            kept.append(variety)
    return kept
