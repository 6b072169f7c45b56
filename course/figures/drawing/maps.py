"""Maps of the manipulability: colours, level lines and the scale beside them; its unit."""

from __future__ import annotations

import re
from collections.abc import Sequence
from functools import lru_cache
from typing import Any

import matplotlib
import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import ListedColormap
from matplotlib.figure import Figure
from matplotlib.patheffects import Normal
from matplotlib.patheffects import Stroke as Outline
from matplotlib.ticker import MaxNLocator

from armproof.course.figures.drawing.plots import tick_numbers
from armproof.course.figures.drawing.style import INK, MAP, PAPER, STROKES, Box, mm_axes

_LIGHTEST_OF_DARK = 0.28  # of the colours: darker ones leave labels unreadable
LEVELS = 6


@lru_cache(maxsize=1)
def map_colours() -> ListedColormap:
    """Return the colours of the maps, from dark (singular) to light."""
    return ListedColormap(matplotlib.colormaps[MAP](np.linspace(_LIGHTEST_OF_DARK, 1, 256)))


def draw_map(
    figure: Figure, axes: Axes, box: Box, x: np.ndarray, y: np.ndarray, values: np.ndarray, highest: float, label: str,
    lang: str, gid: str, *, extent: Sequence[float] | np.ndarray | None = None, lined: np.ndarray | None = None,
) -> None:  # fmt: skip
    """Draw values (len(y), len(x)) in colours with level lines, and their scale in a box; NaN where there are none.

    Args:
        highest: of all values, the end of the scale.
        extent: the edges left, right, bottom, top of the picture; by default the ends of x and y.
        lined: the values of the level lines, if they are others.
    """
    edges = (x[0], x[-1], y[0], y[-1]) if extent is None else tuple(extent)
    shown = {"origin": "lower", "aspect": "auto", "interpolation": "nearest", "zorder": 0, "gid": gid}
    axes.imshow(values, cmap=map_colours(), vmin=0, vmax=highest, extent=edges, **shown)
    levels = levels_up_to(highest)
    if len(levels):
        heights = np.ma.masked_invalid(values if lined is None else lined)
        axes.contour(x, y, heights, levels=levels, colors=INK, linewidths=0.35, alpha=0.7).set_gid("levels")
    _draw_scale(figure, box, highest, levels, label, lang)


def curve_style(k: int) -> dict[str, Any]:
    """Return how the k-th curve on a map is drawn: first in the colour that the map has not."""
    return {**STROKES[(1, 0, 3, 2, 4, 5, 6, 7)[k % len(STROKES)]].line, "path_effects": halo(), "zorder": 5}


def levels_up_to(highest: float) -> np.ndarray:
    """Return some round levels between 0 and the highest value, without 0."""
    levels = np.asarray(MaxNLocator(LEVELS, steps=[1, 2, 2.5, 5, 10]).tick_values(0.0, highest))
    return levels[(levels > 0) & (levels < highest)]


def _draw_scale(figure: Figure, box: Box, highest: float, levels: np.ndarray, label: str, lang: str) -> None:
    """Draw the scale of a map: its colours from 0 to the highest value, with ticks at the levels."""
    axes, shades = mm_axes(figure, *box), np.linspace(0, 1, 256)[:, None]
    axes.imshow(shades, cmap=map_colours(), aspect="auto", origin="lower", extent=(0, 1, 0, highest))
    axes.set_xticks([])
    axes.yaxis.tick_right()
    axes.set_yticks([0.0, *levels])
    axes.yaxis.set_major_formatter(tick_numbers(lang))
    axes.yaxis.set_label_position("right")
    axes.set_ylabel(label, labelpad=3)
    for level in levels:
        axes.axhline(level, color=INK, linewidth=0.35, alpha=0.7)


def smooth(values: np.ndarray) -> np.ndarray:
    """Return a map with each value the mean of the 5 × 5 around it that are numbers, NaN where it was none: for level lines only."""
    padded = np.pad(values, 2, constant_values=np.nan)
    around = np.lib.stride_tricks.sliding_window_view(padded, (5, 5))
    count = np.maximum(np.sum(~np.isnan(around), axis=(2, 3)), 1)
    return np.where(np.isnan(values), np.nan, np.nansum(around, axis=(2, 3)) / count)


def halo() -> list[Any]:
    """Return the effects that set a line off from the map below it: paper around it."""
    return [Outline(linewidth=2.4, foreground=PAPER, alpha=0.9), Normal()]


def plain_condition(latex: str) -> str:
    r"""Return a condition as matplotlib's mathematics reads it, and small: without \text, \frac{\pi}{2} as \pi/2."""
    return re.sub(r"\\frac\{([^{}]+)\}\{([^{}]+)\}", r"\1/\2", latex.replace(r"\text{ and }", r",\;"))
