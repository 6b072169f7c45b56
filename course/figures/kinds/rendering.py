"""A 3D picture of an arm rendered by Drake, with its document frames drawn over it."""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from armproof.course.figures.drawing.fitting import drawn_points
from armproof.course.figures.drawing.labels import say, values_text
from armproof.course.figures.drawing.placement import Label, place_labels
from armproof.course.figures.drawing.style import PAPER, WIDTHS, mm_axes, new_figure, styled
from armproof.course.figures.drawing.symbols import AXIS_COLOURS
from armproof.course.figures.facts.poses import showing_pose
from armproof.course.figures.registry import Kind
from armproof.models.arm import Arm
from armproof.models.errors import ModelError
from armproof.models.showing.projection import axonometric
from armproof.models.showing.rendering import ArmRenderer, Camera, look_at, require_renderer
from armproof.models.showing.skeleton import place_skeleton

_PIXELS = 1000
_FIELD_OF_VIEW = 0.45  # rad
_ROOM = 1.6  # times the radius of the arm's joints: what its body may stick out
_STEPS_BACK = 8
_SMALL = 160  # pixels
_FULL = 0.93  # of half the picture: what the arm fills
_FRAME = 0.09  # of the arm's size: the length of an axis
_MARGIN = 7.0  # mm
_HIGHEST = 92.0  # mm
_SAME = 4.0  # pixels: origins nearer than that have one label


@lru_cache(maxsize=8)
def rendered(arm: Arm, q: tuple[float, ...]) -> tuple[np.ndarray, Camera]:
    """Return the picture of an arm at a configuration on white, and its camera.

    Raises:
        ModelError: the arm has no shape, or this machine cannot render.
    """
    points = drawn_points(arm, np.array(q))
    target = (points.min(axis=0) + points.max(axis=0)) / 2
    radius = max(float(np.linalg.norm(points - target, axis=1).max()), 0.05)
    toward = axonometric().toward
    distance = _distance(arm, q, target, _ROOM * radius / np.sin(_FIELD_OF_VIEW / 2))
    camera = look_at(target, toward, distance, _PIXELS, _PIXELS, _FIELD_OF_VIEW)
    image = _renderer(arm).image(np.array(q), camera)
    image.flags.writeable = False
    return image, camera


def _distance(arm: Arm, q: tuple[float, ...], target: np.ndarray, distance: float) -> float:
    """Return how far the camera is for the arm's body to fill the picture, by small pictures from farther and farther away."""
    for _ in range(_STEPS_BACK):
        camera = look_at(target, axonometric().toward, distance, _SMALL, _SMALL, _FIELD_OF_VIEW)
        inked = _inked(_renderer(arm).image(np.array(q), camera))
        places = np.argwhere(inked) - (_SMALL - 1) / 2
        filled = float(np.abs(places).max(initial=0.0)) / (_SMALL / 2)
        if filled < _FULL:
            return distance * max(filled / _FULL, 0.2)
        distance *= 1.6
    return distance


def _inked(image: np.ndarray) -> np.ndarray:
    """Return which pixels (…, 3) are not white."""
    return np.asarray((image < 250).any(axis=-1))


@lru_cache(maxsize=2)
def _renderer(arm: Arm) -> ArmRenderer:
    return ArmRenderer(arm)


@styled()
def rendering_figure(arm: Arm, lang: str = "", q: np.ndarray | None = None) -> Figure:
    """Return the picture of an arm with the axes x, y, z of its frames.

    Args:
        q: (n,), base to tool (rad, m); a configuration at which the arm is well seen, if not given.

    Raises:
        ModelError: the arm has no shape, or this machine cannot render.
    """
    configuration = showing_pose(arm) if q is None else np.asarray(q, dtype=float)
    image, camera = rendered(arm, tuple(configuration.tolist()))
    left, bottom, right, top = _window(image, arm, configuration, camera)
    scale = min(
        (WIDTHS["column"] - 2 * _MARGIN) / (right - left), (_HIGHEST - 2 * _MARGIN) / (top - bottom)
    )  # mm a pixel
    height = scale * (top - bottom) + 2 * _MARGIN
    figure = new_figure("column", height)
    axes = mm_axes(figure, 0, 0, WIDTHS["column"], height)
    axes.set_axis_off()
    shown = axes.imshow(
        image, extent=(-0.5, camera.width - 0.5, camera.height - 0.5, -0.5), interpolation="antialiased"
    )
    shown.set_gid("picture")
    middle = (left + right) / 2
    wide, high = WIDTHS["column"] / 2 / scale, height / 2 / scale
    axes.set(xlim=(middle - wide, middle + wide), ylim=((top + bottom) / 2 + high, (top + bottom) / 2 - high))
    place_labels(figure, _draw_frames(axes, arm, configuration, camera))
    return figure


