"""Dimensions: lengths between two points with extension lines, and angles as arcs."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from armproof.course.figures.drawing.ink import Ink
from armproof.course.figures.drawing.labels import form_tex
from armproof.course.figures.drawing.scene import Scene
from armproof.course.figures.drawing.style import GREY, INK
from armproof.course.figures.facts.lengths import FrameLength

_OFFSETS = (6.0, 8.5, 11.0, 14.0, 17.0)  # mm from what is dimensioned
_OVERSHOOT = 1.0
_INVISIBLE = 2.0  # mm: what is shorter on the paper is not dimensioned
_THIN = 0.5
_SHORTEST = 5.0  # mm: a shorter dimension has its arrows outside
_ARC = 48


def draw_lengths(scene: Scene, lengths: Sequence[FrameLength], lang: str) -> None:
    """Dimension lengths, each beside its way where the page is emptiest; gid "length 1 2"."""
    ink = Ink(scene.axes.figure)
    for each in lengths:
        text = f"${form_tex(each.form, lang)}$"
        draw_length(scene, np.array([each.start, each.end]), text, f"length {each.previous} {each.frame}", ink)


def draw_length(scene: Scene, way: np.ndarray, text: str, gid: str, ink: Ink | None = None) -> None:
    """Dimension a way (2, 3) between two points, beside it where the page is emptiest; ink: what is on it, if known."""
    ink = ink or Ink(scene.axes.figure)
    ends = scene.paper(way)
    way = ends[1] - ends[0]
    size = float(np.linalg.norm(way))
    if size < scene.metres(_INVISIBLE):
        return
    across = np.array([-way[1], way[0]]) / size
    shift = _emptiest(scene, ink, ends, across)
    line = ends + shift
    for foot, top in zip(ends, line, strict=True):
        beyond = top + scene.metres(_OVERSHOOT) * shift / np.linalg.norm(shift)
        scene.flat_line(np.array([foot + 0.15 * shift, beyond]), color=GREY, linewidth=0.35, zorder=1.5)
    _double_arrow(scene, line, gid)
    also = [line[0] + part * (line[1] - line[0]) for part in (0.3, 0.7)]
    scene.label(text, line.mean(axis=0), shift, gap=0.5, also=also)
    ink.mark(scene.axes.transData.transform(line))


def _double_arrow(scene: Scene, line: np.ndarray, gid: str) -> None:
    way = (line[1] - line[0]) / np.linalg.norm(line[1] - line[0])
    outside = float(np.linalg.norm(line[1] - line[0])) < scene.metres(_SHORTEST)
    tail = scene.metres(3.5) * way
    drawn = np.vstack([line[:1] - tail, line[1:] + tail]) if outside else line
    scene.flat_line(drawn, color=GREY, linewidth=_THIN, zorder=1.6)
    scene.flat_line(line, color=GREY, linewidth=_THIN, zorder=1.6, gid=gid)
    for tip, sign in zip(line, (-1, 1), strict=True):
        _tip(scene, tip, -sign * way if outside else sign * way, GREY)


def _tip(scene: Scene, tip: np.ndarray, way: np.ndarray, colour: str) -> None:
    """Draw the head of an arrow that ends in a point and comes along a unit vector."""
    across = np.array([-way[1], way[0]])
    back = tip - scene.metres(1.5) * way
    corners = np.array([tip, back + scene.metres(0.4) * across, back - scene.metres(0.4) * across])
    scene.fill(corners, zorder=6.5, facecolor=colour, edgecolor="none", linewidth=0)


def _emptiest(scene: Scene, ink: Ink, ends: np.ndarray, across: np.ndarray) -> np.ndarray:
    """Return how a dimension is best moved aside: over as little ink as may be, not far."""
    pixels = scene.axes.transData
    shifts = [sign * scene.metres(offset) * across for offset in _OFFSETS for sign in (1, -1)]
    costs = [
        ink.along(pixels.transform(ends + shift)) + 0.6 * np.linalg.norm(shift) / scene.metres(1.0) for shift in shifts
    ]
    return shifts[int(np.argmin(costs))]


def draw_angle(
    scene: Scene, centre: np.ndarray, start: np.ndarray, axis: np.ndarray, angle: float, text: str,
    *, radius: float, ray: bool = True, gid: str = "", colour: str = INK,
) -> None:  # fmt: skip
    """Draw the arc that turns one unit vector about another by an angle (rad), an arrow at its end.

    Args:
        radius: mm.
        ray: whether the side from which the angle is measured is drawn as a dashed line.
    """
    turned = np.linspace(0, angle, _ARC)
    across = np.cross(axis, start)
    arc = centre + scene.metres(radius) * (np.cos(turned)[:, None] * start + np.sin(turned)[:, None] * across)
    if ray:
        side = np.array([centre, centre + scene.metres(radius + 2.0) * start])
        scene.line(side, color=GREY, linewidth=_THIN, linestyle=(0, (4, 2)), zorder=1.7)
    flat = scene.paper(arc)
    scene.flat_line(flat, color=colour, linewidth=0.7, gid=gid, zorder=5)
    last = flat[-1] - flat[-2]
    if np.linalg.norm(last) > scene.metres(0.01):
        _tip(scene, flat[-1], last / np.linalg.norm(last), colour)
    middle = flat[_ARC // 2]
    scene.label(text, middle, middle - scene.paper(centre), gap=0.4, colour=colour, also=list(flat[4:-4:8]))


def draw_turn(scene: Scene, centre: np.ndarray, axis: np.ndarray, text: str, *, gid: str = "") -> None:
    """Draw the sense in which a joint turns: most of a circle about its axis, open at the back, with an arrow."""
    away = -scene.projection.toward - (-scene.projection.toward @ axis) * axis
    start = away / np.linalg.norm(away) if np.linalg.norm(away) > 1e-6 else scene.projection.right
    cosine, sine = np.cos(np.radians(55)), np.sin(np.radians(55))
    first = cosine * start + sine * np.cross(axis, start)
    draw_angle(scene, centre, first, axis, np.radians(250), text, radius=4.0, ray=False, gid=gid)
