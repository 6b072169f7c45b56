"""The textbook's symbols: revolute and prismatic joints seen from any side, links, base and gripper, frames."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from armproof.course.figures.drawing.fitting import SPACING
from armproof.course.figures.drawing.layout import Layout, lay_out
from armproof.course.figures.drawing.scene import Scene
from armproof.course.figures.drawing.style import INK, PALE, PAPER
from armproof.models.arm import Arm

_RADIUS, _LENGTH = 2.2, 6.5  # mm, of a revolute joint
_BOX, _BOX_LENGTH = 2.0, 7.5  # mm: half width and length of a prismatic joint
_AXIS = 9.0  # mm, of an axis of a frame
_ALONG_VIEW = 0.97
AXIS_COLOURS = {"x": "#b03a00", "y": "#00704f", "z": "#00558a"}  # dark enough to read; z, x are also told by letter


@dataclass(frozen=True)
class Look:
    """How an arm is drawn: ink, or one of several strokes.

    Attributes:
        symbols: whether joints have their symbols; without them a dot each.
        base, gripper: whether these are drawn.
        size: of the symbols, 1 for a figure of its own, less for panels.
    """

    colour: str = INK
    alpha: float = 1.0
    width: float = 2.0
    symbols: bool = True
    linestyle: Any = "-"
    zorder: float = 2.0
    base: bool = True
    gripper: bool = True
    size: float = 1.0

    def bare(self) -> Look:
        """Return the look without symbols, base and gripper."""
        return replace(self, symbols=False, base=False, gripper=False)

    @property
    def line(self) -> dict[str, Any]:
        """The colour of its lines."""
        return {"color": self.colour, "alpha": self.alpha}

    @property
    def outline(self) -> dict[str, Any]:
        """The edge of its symbols."""
        return {"edgecolor": self.colour, "alpha": self.alpha, "linewidth": 0.9}


def draw_arm(scene: Scene, arm: Arm, q: np.ndarray, look: Look | None = None, name: str = "") -> Layout:
    """Draw an arm at a configuration (n,): base, links, joints and gripper; returns its layout.

    The lines have the gid "<name>link 0" to "<name>link n", the symbols of joints "<name>joint <symbol>".
    """
    look = look or Look()
    spacing = scene.metres(SPACING * look.size) if look.symbols else 0.0
    layout = lay_out(arm, np.asarray(q, dtype=float), spacing)
    if look.base:
        draw_base(scene, layout, look)
    for k, link in enumerate(layout.links):
        style = {"linewidth": look.width, "linestyle": look.linestyle, "zorder": look.zorder}
        scene.line(link, gid=f"{name}link {k}", **look.line, **style)
    for joint, placed, spot in zip(arm.joints, layout.joints, layout.spots, strict=True):
        draw_joint(scene, joint.kind, spot, np.array(placed.axis), look, f"{name}joint {joint.symbol}")
    if look.gripper:
        draw_gripper(scene, layout.gripper, layout.gripper_way, look)
    return layout


def draw_joint(scene: Scene, kind: str, at: np.ndarray, axis: np.ndarray, look: Look, gid: str = "") -> None:
    """Draw the symbol of a joint; without symbols, a dot."""
    point = scene.paper(at)
    mark = scene.flat_line(point[None], gid=gid, zorder=look.zorder + 2, linestyle="none", **look.line)
    if not look.symbols:
        mark.set_marker("o" if kind == "revolute" else "s")
        mark.set_markersize(3)
    elif kind == "revolute":
        _revolute(scene, at, axis, look)
    else:
        _prismatic(scene, at, axis, look)


def _revolute(scene: Scene, at: np.ndarray, axis: np.ndarray, look: Look) -> None:
    """Draw a cylinder about the axis, a circle with its centre where the axis points at the reader."""
    style, point = look.outline, scene.paper(at)
    cosine = scene.projection.along(axis)
    z = look.zorder + 0.5
    if abs(cosine) > _ALONG_VIEW:
        scene.circle(point, 1.9 * look.size, zorder=z, **style)
        scene.circle(point, 0.45 * look.size, zorder=z + 0.1, facecolor=look.colour, alpha=look.alpha, edgecolor="none")
        return
    toward = axis if cosine >= 0 else -axis
    half = scene.paper(toward) * scene.metres(look.size * _LENGTH / 2)
    rim = _rim(scene, toward, scene.metres(look.size * _RADIUS))
    scene.fill(point + _swept(rim, half), zorder=z, **style)
    scene.fill(point + half + rim, zorder=z + 0.1, **{**style, "facecolor": PALE})


def _prismatic(scene: Scene, at: np.ndarray, axis: np.ndarray, look: Look) -> None:
    """Draw a box about the axis, its faces towards the reader."""
    first, second = _across(axis)
    sides = [(axis, look.size * _BOX_LENGTH / 2), (first, look.size * _BOX), (second, look.size * _BOX)]
    for k, (way, size) in enumerate(sides):
        cosine = scene.projection.along(way)
        if abs(cosine) < 1e-6:
            continue
        (one, a), (other, b) = (sides[(k + j) % 3] for j in (1, 2))
        middle = at + np.sign(cosine) * scene.metres(size) * way
        corners = np.array([a * s * one + b * t * other for s, t in ((1, 1), (1, -1), (-1, -1), (-1, 1))])
        style = {**look.outline, "joinstyle": "round", "facecolor": PALE if k == 0 else PAPER}
        scene.fill(scene.paper(middle + scene.metres(1.0) * corners), zorder=look.zorder + 0.5, **style)


def draw_base(scene: Scene, layout: Layout, look: Look) -> None:
    """Draw the ground below an arm: a hatched line, below a pin where the arm starts across the paper."""
    at = scene.paper(layout.base)
    way = scene.paper(layout.base_way)
    if np.linalg.norm(way) < 0.2:
        drop = scene.metres(4.6 * look.size)
        feet = at + np.array([[-scene.metres(2.7 * look.size), -drop], [scene.metres(2.7 * look.size), -drop]])
        scene.fill(np.vstack([at, feet]), zorder=look.zorder - 0.2, **look.outline)
        at, way = at - np.array([0.0, drop]), np.array([0.0, 1.0])
    way = way / np.linalg.norm(way)
    along = np.array([way[1], -way[0]])
    reach = scene.metres(4.2 * look.size)
    scene.flat_line(np.array([at - reach * along, at + reach * along]), zorder=look.zorder, linewidth=1.2, **look.line)
    slant = scene.metres(1.7 * look.size) * (-way - along) / np.sqrt(2)
    for part in np.linspace(-0.8, 1.0, 7):
        foot = at + part * reach * along
        scene.flat_line(np.array([foot, foot + slant]), zorder=look.zorder, linewidth=0.6, **look.line)


def draw_gripper(scene: Scene, at: np.ndarray, way: np.ndarray, look: Look) -> None:
    """Draw a gripper of two jaws that points along a unit vector, the point at its palm."""
    point, flat = scene.paper(at), scene.paper(way)
    size = float(np.linalg.norm(flat))
    if size < 0.2:  # it points at the reader, or away
        return
    flat = flat / size
    across = np.array([-flat[1], flat[0]]) * scene.metres(1.7 * look.size)
    ahead = flat * scene.metres(2.8 * look.size)
    jaws = np.array([point + across + ahead, point + across, point - across, point - across + ahead])
    scene.flat_line(jaws, linewidth=0.7 * look.width, zorder=look.zorder, **look.line)


def axis_name(letter: str, frame: str) -> str:
    """Return the name of an axis of a frame: $x_{4}$; a frame with a name of many letters has it upright."""
    index = frame if len(frame) < 3 or frame == "i-1" else rf"\mathrm{{{frame.replace('_', '-')}}}"
    return f"${letter}_{{{index}}}$"


def _across(axis: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return two unit vectors across an axis and each other."""
    helper = np.eye(3)[int(np.argmin(np.abs(np.round(axis, 6))))]
    first = np.cross(axis, helper)
    first /= np.linalg.norm(first)
    return first, np.cross(axis, first)


