"""A set of configurations given by conditions: some variables replaced, the others bound by irreducible relations."""

from __future__ import annotations

import random
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property

from flint import nmod_poly

from armproof.verification.singularities.elimination import Relation, pseudo_remainder
from armproof.verification.singularities.factors import Factor, half_sum
from armproof.verification.singularities.half_angles import HalfAngles, Polynomial

PRIMES = (2_147_483_647, 2_147_483_629, 2_147_483_587, 2_147_483_579, 2_147_483_563, 2_147_483_549)
TRIALS = 40


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


class Probe:
    """A random point of a set, with coordinates modulo a prime: what is not zero there is not zero on the set.

    The converse needs the exact remainder; but most entries of an elimination are not zero, and a point shows it at once.
    """

    def __init__(self, half: HalfAngles, chain: Sequence[Relation]) -> None:
        self._half = half
        self._prime = 0
        self._point: list[int] | None = None
        generator = random.Random(2019)  # the same point at every run
        for trial in range(TRIALS):
            self._prime = PRIMES[trial % len(PRIMES)]
            self._point = self._draw(chain, generator)
            if self._point is not None:
                break

    def shows_not_zero(self, polynomial: Polynomial) -> bool:
        """Whether a polynomial, in the variables that are not replaced, is not zero at the point."""
        return self._point is not None and self._evaluate(polynomial, self._point) % self._prime != 0

    def _draw(self, chain: Sequence[Relation], generator: random.Random) -> list[int] | None:
        """Return a point: random but for square roots, and for the variable of each relation, which is a root of it."""
        point = [generator.randrange(1, self._prime) for _ in range(self._half.context.nvars())]
        for kind, name in self._half.others:
            if kind == "sqrt":
                roots = self._roots([-int(name), 0, 1])
                if not roots:
                    return None
                point[self._half.slot((kind, name))] = roots[0]
        for relation in chain:
            degree = relation.polynomial.degrees()[relation.slot]
            coefficients = [0] * (degree + 1)
            for exponents, coefficient in relation.polynomial.terms():
                power = int(exponents[relation.slot])
                coefficients[power] += self._term(exponents, coefficient, point, relation.slot)
            roots = self._roots(coefficients)
            if not roots:
                return None
            point[relation.slot] = generator.choice(roots)
        return point

    def _roots(self, coefficients: Sequence[int]) -> list[int]:
        """Return the simple roots of a polynomial in one variable, lowest coefficient first."""
        polynomial = nmod_poly([c % self._prime for c in coefficients], self._prime)
        if polynomial.degree() < 1:
            return []
        _, factors = polynomial.factor()
        return [int(-f[0] / f[1]) for f, power in factors if f.degree() == 1 and power == 1]

    def _evaluate(self, polynomial: Polynomial, point: Sequence[int]) -> int:
        return sum(self._term(exponents, k, point, -1) for exponents, k in polynomial.terms())

    def _term(self, exponents: Sequence[int], coefficient: object, point: Sequence[int], without: int) -> int:
        prime = self._prime
        value = int(coefficient.p) * pow(int(coefficient.q), -1, prime)  # type: ignore[attr-defined]
        for slot, power in enumerate(exponents):
            if power and slot != without:
                value = value * pow(point[slot], int(power), prime) % prime
        return value


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
