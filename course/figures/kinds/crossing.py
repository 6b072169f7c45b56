"""What the joints do while the tool passes a singular configuration: with the pseudo-inverse beside damped least squares."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from armproof.course.figures.drawing.fitting import Fit
from armproof.course.figures.drawing.labels import (
    axis_label,
    joint_unit,
    listed,
    math,
    number,
    same_unit,
    say,
    with_unit,
)
from armproof.course.figures.drawing.maps import plain_condition
from armproof.course.figures.drawing.placement import Label
from armproof.course.figures.drawing.plots import at_peak, axes_by_unit, plot_axes
from armproof.course.figures.drawing.scene import Scene, finish
from armproof.course.figures.drawing.style import GREY, STROKES, Box, new_figure, stroke_of, styled
from armproof.course.figures.drawing.symbols import Look, draw_arm
from armproof.course.figures.facts.near_singular import DURATION, NearSingular, near_singular
from armproof.course.figures.facts.task import tool_points
from armproof.course.figures.registry import Kind
from armproof.models.arm import Arm
from armproof.models.motion.limits import read_rate_limits

SNAPSHOTS = 5
_SIZE = 0.8  # of the symbols
_SCENE = (0.0, 2.0, 74.0, 92.0)  # mm
_LEFT, _WIDTH, _PANEL, _GAP, _BOTTOM = 90.0, 68.0, 23.0, 6.5, 9.0
_EXACT, _DAMPED = STROKES[0], STROKES[1]


@styled()
def crossing_figure(arm: Arm, lang: str = "") -> Figure:
    """Return the motion of an arm's tool past a singular configuration, the joint rates of both inverses, and the error of the damped one."""
    found = near_singular(arm)
    assert found is not None
    figure = new_figure("page", 96)
    scene = _scene(figure, found)
    labels: list[Label] = []
    for place, (name, rates) in enumerate((("pseudo", found.rates), ("damped", found.rates_damped))):
        labels += _rates(figure, found, place, name, rates, lang)
    labels += _errors(figure, found, lang)
    return finish(figure, scene, extra=labels)


