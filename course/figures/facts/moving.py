"""An arm as numbers that a page can move it by: its joints at the zero pose, what is seen of it, and its task."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np

from armproof.course.figures.facts.poses import showing_pose
from armproof.course.figures.facts.task import Task, joint_ranges, task_of
from armproof.models.arm import Arm
from armproof.models.bulk.bulk import bulk_of
from armproof.models.numeric.plant import NumericKinematics
from armproof.models.showing.projection import Projection, choose_projection
from armproof.models.showing.skeleton import place_skeleton

_TRIED, _SEED = 300, 2019
_ELLIPSE = 0.25  # of what is seen: the longest half axis of an ellipse
_ROOM = 0.02  # of what is seen, to each side
_DIGITS = 9
UNITS = {
    "revolute": ("°", 180 / np.pi),
    "prismatic": ("mm", 1000.0),
}  # of the sliders, and how many make a radian or a metre


@dataclass(frozen=True, eq=False)
class Moving:
    """What moves an arm on a page.

    Attributes:
        task: its tool, and the rows of J whose determinant is told.
        projection: from where it is seen.
        start: the configuration (n,) at which it is shown first.
        window: (2, 2), the least and the greatest of what is seen on the paper within the joint limits (m).
        size: metres on the paper a unit of the velocities that the ellipse shows.
    """

    task: Task
    projection: Projection
    start: np.ndarray
    window: np.ndarray
    size: float

    @property
    def part(self) -> slice:
        """The rows of J that the ellipse shows: v, of a wrist ω."""
        return slice(3, 6) if self.task.turns_only else slice(0, 3)

    def ellipse(self, J: np.ndarray) -> np.ndarray:
        """Return B (2, n): B u are the velocities of the tool on the paper (m) for joint rates u, of a Jacobian (6, n)."""
        return np.asarray(self.size * self.projection.points(J[self.part].T).T)

    def numbers(self) -> dict[str, Any]:
        """Return what a script needs to draw the arm at any configuration: the exponentials of its joints, in frame 0."""
        arm = self.task.arm
        zero = place_skeleton(arm, np.zeros(len(arm.joints)))
        joints = [
            {"kind": joint.kind, "low": low, "high": high, "start": start, "point": placed.start, "axis": placed.axis}
            for joint, placed, (low, high), start in zip(
                arm.joints, zero.joints, joint_ranges(arm), self.start, strict=True
            )
        ]
        seen = [self.projection.right, self.projection.up]
        tool = zero.frames[self.task.frame][:3, 3]
        base = zero.frames[arm.frames[0]][:3, 3]
        return dict(
            _rounded({"joints": joints, "base": base, "tool": tool, "seen": seen, "window": self.window, "size": self.size}),
            rows=self.task.places,
            part=self.part.start,
        )  # fmt: skip


def columns_of(asked: Sequence[int] | None, joints: int) -> list[int]:
    """Return the columns (from 0) of a Jacobian in the order in which a task asks for all of them, or as they are."""
    return [column - 1 for column in asked] if asked is not None and len(asked) == joints else list(range(joints))


@lru_cache(maxsize=64)
def moving_of(arm: Arm) -> Moving:
    """Return what moves an arm, with room for all that it reaches within its joint limits."""
    task, projection = task_of(arm), choose_projection(arm)
    rng = np.random.default_rng(_SEED)
    q = np.column_stack([rng.uniform(low, high, _TRIED) for low, high in joint_ranges(arm)])
    poses = [bulk_of(arm).pose(q, frame)[:, :3, 3] for frame in dict.fromkeys((*arm.frames, task.frame))]
    points = projection.points(np.vstack(poses))
    window = np.array([points.min(axis=0), points.max(axis=0)])
    reach = max(float(np.ptp(window, axis=0).max()), 1e-3)
    moving = Moving(task, projection, showing_pose(arm), window + _ROOM * reach * np.array([[-1], [1]]), 1.0)
    J = NumericKinematics(arm, q).jacobian(task.frame)
    longest = max(float(np.linalg.norm(moving.ellipse(each), 2)) for each in J)
    return Moving(task, projection, moving.start, moving.window, _ELLIPSE * reach / longest)


def _rounded(value: Any) -> Any:
    """Return numbers as a page has them, whatever holds them."""
    if isinstance(value, dict):
        return {key: _rounded(each) for key, each in value.items()}
    if isinstance(value, (list, tuple, np.ndarray)):
        return [_rounded(each) for each in value]
    return round(float(value), _DIGITS) + 0.0 if isinstance(value, (float, np.floating)) else value
