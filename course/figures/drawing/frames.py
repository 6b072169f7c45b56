"""Frames as arrows; axes that fall upon each other are one arrow with all their names."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field

import numpy as np

from armproof.course.figures.drawing.scene import Scene
from armproof.course.figures.drawing.style import INK
from armproof.course.figures.drawing.symbols import AXIS_COLOURS, axis_name

_SAME = 1e-9


@dataclass
class _Axis:
    """Axes of one origin and one direction, as letter and frame."""

    origin: np.ndarray
    way: np.ndarray
    names: list[tuple[str, str]] = field(default_factory=list)

    def is_at(self, origin: np.ndarray, way: np.ndarray) -> bool:
        return bool(np.linalg.norm(self.origin - origin) < _SAME and np.linalg.norm(self.way - way) < 1e-6)


def draw_frames(
    scene: Scene, frames: Mapping[str, np.ndarray], *, size: float = 9.0, letters: Iterable[str] = "xyz"
) -> None:
    """Draw frames, each a pose (4, 4), with the names of their axes.

    An arrow has the gid "frame 0 x", or "frame 0 x; frame 1 x" where two axes are one.
    """
    axes: list[_Axis] = []
    for letter in letters:
        for name, X_0F in frames.items():
            origin, way = X_0F[:3, 3], X_0F[:3, "xyz".index(letter)]
            found = next((axis for axis in axes if axis.is_at(origin, way)), None)
            if found is None:
                axes.append(found := _Axis(origin, way))
            found.names.append((letter, name))
    for axis in axes:
        _draw(scene, axis, size)


def _draw(scene: Scene, axis: _Axis, size: float) -> None:
    letters = {letter for letter, _ in axis.names}
    colour = AXIS_COLOURS[min(letters)] if len(letters) == 1 else INK
    thin = letters == {"y"}
    gid = "; ".join(f"frame {name} {letter}" for letter, name in axis.names)
    length = scene.metres(0.85 * size if thin else size)
    tip = scene.arrow(axis.origin, length * axis.way, colour=colour, gid=gid, width=0.6 if thin else 0.9)
    names = sorted(axis.names, key=lambda one: (one[0], one[1]))
    text = ", ".join(axis_name(letter, name) for letter, name in names)
    scene.label(text, tip, scene.paper(axis.way), colour=colour, gap=0.4)
