"""All joint values that bring an arm's tool to one pose: the branches of the course's closed form, else found by iteration."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from typing import Literal

import numpy as np

from armproof.course.figures.facts.poses import showing_pose
from armproof.course.figures.facts.task import Task, task_of
from armproof.models.arm import Arm
from armproof.models.catalogue import arm_names, load_arm
from armproof.models.motion.pose_error import pose_error
from armproof.models.numeric.joint_values import outside_limits

STARTS = 480
_STEPS = 60
_REACHED = 1e-11  # m and rad
_SAME = 1e-5
_SEED = 2019


@dataclass(frozen=True, eq=False)
class Postures:
    """The postures that reach a target.

    Attributes:
        target: the configuration (n,) whose tool is the target.
        q: (B, n) joint values (rad, m), all different; that of the target among them.
        found: formula: the branches of a closed form; iteration: by Newton's method from `STARTS` starts.
        within_limits: (B,), whether all joints are within their limits.
    """

    target: np.ndarray
    q: np.ndarray
    found: Literal["formula", "iteration"]
    within_limits: np.ndarray


@lru_cache(maxsize=64)
def postures_of(arm: Arm) -> Postures:
    """Return the postures of an arm at the tool of its showing pose; only that one where there are infinitely many."""
    target = showing_pose(arm)
    q = _by_formula(arm, target)
    found: Literal["formula", "iteration"] = "formula" if q is not None else "iteration"
    if q is None:
        q = _by_iteration(task_of(arm), target) if is_square(arm) else target[None].copy()
    q.flags.writeable = False
    within = np.asarray(~outside_limits(arm, q).any(axis=1))
    return Postures(target, q, found, within)


def is_square(arm: Arm) -> bool:
    """Whether a target has as many numbers as the arm has joints, so that its postures are isolated."""
    return len(task_of(arm).rows) == len(arm.joints)


def _by_formula(arm: Arm, target: np.ndarray) -> np.ndarray | None:
    """Return the branches of the handout's closed form, None where no handout has one for this arm."""
    from armproof.course.inverse import arms_with_inverse, inverse_of

    if arm.name not in arm_names() or load_arm(arm.name) is not arm or arm.name not in arms_with_inverse():
        return None
    inverse = inverse_of(arm.name)
    solved = inverse.solve(inverse.forward(target[None]))
    return _distinct(arm, solved.q[0][solved.valid[0]])


def _by_iteration(task: Task, target: np.ndarray) -> np.ndarray:
    """Return the solutions that Newton's method finds from many starts, and the target's own."""
    arm = task.arm
    goal = task.pose(target[None])
    starts = np.random.default_rng(_SEED).uniform(-np.pi, np.pi, (STARTS, len(arm.joints)))
    q = np.vstack([target, starts])
    for _ in range(_STEPS):
        error = pose_error(goal, task.pose(q))[:, task.places]
        step = np.einsum("nij,nj->ni", np.linalg.pinv(task.jacobian(q), rcond=1e-6), error)
        size = np.linalg.norm(step, axis=1, keepdims=True)
        q = q + step * np.minimum(1.0, 0.7 / np.maximum(size, 1e-300))
    reached = np.abs(pose_error(goal, task.pose(q))[:, task.places]).max(axis=1) < _REACHED
    turning = [k for k, joint in enumerate(arm.joints) if joint.kind == "revolute"]
    q[:, turning] = np.pi - np.mod(np.pi - q[:, turning], 2 * np.pi)
    return _distinct(arm, q[reached])


def _distinct(arm: Arm, q: np.ndarray) -> np.ndarray:
    """Return configurations without those that are another one but for whole turns, in the order of the first."""
    turning = np.array([joint.kind == "revolute" for joint in arm.joints])
    kept: list[np.ndarray] = []
    for one in q:
        differences = [np.where(turning, np.angle(np.exp(1j * (one - other))), one - other) for other in kept]
        if all(np.abs(difference).max() > _SAME for difference in differences):
            kept.append(np.where(np.abs(one) < 1e-12, 0.0, one))
    return np.array(kept)
