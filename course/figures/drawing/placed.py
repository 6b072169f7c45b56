"""An arm with the axes of its joints and letters at its points, and on it the frames that somebody has placed."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import pairwise
from typing import Any

import numpy as np
from matplotlib.figure import Figure

from armproof.course.figures.drawing.dimensions import draw_lengths
from armproof.course.figures.drawing.fitting import Fit
from armproof.course.figures.drawing.scene import Scene, finish
from armproof.course.figures.drawing.style import GREY, INK, WIDTHS, new_figure, styled
from armproof.course.figures.drawing.symbols import AXIS_COLOURS, draw_arm, draw_frames
from armproof.course.figures.drawing.table import dh_texts, draw_table, table_height
from armproof.course.figures.facts.dh_rows import LinkRows
from armproof.course.figures.facts.lengths import FrameLength
from armproof.course.figures.facts.placing import Scheme, difference, places
from armproof.models.dh.entry import LinearForm

_HEIGHTS = (52.0, 125.0)  # mm
_LONGEST = 50.0  # mm, of a link
_BEYOND = 13.0  # mm that an axis is drawn beyond the symbol of its joint
_CORNER = 8.0  # mm from the corner to the directions of the drawing
_ARROW = 7.0  # mm


@styled()
def draw_scheme(
    scheme: Scheme,
    lang: str = "",
    frames: Mapping[str, np.ndarray] | None = None,
    rows: LinkRows | None = None,
    letters: str = "xz",
) -> Figure:
    """Return the drawing of an arm, with frames that are placed on it, each a pose (4, 4), and the table below."""
    arm = scheme.arm
    q, lengths = np.zeros(len(arm.joints)), dict(arm.lengths)
    table = dh_texts(rows, lang) if rows else []
    below = table_height(len(table)) + 3.0 if table else 0.0
    points = places(list(scheme.points.values()), lengths)
    fit = Fit(arm, q, points=points, margin=18.0)
    height = fit.height(WIDTHS["column"], _HEIGHTS, _LONGEST)
    figure = new_figure("column", height + below)
    scene = fit.scene(figure, (0.0, below, WIDTHS["column"], height))
    layout = draw_arm(scene, arm, q)
    _draw_axes(scene, layout.spots, scheme.axes(lengths)[1])
    _draw_directions(scene)
    _draw_points(scene, scheme, points)
    draw_frames(scene, frames or {}, letters)
    if table:
        draw_table(figure, table, left=0.0, top=below - 1.0, width=WIDTHS["column"])
    else:
        draw_lengths(scene, _lengths(scheme, points), lang)
    return finish(figure, scene)


def _draw_axes(scene: Scene, spots: np.ndarray, ways: np.ndarray) -> None:
    """Draw the axis of each joint, with the number of the joint; axes on one line share it."""
    lines: dict[tuple[float, ...], list[int]] = {}
    for k, (spot, way) in enumerate(zip(spots, ways, strict=True)):
        sense = way if way[np.argmax(np.abs(np.round(way, 6)))] > 0 else -way
        foot = spot - (spot @ sense) * sense
        lines.setdefault(tuple(np.round([*foot, *sense], 6) + 0.0), []).append(k)
    for line, joints in lines.items():
        sense, on = np.array(line[3:]), spots[joints] @ np.array(line[3:])
        ends = np.array(line[:3]) + np.outer([on.min(), on.max()], sense)
        ends = ends + scene.metres(_BEYOND) * np.array([-sense, sense])
        style: dict[str, Any] = {"color": GREY, "linewidth": 0.6, "linestyle": (0, (8, 2, 1.5, 2)), "zorder": 1.2}
        scene.line(ends, gid=f"axis {joints[0] + 1}", **style)
        text = ", ".join(str(k + 1) for k in joints)
        scene.label(text, ends[1], sense, colour=GREY, gap=1.5)


def _draw_directions(scene: Scene) -> None:
    """Draw the directions x, y, z of the drawing in its lower left corner."""
    (left, _), (low, _) = scene.axes.get_xlim(), scene.axes.get_ylim()
    projection = scene.projection
    corner = np.array([left, low]) + scene.metres(_CORNER)
    at = corner[0] * projection.right + corner[1] * projection.up
    for letter, way in zip("xyz", np.eye(3), strict=True):
        tip = scene.arrow(at, scene.metres(_ARROW) * way, colour=AXIS_COLOURS[letter], gid=f"direction {letter}")
        scene.label(f"${letter}$", tip, scene.paper(way), colour=AXIS_COLOURS[letter], gap=0.4)


def _draw_points(scene: Scene, scheme: Scheme, points: np.ndarray) -> None:
    for letter, point in zip(scheme.points, points, strict=True):
        scene.circle(scene.paper(point), 0.6, zorder=9, facecolor=INK)
        scene.label(letter, point, (-1.0, 1.0), gap=1.0)


def _lengths(scheme: Scheme, points: np.ndarray) -> list[FrameLength]:
    """Return the lengths from each marked point to the next, along the one direction in which they differ."""
    found = []
    for (k, (before, start)), (j, (after, end)) in pairwise(enumerate(scheme.points.items())):
        ways = [way for way in difference(end, start) if way != LinearForm()]
        if len(ways) == 1:
            found.append(FrameLength(before, after, points[k], points[j], _positive(ways[0])))
    return found


def _positive(form: LinearForm) -> LinearForm:
    """Return a length as a dimension has it, without a sign."""
    return LinearForm(tuple((symbol, abs(factor)) for symbol, factor in form.symbols), number=abs(form.number))
