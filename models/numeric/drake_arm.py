"""The arm as Drake has it: its MultibodyPlant of doubles, and where its joints and frames are in it.

An arm that was read from a value has no plant: asking for it, or for anything in it, is a ModelError.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

from armproof.models.arm import Arm
from armproof.models.errors import Fault, ModelError


@dataclass(frozen=True, eq=False)
class DrakeArm:
    """The Drake objects of an arm.

    Attributes:
        plant: the finalized MultibodyPlant of doubles.
        base: the body that carries the arm.
        joints: the Drake joint of each of `arm.joints`.
        frames: the Drake frame of each document frame.
    """

    plant: Any = field(repr=False)
    base: Any = field(repr=False)
    joints: tuple[Any, ...] = field(repr=False)
    frames: Mapping[str, Any] = field(repr=False)

    @cached_property
    def position_indices(self) -> tuple[int, ...]:
        """The index of each joint variable in the plant's vector of positions (and of velocities)."""
        return tuple(joint.position_start() for joint in self.joints)


def drake_of(arm: Arm) -> DrakeArm:
    """Return the Drake objects of an arm."""
    if arm.drake is None:
        raise ModelError(Fault.NO_PLANT, arm=arm.name)
    drake: DrakeArm = arm.drake
    return drake


def plant_of(arm: Arm) -> Any:
    """Return the finalized MultibodyPlant of doubles of an arm."""
    return drake_of(arm).plant


def frame_of(arm: Arm, name: str | int) -> Any:
    """Return the Drake frame of a document frame; raises ModelError where the arm has no such frame."""
    return drake_of(arm).frames[arm.frame_names(name)[0]]
