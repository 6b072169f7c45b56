"""From space to the page: planar arms are seen along their normal, all others in one fixed axonometric projection."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

_FLAT = 1e-6  # of the reach: a plane to the eye
_AZIMUTH, _ELEVATION = np.radians(-58.0), np.radians(24.0)
_PLANES = {2: ((1, 0, 0), (0, 1, 0)), 1: ((1, 0, 0), (0, 0, 1)), 0: ((0, 1, 0), (0, 0, 1))}  # by the axis looked along


@dataclass(frozen=True)
class View:
    """Which directions of frame 0 point right and up on the page."""

    right: tuple[float, float, float]
    up: tuple[float, float, float]

    def project(self, point: Sequence[float] | np.ndarray) -> tuple[float, float]:
        """Return a point's place on the page (m), up counted upwards."""
        point = np.asarray(point, dtype=float)[:3]
        return float(point @ np.array(self.right)), float(point @ np.array(self.up))

    @property
    def is_planar(self) -> bool:
        """Whether one looks along an axis of frame 0."""
        return sorted(map(abs, self.right)) == [0, 0, 1]


def axonometric() -> View:
    """Return the view of a spatial arm: from before and above, z upwards."""
    ca, sa, ce, se = np.cos(_AZIMUTH), np.sin(_AZIMUTH), np.cos(_ELEVATION), np.sin(_ELEVATION)
    return View((float(-sa), float(ca), 0.0), (float(-se * ca), float(-se * sa), float(ce)))


def choose_view(points: np.ndarray) -> View:
    """Return the view in which an arm is drawn.

    Args:
        points: (N, 3) all points of the arm at several configurations, frame 0 (m).
    """
    reach = max(float(np.ptp(points, axis=0).max(initial=0.0)), 1e-9)
    for axis in (2, 1, 0):
        if np.ptp(points[:, axis]) < _FLAT * reach:
            right, up = _PLANES[axis]
            return View(right, up)
    return axonometric()
