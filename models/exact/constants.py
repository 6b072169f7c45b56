"""The numbers of an arm's constants, as its plant has them."""

from __future__ import annotations

from collections.abc import Mapping
from math import cos, sin

from armproof.models.exact.numbers import angle_value
from armproof.models.exact.polynomial import Generator, root_value


def constant_value(generator: Generator, values: Mapping[str, float]) -> float:
    """Return the number of a generator that no joint moves.

    Args:
        generator: a square root, a length, or the cosine or sine of a constant angle, named or numeric ("pi/5", "0.3").
        values: lengths (m) and angles (rad) by their symbols.
    """
    kind, name = generator
    if kind == "sqrt":
        return root_value(name)
    if kind == "symbol":
        return values[name]
    angle = values[name] if name in values else angle_value(name)
    return cos(angle) if kind == "cos" else sin(angle)
