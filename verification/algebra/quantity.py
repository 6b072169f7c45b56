"""A quantity of an arm, as data: which matrix of which frames, and which of its rows and columns."""

from __future__ import annotations

from dataclasses import dataclass

COMPONENTS = {"x": 0, "y": 1, "z": 2}


@dataclass(frozen=True)
class Quantity:
    """A matrix of an arm: `kind` of `frame` in `reference`, then the rows and columns that are meant (from 1).

    pose: 4×4 X_{reference,frame}; rotation: its 3×3 block; origin: 3×1, p of the frame's origin in the reference;
    axis: 3×1, the frame's x, y or z axis in the reference; difference: p_frame − p_start in the reference;
    jacobian: 6×n, rows [v; ω], of the frame's origin with respect to frame 0, expressed in the reference;
    link: the general link matrix of a convention in frame; joint: a joint's variable; vector: all of them.
    """

    kind: str
    frame: str
    reference: str = "0"
    rows: tuple[int, ...] | None = None
    columns: tuple[int, ...] | None = None
    along: str = "z"
    start: str = "0"
    scalar: bool = False
    homogeneous: bool = False
