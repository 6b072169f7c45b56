"""A motion as arrays: positions, velocities and accelerations of a Drake trajectory at given times."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from armproof.models.errors import Fault, ModelError
from armproof.models.motion.inputs import SHORTEST, read_vector


@dataclass(frozen=True)
class MotionSamples:
    """A motion of n joints at N times; the arrays are read-only.

    Attributes:
        times: (N,), s.
        q, v, w: positions, velocities and accelerations, (N, n) each, rad and m.
    """

    times: np.ndarray
    q: np.ndarray
    v: np.ndarray
    w: np.ndarray


def sample_motion(trajectory: Any, times: np.ndarray) -> MotionSamples:
    """Evaluate a trajectory and its first two derivatives.

    Before its start and after its end a motion is held at that end: the position is the end's, the rates are 0.

    Args:
        trajectory: a pydrake Trajectory with values of the shape (n, 1).
        times: (N,), s, in any order.

    Raises:
        ModelError: not a trajectory of a vector, one without two derivatives, or times that are not finite.
    """
    instants = read_vector(times, "times")
    start, end = interval(trajectory)
    inside = (start - SHORTEST <= instants) & (instants <= end + SHORTEST)
    held = np.clip(instants, start, end)
    try:
        q = np.array([trajectory.value(t)[:, 0] for t in held])
        v, w = (np.array([trajectory.EvalDerivative(t, order)[:, 0] for t in held]) for order in (1, 2))
    except (RuntimeError, ValueError) as error:
        raise ModelError(Fault.NO_DERIVATIVE, reason=str(error)) from None
    v[~inside] = w[~inside] = 0.0
    for array in (q, v, w):
        array.flags.writeable = False
    return MotionSamples(instants, q, v, w)


def interval(trajectory: Any, size: int | None = None) -> tuple[float, float]:
    """Return the start and end time of a trajectory of a vector.

    Args:
        size: how many values it has at a time; any number if not given.

    Raises:
        ModelError: no trajectory, one of values of another shape, or one without a start and a later end.
    """
    from pydrake.trajectories import Trajectory

    if not isinstance(trajectory, Trajectory):
        raise ModelError(Fault.NO_TRAJECTORY, type=type(trajectory).__name__)
    try:
        shape = (trajectory.rows(), trajectory.cols())
        start, end = float(trajectory.start_time()), float(trajectory.end_time())
    except RuntimeError as error:
        raise ModelError(Fault.TRAJECTORY_EMPTY, reason=str(error)) from None
    if shape[1] != 1 or shape[0] == 0 or size not in (None, shape[0]):
        raise ModelError(Fault.TRAJECTORY_SHAPE, size="n" if size is None else size, shape=shape)
    if not (np.isfinite([start, end]).all() and end - start >= SHORTEST):
        raise ModelError(Fault.TRAJECTORY_ENDS, start=start, end=end)
    return start, end
