"""Square roots over one configuration: those of squares are taken, with given signs of what is under them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from fractions import Fraction
from math import prod
from typing import Any

from armproof.verification.algebra.ring import Ring, Scalar
from armproof.verification.algebra.roots import sqrt_of_rational
from armproof.verification.inverse.roots import SubstitutionRoots
from armproof.verification.singularities.half_angles import HalfAngles


class OpenSign(Exception):
    """The sign of a factor decides a square root; both cases are to be looked at."""

    def __init__(self, factor: str) -> None:
        super().__init__(factor)
        self.factor = factor


class ConfigurationRoots(SubstitutionRoots):
    """Square roots over one configuration: that of a square is taken, with given signs of what is under it.

    Squares are found in half-angle coordinates, where factors are unique: √((a_3 C_2 − d_3 S_23)²) is found although its
    normal form does not show it. A factor that has both signs has one of `signs`, or OpenSign is raised.
    """

    def __init__(self, ring: Ring, positive: Iterable[str]) -> None:
        super().__init__(ring, positive)
        self.signs: Mapping[str, int] = {}

    def sqrt(self, value: Scalar) -> Scalar:
        """Return the square root that is not negative; raises OpenSign where a sign decides it."""
        value = value.normal()
        if value.is_zero() or not value.denominator.is_one():
            return super().sqrt(value)
        root = self._root(value)
        return super().sqrt(value) if root is None else root

    def _root(self, value: Scalar) -> Scalar | None:
        """Return the root of a perfect square in the field of half-angle tangents, or None where it is none."""
        half = HalfAngles(self.ring, [value])
        content, factors = half.polynomial(value).factor()
        if int(content.p) < 0 or any(power % 2 for _, power in factors):
            return None
        root, open_factors = half.one, []
        for factor, power in factors:
            root = root * factor ** (power // 2)
            if power % 4 and not self._has_one_sign(half, factor):
                open_factors.append(factor)
        found = half.scalar(root)
        if found is None:
            return None
        sign = prod(self._sign(half, group) for group in _grouped(half, open_factors))
        return found * sqrt_of_rational(self.ring, Fraction(int(content.p), int(content.q))) * sign

    def _sign(self, half: HalfAngles, factor: Any) -> int:
        names = [f"{letter}({angle})" for angle in half.angles for letter in "tu"] + [g[1] for g in half.others]
        key = f"{factor} of {', '.join(names)}"
        if key not in self.signs:
            raise OpenSign(key)
        return self.signs[key]


def _grouped(half: HalfAngles, factors: list[Any]) -> list[Any]:
    """Return the factors, those of one angle alone multiplied: the sign of a sine or a cosine is one sign."""
    groups: dict[object, Any] = {}
    for factor in factors:
        used = half.used(factor)
        key = used[0] if len(used[0]) == 1 and not used[1] else str(factor)
        groups[key] = groups.get(key, half.one) * factor
    return list(groups.values())
