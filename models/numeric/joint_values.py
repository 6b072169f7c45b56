"""Joint values (rad, m) as anyone hands them in: read and checked in one place, with a ModelError that says what is wrong."""

from __future__ import annotations

from typing import Any

import numpy as np

from armproof.models.arm import Arm
from armproof.models.errors import Fault, ModelError, Sentence, counted
from armproof.models.language import noted

_UNITS = {"revolute": "rad", "prismatic": "m"}


def read_joint_values(arm: Arm, q: Any) -> np.ndarray:
    """Return the joint values of N configurations as an (N, n) array of doubles; N may be 0.

    Args:
        q: an array, list or tuple of N configurations, each with n real numbers, base to tool (rad, m). Values outside
            the joint limits are allowed; `outside_limits` tells of them.

    Raises:
        ModelError: another shape, something that is not a real number, or a number that is not finite.
    """
    values = _read_numbers(arm, q)
    n = len(arm.joints)
    if values.ndim != 2 or values.shape[1] != n:
        fault = Fault.ONE_CONFIGURATION_AS_LIST if values.shape == (n,) else Fault.CONFIGURATIONS_SHAPE
        raise ModelError(fault, arm=arm.name, n=n, shape=str(values.shape), joints=_joints(arm))
    return _finite(arm, values)


def read_configuration(arm: Arm, q: Any) -> np.ndarray:
    """Return the joint values of one configuration as an (n,) array of doubles; otherwise as `read_joint_values`."""
    values = _read_numbers(arm, q)
    n = len(arm.joints)
    if values.shape != (n,):
        raise ModelError(Fault.CONFIGURATION_SHAPE, arm=arm.name, n=n, shape=str(values.shape), joints=_joints(arm))
    return _finite(arm, values)


def outside_limits(arm: Arm, q: Any) -> np.ndarray:
    """Return which joint values, (N, n) or (n,), lie outside the limits of their joints, an array of booleans of that shape."""
    values = _read_numbers(arm, q)
    values = read_configuration(arm, values) if values.ndim == 1 else read_joint_values(arm, values)
    lower, upper = (np.array([getattr(joint, end) for joint in arm.joints]) for end in ("lower", "upper"))
    return np.asarray((values < lower) | (values > upper))


def limit_notes(arm: Arm, q: Any) -> tuple[str, ...]:
    """Return one sentence for each joint that some configuration, (N, n) or (n,), takes beyond its limits; none if all are within."""
    outside = np.atleast_2d(outside_limits(arm, q))
    return tuple(
        counted(
            "{joint} is outside its limits [{lower:g}, {upper:g}] {unit} at {count} of {number} configuration",
            "{joint} is outside its limits [{lower:g}, {upper:g}] {unit} at {count} of {number} configurations",
            len(outside),
            joint=joint.symbol,
            lower=joint.lower,
            upper=joint.upper,
            unit=_UNITS[joint.kind],
            count=int(count),
        )
        for joint, count in zip(arm.joints, outside.sum(axis=0), strict=True)
        if count
    )


def _read_numbers(arm: Arm, q: Any) -> np.ndarray:
    """Return the array of doubles that q is, of whatever shape."""
    if isinstance(q, np.ma.MaskedArray) and np.ma.is_masked(q):
        raise ModelError(Fault.MASKED_VALUES, arm=arm.name, count=q.mask.sum())
    try:
        values = np.asarray(q)
    except (ValueError, TypeError, OverflowError):
        raise ModelError(Fault.UNEQUAL_LENGTHS, arm=arm.name, n=len(arm.joints), joints=_joints(arm)) from None
    if values.dtype.kind not in "iuf":
        names = {"b": noted("booleans"), "c": noted("complex numbers"), "U": noted("text"), "S": noted("text")}
        what = Sentence(names.get(values.dtype.kind, noted("objects")))
        raise ModelError(Fault.NOT_REAL, arm=arm.name, what=what, dtype=values.dtype)
    with np.errstate(over="ignore"):
        return values.astype(float, copy=False)


def _finite(arm: Arm, values: np.ndarray) -> np.ndarray:
    wrong = np.argwhere(~np.isfinite(values))
    if len(wrong):
        place = ", ".join(str(index) for index in wrong[0])
        raise ModelError(
            Fault.NOT_FINITE_VALUE,
            place=place,
            joint=arm.joints[wrong[0][-1]].symbol,
            arm=arm.name,
            value=str(values[tuple(wrong[0])]),
        )
    return values


def _joints(arm: Arm) -> str:
    return ", ".join(f"{joint.symbol} ({_UNITS[joint.kind]})" for joint in arm.joints)
