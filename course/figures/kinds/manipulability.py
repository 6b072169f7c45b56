"""The manipulability of an arm over the joints on which it depends most, with its singular curves and its level lines."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from armproof.course.figures.drawing.labels import (
    axis_label,
    joint_scales,
    joint_texts,
    joint_unit,
    joint_value,
    listed,
    number,
    say,
)
from armproof.course.figures.drawing.maps import curve_style, draw_map, plain_condition
from armproof.course.figures.drawing.placement import Label, place_labels
from armproof.course.figures.drawing.plots import mark_angles, plot_axes
from armproof.course.figures.drawing.style import STROKES, TEXT, Stroke, new_figure, styled
from armproof.course.figures.facts.families import determinant_of
from armproof.course.figures.facts.joint_map import (
    JointMap,
    family_lines,
    family_zeros,
    highest_near,
    joint_map,
    shown_families,
)
from armproof.course.figures.facts.task import volume_unit
from armproof.course.figures.registry import Kind
from armproof.models.arm import Arm
from armproof.verification.latex.writer import symbol_as_latex
from armproof.verification.singularities.families import Family

_SHOWN = 2  # every second configuration of each axis is printed
_WIDTH, _HEIGHT = 52.0, 46.0  # mm
_LEFT, _BOTTOM, _TOP = 14.0, 10.0, 5.0
_ENTRY = 3.6  # mm, of a line of the legend


@styled()
def manipulability_figure(arm: Arm, lang: str = "") -> Figure:
    """Return the manipulability of an arm over two joints as a map, or over the one on which it depends as a curve."""
    found = joint_map(arm)
    if len(found.joints) == 2:
        return _map_figure(found, lang)
    figure = new_figure("column", _HEIGHT + _BOTTOM + _TOP)
    place_labels(figure, _draw_curve(figure, found, lang))
    return figure


def _joint_label(arm: Arm, k: int) -> str:
    return axis_label("", joint_unit(arm.joints[k].kind), symbol_as_latex(arm.joints[k].symbol))


def _scaled(found: JointMap) -> list[np.ndarray]:
    """Return the values of the joints of the map as a reader has them: degrees, metres."""
    scales = joint_scales(found.task.arm)
    return [scales[k] * axis for k, axis in zip(found.joints, found.axes, strict=True)]


def _w_label(found: JointMap, lang: str) -> str:
    arm = found.task.arm
    unit = volume_unit(arm, found.task.rows, range(1, len(arm.joints) + 1))
    return axis_label(say("manipulability_word", lang), unit, "w")


def _map_figure(found: JointMap, lang: str) -> Figure:
    arm = found.task.arm
    families = [(family, family_lines(found, family)) for family in shown_families(found)]
    families = [(family, lines) for family, lines in families if lines]
    figure = new_figure("column", _HEIGHT + _BOTTOM + _TOP + _ENTRY * len(families))
    box = (_LEFT, _BOTTOM, _WIDTH, _HEIGHT)
    axes = plot_axes(figure, box, lang, *(_joint_label(arm, k) for k in found.joints), grid=False)
    x, y = _scaled(found)
    for which, values, k in zip("xy", (x, y), found.joints, strict=True):
        if arm.joints[k].kind == "revolute":
            mark_angles(axes, which, float(np.ptp(values)))
    scale, w = (_LEFT + _WIDTH + 3, _BOTTOM, 3.0, _HEIGHT), found.w[::_SHOWN, ::_SHOWN]
    highest, edges, label = float(found.w.max()), (x[0], x[-1], y[0], y[-1]), _w_label(found, lang)
    draw_map(figure, axes, scale, x[::_SHOWN], y[::_SHOWN], w, highest, label, lang, "w", extent=edges)
    axes.set(xlim=(x[0], x[-1]), ylim=(y[0], y[-1]))
    for k, (family, lines) in enumerate(families):
        _draw_family(axes, found, family, lines, k)
    if families:
        axes.legend(loc="lower left", bbox_to_anchor=(0.0, 1.01), borderaxespad=0.0, fontsize=TEXT, handlelength=3.0)
    return figure


def _draw_family(axes: Axes, found: JointMap, family: Family, lines: list[np.ndarray], k: int) -> None:
    scales = joint_scales(found.task.arm)[list(found.joints)]
    points = np.vstack([part for line in lines for part in (scales * line, np.full((1, 2), np.nan))][:-1])
    label, gid = f"${plain_condition(family.latex)}$", f"singular {family.latex}"
    axes.plot(points[:, 0], points[:, 1], label=label, gid=gid, **curve_style(k))


def _draw_curve(figure: Figure, found: JointMap, lang: str) -> list[Label]:
    """Draw w against one joint, with its zeros and its maxima marked."""
    arm, k = found.task.arm, found.joints[0]
    box = (_LEFT + 2, _BOTTOM, _WIDTH + 12, _HEIGHT)
    axes = plot_axes(figure, box, lang, _joint_label(arm, k), _w_label(found, lang))
    (x,) = _scaled(found)
    if arm.joints[k].kind == "revolute":
        mark_angles(axes, "x", float(np.ptp(x)), 8)
    axes.plot(x, found.w, color=STROKES[0].colour, gid="w")
    axes.set(xlim=(x[0], x[-1]), ylim=(0, 1.15 * float(found.w.max())))
    labels = []
    for family in shown_families(found):
        for zero in family_zeros(found, family):
            at = joint_scales(arm)[k] * zero
            text = f"${plain_condition(family.latex)}$"
            _mark(axes, at, 0.0, STROKES[1], f"singular {family.latex}")
            labels.append(Label(axes, text, (at, 0.0), (0.6, 1.0), colour=STROKES[1].colour, gap=5))
    for start in _peaks(found.w):
        at, w = highest_near(found, (start,))
        x_at = joint_scales(arm)[k] * at[k]
        _mark(axes, x_at, w, STROKES[0], "peak")
        text = f"{number(w, lang)} ({joint_value(at[k], arm.joints[k].kind, lang)})"
        labels.append(Label(axes, text, (x_at, w), (0.0, 1.0)))
    return labels


def _mark(axes: Axes, x: float, y: float, stroke: Stroke, gid: str) -> None:
    axes.plot([x], [y], marker=stroke.marker, color=stroke.colour, markersize=4, clip_on=False, zorder=6, gid=gid)


def _peaks(w: np.ndarray) -> list[int]:
    """Return where w is highest of what is around it."""
    inner = [k for k in range(1, len(w) - 1) if w[k] >= w[k - 1] and w[k] > w[k + 1]]
    ends = [k for k, beside in ((0, 1), (len(w) - 1, len(w) - 2)) if w[k] > w[beside]]
    return [k for k in inner + ends if w[k] > 0.8 * w.max()]


def caption(arm: Arm, lang: str = "") -> str:
    """Return the caption: over which joints, how many configurations, the highest value and where, the other joints, the determinant."""
    found = joint_map(arm)
    place = np.unravel_index(int(np.argmax(found.w)), found.w.shape)[::-1]
    at, highest = highest_near(found, tuple(int(k) for k in place))
    unit = volume_unit(arm, found.task.rows, range(1, len(arm.joints) + 1))
    names = ", ".join(f"${symbol_as_latex(arm.joints[k].symbol)}$" for k in found.joints)
    parts = [
        say("w_over", lang, joints=names, count="10^6" if len(found.joints) == 2 else str(found.w.size)),
        say("w_highest", lang, value=f"{number(highest, lang)} {unit}".strip(), at=_texts(arm, at, found.joints, lang)),
    ]
    others = [k for k in found.relevant if k not in found.joints]
    if others:
        parts.append(say("other_joints", lang, values=_texts(arm, found.base, sorted(others), lang)))
    if factored := determinant_of(arm):
        parts.append(say("determinant_is", lang, latex=factored))
    return " ".join(parts)


def _texts(arm: Arm, q: np.ndarray, joints: Iterable[int], lang: str) -> str:
    """Return the values of some joints in words."""
    return listed([joint_texts(arm, q, lang)[k] for k in joints], lang)


KIND = Kind("manipulability", lambda arm, lang: None, manipulability_figure, caption)
