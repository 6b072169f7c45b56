"""Polynomials over ℚ in joint variables, lengths, cosines, sines and square roots, in normal form.

Modulo c² + s² = 1 for every angle and r² = k for every square root, each polynomial has one normal form: its
remainder on division by those relations, which are a Gröbner basis for the lexicographic order used here (their
leading terms s² and r² are coprime). Two formulas are equal for every configuration and every length exactly when
their normal forms are: a decision, with no tolerance and no heuristic simplification. FLINT does the arithmetic.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from fractions import Fraction

from flint import Ordering, fmpq, fmpq_mpoly, fmpq_mpoly_ctx

from armproof.models.exact.polynomial import Generator
from armproof.verification.algebra.budget import Budget
from armproof.verification.errors import TooComplex
from armproof.verification.findings import Kind, say

MAX_TERM_PRODUCTS = 400_000
MAX_TERMS = 60_000
MAX_GENERATORS = 512
FIRST_SLOTS = 32  # most documents have fewer; each slot costs time in every product


class Polynomials:
    """A growing ring ℚ[generators] / relations, and the normal form of its polynomials.

    Later generators are larger in the lexicographic order, so a square root is always reduced into what it was made of.
    A generator may be retired: it is then a polynomial in later ones, cos θ = 2 cos² θ/2 − 1. A polynomial follows when
    it is lifted: FLINT's context tells to which generators it belongs.
    """

    def __init__(self, budget: Budget) -> None:
        self.budget = budget
        self._slots, self._retirements = FIRST_SLOTS, 0
        self.context = _context(self._slots, self._retirements)
        self.one = self.context.constant(1)
        self._slot: dict[Generator, int] = {}
        self._generator_at: list[Generator] = []
        self._relations: dict[int, fmpq_mpoly] = {}  # slot of the leading generator → relation
        self._images: dict[Generator, fmpq_mpoly] = {}  # what a retired generator is by others

    # -- generators ------------------------------------------------------------------------------------------------

    @property
    def size(self) -> int:
        """The number of generators met so far."""
        return len(self._generator_at)

    def __iter__(self) -> Iterator[Generator]:
        return iter(tuple(self._generator_at))

    def __contains__(self, generator: Generator) -> bool:
        return generator in self._slot

    def constant(self, value: int | Fraction) -> fmpq_mpoly:
        """Return a rational constant."""
        return self.context.constant(value if isinstance(value, int) else fmpq(value.numerator, value.denominator))

    def adjoin(self, generator: Generator) -> fmpq_mpoly:
        """Return a new generator."""
        slot = len(self._generator_at)
        if slot == self._slots:
            if slot >= MAX_GENERATORS:
                raise TooComplex(say(Kind.TOO_MANY_SYMBOLS, most=MAX_GENERATORS))
            self._slots *= 2
            self._renew()
        self._slot[generator] = slot
        self._generator_at.append(generator)
        return self.variable(generator)

    def relate(self, generator: Generator, relation: fmpq_mpoly) -> None:
        """Give the newest generator its relation, led by its square."""
        self._relations[self._slot[generator]] = relation

    def variable(self, generator: Generator) -> fmpq_mpoly:
        """Return a generator, or what it is by others where it was retired."""
        if generator in self._images:
            return self.lift(self._images[generator])
        return self.context.gen(self._slots - 1 - self._slot[generator])

    def retire(self, generators: Collection[Generator]) -> None:
        """Let some generators, and the relations that they lead, stand for polynomials in others from now on."""
        for generator in generators:
            self._relations.pop(self._slot[generator], None)
        self._retirements += 1
        self._renew()

    def replace(self, images: Mapping[Generator, fmpq_mpoly]) -> None:
        """Give retired generators the polynomials for which they stand."""
        self._images.update(images)

    def _renew(self) -> None:
        """Move to a context for today's generators; no relation that is left holds a retired one."""
        self.context = _context(self._slots, self._retirements)
        self.one = self.context.constant(1)
        self._relations = {slot: self._moved(relation) for slot, relation in self._relations.items()}

    # -- normal form -----------------------------------------------------------------------------------------------

    def lift(self, polynomial: fmpq_mpoly) -> fmpq_mpoly:
        """Return the polynomial in today's context (the ring may have grown, or retired generators, since)."""
        context = polynomial.context()
        if context is self.context:
            return polynomial
        if str(context.name(0)).partition("g")[0] == str(self._retirements):  # none since
            return polynomial.project_to_context(self.context)
        return self.reduce(self._moved(polynomial))

    def _moved(self, polynomial: fmpq_mpoly) -> fmpq_mpoly:
        """Return the polynomial with what its generators are today, not reduced."""
        last, zero = polynomial.context().nvars() - 1, self.context.constant(0)
        images = [
            self.variable(self._generator_at[last - k]) if degree > 0 else zero
            for k, degree in enumerate(polynomial.degrees())
        ]
        return polynomial.compose(*images, ctx=self.context)

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
            raise TooComplex(say(Kind.LARGE_PRODUCT, one=len(a), other=len(b)))
        self.budget.check()
        product = self.reduce(a * b)
        if len(product) > MAX_TERMS:
            raise TooComplex(say(Kind.LARGE_EXPRESSION, terms=len(product)))
        return product

    # -- what a polynomial is made of --------------------------------------------------------------------------------

    def terms(self, polynomial: fmpq_mpoly) -> Iterator[tuple[dict[Generator, int], Fraction]]:
        """Yield the terms as (powers of generators, coefficient)."""
        polynomial = self.lift(polynomial)
        present = self.generators_of(polynomial)
        for exponents, coefficient in polynomial.terms():
            powers = {generator: int(exponents[k]) for k, generator in present if exponents[k]}
            above, below = int(coefficient.p), int(coefficient.q)
            yield powers, Fraction(above) if below == 1 else Fraction(above, below)  # the first seeks no common factor

    def split(
        self, polynomial: fmpq_mpoly, apart: Collection[Generator]
    ) -> list[tuple[dict[Generator, int], fmpq_mpoly]]:
        """Return the powers of the generators that are set apart, each product with the polynomial in the others behind it."""
        polynomial = self.lift(polynomial)
        places = [(k, generator) for k, generator in self.generators_of(polynomial) if generator in apart]
        alike: dict[tuple[int, ...], dict[tuple[int, ...], fmpq]] = {}
        for exponents, coefficient in polynomial.terms():
            rest = list(exponents)
            for k, _ in places:
                rest[k] = 0
            alike.setdefault(tuple(int(exponents[k]) for k, _ in places), {})[tuple(rest)] = coefficient
        return [
            (
                {generator: power for (_, generator), power in zip(places, powers, strict=True) if power},
                self.context.from_dict(rest),
            )
            for powers, rest in alike.items()
        ]

    def generators_of(self, polynomial: fmpq_mpoly) -> list[tuple[int, Generator]]:
        """Return the generators that a polynomial holds, each with its place among the exponents of a term."""
        if polynomial.is_constant():
            return []
        last = self._slots - 1
        degrees = self.lift(polynomial).degrees()
        return [(k, self._generator_at[last - k]) for k, degree in enumerate(degrees) if degree > 0]


def _context(slots: int, retirements: int) -> fmpq_mpoly_ctx:
    return fmpq_mpoly_ctx.get([f"{retirements}g{slot}" for slot in reversed(range(slots))], Ordering.lex)
