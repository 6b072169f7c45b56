"""Square roots in the proof of an inverse: no root of a square is taken with a sign that is not certain."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from fractions import Fraction
from typing import Any

from flint import fmpq_mpoly

from armproof.models.exact.polynomial import Generator
from armproof.verification.algebra.budget import Budget
from armproof.verification.algebra.calculus import Ring
from armproof.verification.algebra.scalar import Scalar
from armproof.verification.errors import NoValue
from armproof.verification.singularities.half_angles import HalfAngles


class SubstitutionRing(Ring):
    """A ring in which √(k²) is |k|: a generator whose square is k², so that what is proved holds for both signs of k.

    k itself is taken where it cannot be negative: a length, a root, the radicand of a root that has a value.

    Args:
        positive: the symbols that are not negative, the lengths.
    """

    def __init__(self, denominators: Mapping[str, int], positive: Iterable[str], budget: Budget | None = None) -> None:
        super().__init__(denominators, budget)
        self.positive = frozenset(positive)
        self._constants: dict[Fraction, tuple[Scalar, Scalar]] = {}

    def sign(self, name: str) -> Scalar:
        """Return a sign, +1 or −1: a generator whose square is 1, so that what is proved holds for both."""
        generator = ("sign", name)
        if generator not in self._slot:
            slot = self._add(generator)
            root = self._variable(slot)
            self._relations[slot] = root * root - 1
        return self.generator(generator)

    def _constant_angle(self, turns: Fraction) -> tuple[Scalar, Scalar]:
        if turns not in self._constants:
            self._constants[turns] = super()._constant_angle(turns)
        return self._constants[turns]

    def _cos_sin_term(self, powers: dict[Generator, int], coefficient: Fraction) -> tuple[Scalar, Scalar]:
        """Return (cos, sin) of a term; of ±α they are cos α and ± sin α."""
        signs = [generator for generator in powers if generator[0] == "sign"]
        rest = {generator: power for generator, power in powers.items() if generator not in signs}
        if not rest:
            return super()._cos_sin_term(powers, coefficient)
        cosine, sine = super()._cos_sin_term(rest, coefficient)
        for generator in signs:
            sine = sine * self.generator(generator)
        return cosine, sine

    def sqrt(self, value: Scalar) -> Scalar:
        """Return the square root that is not negative; raises NoValue for that of a negative number."""
        value = value.normal()
        if value.is_zero():
            return self.zero
        if not value.denominator.is_one():
            below = self.scalar(value.denominator)
            sign = self._definite_sign(value.denominator)
            below = below * sign if sign else self._known_root(value.denominator * value.denominator)  # √(n d)/|d|
            return self.sqrt(self.scalar(self.multiply(value.numerator, value.denominator))) / below
        content, factors = value.numerator.factor()
        outside, inside = self._split(content, factors)
        return outside if inside.is_one() else outside * self._known_root(inside)

    def atan2(self, y: Scalar, x: Scalar) -> Scalar:
        """Return atan2(y, x): cosine x/√(x² + y²), sine y/√(x² + y²); a common factor may be negative and stays."""
        radius = self.sqrt(x * x + y * y)
        if radius.is_zero():
            raise NoValue("atan2(0, 0) has no value")
        return self.arc(x / radius, y / radius)

    def _split(self, content: Any, factors: list[tuple[fmpq_mpoly, int]]) -> tuple[Scalar, fmpq_mpoly]:
        """Return what certainly is not negative and comes out of the root, and what stays under it."""
        if int(content.p) < 0 and not factors:
            raise NoValue("the square root of a negative number")
        inside = self._context.constant(1 if int(content.p) > 0 else -1)
        outside = self._root_of_rational(Fraction(abs(int(content.p)), int(content.q)))
        for factor, power in factors:
            if power > 1 and (sign := self._definite_sign(factor)):
                outside, power = outside * (self.scalar(factor) * sign) ** (power // 2), power % 2
            outside, power = outside * self.scalar(factor) ** (power // 4 * 2), power % 4
            if power:
                inside = self.multiply(inside, self._power(factor, power))
        return outside, inside

    def _power(self, factor: fmpq_mpoly, power: int) -> fmpq_mpoly:
        """Return a power in normal form."""
        result = self._context.constant(1)
        for _ in range(power):
            result = self.multiply(result, factor)
        return result

    def _definite_sign(self, factor: fmpq_mpoly) -> int:
        """Return 1 for a polynomial that cannot be negative, −1 for one that cannot be positive, 0 where it is not known.

        The radicand of a root cannot be negative where the root has a value, nor can its sum with squares.
        """
        for radicand in self.radicands.values():
            known = self.lift(radicand).numerator
            for sign in (1, -1):
                rest = sign * factor - known
                if rest.is_zero() or self._sign_of_factors(rest) > 0:
                    return sign
        return self._sign_of_factors(factor)

    def _sign_of_factors(self, polynomial: fmpq_mpoly) -> int:
        """Return the sign that a polynomial has by its factors in half-angle coordinates, 0 where it is not known."""
        half = HalfAngles(self, [self.scalar(polynomial)])
        content, factors = half.polynomial(self.scalar(polynomial)).factor()
        one_sign = all(power % 2 == 0 or self._has_one_sign(half, part) for part, power in factors)
        return (1 if int(content.p) > 0 else -1) if one_sign else 0

    def _has_one_sign(self, half: HalfAngles, factor: Any) -> bool:
        """Whether a polynomial cannot be negative: a sum of squares, or a form A u² + C u t + B t² without a real zero."""
        positive = {half.slot(g) for g in half.others if g[0] in ("sqrt", "radical") or g[1] in self.positive}
        if _is_sum_of_squares(factor, positive):
            return True
        angles, _ = half.used(factor)
        if len(angles) != 1 or half.degree(factor, angles[0]) != 2:
            return False
        t, u = half.slots(angles[0])
        parts = {(2, 0): half.zero, (1, 1): half.zero, (0, 2): half.zero}
        for exponents, coefficient in factor.terms():
            rest = tuple(0 if k in (t, u) else e for k, e in enumerate(exponents))
            parts[int(exponents[t]), int(exponents[u])] += half.context.from_dict({rest: coefficient})
        a, c, b = parts[0, 2], parts[1, 1], parts[2, 0]
        above = any(not part.is_zero() and _is_sum_of_squares(part, positive) for part in (a, b))
        return above and _is_nonnegative(4 * a * b - c * c, positive)

    def _known_root(self, inside: fmpq_mpoly) -> Scalar:
        """Return the generator whose square is a polynomial, adding it where it is new."""
        inside = self.reduce(inside)
        for slot, radicand in self.radicands.items():
            if self.lift(radicand).numerator == inside:
                return self.scalar(self._variable(slot))
        slot = self._add(("radical", str(len(self.radicands))))
        inside = self._lifted(inside)
        self.radicands[slot] = self.scalar(inside)
        root = self._variable(slot)
        self._relations[slot] = root * root - inside
        return self.scalar(root)


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
