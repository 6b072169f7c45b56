"""Targets and lengths as anyone hands them in: read and checked in one place, with a message that says what is wrong."""

from __future__ import annotations

from collections.abc import Mapping
from math import isfinite
from numbers import Real
from typing import Any

import numpy as np

from armproof.models.arm import Arm
from armproof.models.bulk.program import BLOCK
from armproof.models.errors import ArmproofError, Sentence
from armproof.verification.inverse.target import Pair, Target

ORTHONORMAL = 1e-6  # how far the rows of a rotation may be from a right-handed orthonormal frame


class InverseError(ArmproofError):
    """A batch of targets that cannot be read, or an arm without a closed-form inverse in the course."""


def read_targets(target: Target, targets: Any) -> tuple[np.ndarray, np.ndarray]:
    """Return targets as an (N, m) array of doubles, and which of them are none: not finite, or no rotation.

    Raises:
        InverseError: another shape, or something that is not a real number.
    """
    try:
        values = np.asarray(targets)
    except (ValueError, TypeError):
        raise InverseError("targets are rows of equal length, {expected}", expected=_shapes(target)) from None
    if values.dtype.kind not in "iuf":
        raise InverseError("targets are real numbers (m, rad), not {dtype}", dtype=values.dtype)
    m = len(target.slots)
    if values.shape[1:] not in {(m,), target.shape}:
        hint = Sentence("; write one target as [x]") if values.shape in {(m,), target.shape} else ""
        raise InverseError("targets have the shape {expected}, not {shape}{hint}",
            expected=_shapes(target), shape=str(values.shape), hint=hint)  # fmt: skip
    rows = values.reshape(len(values), m).astype(float)
    invalid = np.zeros(len(rows), dtype=bool)
    if not np.isfinite(rows).all():
        invalid = ~np.isfinite(rows).all(axis=1)
        rows[invalid] = 0.0
    for column, slot in enumerate(target.slots):
        if slot.is_constant:
            invalid |= rows[:, column] != (1.0 if slot.column == 3 else 0.0)
    for pair in target.rotations:
        invalid |= ~_is_rotation(target, pair, rows)
    return rows, invalid


def read_lengths(arm: Arm, lengths: Mapping[str, float] | None) -> dict[str, float]:
    """Return the number of each length and constant angle of the arm, those of `lengths` in place of the model's.

    Raises:
        InverseError: a name that is no length of the arm, or a value that is no positive number.
    """
    known = {**arm.lengths, **arm.angles}
    for name, value in (lengths or {}).items():
        if name not in arm.lengths:
            raise InverseError("no length '{name}' on arm '{arm}'; it has {lengths}",
                name=name, arm=arm.name, lengths=", ".join(arm.lengths) or "none")  # fmt: skip
        if isinstance(value, bool) or not isinstance(value, Real) or not isfinite(value) or value <= 0:
            raise InverseError("the length '{name}' of arm '{arm}' is a positive number (m), not {value}",
                name=name, arm=arm.name, value=repr(value))  # fmt: skip
        known[name] = float(value)
    return known


def _is_rotation(target: Target, pair: Pair, rows: np.ndarray) -> np.ndarray:
    """Return which rows hold a rotation: orthonormal rows, the third the cross product of the others."""
    cells = target.cells(pair)
    columns = [cells[r, c] for r in range(3) for c in range(3)]
    proper = np.empty(len(rows), dtype=bool)
    for start in range(0, len(rows), BLOCK):
        a, b, c, d, e, f, g, h, i = rows[start : start + BLOCK, columns].T.copy()
        deviations = (
            a * a + b * b + c * c - 1.0,
            d * d + e * e + f * f - 1.0,
            a * d + b * e + c * f,
            b * f - c * e - g,
            c * d - a * f - h,
            a * e - b * d - i,
        )
        proper[start : start + BLOCK] = np.abs(np.stack(deviations)).max(axis=0) <= ORTHONORMAL
    return proper


def _shapes(target: Target) -> str:
    numbers = f"(N, {len(target.slots)})"
    if target.shape == (len(target.slots),):
        return f"{numbers}: {', '.join(slot.label for slot in target.slots)}"
    return f"(N, {', '.join(map(str, target.shape))}) or {numbers}"
