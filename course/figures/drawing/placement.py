"""Labels that never overlap: each is measured, and put where neither another label nor ink is on the page.

The figure is drawn once without the labels; what ink it left is summed up in a table, so that the ink below any box is
known at once. Each label is then tried around its anchor, near before far, and joined to it by a thin line if it had to
go away. Labels placed first are moved again once all are there.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.text import Text
from matplotlib.transforms import Bbox

from armproof.course.figures.drawing.ink import Ink, shown_texts
from armproof.course.figures.drawing.style import GREY, INK, PAPER, TEXT

_DISTANCES = (0.0, 1.5, 3.0, 5.0, 8.0, 12.0, 17.0, 24.0, 32.0, 42.0, 55.0, 70.0)  # pt beyond the gap
_DIRECTIONS = 24
_PADDING = 1.0  # pt, kept free around a label
_LEADER = 7.0  # pt: a label farther from its anchor has a line to it
_ROUNDS = 3
_HOPELESS = 1e6
LEADER = "leader"  # gid of the lines
ZORDER = 20


@dataclass(frozen=True)
class Label:
    """A text that belongs to a point.

    Attributes:
        axes, at: the point, in data coordinates of the axes.
        toward: the side of the point on which the label is best, as a vector on the paper; (0, 0) for any.
        gap: pt, kept between the point and the label.
        also: more points that the label may stand at, as along an arc.
    """

    axes: Axes
    text: str
    at: tuple[float, float]
    toward: tuple[float, float] = (0.0, 0.0)
    size: float = TEXT
    colour: str = INK
    gap: float = 2.0
    also: tuple[tuple[float, float], ...] = ()


def place_labels(figure: Figure, labels: Sequence[Label]) -> tuple[Text, ...]:
    """Write labels on a figure that is otherwise finished; returns their texts in order."""
    page = Ink(figure)
    renderer = figure.canvas.get_renderer()
    taken = [text.get_window_extent(renderer).extents for text in shown_texts(figure)]
    texts = [_write(label) for label in labels]
    spots = [_Spot(label, page, text.get_window_extent(renderer)) for label, text in zip(labels, texts, strict=True)]
    for spot in spots:
        spot.keep_off(taken)
    for _ in range(_ROUNDS):
        moved = [spot.move([other for other in spots if other is not spot]) for spot in spots]
        if not any(moved):
            break
    for label, text, spot in zip(labels, texts, spots, strict=True):
        _put(label, text, spot)
    return tuple(texts)


def _write(label: Label) -> Text:
    return label.axes.text(
        *label.at, label.text, ha="center", va="center", fontsize=label.size, color=label.colour, zorder=ZORDER
    )


def _put(label: Label, text: Text, spot: _Spot) -> None:
    to_data = label.axes.transData.inverted()
    text.set_position(tuple(to_data.transform(spot.centre)))
    if spot.ink > 0:
        text.set_bbox({"facecolor": PAPER, "edgecolor": "none", "pad": 0.4, "alpha": 0.8})
    if spot.distance > _LEADER:
        ends = to_data.transform(spot.leader())
        line = Line2D(ends[:, 0], ends[:, 1], color=GREY, linewidth=0.4, zorder=ZORDER - 1, gid=LEADER, clip_on=False)
        label.axes.add_line(line)


class _Spot:
    """Where a label may go, and where it is."""

    def __init__(self, label: Label, page: Ink, extent: Bbox) -> None:
        self.half = np.array([extent.width, extent.height]) / 2
        anchors = label.axes.transData.transform([label.at, *label.also])
        self.page = page
        tried = len(_DISTANCES) * _DIRECTIONS
        distances = np.tile(np.repeat(np.array(_DISTANCES), _DIRECTIONS), len(anchors))
        angles = np.tile(2 * np.pi * np.arange(_DIRECTIONS) / _DIRECTIONS, len(_DISTANCES) * len(anchors))
        ways = np.stack([np.cos(angles), np.sin(angles)], axis=1)
        away = (label.gap + distances)[:, None] * page.scale
        self.anchors = np.repeat(anchors, tried, axis=0)
        self.centres = self.anchors + ways * away + _reach(ways, self.half)
        padded = self.half + _PADDING * page.scale
        self.boxes = np.hstack([self.centres - padded, self.centres + padded])
        self.costs = self._costs(label, distances, ways)
        self.distances = distances + label.gap
        self.place = -1

    def _costs(self, label: Label, distances: np.ndarray, ways: np.ndarray) -> np.ndarray:
        """Return what each place costs by itself: ink below the label, distance, the wrong side, the page left."""
        toward = np.asarray(label.toward, dtype=float)
        size = float(np.linalg.norm(toward))
        wrong_side = (1 - ways @ toward / size) if size else np.zeros(len(ways))
        ink = self.page.in_boxes(self.boxes) / self.page.scale**2
        return 1.2 * ink + 0.8 * distances + 5.0 * wrong_side + _HOPELESS * self.page.outside(self.boxes)

    def keep_off(self, boxes: Sequence[np.ndarray]) -> None:
        """Give up the places that lie on boxes, (4,) each."""
        for box in boxes:
            self.costs += np.where(_overlap(self.boxes, box), _HOPELESS, 0.0)

    def move(self, others: Sequence[_Spot]) -> bool:
        """Go to the best place that the other labels leave; returns whether that is a new one."""
        costs = self.costs.copy()
        for other in others:
            if other.place >= 0:
                costs += np.where(_overlap(self.boxes, other.boxes[other.place]), _HOPELESS, 0.0)
        best = int(np.argmin(costs))
        moved, self.place = best != self.place, best
        return moved

    @property
    def centre(self) -> np.ndarray:
        return np.asarray(self.centres[self.place])

    @property
    def distance(self) -> float:
        return float(self.distances[self.place])

    @property
    def ink(self) -> float:
        return float(self.page.in_boxes(self.boxes[self.place : self.place + 1])[0])

    def leader(self) -> np.ndarray:
        """Return the ends of the line from the anchor to the edge of the label, (2, 2)."""
        anchor = self.anchors[self.place]
        way = self.centre - anchor
        part = min(1.0, float(np.min(self.half / np.maximum(np.abs(way), 1e-9))))
        return np.array([anchor, self.centre - part * way])


def _reach(ways: np.ndarray, half: np.ndarray) -> np.ndarray:
    """Return how far the centre of a box lies beyond the point of its edge that is nearest to the anchor, (N, 2)."""
    return np.clip(ways * half.max() * 1.5, -half, half)


def _overlap(boxes: np.ndarray, box: np.ndarray) -> np.ndarray:
    return (boxes[:, 0] < box[2]) & (box[0] < boxes[:, 2]) & (boxes[:, 1] < box[3]) & (box[1] < boxes[:, 3])
