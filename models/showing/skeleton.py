"""The skeleton of an arm at one configuration: where its joints and frames are, for a drawing."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType

import numpy as np

from armproof.models.arm import Arm
from armproof.models.errors import Fault, ModelError
from armproof.models.exact.trace import trace_of
from armproof.models.numeric.drake_arm import drake_of

_SAME = 1e-9  # m


@dataclass(frozen=True)
class PlacedJoint:
    """A moving joint in frame 0.

    Attributes:
        kind: revolute or prismatic.
        start: where the joint sits on the link before it (m); revolute joints turn there.
        end: where it carries the link after it (m); other than `start` once a prismatic joint is moved.
        axis: the unit vector of its motion.
    """

    kind: str
    start: tuple[float, ...]
    end: tuple[float, ...]
    axis: tuple[float, ...]


@dataclass(frozen=True)
class Skeleton:
    """An arm at one configuration: its joints base to tool, and the pose of each of its frames in frame 0, (4, 4)."""

    joints: tuple[PlacedJoint, ...]
    frames: Mapping[str, np.ndarray]

    def line(self, frame: str, joints: int | None = None) -> np.ndarray:
        """Return the origin of the arm, both ends of its first joints (by default all), and the origin of a frame, (K, 3)."""
        ends = [end for joint in self.joints[:joints] for end in (joint.start, joint.end)]
        base = next(iter(self.frames.values()))
        return np.vstack([base[:3, 3], *ends, self.frames[frame][:3, 3]])


def place_skeleton(arm: Arm, q: Sequence[float] | np.ndarray) -> Skeleton:
    """Return the skeleton of an arm at a configuration.

    Args:
        q: the joint variables, base to tool (rad, m).

    Raises:
        ModelError: q has another length than the arm has joints.
    """
    q = np.asarray(q, dtype=float)
    if q.shape != (len(arm.joints),):
        raise ModelError(Fault.JOINT_COUNT, arm=arm.name, n=len(arm.joints), shape=str(q.shape))
    drake = drake_of(arm)
    context = drake.plant.CreateDefaultContext()
    positions = np.zeros(drake.plant.num_positions())
    positions[list(drake.position_indices)] = q
    drake.plant.SetPositions(context, positions)
    X_0W = drake.frames[arm.frames[0]].CalcPoseInWorld(context).inverse()
    joints = []
    for joint, drake_joint in zip(arm.joints, drake.joints, strict=True):
        X_0F = X_0W.multiply(drake_joint.frame_on_parent().CalcPoseInWorld(context))
        X_0M = X_0W.multiply(drake_joint.frame_on_child().CalcPoseInWorld(context))
        axis = drake_joint.revolute_axis() if joint.kind == "revolute" else drake_joint.translation_axis()
        joints.append(
            PlacedJoint(
                joint.kind, _floats(X_0F.translation()), _floats(X_0M.translation()), _floats(X_0F.rotation() @ axis)
            )
        )
    frames = {}
    for name in arm.frames:
        pose = X_0W.multiply(drake.frames[name].CalcPoseInWorld(context)).GetAsMatrix4()
        pose.flags.writeable = False
        frames[name] = pose
    return Skeleton(tuple(joints), MappingProxyType(frames))


def stick_points(arm: Arm, q: Sequence[float] | np.ndarray, frame: str) -> np.ndarray:
    """Return the corners of an arm at a configuration drawn as lines from its origin to that of a frame, (K, 3)."""
    return simplify(place_skeleton(arm, q).line(frame, trace_of(arm).depth(frame)))


def simplify(points: np.ndarray) -> np.ndarray:
    """Return a polyline without points that repeat or lie on the line through their neighbours; at least two points."""
    kept = [points[0]]
    for point in points[1:]:
        if np.linalg.norm(point - kept[-1]) > _SAME:
            kept.append(point)
    k = 1
    while k < len(kept) - 1:
        one, other = kept[k] - kept[k - 1], kept[k + 1] - kept[k]
        if np.linalg.norm(np.cross(one, other)) <= _SAME * np.linalg.norm(one) * np.linalg.norm(other) + _SAME**2:
            del kept[k]
            k = max(k - 1, 1)
        else:
            k += 1
    return np.array(kept if len(kept) > 1 else [kept[0], kept[0]])


def _floats(vector: np.ndarray) -> tuple[float, ...]:
    return tuple(float(part) for part in np.ravel(vector))
