"""Elbow up and down: the two triangles of shoulder, elbow and target in the plane across parallel axes, and their circles."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from armproof.course.figures.facts.solutions import is_square, postures_of
from armproof.models.arm import Arm
from armproof.models.showing.projection import Projection, plane_projection
from armproof.models.showing.skeleton import place_skeleton

_TURNING = 2  # joints that make the triangle
_SAME = 1e-9


@dataclass(frozen=True, eq=False)
class Elbow:
    """Two postures of the first two parallel axes that reach one target.

    Attributes:
        projection: along the axes.
        q: (2, n), elbow to the left of the way to the target, then to the right.
        shoulder, target: (2,) on the paper (m).
        elbows: (2, 2), where the circles about both meet.
        radii: of the circle about the shoulder, and of that about the target (m).
    """

    projection: Projection
    q: np.ndarray
    shoulder: np.ndarray
    target: np.ndarray
    elbows: np.ndarray
    radii: tuple[float, float]


@lru_cache(maxsize=64)
def elbow_of(arm: Arm) -> Elbow | None:
    """Return the two postures of an arm; None without two first parallel axes, or with more or fewer postures."""
    projection = plane_projection(arm)
    kinds = [joint.kind for joint in arm.joints]
    if projection is None or kinds[:_TURNING] != ["revolute"] * _TURNING or not is_square(arm):
        return None
    q = postures_of(arm).q
    if len(q) != _TURNING:
        return None
    corners = [_corners(arm, projection, each) for each in q]
    if any(np.linalg.norm(corners[0][k] - corners[1][k]) > _SAME for k in (0, 2)):
        return None
    sides = [_side(*each) for each in corners]
    order = np.argsort(sides)[::-1]
    shoulder, elbow, target = corners[order[0]]
    radii = float(np.linalg.norm(elbow - shoulder)), float(np.linalg.norm(target - elbow))
    elbows = np.array([corners[k][1] for k in order])
    return Elbow(projection, q[order], shoulder, target, elbows, radii)


def _corners(arm: Arm, projection: Projection, q: np.ndarray) -> np.ndarray:
    """Return shoulder, elbow and target of a configuration on the paper: the next turning axis there, or the tool."""
    pose = place_skeleton(arm, q)
    turning = [joint for joint in pose.joints if joint.kind == "revolute"]
    end = turning[2].start if len(turning) > 2 else pose.frames[arm.frames[-1]][:3, 3]
    return projection.points(np.array([turning[0].start, turning[1].start, end]))


def _side(shoulder: np.ndarray, elbow: np.ndarray, target: np.ndarray) -> float:
    (a, b), (c, d) = target - shoulder, elbow - shoulder
    return float(a * d - b * c)
