"""One irreducible factor as a condition: an angle, a sum of angles, a relation between lengths, or an equation."""

from __future__ import annotations

import itertools
from collections.abc import Collection
from dataclasses import dataclass
from enum import Enum
from functools import cached_property
from math import cos, prod, sin

from flint import fmpq

from armproof.models.exact.numbers import angle_value, is_number
from armproof.models.exact.polynomial import root_value
from armproof.verification.singularities.half_angles import HalfAngles, Polynomial

MOST_ANGLES = 4  # in a sum of angles that is recognised


class Kind(Enum):
    """What a factor says where it vanishes."""

    NEVER = "never"  # it has no real zero for positive lengths
    LENGTHS = "lengths"  # a relation between the lengths alone
    ANGLE = "angle"  # a sum of angles is a multiple of a quarter turn
    EQUATION = "equation"  # any other equation


@dataclass(frozen=True)
class AngleSum:
    """The condition Σ ± θ = turns · π/2, with turns 0, 1, 2 or −1."""

    signs: tuple[tuple[str, int], ...]
    turns: int


@dataclass(frozen=True, eq=False)
class Factor:
    """An irreducible polynomial in half-angle coordinates, whose real zeros are one condition.

    Attributes:
        half: the coordinates.
        polynomial: irreducible over ℚ, homogeneous in each pair (t, u).
        positive: the symbols taken as positive, the lengths.
    """

    half: HalfAngles
    polynomial: Polynomial
    positive: frozenset[str]

    @cached_property
    def kind(self) -> Kind:
        """What the factor says."""
        angles, others = self.half.used(self.polynomial)
        if never_zero(self.half, self.polynomial, self.positive):
            return Kind.NEVER
        if all(map(is_number, angles)) and all(name in self.positive or name.isdigit() for _, name in others):
            return Kind.LENGTHS
        return Kind.ANGLE if self.angle_sum is not None else Kind.EQUATION

    @cached_property
    def angle_sum(self) -> AngleSum | None:
        """The sum of angles that the factor fixes at a multiple of a quarter turn; None where it does not."""
        angles, others = self.half.used(self.polynomial)
        if others or not 1 <= len(angles) <= MOST_ANGLES:
            return None
        if any(self.half.degree(self.polynomial, angle) != 1 for angle in angles):
            return None
        monic = self.polynomial / self.polynomial.leading_coefficient()
        for signs in itertools.product((1, -1), repeat=len(angles) - 1):
            chosen = ((angles[0], 1), *zip(angles[1:], signs, strict=True))
            sine, cosine = half_sum(self.half, chosen)
            for turns, candidate in ((0, sine), (2, cosine), (1, sine - cosine), (-1, sine + cosine)):
                if (candidate / candidate.leading_coefficient() - monic).is_zero():
                    return AngleSum(chosen, turns)
        return None


def half_sum(half: HalfAngles, signs: Collection[tuple[str, int]]) -> tuple[Polynomial, Polynomial]:
    """Return sin and cos of half of Σ ± θ, times a common positive factor."""
    sine, cosine = half.zero, half.one
    for angle, sign in signs:
        t, u = half.pair(angle)
        sine, cosine = sine * u + sign * cosine * t, cosine * u - sign * sine * t
    return sine, cosine


def never_zero(half: HalfAngles, polynomial: Polynomial, positive: Collection[str]) -> bool:
    """Whether a polynomial has no zero for real angles and positive lengths, as far as signs and discriminants show.

    It has none where all terms have one sign and cannot vanish together, or where it is a definite quadratic form in one
    pair (t, u).
    """
    if polynomial.is_zero():
        return False
    if (constant := _number(half, polynomial)) is not None:
        return abs(constant) > 1e-9
    free = [slot for angle in half.angles for slot in half.slots(angle)]
    free += [half.slot(g) for g in half.others if not (g[1] in positive or g[0] == "sqrt")]
    if _one_sign(polynomial, free) and not _vanish_together(half, polynomial, free):
        return True
    return any(_is_definite(half, polynomial, angle, positive) for angle in half.used(polynomial)[0])


def _number(half: HalfAngles, polynomial: Polynomial) -> float | None:
    """Return the value of a polynomial of constants alone, such as the sine of 0.3; None where it holds a variable."""
    angles, others = half.used(polynomial)
    if not all(map(is_number, angles)) or any(kind != "sqrt" for kind, _ in others):
        return None
    values = [0.0] * half.context.nvars()
    for angle in angles:
        t, u = half.slots(angle)
        values[t], values[u] = sin(angle_value(angle) / 2), cos(angle_value(angle) / 2)
    for generator in others:
        values[half.slot(generator)] = root_value(generator[1])
    terms = ((int(c.p) / int(c.q), powers) for powers, c in polynomial.terms())
    return sum(
        factor * prod(value ** int(power) for value, power in zip(values, powers, strict=True) if power)
        for factor, powers in terms
    )


def _one_sign(polynomial: Polynomial, free: list[int]) -> bool:
    """Whether every term is ≥ 0, or every term ≤ 0."""
    signs = {coefficient > 0 for coefficient in polynomial.coeffs()}
    return len(signs) == 1 and all(exponents[slot] % 2 == 0 for exponents in polynomial.monoms() for slot in free)


def _vanish_together(half: HalfAngles, polynomial: Polynomial, free: list[int]) -> bool:
    """Whether some variables can be zero, never t and u of one angle both, so that every term has one of them."""
    monomials = [frozenset(slot for slot in free if exponents[slot]) for exponents in polynomial.monoms()]
    partner = {slot: slot ^ 1 for angle in half.angles for slot in half.slots(angle)}

    def possible(zero: frozenset[int]) -> bool:
        rest = next((monomial for monomial in monomials if not monomial & zero), None)
        if rest is None:
            return True
        return any(possible(zero | {slot}) for slot in rest if partner.get(slot) not in zero)

    return possible(frozenset())


def _is_definite(half: HalfAngles, polynomial: Polynomial, angle: str, positive: Collection[str]) -> bool:
    """Whether a polynomial A t² + B t u + C u² has 4AC − B² > 0 everywhere."""
    if half.degree(polynomial, angle) != 2:
        return False
    a, b, c = quadratic(half, polynomial, angle)
    discriminant = 4 * a * c - b * b
    slots = [slot for name in half.angles for slot in half.slots(name)]
    positive_terms = not discriminant.is_zero() and all(k > 0 for k in discriminant.coeffs())
    return positive_terms and _one_sign(discriminant, slots) and never_zero(half, discriminant, positive)


def quadratic(half: HalfAngles, polynomial: Polynomial, angle: str) -> tuple[Polynomial, Polynomial, Polynomial]:
    """Return A, B, C of A t² + B t u + C u²."""
    t, u = half.slots(angle)
    parts: list[dict[tuple[int, ...], fmpq]] = [{}, {}, {}]
    for exponents, coefficient in polynomial.terms():
        rest = tuple(0 if k in (t, u) else int(e) for k, e in enumerate(exponents))
        parts[2 - int(exponents[t])][rest] = coefficient
    a, b, c = (half.context.from_dict(part) for part in parts)
    return a, b, c
