"""Motion in joint space: from one configuration to another, and along a path."""

from __future__ import annotations

from typing import Any

import numpy as np

from armproof.models.arm import Arm
from armproof.models.errors import Fault, ModelError
from armproof.models.motion.inputs import read_duration
from armproof.models.motion.limits import read_rate_limits, require_within_limits
from armproof.models.motion.quintic import quintic, shortest_duration
from armproof.models.motion.samples import interval
from armproof.models.numeric.joint_values import read_configuration, read_joint_values


def point_to_point(arm: Arm, q_0: Any, q_f: Any, duration: float | None = None, *, acceleration: Any = None) -> Any:
    """Return the quintic motion from rest at one configuration to rest at another; all joints start and stop together.

    Args:
        q_0, q_f: (n,), base to tool (rad, m), within the joint limits.
        duration: s; if not given, the shortest that respects the velocity limits of the model file, and the
            acceleration limits given or of the model file if there are any.
        acceleration: highest accelerations, one number or (n,) (rad/s², m/s²).

    Returns:
        A pydrake PiecewisePolynomial on [0, duration] with values of the shape (n, 1).

    Raises:
        ModelError: configurations of another shape, not finite or outside the joint limits; a duration that is not
            positive; without a duration, a motion that goes nowhere, or a joint that nothing limits.
    """
    first, last = read_configuration(arm, q_0), read_configuration(arm, q_f)
    if duration is None:
        limits = read_rate_limits(arm, acceleration=acceleration)
        duration = shortest_duration(first, last, limits.velocity, limits.acceleration)
        if duration == 0:
            raise ModelError(Fault.SAME_ENDS)
    trajectory = quintic(first, last, duration)
    require_within_limits(arm, trajectory)
    return trajectory


def joint_path(arm: Arm, points: Any) -> Any:
    """Return a path q(s), s from 0 to 1, through given configurations, with no time in it.

    s is proportional to the length of the chords in joint space; with two points the path is a straight line, with more a
    cubic spline. To give it time: follow_path, time_optimal.

    Args:
        points: (K, n), base to tool (rad, m), K of at least 2.

    Returns:
        A pydrake PiecewisePolynomial on [0, 1] with values of the shape (n, 1).

    Raises:
        ModelError: another shape, numbers that are not finite, two points in succession that are the same, or joint
            limits that the path passes.
    """
    from pydrake.trajectories import PiecewisePolynomial

    configurations = read_joint_values(arm, points)
    if len(configurations) < 2:
        raise ModelError(Fault.ONE_CONFIGURATION, count=len(configurations))
    chords = np.linalg.norm(np.diff(configurations, axis=0), axis=1)
    if (chords <= 1e-9 * max(chords.max(), 1e-9)).any():
        k = int(np.argmin(chords)) + 1
        raise ModelError(Fault.SAME_POINTS, first=k, second=k + 1)
    s = np.concatenate([[0.0], np.cumsum(chords[:-1]) / chords.sum(), [1.0]])
    if len(configurations) == 2:
        path = PiecewisePolynomial.FirstOrderHold(s, configurations.T)
    else:
        path = PiecewisePolynomial.CubicWithContinuousSecondDerivatives(s, configurations.T, False)
    require_within_limits(arm, path)
    return path


def follow_path(path: Any, duration: float) -> Any:
    """Return the motion along a path from rest to rest, its parameter a quintic in time.

    Args:
        path: a pydrake Trajectory q(s) with values of the shape (n, 1).
        duration: s.

    Returns:
        A pydrake PathParameterizedTrajectory on [0, duration].

    Raises:
        ModelError: not a trajectory of a vector, or a duration that is not positive.
    """
    from pydrake.trajectories import PathParameterizedTrajectory

    start, end = interval(path)
    return PathParameterizedTrajectory(path, quintic(start, end, read_duration(duration)))
