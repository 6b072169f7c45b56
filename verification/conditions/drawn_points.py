"""Configurations drawn on the set of a condition, at one of which another condition is clearly off."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from armproof.models.arm import Arm
from armproof.models.exact.numbers import angle_value, is_number
from armproof.models.exact.trace import trace_of
from armproof.verification.singularities.half_angles import HalfAngles, Polynomial
from armproof.verification.singularities.points import Sampler, unknowns_of
from armproof.verification.singularities.variety import Variety

TRIED = 32
CLEARLY = 1e-6  # what an equation must be off at a counterexample, relative to the size of its terms
OF_ONE = 1e-4  # where a condition on one angle has no slope, as 1 - cos(θ - 60°) has none: it is 0 to rounding 1e-6 beside its zero
WITHOUT_SLOPE = 4e-3  # and one on several, as a sum of squares: the square of one is 0 to rounding where what is squared is off by 1e-3
SLOPE = 1e-3  # what a condition changes by, a radian or a metre on, relative to that size, too

Polynomials = tuple[Polynomial, ...]


@dataclass(frozen=True, eq=False)
class DrawnPoints:
    """Draws configurations.

    Attributes:
        positive: the symbols taken as positive.
        named: the angles and the symbols that occur.
    """

    half: HalfAngles
    arm: Arm | None
    positive: frozenset[str]
    named: tuple[set[str], set[str]]

    def point(
        self,
        variety: Variety,
        left_out: Sequence[Polynomials],
        conclusion: Sequence[tuple[Polynomials, Sequence[Polynomials]]],
        scale: float,
    ) -> dict[str, float] | None:
        """Return a configuration drawn on a set, less what is left out, at which the conclusion is clearly off.

        Args:
            left_out: of each of these polynomials not all vanish.
            conclusion: systems of polynomials that vanish, and of such as `left_out`.
            scale: what the lengths are multiplied by.
        """
        rng = np.random.default_rng(2019)
        sampler = self._sampler(variety, scale)
        conditions = [factor.polynomial for factor in variety.conditions]
        q = sampler.sample(conditions, rng, TRIED)
        if not len(q):
            return None
        least = _least(sampler, conditions, q)
        off = np.ones(len(q), dtype=bool)
        for excluded in left_out:
            off &= _clearly_off(sampler, excluded, q, least)
        for zero, not_all_zero in conclusion:
            fails = _clearly_off(sampler, zero, q, least)
            for excluded in not_all_zero:
                fails |= (np.abs(sampler.values(excluded, q)) < 1e-12).all(axis=1)
            off &= fails
        if not off.any():
            return None
        angles, symbols = self.named
        place = int(np.argmax(off))
        point = {u.name: float(q[place, k]) for k, u in enumerate(sampler.unknowns) if u.name in angles | symbols}
        tells = bool(variety.lengths) or scale != 1.0
        special = {name: value for name, value in sampler.constants.items() if tells and name in symbols}
        return {**point, **special}

    def _sampler(self, variety: Variety, scale: float) -> Sampler:
        """The unknowns of the conditions, with lengths, scaled, that meet those on them; an angle such as 25° is known."""
        constants = {name: angle_value(name) for name in self.half.angles if is_number(name)}
        constants |= {**trace_of(self.arm).constants, **self.arm.lengths} if self.arm is not None else {}
        for place, name in enumerate(sorted(self.positive - set(constants))):
            constants[name] = 0.5 + 0.3 * place
        constants |= {name: scale * constants[name] for name in self.positive & set(constants)}
        sampler = Sampler(self.half, unknowns_of(self.half, self.arm, constants), constants)
        if variety.lengths:
            special = sampler.solved_constants(variety.values)
            sampler = Sampler(self.half, sampler.unknowns, {**constants, **special})
        return sampler


def _least(sampler: Sampler, conditions: Sequence[Polynomial], q: np.ndarray) -> np.ndarray:
    """Return what the conclusion must be off at each point: little where each condition that holds there has a slope, and is 0 nowhere else nearby."""
    moving = [each for each in conditions if sampler.derivatives(each)]
    if not moving:
        return np.full(len(q), CLEARLY)
    slopes = np.abs(sampler.gradients(moving, q)).max(axis=2)
    flat = np.array([OF_ONE if len(sampler.derivatives(each)) == 1 else WITHOUT_SLOPE for each in moving])
    return np.asarray(np.where(slopes > SLOPE * sampler.sizes(moving, q), CLEARLY, flat).max(axis=1))


def _clearly_off(sampler: Sampler, polynomials: Polynomials, q: np.ndarray, least: np.ndarray) -> np.ndarray:
    if not polynomials:
        return np.zeros(len(q), dtype=bool)
    values, sizes = np.abs(sampler.values(polynomials, q)), sampler.sizes(polynomials, q)
    return np.asarray((values > least[:, None] * sizes).any(axis=1))
