"""The sign of a polynomial whose sign does not change: 1 − cos²θ is never negative, whichever form it has."""

from __future__ import annotations

import math
import random
import re

from flint import fmpq_mpoly

from armproof.models.exact.numbers import angle_value
from armproof.models.exact.polynomial import Generator
from armproof.verification.algebra.ring import Ring

POINTS = 24


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
