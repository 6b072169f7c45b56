"""The exact algebra: polynomials over ℚ in joint variables, lengths, cosines, sines and square roots.

Modulo c² + s² = 1 for every angle and r² = k for every square root, each polynomial has one normal form: its
remainder on division by those relations, which are a Gröbner basis for the lexicographic order used here (their
leading terms s² and r² are coprime). Two formulas are equal for every configuration and every length exactly when
their normal forms are: a decision, with no tolerance and no heuristic simplification. Quotients are compared
crosswise. FLINT does the arithmetic.
"""

from __future__ import annotations

import math
import time
from collections.abc import Iterable, Mapping
from fractions import Fraction

from flint import Ordering, fmpq, fmpq_mpoly, fmpq_mpoly_ctx

from models.entry import Entry
from models.exact import cos_sin_of_pi, cos_sin_of_radians
from verification.errors import EvaluationError, NoValue, TooComplex

Generator = tuple[str, str]
MAX_TERM_PRODUCTS = 400_000
MAX_TERMS = 60_000
FIRST_SLOTS = 64


class AngleFraction(Exception):
    """A fraction of an angle was met (θ/2): the ring must be rebuilt with that fraction as its generator."""

    def __init__(self, symbol: str, denominator: int) -> None:
        super().__init__(f"{symbol}/{denominator}")
        self.symbol, self.denominator = symbol, denominator


