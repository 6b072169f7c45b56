"""The symbolic plant of an arm: exact poses in, polynomials out."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cached_property
from typing import Any

import numpy as np

from armproof.models.arm import Joint
from armproof.models.exact.expressions import Expressions
from armproof.models.exact.numbers import IDENTITY
from armproof.models.exact.offset import Offset, exact_offsets, frame_at
from armproof.models.exact.polynomial import Entry, Generator, Rows, number
from armproof.models.exact.polynomial import generators as generators_of
from armproof.models.numeric.drake_arm import DrakeArm
from armproof.models.numeric.plant import calc_jacobian

_ZERO_OFFSET = Offset(IDENTITY, (number(0),) * 3)


class SymbolicPlant:
    """`plant.ToSymbolic()` with the fixed poses of the arm made exact.

    Depth d of a frame: the number of moving joints between the base and its body. A pose relative to a frame of depth d
    does not depend on anything nearer to the base, and `context(d)` leaves that out: joints at zero, offsets at identity.
    That keeps the polynomials short.
    """

    def __init__(
        self, name: str, joints: Sequence[Joint], drake: DrakeArm, offsets: Mapping[int, Offset] | None = None
    ) -> None:
        """Take the Drake objects of an arm, its name for messages, and its joints.

        Args:
            offsets: the exact pose of each fixed frame that holds a symbol, by the frame's index in the plant.
        """
        self._name = name
        self._joints = joints
        self._drake = drake
        self._given = offsets or {}
        self._contexts: dict[int, Any] = {}

    @cached_property
    def plant(self) -> Any:
        """The plant of expressions."""
        return self._drake.plant.ToSymbolic()

    @cached_property
    def offsets(self) -> Mapping[int, Offset]:
        """The exact pose of each fixed frame in its parent, by the frame's index in the plant."""
        return {**exact_offsets(self._drake.plant, but=self._given.keys()), **self._given}

    @cached_property
    def _expressions(self) -> Expressions:
        return Expressions(self._name, self._joints)

    @cached_property
    def _depths(self) -> Mapping[int, int]:
        return _body_depths(self._drake)

    @cached_property
    def _offset_depths(self) -> Mapping[int, int]:
        plant = self._drake.plant
        return {index: self._depths[int(frame_at(plant, index).body().index())] for index in self.offsets}

    def depth(self, frame: str) -> int:
        """Return the number of moving joints between the base and a document frame."""
        return self._depths[int(self._drake.frames[frame].body().index())]

    def pose(self, frame: str, reference: str) -> Rows:
        """Return the pose of a frame in a reference frame."""
        context = self.context(min(self.depth(frame), self.depth(reference)))
        X_RF = self.plant.CalcRelativeTransform(context, self._frame(reference), self._frame(frame))
        return self._expressions.entries(X_RF.GetAsMatrix4())

    def jacobian(self, frame: str, expressed_in: str, reference: str) -> Rows:
        """Return the geometric Jacobian, its columns each with only that part of the chain that it depends on.

        Column j depends on what lies between the joint j, the frame and `expressed_in`, and is zero unless the joint
        lies between the frame and the reference.
        """
        first, last = sorted((self.depth(frame), self.depth(reference)))
        columns: list[tuple[Entry, ...]] = [({},) * 6 for _ in self._joints]
        by_depth: dict[int, list[int]] = {}
        for joint in range(max(first, 0), last):
            below = min(joint, self.depth(frame), self.depth(expressed_in))
            by_depth.setdefault(below, []).append(joint)
        frames = [self._frame(name) for name in (frame, reference, expressed_in)]
        for below, joints in by_depth.items():
            J = calc_jacobian(self.plant, self.context(below), *frames)
            traced = self._expressions.entries(J[:, [self._drake.position_indices[joint] for joint in joints]])
            for joint, column in zip(joints, zip(*traced, strict=True), strict=True):
                columns[joint] = column
        return tuple(zip(*columns, strict=True))

    @property
    def generators(self) -> set[Generator]:
        """The constants and lengths that the fixed poses hold."""
        return generators_of(
            entry
            for offset in self.offsets.values()
            for entry in (*offset.translation, *(entry for row in offset.rotation for entry in row))
        )

    def context(self, depth: int) -> Any:
        """Return the context with joint variables and exact poses from a depth onward."""
        if depth not in self._contexts:
            self._contexts[depth] = self._create_context(depth)
        return self._contexts[depth]

    @cached_property
    def growth(self) -> Mapping[int, float]:
        """How many times (log2, as measured) the angles and roots at each depth double the work of a product."""
        growth = {joint.index - 1: 1.5 for joint in self._joints if joint.kind == "revolute"}
        for index, offset in self.offsets.items():
            depth = self._offset_depths[index]
            found = generators_of(entry for row in offset.rotation for entry in row)
            more = sum({"cos": 1.5, "sqrt": 1.0}.get(kind, 0.0) for kind, _ in found)
            growth[depth] = growth.get(depth, 0.0) + more
        return growth

    def _frame(self, name: str) -> Any:
        return self.plant.get_frame(self._drake.frames[name].index())

    def _create_context(self, depth: int) -> Any:
        from pydrake.math import RigidTransform_, RotationMatrix_
        from pydrake.multibody.tree import BodyIndex, SpatialInertia_
        from pydrake.symbolic import Expression

        plant, context = self.plant, self.plant.CreateDefaultContext()
        one = Expression(1.0)
        # Drake evaluates inertias along with the kinematics and divides by zero at a body without mass.
        inertia = SpatialInertia_[Expression].SolidSphereWithMass(one, one)
        for i in range(1, plant.num_bodies()):
            plant.get_body(BodyIndex(i)).SetSpatialInertiaInBodyFrame(context, inertia)
        for index, offset in self.offsets.items():
            frame = frame_at(plant, index)
            if self._offset_depths[index] < depth:
                offset = _ZERO_OFFSET
            R = RotationMatrix_[Expression](
                np.array([[self._expressions.expression(e) for e in row] for row in offset.rotation])
            )
            p = np.array([self._expressions.expression(entry) for entry in offset.translation])
            frame.SetPoseInParentFrame(context, RigidTransform_[Expression](R, p))
        q = np.full(plant.num_positions(), Expression(0.0))
        for joint, position in enumerate(self._drake.position_indices):
            if joint >= depth:
                q[position] = Expression(self._expressions.joints[joint])
        plant.SetPositions(context, q)
        return context


def _body_depths(drake: DrakeArm) -> dict[int, int]:
    """Return the number of moving joints between the base and each body, by the index of the body; −1 below the base."""
    plant = drake.plant
    moving = {joint.index() for joint in drake.joints}
    joints = [plant.get_joint(index) for index in plant.GetJointIndices()]
    depths = dict.fromkeys(range(plant.num_bodies()), -1)
    reached = [drake.base.index()]
    depths[int(reached[0])] = 0
    for parent in reached:
        for joint in joints:
            if joint.parent_body().index() == parent:
                reached.append(joint.child_body().index())
                depths[int(reached[-1])] = depths[int(parent)] + (joint.index() in moving)
    return depths
