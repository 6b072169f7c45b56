"""Whether the tool can stand just beyond a singular configuration in any other posture: a search from many starts."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from armproof.models.arm import Arm
from armproof.models.bulk.bulk import BulkKinematics
from armproof.models.motion.pose_error import pose_error, rotations

STARTS = 32
STEPS = 60
STEP_BEYOND = 0.01  # of the arm's size
TOLERANCE = 1e-9


@dataclass(frozen=True, eq=False)
class Reach:
    """The task of an arm, given by rows of the Jacobian of a frame in the base frame.

    Attributes:
        arm, kinematics: the arm, and its kinematics with the lengths that are meant.
        frame: the frame that is to be placed.
        rows: which of [v; ω], from 1, matter.
        columns: which joints move, from 1.
        size: a typical length (m).
    """

    arm: Arm
    kinematics: BulkKinematics
    frame: str
    rows: tuple[int, ...]
    columns: tuple[int, ...]
    size: float

    def beyond(self, q: np.ndarray, direction: np.ndarray, rng: np.random.Generator) -> np.ndarray:
        """Return whether the poses at q, moved a little along unit twists, are reached from any of many starts, (N,) bools.

        Args:
            q: (N, n) configurations. direction: (N, rows) directions of [v; ω], in the rows of the task.
        """
        step = np.zeros((len(q), 6))
        step[:, [row - 1 for row in self.rows]] = direction * STEP_BEYOND * self.size
        poses = np.array(self.kinematics.pose(q, self.frame))
        poses[:, :3, 3] += step[:, :3]
        poses[:, :3, :3] = rotations(step[:, 3:]) @ poses[:, :3, :3]
        targets = np.repeat(poses, STARTS, axis=0)
        starts = self._starts(q, rng)
        return np.asarray(self._reached(starts, targets).reshape(len(q), STARTS).any(axis=1))

    def _starts(self, q: np.ndarray, rng: np.random.Generator) -> np.ndarray:
        starts = np.repeat(q, STARTS, axis=0)
        for column in self.columns:
            k = column - 1
            wide = np.pi if self.arm.joints[k].kind == "revolute" else self.size
            starts[:, k] += rng.uniform(-wide, wide, len(starts))
        return starts

    def _reached(self, q: np.ndarray, targets: np.ndarray) -> np.ndarray:
        rows, columns = [row - 1 for row in self.rows], [column - 1 for column in self.columns]
        damping = 1e-2 * np.ones(len(q))
        error = self._error(q, targets)
        for _ in range(STEPS):
            J = np.array(self.kinematics.jacobian(q, self.frame))[:, rows][:, :, columns]
            normal = J @ J.transpose(0, 2, 1)
            size = np.trace(normal, axis1=1, axis2=2)[:, None, None] / len(rows)
            normal = normal + np.eye(len(rows)) * (damping[:, None, None] * size + 1e-15)
            step = np.einsum("nji,nj->ni", J, np.linalg.solve(normal, error[:, :, None])[:, :, 0])
            tried = q.copy()
            tried[:, columns] += step
            found = self._error(tried, targets)
            better = np.linalg.norm(found, axis=1) < np.linalg.norm(error, axis=1)
            q = np.where(better[:, None], tried, q)
            error = np.where(better[:, None], found, error)
            damping = np.where(better, np.maximum(damping / 5, 1e-14), np.minimum(damping * 4, 1e3))
        return np.asarray(np.linalg.norm(error, axis=1) < TOLERANCE * max(self.size, 1.0))

    def _error(self, q: np.ndarray, targets: np.ndarray) -> np.ndarray:
        error = pose_error(targets, self.kinematics.pose(q, self.frame))
        return error[:, [row - 1 for row in self.rows]]


def typical_size(kinematics: BulkKinematics, frame: str, q: np.ndarray) -> float:
    """Return the greatest distance of a frame from the base at some configurations (m)."""
    return float(np.linalg.norm(kinematics.pose(q, frame)[:, :3, 3], axis=1).max(initial=0.0)) or 1.0