def _rim(scene: Scene, axis: np.ndarray, radius: float) -> np.ndarray:
    """Return the rim of a disc across an axis as an ellipse on the paper about (0, 0), (N, 2)."""
    first, second = _across(axis)
    angles = np.linspace(0, 2 * np.pi, 48, endpoint=False)
    circle = np.cos(angles)[:, None] * first + np.sin(angles)[:, None] * second
    return radius * scene.paper(circle)


def _swept(rim: np.ndarray, half: np.ndarray) -> np.ndarray:
    """Return the outline of what an ellipse about (0, 0), (N, 2), passes over from −half to half."""
    rim = np.roll(rim, -int(np.argmax(rim @ np.array([-half[1], half[0]]))), axis=0)  # begins where it is widest across
    turn = len(rim) // 2  # where it is widest on the other side
    end = half * np.sign(rim[turn // 2] @ half)
    return np.vstack([rim[: turn + 1] + end, rim[turn:] - end, rim[:1] - end])


def draw_frames(scene: Scene, frames: Mapping[str, np.ndarray], letters: str = "xyz") -> None:
    """Draw frames, each a pose (4, 4), with the names of their axes.

    An arrow has the gid "frame 0 x", or "frame 0 x; frame 1 x" where two axes are one.
    """
    axes: dict[tuple[float, ...], list[tuple[str, str]]] = {}  # letter and frame, by the origin and the direction
    for letter in letters:
        for name, X_0F in frames.items():
            place = np.round([*X_0F[:3, 3], *X_0F[:3, "xyz".index(letter)]], 7) + 0.0
            axes.setdefault(tuple(place), []).append((letter, name))
    for names in axes.values():
        _draw_axis(scene, frames, names)


def _draw_axis(scene: Scene, frames: Mapping[str, np.ndarray], names: list[tuple[str, str]]) -> None:
    """Draw the axes of one origin and one direction."""
    letters = {letter for letter, _ in names}
    colour = AXIS_COLOURS[min(letters)] if len(letters) == 1 else INK
    thin = letters == {"y"}
    gid = "; ".join(f"frame {name} {letter}" for letter, name in names)
    letter, name = names[0]
    X_0F = frames[name]
    origin, way = X_0F[:3, 3], X_0F[:3, "xyz".index(letter)]
    tip = scene.arrow(
        origin, scene.metres(0.85 * _AXIS if thin else _AXIS) * way, colour=colour, gid=gid, width=0.6 if thin else 0.9
    )
    text = ", ".join(axis_name(letter, name) for letter, name in sorted(names))
    scene.label(text, tip, scene.paper(way), colour=colour, gap=0.4)
