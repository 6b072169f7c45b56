"""What an arm does with its tool: the rows of [v; ω] that its joints command, and where the tool is."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from armproof.models.arm import Arm
from armproof.models.bulk.bulk import bulk_of
from armproof.models.exact.trace import trace_of
from armproof.models.numeric.configurations import generic_configuration
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

    def points(self, q: np.ndarray) -> np.ndarray:
        """Return the origin of the tool's frame in frame 0, (N, 3)."""
        return np.asarray(bulk_of(self.arm).pose(q, self.frame)[:, :3, 3])

    def lowest(self, q: np.ndarray) -> np.ndarray:
        """Return the least height of the origins of the frames over the base, (N,)."""
        heights = [bulk_of(self.arm).pose(q, frame)[:, 2, 3] for frame in self.arm.frames[1:]]
        return np.asarray(np.min(heights, axis=0))

    def jacobian(self, q: np.ndarray) -> np.ndarray:
        """Return the rows of the task of the geometric Jacobian, (N, m, n), from the exact trace."""
        return np.asarray(bulk_of(self.arm).jacobian(q, self.frame)[:, [row - 1 for row in self.rows]])


@lru_cache(maxsize=64)
def task_of(arm: Arm) -> Task:
    """Return the task of an arm: all rows that are not always zero; of more of them than joints those of v, or of ω.

    The same rows as analyse_singularities takes where it is not told any.
    """
    frame = tool_frame(arm)
    J = NumericKinematics(arm, _near_generic(arm)).jacobian(frame)
    used = [row for row in range(6) if np.abs(J[:, row]).max() > _ZERO * np.abs(J).max()]
    if len(used) > len(arm.joints):
        rank = _rank(J)
        halves = [[row for row in used if row < 3], [row for row in used if row >= 3]]
        used = next((half for half in halves if half and _rank(J[:, half]) == min(rank, len(half))), used)
    return Task(arm, frame, tuple(row + 1 for row in used))


def _near_generic(arm: Arm) -> np.ndarray:
    rng = np.random.default_rng(_SEED)
    return generic_configuration(arm) + rng.uniform(-0.2, 0.2, (8, len(arm.joints)))


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
