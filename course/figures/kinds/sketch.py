"""The kinematic sketch of an arm: its symbols, its frames, and the parameters between them as dimensions."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from armproof.course.figures.drawing.dimensions import draw_angle, draw_lengths, draw_turn
from armproof.course.figures.drawing.fitting import Fit
from armproof.course.figures.drawing.labels import length, listed, math, say, values_text
from armproof.course.figures.drawing.layout import Layout
from armproof.course.figures.drawing.scene import Scene, finish
from armproof.course.figures.drawing.style import WIDTHS, new_figure, styled
from armproof.course.figures.drawing.symbols import draw_arm, draw_frames
from armproof.course.figures.drawing.table import dh_texts, draw_table, table_height
from armproof.course.figures.facts.dh_rows import LinkRows, chain_frames, link_rows
from armproof.course.figures.facts.lengths import frame_lengths
from armproof.course.figures.facts.poses import showing_pose, zero_pose
from armproof.course.figures.facts.task import tool_frame
from armproof.course.figures.registry import Kind
from armproof.models.arm import Arm
from armproof.models.dh.entry import LinearForm
from armproof.models.showing.projection import choose_projection

_TABLE = 56.0  # mm, beside the drawing of a page
_HEIGHTS = (50.0, 125.0)  # mm, of the drawing
_LONGEST = 62.0  # mm, of a link
_BEYOND = 7.5  # mm from a joint's symbol to the arrow of its turning


@styled()
def sketch(arm: Arm, lang: str = "", *, table: bool = True) -> Figure:
    """Return the kinematic sketch of an arm: planar arms in their plane, spatial ones from a fixed side.

    Joints and links are drawn in the textbook's symbols at a pose at which they are well seen, with the frames of the arm;
    where these are DH frames, the figure has the table of a_i, α_i, d_i, θ_i, and each is dimensioned in the drawing:
    d along z, a along x, θ about z, α about x. Elsewhere the way from each frame to the next is dimensioned along its axes.

    Args:
        table: whether the table stands beside the drawing; a lesson that asks for it leaves it out.

    Raises:
        LanguageError: a language that the labels are not written in.
    """
    rows, q = link_rows(arm), sketch_pose(arm)
    figure, scene = _page(arm, rows if table else None, q, lang)
    layout = draw_arm(scene, arm, q)
    draw_frames(scene, {name: layout.frames[name] for name in shown_frames(arm)})
    _draw_joint_variables(scene, arm, layout)
    if rows is not None:
        _draw_twists(scene, rows, layout)
    draw_lengths(scene, frame_lengths(arm, shown_frames(arm), layout.frames), lang)
    return finish(figure, scene)


def sketch_pose(arm: Arm) -> np.ndarray:
    """Return the configuration of the sketch: bent for planar arms, where angles are seen; zero for spatial ones."""
    return showing_pose(arm) if choose_projection(arm).planar else zero_pose(arm)


def shown_frames(arm: Arm) -> tuple[str, ...]:
    """Return the frames of the sketch: that of each joint, and the tool's."""
    return tuple(dict.fromkeys((*chain_frames(arm), tool_frame(arm))))


def _page(arm: Arm, rows: LinkRows | None, q: np.ndarray, lang: str) -> tuple[Figure, Scene]:
    """Return a figure with the DH table, and the scene of the drawing, as high as it needs.

    Planar arms take a column with the table below, others a page with the table on the right.
    """
    planar = choose_projection(arm).planar
    table = [] if rows is None else dh_texts(rows, lang)
    below = table_height(len(table)) + 3.0 if planar and table else 0.0
    width = WIDTHS["column"] if planar else WIDTHS["page"] - (_TABLE if table else 0.0)
    fit = Fit(arm, q, margin=15.0 if planar else 18.0)
    height = fit.height(width, _HEIGHTS, _LONGEST)
    figure = new_figure("column" if planar else "page", height + below)
    if table and planar:
        draw_table(figure, table, left=0.0, top=below - 1.0, width=width)
    elif table:
        draw_table(figure, table, left=width - 2.0, top=(height + table_height(len(table))) / 2, width=_TABLE)
    return figure, fit.scene(figure, (0.0, below, width, height))


def _draw_joint_variables(scene: Scene, arm: Arm, layout: Layout) -> None:
    """Draw the angle of each revolute joint: between the x axes in the plane, else as the sense of turning."""
    frames = chain_frames(arm)
    for k, joint in enumerate(arm.joints):
        if joint.kind != "revolute":
            continue
        axis, text, gid = np.array(layout.joints[k].axis), math(joint.symbol), f"angle {joint.symbol}"
        if scene.projection.planar and len(frames) == len(arm.joints) + 1:
            x, x_next = (layout.frames[frame][:3, 0] for frame in frames[k : k + 2])
            angle = float(np.arctan2(np.cross(x, x_next) @ axis, x @ x_next))
            if abs(angle) > np.radians(8) and abs(x @ axis) < 1e-9:
                draw_angle(scene, layout.spots[k], x, axis, angle, text, radius=12.0, gid=gid)
                continue
        draw_turn(scene, _turning_point(scene, layout, k), axis, text, gid=gid)


def _turning_point(scene: Scene, layout: Layout, k: int) -> np.ndarray:
    """Return where on the axis of a joint its sense of turning is drawn: beyond the symbol, on the side without links."""
    axis, spot = np.array(layout.joints[k].axis), layout.spots[k]
    if abs(scene.projection.along(axis)) > 0.97:
        return spot
    others = np.vstack([*layout.links, *(X[None, :3, 3] for X in layout.frames.values())])
    used = [np.min(np.linalg.norm(others - (spot + s * scene.metres(_BEYOND) * axis), axis=1)) for s in (1, -1)]
    return np.asarray(spot + (1 if used[0] >= used[1] - 1e-9 else -1) * scene.metres(_BEYOND) * axis)


def _draw_twists(scene: Scene, rows: LinkRows, layout: Layout) -> None:
    """Draw the angle α between successive z axes, about the x axis that carries a."""
    modified = rows.convention == "modified"
    at: dict[tuple[float, ...], int] = {}
    for row in rows.rows:
        if row.alpha == LinearForm():
            continue
        before, after = layout.frames[row.previous], layout.frames[row.frame]
        axis = before[:3, 0] if modified else after[:3, 0]
        centre = before[:3, 3] + ((after - before)[:3, 3] @ axis) * axis if modified else after[:3, 3]
        z, z_next = before[:3, 2], after[:3, 2]
        angle = float(np.arctan2(np.cross(z, z_next) @ axis, z @ z_next))
        place = tuple(np.round(centre, 9))
        at[place] = at.get(place, 0) + 1
        index = row.previous if modified else row.frame
        text = rf"$\alpha_{{{index}}}$"
        draw_angle(
            scene, centre, z, axis, angle, text, radius=4.4 + 1.6 * at[place], gid=f"twist {index}", colour="#7a4a9c"
        )


def caption(arm: Arm, lang: str = "") -> str:
    """Return the caption of the sketch: its frames, the pose, and the lengths of the model."""
    rows = link_rows(arm)
    q = sketch_pose(arm)
    parts = [
        say(f"frames_{rows.convention}" if rows else "frames_own", lang),
        say("drawn_at", lang, pose=values_text(arm, q, lang)),
    ]
    if arm.lengths:
        lengths = [f"{math(symbol)} = {length(value, lang)}" for symbol, value in arm.lengths.items()]
        parts.append(say("lengths_are", lang, lengths=listed(lengths, lang)))
    return " ".join(parts)


KIND = Kind("sketch", lambda arm, lang: None, sketch, caption)
