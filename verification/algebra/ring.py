"""Polynomials over ℚ in joint variables, lengths, cosines, sines and square roots, in normal form.

Modulo c² + s² = 1 for every angle and r² = k for every square root, each polynomial has one normal form: its
remainder on division by those relations, which are a Gröbner basis for the lexicographic order used here (their
leading terms s² and r² are coprime). Two formulas are equal for every configuration and every length exactly when
their normal forms are: a decision, with no tolerance and no heuristic simplification. Quotients are compared
crosswise. FLINT does the arithmetic.
"""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from typing import TYPE_CHECKING, cast

from flint import Ordering, fmpq, fmpq_mpoly, fmpq_mpoly_ctx

from armproof.models.exact.polynomial import Entry, Generator
from armproof.verification.algebra.budget import Budget
from armproof.verification.algebra.scalar import Scalar
from armproof.verification.errors import TooComplex

if TYPE_CHECKING:
    from armproof.verification.algebra.calculus import Ring

MAX_TERM_PRODUCTS = 400_000
MAX_TERMS = 60_000
MAX_GENERATORS = 512
FIRST_SLOTS = 32  # most documents have fewer; each slot costs time in every product


class QuotientRing:
    """A growing ring ℚ[generators] / relations.

    Generators are named as in a trace: ("cos", angle), ("sin", angle), ("symbol", name), ("sqrt", "3"); beside them
    stand ("pi", ""), ("radical", n) and ("arc", n). Later generators are larger in the lexicographic order, so a
    square root is always reduced into what it was made of.
    """

    def __init__(self, budget: Budget | None = None) -> None:
        self.budget = Budget() if budget is None else budget
        self._slots = FIRST_SLOTS
        self._context = _context(FIRST_SLOTS)
        self._slot: dict[Generator, int] = {}
        self._generator_at: list[Generator] = []
        self._relations: dict[int, fmpq_mpoly] = {}  # slot of the leading generator → relation
        self.zero = self.rational(0)
        self.one = self.rational(1)

    # -- scalars ---------------------------------------------------------------------------------------------------

    def scalar(self, numerator: fmpq_mpoly, denominator: fmpq_mpoly | None = None) -> Scalar:
        """Return numerator/denominator, both in normal form, as a scalar; the denominator is 1 unless given."""
        below = self._context.constant(1) if denominator is None else denominator
        return Scalar(cast("Ring", self), numerator, below)

    def rational(self, value: int | Fraction) -> Scalar:
        """Return a rational constant."""
        number = Fraction(value)
        return self.scalar(self._context.constant(fmpq(number.numerator, number.denominator)))

    def from_entry(self, entry: Entry) -> Scalar:
        """Return a traced entry (armproof.models.exact.trace) as a scalar of this ring."""
        total = self.zero
        for monomial, coefficient in entry.items():
            term = self.rational(coefficient)
            for generator, power in monomial:
                term = term * self.generator(generator) ** power
            total = total + term
        return total

    def lift(self, value: Scalar) -> Scalar:
        """Bring the scalar, in place, into today's context (the ring may have grown since it was made)."""
        if value.numerator.context() is not self._context:
            value.numerator = value.numerator.project_to_context(self._context)
            value.denominator = value.denominator.project_to_context(self._context)
        return value

    def _lifted(self, polynomial: fmpq_mpoly) -> fmpq_mpoly:
        return polynomial if polynomial.context() is self._context else polynomial.project_to_context(self._context)

    # -- generators ------------------------------------------------------------------------------------------------

    def generator(self, generator: Generator) -> Scalar:
        """Return a generator, adding it and its relation where it is new."""
        kind, name = generator
        if generator not in self._slot:
            if kind in ("cos", "sin"):
                self._pair(name)
            elif kind == "sqrt":
                slot = self._add(generator)
                root = self._variable(slot)
                self._relations[slot] = root * root - int(name)
            else:
                self._add(generator)
        return self.scalar(self._variable(self._slot[generator]))

    @property
    def size(self) -> int:
        """The number of generators met so far."""
        return len(self._generator_at)

    def symbol(self, name: str) -> Scalar:
        """Return a free symbol: a length, a joint variable, a letter of a general statement."""
        return self.generator(("symbol", name))

    def _pair(self, angle: str) -> tuple[Scalar, Scalar]:
        if ("cos", angle) not in self._slot:
            slots = self._add(("cos", angle)), self._add(("sin", angle))
            c, s = map(self._variable, slots)
            self._relations[slots[1]] = s * s + c * c - 1
        cosine, sine = (self._variable(self._slot[function, angle]) for function in ("cos", "sin"))
        return self.scalar(cosine), self.scalar(sine)

    def _add(self, generator: Generator) -> int:
        slot = len(self._generator_at)
        if slot == self._slots:
            if slot >= MAX_GENERATORS:
                raise TooComplex(f"more than {MAX_GENERATORS} symbols in one document")
            self._slots *= 2
            self._context = _context(self._slots)
            self._relations = {k: p.project_to_context(self._context) for k, p in self._relations.items()}
            self.zero, self.one = self.lift(self.zero), self.lift(self.one)
        self._slot[generator] = slot
        self._generator_at.append(generator)
        return slot

    def _variable(self, slot: int) -> fmpq_mpoly:
        return self._context.gen(self._slots - 1 - slot)

    # -- normal form -----------------------------------------------------------------------------------------------

    def reduce(self, polynomial: fmpq_mpoly) -> fmpq_mpoly:
        """Return the normal form: the remainder on division by the relations, the latest first."""
        if not self._relations:
            return polynomial
        degrees = polynomial.degrees()
        last = self._slots - 1
        for slot in reversed(self._relations):
            if degrees[last - slot] >= 2:
                polynomial = divmod(polynomial, self._relations[slot])[1]
                degrees = polynomial.degrees()
        return polynomial

    def multiply(self, a: fmpq_mpoly, b: fmpq_mpoly) -> fmpq_mpoly:
        """Return the product in normal form, within the bounds on size and time."""
        if len(a) * len(b) > MAX_TERM_PRODUCTS:
            raise TooComplex(f"a product of {len(a):,} by {len(b):,} terms")
        self.budget.check()
        product = self.reduce(a * b)
        if len(product) > MAX_TERMS:
            raise TooComplex(f"an expression of {len(product):,} terms")
        return product

    def terms(self, polynomial: fmpq_mpoly) -> Iterable[tuple[dict[Generator, int], Fraction]]:
        """Yield the terms as (powers of generators, coefficient)."""
        polynomial = self._lifted(polynomial)
        present = self.generators_of(polynomial)
        for exponents, coefficient in polynomial.terms():
            powers = {generator: int(exponents[k]) for k, generator in present if exponents[k]}
            yield powers, Fraction(int(coefficient.p), int(coefficient.q))

    def generators_of(self, polynomial: fmpq_mpoly) -> list[tuple[int, Generator]]:
        """Return the generators that a polynomial holds, each with its place among the exponents of a term."""
        last = self._slots - 1
        degrees = self._lifted(polynomial).degrees()
        return [(k, self._generator_at[last - k]) for k, degree in enumerate(degrees) if degree > 0]


def _context(slots: int) -> fmpq_mpoly_ctx:
    return fmpq_mpoly_ctx.get([f"g{slot}" for slot in reversed(range(slots))], Ordering.lex)
