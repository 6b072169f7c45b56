"""Angles in the exact algebra: the cosine and sine of sums of angles."""

from __future__ import annotations

import math
from collections.abc import Mapping
from fractions import Fraction

from armproof.models.exact.numbers import cos_sin_of_pi, cos_sin_of_radians
from armproof.models.exact.polynomial import Entry, Generator
from armproof.verification.algebra.budget import Budget
from armproof.verification.algebra.ring import QuotientRing
from armproof.verification.algebra.scalar import Scalar
from armproof.verification.errors import EvaluationError, TooComplex

MAX_MULTIPLE = 24


class AngleFraction(Exception):
    """A fraction of an angle was met (θ/2): the ring must be rebuilt with that fraction as its generator."""

    def __init__(self, symbol: str, denominator: int) -> None:
        super().__init__(f"{symbol}/{denominator}")
        self.symbol, self.denominator = symbol, denominator


class AngleRing(QuotientRing):
    """A ring in which linear forms in angles have a cosine and a sine, by the addition theorems."""

    def __init__(self, denominators: Mapping[str, int] | None = None, budget: Budget | None = None) -> None:
        super().__init__(budget)
        self.arcs: dict[str, tuple[Scalar, Scalar]] = {}  # arc name → (cos, sin) of it
        self.denominators = dict(denominators or {})  # angle → d where cos(angle/d) is the generator

    def generator(self, generator: Generator) -> Scalar:
        """Return a generator, adding it and its relation where it is new; the cosine of θ is one of θ/d in it."""
        kind, name = generator
        if kind in ("cos", "sin") and (parts := self.denominators.get(name)):
            cosine, sine = self._multiple(self._pair(f"{name}/{parts}"), parts)
            return cosine if kind == "cos" else sine
        return super().generator(generator)

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
        return self._multiple(self._pair(self._finest(name)), int(scaled))

    def _multiple(self, pair: tuple[Scalar, Scalar], times: int) -> tuple[Scalar, Scalar]:
        if abs(times) > MAX_MULTIPLE:
            raise TooComplex(f"{times} times an angle")
        cosine, sine = self.one, self.zero
        for _ in range(abs(times)):
            cosine, sine = cosine * pair[0] - sine * pair[1], sine * pair[0] + cosine * pair[1]
        return (cosine, -sine) if times < 0 else (cosine, sine)

    def _constant_angle(self, turns: Fraction) -> tuple[Scalar, Scalar]:
        """Return (cos, sin) of turns·π, named as a trace names them: radicals for multiples of π/12, else a pair."""
        return self._from_entries(cos_sin_of_pi(turns))

    def _from_entries(self, pair: tuple[Entry, Entry]) -> tuple[Scalar, Scalar]:
        return self.from_entry(pair[0]), self.from_entry(pair[1])

    def _finest(self, name: str) -> str:
        """Return the angle whose cosine and sine are generators: θ, or θ/d where a fraction of it was met."""
        parts = self.denominators.get(name, 1)
        return f"{name}/{parts}" if parts > 1 else name

    def has_arcs(self, value: Scalar) -> bool:
        """Whether the value holds an arc function, so that it is an angle known up to whole turns."""
        return any(kind == "arc" for powers, _ in self.terms(value.numerator) for kind, _ in powers)