class Ring:
    """A growing ring ℚ[generators] / relations.

    Generators are named as in a trace: ("cos", angle), ("sin", angle), ("symbol", name), ("sqrt", "3"); beside them
    stand ("pi", ""), ("radical", n) and ("arc", n). Later generators are larger in the lexicographic order, so a
    square root is always reduced into what it was made of.
    """

    def __init__(self, denominators: Mapping[str, int] | None = None) -> None:
        self._slots = FIRST_SLOTS
        self._context = _context(FIRST_SLOTS)
        self._slot: dict[Generator, int] = {}
        self._generator_at: list[Generator] = []
        self._relations: dict[int, fmpq_mpoly] = {}  # slot of the leading generator → relation
        self.radicands: dict[int, Scalar] = {}  # slot of a radical → its square
        self.arcs: dict[str, tuple[Scalar, Scalar]] = {}  # arc name → (cos, sin) of it
        self.denominators = dict(denominators or {})  # angle → d where cos(angle/d) is the generator
        self.signs_chosen = False  # whether √(k²) was taken as k for a k that may be negative
        self.deadline = math.inf
        self.zero = self.rational(0)
        self.one = self.rational(1)

    # -- generators ------------------------------------------------------------------------------------------------

    def rational(self, value: int | Fraction) -> Scalar:
        """Return a rational constant."""
        number = Fraction(value)
        return Scalar(self, self._context.constant(fmpq(number.numerator, number.denominator)), self._context.constant(1))

    def generator(self, generator: Generator) -> Scalar:
        """Return a generator, adding it and its relation where it is new."""
        kind, name = generator
        if kind in ("cos", "sin") and (parts := self.denominators.get(name)):
            cosine, sine = self._multiple(self._pair(f"{name}/{parts}"), parts)
            return cosine if kind == "cos" else sine
        if generator not in self._slot:
            if kind in ("cos", "sin"):
                self._pair(name)
            elif kind == "sqrt":
                slot = self._add(generator)
                root = self._variable(slot)
                self._relations[slot] = root * root - int(name)
            else:
                self._add(generator)
        return Scalar(self, self._variable(self._slot[generator]), self._context.constant(1))

    def symbol(self, name: str) -> Scalar:
        """Return a free symbol: a length, a joint variable, a letter of a general statement."""
        return self.generator(("symbol", name))

    def _pair(self, angle: str) -> tuple[Scalar, Scalar]:
        if ("cos", angle) not in self._slot:
            cosine = self._add(("cos", angle))
            sine = self._add(("sin", angle))
            s, c = self._variable(sine), self._variable(cosine)
            self._relations[sine] = s * s + c * c - 1
        one = self._context.constant(1)
        return (
            Scalar(self, self._variable(self._slot["cos", angle]), one),
            Scalar(self, self._variable(self._slot["sin", angle]), one),
        )

    def _add(self, generator: Generator) -> int:
        slot = len(self._generator_at)
        if slot == self._slots:
            if slot >= 512:
                raise TooComplex("more than 512 symbols in one document")
            self._slots *= 2
            self._context = _context(self._slots)
            self._relations = {k: p.project_to_context(self._context) for k, p in self._relations.items()}
            self.zero, self.one = self.lift(self.zero), self.lift(self.one)
        self._slot[generator] = slot
        self._generator_at.append(generator)
        return slot

    def _variable(self, slot: int) -> fmpq_mpoly:
        return self._context.gen(self._slots - 1 - slot)

    def lift(self, value: Scalar) -> Scalar:
        """Bring the scalar, in place, into today's context (the ring may have grown since it was made)."""
        if value.numerator.context() is not self._context:
            value.numerator = value.numerator.project_to_context(self._context)
            value.denominator = value.denominator.project_to_context(self._context)
        return value

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

    def check_time(self) -> None:
        """Raise TooComplex when the display at hand has had its time."""
        if time.monotonic() > self.deadline:
            raise TooComplex("more time than a display may take")

    def multiply(self, a: fmpq_mpoly, b: fmpq_mpoly) -> fmpq_mpoly:
        """Return the product in normal form, within the bounds on size and time."""
        if len(a) * len(b) > MAX_TERM_PRODUCTS:
            raise TooComplex(f"a product of {len(a):,} by {len(b):,} terms")
        self.check_time()
        product = self.reduce(a * b)
        if len(product) > MAX_TERMS:
            raise TooComplex(f"an expression of {len(product):,} terms")
        return product

    def terms(self, polynomial: fmpq_mpoly) -> Iterable[tuple[dict[Generator, int], Fraction]]:
        """Yield the terms as (powers of generators, coefficient)."""
        last = self._slots - 1
        polynomial = polynomial if polynomial.context() is self._context else polynomial.project_to_context(self._context)
        for exponents, coefficient in polynomial.terms():
            powers = {self._generator_at[last - index]: int(power) for index, power in enumerate(exponents) if power}
            yield powers, Fraction(int(coefficient.p), int(coefficient.q))

    def from_entry(self, entry: Mapping[tuple[tuple[Generator, int], ...], Fraction]) -> Scalar:
        """Return a traced entry (models.trace) as a scalar of this ring."""
        total = self.zero
        for monomial, coefficient in entry.items():
            term = self.rational(coefficient)
            for generator, power in monomial:
                term = term * self.generator(generator) ** power
            total = total + term
        return total

    # -- angles ----------------------------------------------------------------------------------------------------

    def cos_sin(self, angle: Scalar) -> tuple[Scalar, Scalar]:
        """Return (cos, sin) of a linear form in angles, multiples of π, arc functions and a constant in radians.

        Raises EvaluationError where the argument is not such a form, AngleFraction where it holds a fraction θ/d
        for which this ring was not made.
        """
        angle = angle.normal()
        if not angle.denominator.is_constant():
            raise EvaluationError("the cosine of a quotient")
        cosine, sine = self.one, self.zero
        for powers, coefficient in self.terms(angle.numerator):
            pair = self._cos_sin_term(powers, coefficient)
            cosine, sine = cosine * pair[0] - sine * pair[1], sine * pair[0] + cosine * pair[1]
        return cosine, sine

    def _cos_sin_term(self, powers: dict[Generator, int], coefficient: Fraction) -> tuple[Scalar, Scalar]:
        if not powers:
            return self._from_entries(cos_sin_of_radians(coefficient))
        if len(powers) != 1 or set(powers.values()) != {1}:
            raise EvaluationError("the cosine of something that is not a sum of angles")
        (kind, name), _ = powers.popitem()
        if kind == "pi":
            return self._constant_angle(coefficient)
        if kind == "arc":
            if coefficient.denominator != 1:
                raise EvaluationError("a fraction of an arc function")
            return self._multiple(self.arcs[name], int(coefficient))
        if kind != "symbol":
            raise EvaluationError("the cosine of something that is not a sum of angles")
        parts = self.denominators.get(name, 1)
        scaled = coefficient * parts
        if scaled.denominator != 1:
            raise AngleFraction(name, math.lcm(parts, coefficient.denominator))
        base = self._pair(f"{name}/{parts}" if parts > 1 else name)
        return self._multiple(base, int(scaled))

    def _signed(self, pair: tuple[Scalar, Scalar], negative: bool) -> tuple[Scalar, Scalar]:
        return (pair[0], -pair[1]) if negative else pair

    def _multiple(self, pair: tuple[Scalar, Scalar], times: int) -> tuple[Scalar, Scalar]:
        if abs(times) > 24:
            raise TooComplex(f"{times} times an angle")
        cosine, sine = self.one, self.zero
        for _ in range(abs(times)):
            cosine, sine = cosine * pair[0] - sine * pair[1], sine * pair[0] + cosine * pair[1]
        return self._signed((cosine, sine), times < 0)

    def _constant_angle(self, turns: Fraction) -> tuple[Scalar, Scalar]:
        """Return (cos, sin) of turns·π, named as a trace names them: radicals for multiples of π/12, else a pair."""
        return self._from_entries(cos_sin_of_pi(turns))

    def _from_entries(self, pair: tuple[Entry, Entry]) -> tuple[Scalar, Scalar]:
        return self.from_entry(pair[0]), self.from_entry(pair[1])

    # -- square roots and arc functions ----------------------------------------------------------------------------

    def sqrt(self, value: Scalar) -> Scalar:
        """Return the square root, a new generator r with r² = value unless it is known or a perfect square.

        √(n/d) is √(n·d)/d; rational factors become roots of primes. The sign is that of the non-negative root for
        positive d: what rests on it is confirmed on the double plant as well.
        """
        value = value.normal()
        if value.is_zero():
            return self.zero
        if not value.denominator.is_one():
            radicand = Scalar(self, self.multiply(value.numerator, value.denominator), self._context.constant(1))
            return self.sqrt(radicand) / Scalar(self, value.denominator, self._context.constant(1))
        content, factors = value.numerator.factor()
        if int(content.p) < 0 and not factors:
            raise EvaluationError("the square root of a negative number")
        inside = self._context.constant(1 if int(content.p) > 0 else -1)
        outside = self._root_of_rational(Fraction(abs(int(content.p)), int(content.q)))
        for factor, power in factors:
            outside = outside * Scalar(self, factor, self._context.constant(1)) ** (power // 2)
            self.signs_chosen |= power > 1 and not self._is_symbol(factor)
            if power % 2:
                inside = inside * factor
        if inside.is_one():
            return outside
        for slot, radicand in self.radicands.items():
            if self.lift(radicand).numerator == inside:
                return outside * Scalar(self, self._variable(slot), self._context.constant(1))
        slot = self._add(("radical", str(len(self.radicands))))
        inside = inside if inside.context() is self._context else inside.project_to_context(self._context)
        self.radicands[slot] = Scalar(self, inside, self._context.constant(1))
        root = self._variable(slot)
        self._relations[slot] = root * root - inside
        return outside * Scalar(self, root, self._context.constant(1))

    def _is_symbol(self, factor: fmpq_mpoly) -> bool:
        """Whether a factor is a length, a letter or a root, and not something that changes its sign as an angle does."""
        terms = list(self.terms(factor))
        return len(terms) == 1 and all(kind in ("symbol", "sqrt", "radical") for kind, _ in terms[0][0])

    def _root_of_rational(self, value: Fraction) -> Scalar:
        number = value.numerator * value.denominator
        outside, inside = 1, []
        factor = 2
        while factor * factor <= number and factor < 10_000:
            while number % (factor * factor) == 0:
                number //= factor * factor
                outside *= factor
            if number % factor == 0:
                inside.append(factor)
                number //= factor
            factor += 1
        if number > 1:
            root = math.isqrt(number)
            if root * root == number:
                outside *= root
            else:
                inside.append(number)
        result = self.rational(Fraction(outside, value.denominator))
        for prime in inside:
            result = result * self.generator(("sqrt", str(prime)))
        return result

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
        """Return atan2(y, x): the angle with cosine x/√(x²+y²) and sine y/√(x²+y²)."""
        radius = self.sqrt(x * x + y * y)
        if radius.is_zero():
            raise EvaluationError("atan2(0, 0) has no value")
        return self.arc(x / radius, y / radius)

    # -- derivatives -----------------------------------------------------------------------------------------------

    def derivative(self, value: Scalar, variable: Scalar) -> Scalar:
        """Return ∂value/∂variable for a variable that is a free symbol (a joint variable, a length).

        d cos θ = −sin θ, d sin θ = cos θ, d√k = dk/(2√k); arc functions are outside this algebra.
        """
        found = list(self.terms(variable.numerator)) if variable.denominator.is_one() else []
        if len(found) != 1 or found[0][1] != 1 or len(found[0][0]) != 1:
            raise EvaluationError("a derivative with respect to something that is not a variable")
        (kind, name), power = next(iter(found[0][0].items()))
        if kind != "symbol" or power != 1:
            raise EvaluationError("a derivative with respect to something that is not a variable")
        numerator = self._poly_derivative(value.numerator, name)
        denominator = self._poly_derivative(value.denominator, name)
        bottom = Scalar(self, value.denominator, self._context.constant(1))
        top = Scalar(self, value.numerator, self._context.constant(1))
        return (numerator * bottom - top * denominator) / (bottom * bottom)

    def _poly_derivative(self, polynomial: fmpq_mpoly, name: str) -> Scalar:
        one = self._context.constant(1)
        polynomial = polynomial if polynomial.context() is self._context else polynomial.project_to_context(self._context)
        last = self._slots - 1
        total = self.zero
        degrees = polynomial.degrees()
        parts = self.denominators.get(name, 1)
        angle = f"{name}/{parts}" if parts > 1 else name
        for slot, generator in enumerate(self._generator_at[: len(degrees)]):
            if not degrees[last - slot]:
                continue
            kind, label = generator
            inner: Scalar | None = None
            if generator == ("symbol", name):
                inner = self.one
            elif kind == "cos" and label == angle:
                inner = -self.generator(("sin", angle)) * self.rational(Fraction(1, parts))
            elif kind == "sin" and label == angle:
                inner = self.generator(("cos", angle)) * self.rational(Fraction(1, parts))
            elif kind == "radical":
                inner = self._poly_derivative(self.lift(self.radicands[slot]).numerator, name)
                if not inner.is_zero():
                    inner = inner / (Scalar(self, self._variable(slot), one) * self.rational(2))
            elif kind == "arc":
                cosine, sine = self.arcs[label]
                variable = self.symbol(name)
                inner = cosine * self.derivative(sine, variable) - sine * self.derivative(cosine, variable)
            if inner is not None and not inner.is_zero():
                total = total + Scalar(self, self.reduce(polynomial.derivative(last - slot)), one) * inner
        return total

    def substitute(self, value: Scalar, values: Mapping[str, Scalar]) -> Scalar:
        """Return the value with symbols (joint variables, lengths) replaced, their cosines and sines with them."""
        replacements: dict[Generator, Scalar] = {}
        for name, replacement in values.items():
            replacements["symbol", name] = replacement
            parts = self.denominators.get(name, 1)
            angle = f"{name}/{parts}" if parts > 1 else name
            if ("cos", angle) in self._slot:
                pair = self.cos_sin(replacement / parts)
                replacements["cos", angle], replacements["sin", angle] = pair
        return self._replace(value.numerator, replacements) / self._replace(value.denominator, replacements)

    def _replace(self, polynomial: fmpq_mpoly, replacements: Mapping[Generator, Scalar]) -> Scalar:
        total = self.zero
        for powers, coefficient in self.terms(polynomial):
            term = self.rational(coefficient)
            for generator, power in powers.items():
                if generator in replacements:
                    base = replacements[generator]
                elif generator[0] == "radical":
                    slot = self._slot[generator]
                    base = self.sqrt(self._replace(self.lift(self.radicands[slot]).numerator, replacements))
                elif generator[0] == "arc":
                    cosine, sine = (self._replace(v.numerator, replacements) / self._replace(v.denominator, replacements)
                                    for v in map(self.lift, self.arcs[generator[1]]))  # fmt: skip
                    base = self.arc(cosine, sine)
                else:
                    base = self.generator(generator)
                term = term * base**power
            total = total + term
        return total

    def without_sines_below(self, value: Scalar) -> Scalar:
        """Return the same quotient with a denominator free of sines: d·d̄ is, where d̄ is d with s replaced by −s.

        In that form common factors cancel that s² = 1 − c² hides, such as s in (1 − c²)/s.
        """
        value = value.normal()
        last = self._slots - 1
        for slot, (kind, _) in enumerate(self._generator_at):
            if kind != "sin" or not value.denominator.degrees()[last - slot]:
                continue
            conjugate = self._conjugate(value.denominator, slot)
            value = Scalar(self, self.multiply(value.numerator, conjugate), self.multiply(value.denominator, conjugate)).normal()
        return value

    def _conjugate(self, polynomial: fmpq_mpoly, slot: int) -> fmpq_mpoly:
        index = self._slots - 1 - slot
        signed = {exponents: (-c if exponents[index] % 2 else c) for exponents, c in polynomial.terms()}
        return self._context.from_dict(signed)

    def is_extended(self) -> bool:
        """Whether square roots of expressions or arc functions have been adjoined."""
        return bool(self.radicands) or bool(self.arcs)

    def leaves_open(self, difference: Scalar) -> bool:
        """Whether a difference that is not zero in normal form may vanish nevertheless.

        So it may if it holds a square root of an expression, an arc function, or the cosine of a constant angle that is
        no multiple of π/12 (cos 2π/5 is a generator of its own, though it is a polynomial in cos π/5).
        """
        parts = (difference.numerator, difference.denominator)
        return any(
            kind in ("radical", "arc") or (kind in ("cos", "sin") and (name[:1].isdigit() or name.startswith("pi/")))
            for part in parts
            for powers, _ in self.terms(part)
            for kind, name in powers
        )

    def has_arcs(self, value: Scalar) -> bool:
        """Whether the value holds an arc function, so that it is an angle known up to whole turns."""
        return any(kind == "arc" for powers, _ in self.terms(value.numerator) for kind, _ in powers)


def _context(slots: int) -> fmpq_mpoly_ctx:
    return fmpq_mpoly_ctx.get([f"g{slot}" for slot in reversed(range(slots))], Ordering.lex)


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
                "·".join([str(c), *(f"{kind[0]}[{name}]{'^' + str(p) if p > 1 else ''}" for (kind, name), p in powers.items())])
                for powers, c in self.ring.terms(polynomial)
            ]
            return " + ".join(terms) or "0"

        return show(self.numerator) if self.denominator.is_one() else f"({show(self.numerator)})/({show(self.denominator)})"
