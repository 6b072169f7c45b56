"""Straight lines of the tool followed by many configurations at once, to choose the ones that figures show."""

from __future__ import annotations

import numpy as np

from armproof.course.figures.facts.task import Task
from armproof.models.bulk.bulk import bulk_of
from armproof.models.motion.inverse_velocity import damped_inverse
from armproof.models.motion.pose_error import pose_error, rotations

_CORRECTIONS = 4
_LARGEST_STEP = 0.4  # rad, m
_DAMPING = 1e-7


def line_poses(X_0: np.ndarray, twists: np.ndarray, s: np.ndarray) -> np.ndarray:
    """Return poses that move evenly: p = p_0 + s v and R = exp(s [ω]) R_0.

    Args:
        X_0: (K, 4, 4) in frame 0.
        twists: (K, 6), rows [v; ω] in the axes of frame 0.
        s: (S,).

    Returns:
        (S, K, 4, 4).
    """
    poses = np.broadcast_to(X_0, (len(s), *X_0.shape)).copy()
    poses[:, :, :3, 3] += s[:, None, None] * twists[:, :3]
    poses[:, :, :3, :3] = rotations(s[:, None, None] * twists[:, 3:]) @ X_0[:, :3, :3]
    return poses


def follow(task: Task, q_0: np.ndarray, poses: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return joint values that have the tool at poses, each found by Newton's method from the ones before.

    Args:
        q_0: (K, n), at or near to the first pose (rad, m).
        poses: (S, K, 4, 4) in frame 0.

    Returns:
        q: (S, K, n).
        error: (S, K), what is missing in the rows of the task (m, rad); where the arm cannot follow it is not near 0.
    """
    q = np.empty((len(poses), *q_0.shape))
    error = np.empty(q.shape[:2])
    for k in range(len(poses)):
        guess = q_0 if k == 0 else q[k - 1]
        step = q[k - 1] - q[k - 2] if k > 1 else np.zeros_like(q_0)
        q[k], error[k] = correct(task, guess + _bounded(step), poses[k])
    return q, error


def correct(task: Task, q: np.ndarray, X: np.ndarray, rounds: int = _CORRECTIONS) -> tuple[np.ndarray, np.ndarray]:
    """Return joint values (K, n) after some Newton steps towards poses (K, 4, 4), and the error that is left, (K,)."""
    rows = task.places
    for _ in range(rounds):
        at, J = bulk_of(task.arm).pose_and_jacobian(q, task.frame)
        error = pose_error(X, at)[:, rows]
        q = q + _bounded((damped_inverse(J[:, rows], _DAMPING) @ error[..., None])[..., 0])
    left = pose_error(X, task.pose(q))[:, rows]
    return q, np.linalg.norm(left, axis=1)


def _bounded(step: np.ndarray) -> np.ndarray:
    largest = np.maximum(np.abs(step).max(axis=-1, keepdims=True), 1e-300)
    return np.asarray(step * np.minimum(1.0, _LARGEST_STEP / largest))
