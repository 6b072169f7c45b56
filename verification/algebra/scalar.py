"""A scalar of the exact algebra: a quotient of two polynomials, each in the normal form of its ring."""

from __future__ import annotations

from fractions import Fraction
from typing import TYPE_CHECKING

from flint import fmpq, fmpq_mpoly

from armproof.verification.errors import NoValue

if TYPE_CHECKING:
    from armproof.verification.algebra.calculus import Ring


class Scalar:
    """numerator/denominator, both in normal form; the operators keep them so."""

    __slots__ = ("denominator", "numerator", "ring")

    def __init__(self, ring: Ring, numerator: fmpq_mpoly, denominator: fmpq_mpoly) -> None:
        self.ring, self.numerator, self.denominator = ring, numerator, denominator

    def _coerce(self, other: object) -> tuple[Scalar, Scalar]:
        if not isinstance(other, Scalar):
            other = self.ring.rational(other)  # type: ignore[arg-type]
        return self.ring.lift(self), self.ring.lift(other)

    def __add__(self, other: object) -> Scalar:
        a, b = self._coerce(other)
        if a.numerator.is_zero():
            return b
        if b.numerator.is_zero():
            return a
        if a.denominator == b.denominator:
            total = Scalar(a.ring, a.numerator + b.numerator, a.denominator)
            return total if a.denominator.is_one() else total.normal()
        multiply = a.ring.multiply
        numerator = multiply(a.numerator, b.denominator) + multiply(b.numerator, a.denominator)
        return Scalar(a.ring, a.ring.reduce(numerator), multiply(a.denominator, b.denominator)).normal()

    def __sub__(self, other: object) -> Scalar:
        a, b = self._coerce(other)
        return a + (-b)

    def __neg__(self) -> Scalar:
        return Scalar(self.ring, -self.numerator, self.denominator)

    def __mul__(self, other: object) -> Scalar:
        a, b = self._coerce(other)
        if a.numerator.is_zero() or b.is_one():
            return a
        if b.numerator.is_zero() or a.is_one():
            return b
        numerator = a.ring.multiply(a.numerator, b.numerator)
        if a.denominator.is_one() and b.denominator.is_one():
            return Scalar(a.ring, numerator, a.denominator)
        return Scalar(a.ring, numerator, a.ring.multiply(a.denominator, b.denominator)).normal()

    def __truediv__(self, other: object) -> Scalar:
        a, b = self._coerce(other)
        if b.is_zero():
            raise NoValue("a division by zero")
        return a * Scalar(b.ring, b.denominator, b.numerator).normal()

    __radd__ = __add__
    __rmul__ = __mul__

    def __rsub__(self, other: object) -> Scalar:
        return -(self - other)

    def __pow__(self, exponent: int) -> Scalar:
        if exponent < 0:
            return self.ring.one / self**-exponent
        result = self.ring.one
        for _ in range(exponent):
            result = result * self
        return result

    def normal(self) -> Scalar:
        """Return the quotient with a common factor cancelled and a constant denominator divided out."""
        ring = self.ring
        numerator, denominator = self.numerator, self.denominator
        if denominator.is_one():
            return self
        if numerator.is_zero():
            return ring.zero
        if not denominator.is_constant():
            common = numerator.gcd(denominator)
            if not common.is_constant():
                numerator, denominator = divmod(numerator, common)[0], divmod(denominator, common)[0]
        content = denominator.leading_coefficient()
        if content != 1:
            numerator, denominator = numerator / content, denominator / content
        return Scalar(ring, numerator, denominator)

    def is_zero(self) -> bool:
        """Decide whether the value is zero for every configuration."""
        return bool(self.numerator.is_zero())

    def is_one(self) -> bool:
        """Decide whether the value is one for every configuration."""
        return bool(self.numerator.is_one() and self.denominator.is_one())

    def as_fraction(self) -> Fraction | None:
        """Return the value where it is a rational constant, else None."""
        value = self.normal()
        if not (value.numerator.is_constant() and value.denominator.is_one()):
            return None
        coefficient = value.numerator.leading_coefficient() if not value.numerator.is_zero() else fmpq(0)
        return Fraction(int(coefficient.p), int(coefficient.q))

    def __repr__(self) -> str:
        def show(polynomial: fmpq_mpoly) -> str:
            terms = [
                "·".join(
                    [
                        str(c),
                        *(f"{kind[0]}[{name}]{'^' + str(p) if p > 1 else ''}" for (kind, name), p in powers.items()),
                    ]
                )
                for powers, c in self.ring.terms(polynomial)
            ]
            return " + ".join(terms) or "0"

        return (
            show(self.numerator)
            if self.denominator.is_one()
            else f"({show(self.numerator)})/({show(self.denominator)})"
        )
