"""One link between two axes that are skew, parallel or meet: its frames from Drake, and its four parameters as lengths and angles."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from typing import Literal

import numpy as np

from armproof.models.catalogue import load_arm
from armproof.models.numeric.plant import NumericKinematics

Convention = Literal["classic", "modified"]


@dataclass(frozen=True, eq=False)
class Turn:
    """An angle: at a point, from one unit vector about another (rad)."""

    name: str
    at: np.ndarray
    start: np.ndarray
    axis: np.ndarray
    angle: float


@dataclass(frozen=True, eq=False)
class LinkParts:
    """A link of a DH table.

    Attributes:
        before, after: the poses of frames i-1 and i, (4, 4).
        axes: of the two joints that it joins, each a point and a unit vector.
        feet: where the common normal of these axes meets them, (2, 3).
        lengths: a and d by their names, each with its ends (2, 3).
        turns: α and θ.
    """

    before: np.ndarray
    after: np.ndarray
    axes: tuple[tuple[np.ndarray, np.ndarray], ...]
    feet: np.ndarray
    lengths: dict[str, np.ndarray]
    turns: tuple[Turn, ...]


@lru_cache(maxsize=16)
def link_parts(convention: Convention, a: float, alpha: float, d: float, theta: float) -> LinkParts:
    """Return the link of the parameters (m, degrees), a joint of its own before it, as Drake has it."""
    row = {"a": a, "alpha": f"{alpha}°", "d": d}
    arm = load_arm(
        {"dh": convention, "rows": [{"a": 0, "alpha": 0, "d": 0, "theta": "theta_1"}, {**row, "theta": "theta_2"}]}
    )
    kinematics = NumericKinematics(arm, np.array([[0.0, np.radians(theta)]]))
    before, after = (kinematics.pose(frame)[0] for frame in arm.frames[1:3])
    (x, _, z, o), (x_next, _, z_next, o_next) = before[:3].T, after[:3].T
    across = x if convention == "modified" else x_next
    feet = np.array([o, o + a * x]) if convention == "modified" else np.array([o_next - a * x_next, o_next])
    twist = Turn("alpha", feet[1], z, across, np.radians(alpha))
    turn = Turn(
        "theta",
        feet[1] if convention == "modified" else feet[0],
        x,
        z_next if convention == "modified" else z,
        np.radians(theta),
    )
    offset = np.array([feet[1], o_next]) if convention == "modified" else np.array([o, feet[0]])
    return LinkParts(before, after, ((o, z), (feet[1], z_next)), feet, {"a": feet, "d": offset}, (twist, turn))
