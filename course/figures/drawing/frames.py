"""Frames as arrows; axes that fall upon each other are one arrow with all their names."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

import numpy as np

from armproof.course.figures.drawing.scene import Scene
from armproof.course.figures.drawing.style import INK
from armproof.course.figures.drawing.symbols import AXIS_COLOURS, axis_name


def draw_frames(
    scene: Scene, frames: Mapping[str, np.ndarray], *, size: float = 9.0, letters: Iterable[str] = "xyz"
) -> None:
    """Draw frames, each a pose (4, 4), with the names of their axes.

    An arrow has the gid "frame 0 x", or "frame 0 x; frame 1 x" where two axes are one.
    """
    axes: dict[tuple[float, ...], list[tuple[str, str]]] = {}  # letter and frame, by the origin and the direction
    for letter in letters:
        for name, X_0F in frames.items():
            place = np.round([*X_0F[:3, 3], *X_0F[:3, "xyz".index(letter)]], 7) + 0.0
            axes.setdefault(tuple(place), []).append((letter, name))
    for names in axes.values():
        _draw(scene, frames, names, size)


def _draw(scene: Scene, frames: Mapping[str, np.ndarray], names: list[tuple[str, str]], size: float) -> None:
    """Draw the axes of one origin and one direction."""
    letters = {letter for letter, _ in names}
    colour = AXIS_COLOURS[min(letters)] if len(letters) == 1 else INK
    thin = letters == {"y"}
    gid = "; ".join(f"frame {name} {letter}" for letter, name in names)
    letter, name = names[0]
    X_0F = frames[name]
    origin, way = X_0F[:3, 3], X_0F[:3, "xyz".index(letter)]
    length = scene.metres(0.85 * size if thin else size)
    tip = scene.arrow(origin, length * way, colour=colour, gid=gid, width=0.6 if thin else 0.9)
    text = ", ".join(axis_name(letter, name) for letter, name in sorted(names))
    scene.label(text, tip, scene.paper(way), colour=colour, gap=0.4)
