"""The exact algebra: a ring of polynomials with all that was adjoined to it, and its scalars, quotients of two of them.

Two scalars are compared crosswise, each polynomial being in its normal form. What is made of scalars stands beside the
ring: sines and cosines (angles), square roots and arc functions (roots), derivatives and substitution (calculus).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction

from flint import fmpq, fmpq_mpoly

from armproof.models.exact.polynomial import Entry, Generator
from armproof.verification.algebra.budget import Budget
from armproof.verification.algebra.polynomials import Polynomials
from armproof.verification.errors import NoValue
from armproof.verification.findings import Kind, say


class Scalar:
    """numerator/denominator, both in normal form; the operators keep them so."""

    __slots__ = ("denominator", "numerator", "ring")

    def __init__(self, ring: Ring, numerator: fmpq_mpoly, denominator: fmpq_mpoly) -> None:
        self.ring, self.numerator, self.denominator = ring, numerator, denominator

    @property
    def generators(self) -> set[Generator]:
        """The symbols, cosines, roots, … of which it is made, above and below."""
        return {each for part in (self.numerator, self.denominator) for _, each in self.ring.generators_of(part)}

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
            raise NoValue(say(Kind.DIVISION_BY_ZERO))
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


RootRule = Callable[[Scalar], Scalar]  # how a square root is taken


@dataclass(frozen=True)
class Radical:
    """A square root that was adjoined: its square, and the rule by which its root is taken again where it has changed."""

    square: Scalar
    rule: RootRule


class Ring:
    """A growing ring ℚ[generators] / relations with its quotients.

    Generators are named as in a trace: ("cos", angle), ("sin", angle), ("symbol", name), ("sqrt", "3"); beside them
    stand ("pi", ""), ("sign", name), ("radical", name) and ("arc", name).

    Attributes:
        budget: the time for what is computed in it.
        parts: angle θ → d where cos(θ/d) and sin(θ/d) are the generators; 1 unless a fraction of it was met.
        radicals: name of a radical → what it is the root of.
        arcs: name of an arc function → (cos, sin) of it.
        constants: the cosines and sines of multiples of π met so far.
        signs_chosen: whether √(k²) was taken as k for a k that may be negative, since `forget_signs`.
    """

    def __init__(self, budget: Budget | None = None) -> None:
        self.budget = Budget() if budget is None else budget
        self.polynomials = Polynomials(self.budget)
        self.reduce, self.multiply = self.polynomials.reduce, self.polynomials.multiply
        self.terms, self.generators_of = self.polynomials.terms, self.polynomials.generators_of
        self.parts: dict[str, int] = {}
        self.radicals: dict[str, Radical] = {}
        self.arcs: dict[str, tuple[Scalar, Scalar]] = {}
        self.constants: dict[Fraction, tuple[Scalar, Scalar]] = {}
        self.signs_chosen = False
        self.zero, self.one = self.rational(0), self.rational(1)

    @property
    def size(self) -> int:
        """The number of generators met so far."""
        return self.polynomials.size

    @property
    def angles(self) -> set[str]:
        """The angles of which a cosine was met so far."""
        named = (name for kind, name in self.polynomials if kind == "cos" and not name[0].isdigit())
        return {name.partition("/")[0] for name in named} - {"pi"}

    def scalar(self, polynomial: fmpq_mpoly) -> Scalar:
        """Return a polynomial in normal form as a scalar."""
        return Scalar(self, polynomial, self.polynomials.one)

    def rational(self, value: int | Fraction) -> Scalar:
        """Return a rational constant."""
        return self.scalar(self.polynomials.constant(value))

    def symbol(self, name: str) -> Scalar:
        """Return a free symbol: a length, a joint variable, a letter of a general statement."""
        return self.generator(("symbol", name))

    def generator(self, generator: Generator) -> Scalar:
        """Return a generator, adding it and its relation where it is new."""
        if generator not in self.polynomials:
            self._adjoin(generator)
        return self.scalar(self.polynomials.variable(generator))

    def _adjoin(self, generator: Generator) -> None:
        kind, name = generator
        if kind in ("cos", "sin"):
            c, s = (self.polynomials.adjoin((function, name)) for function in ("cos", "sin"))
            self.polynomials.relate(("sin", name), s * s + self.polynomials.lift(c) ** 2 - 1)
            return
        variable = self.polynomials.adjoin(generator)
        if kind in ("sqrt", "sign"):
            self.polynomials.relate(generator, variable * variable - (int(name) if kind == "sqrt" else 1))

    def radical(self, square: fmpq_mpoly, rule: RootRule) -> Scalar:
        """Return the generator whose square is a polynomial in normal form, adding it where it is new."""
        for name, known in self.radicals.items():
            if self.lift(known.square).numerator == square:
                return self.generator(("radical", name))
        generator = ("radical", str(self.size))
        variable = self.polynomials.adjoin(generator)
        square = self.polynomials.lift(square)
        self.polynomials.relate(generator, variable * variable - square)
        self.radicals[generator[1]] = Radical(self.scalar(square), rule)
        return self.scalar(variable)

    def radicand(self, name: str) -> Scalar:
        """Return the square of the radical of that name."""
        return self.lift(self.radicals[name].square)

    def from_entry(self, entry: Entry) -> Scalar:
        """Return a traced entry (armproof.models.exact.trace) as a scalar of this ring."""
        polynomials = self.polynomials
        for generator in dict.fromkeys(each for monomial in entry for each, _ in monomial):
            if generator not in polynomials:  # all before the first is used: a new one may need a new context
                self._adjoin(generator)
        total = polynomials.constant(0)
        for monomial, number in entry.items():
            term = polynomials.constant(number)
            for generator, power in monomial:
                term *= polynomials.variable(generator) ** power if power > 1 else polynomials.variable(generator)
            total += term
        self.budget.check()
        return self.scalar(self.reduce(total))

    def lift(self, value: Scalar) -> Scalar:
        """Bring the scalar, in place, into the ring as it is today (it may have grown since the scalar was made)."""
        if value.numerator.context() is not self.polynomials.context:
            value.numerator = self.polynomials.lift(value.numerator)
            value.denominator = self.polynomials.lift(value.denominator)
        return value

    def forget_signs(self) -> None:
        """Begin anew: what is evaluated from now on has chosen no sign of a root yet."""
        self.signs_chosen = False
