"""Checks of what a user gives for a motion: numbers, vectors, durations."""

from __future__ import annotations

import numpy as np

from armproof.models.errors import Fault, ModelError

SHORTEST = 1e-9  # s; Drake ends the process on breaks that are nearer to each other than its rounding


def read_vector(value: object, name: str, size: int | None = None) -> np.ndarray:
    """Return a value as a read-only vector of finite numbers; a single number is a vector of one.

    Args:
        size: how many numbers; any number of them if not given.

    Raises:
        ModelError: not numbers, not finite, or another shape.
    """
    try:
        vector = np.atleast_1d(np.array(value, dtype=float))
    except (TypeError, ValueError):
        raise ModelError(Fault.NOT_A_VECTOR, name=name, value=f"{value!r:.60}") from None
    if vector.ndim != 1 or (vector.size != size if size is not None else not vector.size):
        expected = "(n,)" if size is None else f"({size},)"
        raise ModelError(Fault.VECTOR_SHAPE, name=name, expected=expected, shape=str(vector.shape))
    if not np.isfinite(vector).all():
        raise ModelError(Fault.VECTOR_NOT_FINITE, name=name, number=int(np.argmin(np.isfinite(vector))) + 1)
    vector.flags.writeable = False
    return vector


def read_duration(value: object, name: str = "duration") -> float:
    """Return a duration in seconds.

    Raises:
        ModelError: not one finite number, or not above 0.
    """
    duration = float(read_vector(value, name, 1)[0])
    if not SHORTEST <= duration <= 1 / SHORTEST:
        raise ModelError(Fault.DURATION, name=name, shortest=SHORTEST, longest=1 / SHORTEST, duration=duration)
    return duration
