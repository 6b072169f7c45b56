"""The exact symbolic kinematics of an arm: what every proof compares a document with.

An arm that was loaded is asked through its symbolic plant (models/exact/symbolic.py); one that was read from a value, by
the links that were traced when it was written (models/exact/value.py). Neither NumPy nor Drake is imported here.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cached_property
from types import MappingProxyType
from typing import Protocol

from armproof.models.arm import Arm, once_per_arm
from armproof.models.errors import Fault, ModelError
from armproof.models.exact.numbers import angle_value
from armproof.models.exact.polynomial import Entry, Generator, Rows

_MOST_GROWTH = 19


class ExactKinematics(Protocol):
    """Exact poses and Jacobians between frames that the arm has.

    Depth of a frame: the number of moving joints between the base and its body; −1 below the base.
    """

    def depth(self, frame: str) -> int:
        """Return the depth of a frame."""

    def pose(self, frame: str, reference: str) -> Sequence[Sequence[Entry]]:
        """Return the pose of a frame in a reference frame, 4 rows of 4 entries."""

    def jacobian(self, frame: str, expressed_in: str, reference: str) -> Sequence[Sequence[Entry]]:
        """Return the geometric Jacobian [v; ω], 6 rows of n entries."""

    @property
    def generators(self) -> set[Generator]:
        """The constants and lengths that the fixed poses hold."""

    @property
    def growth(self) -> Mapping[int, float]:
        """How many times (log2, as measured) the angles and roots at each depth double the work of a product."""


@once_per_arm
def trace_of(arm: Arm) -> Trace:
    """Return the exact symbolic kinematics of an arm."""
    return Trace(arm, arm.exact)


class Trace:
    """Exact poses and Jacobians of the frames of an arm, in normal form (see models/exact/polynomial.py), computed once each.

    A reference, or axes, that are not given are the base frame's, usually "0". A frame that the arm has not is a ModelError, and
    so are entries that have too many terms.
    """

    def __init__(self, arm: Arm, kinematics: ExactKinematics) -> None:
        self._arm = arm
        self._kinematics = kinematics
        self._entries: dict[tuple[str, ...], Rows] = {}

    def depth(self, frame: str) -> int:
        """Return the number of moving joints between the base and a frame; −1 below the base."""
        return self._kinematics.depth(*self._arm.frame_names(frame))

    def pose(self, frame: str, reference: str | None = None) -> Rows:
        """Return the pose of a frame in a reference frame, the homogeneous transform {}^{reference}T_{frame}.

        Returns:
            4 rows of 4 entries; lengths in metres.
        """
        frame, reference = self._arm.frame_names(frame, reference)
        key = ("pose", frame, reference)
        if key not in self._entries:
            below = min(self._kinematics.depth(frame), self._kinematics.depth(reference))
            self._check_size(below, (frame, reference))
            self._entries[key] = _read_only(self._kinematics.pose(frame, reference))
        return self._entries[key]

    def jacobian(self, frame: str, expressed_in: str | None = None, reference: str | None = None) -> Rows:
        """Return the geometric Jacobian of the origin of a frame: [v; ω] = J(q) q̇.

        v (m/s) and ω (rad/s) are those of `frame` relative to `reference`, expressed in the axes of `expressed_in`.

        Returns:
            6 rows, [v; ω], of n entries, one a joint from base to tool.
        """
        frame, expressed_in, reference = self._arm.frame_names(frame, expressed_in, reference)
        key = ("jacobian", frame, expressed_in, reference)
        if key not in self._entries:
            depth = self._kinematics.depth
            first, last = sorted((depth(frame), depth(reference)))
            if max(first, 0) < last:
                lowest = min(max(first, 0), depth(frame), depth(expressed_in))
                self._check_size(lowest, (frame, reference), expressed_in)
            self._entries[key] = _read_only(self._kinematics.jacobian(frame, expressed_in, reference))
        return self._entries[key]

    @cached_property
    def constants(self) -> Mapping[str, float]:
        """The value (rad) of every angle that is not a joint variable: numeric names such as "pi/5", and arm.angles."""
        values = dict(self._arm.angles)
        for kind, name in sorted(self._kinematics.generators):
            if kind in ("cos", "sin") and name not in values:
                values[name] = angle_value(name)
        return MappingProxyType(values)

    def _check_size(self, depth: int, frames: tuple[str, ...], expressed_in: str | None = None) -> None:
        """Refuse a trace whose rotations from a depth to the frames multiply to more terms than two seconds allow.

        Raises:
            ModelError: the estimate, in bits, of the work is above 19 (a 12R arm with right angles, or 6R with symbols).
        """
        growth = sum(self._growth(depth, frame) for frame in frames)
        if expressed_in is not None:
            growth += self._growth(depth, expressed_in) / 2
        if growth > _MOST_GROWTH:
            raise ModelError(Fault.TOO_MANY_ANGLES, arm=self._arm.name, frames=list(frames))

    def _growth(self, depth: int, frame: str) -> float:
        end = self._kinematics.depth(frame)
        return sum(growth for at, growth in self._kinematics.growth.items() if depth <= at < end)


def _read_only(rows: Sequence[Sequence[Entry]]) -> Rows:
    return tuple(tuple(MappingProxyType(dict(entry)) for entry in row) for row in rows)
