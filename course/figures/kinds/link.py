"""One link between skew axes with its four parameters, in both Denavit–Hartenberg conventions side by side."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from armproof.course.figures.drawing.dimensions import draw_angle, draw_length
from armproof.course.figures.drawing.labels import number, say
from armproof.course.figures.drawing.panels import PanelTitle, make_panels
from armproof.course.figures.drawing.scene import Scene, View, finish
from armproof.course.figures.drawing.style import GREY, PALE, styled
from armproof.course.figures.drawing.symbols import draw_frames
from armproof.course.figures.facts.link_parts import Convention, LinkParts, link_parts
from armproof.course.figures.registry import Kind
from armproof.models.arm import Arm
from armproof.models.showing.projection import axonometric

EXAMPLE = (0.5, 50.0, 0.4, 40.0)  # a (m), α (°), d (m), θ (°)
_CONVENTIONS: tuple[Convention, ...] = ("classic", "modified")
_HEIGHT = 78.0  # mm
_METRE = 0.0145  # metres on the paper a millimetre
_UP = np.array([0.0, 0.0, 0.35])  # m, room above
_BELOW, _ABOVE = 0.18, 0.6  # m, of an axis to both sides of what is on it
_RADIUS = 9.0  # mm, of the arcs


@styled()
def link_figure(arm: Arm, lang: str = "") -> Figure:
    """Return a link between two skew axes, with a, α, d and θ; the arm plays no part."""
    figure, panels = make_panels([PanelTitle(say(f"dh_{one}", lang), []) for one in _CONVENTIONS], _HEIGHT)
    scenes = []
    for panel, convention in zip(panels, _CONVENTIONS, strict=True):
        parts = link_parts(convention, *EXAMPLE)
        scene = Scene.show(figure, panel.box, _view(parts))
        draw_axes(scene, parts)
        _draw_frames(scene, parts)
        draw_parameters(scene, parts, convention)
        scenes.append(scene)
    return finish(figure, *scenes)


def _view(parts: LinkParts) -> View:
    points = np.vstack([parts.feet, parts.before[:3, 3], parts.after[:3, 3]])
    seen = axonometric().points(np.vstack([points, points + _UP]))
    return View(axonometric(), (seen.min(axis=0) + seen.max(axis=0)) / 2, _METRE)


def draw_axes(scene: Scene, parts: LinkParts) -> None:
    """Draw the axes of the joints as chain lines, and the common normal between them; gids "axis 0", "axis 1", "normal"."""
    marked = np.vstack([parts.feet, parts.before[:3, 3], parts.after[:3, 3]])
    for k, (point, way) in enumerate(parts.axes):
        places = (marked - point) @ way
        on_it = places[np.linalg.norm(marked - point - places[:, None] * way, axis=1) < 1e-9]
        ends = point + np.outer([on_it.min() - _BELOW, on_it.max() + _ABOVE], way)
        scene.line(ends, gid=f"axis {k}", color=GREY, linewidth=0.8, linestyle=(0, (8, 2, 1.5, 2)), zorder=1.4)
    scene.line(parts.feet, gid="normal", color=PALE, linewidth=5.0, zorder=1.2)


def _draw_frames(scene: Scene, parts: LinkParts) -> None:
    draw_frames(scene, {"i-1": parts.before, "i": parts.after})
    for name, pose in (("O_{i-1}", parts.before), ("O_i", parts.after)):
        scene.circle(scene.paper(pose[:3, 3]), 0.6, zorder=7, facecolor=GREY)
        scene.label(f"${name}$", pose[:3, 3], (-1.0, -1.0), gap=1.0)


def draw_parameters(scene: Scene, parts: LinkParts, convention: Convention) -> None:
    """Dimension a and d, and draw the arcs of α and θ; gids "a", "d", "alpha", "theta"."""
    index = {"a": "{i-1}", "alpha": "{i-1}", "d": "i", "theta": "i"} if convention == "modified" else dict.fromkeys(("a", "alpha", "d", "theta"), "i")  # fmt: skip
    for name, ends in parts.lengths.items():
        draw_length(scene, ends, f"${name}_{index[name]}$", name)
    for turn in parts.turns:
        text = rf"$\{turn.name}_{index[turn.name]}$"
        draw_angle(scene, turn.at, turn.start, turn.axis, turn.angle, text, radius=_RADIUS, gid=turn.name)


def caption(arm: Arm, lang: str = "") -> str:
    """Return the caption: what each parameter is, and the values that are drawn."""
    a, alpha, d, theta = (number(value, lang) for value in EXAMPLE)
    return say("link_is", lang, a=a, alpha=alpha, d=d, theta=theta)


KIND = Kind("link", lambda arm, lang: None, link_figure, caption, general=True)
