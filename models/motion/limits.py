"""The limits that a motion has to respect: those of the joints in the model file, and what a user gives for those missing."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from armproof.models.arm import Arm
from armproof.models.errors import Fault, ModelError
from armproof.models.numeric.drake_arm import drake_of, plant_of

LEAST, GREATEST = (
    1e-6,
    1e9,
)  # of a limit, unless it is infinite; Drake ends the process on times that rounding makes equal
_ROUNDING = 1e-9  # rad, m: a polynomial that ends at a limit may pass it by so much
_UNITS = {"revolute": "rad", "prismatic": "m"}


def extremes(trajectory: Any, order: int = 0) -> tuple[np.ndarray, np.ndarray]:
    """Return the smallest and the largest value of each row of a piecewise polynomial, or of a derivative of it.

    They are at the ends of a segment or where the derivative is zero: at the real roots of its polynomial.

    Args:
        trajectory: a pydrake PiecewisePolynomial with values of the shape (n, 1).
        order: 0 for positions, 1 for velocities, 2 for accelerations.

    Returns:
        (n,) and (n,).
    """
    polynomial = trajectory.derivative(order) if order else trajectory
    breaks = polynomial.get_segment_times()
    lower, upper = np.empty(polynomial.rows()), np.empty(polynomial.rows())
    for row in range(polynomial.rows()):
        values = [
            value
            for segment in range(polynomial.get_number_of_segments())
            for value in _candidates(
                polynomial.getPolynomial(segment, row, 0).GetCoefficients(), breaks[segment + 1] - breaks[segment]
            )
        ]
        lower[row], upper[row] = min(values), max(values)
    return lower, upper


def _candidates(coefficients: np.ndarray, duration: float) -> np.ndarray:
    """Return the values of a_0 + a_1 t + … at 0, at the duration and at the stationary points between."""
    scaled = coefficients * duration ** np.arange(len(coefficients))  # of t / duration, which keeps the roots near 1
    polynomial = np.polynomial.Polynomial(scaled)
    # The real part of a complex root does no harm: its value lies between the extremes.
    roots = np.clip(np.real(polynomial.deriv().roots()), 0.0, 1.0)
    return np.asarray(polynomial(np.concatenate([[0.0, 1.0], roots])))


@dataclass(frozen=True)
class RateLimits:
    """The highest rates of n joints, in both directions; infinite where there is none.

    Attributes:
        velocity: rad/s, m/s.
        acceleration: rad/s², m/s².
        effort: torque or force of the drive, N m, N.
    """

    velocity: np.ndarray
    acceleration: np.ndarray
    effort: np.ndarray


def read_rate_limits(arm: Arm, *, velocity: Any = None, acceleration: Any = None, effort: Any = None) -> RateLimits:
    """Return the highest rates of an arm's joints: those given, otherwise those of its model file.

    A URDF states them as <limit velocity="…" effort="…" drake:acceleration="…"/>; it reaches the drive by a <transmission>.
    Where the limits of the two directions differ, the nearer to 0 counts for both.

    Args:
        velocity, acceleration, effort: one positive number for all joints, or (n,); infinite for none.

    Raises:
        ModelError: another shape, or a limit that is not positive.
    """
    joints = drake_of(arm).joints
    found = {
        "velocity": [_nearer(j.velocity_lower_limits(), j.velocity_upper_limits()) for j in joints],
        "acceleration": [_nearer(j.acceleration_lower_limits(), j.acceleration_upper_limits()) for j in joints],
        "effort": _efforts(arm),
    }
    given = {"velocity": velocity, "acceleration": acceleration, "effort": effort}
    return RateLimits(**{name: read_limits(given[name], name, values) for name, values in found.items()})


def read_limits(value: Any, name: str, default: Any) -> np.ndarray:
    """Return one limit a joint, read-only: the value, or where it is None the default.

    Raises:
        ModelError: another shape than one number or one for each joint, or a limit that is not positive.
    """
    size = len(default)
    try:
        limits = np.atleast_1d(np.array(default if value is None else value, dtype=float))
    except (TypeError, ValueError):
        raise ModelError(Fault.NO_LIMITS, name=name, value=f"{value!r:.60}") from None
    within = (limits >= LEAST) & ((limits <= GREATEST) | np.isinf(limits))
    if limits.shape not in ((1,), (size,)) or not within.all():
        fault, wrong = (Fault.LIMIT_SHAPE_OF_MODEL, limits.tolist()) if value is None else (Fault.LIMIT_SHAPE, value)
        raise ModelError(fault, name=name, size=size, least=LEAST, greatest=GREATEST, value=str(wrong))
    limits = np.array(np.broadcast_to(limits, size))
    limits.flags.writeable = False
    return limits


def require_within_limits(arm: Arm, trajectory: Any) -> None:
    """Check that a piecewise polynomial keeps every joint within its limits, at all times and not only at its points.

    Raises:
        ModelError: a joint leaves its limits; which, and how far.
    """
    for joint, least, most in zip(arm.joints, *extremes(trajectory), strict=True):
        if least < joint.lower - _ROUNDING or most > joint.upper + _ROUNDING:
            reached = least if least < joint.lower - _ROUNDING else most
            raise ModelError(
                Fault.BEYOND_LIMITS,
                joint=joint.symbol,
                arm=arm.name,
                reached=reached,
                unit=_UNITS[joint.kind],
                lower=joint.lower,
                upper=joint.upper,
            )


def _nearer(lower: np.ndarray, upper: np.ndarray) -> float:
    return float(min(-lower[0], upper[0]))


def _efforts(arm: Arm) -> list[float]:
    """Return the effort limit of the drive of each joint, infinite for a joint without a drive."""
    plant = plant_of(arm)
    drives = (plant.get_joint_actuator(index) for index in plant.GetJointActuatorIndices())
    efforts = {drive.joint().index(): float(drive.effort_limit()) for drive in drives}
    return [efforts.get(joint.index(), np.inf) for joint in drake_of(arm).joints]
