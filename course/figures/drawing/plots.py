"""Ordinary plots: axes with ticks in the language of the figure."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, MaxNLocator, MultipleLocator

from armproof.course.figures.drawing.labels import number
from armproof.course.figures.drawing.placement import Label
from armproof.course.figures.drawing.style import PALE, SMALL, Box, Stroke, mm_axes

_ANGLE_STEPS = (1, 2, 5, 10, 15, 30, 45, 60, 90, 180)  # degrees between ticks


def plot_axes(
    figure: Figure, box: Box, lang: str, x: str = "", y: str = "", *, title: str = "", grid: bool = True
) -> Axes:
    """Return axes for a plot, open above and to the right.

    Args:
        box: the area within the axes.
        x, y: their labels; without a label for x the ticks have no numbers.
    """
    axes = mm_axes(figure, *box)
    axes.spines[["top", "right"]].set_visible(False)
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_formatter(tick_numbers(lang))
    axes.xaxis.set_major_locator(MaxNLocator(6, steps=[1, 2, 2.5, 5, 10]))
    axes.yaxis.set_major_locator(MaxNLocator(4, steps=[1, 2, 2.5, 5, 10]))
    axes.set_xlabel(x, labelpad=2)
    axes.set_ylabel(y, labelpad=3)
    axes.tick_params(labelbottom=bool(x), pad=2)
    if title:
        axes.set_title(title, loc="left", pad=2, fontsize=SMALL)
    if grid:
        axes.grid(color=PALE, linewidth=0.4)
    return axes


def axes_by_unit(axes: Axes, labels: Mapping[str, str], lang: str) -> dict[str, Axes]:
    """Return the axes of each kind of curve by its label: what has another unit has its own axis, on the right."""
    first, *others = dict.fromkeys(labels.values())
    axes.set_ylabel(first, labelpad=3)
    found = {first: axes}
    for label in others:  # two units at most: of angles, and of lengths
        found[label] = axes.twinx()
        found[label].spines[["top", "left"]].set_visible(False)
        found[label].yaxis.set_major_formatter(tick_numbers(lang))
        found[label].yaxis.set_major_locator(MaxNLocator(4, steps=[1, 2, 2.5, 5, 10]))
        found[label].set_ylabel(label, labelpad=3)
        found[label].tick_params(pad=2)
    return {kind: found[label] for kind, label in labels.items()}


def at_peak(axes: Axes, text: str, x: np.ndarray, y: np.ndarray, stroke: Stroke, beside: float = 0.0) -> Label:
    """Return a label for the point of a curve that is farthest from zero, beyond it; `beside` moves it along x."""
    at = int(np.argmax(np.abs(y)))
    return Label(axes, text, (x[at], y[at]), (beside, float(np.sign(y[at]))), SMALL, stroke.colour)


def tick_numbers(lang: str) -> FuncFormatter:
    """Return what writes the numbers of ticks in a language."""
    return FuncFormatter(lambda value, _: number(round(value, 12), lang, 6))


def mark_angles(axes: Axes, which: str, spread: float, most: int = 6) -> None:
    """Put the ticks of an axis in degrees at round angles.

    Args:
        which: x or y.
        spread: how many degrees the axis shows.
        most: ticks, about.
    """
    step = next((step for step in _ANGLE_STEPS if spread / step <= most), _ANGLE_STEPS[-1])
    axis = axes.xaxis if which == "x" else axes.yaxis
    axis.set_major_locator(MultipleLocator(step))