def _scene(figure: Figure, found: NearSingular) -> Scene:
    arm, last = found.task.arm, len(found.times) - 1
    places = sorted({*np.linspace(0, last, SNAPSHOTS).astype(int).tolist(), found.nearest})
    paths = tool_points(arm, found.q), tool_points(arm, found.q_damped)
    scene = Fit(arm, found.q[places], points=np.vstack(paths), margin=7.0, size=_SIZE).scene(figure, _SCENE)
    for place in places:
        near = place == found.nearest
        look = Look(size=_SIZE, zorder=4.0) if near else Look(GREY, 0.45, 1.1, size=_SIZE).bare()
        draw_arm(scene, arm, found.q[place], look, name=f"{place} ")
    for name, path, stroke in zip(("pseudo", "damped"), paths, (_EXACT, _DAMPED), strict=True):
        scene.line(path, gid=f"path {name}", zorder=8, linewidth=1.3, **stroke.line)
    scene.label("$A$", paths[0][0], paths[0][0] - paths[0][last // 2], gap=1.0)
    scene.label("$B$", paths[0][-1], paths[0][-1] - paths[0][last // 2], gap=1.0)
    return scene


def rate_scales(arm: Arm) -> tuple[np.ndarray, dict[str, str]]:
    """Return what joint rates are multiplied by for a plot, (n,), and its label by the kind of joint: % of limits, or rad/s, m/s."""
    kinds = [kind for kind, _ in same_unit(arm)]
    limits = read_rate_limits(arm).velocity
    if np.isfinite(limits).all():
        return 100 / limits, dict.fromkeys(kinds, axis_label("", "%", r"\dot{q}/k_v"))
    units = {kind: joint_unit(kind, 1).replace("°", "rad") for kind in kinds}
    return np.ones(len(limits)), {kind: axis_label("", unit, r"\dot{q}") for kind, unit in units.items()}


def _box(place: int) -> Box:
    return (_LEFT, _BOTTOM + (2 - place) * (_PANEL + _GAP), _WIDTH, _PANEL)


def _rates(figure: Figure, found: NearSingular, place: int, name: str, rates: np.ndarray, lang: str) -> list[Label]:
    """Plot the rates of all joints; returns the names of the fastest ones, at their peaks."""
    arm = found.task.arm
    scales, names = rate_scales(arm)
    title = say(f"{name}_inverse", lang, damping=number(found.damping, lang, in_math=True))
    axes = plot_axes(figure, _box(place), lang, title=title)
    sides = axes_by_unit(axes, names, lang)
    for kind, places in same_unit(arm):
        most = 1.25 * float(
            np.abs(scales * found.rates)[:, places if len(set(names.values())) > 1 else slice(None)].max()
        )
        sides[kind].set(xlim=(0, DURATION), ylim=(-most, most))
    _mark_nearest(axes, found)
    labels = []
    peaks = np.abs(scales * found.rates).max(axis=0)
    for k, joint in enumerate(arm.joints):
        stroke, values = stroke_of(k), scales[k] * rates[:, k]
        side = sides[joint.kind]
        side.plot(found.times, values, linewidth=1.0, gid=f"rate {name} {joint.symbol}", **stroke.line)
        if peaks[k] > 0.25 * peaks.max():
            labels.append(at_peak(side, math(joint.symbol), found.times, values, stroke, _beside(found)))
    return labels


def _beside(found: NearSingular) -> float:
    """Return on which side of its peak the name of a curve stands: where there is room."""
    return 0.5 if found.passes else -0.6


def _mark_nearest(axes: Axes, found: NearSingular) -> None:
    axes.axvline(found.times[found.nearest], color=GREY, linewidth=0.5, linestyle=(0, (1, 2)), zorder=1)


def error_parts(found: NearSingular) -> list[tuple[str, float, np.ndarray]]:
    """Return the errors that are plotted: mm of translation, degrees of rotation, with what the error in SI units is multiplied by."""
    linear = [k for k, row in enumerate(found.task.rows) if row <= 3]
    angular = [k for k, row in enumerate(found.task.rows) if row > 3]
    parts = [("mm", 1000.0, linear), ("°", 180 / np.pi, angular)]
    return [(unit, scale, np.linalg.norm(found.error[:, columns], axis=1)) for unit, scale, columns in parts if columns]


def _errors(figure: Figure, found: NearSingular, lang: str) -> list[Label]:
    """Plot how far the tool is from where it ought to be with the damped inverse."""
    parts = error_parts(found)
    time, title = axis_label(say("time", lang), "s", "t"), say("damped_error", lang)
    axes = plot_axes(figure, _box(2), lang, time, title=title)
    sides = axes_by_unit(axes, {unit: axis_label("", unit, "e") for unit, _, _ in parts}, lang)
    _mark_nearest(axes, found)
    labels = []
    for (unit, scale, error), stroke in zip(parts, (STROKES[1], STROKES[3]), strict=False):
        sides[unit].plot(found.times, scale * error, linewidth=1.0, gid=f"error {unit}", **stroke.line)
        sides[unit].set(xlim=(0, DURATION), ylim=(0, 1.3 * max(scale * float(error.max()), 1e-12)))
        text = with_unit(scale * float(error.max()), unit, lang)
        labels.append(at_peak(sides[unit], text, found.times, scale * error, stroke, _beside(found)))
    return labels


def caption(arm: Arm, lang: str = "") -> str:
    """Return the caption: the speed, the family, the least singular value, the highest rates of both inverses, the bound, the error."""
    found = near_singular(arm)
    assert found is not None
    speed = float(np.linalg.norm(found.twist))
    translates = bool(np.linalg.norm(found.twist[:3]) > 0)
    fastest = int(np.argmax(np.abs(rate_scales(arm)[0] * found.rates).max(axis=0)))
    joint = arm.joints[fastest]
    unit = joint_unit(joint.kind, 1).replace("°", "rad")
    highest = [with_unit(float(np.abs(r[:, fastest]).max()), unit, lang) for r in (found.rates, found.rates_damped)]
    moving = say("moves_at" if translates else "turns_at", lang, speed=number(speed, lang))
    errors = [with_unit(scale * float(error.max()), unit, lang) for unit, scale, error in error_parts(found)]
    return " ".join(
        (
            say("passes" if found.passes else "comes_near", lang, moving=moving, family=plain_condition(found.family.latex), least=number(found.least, lang, 2)),
            say("highest_rates", lang, joint=math(joint.symbol), pseudo=highest[0], damped=highest[1], damping=number(found.damping, lang, in_math=True)),
            say("and_error", lang, errors=listed(errors, lang)),
        )
    )  # fmt: skip


def applies(arm: Arm, lang: str) -> str | None:
    """Return why there is no such motion of an arm, or None."""
    return None if near_singular(arm) is not None else say("no_crossing", lang)


KIND = Kind("crossing", applies, crossing_figure, caption, empty=True)
