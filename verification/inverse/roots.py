"""Square roots in the proof of an inverse: no root of a square is taken with a sign that is not certain."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from functools import reduce
from typing import Any

from flint import fmpq_mpoly

from armproof.verification.algebra.ring import Ring, Scalar
from armproof.verification.algebra.roots import arc, sqrt_of_rational
from armproof.verification.errors import NoValue
from armproof.verification.findings import Kind, say
from armproof.verification.singularities.factors import quadratic
from armproof.verification.singularities.half_angles import HalfAngles


class SubstitutionRoots:
    """Square roots by which √(k²) is |k|: a generator whose square is k², so that what is proved holds for both signs of k.

    k itself is taken where it cannot be negative: a length, a root, the radicand of a root that has a value.

    Args:
        ring: the ring in which the roots are taken.
        positive: the symbols that are not negative, the lengths.
    """

    def __init__(self, ring: Ring, positive: Iterable[str]) -> None:
        self.ring = ring
        self.positive = frozenset(positive)

    def sqrt(self, value: Scalar) -> Scalar:
        """Return the square root that is not negative; raises NoValue for that of a negative number."""
        value = value.normal()
        if value.is_zero():
            return self.ring.zero
        if not value.denominator.is_one():
            below = self.ring.scalar(value.denominator)
            sign = self._definite_sign(value.denominator)
            below = below * sign if sign else self._known_root(value.denominator * value.denominator)  # √(n d)/|d|
            return self.sqrt(self.ring.scalar(self.ring.multiply(value.numerator, value.denominator))) / below
        content, factors = value.numerator.factor()
        outside, inside = self._split(content, factors)
        return outside if inside.is_one() else outside * self._known_root(inside)

    def atan2(self, y: Scalar, x: Scalar) -> Scalar:
        """Return atan2(y, x): cosine x/√(x² + y²), sine y/√(x² + y²); a common factor may be negative and stays."""
        radius = self.sqrt(x * x + y * y)
        if radius.is_zero():
            raise NoValue(say(Kind.ATAN2_OF_ZEROS))
        return arc(x / radius, y / radius)

    def _split(self, content: Any, factors: list[tuple[fmpq_mpoly, int]]) -> tuple[Scalar, fmpq_mpoly]:
        """Return what certainly is not negative and comes out of the root, and what stays under it."""
        if int(content.p) < 0 and not factors:
            raise NoValue(say(Kind.ROOT_OF_NEGATIVE))
        inside = self.ring.polynomials.constant(1 if int(content.p) > 0 else -1)
        outside = sqrt_of_rational(self.ring, Fraction(abs(int(content.p)), int(content.q)))
        for factor, power in factors:
            if power > 1 and (sign := self._definite_sign(factor)):
                outside, power = outside * (self.ring.scalar(factor) * sign) ** (power // 2), power % 2
            outside, power = outside * self.ring.scalar(factor) ** (power // 4 * 2), power % 4
            if power:
                inside = reduce(self.ring.multiply, [factor] * power, inside)
        return outside, inside

    def _definite_sign(self, factor: fmpq_mpoly) -> int:
        """Return 1 for a polynomial that cannot be negative, −1 for one that cannot be positive, 0 where it is not known.

        The radicand of a root cannot be negative where the root has a value, nor can its sum with squares.
        """
        for radical in self.ring.radicals.values():
            known = self.ring.lift(radical.square).numerator
            for sign in (1, -1):
                rest = sign * factor - known
                if rest.is_zero() or self._sign_of_factors(rest) > 0:
                    return sign
        return self._sign_of_factors(factor)

    def _sign_of_factors(self, polynomial: fmpq_mpoly) -> int:
        """Return the sign that a polynomial has by its factors in half-angle coordinates, 0 where it is not known."""
        half = HalfAngles(self.ring, [self.ring.scalar(polynomial)])
        content, factors = half.polynomial(self.ring.scalar(polynomial)).factor()
        one_sign = all(power % 2 == 0 or self._has_one_sign(half, part) for part, power in factors)
        return (1 if int(content.p) > 0 else -1) if one_sign else 0

    def _has_one_sign(self, half: HalfAngles, factor: Any) -> bool:
        """Whether a polynomial cannot be negative: a sum of squares, or a form A t² + C t u + B u² without a real zero."""
        positive = {half.slot(g) for g in half.others if g[0] in ("sqrt", "radical") or g[1] in self.positive}
        if _is_sum_of_squares(factor, positive):
            return True
        angles, _ = half.used(factor)
        if len(angles) != 1 or half.degree(factor, angles[0]) != 2:
            return False
        a, c, b = quadratic(half, factor, angles[0])
        above = any(not part.is_zero() and _is_sum_of_squares(part, positive) for part in (a, b))
        return above and _is_nonnegative(4 * a * b - c * c, positive)

    def _known_root(self, inside: fmpq_mpoly) -> Scalar:
        """Return the generator whose square is a polynomial, adding it where it is new."""
        return self.ring.radical(self.ring.reduce(inside), self.sqrt)


def _is_sum_of_squares(polynomial: Any, positive: set[int]) -> bool:
    """Whether a polynomial is a sum of products, with positive numbers, of squares and of variables that are not negative."""
    return all(
        int(coefficient.p) > 0 and all(int(power) % 2 == 0 or slot in positive for slot, power in enumerate(exponents))
        for exponents, coefficient in polynomial.terms()
    )


def _is_nonnegative(polynomial: Any, positive: set[int]) -> bool:
    if polynomial.is_zero() or _is_sum_of_squares(polynomial, positive):
        return True
    content, factors = polynomial.factor()
    return int(content.p) > 0 and all(power % 2 == 0 or _is_sum_of_squares(f, positive) for f, power in factors)
