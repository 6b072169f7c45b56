"""The error with which a simulated arm tracks a motion, with its own masses in the controller and with wrong ones."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from armproof.course.figures.drawing.labels import axis_label, math, number, same_unit, say, with_unit
from armproof.course.figures.drawing.placement import Label, place_labels
from armproof.course.figures.drawing.plots import at_peak, axes_by_unit, plot_axes
from armproof.course.figures.drawing.style import GREY, STROKES, new_figure, stroke_of, styled
from armproof.course.figures.facts.motions import motion_of
from armproof.course.figures.facts.task import task_of
from armproof.course.figures.registry import Kind
from armproof.models.arm import Arm
from armproof.models.errors import ModelError
from armproof.models.motion.limits import read_rate_limits
from armproof.models.motion.tracking import BANDWIDTH, TrackingLog, track

PERIOD = 2e-3  # s, of the controller
WRONG = 0.8  # times the masses
_LEFT, _WIDTH, _PANEL, _GAP, _BOTTOM = 14.0, 57.0, 25.0, 7.0, 9.0  # mm
_THOUSANDTHS = {"revolute": "mrad", "prismatic": "mm"}


@dataclass(frozen=True, eq=False)
class TrackedMotion:
    """Two simulations of the motion of an arm: the controller's model right, and with all masses WRONG times their own."""

    arm: Arm
    right: TrackingLog
    wrong: TrackingLog


@lru_cache(maxsize=16)
def tracked(arm: Arm) -> TrackedMotion:
    """Return the simulations of the motion that the figures of an arm show.

    Raises:
        ModelError: the arm cannot be simulated, as one without masses.
    """
    trajectory, frame = motion_of(arm).trajectory, task_of(arm).frame
    return TrackedMotion(
        arm,
        track(arm, trajectory, frame=frame, period=PERIOD),
        track(arm, trajectory, frame=frame, period=PERIOD, mass_factor=WRONG),
    )


@styled()
def tracking_figure(arm: Arm, lang: str = "") -> Figure:
    """Return the error of the tool and of the joints, and the efforts of the drives, against time."""
    found = tracked(arm)
    figure = new_figure("column", 3 * _PANEL + 2 * _GAP + _BOTTOM + 6)
    labels = _tool_error(_panel(figure, 0, "tool_error", axis_label("", _tool(arm)[0], "e"), lang), found, lang)
    errors = {kind: axis_label("", unit, "q_d - q") for kind, unit in _THOUSANDTHS.items()}
    axes = _panel(figure, 1, "joint_error", "", lang)
    labels += _curves(axes, found, 1000 * (found.wrong.q_desired - found.wrong.q), "error", errors, lang)
    axes = _panel(figure, 2, "effort", "", lang)
    labels += _curves(axes, found, effort_scales(arm) * found.wrong.torques, "effort", _effort_labels(arm), lang)
    place_labels(figure, labels)
    return figure


def _panel(figure: Figure, place: int, what: str, y: str, lang: str) -> Axes:
    time = axis_label(say("time", lang), "s", "t") if place == 2 else ""
    box = (_LEFT, _BOTTOM + (2 - place) * (_PANEL + _GAP), _WIDTH, _PANEL)
    return plot_axes(figure, box, lang, time, y, title=say(f"{what}_title", lang, part=number(100 * WRONG, lang)))


def _tool(arm: Arm) -> tuple[str, float]:
    """Return the unit in which the error of the tool is plotted, and what metres or radians are multiplied by."""
    return ("°", 180 / np.pi) if task_of(arm).turns_only else ("mm", 1000.0)


def tool_error(arm: Arm, log: TrackingLog) -> np.ndarray:
    """Return the error of the tool (N,): of its position (m), of a wrist that of its axes (rad)."""
    return log.rotation_error if task_of(arm).turns_only else log.position_error


