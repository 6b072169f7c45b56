"""How large an arm is drawn: it is seen whole, with its symbols, whose size on the paper does not depend on the scale."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from armproof.course.figures.drawing.layout import lay_out
from armproof.course.figures.drawing.scene import Scene, View, fit_view
from armproof.models.arm import Arm
from armproof.models.showing.projection import Projection, choose_projection

SPACING = 8.0  # mm between symbols of joints that would fall upon each other
_ROUNDS = 8  # symbols moved apart need room, which changes the scale
_SETTLED = 2e-3


def fit_arm(
    figure: Figure,
    box: tuple[float, float, float, float],
    arm: Arm,
    configurations: np.ndarray,
    *,
    projection: Projection | None = None,
    points: np.ndarray | None = None,
    margin: float = 10.0,
    size: float = 1.0,
) -> Scene:
    """Return a scene in a box (left, bottom, width, height in mm) of the page; the rest as for `arm_view`."""
    room = (box[2], box[3])
    view = arm_view(arm, configurations, room, projection=projection, points=points, margin=margin, size=size)
    return Scene.show(figure, box, view)


def arm_view(
    arm: Arm,
    configurations: np.ndarray,
    room: tuple[float, float],
    *,
    projection: Projection | None = None,
    points: np.ndarray | None = None,
    margin: float = 10.0,
    size: float = 1.0,
) -> View:
    """Return the view in which an arm is seen whole at configurations (N, n).

    Args:
        room: the width and height of the paper (mm).
        projection: the arm's own if not given.
        points: (M, 3) more points to be seen.
        margin: mm, for frames and labels.
        size: of the symbols, as in `Look`.
    """
    projection = projection or choose_projection(arm)
    more = np.empty((0, 3)) if points is None else points
    spacing, before = 0.0, 0.0
    for _ in range(_ROUNDS):
        view = fit_view(projection, np.vstack([drawn_points(arm, configurations, spacing), more]), room, margin)
        if abs(view.metre - before) < _SETTLED * view.metre:
            break
        before, spacing = view.metre, view.metre * SPACING * size
    return view


def drawn_points(arm: Arm, configurations: np.ndarray, spacing: float = 0.0) -> np.ndarray:
    """Return the points of an arm at configurations (N, n), for `Scene.fit`: base, links, gripper, tool, (M, 3).

    Args:
        spacing: as for `lay_out`.
    """
    layouts = [lay_out(arm, q, spacing) for q in np.atleast_2d(configurations)]
    return np.vstack([np.vstack([layout.base, layout.tool, layout.gripper, *layout.links]) for layout in layouts])


def arm_height(
    arm: Arm,
    configurations: np.ndarray,
    width: float,
    bounds: tuple[float, float],
    *,
    projection: Projection | None = None,
    margin: float = 10.0,
    size: float = 1.0,
    longest: float = np.inf,
) -> float:
    """Return the height in mm that an arm takes where it is as wide as the paper, between bounds; see `arm_view`.

    Args:
        longest: mm, what the longest link may measure: a short arm is not blown up.
    """
    view = arm_view(arm, configurations, (width, bounds[1]), projection=projection, margin=margin, size=size)
    points = drawn_points(arm, configurations, view.metre * SPACING * size)
    inner = float(np.ptp(view.projection.points(points)[:, 1])) / view.metre
    links = [link for q in np.atleast_2d(configurations) for link in lay_out(arm, q, 0.0).links]
    steps = [np.linalg.norm(np.diff(view.projection.points(link), axis=0), axis=1).max() for link in links]
    shrunk = min(1.0, longest / max(float(max(steps)) / view.metre, 1e-9))
    return min(max(inner * shrunk + 2 * margin, bounds[0]), bounds[1])
