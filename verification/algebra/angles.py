"""Angles in the exact algebra: the cosine and sine of sums of angles, by the addition theorems.

The cosine and sine of an angle θ are generators. Where a fraction θ/d is met those of θ/d take their place, and all scalars
follow: cos θ is then a polynomial in cos θ/d.
"""

from __future__ import annotations

import math
from fractions import Fraction
from functools import reduce

from armproof.models.exact.numbers import cos_sin_of_pi, cos_sin_of_radians
from armproof.models.exact.polynomial import Generator
from armproof.verification.algebra.ring import Radical, Ring, Scalar
from armproof.verification.errors import EvaluationError, TooComplex
from armproof.verification.findings import Kind, say

MAX_MULTIPLE = 24

Pair = tuple[Scalar, Scalar]  # cosine and sine of one angle


def cos_sin(angle: Scalar) -> Pair:
    """Return (cos, sin) of a linear form in angles, multiples of π, arc functions and a constant in radians.

    Raises:
        EvaluationError: the argument is not such a form.
        TooComplex: a multiple or a fraction of an angle that is too large.
    """
    angle = angle.normal()
    if not angle.denominator.is_constant():
        raise EvaluationError(say(Kind.COSINE_OF_QUOTIENT))
    ring = angle.ring
    pairs = [_cos_sin_term(ring, powers, coefficient) for powers, coefficient in list(ring.terms(angle.numerator))]
    return reduce(_sum, pairs) if pairs else (ring.one, ring.zero)


def _cos_sin_term(ring: Ring, powers: dict[Generator, int], coefficient: Fraction) -> Pair:
    """Return (cos, sin) of a term; of ±α they are cos α and ± sin α."""
    signs = [generator for generator in powers if generator[0] == "sign"]
    rest = {generator: power for generator, power in powers.items() if generator not in signs}
    cosine, sine = _cos_sin_of(ring, rest, coefficient)
    for sign in signs:
        sine = sine * ring.generator(sign)
    return cosine, sine


def _cos_sin_of(ring: Ring, powers: dict[Generator, int], coefficient: Fraction) -> Pair:
    if not powers:
        cosine, sine = cos_sin_of_radians(coefficient)
        return ring.from_entry(cosine), ring.from_entry(sine)
    if len(powers) != 1 or set(powers.values()) != {1}:
        raise EvaluationError(say(Kind.COSINE_OF_NO_ANGLE))
    ((kind, name),) = powers
    if kind == "pi":
        return constant_angle(ring, coefficient)
    if kind == "arc":
        if coefficient.denominator != 1:
            raise EvaluationError(say(Kind.FRACTION_OF_ARC))
        return _multiple(ring.arcs[name], int(coefficient))
    if kind != "symbol":
        raise EvaluationError(say(Kind.COSINE_OF_NO_ANGLE))
    parts = math.lcm(ring.parts.get(name, 1), coefficient.denominator)
    if parts != ring.parts.get(name, 1):
        _refine(ring, name, parts)
    return _multiple(_pair(ring, finest(ring, name)), int(coefficient * parts))


def constant_angle(ring: Ring, turns: Fraction) -> Pair:
    """Return (cos, sin) of turns·π, named as a trace names them: radicals for multiples of π/12, else a pair."""
    if turns not in ring.constants:
        cosine, sine = cos_sin_of_pi(turns)
        ring.constants[turns] = ring.from_entry(cosine), ring.from_entry(sine)
    return ring.constants[turns]


def finest(ring: Ring, name: str) -> str:
    """Return the angle whose cosine and sine are generators: θ, or θ/d where a fraction of it was met."""
    parts = ring.parts.get(name, 1)
    return f"{name}/{parts}" if parts > 1 else name


def has_arcs(value: Scalar) -> bool:
    """Whether the value holds an arc function, so that it is an angle known up to whole turns."""
    return bool(value.ring.arcs) and any(kind == "arc" for _, (kind, _) in value.ring.generators_of(value.numerator))


def _pair(ring: Ring, angle: str) -> Pair:
    return ring.generator(("cos", angle)), ring.generator(("sin", angle))


def _sum(a: Pair, b: Pair) -> Pair:
    return a[0] * b[0] - a[1] * b[1], a[1] * b[0] + a[0] * b[1]


def _multiple(pair: Pair, times: int) -> Pair:
    if abs(times) > MAX_MULTIPLE:
        raise TooComplex(say(Kind.TIMES_AN_ANGLE, times=times))
    total = reduce(_sum, [pair] * abs(times)) if times else (pair[0].ring.one, pair[0].ring.zero)
    return (total[0], -total[1]) if times < 0 else total


def _refine(ring: Ring, name: str, parts: int) -> None:
    """Put the cosine and sine of θ/parts in the place of those that were generators, and take the roots again.

    Raises:
        TooComplex: the document has too many denominators; the ring then stays as it is.
    """
    if parts > MAX_MULTIPLE:
        raise TooComplex(say(Kind.TOO_MANY_FRACTIONS))
    ring.budget.check()
    polynomials, coarse = ring.polynomials, finest(ring, name)
    _pair(ring, coarse)
    retired = {("cos", coarse), ("sin", coarse)}
    changed: dict[str, Radical] = {}
    for root, radical in ring.radicals.items():
        if retired & {generator for _, generator in ring.generators_of(radical.square.numerator)}:
            changed[root] = radical
            retired.add(("radical", root))
    pair = _multiple(_pair(ring, f"{name}/{parts}"), parts // ring.parts.get(name, 1))
    ring.parts[name] = parts
    ring.radicals = {root: radical for root, radical in ring.radicals.items() if root not in changed}
    polynomials.retire(retired)
    polynomials.replace({("cos", coarse): pair[0].numerator, ("sin", coarse): pair[1].numerator})
    for root, radical in changed.items():
        polynomials.replace({("radical", root): _root_again(ring, radical).numerator})


def _root_again(ring: Ring, radical: Radical) -> Scalar:
    square = ring.lift(radical.square)
    try:
        root = radical.rule(square)
        return root if root.denominator.is_one() else ring.radical(square.numerator, radical.rule)
    except Exception:  # the rule finds no root now; one of its own is right as well, and no scalar may be left without
        return ring.radical(square.numerator, radical.rule)
