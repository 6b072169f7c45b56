"""A point of a set of configurations in a finite field: what is not zero there is not zero on the set.

The converse needs the exact remainder; but most entries of an elimination are not zero, and a point shows it at once.
"""

from __future__ import annotations

import random
from collections.abc import Sequence

from flint import nmod_poly

from armproof.verification.singularities.elimination import Relation
from armproof.verification.singularities.half_angles import HalfAngles, Polynomial

PRIMES = (2_147_483_647, 2_147_483_629, 2_147_483_587, 2_147_483_579, 2_147_483_563, 2_147_483_549)
TRIALS = 40


class Probe:
    """A random point with coordinates modulo a prime at which the relations of a set hold."""

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
