"""The exact symbolic kinematics of an arm, traced through its MultibodyPlant.

Every fixed pose of an arm stands in a FixedOffsetFrame, and in a context of `plant.ToSymbolic()` such a pose is a
parameter. With exact poses there and variables for the joints, Drake's own kinematics gives each entry as a polynomial.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cache, cached_property
from types import MappingProxyType
from typing import Any

import numpy as np

from armproof.models.arm import Arm
from armproof.models.errors import ModelError
from armproof.models.exact.constants import constant_value
from armproof.models.exact.numbers import angle_value
from armproof.models.exact.polynomial import Entry, Generator, Rows, evaluate, generators
from armproof.models.exact.symbolic import SymbolicPlant
from armproof.models.numeric.jacobian import calc_jacobian
from armproof.models.numeric.joint_values import read_joint_values

AXES = {"x": 0, "y": 1, "z": 2}


class Trace:
    """Exact poses and Jacobians of the frames of an arm, in normal form (see models/exact/polynomial.py), computed once each."""

    def __init__(self, arm: Arm) -> None:
        self._arm = arm
        self._entries: dict[tuple[str, ...], Rows] = {}

    @cached_property
    def _symbolic(self) -> SymbolicPlant:
        return SymbolicPlant(self._arm)

    def depth(self, frame: str) -> int:
        """Return the number of moving joints between the base and a frame; −1 below the base."""
        return self._symbolic.depth(frame)

    def pose(self, frame: str, reference: str | None = None) -> Rows:
        """Return the pose of a frame in a reference frame, the homogeneous transform {}^{reference}T_{frame}.

        Args:
            reference: the base frame, usually "0", if not given.

        Returns:
            4 rows of 4 entries; lengths in metres.

        Raises:
            ModelError: the arm has no such frame.
        """
        frame, reference = self._arm.frame_names(frame, reference)
        key = ("pose", frame, reference)
        if key not in self._entries:
            symbolic = self._symbolic
            below = min(symbolic.depth(frame), symbolic.depth(reference))
            symbolic.check_size(below, (frame, reference))
            plant, context = symbolic.plant, symbolic.context(below)
            X_RF = plant.CalcRelativeTransform(context, symbolic.frame(reference), symbolic.frame(frame))
            self._entries[key] = _read_only(symbolic.entries(X_RF.GetAsMatrix4()))
        return self._entries[key]

    def rotation(self, frame: str, reference: str | None = None) -> Rows:
        """Return the rotation matrix of a frame in a reference frame: 3 rows of 3 entries."""
        return tuple(row[:3] for row in self.pose(frame, reference)[:3])

    def origin(self, frame: str, reference: str | None = None) -> tuple[Entry, ...]:
        """Return the origin of a frame from the origin of the reference frame, in its axes: 3 entries, metres."""
        return tuple(row[3] for row in self.pose(frame, reference)[:3])

    def axis(self, frame: str, axis: str = "z", reference: str | None = None) -> tuple[Entry, ...]:
        """Return the unit vector of an axis, x, y or z, of a frame in the axes of the reference frame: 3 entries."""
        if axis not in AXES:
            raise ModelError(f"no axis '{axis}'; a frame has the axes x, y, z")
        return tuple(row[AXES[axis]] for row in self.rotation(frame, reference))

    def jacobian(self, frame: str, expressed_in: str | None = None, reference: str | None = None) -> Rows:
        """Return the geometric Jacobian of the origin of a frame: [v; ω] = J(q) q̇.

        v (m/s) and ω (rad/s) are those of `frame` relative to `reference`, expressed in the axes of `expressed_in`;
        both are the base frame, usually "0", if not given.

        Returns:
            6 rows, [v; ω], of n entries, one a joint from base to tool.

        Raises:
            ModelError: the arm has no such frame.
        """
        key = ("jacobian", *self._arm.frame_names(frame, expressed_in, reference))
        if key not in self._entries:
            self._entries[key] = _read_only(self._trace_jacobian(*key[1:]))
        return self._entries[key]

    def _trace_jacobian(self, frame: str, expressed_in: str, reference: str) -> Rows:
        """Trace the columns, each with only that part of the chain that it depends on.

        Column j depends on what lies between the joint j, the frame and `expressed_in`, and is zero unless the joint
        lies between the frame and the reference.
        """
        symbolic = self._symbolic
        n = len(self._arm.joints)
        first, last = sorted((symbolic.depth(frame), symbolic.depth(reference)))
        columns: list[tuple[Entry, ...]] = [({},) * 6 for _ in range(n)]
        by_depth: dict[int, list[int]] = {}
        for joint in range(max(first, 0), last):
            below = min(joint, symbolic.depth(frame), symbolic.depth(expressed_in))
            by_depth.setdefault(below, []).append(joint)
        for below, joints in by_depth.items():
            symbolic.check_size(below, (frame, reference), expressed_in)
            J = calc_jacobian(
                symbolic.plant,
                symbolic.context(below),
                *(symbolic.frame(name) for name in (frame, reference, expressed_in)),
            )
            traced = symbolic.entries(J[:, [self._arm.position_indices[joint] for joint in joints]])
            for joint, column in zip(joints, zip(*traced, strict=True), strict=True):
                columns[joint] = column
        return tuple(zip(*columns, strict=True))

    @cached_property
    def constants(self) -> Mapping[str, float]:
        """The value (rad) of every angle that is not a joint variable: numeric names such as "pi/5", and arm.angles."""
        values = dict(self._arm.angles)
        for kind, name in sorted(self._symbolic.generators):
            if kind in ("cos", "sin") and name not in values:
                values[name] = angle_value(name)
        return MappingProxyType(values)

    def evaluate(self, entries: Sequence[Sequence[Entry]], q: np.ndarray) -> np.ndarray:
        """Evaluate a matrix of entries at N configurations, with the lengths and angles that the plant has.

        Args:
            entries: rows of entries, as `pose` and `jacobian` return them.
            q: (N, n) array of joint variables, base to tool.

        Returns:
            (N, rows, columns) array.

        Raises:
            ModelError: q cannot be read (see `read_joint_values`).
        """
        q = read_joint_values(self._arm, q)
        column = {joint.symbol: q[:, joint.index - 1] for joint in self._arm.joints}
        constants = {**self._arm.lengths, **self._arm.angles}

        @cache
        def value(generator: Generator) -> Any:
            kind, name = generator
            if name not in column:
                return constant_value(generator, constants)
            if kind == "symbol":
                return column[name]
            return np.cos(column[name]) if kind == "cos" else np.sin(column[name])

        values = np.empty((len(q), len(entries), len(entries[0])))
        for i, row in enumerate(entries):
            for j, entry in enumerate(row):
                values[:, i, j] = evaluate(entry, value)
        return values

    def generators(self, entries: Sequence[Sequence[Entry]]) -> set[Generator]:
        """Return the cosines, sines, symbols and roots that occur in a matrix of entries."""
        return generators(entry for row in entries for entry in row)


def _read_only(rows: Sequence[Sequence[Entry]]) -> Rows:
    return tuple(tuple(MappingProxyType(dict(entry)) for entry in row) for row in rows)