def _window(image: np.ndarray, arm: Arm, q: np.ndarray, camera: Camera) -> tuple[float, float, float, float]:
    """Return the part of the picture with the arm and its frames: left, top, right, bottom (pixels)."""
    rows, columns = np.nonzero(_inked(image))
    tips = np.vstack([camera.pixels(points) for points in frame_axes(arm, q).values()])
    across, down = np.append(columns, tips[:, 0]), np.append(rows, tips[:, 1])
    return float(across.min()), float(down.min()), float(across.max()), float(down.max())


def frame_axes(arm: Arm, q: np.ndarray) -> dict[str, np.ndarray]:
    """Return the origin of each frame and the tips of its axes x, y, z as they are drawn, (4, 3), in frame 0 (m)."""
    points = drawn_points(arm, q)
    length = _FRAME * float(np.linalg.norm(np.ptp(points, axis=0)))
    frames = place_skeleton(arm, q).frames
    return {name: np.vstack([X[:3, 3], X[:3, 3] + length * X[:3, :3].T]) for name, X in frames.items()}


def _draw_frames(axes: Axes, arm: Arm, q: np.ndarray, camera: Camera) -> list[Label]:
    """Draw the axes of all frames; returns the names of the frames at their origins, and of the axes of the first frame."""
    origins: list[tuple[np.ndarray, list[str]]] = []
    labels = []
    for place, (name, points) in enumerate(frame_axes(arm, q).items()):
        origin, *tips = camera.pixels(points)
        for letter, tip in zip("xyz", tips, strict=True):
            colour, way = AXIS_COLOURS[letter], (tip - origin) * np.array([1.0, -1.0])
            _arrow(axes, origin, tip, colour, f"frame {name} {letter}")
            if place == 0:
                labels.append(Label(axes, f"${letter}_{{{name}}}$", tuple(tip), tuple(way), colour=colour))
        near = next((names for at, names in origins if np.linalg.norm(at - origin) < _SAME), None)
        if near is None:
            origins.append((origin, near := []))
        near.append(f"$O_{{{name}}}$")
    return labels + [Label(axes, ", ".join(names), (at[0], at[1]), (-1.0, 0.3), gap=4.0) for at, names in origins]


def _arrow(axes: Axes, start: np.ndarray, tip: np.ndarray, colour: str, gid: str) -> None:
    ends = np.array([start, tip]).T
    axes.plot(*ends, color=PAPER, linewidth=2.2, alpha=0.8, zorder=3, clip_on=False)
    axes.plot(*ends, color=colour, linewidth=1.1, zorder=4, clip_on=False, gid=gid)
    size = float(np.linalg.norm(tip - start))
    if size > 2:
        head = {"facecolor": colour, "edgecolor": "none", "width": 0.0, "headwidth": 3.4, "headlength": 4.2}
        back, beyond = (tuple(tip + sign * (tip - start) / size * 3) for sign in (-1, 1))
        axes.annotate("", beyond, back, arrowprops=head, zorder=5, annotation_clip=False)


def caption(arm: Arm, lang: str = "") -> str:
    """Return the caption: the pose."""
    pose = values_text(arm, showing_pose(arm), lang)
    return f"{say('drawn_at', lang, pose=pose)} {say('axes_colours', lang)}"


def applies(arm: Arm, lang: str) -> str | None:
    """Return why there is no picture of an arm, what to install included, or None."""
    if arm.path is None:
        return say("no_shape", lang)
    try:
        require_renderer()
    except ModelError:
        return say("no_renderer", lang)
    return None


KIND = Kind("rendering", applies, rendering_figure, caption)
