"""The images of singular families in a plane: configurations of a family, ordered along the curve that they draw."""

from __future__ import annotations

import numpy as np

from armproof.course.figures.facts.positioning import Positioning
from armproof.course.figures.facts.task import joint_ranges, within_limits
from armproof.models.arm import Arm
from armproof.verification.singularities.families import Family

_DRAWN, _ROUNDS, _ENOUGH = 400, 4, 350
_SEED = 5
_FINE = 400  # cells along the longer side of the map in which one point is kept
_COARSE, _AREA = 60, 420  # so many of 60 × 60 cells are an area and no curve
_GAP = 0.06  # of the longer side: a curve is broken where it has a longer gap
_ON_IT = 1e-9


def family_curve(positioning: Positioning, family: Family) -> np.ndarray:
    """Return configurations (M, n) of a family within the joint limits, in order along its image; rows of NaN part its pieces.

    No configuration at all (0, n) where none is within the limits, or where the image is an area.
    """
    arm, rng = positioning.arm, np.random.default_rng(_SEED)
    moving = [column - 1 for column in positioning.columns]
    still = [k for k in range(len(arm.joints)) if k not in moving or (positioning.about and k == 0)]
    found: list[np.ndarray] = []
    for _ in range(_ROUNDS):
        q = family.sample(rng, _DRAWN)
        q[:, still] = 0.0
        q = into_limits(arm, q)
        kept = within_limits(arm, q)[:, [k for k in moving if k not in still]].all(axis=1)
        found.append(q[kept & family.contains(q, _ON_IT)])
        if not 0 < sum(map(len, found)) < _ENOUGH:
            break
    q = np.vstack(found)
    if not len(q):
        return np.empty((0, len(arm.joints)))
    points = positioning.projection.points(positioning.points(q))
    size = max(float(np.ptp(points, axis=0).max()), 1e-9)
    if _firsts(points, size / _COARSE).size > _AREA:
        return np.empty((0, len(arm.joints)))
    kept = _firsts(points, size / _FINE)
    return _ordered(q[kept], points[kept], _GAP * size)


def into_limits(arm: Arm, q: np.ndarray) -> np.ndarray:
    """Return configurations (N, n) with each angle changed by whole turns towards the middle of its range."""
    q = q.copy()
    for k, (low, high) in enumerate(joint_ranges(arm)):
        if arm.joints[k].kind == "revolute":
            q[:, k] -= 2 * np.pi * np.round((q[:, k] - (low + high) / 2) / (2 * np.pi))
    return q


def _firsts(points: np.ndarray, size: float) -> np.ndarray:
    """Return the places of the points that are the first in their cells of a grid."""
    return np.sort(np.unique(np.floor(points / size).astype(int), axis=0, return_index=True)[1])


def _ordered(q: np.ndarray, points: np.ndarray, gap: float) -> np.ndarray:
    """Return configurations in the order in which a pen goes from point to nearest point, lifted at gaps."""
    left = np.ones(len(points), dtype=bool)
    pieces: list[np.ndarray] = []
    while left.any():
        chain = [int(np.flatnonzero(left)[0])]
        left[chain[0]] = False
        for _ in range(2):  # forward, then backward from where it began
            while left.any():
                distance = np.where(left, np.linalg.norm(points - points[chain[-1]], axis=1), np.inf)
                nearest = int(np.argmin(distance))
                if distance[nearest] > gap:
                    break
                chain.append(nearest)
                left[nearest] = False
            chain.reverse()
        if len(chain) > 2 and np.linalg.norm(points[chain[0]] - points[chain[-1]]) < gap:
            chain.append(chain[0])
        if len(chain) > 1 or not pieces:
            pieces += [q[chain], np.full((1, q.shape[1]), np.nan)]
    return np.vstack(pieces[:-1])
