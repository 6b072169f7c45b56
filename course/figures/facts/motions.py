"""The motion that the trajectory figures of an arm show: between two configurations, and along a straight line of the tool."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from math import ceil
from typing import Any

import numpy as np

from armproof.course.figures.facts.lines import follow, line_poses
from armproof.course.figures.facts.task import Task, joint_ranges, limits_of, task_of, within_limits
from armproof.models.arm import Arm
from armproof.models.errors import ModelError
from armproof.models.motion.joint_space import point_to_point
from armproof.models.motion.limits import read_rate_limits
from armproof.models.motion.pose_error import pose_error
from armproof.models.motion.quintic import shortest_duration
from armproof.models.motion.straight_line import StraightLine, straight_line
from armproof.models.numeric.plant import NumericKinematics
from armproof.models.showing.projection import choose_projection

_TRIED = 400
_LINES = 240
_STEPS = 17
_ATTEMPTS = 4
_LARGEST_ERROR = 2e-3  # m, rad; too little to be seen
_FAR = 0.12  # of the largest manipulability on any line
_SEED = 2019
_STEP, _SLIDE_STEP = np.radians(5), 0.01
_MOST = np.radians(120)
_TYPICAL = np.radians(60)
_EASE = 1.5  # times the shortest duration, so that drives are not at their limits
_FREE = 2.0  # s, of an arm whose joints nothing limits


@dataclass(frozen=True, eq=False)
class Motion:
    """A motion from rest to rest between two configurations, in joint space.

    Attributes:
        q_0, q_f: (n,), base to tool (rad, m), read-only.
        duration: s, a round number that respects the velocity limits of the model file.
        trajectory: the quintic, a pydrake PiecewisePolynomial on [0, duration].
        line: the straight line of the tool between the same configurations; None where none was found.
    """

    arm: Arm
    q_0: np.ndarray
    q_f: np.ndarray
    duration: float
    trajectory: Any
    line: StraightLine | None


@lru_cache(maxsize=64)
def motion_of(arm: Arm) -> Motion:
    """Return the motion that the figures of an arm show: a long one, far from singular configurations and from the ground.

    Its ends are drawn by a fixed generator, angles multiples of 5°, lengths of 10 mm; the tool can move on a straight line between them.
    """
    task = task_of(arm)
    q_0, q_f = _pairs(arm, task)
    for k in _followed(task, q_0, q_f)[:_ATTEMPTS]:
        line = _line(arm, task, q_0[k], q_f[k])
        if line is not None:
            return make_motion(arm, q_0[k], q_f[k], line)
    return make_motion(arm, q_0[0], q_f[0])


def make_motion(arm: Arm, q_0: np.ndarray, q_f: np.ndarray, line: StraightLine | None = None) -> Motion:
    """Return the quintic motion between two configurations (n,), in a round time that the velocity limits allow.

    Raises:
        ModelError: configurations of another shape, outside the joint limits, or the same.
    """
    duration = round_duration(arm, q_0, q_f)
    trajectory = point_to_point(arm, q_0, q_f, duration)
    ends = [np.array(q, dtype=float) for q in (q_0, q_f)]
    for q in ends:
        q.flags.writeable = False
    return Motion(arm, ends[0], ends[1], duration, trajectory, line)


def round_duration(arm: Arm, q_0: np.ndarray, q_f: np.ndarray) -> float:
    """Return half as long again as the shortest duration of the quintic, rounded up to 0.1 s; at least 2 s where nothing limits a joint."""
    limits = read_rate_limits(arm)
    free = np.isinf(limits.velocity) & np.isinf(limits.acceleration)
    limited = np.where(free, q_0, q_f)
    shortest = shortest_duration(q_0, limited, limits.velocity, limits.acceleration)
    return max(ceil(10 * _EASE * shortest) / 10, _FREE if free.any() else 0.1)


def _pairs(arm: Arm, task: Task) -> tuple[np.ndarray, np.ndarray]:
    """Return pairs of configurations, (K, n) each, the best first."""
    rng = np.random.default_rng(_SEED)
    q = _candidates(arm, rng)
    w = task.manipulability(q)
    points, low = task.points(q), task.lowest(q)
    kept = np.flatnonzero((w >= np.quantile(w, 0.4)) & (low >= np.quantile(low, 0.4)))
    first, last = (rng.choice(kept, 3 * _TRIED) for _ in range(2))
    way = np.linalg.norm(points[first] - points[last], axis=1)
    turn = np.abs(q[first] - q[last]) / _typical_moves(arm)
    score = way / max(float(way.max()), 1e-300) - 0.4 * np.abs(turn.max(axis=1) - 1) + np.minimum(turn.min(axis=1), 0.3)
    right = choose_projection(arm).points(points)[:, 0]
    score += 0.3 * np.minimum(right[first], right[last]) / max(float(np.abs(right).max()), 1e-300)
    order = np.argsort(-score, kind="stable")[:_LINES]
    return q[first[order]], q[last[order]]


def _typical_moves(arm: Arm) -> np.ndarray:
    """Return how far each joint may well go in a figure: 60°, or half of the range of a slide, (n,)."""
    pairs = zip(arm.joints, joint_ranges(arm), strict=True)
    return np.array([_TYPICAL if joint.kind == "revolute" else (high - low) / 2 for joint, (low, high) in pairs])


def _followed(task: Task, q_0: np.ndarray, q_f: np.ndarray) -> np.ndarray:
    """Return the pairs whose straight line the arm follows within its limits, far from singular configurations."""
    X_0, X_f = task.pose(q_0), task.pose(q_f)
    q, error = follow(task, q_0, line_poses(X_0, pose_error(X_f, X_0), np.linspace(0.0, 1.0, _STEPS)))
    inside = within_limits(task.arm, q).all(axis=(0, 2))
    follows = (error.max(axis=0) < 1e-6) & inside & (np.abs(q[-1] - q_f).max(axis=1) < 1e-6)
    w = np.array([task.manipulability(part) for part in q])
    return np.flatnonzero(follows & (w.min(axis=0) > _FAR * w.max()))


def _candidates(arm: Arm, rng: np.random.Generator) -> np.ndarray:
    """Return configurations well within the joint limits, rounded, (N, n)."""
    columns = []
    for joint, (low, high) in zip(arm.joints, joint_ranges(arm), strict=True):
        step, most = (_STEP, _MOST) if joint.kind == "revolute" else (_SLIDE_STEP, np.inf)
        margin = 0.1 * (high - low)
        first, last = ceil(max(low + margin, -most) / step), int(min(high - margin, most) // step)
        columns.append(step * rng.integers(first, max(first, last) + 1, _TRIED))
    return np.clip(np.column_stack(columns), *limits_of(arm))


def _line(arm: Arm, task: Task, q_0: np.ndarray, q_f: np.ndarray) -> StraightLine | None:
    """Return the straight line from one configuration to another, if the arm can follow it."""
    X_f = NumericKinematics(arm, q_f[np.newaxis]).pose(task.frame)[0]
    try:
        return straight_line(arm, task.frame, q_0, X_f, rows=task.rows, samples=61, tolerance=_LARGEST_ERROR)
    except ModelError:
        return None
