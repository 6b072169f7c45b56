"""What is on a page already: its texts, and the ink of each pixel, with what symbols enclose, so that labels keep off."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.text import Text

_ENCLOSED = 0.25  # ink of a pixel inside a symbol, which may be white
_EDGE = 12  # pixels of the page that a line keeps clear of
_OFF_PAGE = 1e3


class Ink:
    """The ink on a page, in pixels from the lower left corner; drawn once."""

    def __init__(self, figure: Figure) -> None:
        figure.canvas.draw()
        self.scale = figure.dpi / 72  # pixels a pt
        self.darkness = 1 - np.asarray(figure.canvas.buffer_rgba())[::-1, :, :3].mean(axis=2) / 255
        self.height, self.width = self.darkness.shape
        for axes in figure.axes:
            for patch in axes.patches:
                self._enclose(patch.get_window_extent().extents)
        self.sums = np.zeros((self.height + 1, self.width + 1))
        self.sums[1:, 1:] = self.darkness.cumsum(axis=0).cumsum(axis=1)

    def _enclose(self, extents: np.ndarray) -> None:
        left, bottom, right, top = np.round(np.clip(extents, 0, max(self.width, self.height))).astype(int)
        if (right - left) * (top - bottom) < 0.02 * self.width * self.height:  # a symbol, no frame of a plot
            inside = self.darkness[bottom:top, left:right]
            np.maximum(inside, _ENCLOSED, out=inside)

    def in_boxes(self, boxes: np.ndarray) -> np.ndarray:
        """Return the ink in boxes (N, 4) of left, bottom, right, top, (N,)."""
        left, right = (np.clip(np.round(boxes[:, k]).astype(int), 0, self.width) for k in (0, 2))
        bottom, top = (np.clip(np.round(boxes[:, k]).astype(int), 0, self.height) for k in (1, 3))
        sums = self.sums
        return np.asarray(sums[top, right] - sums[bottom, right] - sums[top, left] + sums[bottom, left])

    def outside(self, boxes: np.ndarray) -> np.ndarray:
        """Return which boxes (N, 4) leave the page, (N,)."""
        return np.asarray(
            (boxes[:, :2] < 1).any(axis=1) | (boxes[:, 2:] > (self.width - 1, self.height - 1)).any(axis=1)
        )

    def mark(self, ends: np.ndarray) -> None:
        """Take note of a line between two points (2, 2) that is drawn now."""
        points = np.clip(_pixels(ends), 0, (self.width - 1, self.height - 1))
        self.darkness[points[:, 1], points[:, 0]] = 1.0

    def along(self, ends: np.ndarray) -> float:
        """Return the ink near a line between two points (2, 2), and much where it leaves the page."""
        points = _pixels(ends)
        if points.min() < _EDGE or np.any(points.max(axis=0) >= (self.width - _EDGE, self.height - _EDGE)):
            return _OFF_PAGE
        near = [(dx, dy) for dx in (-2, 0, 2) for dy in (-2, 0, 2)]
        return float(sum(self.darkness[points[:, 1] + dy, points[:, 0] + dx].sum() for dx, dy in near)) / 4


def _pixels(ends: np.ndarray) -> np.ndarray:
    """Return the pixels of a line between two points (2, 2), (N, 2)."""
    steps = np.linspace(0, 1, 2 + int(np.linalg.norm(ends[1] - ends[0])))
    return np.asarray(np.round(ends[0] + steps[:, None] * (ends[1] - ends[0])).astype(int))


def shown_texts(figure: Figure) -> list[Text]:
    """Return the texts of a figure that can be seen."""
    hidden = {id(text) for axes in figure.axes for text in _hidden(axes)}
    texts = (text for text in figure.findobj(Text) if isinstance(text, Text) and id(text) not in hidden)
    return [text for text in texts if text.get_visible() and text.get_text().strip()]


def _hidden(axes: Axes) -> list[Text]:
    """Return the texts of the axes that are not drawn: all of axes that are off, labels of ticks outside the limits."""
    if not axes.get_visible():
        return [text for text in axes.findobj(Text) if isinstance(text, Text)]
    hidden: list[Text] = []
    for axis in (axes.xaxis, axes.yaxis):
        low, high = sorted(axis.get_view_interval())
        margin = 1e-9 * (high - low)
        ticks = zip(axis.get_major_ticks(), axis.get_majorticklocs(), strict=False)
        outside = [tick for tick, place in ticks if not low - margin <= place <= high + margin]
        parts = outside if axes.axison and axis.get_visible() else [axis]
        hidden += [text for part in parts for text in part.findobj(Text) if isinstance(text, Text)]
    return hidden
