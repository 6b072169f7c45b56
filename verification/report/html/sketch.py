"""A line drawing of an arm as SVG: links, joints and frames; what is claimed beside what is true.

The drawing knows points and poses only, no model. Everything is told apart by line and word, not by colour alone; the
page's style sheet colours the classes.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cache
from html import escape
from importlib import resources

import numpy as np

from armproof.models.showing.projection import Projection

WIDTH, HEIGHT = 330.0, 250.0
BESIDE, ABOVE = 50.0, 26.0  # room for the labels
_SUBSCRIPTS = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")

Point = Sequence[float] | np.ndarray


@dataclass
class Sketch:
    """Collects shapes in metres of frame 0, then fits them to the picture and writes it.

    Attributes:
        projection: from where it is seen.
        triad: the length of a frame's axes (m).
        window: the least and the greatest of what is seen (m), (2, 2), where that is not to follow the shapes.
    """

    projection: Projection
    triad: float
    window: np.ndarray | None = None
    shapes: list[tuple[str, list[tuple[float, float]], str, str]] = field(default_factory=list)

    def line(self, points: Sequence[Point] | np.ndarray, kind: str) -> None:
        """Draw a polyline."""
        self.shapes.append(("line", [self._project(point) for point in points], kind, ""))

    def outline(self, point: Point, around: np.ndarray, kind: str) -> None:
        """Draw a closed line (K, 2) of the paper around a point."""
        x, y = self._project(point)
        self.shapes.append(("line", [(x + float(u), y + float(v)) for u, v in around], kind, ""))

    def dot(self, point: Point, kind: str) -> None:
        """Draw a joint or a point: "revolute" round, "prismatic" square."""
        self.shapes.append(("square" if kind == "prismatic" else "dot", [self._project(point)], kind, ""))

    def text(self, point: Point, words: str, kind: str) -> None:
        """Write a short label below a point, on its left."""
        self.shapes.append(("text", [self._project(point)], kind, words))

    def arrow(self, start: Point, end: Point, kind: str, words: str = "") -> None:
        """Draw an arrow with a label at its tip; one that points at the viewer is a dot."""
        a, b = self._project(start), self._project(end)
        self.shapes.append(("arrow", [a, b], kind, words))

    def frame(self, pose: np.ndarray, kind: str, index: str = "") -> None:
        """Draw the axes of a pose, each with its letter."""
        for k, letter in enumerate("xyz"):
            label = f"{letter}{index.translate(_SUBSCRIPTS)}" if index else ""
            tip = pose[:3, 3] + self.triad * pose[:3, k]
            self.arrow(pose[:3, 3], tip, f"{kind} axis-{letter}", label)

    def _project(self, point: Point) -> tuple[float, float]:
        """Return a point's place on the page (m), up counted upwards."""
        right, up = self.projection.points(np.asarray(point, dtype=float))
        return float(right), float(up)

    # -- writing -----------------------------------------------------------------------------------------------------

    def write(self, words: str) -> str:
        """Return the picture as SVG; `words` tell it to who cannot see it."""
        fit = self._fit()
        body = "".join(self._shape(*shape, fit) for shape in self.shapes)
        size = f'viewBox="0 0 {WIDTH:.0f} {HEIGHT:.0f}" width="{WIDTH:.0f}" height="{HEIGHT:.0f}"'
        return f'<svg class="sketch" role="img" aria-label="{escape(words)}" {size}>{body}</svg>'

    def _fit(self) -> tuple[float, float, float]:
        """Return the scale and the offsets that bring all shapes into the picture."""
        drawn = [point for _, points, _, _ in self.shapes for point in points] or [(0.0, 0.0)]
        points = np.array(drawn) if self.window is None else self.window
        low, high = points.min(axis=0), points.max(axis=0)
        size = np.maximum(high - low, 1e-9)
        scale = float(min((WIDTH - 2 * BESIDE) / size[0], (HEIGHT - 2 * ABOVE) / size[1]))
        middle = (low + high) / 2
        return scale, WIDTH / 2 - scale * float(middle[0]), HEIGHT / 2 + scale * float(middle[1])

    def _shape(
        self, shape: str, points: list[tuple[float, float]], kind: str, words: str, fit: tuple[float, float, float]
    ) -> str:
        scale, x0, y0 = fit
        placed = [(x0 + scale * x, y0 - scale * y) for x, y in points]
        if shape == "line":
            return f'<polyline class="{kind}" points="{" ".join(f"{x:.1f},{y:.1f}" for x, y in placed)}"/>'
        x, y = placed[0]
        if shape == "dot":
            return f'<circle class="{kind}" cx="{x:.1f}" cy="{y:.1f}" r="5"/>'
        if shape == "square":
            return f'<rect class="{kind}" x="{x - 5:.1f}" y="{y - 5:.1f}" width="10" height="10"/>'
        if shape == "text":
            return f'<text class="{kind}" text-anchor="end" x="{x - 6:.1f}" y="{y + 15:.1f}">{escape(words)}</text>'
        return _arrow(placed[0], placed[1], kind, words)


@cache
def sketch_style() -> str:
    """Return the style of the drawings of an arm, in the colours --ink, --good, --x and so on of whoever shows them."""
    return resources.files(__package__).joinpath("templates", "sketch.css").read_text(encoding="utf-8")


def _arrow(start: tuple[float, float], end: tuple[float, float], kind: str, words: str) -> str:
    (x, y), (u, v) = start, end
    length = float(np.hypot(u - x, v - y))
    if length < 3:  # along the line of sight
        return f'<circle class="{kind} end-on" cx="{x:.1f}" cy="{y:.1f}" r="2.5"/>'
    dx, dy = (u - x) / length, (v - y) / length
    head = min(7.0, length / 2)
    left = (u - head * dx + 0.45 * head * dy, v - head * dy - 0.45 * head * dx)
    right = (u - head * dx - 0.45 * head * dy, v - head * dy + 0.45 * head * dx)
    tip = " ".join(f"{a:.1f},{b:.1f}" for a, b in ((u, v), left, right))
    shaft = f'<line class="{kind}" x1="{x:.1f}" y1="{y:.1f}" x2="{u - head * dx:.1f}" y2="{v - head * dy:.1f}"/>'
    label = ""
    if words:
        anchor = "middle" if abs(dx) < 0.5 else "start" if dx > 0 else "end"
        label = f'<text class="{kind}" text-anchor="{anchor}" x="{u + 7 * dx:.1f}" y="{v + 9 * dy + 4:.1f}">{escape(words)}</text>'
    return f'{shaft}<polygon class="{kind}" points="{tip}"/>{label}'