def _tool_error(axes: Axes, found: TrackedMotion, lang: str) -> list[Label]:
    unit, scale = _tool(found.arm)
    labels = []
    for key, log, stroke in (("right", found.right, STROKES[0]), ("wrong", found.wrong, STROKES[1])):
        error = scale * tool_error(found.arm, log)
        axes.plot(log.times, error, linewidth=1.0, gid=f"tool {key}", **stroke.line)
        masses = say(f"masses_{key}", lang, part=number(100 * WRONG, lang))
        text = f"{masses}: {with_unit(float(error.max()), unit, lang, 2)}"
        labels.append(at_peak(axes, text, log.times, error, stroke, 0.3))
    axes.set(xlim=(0, found.right.times[-1]), ylim=(0, 1.35 * scale * float(tool_error(found.arm, found.wrong).max())))
    return labels


def _effort_labels(arm: Arm) -> dict[str, str]:
    if np.isfinite(read_rate_limits(arm).effort).all():
        return dict.fromkeys(_THOUSANDTHS, axis_label("", "%", r"\tau/\tau_\mathrm{max}"))
    return {"revolute": axis_label("", "N m", r"\tau"), "prismatic": axis_label("", "N", r"\tau")}


def effort_scales(arm: Arm) -> np.ndarray:
    """Return what efforts are multiplied by for the plot: to per cent of the drives' limits, if all have one, (n,)."""
    limits = read_rate_limits(arm).effort
    return 100 / limits if np.isfinite(limits).all() else np.ones(len(limits))


def _curves(
    axes: Axes, found: TrackedMotion, values: np.ndarray, gid: str, names: Mapping[str, str], lang: str
) -> list[Label]:
    """Plot a curve a joint, each unit on its own axis; returns their names, those of small ones left out."""
    labels, arm, times = [], found.arm, found.wrong.times
    groups = same_unit(arm)
    sides = axes_by_unit(axes, {kind: names[kind] for kind, _ in groups}, lang)
    if len(set(sides.values())) == 1:
        groups = [(groups[0][0], [k for _, places in groups for k in places])]
    for kind, places in groups:
        side, largest = sides[kind], float(np.abs(values[:, places]).max())
        for k in places:
            symbol, curve = arm.joints[k].symbol, values[:, k]
            side.plot(times, curve, linewidth=0.9, gid=f"{gid} {symbol}", **stroke_of(k).line)
            if np.abs(curve).max() > 0.12 * largest:
                labels.append(at_peak(side, math(symbol), times, curve, stroke_of(k), 0.2))
        most = 1.35 * largest
        side.set(xlim=(0, times[-1]), ylim=(-most, most))  # 0 at one height on both sides
    axes.axhline(0, color=GREY, linewidth=0.4, zorder=1)
    return labels


def caption(arm: Arm, lang: str = "") -> str:
    """Return the caption: the motion's duration, the controller, the largest errors of the tool, the largest effort."""
    found = tracked(arm)
    unit, scale = _tool(arm)
    errors = (scale * float(tool_error(arm, log).max()) for log in (found.right, found.wrong))
    right, wrong = (with_unit(error, unit, lang, 2) for error in errors)
    parts = [
        say(
            "tracking_is", lang, t_f=number(motion_of(arm).duration, lang), bandwidth=number(BANDWIDTH, lang),
            period=number(1000 * PERIOD, lang), right=right, wrong=wrong, part=number(100 * WRONG, lang),
        ),
    ]  # fmt: skip
    if np.isfinite(read_rate_limits(arm).effort).all():
        use = np.abs(effort_scales(arm) * found.wrong.torques).max(axis=0)
        at = int(np.argmax(use))
        parts.append(say("effort_is", lang, joint=math(arm.joints[at].symbol), use=number(float(use[at]), lang, 2)))
    return " ".join(parts)


def applies(arm: Arm, lang: str) -> str | None:
    """Return why an arm cannot be simulated, or None."""
    try:
        tracked(arm)
    except ModelError:
        return say("no_masses", lang)
    return None


KIND = Kind("tracking", applies, tracking_figure, caption)
