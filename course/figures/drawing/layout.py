"""How an arm is laid out for a drawing: where along their axes the joints' symbols stand, and how the links run.

A joint's symbol may stand anywhere on the joint's axis, which is what a textbook uses where several axes meet in one
point: the first of them is drawn towards the base, the last towards the tool.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from armproof.course.figures.facts.task import tool_frame
from armproof.models.arm import Arm
from armproof.models.showing.projection import choose_projection
from armproof.models.showing.skeleton import PlacedJoint, place_skeleton, simplify

_COINCIDE = 0.6  # of the spacing: joints nearer than that are drawn apart
_DETOUR = 2.0  # a link longer than so many times the direct way runs straight
_PARALLEL = 1e-6
_SAME = 1e-9  # m


@dataclass(frozen=True, eq=False)
class Layout:
    """An arm at one configuration, ready to be drawn; points (3,) in frame 0, metres.

    Attributes:
        joints: as placed by the plant.
        spots: (n, 3), where the symbol of each joint stands on its axis.
        links: the polylines of link 0 (from the base) to link n (to the tool), each (k, 3).
        base, base_way: where the ground is, and the unit vector from it to the arm; zero where the arm moves in the plane of the paper.
        gripper, gripper_way: where the gripper is, and the unit vector in which it points.
        tool: the origin of the tool's frame.
        frames: the pose of each frame, (4, 4).
    """

    joints: tuple[PlacedJoint, ...]
    spots: np.ndarray
    links: tuple[np.ndarray, ...]
    base: np.ndarray
    base_way: np.ndarray
    gripper: np.ndarray
    gripper_way: np.ndarray
    tool: np.ndarray
    frames: Mapping[str, np.ndarray]


def lay_out(arm: Arm, q: np.ndarray, spacing: float) -> Layout:
    """Return the layout of an arm at a configuration.

    Args:
        q: (n,) joint values (rad, m).
        spacing: metres between symbols that would fall upon each other.
    """
    return _Layouter(arm, q, spacing).layout()


class _Layouter:
    """Lays out one arm at one configuration."""

    def __init__(self, arm: Arm, q: np.ndarray, spacing: float) -> None:
        skeleton = place_skeleton(arm, q)
        self.joints, self.frames, self.spacing = skeleton.joints, skeleton.frames, spacing
        self.starts, self.ends, self.axes = (
            np.array([getattr(joint, part) for joint in self.joints]) for part in ("start", "end", "axis")
        )
        self.origin = self.frames[arm.frames[0]][:3, 3]
        self.X_0T = self.frames[tool_frame(arm)]
        self.tool = self.X_0T[:3, 3]
        self.planar = choose_projection(arm).planar
        self.near = _COINCIDE * spacing

    def layout(self) -> Layout:
        spots = self._spots()
        base, base_way = self._base(spots[0])
        gripper, gripper_way = self._gripper(spots[-1])
        first = route(base, base_way if np.any(base_way) else self.axes[0], spots[0], self.axes[0])
        links = [
            simplify(np.vstack([spots[k], route(self.ends[k], self.axes[k], spots[k + 1], self.axes[k + 1])]))
            for k in range(len(spots) - 1)
        ]
        last = simplify(np.vstack([spots[-1], self._last_link(spots[-1], gripper)]))
        links = [first, *links, last]
        return Layout(self.joints, spots, tuple(links), base, base_way, gripper, gripper_way, self.tool, self.frames)

    def _spots(self) -> np.ndarray:
        spots = self.starts.copy()
        if not self.planar:
            for first, last in self._runs():
                self._spread(spots, first, last)
        for k, joint in enumerate(self.joints):  # a slide that begins on the joint before it is drawn at its middle
            if joint.kind == "prismatic" and k and np.linalg.norm(spots[k - 1] - spots[k]) < self.spacing:
                spots[k] = (self.starts[k] + self.ends[k]) / 2
        return spots

    def _runs(self) -> list[tuple[int, int]]:
        """Return the first and last of each run of joints that follow each other at one point."""
        runs, first = [], 0
        for k in range(1, len(self.starts) + 1):
            if k == len(self.starts) or np.linalg.norm(self.starts[k] - self.ends[k - 1]) >= self.near:
                if k - first > 1:
                    runs.append((first, k - 1))
                first = k
        return runs

    def _spread(self, spots: np.ndarray, first: int, last: int) -> None:
        """Move the first joint of a run back along its axis, or the last one forward; of three or more, both."""
        back, comes_along = self._way_back(first)
        ahead, goes_along = self._way_ahead(last)
        three = last - first > 1
        moves_back = three or comes_along or not goes_along
        if moves_back:
            spots[first] = spots[first] + self.spacing * back
        if three or not moves_back:
            spots[last] = spots[last] + self.spacing * ahead

    def _way_back(self, k: int) -> tuple[np.ndarray, bool]:
        """Return the way along a joint's axis to where the arm comes from, and whether it comes along that axis."""
        axis = self.axes[k]
        if k == 0:
            return -axis * _upwards(axis), True
        part = float((self.ends[k - 1] - self.starts[k]) @ axis)
        return (axis * np.sign(part), True) if abs(part) > self.near else (-axis * _upwards(axis), False)

    def _way_ahead(self, k: int) -> tuple[np.ndarray, bool]:
        """Return the way along a joint's axis to where the arm goes on, and whether it goes on along that axis."""
        axis = self.axes[k]
        goal = self.starts[k + 1] if k + 1 < len(self.starts) else self.tool
        part = float((goal - self.ends[k]) @ axis)
        last = k + 1 == len(self.starts)
        if abs(part) > _SAME:
            return axis * np.sign(part), last or abs(part) > self.near
        return axis * self._approach(axis), last

    def _approach(self, axis: np.ndarray) -> float:
        """Return 1 if the tool goes on along an axis, else −1: away from the joint before, else as z of its frame has it."""
        come = float((self.ends[-1] - self.starts[-2]) @ axis) if len(self.starts) > 1 else 0.0
        if abs(come) > _SAME:
            return float(np.sign(come))
        return -1.0 if self.X_0T[:3, 2] @ axis < -0.1 else 1.0

    def _base(self, spot: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return where the ground is, and the unit vector from it to the arm."""
        way, axis = spot - self.origin, self.axes[0]
        distance = float(np.linalg.norm(way))
        if self.planar and distance < self.near:
            return spot, np.zeros(3)
        if distance > 1.5 * self.spacing:
            along = abs(way @ axis) > 0.9 * distance
            return self.origin, way / distance if along else np.array([0.0, 0.0, 1.0])
        up = axis * _upwards(axis)
        return spot - 1.1 * self.spacing * up, up

    def _gripper(self, spot: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return where the gripper is, and its way: that of the last link, else that of the last axis."""
        link = route_to_point(self.ends[-1], self.axes[-1], self.tool)
        way = link[-1] - link[-2]
        if np.linalg.norm(way) > self.near and (self.tool - spot) @ way > 0:
            return self.tool, way / np.linalg.norm(way)
        axis = self.axes[-1]
        if self.joints[-1].kind == "prismatic":
            return self.tool, axis
        beyond = spot - self.ends[-1]
        ahead = beyond / np.linalg.norm(beyond) if np.linalg.norm(beyond) > _SAME else axis * self._approach(axis)
        return spot + 1.2 * self.spacing * ahead, ahead

    def _last_link(self, spot: np.ndarray, gripper: np.ndarray) -> np.ndarray:
        if gripper is self.tool:
            return route_to_point(self.ends[-1], self.axes[-1], self.tool)
        return np.array([spot, gripper])


def _upwards(axis: np.ndarray) -> float:
    """Return 1 if an axis points up, towards z_0, or where it is level towards x_0, then y_0; else −1."""
    parts = (axis[2], axis[0], axis[1])
    return float(next((np.sign(part) for part in parts if abs(part) > 0.1), 1.0))


def route(start: np.ndarray, axis: np.ndarray, end: np.ndarray, next_axis: np.ndarray) -> np.ndarray:
    """Return the way of a link from a point on one joint's axis to a point on the next one's, (k, 3).

    It follows d and a of Denavit and Hartenberg; of parallel axes the common normal through the end is taken.
    """
    across = np.cross(axis, next_axis)
    if np.linalg.norm(across) < _PARALLEL:
        way = [start, start + ((end - start) @ axis) * axis, end]
    else:
        s, t, _ = np.linalg.solve(np.column_stack([axis, -next_axis, across]), end - start)
        way = [start, start + s * axis, end + t * next_axis, end]
    length = sum(float(np.linalg.norm(one - other)) for one, other in pairwise(way))
    detour = length > _DETOUR * np.linalg.norm(end - start) + _SAME
    return simplify(np.array([start, end] if detour else way))


def route_to_point(start: np.ndarray, axis: np.ndarray, point: np.ndarray) -> np.ndarray:
    """Return the way of the last link: along the joint's axis, then across it to a point, (k, 3)."""
    return simplify(np.array([start, start + ((point - start) @ axis) * axis, point]))
