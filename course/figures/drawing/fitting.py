"""How large an arm is drawn: it is seen whole, with its symbols, whose size on the paper does not depend on the scale."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from matplotlib.figure import Figure

from armproof.course.figures.drawing.layout import lay_out
from armproof.course.figures.drawing.scene import Scene, View
from armproof.course.figures.drawing.style import Box
from armproof.models.arm import Arm
from armproof.models.showing.projection import Projection, choose_projection

SPACING = 8.0  # mm between symbols of joints that would fall upon each other
_ROUNDS = 8  # symbols moved apart need room, which changes the scale
_SETTLED = 2e-3


@dataclass(frozen=True, eq=False)
class Fit:
    """What is to be seen whole on a piece of paper.

    Attributes:
        arm, configurations: the arm, and where it is, (N, n).
        projection: the arm's own if not given.
        points: (M, 3) more points to be seen.
        margin: mm, for frames and labels.
        size: of the symbols, as in `Look`.
    """

    arm: Arm
    configurations: np.ndarray
    projection: Projection | None = None
    points: np.ndarray | None = None
    margin: float = 10.0
    size: float = 1.0

    def view(self, width: float, height: float) -> View:
        """Return the view in which all of it is as large as may be on paper (mm)."""
        projection = self.projection or choose_projection(self.arm)
        more = np.empty((0, 3)) if self.points is None else self.points
        room = np.maximum(np.array([width, height]) - 2 * self.margin, 1.0)
        spacing, before = 0.0, 0.0
        for _ in range(_ROUNDS):
            seen = projection.points(np.vstack([drawn_points(self.arm, self.configurations, spacing), more]))
            low, high = seen.min(axis=0), seen.max(axis=0)
            view = View(projection, (low + high) / 2, float(max(np.max((high - low) / room), 1e-6)))
            if abs(view.metre - before) < _SETTLED * view.metre:
                break
            before, spacing = view.metre, view.metre * SPACING * self.size
        return view

    def scene(self, figure: Figure, box: Box) -> Scene:
        """Return a scene of it in a box of the page."""
        return Scene.show(figure, box, self.view(*box[2:]))

    def height(self, width: float, bounds: tuple[float, float], longest: float = np.inf) -> float:
        """Return the height in mm that it takes where it is as wide as the paper, between bounds.

        Args:
            longest: mm, what the longest link may measure: a short arm is not blown up.
        """
        view = self.view(width, bounds[1])
        points = drawn_points(self.arm, self.configurations, view.metre * SPACING * self.size)
        inner = float(np.ptp(view.projection.points(points)[:, 1])) / view.metre
        links = [link for q in np.atleast_2d(self.configurations) for link in lay_out(self.arm, q, 0.0).links]
        steps = [np.linalg.norm(np.diff(view.projection.points(link), axis=0), axis=1).max() for link in links]
        shrunk = min(1.0, longest / max(float(max(steps)) / view.metre, 1e-9))
        return min(max(inner * shrunk + 2 * self.margin, bounds[0]), bounds[1])


def drawn_points(arm: Arm, configurations: np.ndarray, spacing: float = 0.0) -> np.ndarray:
    """Return the points of an arm at configurations (N, n): base, links, gripper, tool, (M, 3); spacing as for `lay_out`."""
    layouts = [lay_out(arm, q, spacing) for q in np.atleast_2d(configurations)]
    return np.vstack([np.vstack([layout.base, layout.tool, layout.gripper, *layout.links]) for layout in layouts])
