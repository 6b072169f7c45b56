"""What an arm does with its tool: the rows of [v; ω] that its joints command, and where the tool is."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from armproof.models.arm import Arm
from armproof.models.bulk.bulk import bulk_of
from armproof.models.exact.trace import trace_of
from armproof.models.numeric.configurations import generic_configuration, joint_range
from armproof.models.numeric.drake_arm import frame_of
from armproof.models.numeric.plant import NumericKinematics

_ZERO = 1e-9  # of the largest entry of the Jacobian
_SEED = 7


@dataclass(frozen=True, eq=False)
class Task:
    """The twist that an arm is made for.

    Attributes:
        arm, frame: the arm and the frame of its tool.
        rows: the rows of [v; ω], from 1, of which the joints can give all components at a generic configuration.
    """

    arm: Arm
    frame: str
    rows: tuple[int, ...]

    @property
    def turns_only(self) -> bool:
        """Whether the rows are of ω only."""
        return min(self.rows) > 3

    @property
    def places(self) -> list[int]:
        """The rows, from 0."""
        return [row - 1 for row in self.rows]

    def pose(self, q: np.ndarray) -> np.ndarray:
        """Return the pose of the tool's frame in frame 0 at configurations (N, n), (N, 4, 4)."""
        return bulk_of(self.arm).pose(q, self.frame)

    def manipulability(self, q: np.ndarray) -> np.ndarray:
        """Return √det(J Jᵀ) at configurations (N, n), (N,)."""
        return bulk_of(self.arm).manipulability(q, self.frame, self.rows)

    def points(self, q: np.ndarray) -> np.ndarray:
        """Return the origin of the tool's frame in frame 0, (N, 3)."""
        return np.asarray(self.pose(q)[:, :3, 3])

    def lowest(self, q: np.ndarray) -> np.ndarray:
        """Return the least height of the origins of the frames over the base, (N,)."""
        heights = [bulk_of(self.arm).pose(q, frame)[:, 2, 3] for frame in self.arm.frames[1:]]
        return np.asarray(np.min(heights, axis=0))

    def jacobian(self, q: np.ndarray) -> np.ndarray:
        """Return the rows of the task of the geometric Jacobian, (N, m, n), from the exact trace."""
        return np.asarray(bulk_of(self.arm).jacobian(q, self.frame)[:, self.places])


@lru_cache(maxsize=64)
def task_of(arm: Arm) -> Task:
    """Return the task of an arm: all rows that are not always zero; of more of them than joints those of v, or of ω.

    The same rows as analyse_singularities takes where it is not told any.
    """
    frame = tool_frame(arm)
    J = generic_jacobian(arm, frame, _SEED)
    used = [row for row in range(6) if np.abs(J[:, row]).max() > _ZERO * np.abs(J).max()]
    if len(used) > len(arm.joints):
        rank = _rank(J)
        halves = [[row for row in used if row < 3], [row for row in used if row >= 3]]
        used = next((half for half in halves if half and _rank(J[:, half]) == min(rank, len(half))), used)
    return Task(arm, frame, tuple(row + 1 for row in used))


def generic_jacobian(arm: Arm, frame: str, seed: int) -> np.ndarray:
    """Return the Jacobian of a frame at eight configurations near a generic one, (8, 6, n)."""
    near = np.random.default_rng(seed).uniform(-0.2, 0.2, (8, len(arm.joints)))
    return np.asarray(NumericKinematics(arm, generic_configuration(arm) + near).jacobian(frame))


def joint_ranges(arm: Arm) -> list[tuple[float, float]]:
    """Return the range of each joint from which configurations are drawn: its limits, or half a turn or half a metre to each side."""
    return [joint_range(joint.lower, joint.upper, joint.kind) for joint in arm.joints]


def limits_of(arm: Arm) -> np.ndarray:
    """Return the lower and the upper limits of the joints, (2, n)."""
    return np.array([[joint.lower for joint in arm.joints], [joint.upper for joint in arm.joints]])


def within_limits(arm: Arm, q: np.ndarray) -> np.ndarray:
    """Return which joint values (…, n) are within the limits of their joints."""
    lower, upper = limits_of(arm)
    return np.asarray((q >= lower - _ZERO) & (q <= upper + _ZERO))


def _rank(J: np.ndarray) -> int:
    singular_values = np.linalg.svd(J, compute_uv=False)
    return int(np.sum(singular_values > _ZERO * singular_values[:, :1], axis=1).max())


@lru_cache(maxsize=64)
def tool_frame(arm: Arm) -> str:
    """Return the frame of the tool: of the frames that the last joint carries, the one at the end of the chain."""
    moved = [frame for frame in arm.frames if trace_of(arm).depth(frame) == len(arm.joints)]
    if not moved:
        return arm.frames[-1]
    end = frame_of(arm, moved[-1]).index()
    return next(name for name in moved if frame_of(arm, name).index() == end)


def tool_points(arm: Arm, q: np.ndarray) -> np.ndarray:
    """Return the origin of the tool's frame in frame 0 at configurations (N, n), on the double plant, (N, 3), metres."""
    return np.asarray(NumericKinematics(arm, q).pose(tool_frame(arm))[:, :3, 3])


def volume_unit(arm: Arm, rows: Sequence[int], columns: Sequence[int]) -> str:
    """Return the unit of √det(J Jᵀ), a power of the metre; "" where it is a number, or a sum of different units.

    Args:
        rows: of [v; ω], from 1.
        columns: from 1.
    """
    sliding = sum(arm.joints[column - 1].kind == "prismatic" for column in columns)
    if sliding and len(rows) != len(columns):
        return ""
    power = sum(row <= 3 for row in rows) - sliding
    return {0: "", 1: "m", 2: "m²", 3: "m³"}.get(power, "")
