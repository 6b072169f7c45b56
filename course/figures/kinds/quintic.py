"""The quintic of an arm against time: joint positions, velocities and accelerations, with their peaks marked."""

from __future__ import annotations

from math import sqrt

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from armproof.course.figures.drawing.labels import (
    axis_label,
    joint_scales,
    joint_unit,
    math,
    number,
    same_unit,
    say,
    values_text,
    with_unit,
)
from armproof.course.figures.drawing.placement import Label, place_labels
from armproof.course.figures.drawing.plots import plot_axes
from armproof.course.figures.drawing.style import GREY, SMALL, WIDTHS, Box, Size, new_figure, stroke_of, styled
from armproof.course.figures.facts.motions import Motion, motion_of
from armproof.course.figures.registry import Kind
from armproof.models.arm import Arm
from armproof.models.motion.quintic import PEAK_ACCELERATION, PEAK_SPEED
from armproof.models.motion.samples import MotionSamples, sample_motion

SAMPLES = 241
ORDERS = ("q", "v", "w")  # gids: "q theta_1", "v theta_1", "w theta_1"; peaks "peak v theta_1"
_LEFT, _RIGHT, _BOTTOM, _TOP, _GAP = 14.0, 9.0, 9.0, 6.0, 5.0  # mm
_PANEL = 27.0  # mm
_FEW = 3  # joints of which every peak has its number


def peak_times(duration: float) -> tuple[float, float, float]:
    """Return when the quintic accelerates most, is fastest and brakes most (s): t_f (1/2 − √3/6), t_f/2, t_f (1/2 + √3/6).

    Source: course/handouts/quintic-004.md.
    """
    off = sqrt(3) / 6
    return duration * (0.5 - off), duration / 2, duration * (0.5 + off)


@styled()
def quintic_figure(arm: Arm, lang: str = "", motion: Motion | None = None) -> Figure:
    """Return q, q̇ and q̈ of the quintic between two configurations against time; angles in degrees.

    Args:
        motion: the one that the figures of the arm show, if not given.
    """
    motion = motion or motion_of(arm)
    samples = sample_motion(motion.trajectory, np.linspace(0.0, motion.duration, SAMPLES))
    groups = same_unit(arm)
    size: Size = "column" if len(groups) == 1 else "page"
    figure = new_figure(size, _BOTTOM + _TOP + 3 * _PANEL + 2 * _GAP)
    width = WIDTHS[size] / len(groups)
    labels: list[Label] = []
    for column, (kind, joints) in enumerate(groups):
        for order in range(3):
            bottom = _BOTTOM + (2 - order) * (_PANEL + _GAP)
            box = (column * width + _LEFT, bottom, width - _LEFT - _RIGHT, _PANEL)
            labels += _panel(figure, box, motion, samples, kind, joints, order, lang)
    place_labels(figure, labels)
    return figure


def _panel(
    figure: Figure, box: Box, motion: Motion, samples: MotionSamples,
    kind: str, joints: list[int], order: int, lang: str,
) -> list[Label]:  # fmt: skip
    """Draw one derivative of the joints of one kind; returns the labels that it needs."""
    symbol = ("q", r"\dot{q}", r"\ddot{q}")[order]
    time = axis_label(say("time", lang), "s", "t") if order == 2 else ""
    axes = plot_axes(figure, box, lang, time, axis_label("", joint_unit(kind, order), symbol))
    axes.set_xlim(0, motion.duration)
    axes.margins(y=0.16)
    values = (samples.q, samples.v, samples.w)[order]
    for k in joints:
        gid = f"{ORDERS[order]} {motion.arm.joints[k].symbol}"
        axes.plot(samples.times, joint_scales(motion.arm)[k] * values[:, k], gid=gid, **stroke_of(k).line)
    _mark_times(axes, motion.duration, order)
    return _names(axes, motion, joints) if order == 0 else _peaks(axes, motion, kind, joints, order, lang)


def _mark_times(axes: Axes, duration: float, order: int) -> None:
    """Draw a line at each time of a peak, named above the first panel."""
    names = ("$t_1$", "$t_f/2$", "$t_2$")
    for time, name in zip(peak_times(duration), names, strict=True):
        axes.axvline(time, color=GREY, linewidth=0.5, linestyle=(0, (1, 2)), zorder=1)
        if order == 0:
            axes.text(time, 1.03, name, transform=axes.get_xaxis_transform(), ha="center", va="bottom", fontsize=SMALL)


def _names(axes: Axes, motion: Motion, joints: list[int]) -> list[Label]:
    """Return the names of the joints, at the ends of their curves."""
    scales = joint_scales(motion.arm)
    return [
        Label(axes, math(motion.arm.joints[k].symbol), (motion.duration, scales[k] * motion.q_f[k]), (1.0, 0.0), colour=stroke_of(k).colour)
        for k in joints
    ]  # fmt: skip


def _peaks(axes: Axes, motion: Motion, kind: str, joints: list[int], order: int, lang: str) -> list[Label]:
    """Mark the peak of each joint; returns the numbers of all of few joints, of many only the largest."""
    scales = joint_scales(motion.arm)
    found = peak_values(motion)[order - 1]
    largest = max(joints, key=lambda k: abs(found[k]))
    labels = []
    for k in joints:
        stroke, gid = stroke_of(k), f"peak {ORDERS[order]} {motion.arm.joints[k].symbol}"
        times = (peak_times(motion.duration)[1],) if order == 1 else peak_times(motion.duration)[::2]
        values = scales[k] * found[k] * np.array([1.0, -1.0])[: len(times)]
        axes.plot(times, values, stroke.marker, color=stroke.colour, markersize=3.2, zorder=4, gid=gid)
        if found[k] and (k == largest or len(joints) <= _FEW):
            text = with_unit(values[0], joint_unit(kind, order), lang)
            labels.append(Label(axes, text, (times[0], values[0]), (0.4, np.sign(values[0])), SMALL, stroke.colour))
    return labels


def peak_values(motion: Motion) -> tuple[np.ndarray, np.ndarray]:
    """Return the peak velocities 15 Δq / (8 t_f) and accelerations 10 Δq / (√3 t_f²) of the joints, (n,) each.

    Source: course/handouts/quintic-004.md, where they are proved.
    """
    move = motion.q_f - motion.q_0
    return PEAK_SPEED * move / motion.duration, PEAK_ACCELERATION * move / motion.duration**2


def caption(arm: Arm, lang: str = "", motion: Motion | None = None) -> str:
    """Return the caption: both configurations, the duration, the peaks and when they are."""
    motion = motion or motion_of(arm)
    t_1, half, t_2 = (number(time, lang) for time in peak_times(motion.duration))
    speeds, accelerations = peak_values(motion)
    return " ".join(
        (
            say("from_to", lang, start=values_text(arm, motion.q_0, lang), end=values_text(arm, motion.q_f, lang), t_f=number(motion.duration, lang)),
            say("peak_speed", lang, time=half, values=values_text(arm, speeds, lang, 1)),
            say("peak_acceleration", lang, first=t_1, second=t_2, values=values_text(arm, accelerations, lang, 2)),
        )
    )  # fmt: skip


KIND = Kind("quintic", lambda arm, lang: None, quintic_figure, caption)
