"""A set of configurations given by conditions: some variables replaced, the others bound by irreducible relations."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property

from armproof.verification.singularities.elimination import Relation, pseudo_remainder
from armproof.verification.singularities.factors import Factor, half_sum
from armproof.verification.singularities.half_angles import HalfAngles, Polynomial
from armproof.verification.singularities.probe import Probe


@dataclass(frozen=True, eq=False)
class Variety:
    """The configurations at which some conditions hold, in half-angle coordinates.

    Attributes:
        half: the coordinates.
        factors: the conditions that fix a sum of angles, in the order in which they were found.
        lengths: conditions on the lengths alone, under which the set is meant.
        values: variables (by index) that the conditions fix, and what they equal, in terms of the others.
        chain: irreducible relations between the others, triangular.
    """

    half: HalfAngles
    factors: tuple[Factor, ...] = ()
    lengths: tuple[Factor, ...] = ()
    values: Mapping[int, Polynomial] = field(default_factory=dict)
    chain: tuple[Relation, ...] = ()

    def substituted(self, polynomial: Polynomial) -> Polynomial:
        """Return the polynomial with the fixed variables replaced."""
        return self.half.substitute(polynomial, self.values)

    def reduced(self, polynomial: Polynomial) -> Polynomial:
        """Return a polynomial that is zero exactly where the given one vanishes on the whole set."""
        polynomial = self.substituted(polynomial)
        if polynomial.is_zero() or not self.chain:
            return polynomial
        for relation in reversed(self.chain[1:]):
            polynomial = pseudo_remainder(self.half, polynomial, relation)
            if polynomial.is_zero():
                return polynomial
        first = self.chain[0]
        if len(self.chain) > 1:
            return pseudo_remainder(self.half, polynomial, first)
        return self.half.zero if self.half.divides(first.polynomial, polynomial) else polynomial

    def vanishes(self, polynomial: Polynomial) -> bool:
        """Whether a polynomial is zero on the whole set."""
        polynomial = self.substituted(polynomial)
        if polynomial.is_zero() or not self.chain:
            return bool(polynomial.is_zero())
        return not self._probe.shows_not_zero(polynomial) and bool(self.reduced(polynomial).is_zero())

    @cached_property
    def _probe(self) -> Probe:
        return Probe(self.half, self.chain)

    @cached_property
    def conditions(self) -> tuple[Factor, ...]:
        """The conditions on the joint variables."""
        return (*self.factors, *(relation.factor for relation in self.chain))

    @property
    def codimension(self) -> int:
        """The number of independent conditions on the joint variables."""
        return len(self.conditions)

    def with_values(self, factor: Factor, values: Mapping[int, Polynomial], *, lengths: bool = False) -> Variety:
        """Return the set with more variables fixed; the relations between the others are left to be added again."""
        older = {slot: self.half.substitute(value, values) for slot, value in self.values.items()}
        factors = self.factors if lengths else (*self.factors, factor)
        conditions = (*self.lengths, factor) if lengths else self.lengths
        return Variety(self.half, factors, conditions, {**older, **values}, ())

    def is_within(self, other: Variety) -> bool:
        """Whether every configuration of this set is one of the other."""
        return all(self.vanishes(factor.polynomial) for factor in (*other.conditions, *other.lengths))


def solve_angle(factor: Factor) -> dict[int, Polynomial]:
    """Return the values of t and u of the last angle that solve Σ ± θ = turns · π/2."""
    half, found = factor.half, factor.angle_sum
    assert found is not None
    *rest, (angle, sign) = found.signs
    sine, cosine = half_sum(half, rest)
    sin_half, cos_half = {0: (0, 1), 2: (1, 0), 1: (1, 1), -1: (-1, 1)}[found.turns]
    t, u = half.slots(angle)
    return {t: sign * (sin_half * cosine - cos_half * sine), u: cos_half * cosine + sin_half * sine}


def solve_length(factor: Factor) -> dict[int, Polynomial] | None:
    """Return a length in terms of others where the condition is linear in it with a constant coefficient; else None."""
    half, polynomial = factor.half, factor.polynomial
    for generator in half.used(polynomial)[1]:
        slot = half.slot(generator)
        if generator[0] != "symbol" or polynomial.degrees()[slot] != 1:
            continue
        slope = polynomial.derivative(slot)
        if slope.is_constant():
            variable = half.context.gen(slot)
            return {slot: (slope.leading_coefficient() * variable - polynomial) / slope.leading_coefficient()}
    return None
