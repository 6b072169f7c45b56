"""Square roots and arc functions in the exact algebra: each is a new generator, unless it is known."""

from __future__ import annotations

import math
import random
import re
from fractions import Fraction

from flint import fmpq_mpoly

from armproof.models.errors import ModelError
from armproof.models.exact.numbers import angle_value
from armproof.models.exact.polynomial import Generator, root
from armproof.verification.algebra.angles import constant_angle
from armproof.verification.algebra.ring import Ring, Scalar
from armproof.verification.errors import EvaluationError, NoValue, TooComplex
from armproof.verification.findings import Kind, say

POINTS = 24
_TWELFTHS = tuple(Fraction(twelfths, 12) for twelfths in range(-11, 13))


def is_negative(ring: Ring, polynomial: fmpq_mpoly) -> bool:
    """Whether a polynomial is negative at POINTS random points, angles being anywhere and all else positive.

    It chooses between the two roots ±k of k² and proves nothing: what is said of the root is decided afterwards.
    """
    terms = [(powers, float(coefficient)) for powers, coefficient in ring.terms(polynomial)]
    generators = {generator for powers, _ in terms for generator in powers}
    if any(kind in ("radical", "arc", "sign") for kind, _ in generators):
        return False  # a root or an arc function inside: its own sign is open
    angles = sorted({name for kind, name in generators if kind in ("cos", "sin")})
    source = random.Random(POINTS)
    return all(_value(terms, sorted(generators), angles, source) < 0 for _ in range(POINTS))


def _value(
    terms: list[tuple[dict[Generator, int], float]],
    generators: list[Generator],
    angles: list[str],
    source: random.Random,
) -> float:
    """Return the value at one random point."""
    radians = {name: _angle(name, source) for name in angles}
    values = {generator: _at(generator, radians, source) for generator in generators}
    return sum(k * math.prod(values[g] ** power for g, power in powers.items()) for powers, k in terms)


def _at(generator: Generator, radians: dict[str, float], source: random.Random) -> float:
    kind, name = generator
    if kind in ("cos", "sin"):
        return math.cos(radians[name]) if kind == "cos" else math.sin(radians[name])
    if kind == "sqrt":
        return math.sqrt(int(name))
    return math.pi if kind == "pi" else source.uniform(0.2, 2.0)


def _angle(name: str, source: random.Random) -> float:
    """A constant angle as it is (pi/5, 0.5), any other anywhere."""
    if "pi/" in name or re.fullmatch(r"[\d.]+", name):
        return float(angle_value(name))
    return source.uniform(-math.pi, math.pi)


def sqrt(value: Scalar) -> Scalar:
    """Return the square root, a new generator r with r² = value unless it is known or a perfect square.

    √(n/d) is √(n·d)/d; rational factors become roots of primes. The sign is that of the non-negative root for
    positive d: what rests on it is confirmed on the double plant as well.
    """
    value = value.normal()
    ring = value.ring
    if value.is_zero():
        return ring.zero
    if not value.denominator.is_one():
        radicand = ring.scalar(ring.multiply(value.numerator, value.denominator))
        return sqrt(radicand) / ring.scalar(value.denominator)
    content, factors = value.numerator.factor()
    if int(content.p) < 0 and not factors:
        raise NoValue(say(Kind.ROOT_OF_NEGATIVE))
    outside = sqrt_of_rational(ring, Fraction(abs(int(content.p)), int(content.q)))  # which may need a new context
    inside = ring.polynomials.constant(1 if int(content.p) > 0 else -1)
    for factor, power in factors:
        outside = outside * ring.scalar(factor) ** (power // 2)
        ring.signs_chosen |= power > 1 and not _is_symbol(ring, factor)
        if power % 2:
            inside = inside * ring.polynomials.lift(factor)
    if is_negative(ring, outside.numerator):
        outside = -outside
    return outside if inside.is_one() else outside * ring.radical(inside, sqrt)


def sqrt_of_rational(ring: Ring, value: Fraction) -> Scalar:
    """Return the square root of a rational number ≥ 0; raises TooComplex where its factors are not sought."""
    try:
        return ring.from_entry(root(value))
    except ModelError as problem:
        raise TooComplex(str(problem)) from None


def _is_symbol(ring: Ring, factor: fmpq_mpoly) -> bool:
    """Whether a factor is a length, a letter or a root, and not something that changes its sign as an angle does."""
    terms = list(ring.terms(factor))
    return len(terms) == 1 and all(kind in ("symbol", "sqrt", "radical") for kind, _ in terms[0][0])


def arc(cosine: Scalar, sine: Scalar) -> Scalar:
    """Return the angle with this cosine and sine, a generator that cos_sin turns back into them."""
    ring = cosine.ring
    known = [(turns, *constant_angle(ring, turns)) for turns in _TWELFTHS]  # arccos 1 is 0, atan2(1, 0) is π/2
    for turns, known_cosine, known_sine in known if _may_be_constant(cosine) and _may_be_constant(sine) else ():
        if (cosine - known_cosine).is_zero() and (sine - known_sine).is_zero():
            return ring.generator(("pi", "")) * ring.rational(turns)
    for name, (known_cosine, known_sine) in ring.arcs.items():
        if (known_cosine - cosine).is_zero() and (known_sine - sine).is_zero():
            return ring.generator(("arc", name))
    name = str(len(ring.arcs))
    ring.arcs[name] = (cosine, sine)
    return ring.generator(("arc", name))


def _may_be_constant(value: Scalar) -> bool:
    """Whether a value may be a number: a polynomial in normal form that holds a letter or an angle is none."""
    return not value.denominator.is_one() or all(kind == "sqrt" for kind, _ in value.generators)


def atan2(y: Scalar, x: Scalar) -> Scalar:
    """Return atan2(y, x): the angle with cosine x/√(x²+y²) and sine y/√(x²+y²), a common factor taken as positive."""
    if y.is_zero() and x.is_zero():
        raise EvaluationError(say(Kind.ATAN2_OF_ZEROS))
    common = _common_factor(y, x)
    y, x = y / common, x / common
    radius = sqrt(x * x + y * y)
    return arc(x / radius, y / radius)


def _common_factor(a: Scalar, b: Scalar) -> Scalar:
    """Return the common factor of two numerators: the root of k²(x² + y²) is not found where k² has been reduced."""
    ring = a.ring
    common = ring.lift(a).numerator.gcd(ring.lift(b).numerator)
    if common.is_constant():
        return ring.one
    ring.signs_chosen |= not _is_symbol(ring, common)
    return ring.scalar(-common if is_negative(ring, common) else common)
