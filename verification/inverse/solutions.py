"""What a batch of targets is solved to: all branches of each, which are solutions, and a mark that says what each target is."""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import IntEnum
from functools import cached_property
from itertools import combinations

import numpy as np

from armproof.models.arm import Joint
from armproof.models.motion.pose_error import rotations
from armproof.verification.inverse.compiled import Compiled

TURN = 2.0 * np.pi
RETURNS = 1e-9  # how far a solution may miss its target, relative to the size of it
MOVED = 1e-3  # how far targets are moved off those of the arm, relative to their size
SAMPLES = 64
SEED = 5
COINCIDE = 1e-9  # rad or m between two branches that are one solution


class Mark(IntEnum):
    """What a target is.

    REACHABLE: the branches that are valid are different solutions. EDGE: at least two branches coincide, as on the limit
    of the workspace. DEGENERATE: on some branch an atan2 is of (0, 0) or a denominator vanishes: a joint is free, there are
    infinitely many solutions (or the formulas were not made for this target). UNREACHABLE: no branch has a value. INVALID: no
    target, being not finite or no rotation.
    """

    REACHABLE = 0
    EDGE = 1
    DEGENERATE = 2
    UNREACHABLE = 3
    INVALID = 4


@dataclass(frozen=True)
class Solutions:
    """The solutions of N targets on B branches, for n joints; all arrays are read-only.

    Attributes:
        q: (N, B, n) joint values from base to tool (rad, m), angles in [−π, π]; NaN on branches that are not valid.
        valid: (N, B), which branches are solutions. On a degenerate target a valid branch is one solution of infinitely
            many, with the free joint at 0.
        mark: (N,), what each target is: values of `Mark`.
        joints: the joints of the arm.
    """

    q: np.ndarray
    valid: np.ndarray
    mark: np.ndarray
    joints: tuple[Joint, ...] = field(repr=False)

    def __post_init__(self) -> None:
        for array in (self.q, self.valid, self.mark):
            array.flags.writeable = False

    @cached_property
    def within_limits(self) -> np.ndarray:
        """(N, B), which valid branches lie within the limits of all joints, angles moved by whole turns where that helps."""
        inside = self.valid.copy()
        for joint in self.joints:
            value = self.q[..., joint.index - 1]
            if joint.kind == "revolute" and np.isfinite(joint.lower):
                value = value + TURN * np.ceil((joint.lower - value) / TURN)  # the least one not below the lower limit
            inside &= (value >= joint.lower) & (value <= joint.upper)
        inside.flags.writeable = False
        return inside

    def __len__(self) -> int:
        return len(self.q)


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
        R = targets[:, columns].reshape(-1, 3, 3) @ rotations(MOVED * generator.normal(size=(len(targets), 3)))
        moved[:, columns] = R.reshape(-1, 9)
    values, _ = compiled.solve(moved)
    q = values.reshape(len(moved), len(compiled.outputs), -1)
    missed = np.isfinite(q).all(axis=-1) & ~returns(compiled, q, moved)
    return not missed.any()


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
