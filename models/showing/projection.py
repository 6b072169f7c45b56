"""How an arm is seen: planar arms in their plane, spatial ones from a fixed direction, always along parallel rays."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from armproof.models.arm import Arm
from armproof.models.numeric.configurations import generic_configuration
from armproof.models.showing.skeleton import place_skeleton

_AZIMUTH, _ELEVATION = np.radians(-62.0), np.radians(24.0)  # x_0 to the right and a little down, y_0 into the page
_PARALLEL = 1e-9


@dataclass(frozen=True, eq=False)
class Projection:
    """An orthographic projection of frame 0 to the paper.

    Attributes:
        right, up, toward: unit vectors in frame 0 (3,): to the right and upwards on the paper, and out of it.
        planar: whether the arm moves in the plane of the paper.
    """

    right: np.ndarray
    up: np.ndarray
    toward: np.ndarray
    planar: bool = False

    def points(self, points: np.ndarray) -> np.ndarray:
        """Return points or vectors (…, 3) of frame 0 on the paper, (…, 2), in metres."""
        points = np.asarray(points, dtype=float)
        return np.stack([points @ self.right, points @ self.up], axis=-1)

    def depth(self, points: np.ndarray) -> np.ndarray:
        """Return how far points (…, 3) are in front of the paper, (…,), in metres."""
        return np.asarray(np.asarray(points, dtype=float) @ self.toward)

    def along(self, vector: np.ndarray) -> float:
        """Return how much a vector points at the viewer: 1 straight at them, −1 straight away, 0 in the paper."""
        return float(vector @ self.toward / np.linalg.norm(vector))


def look_along(toward: np.ndarray, planar: bool = False) -> Projection:
    """Return the view of someone in a direction from the arm, with z_0 upwards, or y_0 seen along z_0.

    Args:
        toward: (3,) from the arm to the viewer, not zero.
    """
    toward = np.asarray(toward, dtype=float) / np.linalg.norm(toward)
    vertical = np.array([0.0, 0.0, 1.0]) if abs(toward[2]) < 1 - 1e-9 else np.array([0.0, 1.0, 0.0])
    right = np.cross(vertical, toward)
    right /= np.linalg.norm(right)
    vectors = (right, np.cross(toward, right), toward)
    for vector in vectors:
        vector[np.abs(vector) < 1e-15] = 0.0
        vector.flags.writeable = False
    return Projection(*vectors, planar)


def axonometric() -> Projection:
    """Return the one view in which spatial arms are drawn."""
    flat = np.array([np.cos(_AZIMUTH), np.sin(_AZIMUTH), 0.0])
    return look_along(np.cos(_ELEVATION) * flat + np.array([0.0, 0.0, np.sin(_ELEVATION)]))


def side_projection() -> Projection:
    """Return the view of the plane x_0 z_0, x_0 to the right and z_0 upwards."""
    return look_along(np.array([0.0, -1.0, 0.0]))


@lru_cache(maxsize=64)
def choose_projection(arm: Arm) -> Projection:
    """Return how an arm is best seen: a planar one along the normal of its plane, another one axonometrically."""
    normal = _plane_normal(arm)
    return axonometric() if normal is None else look_along(normal, planar=True)


@lru_cache(maxsize=64)
def plane_projection(arm: Arm) -> Projection | None:
    """Return the view along the revolute axes where all are parallel (planar arms, SCARA), else None."""
    turning, _ = _axes(arm)
    if not len(turning) or not _parallel(turning):
        return None
    return look_along(_facing(turning[0]), planar=True)


def _plane_normal(arm: Arm) -> np.ndarray | None:
    turning, sliding = _axes(arm)
    if len(turning):
        normal = turning[0]
        if not _parallel(turning):
            return None
    elif len(sliding) > 1 and not _parallel(sliding[:2]):
        normal = np.cross(sliding[0], sliding[1])
        normal /= np.linalg.norm(normal)
    else:
        return None
    return _facing(normal) if np.all(np.abs(sliding @ normal) < _PARALLEL) else None


def _axes(arm: Arm) -> tuple[np.ndarray, np.ndarray]:
    """Return the revolute and the prismatic axes in frame 0 at a configuration without any special angle."""
    joints = place_skeleton(arm, generic_configuration(arm)).joints
    axes = {
        kind: np.array([joint.axis for joint in joints if joint.kind == kind]) for kind in ("revolute", "prismatic")
    }
    return axes["revolute"].reshape(-1, 3), axes["prismatic"].reshape(-1, 3)


def _parallel(axes: np.ndarray) -> bool:
    return bool(np.all(np.linalg.norm(np.cross(axes, axes[0]), axis=1) < _PARALLEL))


def _facing(normal: np.ndarray) -> np.ndarray:
    """Return a normal or its opposite: z_0 points at the viewer, x_0 to the right, y_0 to the right, in this order."""
    keys = (normal[2], -normal[1], normal[0])
    sign = next((np.sign(key) for key in keys if abs(key) > 1e-6), 1.0)
    return np.asarray(sign * normal)
