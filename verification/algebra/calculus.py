"""The exact algebra's ring: derivatives, substitution, and what its normal form leaves open."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

from flint import fmpq_mpoly

from armproof.models.exact.polynomial import Generator
from armproof.verification.algebra.roots import RootRing
from armproof.verification.algebra.scalar import Scalar
from armproof.verification.errors import EvaluationError


class Ring(RootRing):
    """ℚ[joint variables, lengths, cosines, sines, square roots] / relations, with derivatives and substitution.

    Built in steps: polynomials in normal form (QuotientRing), angles (AngleRing), square roots and arc functions
    (RootRing).
    """

    def derivative(self, value: Scalar, variable: Scalar) -> Scalar:
        """Return ∂value/∂variable for a variable that is a free symbol (a joint variable, a length).

        d cos θ = −sin θ, d sin θ = cos θ, d√k = dk/(2√k), d atan2(s, c) = c ds − s dc for s² + c² = 1.
        """
        found = list(self.terms(variable.numerator)) if variable.denominator.is_one() else []
        if len(found) != 1 or found[0][1] != 1 or len(found[0][0]) != 1:
            raise EvaluationError("a derivative with respect to something that is not a variable")
        (kind, name), power = next(iter(found[0][0].items()))
        if kind != "symbol" or power != 1:
            raise EvaluationError("a derivative with respect to something that is not a variable")
        numerator = self._poly_derivative(value.numerator, name)
        denominator = self._poly_derivative(value.denominator, name)
        top, bottom = self.scalar(value.numerator), self.scalar(value.denominator)
        return (numerator * bottom - top * denominator) / (bottom * bottom)

    def _poly_derivative(self, polynomial: fmpq_mpoly, name: str) -> Scalar:
        polynomial = self._lifted(polynomial)
        last = self._slots - 1
        total = self.zero
        degrees = polynomial.degrees()
        parts, angle = self.denominators.get(name, 1), self._finest(name)
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
                    inner = inner / (self.scalar(self._variable(slot)) * self.rational(2))
            elif kind == "arc":
                cosine, sine = self.arcs[label]
                variable = self.symbol(name)
                inner = cosine * self.derivative(sine, variable) - sine * self.derivative(cosine, variable)
            if inner is not None and not inner.is_zero():
                total = total + self.scalar(self.reduce(polynomial.derivative(last - slot))) * inner
        return total

    def substitute(self, value: Scalar, values: Mapping[str, Scalar]) -> Scalar:
        """Return the value with symbols (joint variables, lengths) replaced, their cosines and sines with them."""
        replacements: dict[Generator, Scalar] = {}
        for name, replacement in values.items():
            replacements["symbol", name] = replacement
            parts, angle = self.denominators.get(name, 1), self._finest(name)
            if ("cos", angle) in self._slot:
                pair = self.cos_sin(replacement / parts)
                replacements["cos", angle], replacements["sin", angle] = pair
        return self._replaced(value, replacements)

    def _replaced(self, value: Scalar, replacements: Mapping[Generator, Scalar]) -> Scalar:
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
                    cosine, sine = (self._replaced(self.lift(v), replacements) for v in self.arcs[generator[1]])
                    base = self.arc(cosine, sine)
                else:
                    base = self.generator(generator)
                term = term * base**power
            total = total + term
        return total

    def leaves_open(self, difference: Scalar) -> bool:
        """Whether a difference that is not zero in normal form may vanish nevertheless.

        So it may if it holds a square root of an expression, an arc function, or the cosine of a constant angle that is
        no multiple of π/12 (cos 2π/5 is a generator of its own, though it is a polynomial in cos π/5).
        """
        parts = (difference.numerator, difference.denominator)
        return any(_is_open(generator) for part in parts for _, generator in self.generators_of(part))


def _is_open(generator: Generator) -> bool:
    kind, name = generator
    return kind in ("radical", "arc") or (kind in ("cos", "sin") and (name[:1].isdigit() or name.startswith("pi/")))
