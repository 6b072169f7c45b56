"""The postures in which an arm reaches one target, laid over each other."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from armproof.course.figures.drawing.fitting import Fit
from armproof.course.figures.drawing.labels import joint_texts, joint_value, length, math, say, values_text
from armproof.course.figures.drawing.layout import Layout, lay_out
from armproof.course.figures.drawing.panels import PanelTitle, columns_of, make_panels
from armproof.course.figures.drawing.scene import Scene, finish
from armproof.course.figures.drawing.style import GREY, PALE, SMALL, TEXT, WIDTHS, new_figure, stroke_of, styled
from armproof.course.figures.drawing.symbols import AXIS_COLOURS, Look, draw_arm
from armproof.course.figures.drawing.table import draw_table, table_height
from armproof.course.figures.facts.branches import branch_of, corners_of
from armproof.course.figures.facts.solutions import STARTS, Postures, is_square, postures_of
from armproof.course.figures.facts.task import task_of
from armproof.course.figures.registry import Kind
from armproof.models.arm import Arm
from armproof.models.numeric.plant import NumericKinematics
from armproof.models.showing.projection import plane_projection

_FEW = 2  # postures that are drawn in one picture, with a table
_MOST = 8  # that have a panel each
_MARGIN = 11.0  # mm
_LOWEST, _HIGHEST = 40.0, 62.0  # mm, of a panel
_SIZE = 0.7
_TRIAD = 6.0  # mm, of the axes of the tool


@styled()
def postures(arm: Arm, lang: str = "") -> Figure:
    """Return the postures of an arm laid over each other on one target, in different strokes.

    Two are drawn in one picture above a table of their joint values; of more, a first panel has all and each further panel
    one of them in full, the others pale behind it.

    Raises:
        LanguageError: a language that the labels are not written in.
    """
    found = postures_of(arm)
    return _draw_few(arm, found, lang) if len(found.q) <= _FEW else _draw_panels(arm, found, lang)


def _draw_few(arm: Arm, found: Postures, lang: str) -> Figure:
    table = [["", *(math(joint.symbol) for joint in arm.joints)]]
    for number, q in enumerate(found.q, start=1):
        values = [joint_value(value, joint.kind, lang) for joint, value in zip(arm.joints, q, strict=True)]
        table.append([str(number), *values])
    below = table_height(len(table)) + 2.0
    width = WIDTHS["column"]
    fit = _fit(arm, found.q, 0.8)
    height = fit.height(width, (_LOWEST, 75.0))
    figure = new_figure("column", height + below)
    draw_table(figure, table, left=0.0, top=below - 1.0, width=width)
    scene = fit.scene(figure, (0.0, below, width, height))
    for k, q in enumerate(found.q):
        _draw_posture(scene, arm, q, k, symbols=True, size=0.8, number=True)
    _draw_target(scene, arm, found, lang)
    return finish(figure, scene)


def _draw_panels(arm: Arm, found: Postures, lang: str) -> Figure:
    shown = found.q[:_MOST]
    titles = [PanelTitle(say("all_postures", lang, count=len(found.q)), [])]
    for number, q in enumerate(shown, start=1):
        facts = joint_texts(arm, q, lang)
        if not found.within_limits[number - 1]:
            facts.append(say("beyond_limits", lang))
        named = ", ".join(say(key, lang) for key in branch_of(arm, q))
        titles.append(PanelTitle(f"{number}) {named}" if named else f"{say('posture', lang)} {number}", facts))
    width = WIDTHS["page"] / columns_of(len(titles))
    fit = Fit(
        arm, shown, margin=_MARGIN, size=_SIZE
    )  # from the side: seen along parallel axes, turned wrists look alike
    height = fit.height(width, (_LOWEST, _HIGHEST))
    figure, panels = make_panels(titles, height)
    view = fit.view(width, height)
    scenes = [Scene.show(figure, panel.box, view) for panel in panels]
    for k, q in enumerate(shown):
        _draw_posture(scenes[0], arm, q, k, symbols=False, size=_SIZE)
        for pale in shown:
            _draw_pale(scenes[k + 1], arm, pale)
        layout = _draw_posture(scenes[k + 1], arm, q, k, symbols=True, size=_SIZE)
        _draw_tool(scenes[k + 1], layout.frames[task_of(arm).frame])
        _name_corners(scenes[k + 1], arm, q)
    _draw_target(scenes[0], arm, found, lang)
    return finish(figure, *scenes)


def _fit(arm: Arm, q: np.ndarray, size: float) -> Fit:
    """Return how the arm is fitted to its paper: seen along its parallel axes if it has such, else as it is otherwise."""
    return Fit(arm, q, plane_projection(arm), margin=_MARGIN, size=size)


def _draw_posture(
    scene: Scene, arm: Arm, q: np.ndarray, k: int, *, symbols: bool, size: float, number: bool = False
) -> Layout:
    stroke = stroke_of(k)
    look = Look(stroke.colour, 1.0, 1.6, symbols=symbols, linestyle=stroke.linestyle, size=size)
    layout = draw_arm(scene, arm, q, look, name=f"posture {k + 1} ")
    if number:  # beside the link that starts highest, where the postures are apart
        middle = np.mean(layout.links[1][:2], axis=0)
        scene.label(str(k + 1), middle, colour=stroke.colour, gap=1.0)
    return layout


def _draw_tool(scene: Scene, pose: np.ndarray) -> None:
    """Draw the axes of the tool, which are the same in all postures."""
    for k, (letter, colour) in enumerate(AXIS_COLOURS.items()):
        scene.arrow(
            pose[:3, 3], scene.metres(_TRIAD) * pose[:3, k], colour=colour, width=0.7, gid=f"tool {letter}", head=0.7
        )


def _name_corners(scene: Scene, arm: Arm, q: np.ndarray) -> None:
    """Name shoulder, elbow and wrist of an arm whose last three axes meet."""
    for key, at in corners_of(arm, q).items():
        scene.label(key[0].upper(), at, gap=2.0, size=SMALL, colour=GREY)


def _draw_pale(scene: Scene, arm: Arm, q: np.ndarray) -> None:
    """Draw the links of a posture as one pale line, behind the others."""
    links = lay_out(arm, q, 0.0).links
    gap = np.full((1, 3), np.nan)
    scene.line(np.vstack([part for link in links for part in (link, gap)]), color=PALE, linewidth=1.0, zorder=1.5)


def _draw_target(scene: Scene, arm: Arm, found: Postures, lang: str) -> None:
    task = task_of(arm)
    X_0T = NumericKinematics(arm, found.target[None]).pose(task.frame)[0]
    at = scene.paper(X_0T[:3, 3])
    scene.circle(at, 1.1, zorder=8, facecolor="none", edgecolor=GREY, linewidth=1.0)
    for way in (np.array([1.0, 0.0]), np.array([0.0, 1.0])):
        ends = np.array([at - scene.metres(2.0) * way, at + scene.metres(2.0) * way])
        scene.flat_line(ends, color=GREY, linewidth=0.7, zorder=8, gid="target")
    scene.label(say("target", lang), at, gap=2.0, size=TEXT)


def reason(arm: Arm, lang: str) -> str | None:
    """Return why an arm has no such figure; None if several postures reach a target."""
    if not is_square(arm):
        return say("many_postures", lang, joints=len(arm.joints), rows=len(task_of(arm).rows))
    return say("one_posture", lang) if len(postures_of(arm).q) < 2 else None


def caption(arm: Arm, lang: str = "") -> str:
    """Return the caption: the target, and the joint values of each posture."""
    found = postures_of(arm)
    point = NumericKinematics(arm, found.target[None]).pose(task_of(arm).frame)[0, :3, 3]
    target = f"$x$ = {length(point[0], lang)}, $y$ = {length(point[1], lang)}, $z$ = {length(point[2], lang)}"
    parts = [
        say("postures_caption", lang, count=len(found.q), target=target),
        say("by_formula", lang) if found.found == "formula" else say("by_iteration", lang, starts=STARTS),
    ]
    if corners_of(arm, found.target):
        parts.append(say("corners_are", lang))
    for number, q in enumerate(found.q, start=1):
        parts.append(say("posture_caption", lang, number=number, pose=values_text(arm, q, lang)))
    return " ".join(parts)


KIND = Kind("postures", reason, postures, caption)
