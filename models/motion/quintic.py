"""The quintic joint trajectory: positions, velocities and accelerations at both ends, in closed form."""

from __future__ import annotations

from math import sqrt
from typing import Any

import numpy as np

from armproof.models.errors import Fault, ModelError
from armproof.models.motion.inputs import SHORTEST, read_duration, read_vector
from armproof.models.motion.limits import read_limits

PEAK_SPEED = 15 / 8  # of |q_f − q_0| / t_f, at t_f/2
PEAK_ACCELERATION = 10 / sqrt(3)  # of |q_f − q_0| / t_f², at t_f (1/2 ∓ √3/6)

Values = np.ndarray | float


def quintic(
    q_0: Values,
    q_f: Values,
    t_f: float,
    *,
    v_0: Values = 0.0,
    v_f: Values = 0.0,
    w_0: Values = 0.0,
    w_f: Values = 0.0,
    start_time: float = 0.0,
) -> Any:
    """Return the quintic q(t) with given positions, velocities and accelerations at its two ends.

    q(t) = a_0 + a_1 t + … + a_5 t⁵ with a_0 = q_0, a_1 = v_0, a_2 = w_0 / 2 and

        a_3 = (20 (q_f − q_0) − (8 v_f + 12 v_0) t_f − (3 w_0 − w_f) t_f²) / (2 t_f³)
        a_4 = (−30 (q_f − q_0) + (14 v_f + 16 v_0) t_f + (3 w_0 − 2 w_f) t_f²) / (2 t_f⁴)
        a_5 = (12 (q_f − q_0) − 6 (v_f + v_0) t_f − (w_0 − w_f) t_f²) / (2 t_f⁵)

    At rest at both ends, as it is without more arguments, q(t) = q_0 + (q_f − q_0) (10 s³ − 15 s⁴ + 6 s⁵), s = t / t_f.
    Outside [start_time, start_time + t_f] Drake evaluates the end; sample_motion also sets the rates to 0 there.

    Source: document 004, section 3; proved in course/handouts/quintic-004.md.

    Args:
        q_0, q_f: the positions at the start and at the end: a number, or (n,) of n joints (rad, m).
        t_f: the duration (s).
        v_0, v_f: the velocities there: one number for all joints, or (n,).
        w_0, w_f: the accelerations there: one number for all joints, or (n,).
        start_time: the time of the start (s).

    Returns:
        A pydrake PiecewisePolynomial of one segment with values of the shape (n, 1).

    Raises:
        ModelError: a number that is not finite, a duration that is not positive, or shapes that do not fit.
    """
    from pydrake.polynomial import Polynomial
    from pydrake.trajectories import PiecewisePolynomial

    duration = read_duration(t_f)
    start = float(read_vector(start_time, "start_time", 1)[0])
    first = read_vector(q_0, "q_0")
    rows = {"q_f": q_f, "v_0": v_0, "v_f": v_f, "w_0": w_0, "w_f": w_f}
    last, *rates = (_fit(value, name, first.size) for name, value in rows.items())
    coefficients: Any
    with np.errstate(over="ignore", invalid="ignore"):
        coefficients = _coefficients(first, last, rates, duration)
    if not np.isfinite(coefficients).all() or start + duration - start < SHORTEST:
        raise ModelError(Fault.OUT_OF_PRECISION)
    column = np.array([[Polynomial(joint)] for joint in np.ascontiguousarray(coefficients.T)])
    return PiecewisePolynomial([column], [start, start + duration])


def shortest_duration(q_0: Values, q_f: Values, velocity: Values, acceleration: Values) -> float:
    """Return the shortest duration of a quintic at rest at both ends that respects highest speeds and accelerations.

    t_f = max over the joints of 15 |Δq| / (8 k_v) and √(10 |Δq| / (√3 k_a)); the slowest joint decides.

    Source: course/handouts/quintic-004.md.

    Args:
        q_0, q_f: the positions at the start and at the end, a number or (n,) (rad, m).
        velocity, acceleration: the highest speeds k_v and accelerations k_a: one number for all joints, or (n,);
            infinite where there is none.

    Returns:
        The duration (s); 0 if no joint moves.

    Raises:
        ModelError: shapes that do not fit, a limit that is not positive, or no limit on a joint that moves.
    """
    first = read_vector(q_0, "q_0")
    distance = np.abs(_fit(q_f, "q_f", first.size) - first)
    k_v = read_limits(velocity, "velocity", first)
    k_a = read_limits(acceleration, "acceleration", first)
    if (np.isinf(k_v) & np.isinf(k_a) & (distance > 0)).any():
        raise ModelError(Fault.NO_JOINT_LIMIT)
    by_speed = PEAK_SPEED * distance / k_v
    by_acceleration = np.sqrt(PEAK_ACCELERATION * distance / k_a)
    return float(max(by_speed.max(), by_acceleration.max()))


def _coefficients(q_0: np.ndarray, q_f: np.ndarray, rates: list[np.ndarray], t_f: float) -> np.ndarray:
    """Return the coefficients a_0 … a_5 of the joints as a (6, n) array; the rates are v_0, v_f, w_0 and w_f."""
    v_0, v_f, w_0, w_f = rates
    move = q_f - q_0
    a_3 = (20 * move - (8 * v_f + 12 * v_0) * t_f - (3 * w_0 - w_f) * t_f**2) / (2 * t_f**3)
    a_4 = (-30 * move + (14 * v_f + 16 * v_0) * t_f + (3 * w_0 - 2 * w_f) * t_f**2) / (2 * t_f**4)
    a_5 = (12 * move - 6 * (v_f + v_0) * t_f - (w_0 - w_f) * t_f**2) / (2 * t_f**5)
    return np.stack([q_0, v_0, w_0 / 2, a_3, a_4, a_5])


def _fit(value: Values, name: str, size: int) -> np.ndarray:
    """Return a vector of one number a joint; one number stands for all joints."""
    vector = read_vector(value, name)
    return np.broadcast_to(vector, size) if vector.size == 1 else read_vector(value, name, size)
