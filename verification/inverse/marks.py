"""Whether a solution is one, by its forward kinematics; which branches of a doubtful target are, and what the target is."""

from __future__ import annotations

from itertools import combinations

import numpy as np

from armproof.verification.inverse.compiled import Compiled
from armproof.verification.inverse.solutions import Mark

RETURNS = 1e-9  # how far a solution may miss its target, relative to the size of it
MOVED = 1e-3  # how far targets are moved off those of the arm, relative to their size
SAMPLES = 64
SEED = 5
COINCIDE = 1e-9  # rad or m between two branches that are one solution


def returns(compiled: Compiled, q: np.ndarray, targets: np.ndarray) -> np.ndarray:
    """Return whether the forward kinematics of each branch, q (N, B, n), is the target, (N, m): (N, B)."""
    count, branches, joints = q.shape
    reached = compiled.forward(np.nan_to_num(q).reshape(-1, joints)).reshape(count, branches, -1)
    error = np.abs(reached - targets[:, None, :])
    error = np.where(compiled.angles, np.abs(np.sin(error / 2.0)), error)
    close: np.ndarray = (error <= RETURNS * (1.0 + compiled.sizes)).all(axis=-1)
    return close


def sees_every_number(compiled: Compiled) -> bool:
    """Whether the formulas use every number of the target: whether they return targets also that the arm has none of.

    A pose of an arm with three joints, or x, y and an angle for two, may be one that the arm does not reach though the formulas
    have a value. Targets of the arm are moved a little, rotations turned; where some solution then misses, each has to be
    compared with its target.
    """
    generator = np.random.default_rng(SEED)
    targets = compiled.seeds[:SAMPLES].copy()
    target = compiled.derivation.target
    moved = targets + MOVED * compiled.sizes * generator.normal(size=targets.shape)
    for index, slot in enumerate(target.slots):
        if slot.is_constant:
            moved[:, index] = targets[:, index]
    for pair in target.rotations:
        cells = target.cells(pair)
        columns = [cells[row, column] for row in range(3) for column in range(3)]
        R = targets[:, columns].reshape(-1, 3, 3) @ _small_rotations(generator, len(targets))
        moved[:, columns] = R.reshape(-1, 9)
    values, _ = compiled.solve(moved)
    q = values.reshape(len(moved), len(compiled.outputs), -1)
    missed = np.isfinite(q).all(axis=-1) & ~returns(compiled, q, moved)
    return not missed.any()


def _small_rotations(generator: np.random.Generator, count: int) -> np.ndarray:
    """Return rotations by about MOVED, (N, 3, 3): Cayley transforms of skew matrices."""
    x, y, z = MOVED * generator.normal(size=(3, count))
    zero = np.zeros(count)
    S = np.stack([zero, -z, y, z, zero, -x, -y, x, zero], axis=-1).reshape(-1, 3, 3)
    rotations: np.ndarray = np.linalg.solve(np.eye(3) - S, np.eye(3) + S)
    return rotations


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
