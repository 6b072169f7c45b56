"""The origins of an arm's joints as its model file states them: where each joint sits on its parent link."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any

from armproof.models.arm import Arm
from armproof.models.exact.numbers import exact_cos_sin
from armproof.models.exact.offset import exact_offset
from armproof.models.exact.polynomial import Entry
from armproof.models.numeric.drake_arm import plant_of

KINDS = {"weld": "fixed"}


@dataclass(frozen=True)
class JointOrigin:
    """The pose of a joint in its parent link, R = Rz(yaw) Ry(pitch) Rx(roll), as in the <origin> of a URDF.

    Attributes:
        parent, child: the links that the joint connects.
        kind: revolute, prismatic or fixed.
        xyz: the origin in the axes of the parent link (m), exact; a coordinate that the card names is its symbol.
        rpy: roll, pitch and yaw, each as (cosine, sine), exact.
        axis: the unit vector of the motion in the axes of the joint; None where the joint is fixed.
    """

    parent: str
    child: str
    kind: str
    xyz: tuple[Entry, ...]
    rpy: tuple[tuple[Entry, Entry], ...]
    axis: tuple[float, ...] | None


def joint_origins(arm: Arm) -> Mapping[str, JointOrigin]:
    """Return the origin of every joint, moving or fixed, by its name in the model file.

    The weld of the base to the world is left out. An arm given by a DH table has no model file and so no joint origins:
    the mapping is empty.
    """
    if arm.path is None:
        return MappingProxyType({})
    plant = plant_of(arm)
    world = plant.world_body().index()
    joints = [plant.get_joint(index) for index in plant.GetJointIndices()]
    welds = [joint for joint in joints if joint.type_name() == "weld" and joint.parent_body().index() == world]
    return MappingProxyType({joint.name(): _origin(arm, joint) for joint in joints if joint not in welds})


def _origin(arm: Arm, joint: Any) -> JointOrigin:
    from pydrake.math import RollPitchYaw

    frame = joint.frame_on_parent()
    X_PF = frame.GetFixedPoseInBodyFrame()
    offset = arm.exact.offsets.get(int(frame.index())) or exact_offset(X_PF)
    kind = KINDS.get(joint.type_name(), joint.type_name())
    axis = {"revolute": "revolute_axis", "prismatic": "translation_axis"}.get(kind)
    return JointOrigin(
        joint.parent_body().name(),
        joint.child_body().name(),
        kind,
        offset.translation,
        tuple(exact_cos_sin(float(angle)) for angle in RollPitchYaw(X_PF.rotation()).vector()),
        tuple(float(part) for part in getattr(joint, axis)()) if axis else None,
    )
