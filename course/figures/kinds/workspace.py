"""The workspace of an arm: where its tool, or the centre of its wrist, can be, how well it moves there, where it is singular."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from armproof.course.figures.drawing.labels import axis_label, length, number, say
from armproof.course.figures.drawing.maps import curve_style, draw_map, plain_condition, smooth
from armproof.course.figures.drawing.placement import Label
from armproof.course.figures.drawing.plots import plot_axes
from armproof.course.figures.drawing.scene import Scene, finish
from armproof.course.figures.drawing.style import INK, PAPER, Box, new_figure, styled
from armproof.course.figures.facts.boundary import boundary
from armproof.course.figures.facts.curves import family_curve
from armproof.course.figures.facts.highest import climb
from armproof.course.figures.facts.positioning import Positioning, position_singularities, positioning_of
from armproof.course.figures.facts.task import joint_ranges, volume_unit
from armproof.course.figures.registry import Kind
from armproof.models.arm import Arm
from armproof.models.showing.skeleton import stick_points

CONFIGURATIONS = 1_000_000
_CELLS = 230  # along the longer side of the map
_SEED = 3
_NEARLY = 0.98
_WIDEST, _HIGHEST = 54.0, 60.0  # mm
_LEFT, _BOTTOM, _RIGHT, _TOP = 12.0, 10.0, 18.0, 8.0
_MARGIN = 0.09  # of the longer side, around the workspace


@dataclass(frozen=True, eq=False)
class Workspace:
    """The cells of a map that the point of an arm reaches within the joint limits.

    Attributes:
        positioning: which point, and the plane of the map.
        x, y: the centres of the cells (m).
        best: (len(y), len(x)), the highest manipulability in each cell, NaN where no configuration is.
        winners: (len(y), len(x), n), the configuration of each cell that has it, NaN where none is.
        reach: the smallest and the largest distance from the origin of the map (m).
        highest: the highest manipulability of all (in its unit), at a configuration between those drawn.
        boundary: points (M, 2) along the boundary of what is reached; NaN parts its pieces.
        curves: configurations (M, n) along the image of each singular family that has some, by its LaTeX.
    """

    positioning: Positioning
    x: np.ndarray
    y: np.ndarray
    best: np.ndarray
    winners: np.ndarray
    reach: tuple[float, float]
    highest: float
    boundary: np.ndarray
    curves: dict[str, np.ndarray]


@lru_cache(maxsize=16)
def workspace_of(arm: Arm) -> Workspace:
    """Return the workspace of an arm that has one in a plane, from a million configurations drawn by a fixed generator."""
    positioning = positioning_of(arm)
    assert positioning is not None
    q = np.zeros((CONFIGURATIONS, len(arm.joints)))
    rng = np.random.default_rng(_SEED)
    for column in positioning.free:
        q[:, column - 1] = rng.uniform(*joint_ranges(arm)[column - 1], CONFIGURATIONS)
    points = positioning.projection.points(positioning.points(q))
    low, high = points.min(axis=0), points.max(axis=0)
    cell = float((high - low).max()) / _CELLS
    columns, rows = np.ceil((high - low) / cell).astype(int) + 1
    across, up = ((points - low) / cell).astype(int).T
    w = positioning.manipulability(q)
    order = np.argsort(w)
    winner = np.full(rows * columns, -1)
    winner[(up * columns + across)[order]] = order  # of those in a cell, the one with the highest w is written last
    winner = winner.reshape(rows, columns)
    x, y = (low[k] + cell * (np.arange(count) + 0.5) for k, count in enumerate((columns, rows)))
    distances = np.linalg.norm(points, axis=1)
    analysis = position_singularities(arm)
    curves = {family.latex: family_curve(positioning, family) for family in analysis.families} if analysis else {}
    reached = winner >= 0
    return Workspace(
        positioning, x, y, np.where(reached, w[winner], np.nan), np.where(reached[..., None], q[winner], np.nan),
        (float(distances.min()), float(distances.max())), _highest(positioning, q[order[-1]]),
        boundary(positioning, x, y, reached), {latex: curve for latex, curve in curves.items() if len(curve)},
    )  # fmt: skip


def _highest(positioning: Positioning, q: np.ndarray) -> float:
    """Return the highest manipulability, near the best configuration of those drawn."""
    places = [column - 1 for column in positioning.free]
    axes = [np.linspace(*joint_ranges(positioning.arm)[k], _CELLS) for k in places]
    return climb(positioning.manipulability, q, places, axes)[1]


@styled()
def workspace_figure(arm: Arm, lang: str = "") -> Figure:
    """Return the workspace of an arm in its plane, or in the section that its first joint turns, with its singular curves."""
    found = workspace_of(arm)
    cell = found.x[1] - found.x[0]
    extent = np.array([found.x[0], found.x[-1], found.y[0], found.y[-1]]) + cell / 2 * np.array([-1, 1, -1, 1])
    margin = _MARGIN * max(np.ptp(extent[:2]), np.ptp(extent[2:]))
    window = extent + margin * np.array([-1, 1, -1, 1])
    metre = max(np.ptp(window[:2]) / _WIDEST, np.ptp(window[2:]) / _HIGHEST)  # metres a millimetre
    width, height = np.ptp(window[:2]) / metre, np.ptp(window[2:]) / metre
    figure = new_figure("column", height + _BOTTOM + _TOP)
    names = ("x_0", "y_0") if abs(found.positioning.projection.toward[2]) > 0.9 else ("x_0", "z_0")
    box = (_LEFT + (_WIDEST - width) / 2, _BOTTOM, width, height)
    axes = plot_axes(figure, box, lang, axis_label("", "m", names[0]), axis_label("", "m", names[1]), grid=False)
    axes.set(xlim=window[:2], ylim=window[2:])
    _draw_map(figure, axes, box, found, extent, lang)
    axes.plot(*found.boundary.T, gid="boundary", color=INK, linewidth=1.3, zorder=4.5)
    labels = _draw_curves(axes, found)
    scene = Scene(axes, found.positioning.projection, metre)
    _draw_stick(scene, stick_points(arm, shown_configuration(found), found.positioning.frame))
    return finish(figure, scene, extra=labels)


def _draw_map(figure: Figure, axes: Axes, box: Box, found: Workspace, extent: np.ndarray, lang: str) -> None:
    positioning = found.positioning
    lined = smooth(found.best) if len(positioning.free) > 2 else found.best
    unit = volume_unit(positioning.arm, positioning.rows, positioning.columns)
    label, scale = axis_label(say("manipulability_word", lang), unit, "w"), (_LEFT + _WIDEST + 3, box[1], 3.0, box[3])
    best = found.best
    draw_map(
        figure, axes, scale, found.x, found.y, best, found.highest, label, lang, "best", extent=extent, lined=lined
    )


def _draw_curves(axes: Axes, found: Workspace) -> list[Label]:
    """Draw the images of the singular families; returns their conditions as labels."""
    labels = []
    for k, (latex, q) in enumerate(found.curves.items()):
        points = curve_points(found.positioning, q)
        dot = {"marker": "o", "markersize": 4} if len(points) == 1 else {}
        axes.plot(points[:, 0], points[:, 1], gid=f"singular {latex}", **curve_style(k), **dot)
        at = points[int(np.nanargmax(points @ np.array([1.0, 0.6 - 0.8 * k])))]
        text, colour = f"${plain_condition(latex)}$", curve_style(k)["color"]
        labels.append(Label(axes, text, (at[0], at[1]), (1.0, 0.5 - 0.7 * k), colour=colour))
    return labels


def curve_points(positioning: Positioning, q: np.ndarray) -> np.ndarray:
    """Return the points of configurations (M, n) on the map, (M, 2); NaN where the rows are."""
    points = np.full((len(q), 2), np.nan)
    valid = ~np.isnan(q[:, 0])
    points[valid] = positioning.projection.points(positioning.points(q[valid]))
    return points


def shown_configuration(found: Workspace) -> np.ndarray:
    """Return where the arm is drawn: of the cells with nearly the highest manipulability the one farthest up to the right."""
    rows, columns = np.nonzero(found.best >= _NEARLY * np.nanmax(found.best))
    farthest = int(np.argmax(found.x[columns] + found.y[rows]))
    return np.asarray(found.winners[rows[farthest], columns[farthest]])


def caption(arm: Arm, lang: str = "") -> str:
    """Return the caption: which point, of how many configurations, how far it reaches, the best manipulability, the singular curves."""
    found = workspace_of(arm)
    positioning = found.positioning
    point = say("wrist_centre" if positioning.wrist else "tool_point", lang)
    unit = volume_unit(arm, positioning.rows, positioning.columns)
    best = f"{number(found.highest, lang)} {unit}".strip()
    near, far = (length(distance, lang) for distance in found.reach)
    parts = [say("workspace_is", lang, point=point, count=say("million", lang), best=best)]
    if not positioning.about:
        parts.append(say("workspace_reach", lang, near=near, far=far))
    parts.append(say("boundary_is", lang))
    if found.curves:
        curves = ", ".join(f"${plain_condition(latex)}$" for latex in found.curves)
        parts.append(say("singular_curves", lang, curves=curves))
    return " ".join(parts if found.curves else [*parts, say("no_singular_curves", lang)])


def applies(arm: Arm, lang: str) -> str | None:
    """Return why an arm has no map of its workspace, or None."""
    return None if positioning_of(arm) is not None else say("no_plane", lang)


def _draw_stick(scene: Scene, points: np.ndarray) -> None:
    """Draw an arm as lines between its joints, a dot at each; gid "stick"."""
    scene.line(points, gid="stick", zorder=8, color=INK, linewidth=1.6, marker="o", markersize=3, markerfacecolor=PAPER, markeredgewidth=0.8)  # fmt: skip
    scene.line(points[-1:], zorder=8.1, color=INK, marker="o", markersize=3, linestyle="none")


KIND = Kind("workspace", applies, workspace_figure, caption)
