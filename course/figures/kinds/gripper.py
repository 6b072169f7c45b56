"""The frame of a gripper: sliding s, normal n, approach a, the columns of the tool's rotation."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from armproof.course.figures.drawing.labels import say
from armproof.course.figures.drawing.scene import Scene, View, finish
from armproof.course.figures.drawing.style import GREY, INK, WIDTHS, new_figure, styled
from armproof.course.figures.drawing.symbols import AXIS_COLOURS
from armproof.course.figures.registry import Kind
from armproof.models.arm import Arm
from armproof.models.showing.projection import axonometric

_HEIGHT = 54.0  # mm
_METRE = 0.0042  # metres on the paper a millimetre
_AXIS = 15.0  # mm
SLIDING, APPROACH = np.array([0.0, 1.0, 0.0]), np.array([1.0, 0.0, 0.0])
NORMAL = np.cross(APPROACH, SLIDING)
_OPEN, _DEEP, _ARM = 0.045, 0.06, 0.08  # m: half the way between the fingers, their length, the last link


@styled()
def gripper_figure(arm: Arm, lang: str = "") -> Figure:
    """Return a gripper of two fingers with s, n and a at its point; the arm plays no part."""
    figure = new_figure("column", _HEIGHT)
    view = View(axonometric(), axonometric().points(-0.02 * APPROACH), _METRE)
    scene = Scene.show(figure, (0.0, 0.0, WIDTHS["column"], _HEIGHT), view)
    palm = -_DEEP * APPROACH
    fingers = [
        palm + side * _OPEN * SLIDING + deep * APPROACH for side, deep in ((1, _DEEP), (1, 0), (-1, 0), (-1, _DEEP))
    ]
    scene.line(np.array(fingers), gid="fingers", color=INK, linewidth=2.4)
    scene.line(np.array([palm - _ARM * APPROACH, palm]), gid="link", color=GREY, linewidth=4.0, zorder=1.5)
    for name, way, letter in (("s", SLIDING, "x"), ("n", NORMAL, "y"), ("a", APPROACH, "z")):
        tip = scene.arrow(np.zeros(3), scene.metres(_AXIS) * way, colour=AXIS_COLOURS[letter], width=1.2, gid=name)
        scene.label(f"${name}$ = ${letter}$", tip, scene.paper(way), colour=AXIS_COLOURS[letter])
    scene.circle(scene.paper(np.zeros(3)), 0.7, zorder=7, facecolor=GREY)
    scene.label("$G$", np.zeros(3), (-0.6, -1.0), gap=1.2)
    return finish(figure, scene)


def caption(arm: Arm, lang: str = "") -> str:
    """Return the caption: what the three axes are."""
    return say("gripper_is", lang)


KIND = Kind("gripper", lambda arm, lang: None, gripper_figure, caption, general=True)
