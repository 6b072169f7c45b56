"""What a batch of targets is solved to: all branches of each, and a mark that says what each target is."""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import IntEnum
from functools import cached_property

import numpy as np

from armproof.models.arm import Joint

TURN = 2.0 * np.pi


class Mark(IntEnum):
    """What a target is.

    REACHABLE: the branches that are valid are different solutions. EDGE: at least two branches coincide, as on the limit
    of the workspace. DEGENERATE: on some branch an atan2 is of (0, 0) or a denominator vanishes: a joint is free, there are
    infinitely many solutions (or the formulas were not made for this target). UNREACHABLE: no branch has a value. INVALID: no
    target, being not finite or no rotation.
    """

    REACHABLE = 0
    EDGE = 1
    DEGENERATE = 2
    UNREACHABLE = 3
    INVALID = 4


@dataclass(frozen=True)
class Solutions:
    """The solutions of N targets on B branches, for n joints; all arrays are read-only.

    Attributes:
        q: (N, B, n) joint values from base to tool (rad, m), angles in [−π, π]; NaN on branches that are not valid.
        valid: (N, B), which branches are solutions. On a degenerate target a valid branch is one solution of infinitely
            many, with the free joint at 0.
        mark: (N,), what each target is: values of `Mark`.
        joints: the joints of the arm.
    """

    q: np.ndarray
    valid: np.ndarray
    mark: np.ndarray
    joints: tuple[Joint, ...] = field(repr=False)

    def __post_init__(self) -> None:
        for array in (self.q, self.valid, self.mark):
            array.flags.writeable = False

    @cached_property
    def within_limits(self) -> np.ndarray:
        """(N, B), which valid branches lie within the limits of all joints, angles moved by whole turns where that helps."""
        inside = self.valid.copy()
        for joint in self.joints:
            value = self.q[..., joint.index - 1]
            if joint.kind == "revolute" and np.isfinite(joint.lower):
                value = value + TURN * np.ceil((joint.lower - value) / TURN)  # the least one not below the lower limit
            inside &= (value >= joint.lower) & (value <= joint.upper)
        inside.flags.writeable = False
        return inside

    def __len__(self) -> int:
        return len(self.q)
