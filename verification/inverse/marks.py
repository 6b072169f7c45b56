"""Which branches of a doubtful target are solutions, and what the target is."""

from __future__ import annotations

from itertools import combinations

import numpy as np

from armproof.verification.inverse.compiled import Compiled
from armproof.verification.inverse.returning import returns
from armproof.verification.inverse.solutions import Mark

COINCIDE = 1e-9  # rad or m between two branches that are one solution


def judge(compiled: Compiled, targets: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return q (N, B, n), valid (N, B) and mark (N,) of targets that are evaluated with their error bounds."""
    arm, count = compiled.arm, len(targets)
    found = compiled.careful(targets)
    q = np.stack([found.of(term, count) for term in compiled.terms], axis=-1)
    q = q.reshape(count, len(compiled.outputs), len(arm.joints))
    reached = np.isfinite(q).all(axis=-1)
    degenerate = np.zeros(reached.shape, dtype=bool)
    for branch, places in enumerate(compiled.branch_nodes):
        for place in places:
            if place in found.unreachable:
                reached[:, branch] &= ~found.unreachable[place]
            if place in found.degenerate:
                degenerate[:, branch] |= found.degenerate[place]
    valid = reached & (~degenerate | returns(compiled, q, targets))
    mark = np.full(count, Mark.UNREACHABLE, dtype=np.int8)
    mark[valid.any(axis=1)] = Mark.REACHABLE
    mark[_has_equal_branches(compiled, q, valid)] = Mark.EDGE
    mark[(reached & degenerate).any(axis=1)] = Mark.DEGENERATE
    return np.where(valid[..., None], q, np.nan), valid, mark


def _has_equal_branches(compiled: Compiled, q: np.ndarray, valid: np.ndarray) -> np.ndarray:
    """Whether two valid branches of a target are one solution."""
    equal = np.zeros(len(q), dtype=bool)
    for a, b in combinations(range(q.shape[1]), 2):
        equal |= valid[:, a] & valid[:, b] & same_configuration(compiled, q[:, a], q[:, b])
    return equal


def same_configuration(compiled: Compiled, a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Whether configurations, (N, n) each, are equal up to whole turns."""
    difference = a - b
    revolute = np.array([joint.kind == "revolute" for joint in compiled.arm.joints])
    difference = np.where(revolute, 2.0 * np.sin(difference / 2.0), difference)
    same: np.ndarray = (np.abs(difference) <= COINCIDE).all(axis=-1)
    return same
