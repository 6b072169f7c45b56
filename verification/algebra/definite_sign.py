"""The sign of a polynomial whose sign does not change: 1 − cos²θ is never negative, whichever form it has."""

from __future__ import annotations

import math
import re
from typing import TYPE_CHECKING

import numpy as np
from flint import fmpq_mpoly

from armproof.models.exact.numbers import angle_value
from armproof.models.exact.polynomial import Generator

if TYPE_CHECKING:
    from armproof.verification.algebra.angles import AngleRing

POINTS = 24


def is_negative(ring: AngleRing, polynomial: fmpq_mpoly) -> bool:
    """Whether a polynomial is negative at POINTS random points, angles being anywhere and all else positive.

    It chooses between the two roots ±k of k² and proves nothing: what is said of the root is decided afterwards.
    """
    generator = np.random.default_rng(POINTS)
    angles: dict[str, np.ndarray] = {}
    symbols: dict[Generator, np.ndarray] = {}
    total = np.zeros(POINTS)
    for powers, coefficient in ring.terms(polynomial):
        term = np.full(POINTS, float(coefficient))
        for (kind, name), power in powers.items():
            if kind in ("cos", "sin"):
                if name not in angles:
                    angles[name] = _angle(name, generator)
                value = np.cos(angles[name]) if kind == "cos" else np.sin(angles[name])
            elif kind in ("sqrt", "pi"):
                value = np.full(POINTS, math.sqrt(int(name)) if kind == "sqrt" else math.pi)
            elif kind == "symbol":
                value = symbols.setdefault((kind, name), generator.uniform(0.2, 2.0, POINTS))
            else:
                return False  # a root or an arc function inside: its own sign is open
            term = term * value**power
        total += term
    return bool((total < 0).all())


def _angle(name: str, generator: np.random.Generator) -> np.ndarray:
    """A constant angle as it is (pi/5, 0.5), any other anywhere."""
    if "pi/" in name or re.fullmatch(r"[\d.]+", name):
        return np.full(POINTS, angle_value(name))
    return generator.uniform(-math.pi, math.pi, POINTS)
