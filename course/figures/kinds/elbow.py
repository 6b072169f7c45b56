"""Elbow up and elbow down: the circles about shoulder and target, whose two crossings are the elbows."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from armproof.course.figures.drawing.fitting import Fit
from armproof.course.figures.drawing.labels import length, number, say, values_text
from armproof.course.figures.drawing.scene import Scene, finish
from armproof.course.figures.drawing.style import GREY, WIDTHS, new_figure, stroke_of, styled
from armproof.course.figures.drawing.symbols import Look, draw_arm
from armproof.course.figures.facts.elbow import Elbow, elbow_of
from armproof.course.figures.registry import Kind
from armproof.models.arm import Arm

_HEIGHT, _MARGIN, _SIZE = 84.0, 9.0, 0.8  # mm, mm, of the symbols
_TURN = np.linspace(0, 2 * np.pi, 181)


@styled()
def elbow_figure(arm: Arm, lang: str = "") -> Figure:
    """Return the two postures of an arm in the plane across its axes, with the circles that give them."""
    found = elbow_of(arm)
    assert found is not None
    figure = new_figure("column", _HEIGHT)
    reach = np.array([found.shoulder - found.radii[0], found.shoulder + found.radii[0], found.target - found.radii[1], found.target + found.radii[1]])  # fmt: skip
    points = reach @ np.array([found.projection.right, found.projection.up])
    fit = Fit(arm, found.q, found.projection, points, _MARGIN, _SIZE)
    scene = fit.scene(figure, (0.0, 0.0, WIDTHS["column"], _HEIGHT))
    for centre, radius, name in ((found.shoulder, found.radii[0], "shoulder"), (found.target, found.radii[1], "target")):  # fmt: skip
        ring = centre + radius * np.column_stack([np.cos(_TURN), np.sin(_TURN)])
        scene.flat_line(ring, gid=f"circle {name}", color=GREY, linewidth=0.6, linestyle=(0, (5, 2)), zorder=1)
    for k, q in enumerate(found.q):
        stroke = stroke_of(k)
        draw_arm(
            scene, arm, q, Look(stroke.colour, 1.0, 1.6, linestyle=stroke.linestyle, size=_SIZE), f"posture {k + 1} "
        )
    _draw_words(scene, found, lang)
    return finish(figure, scene)


def _draw_words(scene: Scene, found: Elbow, lang: str) -> None:
    """Name the corners, and draw the way from shoulder to target."""
    for k, key in enumerate(("elbow_up", "elbow_down")):
        away = found.elbows[k] - found.elbows[1 - k]
        scene.label(say(key, lang), found.elbows[k], away, gap=2.2, colour=stroke_of(k).colour)
    scene.label(say("shoulder", lang), found.shoulder, found.shoulder - found.target, gap=3.0)
    scene.label(say("target", lang), found.target, found.target - found.shoulder, gap=2.4)
    scene.flat_line(np.array([found.shoulder, found.target]), gid="r", color=GREY, linewidth=0.7, linestyle=(0, (1, 2)))
    scene.label("$r$", (found.shoulder + found.target) / 2, gap=0.6, colour=GREY)


def caption(arm: Arm, lang: str = "") -> str:
    """Return the caption: the radii, the distance, and the joint values of both postures."""
    found = elbow_of(arm)
    assert found is not None
    first, second = (length(radius, lang) for radius in found.radii)
    distance = length(float(np.linalg.norm(found.target - found.shoulder)), lang)
    postures = [say("posture_caption", lang, number=number(k, lang), pose=values_text(arm, q, lang)) for k, q in enumerate(found.q, start=1)]  # fmt: skip
    return " ".join([say("elbow_is", lang, first=first, second=second, distance=distance), *postures])


def applies(arm: Arm, lang: str) -> str | None:
    """Return why an arm has no such figure, or None."""
    return None if elbow_of(arm) is not None else say("no_elbow", lang)


KIND = Kind("elbow", applies, elbow_figure, caption)
