"""The columns of an arm's Jacobian one by one: the axis of a joint, the lever from it to the tool, the velocity that it gives."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from armproof.course.figures.facts.poses import showing_pose
from armproof.course.figures.facts.task import tool_frame
from armproof.models.arm import Arm, Joint
from armproof.models.numeric.plant import NumericKinematics
from armproof.models.showing.skeleton import place_skeleton


@dataclass(frozen=True, eq=False)
class Column:
    """What one joint does with the tool.

    Attributes:
        joint: the joint.
        at: a point on its axis (3,) in frame 0 (m).
        z: its axis, a unit vector.
        lever: from there to the tool (m).
        v: the velocity of the tool at 1 rad/s, or 1 m/s, as Drake has it.
    """

    joint: Joint
    at: np.ndarray
    z: np.ndarray
    lever: np.ndarray
    v: np.ndarray


@lru_cache(maxsize=64)
def columns_of(arm: Arm) -> tuple[Column, ...]:
    """Return the columns of an arm where it is well seen."""
    q, frame = showing_pose(arm), tool_frame(arm)
    kinematics, placed = NumericKinematics(arm, q[None]), place_skeleton(arm, q).joints
    tool, J = kinematics.pose(frame)[0, :3, 3], kinematics.jacobian(frame)[0]
    ends = [np.array(joint.end) for joint in placed]
    return tuple(
        Column(joint, end, np.array(each.axis), tool - end, J[:3, k])
        for k, (joint, each, end) in enumerate(zip(arm.joints, placed, ends, strict=True))
    )
