"""Half-angle coordinates: the ring of sines and cosines as homogeneous polynomials, where factors are unique.

The quotient ring ℚ[c, s]/(c² + s² − 1) has no unique factors (1 − c² = s·s = (1 − c)(1 + c)). With t : u = tan(θ/2), that is

    cos θ = (u² − t²)/(t² + u²),    sin θ = 2tu/(t² + u²),

a polynomial in cosines and sines becomes one that is homogeneous in each pair (t, u), over ℚ with the lengths: a ring with
unique factors. Each θ is one real point t : u, so an irreducible factor that has real zeros is one condition: t = 0 is
θ = 0, u = 0 is θ = π, t = ±u is θ = ±π/2.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from fractions import Fraction
from functools import cache
from typing import Any

from flint import Ordering, fmpq, fmpq_mpoly, fmpq_mpoly_ctx

from armproof.models.exact.polynomial import Generator
from armproof.verification.algebra.ring import Ring, Scalar
from armproof.verification.errors import TooComplex

Polynomial = Any  # flint.fmpq_mpoly of the context of one HalfAngles


class HalfAngles:
    """ℚ[t, u of each angle; lengths, prismatic variables, roots], made for the generators that some scalars hold."""

    def __init__(self, ring: Ring, values: Iterable[Scalar]) -> None:
        self.ring, self.parts = ring, dict(ring.parts)
        found: set[Generator] = set()
        for value in values:
            ring.budget.check()
            found |= value.generators
        self.angles: tuple[str, ...] = tuple(sorted({name for kind, name in found if kind in ("cos", "sin")}))
        self.others: tuple[Generator, ...] = tuple(sorted(g for g in found if g[0] not in ("cos", "sin")))
        count = 2 * len(self.angles) + len(self.others)
        self.context: fmpq_mpoly_ctx = fmpq_mpoly_ctx.get([f"h{k}" for k in range(max(count, 1))], Ordering.degrevlex)
        self.one: Polynomial = self.context.constant(1)
        self.zero: Polynomial = self.context.constant(0)

    # -- variables ---------------------------------------------------------------------------------------------------

    def slots(self, angle: str) -> tuple[int, int]:
        """Return the indices of t and u of an angle."""
        place = 2 * self.angles.index(angle)
        return place, place + 1

    def pair(self, angle: str) -> tuple[Polynomial, Polynomial]:
        """Return t and u of an angle: t : u = sin(θ/2) : cos(θ/2)."""
        t, u = self.slots(angle)
        return self.context.gen(t), self.context.gen(u)

    def slot(self, generator: Generator) -> int:
        """Return the index of a length, a prismatic variable or a root."""
        return 2 * len(self.angles) + self.others.index(generator)

    def variable(self, generator: Generator) -> Polynomial:
        """Return a length, a prismatic variable or a root."""
        return self.context.gen(self.slot(generator))

    def used(self, polynomial: Polynomial) -> tuple[tuple[str, ...], tuple[Generator, ...]]:
        """Return the angles and the other generators that a polynomial holds."""
        degrees = polynomial.degrees()
        angles = tuple(a for a in self.angles if any(degrees[k] for k in self.slots(a)))
        return angles, tuple(g for g in self.others if degrees[self.slot(g)])

    def degree(self, polynomial: Polynomial, angle: str) -> int:
        """Return the degree in t and u together of a polynomial that is homogeneous in them."""
        t, u = self.slots(angle)
        exponents = next(iter(polynomial.monoms()), None)
        return 0 if exponents is None else int(exponents[t] + exponents[u])

    def holds(self, value: Scalar) -> bool:
        """Whether each generator of a scalar is among the variables: a product of two roots may bring a third."""
        return all(g[1] in self.angles if g[0] in ("cos", "sin") else g in self.others for g in value.generators)

    # -- there and back ------------------------------------------------------------------------------------------------

    def degrees(self, values: Iterable[Scalar]) -> dict[str, int]:
        """Return the highest degree of the numerators in the cosine and sine of each angle."""
        terms = [powers for value in values for powers, _ in self.ring.terms(value.numerator)]
        return {
            angle: max((p.get(("cos", angle), 0) + p.get(("sin", angle), 0) for p in terms), default=0)
            for angle in self.angles
        }

    def polynomial(self, value: Scalar, degrees: Mapping[str, int] | None = None) -> Polynomial:
        """Return the numerator of a scalar times Π (t² + u²)^degree: homogeneous in each pair (t, u).

        `degrees` are the scalar's own unless given (so that several scalars get the same factor).
        """
        if self.parts != self.ring.parts:
            raise TooComplex("a fraction of an angle among the conditions")
        terms = list(self.ring.terms(value.numerator))
        degrees = self.degrees([value]) if degrees is None else degrees

        @cache
        def powers_of(angle: str, cosines: int, sines: int, degree: int) -> Polynomial:
            t, u = self.pair(angle)
            rest = degree - cosines - sines
            return (u * u - t * t) ** cosines * (2 * t * u) ** sines * (t * t + u * u) ** rest

        total = self.zero
        for powers, coefficient in terms:
            self.ring.budget.check()
            term = self.context.constant(fmpq(coefficient.numerator, coefficient.denominator))
            for generator, power in powers.items():
                if generator[0] not in ("cos", "sin"):
                    term = term * self.variable(generator) ** power
            for angle, degree in degrees.items():
                term = term * powers_of(angle, powers.get(("cos", angle), 0), powers.get(("sin", angle), 0), degree)
            total = total + term
        return total

    def scalar(self, polynomial: Polynomial) -> Scalar | None:
        """Return the polynomial in cosines and sines (t² + u² = 1); None where a degree in (t, u) is odd."""
        if any(self.degree(polynomial, angle) % 2 for angle in self.angles):
            return None
        ring, total = self.ring, self.ring.zero
        for exponents, coefficient in polynomial.terms():
            term = ring.rational(Fraction(int(coefficient.p), int(coefficient.q)))
            for angle in self.angles:
                t, u = (int(exponents[k]) for k in self.slots(angle))
                term = term * _half_powers(ring, angle, t, u)
            for generator in self.others:
                power = int(exponents[self.slot(generator)])
                if power:
                    term = term * ring.generator(generator) ** power
            total = total + term
        return total

    def squares_to_scalar(self, polynomial: Polynomial) -> Scalar:
        """Return a scalar with the real zeros of a polynomial: itself, or its square where a degree is odd."""
        value = self.scalar(polynomial)
        if value is None:
            value = self.scalar(polynomial * polynomial)
        assert value is not None
        return value

    # -- operations ----------------------------------------------------------------------------------------------------

    def factors(self, polynomial: Polynomial) -> list[tuple[Polynomial, int]]:
        """Return the irreducible factors with their powers, t² + u² left out: it is never zero."""
        _, found = polynomial.factor()
        norms = [t * t + u * u for t, u in map(self.pair, self.angles)]
        return [(f, int(power)) for f, power in found if all(_monic(f) != _monic(norm) for norm in norms)]

    def substitute(self, polynomial: Polynomial, values: Mapping[int, Polynomial]) -> Polynomial:
        """Return the polynomial with variables, given by index, replaced."""
        degrees = polynomial.degrees()
        if not any(degrees[slot] for slot in values):
            return polynomial
        return polynomial.compose(*(values.get(k, self.context.gen(k)) for k in range(self.context.nvars())))

    def divides(self, divisor: Polynomial, polynomial: Polynomial) -> bool:
        """Whether a polynomial is a multiple of another."""
        return bool(divmod(polynomial, divisor)[1].is_zero())


def _half_powers(ring: Ring, angle: str, t: int, u: int) -> Scalar:
    """Return sin^t(θ/2) cos^u(θ/2) for t + u even: of (1 − c)/2, (1 + c)/2 and s/2."""
    cosine, sine = ring.generator(("cos", angle)), ring.generator(("sin", angle))
    half = ring.rational(1) / ring.rational(2)
    value = (half * (1 - cosine)) ** (t // 2) * (half * (1 + cosine)) ** (u // 2)
    return value * half * sine if t % 2 else value


def _monic(polynomial: fmpq_mpoly) -> fmpq_mpoly:
    return polynomial / polynomial.leading_coefficient()
