"""Whether a solution is one: its forward kinematics compared with the target, where the formulas do not see to it."""

from __future__ import annotations

import numpy as np

from armproof.verification.inverse.compiled import Compiled

RETURNS = 1e-9  # how far a solution may miss its target, relative to the size of it
MOVED = 1e-3  # how far targets are moved off those of the arm, relative to their size
SAMPLES = 64
SEED = 5


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
