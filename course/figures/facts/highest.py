"""The highest value near a configuration: a grid around it, again and again with a finer one."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

_ZOOMS, _ZOOMED = 5, 41


def climb(
    value: Callable[[np.ndarray], np.ndarray], q: np.ndarray, joints: Sequence[int], axes: Sequence[np.ndarray]
) -> tuple[np.ndarray, float]:
    """Return the configuration (n,) near another at which a value of configurations (N, n) is highest, and that value.

    Args:
        joints: the places of those that are moved.
        axes: the values of each, increasing: a step and the ends within which it stays.
    """
    steps = [axis[1] - axis[0] for axis in axes]
    for _ in range(_ZOOMS):
        around = [
            np.clip(q[k] + np.linspace(-step, step, _ZOOMED), axis[0], axis[-1])
            for k, step, axis in zip(joints, steps, axes, strict=True)
        ]
        tried = np.tile(q, (_ZOOMED ** len(around), 1))
        tried[:, list(joints)] = np.column_stack([part.ravel() for part in np.meshgrid(*around)])
        values = value(tried)
        q = tried[int(np.argmax(values))]
        steps = [4 * step / _ZOOMED for step in steps]
    return q, float(values.max())
