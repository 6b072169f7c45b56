"""The closed-form inverse in bulk: targets a second on one core, all branches of each."""

from __future__ import annotations

import time

import numpy as np

from armproof.course.inverse import arms_with_inverse, inverse_of
from tests.sweeps.inverse_targets import generic

COUNT = 200_000
ROUNDS = 5
TARGETS = {"rx90": ">= 200,000/s"}


def measure_rate(name: str, count: int = COUNT) -> float:
    """Return how many targets a second of processor time are solved on all branches (the best of several rounds)."""
    inverse = inverse_of(name)
    targets = inverse.forward(generic(inverse.arm, np.random.default_rng(6), count))
    inverse.solve(targets[:1])  # compiles
    best = np.inf
    for _ in range(ROUNDS):
        started = time.process_time()
        inverse.solve(targets)
        best = min(best, time.process_time() - started)
    return count / best


def rows() -> list[tuple[str, str, str]]:
    """Return a row an arm: what, figure, target."""
    return [
        (f"{name}, {len(inverse_of(name).branches)} branches", f"{measure_rate(name):,.0f}/s", TARGETS.get(name, ""))
        for name in arms_with_inverse()
    ]
