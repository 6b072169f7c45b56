"""The fixed pose of a base or a tool beside a DH table: {xyz: [x, y, z], rpy: [roll, pitch, yaw]}, as a URDF has it.

X = Trans(x, y, z) Rot(z, yaw) Rot(y, pitch) Rot(x, roll); each entry reads as one of the table.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, fields
from typing import Any

from armproof.models.dh.entry import LinearForm, read_entry
from armproof.models.errors import Fault, ModelError

Three = tuple[LinearForm, ...]
_NOWHERE: Three = (LinearForm(),) * 3


@dataclass(frozen=True)
class FixedPose:
    """A pose that no joint moves: xyz in metres, rpy in radians."""

    xyz: Three = _NOWHERE
    rpy: Three = _NOWHERE


def read_pose(key: str, given: object) -> FixedPose | None:
    """Return the pose under a key of a DH table, None where there is none; raises ModelError."""
    if given is None:
        return None
    names = [field.name for field in fields(FixedPose)]
    is_pose = isinstance(given, Mapping) and set(given) <= set(names)
    if not isinstance(given, Mapping) or not is_pose or not all(_is_three(each) for each in given.values()):
        raise ModelError(Fault.POSE_KEYS, key=key, keys=names, given=repr(given))
    pose = FixedPose(**{name: tuple(map(read_entry, entries)) for name, entries in given.items()})
    lengths = [entry for entry in pose.xyz if entry.pi]
    angles = [entry for entry in pose.rpy if any(factor.denominator != 1 for _, factor in entry.symbols)]
    if lengths or angles:
        raise ModelError(Fault.POSE_ENTRY, key=key, entry=str([*lengths, *angles][0]))
    return pose


def write_pose(pose: FixedPose) -> dict[str, Any]:
    """Return the mapping that `read_pose` reads as this pose."""
    return {field.name: list(map(str, getattr(pose, field.name))) for field in fields(FixedPose)}


def _is_three(entries: object) -> bool:
    return isinstance(entries, list | tuple) and len(entries) == 3
