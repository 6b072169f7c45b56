"""Configurations at which signs that are given hold and others do not; loaded where one is sought."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from armproof.verification.algebra.calculus import symbols_in
from armproof.verification.conditions.signs import Sign
from armproof.verification.equations.chain import ChainChecker

CLEARLY = 1e-6
ANGLES = np.arange(-11, 13) * np.pi / 12
SLIDES = np.array([-1.5, -1.0, -0.5, 0.5, 1.0, 1.5, 2.0])
LENGTHS = np.array([0.5, 1.0, 1.5, 2.0])


def signed_point(checker: ChainChecker, given: Sequence[Sign], asked: Sequence[Sign]) -> dict[str, float] | None:
    """Return a configuration, and lengths, at which what is given is clearly so and what is asked for clearly not."""
    arm, sampled = checker.names.arm, checker.sampled()
    assert arm is not None
    names = symbols_in([sign.value for sign in (*given, *asked)])
    stated = checker.names.state.stated
    free = {name for name, length in arm.lengths.items() if length > 0 and name not in stated}
    joints = {joint.symbol: ANGLES if joint.kind == "revolute" else SLIDES for joint in arm.joints}
    if not names <= {*joints, *arm.lengths}:
        return None
    random = np.random.default_rng(2026)
    drawn = {name: random.choice(choices, sampled.samples) for name, choices in joints.items()}
    drawn |= {name: random.choice(LENGTHS, sampled.samples) for name in sorted(free)}
    algebra = sampled.at(drawn)
    with np.errstate(all="ignore"):
        good = np.ones(sampled.samples, dtype=bool)
        for sign in given:
            value = algebra.from_exact(sign.value)
            good &= np.abs(value) > CLEARLY if sign.relation == "≠" else value > CLEARLY
        bad = np.zeros(sampled.samples, dtype=bool)
        for sign in asked:
            value = algebra.from_exact(sign.value)
            bad |= np.abs(value) < CLEARLY**2 if sign.relation == "≠" else value < -CLEARLY
    if not (good & bad).any():
        return None
    place = int(np.argmax(good & bad))
    return {name: float(values[place]) for name, values in drawn.items() if name in names}
