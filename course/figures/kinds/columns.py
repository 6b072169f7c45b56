"""The linear columns of a Jacobian: for each joint its axis, the lever to the tool, and the velocity z × p of the tool."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from armproof.course.figures.drawing.fitting import Fit
from armproof.course.figures.drawing.labels import math, number, say, values_text
from armproof.course.figures.drawing.panels import PanelTitle, make_panels
from armproof.course.figures.drawing.panels import columns_of as panel_columns
from armproof.course.figures.drawing.scene import Scene, finish
from armproof.course.figures.drawing.style import GREY, STROKES, WIDTHS, styled
from armproof.course.figures.drawing.symbols import AXIS_COLOURS, Look, draw_arm
from armproof.course.figures.facts.columns import Column, columns_of
from armproof.course.figures.facts.poses import showing_pose
from armproof.course.figures.facts.task import task_of
from armproof.course.figures.registry import Kind
from armproof.models.arm import Arm

_HEIGHTS = (34.0, 56.0)  # mm, of a panel
_AXIS, _LONGEST = 9.0, 13.0  # mm: of an axis, of the fastest velocity
_LOOK = Look(GREY, 0.55, 1.2, size=0.6)
_MARGIN = 14.0  # mm


@styled()
def columns_figure(arm: Arm, lang: str = "") -> Figure:
    """Return a panel a joint: the axis z, the lever p and the velocity of the tool when this joint alone moves at rate 1."""
    found, q = columns_of(arm), showing_pose(arm)
    titles = [PanelTitle(math(column.joint.symbol), [_values(column, lang)]) for column in found]
    width = WIDTHS["page"] / panel_columns(len(titles))
    fit = Fit(arm, q, margin=_MARGIN, size=_LOOK.size)
    height = fit.height(width, _HEIGHTS)
    figure, panels = make_panels(titles, height)
    fastest = max(float(np.linalg.norm(column.v)) for column in found)
    scenes = [Scene.show(figure, panel.box, fit.view(width, height)) for panel in panels]
    for scene, column in zip(scenes, found, strict=True):
        draw_arm(scene, arm, q, _LOOK)
        _draw_column(scene, column, _LONGEST / fastest)
    return finish(figure, *scenes)


def _values(column: Column, lang: str) -> str:
    values = ";\\, ".join(number(round(value, 9), lang, in_math=True) for value in column.v)
    return f"$v = ({values})$ m/s"


def _draw_column(scene: Scene, column: Column, size: float) -> None:
    turns, tool, velocity = column.joint.kind == "revolute", column.at + column.lever, STROKES[1].colour
    tip = scene.arrow(column.at, scene.metres(_AXIS) * column.z, colour=AXIS_COLOURS["z"], width=1.3, gid="z")
    scene.label("$z$", tip, scene.paper(column.z), colour=AXIS_COLOURS["z"], gap=1.0)
    if turns and np.linalg.norm(column.lever) > 1e-9:
        scene.arrow(column.at, column.lever, colour=GREY, width=0.8, linestyle=(0, (4, 2)), gid="p")
        scene.label("$p$", column.at + column.lever / 2, gap=0.8, colour=GREY)
    name = "$z \\times p$" if turns else "$z$"
    if np.linalg.norm(column.v) > 1e-9:
        tip = scene.arrow(tool, scene.metres(size) * column.v, colour=velocity, width=1.6, zorder=7, gid="v")
        scene.label(name, tip, scene.paper(column.v), colour=velocity)
    else:
        scene.circle(scene.paper(tool), 0.8, zorder=7, facecolor=velocity)
        scene.label(f"{name} $= 0$", tool, gap=1.0, colour=velocity)


def caption(arm: Arm, lang: str = "") -> str:
    """Return the caption: the rule of a column, and the pose."""
    return say("columns_are", lang, pose=values_text(arm, showing_pose(arm), lang))


def applies(arm: Arm, lang: str) -> str | None:
    """Return why an arm has no such figure: its tool turns about a point that rests."""
    return say("no_velocity", lang) if task_of(arm).turns_only else None


KIND = Kind("columns", applies, columns_figure, caption)
