"""A drawing in space on a part of the page: axes, a projection, and the scale between metres and millimetres."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Circle, Polygon

from armproof.course.figures.drawing.placement import Label, place_labels
from armproof.course.figures.drawing.style import INK, PAPER, POINT, TEXT, Box, mm_axes
from armproof.models.showing.projection import Projection

_HEAD = (1.9, 0.62)  # mm: length and half width of an arrow's head
_FILLED = {"facecolor": PAPER, "edgecolor": INK, "linewidth": 0.8, "clip_on": False}
_SHORT = 0.9  # mm: an arrow that is shorter on the paper points at the viewer or away


@dataclass(frozen=True, eq=False)
class View:
    """What a scene shows: a projection, the point (2,) in its middle, and metres on the paper a millimetre."""

    projection: Projection
    middle: np.ndarray
    metre: float


@dataclass(eq=False)
class Scene:
    """Axes in which one unit is a metre in the plane of the paper.

    Attributes:
        metre: metres on the paper a millimetre.
        labels: those that `finish` will place.
    """

    axes: Axes
    projection: Projection
    metre: float
    labels: list[Label] = field(default_factory=list)

    @classmethod
    def show(cls, figure: Figure, box: Box, view: View) -> Scene:
        """Return a scene in a box of the page that shows a view, its middle in the middle of the box."""
        axes = mm_axes(figure, *box)
        axes.set_axis_off()
        half = view.metre * np.array(box[2:]) / 2
        axes.set_xlim(view.middle[0] - half[0], view.middle[0] + half[0])
        axes.set_ylim(view.middle[1] - half[1], view.middle[1] + half[1])
        return cls(axes, view.projection, view.metre)

    def metres(self, millimetres: float) -> float:
        """Return the metres that so many millimetres of the paper are."""
        return millimetres * self.metre

    def paper(self, points: np.ndarray | Sequence[float]) -> np.ndarray:
        """Return points (…, 3) of frame 0 as data coordinates (…, 2)."""
        return self.projection.points(np.asarray(points, dtype=float))

    def line(self, points: np.ndarray, *, gid: str = "", zorder: float = 2, **style: Any) -> Line2D:
        """Draw a line through points (N, 3)."""
        return self.flat_line(self.paper(points), gid=gid, zorder=zorder, **style)

    def flat_line(self, points: np.ndarray, *, gid: str = "", zorder: float = 2, **style: Any) -> Line2D:
        """Draw a line through points (N, 2) of the paper."""
        options = {"color": INK, "clip_on": False, "gid": gid or None, **style}
        return self.axes.add_line(Line2D(points[:, 0], points[:, 1], zorder=zorder, **options))

    def fill(self, points: np.ndarray, *, zorder: float = 3, **style: Any) -> Polygon:
        """Fill a polygon (N, 2) of the paper."""
        return self.axes.add_patch(Polygon(points, closed=True, zorder=zorder, **_FILLED | style))

    def circle(self, centre: np.ndarray, radius: float, *, zorder: float = 3, **style: Any) -> Circle:
        """Draw a circle about a point (2,) of the paper; radius in mm."""
        return self.axes.add_patch(Circle(tuple(centre), self.metres(radius), zorder=zorder, **_FILLED | style))

    def arrow(
        self,
        start: np.ndarray,
        vector: np.ndarray,
        *,
        colour: str = INK,
        width: float = 0.9,
        gid: str = "",
        zorder: float = 6,
        double: bool = False,
        **style: Any,
    ) -> np.ndarray:
        """Draw an arrow from a point (3,) along a vector (3,), both in metres; returns its tip on the paper, (2,).

        A vector along the view becomes a dot in a circle (towards the reader) or a cross in it (away). With `double` the
        arrow has two heads, as that of a rotation.
        """
        foot, tip = self.paper(start), self.paper(np.asarray(start) + vector)
        line = self.flat_line(np.array([foot, tip]), gid=gid, zorder=zorder, color=colour, linewidth=width, **style)
        if np.linalg.norm(tip - foot) < self.metres(_SHORT):
            self._point_at_reader(foot, self.projection.along(np.asarray(vector)) > 0, colour, zorder)
            return foot
        self._head(foot, tip, colour, zorder)
        if double:
            back = self.metres(_HEAD[0]) * (tip - foot) / np.linalg.norm(tip - foot)
            self._head(foot, tip - back, colour, zorder)
        line.set_solid_capstyle("butt")
        return tip

    def _head(self, foot: np.ndarray, tip: np.ndarray, colour: str, zorder: float) -> None:
        way = (tip - foot) / np.linalg.norm(tip - foot)
        across = np.array([-way[1], way[0]])
        size = min(1.0, float(np.linalg.norm(tip - foot)) / self.metres(_HEAD[0]))
        back, side = (self.metres(part * size) for part in _HEAD)
        corners = np.array(
            [tip, tip - back * way + side * across, tip - 0.75 * back * way, tip - back * way - side * across]
        )
        self.fill(corners, zorder=zorder + 0.1, facecolor=colour, edgecolor="none", linewidth=0)

    def _point_at_reader(self, at: np.ndarray, towards: bool, colour: str, zorder: float) -> None:
        self.circle(at, 1.15, zorder=zorder, edgecolor=colour, linewidth=0.9)
        if towards:
            self.circle(at, 0.35, zorder=zorder + 0.1, facecolor=colour, edgecolor="none")
            return
        arm = self.metres(1.15 / np.sqrt(2))
        for sign in (1, -1):
            cross = at + np.array([[-arm, -sign * arm], [arm, sign * arm]])
            self.flat_line(cross, zorder=zorder + 0.1, color=colour, linewidth=0.9)

    def label(
        self,
        text: str,
        at: np.ndarray,
        toward: np.ndarray | Sequence[float] = (0.0, 0.0),
        *,
        size: float = TEXT,
        colour: str = INK,
        gap: float = 0.6,
        also: Sequence[np.ndarray] = (),
    ) -> None:
        """Keep a label for a point, (3,) in frame 0 or (2,) on the paper, to be placed at the end.

        Args:
            toward: the side on which it is best, a vector (3,) or (2,).
            gap: mm between the point and the label.
            also: more points (2,) of the paper that it may stand at instead.
        """
        at, toward = (self.paper(v) if len(v) == 3 else np.asarray(v, dtype=float) for v in (at, toward))
        points, way = [(float(x), float(y)) for x, y in (at, *also)], (float(toward[0]), float(toward[1]))
        label = Label(self.axes, text, points[0], way, size, colour, gap / POINT, tuple(points[1:]))
        self.labels.append(label)


def finish(figure: Figure, *scenes: Scene, extra: Sequence[Label] = ()) -> Figure:
    """Place the labels of all scenes of a figure, together with others; nothing is drawn after it."""
    place_labels(figure, [label for scene in scenes for label in scene.labels] + list(extra))
    return figure
