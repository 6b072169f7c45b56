"""Configurations at which an arm is well seen."""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from armproof.course.figures.facts.task import joint_ranges, tool_frame
from armproof.models.arm import Arm
from armproof.models.bulk.bulk import bulk_of
from armproof.models.numeric.configurations import generic_configuration
from armproof.models.showing.projection import Projection, choose_projection
from armproof.models.showing.skeleton import place_skeleton, simplify

_TRIED = 160
_SEED = 2019
_STEP = np.radians(15)
_QUARTER = 6  # steps of a right angle
_MOST = 2.1  # rad


def zero_pose(arm: Arm) -> np.ndarray:
    """Return the zero pose as far as the limits allow, prismatic joints at the middle of their range, (n,)."""
    values = []
    for joint, (low, high) in zip(arm.joints, joint_ranges(arm), strict=True):
        slides = joint.kind == "prismatic"
        values.append(round(0.35 * low + 0.65 * high, 3) if slides else min(max(0.0, low), high))
    return np.array(values)


@lru_cache(maxsize=64)
def showing_pose(arm: Arm) -> np.ndarray:
    """Return a configuration within the limits at which an arm is well seen, angles multiples of 15°, (n,), read-only.

    Of those drawn by a fixed generator, the one with its joints farthest apart on the paper and farthest from a singular posture.
    """
    candidates = _candidates(arm, np.random.default_rng(_SEED))
    bent = 3.0 * np.minimum(_roundness(arm, candidates), 0.6)
    scores = np.array([_clearness(arm, choose_projection(arm), q) for q in candidates]) + bent
    best = candidates[int(np.argmax(scores))].copy()
    best.flags.writeable = False
    return best


def _candidates(arm: Arm, rng: np.random.Generator) -> np.ndarray:
    columns = []
    for joint, (low, high), middle in zip(arm.joints, joint_ranges(arm), generic_configuration(arm), strict=True):
        if joint.kind == "prismatic":
            columns.append(np.full(_TRIED, round(middle, 2) if high - low > 0.05 else middle))
            continue
        steps = np.arange(np.ceil(max(low, -_MOST) / _STEP), np.floor(min(high, _MOST) / _STEP) + 1)
        if choose_projection(arm).planar and np.any(np.abs(steps) != _QUARTER):
            steps = steps[np.abs(steps) != _QUARTER]  # there the y axis lies along the link
        if joint.index > 1 and np.any(np.abs(steps) > 1):
            steps = steps[np.abs(steps) > 1]
        columns.append(_STEP * rng.choice(steps if len(steps) else np.array([middle / _STEP]), _TRIED))
    return np.column_stack(columns)


def _roundness(arm: Arm, q: np.ndarray) -> np.ndarray:
    """Return how far configurations are from singular ones, compared with the best of them: from 0 to 1."""
    frame = tool_frame(arm)
    by_position = 1 / bulk_of(arm).condition_number(q, frame, rows=(1, 2, 3))
    by_all = 1 / bulk_of(arm).condition_number(q, frame)
    return np.asarray(np.minimum(by_position / by_position.max(), by_all / by_all.max()))


def _clearness(arm: Arm, projection: Projection, q: np.ndarray) -> float:
    """Return how well an arm is seen: links in the paper, points apart on it, above the ground, to the right, little turned."""
    points = simplify(place_skeleton(arm, q).line(tool_frame(arm)))
    paper = projection.points(points)
    lengths, seen = (np.linalg.norm(np.diff(line, axis=0), axis=1) for line in (points, paper))
    total = max(float(lengths.sum()), 1e-12)
    straight = float(np.sum(seen * seen / np.maximum(lengths, 1e-12))) / total
    gaps = [float(np.linalg.norm(paper[i] - paper[j])) for i in range(len(paper)) for j in range(i + 2, len(paper))]
    right, up = (paper[-1] - paper[0]) / total
    below = 0.0 if projection.planar else max(0.0, float(points[0, 2] - points[:, 2].min())) / total
    apart = min(gaps, default=total) / total
    return straight + 2 * apart - 2 * below + 0.3 * right + 0.3 * up - 0.05 * float(np.abs(q).mean())
