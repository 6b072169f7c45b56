"""The boundary of what a point reaches in a plane: where joints stand at their limits, or the others lose a direction."""

from __future__ import annotations

from itertools import combinations, product

import contourpy
import numpy as np

from armproof.course.figures.facts.positioning import Positioning
from armproof.course.figures.facts.task import joint_ranges
from armproof.models.bulk.bulk import bulk_of

_ALONG = 1200  # configurations of a curve on which one joint moves
_GRID = 241  # of a joint, where two move
_NEAR = 2  # cells of the map between a boundary and what is not reached
_PIECE = 6  # cells: a shorter piece is a curve that crosses the boundary


def boundary(positioning: Positioning, x: np.ndarray, y: np.ndarray, reached: np.ndarray) -> np.ndarray:
    """Return the points (M, 2) of the boundary of a workspace; rows of NaN part its pieces.

    Args:
        x, y: the centres of the cells of its map.
        reached: (len(y), len(x)), which of them some configuration reaches.
    """
    beside = _widened(~_widened(np.pad(reached, 2 * _NEAR), 1), _NEAR + 1)
    cell, pieces = x[1] - x[0], []
    for q in boundary_candidates(positioning):
        points = positioning.projection.points(positioning.points(q))
        across, up = (
            np.round((points[:, k] - axis[0]) / cell).astype(int) + 2 * _NEAR for k, axis in enumerate((x, y))
        )
        kept = beside[np.clip(up, 0, len(beside) - 1), np.clip(across, 0, len(beside[0]) - 1)]
        for run in np.split(np.arange(len(q)), np.flatnonzero(np.diff(kept)) + 1):
            way = float(np.linalg.norm(np.diff(points[run], axis=0), axis=1).sum())
            if kept[run[0]] and way > _PIECE * cell:
                pieces += [points[run], np.full((1, 2), np.nan)]
    return np.vstack(pieces[:-1]) if pieces else np.empty((0, 2))


def _widened(cells: np.ndarray, by: int) -> np.ndarray:
    """Return cells with those around them, so many to each side."""
    padded = np.pad(cells, by)
    return np.asarray(np.lib.stride_tricks.sliding_window_view(padded, (2 * by + 1,) * 2).any(axis=(2, 3)))


def boundary_candidates(positioning: Positioning) -> list[np.ndarray]:
    """Return curves of configurations (M, n) whose points hold all of the boundary.

    A point is on it only where the joints that can still move either way give one direction at most: one joint, all
    others at their limits; or two whose columns are parallel, the others at their limits. Where three move, all columns
    are parallel: those curves are the singular families of the arm.
    """
    curves = []
    ends = {column: joint_ranges(positioning.arm)[column - 1] for column in positioning.free}
    for moving in positioning.free:
        for fixed in _fixed(positioning, (moving,), ends):
            q = np.tile(fixed, (_ALONG, 1))
            q[:, moving - 1] = np.linspace(*ends[moving], _ALONG)
            curves.append(q)
    for pair in combinations(positioning.free, 2):
        for fixed in _fixed(positioning, pair, ends):
            curves += _parallel(positioning, pair, fixed, ends)
    return curves


def _fixed(positioning: Positioning, moving: tuple[int, ...], ends: dict[int, tuple[float, float]]) -> list[np.ndarray]:
    """Return the configurations in which all joints but those that move stand at a limit."""
    resting = [column for column in positioning.free if column not in moving]
    found = []
    for values in product(*(ends[column] for column in resting)):
        q = np.zeros(len(positioning.arm.joints))
        q[[column - 1 for column in resting]] = values
        found.append(q)
    return found


def _parallel(
    positioning: Positioning, pair: tuple[int, int], fixed: np.ndarray, ends: dict[int, tuple[float, float]]
) -> list[np.ndarray]:
    """Return the curves on which two joints move the point along one line only."""
    first, second = (np.linspace(*ends[column], _GRID) for column in pair)
    q = np.tile(fixed, (_GRID * _GRID, 1))
    q[:, pair[0] - 1], q[:, pair[1] - 1] = (each.ravel() for each in np.meshgrid(first, second))
    J = bulk_of(positioning.arm).pose_and_jacobian(q, positioning.frame)[1][:, :3]
    columns = positioning.projection.points(J[:, :, [column - 1 for column in pair]].transpose(0, 2, 1))
    determinant = np.linalg.det(columns).reshape(_GRID, _GRID)
    curves = []
    for line in contourpy.contour_generator(first, second, determinant).lines(0.0):
        q = np.tile(fixed, (len(line), 1))
        q[:, [column - 1 for column in pair]] = line
        curves.append(q)
    return curves
