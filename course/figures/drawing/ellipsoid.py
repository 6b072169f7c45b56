"""The ellipsoid of the velocities that joint rates of norm 1 give, drawn in projection; flat where a direction is lost."""

from __future__ import annotations

import numpy as np

from armproof.course.figures.drawing.scene import Scene
from armproof.course.figures.drawing.style import Stroke

_POINTS = 120
_THIN = 0.6  # mm: what is thinner on the paper is a line


def draw_ellipsoid(scene: Scene, centre: np.ndarray, B: np.ndarray, size: float, stroke: Stroke, gid: str = "") -> None:
    """Draw {B u : |u| = 1} about a point: its outline, and its sections by the planes of its axes.

    Args:
        centre: (3,) in frame 0 (m).
        B: (3, k), in any unit.
        size: metres on the paper a unit of B.
        gid: of the outline.
    """
    middle = scene.paper(centre)
    outline = middle + size * _outline(scene.paper(B.T).T)
    flat = np.ptp((outline - middle) @ _narrow(outline - middle)) < scene.metres(_THIN)
    scene.fill(outline, zorder=4.2, facecolor=stroke.colour, edgecolor="none", alpha=0.16)
    linestyle = "-" if flat else stroke.linestyle
    width = 2.2 if flat else 1.0
    scene.flat_line(outline, gid=gid, linewidth=width, color=stroke.colour, linestyle=linestyle, zorder=4.4)
    U, sizes, _ = np.linalg.svd(B, full_matrices=False)
    for k in range(len(sizes)):
        pair = [j for j in range(len(sizes)) if j != k]
        if len(pair) == 2 and not flat:
            section = _turn() @ (U[:, pair] * sizes[pair]).T
            scene.line(centre + size * section, color=stroke.colour, linewidth=0.4, alpha=0.8, zorder=4.3)


def _turn() -> np.ndarray:
    angles = np.linspace(0, 2 * np.pi, _POINTS + 1)
    return np.stack([np.cos(angles), np.sin(angles)], axis=1)


def _outline(flat: np.ndarray) -> np.ndarray:
    """Return the edge of the image of the unit ball under a matrix (2, k), (N, 2)."""
    U, sizes, _ = np.linalg.svd(flat, full_matrices=False)
    return np.asarray(_turn()[:, : len(sizes)] @ (U * sizes).T)


def _narrow(points: np.ndarray) -> np.ndarray:
    """Return the unit vector across which points (N, 2) about (0, 0) are the least wide."""
    _, _, Vt = np.linalg.svd(points, full_matrices=False)
    return np.asarray(Vt[-1])
