"""Where an arm puts its tool, without turning it: the point, the joints that move it, and the plane in which that is seen."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from armproof.course.figures.facts.families import singularities_of
from armproof.course.figures.facts.task import generic_jacobian, task_of
from armproof.models.arm import Arm
from armproof.models.bulk.bulk import bulk_of
from armproof.models.numeric.configurations import generic_configuration
from armproof.models.numeric.plant import NumericKinematics
from armproof.models.showing.projection import (
    Projection,
    choose_projection,
    look_along,
    plane_projection,
    side_projection,
)
from armproof.models.showing.skeleton import place_skeleton
from armproof.verification.errors import EvaluationError
from armproof.verification.singularities.analysis import analyse_singularities
from armproof.verification.singularities.families import SingularityAnalysis

_ZERO = 1e-9
_SEED = 11


@dataclass(frozen=True, eq=False)
class Positioning:
    """The positioning of a point of an arm.

    Attributes:
        arm, frame: the arm, and the frame whose origin is the point: the tool's, or where the last three axes meet.
        rows: the rows of v, from 1, in which it moves.
        columns: the joints that move it, from 1.
        wrist: whether it is the centre of a wrist.
        projection: the plane of the map.
        about: whether the first joint turns the plane of the map about itself and is at rest in it.
    """

    arm: Arm
    frame: str
    rows: tuple[int, ...]
    columns: tuple[int, ...]
    wrist: bool
    projection: Projection
    about: bool

    def points(self, q: np.ndarray) -> np.ndarray:
        """Return the point at configurations (N, n) in frame 0, (N, 3)."""
        return np.asarray(bulk_of(self.arm).pose(q, self.frame)[:, :3, 3])

    def manipulability(self, q: np.ndarray) -> np.ndarray:
        """Return √det(J_v J_vᵀ) of the rows and columns at configurations (N, n), (N,)."""
        return np.asarray(bulk_of(self.arm).manipulability(q, self.frame, self.rows, self.columns))

    @property
    def free(self) -> tuple[int, ...]:
        """The joints, from 1, that move within the map."""
        return self.columns[1:] if self.about else self.columns


@lru_cache(maxsize=64)
def positioning_of(arm: Arm) -> Positioning | None:
    """Return how an arm positions its tool; None for one whose tool turns only, or stays on a surface or curve in space."""
    task = task_of(arm)
    if task.turns_only:
        return None
    frame = _wrist_centre(arm) or task.frame
    J = generic_jacobian(arm, frame, _SEED)[:, :3]
    moving = np.abs(J) > _ZERO * np.abs(J).max()
    rows = tuple(int(k) + 1 for k in np.flatnonzero(moving.any(axis=(0, 2))))
    columns = tuple(int(k) + 1 for k in np.flatnonzero(moving.any(axis=(0, 1))))
    if len(columns) < len(rows):
        return None
    flat = plane_projection(arm) or (choose_projection(arm) if len(rows) == 2 else None)
    if flat is not None:
        return Positioning(arm, frame, rows, columns, frame != task.frame, flat, False)
    section = _section(arm, frame, columns)
    return None if section is None else Positioning(arm, frame, rows, columns, frame != task.frame, section, True)


@lru_cache(maxsize=64)
def position_singularities(arm: Arm) -> SingularityAnalysis | None:
    """Return the singular configurations of the positioning; None without one, or where they are beyond exact reach."""
    positioning = positioning_of(arm)
    if positioning is None:
        return None
    task = task_of(arm)
    whole = (task.frame, task.rows, tuple(range(1, len(arm.joints) + 1)))
    try:
        if (positioning.frame, positioning.rows, positioning.columns) == whole:
            return singularities_of(arm)
        return analyse_singularities(arm, positioning.frame, positioning.rows, positioning.columns)
    except EvaluationError:
        return None


def _wrist_centre(arm: Arm) -> str | None:
    """Return the first frame at the point in which the last three of at least six axes meet, if they do and a frame is there."""
    if len(arm.joints) < 6 or any(joint.kind != "revolute" for joint in arm.joints[-3:]):
        return None
    skeleton = place_skeleton(arm, generic_configuration(arm))
    starts, axes = (np.array([getattr(joint, part) for joint in skeleton.joints[-3:]]) for part in ("start", "axis"))
    across = np.eye(3) - axes[:, :, None] * axes[:, None, :]
    centre, *_ = np.linalg.lstsq(across.reshape(-1, 3), (across @ starts[:, :, None]).ravel(), rcond=None)
    if np.abs(across @ (centre - starts)[:, :, None]).max() > _ZERO:
        return None
    return next((name for name, X in skeleton.frames.items() if np.linalg.norm(X[:3, 3] - centre) < _ZERO), None)


def _section(arm: Arm, frame: str, columns: tuple[int, ...]) -> Projection | None:
    """Return the view of the plane in which the other joints move the point while the first one rests, if there is one along z_0."""
    first = place_skeleton(arm, np.zeros(len(arm.joints))).joints[0]
    if columns[0] != 1 or first.kind != "revolute" or abs(first.axis[2]) < 1 - _ZERO:
        return None
    q = np.zeros((60, len(arm.joints)))
    q[:, [column - 1 for column in columns[1:]]] = np.random.default_rng(_SEED).uniform(-1, 1, (60, len(columns) - 1))
    points = NumericKinematics(arm, q).pose(frame)[:, :3, 3]
    points = points - points.mean(axis=0)
    _, sizes, ways = np.linalg.svd(points)
    if sizes[2] > _ZERO * sizes[0]:
        return None
    return side_projection() if abs(ways[2][1]) > 1 - _ZERO else look_along(_facing(ways[2]))


def _facing(normal: np.ndarray) -> np.ndarray:
    """Return a horizontal normal or its opposite: towards −y_0 or, across it, +x_0."""
    return np.asarray(normal if (-normal[1], normal[0]) > (0.0, 0.0) else -normal)
