"""The skeleton of an arm at one configuration: where its joints and frames are, for a drawing."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType

import numpy as np

from armproof.models.arm import Arm
from armproof.models.errors import ModelError


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


def place_skeleton(arm: Arm, q: Sequence[float] | np.ndarray) -> Skeleton:
    """Return the skeleton of an arm at a configuration.

    Args:
        q: the joint variables, base to tool (rad, m).

    Raises:
        ModelError: q has another length than the arm has joints.
    """
    q = np.asarray(q, dtype=float)
    if q.shape != (len(arm.joints),):
        raise ModelError(f"a configuration of arm '{arm.name}' has {len(arm.joints)} values, not {q.shape}")
    plant, context = arm.plant, arm.plant.CreateDefaultContext()
    positions = np.zeros(plant.num_positions())
    positions[list(arm.position_indices)] = q
    plant.SetPositions(context, positions)
    X_0W = arm.frame(arm.frames[0]).CalcPoseInWorld(context).inverse()
    joints = []
    for joint, drake_joint in zip(arm.joints, arm.drake_joints, strict=True):
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
        pose = X_0W.multiply(arm.frame(name).CalcPoseInWorld(context)).GetAsMatrix4()
        pose.flags.writeable = False
        frames[name] = pose
    return Skeleton(tuple(joints), MappingProxyType(frames))


def _floats(vector: np.ndarray) -> tuple[float, ...]:
    return tuple(float(part) for part in np.ravel(vector))
