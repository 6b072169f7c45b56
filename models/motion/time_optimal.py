"""The fastest motion along a path within the limits of the joints, by Drake's Toppra."""

from __future__ import annotations

from dataclasses import dataclass
from numbers import Integral
from typing import Any

import numpy as np

from armproof.models.arm import Arm
from armproof.models.errors import Fault, ModelError
from armproof.models.motion.computed_torque import InverseDynamics
from armproof.models.motion.limits import RateLimits, read_rate_limits
from armproof.models.motion.samples import interval, sample_motion
from armproof.models.numeric.drake_arm import plant_of

_CHECKED = 1001  # instants at which the result is held against the limits
_MOST_SOLUTIONS = 6
_ROUNDING = 1e-9
_MARGIN = 0.002  # a limit that was passed is tightened by so much more, doubled each time, to end the repetition
_SHORTEST = 1e-4  # of a path; Drake ends the process on times that rounding makes equal
_STANDING = 1e-9  # part of the largest |dq/ds| below which a path stands still


@dataclass(frozen=True)
class TimeOptimalMotion:
    """A path with the fastest time law that the limits allow, from rest to rest.

    Attributes:
        trajectory: q(t), a pydrake PathParameterizedTrajectory from 0 to the duration, with values of the shape (n, 1).
        duration: s.
        limits: those respected.
        velocity_use, acceleration_use, effort_use: (n,), the largest rate of each joint as a part of its limit, at most
            1, measured at 1001 instants; 0 for a joint without this limit.
    """

    trajectory: Any
    duration: float
    limits: RateLimits
    velocity_use: np.ndarray
    acceleration_use: np.ndarray
    effort_use: np.ndarray


def time_optimal(
    arm: Arm, path: Any, *, velocity: Any = None, acceleration: Any = None, effort: Any = None, grid_points: int = 400
) -> TimeOptimalMotion:
    """Return the fastest motion along a path, from rest to rest, that respects velocity, acceleration and effort limits.

    The efforts are those of inverse dynamics with gravity. Toppra leaves out the damping of the joints, and holds the limits
    at the grid points only; so the motion is measured, and what passes a limit is set aside from it and solved for again.

    Source: H. Pham and Q.-C. Pham, 2018.

    Args:
        path: a pydrake Trajectory q(s) with values of the shape (n, 1) and a derivative that is nowhere 0, as joint_path
            and straight_line make it. A motion that starts at rest is none: it stands still in s.
        velocity, acceleration, effort: highest rates, one number or (n,), infinite for none; those of the model file if
            not given.
        grid_points: of s, at which the limits hold, at least 10.

    Raises:
        ModelError: a path that is none or stands still, joint limits passed at an end of it, limits of another shape or
            not positive, neither accelerations nor efforts limited, efforts too small to hold the arm, or no solution.
    """
    start, end = interval(path, len(arm.joints))
    if end - start < _SHORTEST or max(abs(start), abs(end)) > 1 / _SHORTEST:
        raise ModelError(Fault.PATH_INTERVAL, least=-1 / _SHORTEST, most=1 / _SHORTEST, shortest=_SHORTEST)
    if not isinstance(grid_points, Integral) or not 10 <= grid_points <= 100_000:
        raise ModelError(Fault.PATH_POINTS, points=grid_points)
    limits = read_rate_limits(arm, velocity=velocity, acceleration=acceleration, effort=effort)
    _require_bounds(arm, limits)
    grid = np.linspace(start, end, grid_points)
    _require_motion(arm, path, grid)
    tightened = limits
    for attempt in range(_MOST_SOLUTIONS):
        motion = _measure(arm, path, _solve(arm, path, grid, tightened), limits)
        uses = {"velocity": motion.velocity_use, "acceleration": motion.acceleration_use, "effort": motion.effort_use}
        if max(use.max() for use in uses.values()) <= 1 + _ROUNDING:
            return motion
        margin = 1 + _MARGIN * 2**attempt
        passed = {name: np.where(use > 1 + _ROUNDING, margin * use, 1) for name, use in uses.items()}
        tightened = RateLimits(**{name: getattr(tightened, name) / passed[name] for name in uses})
    worst = max(uses, key=lambda name: float(uses[name].max()))
    raise ModelError(Fault.LIMIT_PASSED, worst=worst, arm=arm.name, factor=uses[worst].max(), points=grid_points)


def _require_bounds(arm: Arm, limits: RateLimits) -> None:
    unbounded = np.isinf(limits.acceleration) & np.isinf(limits.effort)
    if unbounded.any():
        joint = arm.joints[int(np.argmax(unbounded))]
        raise ModelError(Fault.NO_RATE_LIMIT, joint=joint.symbol, arm=arm.name)


def _require_motion(arm: Arm, path: Any, grid: np.ndarray) -> None:
    """Check that the path moves on at every point of the grid and keeps within the joint limits there."""
    motion = sample_motion(path, grid)
    speed = np.linalg.norm(motion.v, axis=1)
    if not all(np.isfinite(values).all() for values in (motion.q, motion.v, motion.w)):
        raise ModelError(Fault.PATH_NOT_FINITE)
    if not (speed > _STANDING * speed.max()).all():
        at = grid[int(np.argmin(speed))]
        raise ModelError(Fault.PATH_STANDS, at=at)
    for joint, values in zip(arm.joints, motion.q.T, strict=True):
        beyond = (values < joint.lower - 1e-9) | (values > joint.upper + 1e-9)
        if beyond.any():
            k = int(np.argmax(beyond))
            raise ModelError(
                Fault.BEYOND_LIMITS_AT,
                joint=joint.symbol,
                arm=arm.name,
                value=values[k],
                at=grid[k],
                lower=joint.lower,
                upper=joint.upper,
            )


def _solve(arm: Arm, path: Any, grid: Any, limits: RateLimits) -> Any:
    """Return s(t), a pydrake PiecewisePolynomial."""
    from pydrake.multibody.optimization import Toppra

    problem: Any = Toppra(path, plant_of(arm), grid)
    if np.isfinite(limits.velocity).any():
        problem.AddJointVelocityLimit(-limits.velocity, limits.velocity)
    if np.isfinite(limits.acceleration).any():
        problem.AddJointAccelerationLimit(-limits.acceleration, limits.acceleration)
    if np.isfinite(limits.effort).any():
        problem.AddJointTorqueLimit(-limits.effort, limits.effort)
    time_law = problem.SolvePathParameterization()
    if time_law is None:
        raise ModelError(Fault.NO_MOTION, arm=arm.name)
    return time_law


def _measure(arm: Arm, path: Any, time_law: Any, limits: RateLimits) -> TimeOptimalMotion:
    from pydrake.trajectories import PathParameterizedTrajectory

    start = float(time_law.start_time())
    time_law.shiftRight(-start)
    trajectory = PathParameterizedTrajectory(path, time_law)
    duration = float(time_law.end_time())
    motion = sample_motion(trajectory, np.linspace(0.0, duration, _CHECKED))
    dynamics = InverseDynamics(arm)
    efforts = np.array([dynamics.torques(*row) for row in zip(motion.q, motion.v, motion.w, strict=True)])
    uses = [
        np.asarray(np.abs(rates).max(axis=0) / limit)
        for rates, limit in ((motion.v, limits.velocity), (motion.w, limits.acceleration), (efforts, limits.effort))
    ]
    for use in uses:
        use.flags.writeable = False
    return TimeOptimalMotion(trajectory, duration, limits, *uses)
