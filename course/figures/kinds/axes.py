"""The three cases of two successive joint axes: skew, parallel, meeting; where their common normal is."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from armproof.course.figures.drawing.dimensions import draw_angle, draw_length
from armproof.course.figures.drawing.labels import say
from armproof.course.figures.drawing.panels import PanelTitle, make_panels
from armproof.course.figures.drawing.scene import Scene, View, finish
from armproof.course.figures.drawing.style import GREY, PALE, styled
from armproof.course.figures.drawing.symbols import AXIS_COLOURS
from armproof.course.figures.facts.link_parts import LinkParts, link_parts
from armproof.course.figures.kinds.link import draw_axes
from armproof.course.figures.registry import Kind
from armproof.models.arm import Arm
from armproof.models.showing.projection import axonometric

CASES = {"skew": (0.5, 50.0), "parallel": (0.5, 0.0), "meeting": (0.0, 50.0)}  # a (m), α (°)
_HEIGHT, _METRE = 58.0, 0.0185  # mm; metres on the paper a millimetre
_UP = np.array([0.0, 0.0, 0.2])  # m, of the middle of the picture above the normal
_RADIUS, _AXIS = 11.0, 12.0  # mm
_OTHERS = (-0.18, 0.22, 0.42)  # m along the axis: normals of parallel axes that would do as well


@styled()
def axes_figure(arm: Arm, lang: str = "") -> Figure:
    """Return two axes in each of the three cases, with their common normal, a and α; the arm plays no part."""
    titles = [PanelTitle(say(f"axes_{case}", lang), [say(f"axes_{case}_so", lang)], letter=letter) for case, letter in zip(CASES, "abc", strict=True)]  # fmt: skip
    figure, panels = make_panels(titles, _HEIGHT)
    scenes = []
    for panel, (case, (a, alpha)) in zip(panels, CASES.items(), strict=True):
        parts = link_parts("modified", a, alpha, 0.0, 0.0)
        scenes.append(Scene.show(figure, panel.box, _view(parts)))
        draw_axes(scenes[-1], parts)
        _draw_case(scenes[-1], parts, case)
    return finish(figure, *scenes)


def _view(parts: LinkParts) -> View:
    return View(axonometric(), axonometric().points(parts.feet.mean(axis=0) + _UP), _METRE)


def _draw_case(scene: Scene, parts: LinkParts, case: str) -> None:
    x, z, z_next = parts.before[:3, 0], parts.axes[0][1], parts.axes[1][1]
    for point, way, name in ((parts.feet[0], z, "z_{i-1}"), (parts.feet[1], z_next, "z_i")):
        tip = scene.arrow(point, scene.metres(_AXIS) * way, colour=AXIS_COLOURS["z"], gid=name)
        scene.label(f"${name}$", tip, scene.paper(way), colour=AXIS_COLOURS["z"])
    tip = scene.arrow(parts.feet[0], scene.metres(_AXIS) * x, colour=AXIS_COLOURS["x"], gid="x_{i-1}")
    scene.label("$x_{i-1}$", tip, (1.0, -0.6), colour=AXIS_COLOURS["x"])
    scene.circle(scene.paper(parts.feet[0]), 0.6, zorder=7, facecolor=GREY)
    scene.label("$O_{i-1}$", parts.feet[0], (-1.0, -0.6), gap=1.0)
    if case != "meeting":
        draw_length(scene, parts.feet, "$a_{i-1}$", "a")
    if case != "parallel":
        draw_angle(scene, parts.feet[1], z, parts.turns[0].axis, parts.turns[0].angle, r"$\alpha_{i-1}$", radius=_RADIUS + 5, gid="alpha")  # fmt: skip
    else:
        for up in _OTHERS:
            scene.line(parts.feet + up * z, color=PALE, linewidth=2.0, zorder=1.1, gid="another normal")


def caption(arm: Arm, lang: str = "") -> str:
    """Return the caption: the rule of least distance, and what is free in each case."""
    return say("axes_are", lang)


KIND = Kind("axes", lambda arm, lang: None, axes_figure, caption, general=True)
