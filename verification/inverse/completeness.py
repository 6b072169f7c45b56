"""Completeness: every configuration that reaches a target is returned by some branch.

The target is that of a configuration q, and every joint solved before the one at hand is that of q. Then each root in a step
is that of a square, ±k, whose sign the configuration decides; for every choice of these signs there must be a branch on which
each step gives back the joint of q. So the solutions are the branches and no others, wherever the formulas have a value.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from fractions import Fraction
from itertools import product
from math import prod
from typing import Any

from armproof.models.arm import Arm
from armproof.verification.algebra.angles import cos_sin
from armproof.verification.algebra.budget import Budget
from armproof.verification.algebra.ring import Ring, Scalar
from armproof.verification.algebra.roots import sqrt_of_rational
from armproof.verification.inverse.derivation import Derivation, Signs
from armproof.verification.inverse.resolution import Resolution, forward_values
from armproof.verification.inverse.roots import SubstitutionRoots
from armproof.verification.inverse.symbolic_algebra import SymbolicAlgebra, free_algebra
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
        self._squares: dict[str, tuple[Scalar, tuple[str, ...]] | None] = {}  # each is met on every branch

    def sqrt(self, value: Scalar) -> Scalar:
        """Return the square root that is not negative; raises OpenSign where a sign decides it."""
        value = value.normal()
        if value.is_zero() or not value.denominator.is_one():
            return super().sqrt(value)
        written = str(value.numerator)
        if written not in self._squares:
            self._squares[written] = self._root(value)
        found = self._squares[written]
        return super().sqrt(value) if found is None else found[0] * prod(map(self._sign, found[1]))

    def _root(self, value: Scalar) -> tuple[Scalar, tuple[str, ...]] | None:
        """Return the root of a perfect square in the field of half-angle tangents but for the signs of factors, and these; None of no square."""
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
        names = [f"{letter}({angle})" for angle in half.angles for letter in "tu"] + [g[1] for g in half.others]
        signs = tuple(f"{factor} of {', '.join(names)}" for factor in _grouped(half, open_factors))
        return found * sqrt_of_rational(self.ring, Fraction(int(content.p), int(content.q))), signs

    def _sign(self, key: str) -> int:
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


def find_lost_step(derivation: Derivation, budget: Budget) -> str | None:
    """Return the first joint that no branch gives back for some configurations, or None where completeness is proved.

    Raises:
        TooComplex: the polynomials grow beyond the bounds.
        EvaluationError: a step that has no exact value.
    """
    return _Search(derivation, budget).lost(0, {}, {})


class _Search:
    def __init__(self, derivation: Derivation, budget: Budget) -> None:
        self.derivation = derivation
        self.arm: Arm = derivation.arm
        self.ring = Ring(budget)
        self.roots = ConfigurationRoots(self.ring, self.arm.lengths)
        given = forward_values(derivation, free_algebra(self.ring, self.arm, self.roots))
        self.algebra = SymbolicAlgebra(self.ring, self.arm, derivation.target, given, roots=self.roots)

    def lost(self, index: int, chosen: Signs, factors: Signs) -> str | None:
        """Return the joint lost at a step or after it, given the branch so far and the signs of some factors."""
        if index == len(self.derivation.steps):
            return None
        try:
            returning = self._returning(index, chosen, factors)
        except OpenSign as found:
            factor = found.factor
        else:
            lost = self.derivation.steps[index].joint
            for branch in returning:
                after = self.lost(index + 1, branch, factors)
                if after is None:
                    return None
                lost = after
            return lost
        # The sign of a root decides: what follows must hold for either.
        cases = (self.lost(index, chosen, {**factors, factor: sign}) for sign in (1, -1))
        return next((joint for joint in cases if joint is not None), None)

    def _returning(self, index: int, chosen: Signs, factors: Signs) -> list[Signs]:
        """Return the branches, with the signs that the step brings in, on which it gives back its joint."""
        returns, met = self._try(index, chosen, factors)
        new = [name for name in met if name not in chosen]
        branches: list[Signs] = [{**chosen, **dict.fromkeys(new, 1)}] if returns else []
        for signs in list(product((1, -1), repeat=len(new)))[1:]:
            branch = {**chosen, **dict(zip(new, signs, strict=True))}
            if self._try(index, branch, factors)[0]:
                branches.append(branch)
        return branches

    def _try(self, index: int, chosen: Signs, factors: Signs) -> tuple[bool, list[str]]:
        """Return whether a step gives back its joint, and the signs that it has met."""
        ring, step = self.ring, self.derivation.steps[index]
        self.roots.signs = factors
        self.algebra.solved = {k.joint: ring.symbol(k.joint) for k in self.derivation.steps[:index]}
        resolution = Resolution(self.derivation, self.algebra, chosen)
        difference = resolution.variable(step.formula) - ring.symbol(step.joint)
        if self.arm.joint(step.joint).kind == "revolute" and not difference.is_zero():
            difference = cos_sin(difference)[0] - 1
        return difference.is_zero(), resolution.branching
