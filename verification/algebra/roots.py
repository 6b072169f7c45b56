"""Square roots and arc functions in the exact algebra: each is a new generator, unless it is known."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

from flint import fmpq_mpoly

from armproof.models.errors import ModelError
from armproof.models.exact.polynomial import root
from armproof.verification.algebra.angles import AngleRing
from armproof.verification.algebra.budget import Budget
from armproof.verification.algebra.definite_sign import is_negative
from armproof.verification.algebra.scalar import Scalar
from armproof.verification.errors import EvaluationError, NoValue, TooComplex


class RootRing(AngleRing):
    """A ring to which square roots of its own expressions, and the angles of its points, are adjoined."""

    def __init__(self, denominators: Mapping[str, int] | None = None, budget: Budget | None = None) -> None:
        super().__init__(denominators, budget)
        self.radicands: dict[int, Scalar] = {}  # slot of a radical → its square
        self.signs_chosen = False  # whether √(k²) was taken as k for a k that may be negative

    def sqrt(self, value: Scalar) -> Scalar:
        """Return the square root, a new generator r with r² = value unless it is known or a perfect square.

        √(n/d) is √(n·d)/d; rational factors become roots of primes. The sign is that of the non-negative root for
        positive d: what rests on it is confirmed on the double plant as well.
        """
        value = value.normal()
        if value.is_zero():
            return self.zero
        if not value.denominator.is_one():
            radicand = self.scalar(self.multiply(value.numerator, value.denominator))
            return self.sqrt(radicand) / self.scalar(value.denominator)
        content, factors = value.numerator.factor()
        if int(content.p) < 0 and not factors:
            raise NoValue("the square root of a negative number")
        inside = self._context.constant(1 if int(content.p) > 0 else -1)
        outside = self._root_of_rational(Fraction(abs(int(content.p)), int(content.q)))
        for factor, power in factors:
            outside = outside * self.scalar(factor) ** (power // 2)
            self.signs_chosen |= power > 1 and not self._is_symbol(factor)
            if power % 2:
                inside = inside * factor
        if len(outside.numerator) > 1 and is_negative(self, outside.numerator):
            outside = -outside
        if inside.is_one():
            return outside
        for slot, radicand in self.radicands.items():
            if self.lift(radicand).numerator == inside:
                return outside * self.scalar(self._variable(slot))
        slot = self._add(("radical", str(len(self.radicands))))
        inside = self._lifted(inside)
        self.radicands[slot] = self.scalar(inside)
        variable = self._variable(slot)
        self._relations[slot] = variable * variable - inside
        return outside * self.scalar(variable)

    def _is_symbol(self, factor: fmpq_mpoly) -> bool:
        """Whether a factor is a length, a letter or a root, and not something that changes its sign as an angle does."""
        terms = list(self.terms(factor))
        return len(terms) == 1 and all(kind in ("symbol", "sqrt", "radical") for kind, _ in terms[0][0])

    def _root_of_rational(self, value: Fraction) -> Scalar:
        try:
            return self.from_entry(root(value))
        except ModelError as problem:
            raise TooComplex(str(problem)) from None

    def radicand(self, name: str) -> Scalar:
        """Return the square of the radical of that name."""
        return self.lift(self.radicands[self._slot["radical", name]])

    def arc(self, cosine: Scalar, sine: Scalar) -> Scalar:
        """Return the angle with this cosine and sine, a generator that cos_sin turns back into them."""
        for twelfths in range(-11, 13):  # arccos 1 is 0, atan2(1, 0) is π/2
            known_cosine, known_sine = self._constant_angle(Fraction(twelfths, 12))
            if (cosine - known_cosine).is_zero() and (sine - known_sine).is_zero():
                return self.generator(("pi", "")) * self.rational(Fraction(twelfths, 12))
        for name, (known_cosine, known_sine) in self.arcs.items():
            if (known_cosine - cosine).is_zero() and (known_sine - sine).is_zero():
                return self.generator(("arc", name))
        name = str(len(self.arcs))
        self.arcs[name] = (cosine, sine)
        return self.generator(("arc", name))

    def atan2(self, y: Scalar, x: Scalar) -> Scalar:
        """Return atan2(y, x): the angle with cosine x/√(x²+y²) and sine y/√(x²+y²), a common factor taken as positive."""
        if y.is_zero() and x.is_zero():
            raise EvaluationError("atan2(0, 0) has no value")
        common = self._common_factor(y, x)
        y, x = y / common, x / common
        radius = self.sqrt(x * x + y * y)
        return self.arc(x / radius, y / radius)

    def _common_factor(self, a: Scalar, b: Scalar) -> Scalar:
        """Return the common factor of two numerators: the root of k²(x² + y²) is not found where k² has been reduced."""
        common = self.lift(a).numerator.gcd(self.lift(b).numerator)
        if common.is_constant():
            return self.one
        self.signs_chosen |= not self._is_symbol(common)
        return self.scalar(-common if is_negative(self, common) else common)
