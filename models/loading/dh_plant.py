"""Build the arm of a DH table: a MultibodyPlant with one link a row, and the exact poses of its fixed frames."""

from __future__ import annotations

from collections.abc import Mapping
from hashlib import sha256
from itertools import count
from math import pi
from types import MappingProxyType
from typing import Any

import numpy as np

from armproof.models.arm import Arm, Joint
from armproof.models.dh.entry import LinearForm
from armproof.models.dh.pose import FixedPose
from armproof.models.dh.table import DHRow, DHTable
from armproof.models.exact.numbers import add_angles, cos_sin_of_pi, cos_sin_of_radians, rotation
from armproof.models.exact.offset import Offset
from armproof.models.exact.polynomial import Entry, Rows, add, generator, matrix_product, number, scale
from armproof.models.exact.symbolic import SymbolicPlant
from armproof.models.language import noted
from armproof.models.numeric.drake_arm import DrakeArm

NAME = "DH table"
_LENGTHS = (0.431, 0.317, 0.283, 0.523, 0.229, 0.613, 0.367, 0.571, 0.271, 0.701, 0.349, 0.467, 0.757, 0.389, 0.647)
_ANGLES = (0.41, 0.73, 1.13, 0.59, 0.97, 0.29, 1.31, 0.83)


def build_arm(table: DHTable, values: Mapping[str, float] = MappingProxyType({})) -> Arm:
    """Build the arm of a DH table.

    Link i carries the frame behind the i-th joint and what is fixed to it; a joint is named by its variable. Each length symbol is given a positive value
    (m) and each constant angle symbol a value (rad) of its own, always the same; they serve the plant of doubles only.

    Args:
        values: other values of lengths (m).
    """
    from pydrake.multibody.plant import MultibodyPlant

    lengths = dict(zip(table.length_symbols, _values(_LENGTHS), strict=False))
    lengths |= {symbol: values[symbol] for symbol in lengths if symbol in values}
    angles = dict(zip(table.angle_symbols, _values(_ANGLES), strict=False))
    plant = MultibodyPlant(time_step=0.0)
    builder = _Builder(plant, {**lengths, **angles})
    frames = [builder.add_base()]
    drake_joints = []
    if table.base is not None:
        frames.append(builder.add_pose("base_pose", frames[-1], table.base))
    for i, row in enumerate(table.rows, start=1):
        joint, frame = builder.add_row(i, row, frames[-1], classic=table.convention == "classic")
        drake_joints.extend([] if joint is None else [joint])
        frames.append(frame)
    if table.tool is not None:
        frames.append(builder.add_pose("tool_pose", frames[-1], table.tool))
    plant.Finalize()
    joints = tuple(
        Joint(i, row.joint, row.joint, "revolute" if row.kind == "revolute" else "prismatic", *_limits(row))
        for i, row in enumerate(table.joint_rows, start=1)
    )
    named = dict(zip(table.frames, frames, strict=True))
    drake = DrakeArm(plant, frames[0].body(), tuple(drake_joints), MappingProxyType(named))
    return Arm(
        name=NAME,
        title=noted("Arm of a classic DH table")
        if table.convention == "classic"
        else noted("Arm of a modified DH table"),
        source="",
        zero="",
        joints=joints,
        lengths=MappingProxyType(lengths),
        angles=MappingProxyType(angles),
        frames=table.frames,
        exact=SymbolicPlant(NAME, joints, drake, builder.offsets),
        drake=drake,
        dh=table,
        digest=sha256(repr(table).encode()).hexdigest(),
    )


def _values(fixed: tuple[float, ...]) -> Any:
    """Yield the values of a list, then as many more, pairwise different."""
    yield from fixed
    for k in count(1):
        yield from (value + 0.0007 * k for value in fixed)


def _limits(row: DHRow) -> tuple[float, float]:
    return (-pi, pi) if row.kind == "revolute" else (-1.0, 1.0)


class _Builder:
    """Adds links, joints and fixed frames to a plant, and notes the exact pose of every fixed frame."""

    def __init__(self, plant: Any, values: dict[str, float]) -> None:
        self.plant = plant
        self.values = values
        self.offsets: dict[int, Offset] = {}

    def add_base(self) -> Any:
        base = self._add_link(0)
        self.plant.WeldFrames(self.plant.world_frame(), base.body_frame())
        return base.body_frame()

    def add_pose(self, name: str, previous: Any, pose: FixedPose) -> Any:
        """Add a frame at a fixed pose Trans(xyz) Rz(yaw) Ry(pitch) Rx(roll) in the one before."""
        from pydrake.math import RigidTransform, RollPitchYaw

        turns = [rotation(axis, cos_sin(angle)) for axis, angle in enumerate(pose.rpy)]
        R = matrix_product(matrix_product(turns[2], turns[1]), turns[0])
        offset = Offset(R, tuple(map(exact_length, pose.xyz)))
        rpy, xyz = (np.array([form.value(self.values) for form in forms]) for forms in (pose.rpy, pose.xyz))
        return self._add_fixed(name, previous, RigidTransform(RollPitchYaw(rpy), xyz), offset)

    def add_row(self, i: int, row: DHRow, previous: Any, classic: bool) -> tuple[Any, Any]:
        """Add the i-th row on the DH frame i−1, a link where it has a joint; return that joint, or None, and frame i."""
        from pydrake.multibody.tree import PrismaticJoint, RevoluteJoint

        if not row.joint:
            steps = row.theta, row.d, row.a, row.alpha
            return None, self._add_frame(f"frame_{i}", previous, *steps, alpha_first=not classic)
        zero = LinearForm()
        revolute = row.kind == "revolute"
        theta, d = (row.theta.without(row.joint), row.d) if revolute else (row.theta, row.d.without(row.joint))
        # What is constant and commutes with the motion of the joint, about or along z, stands before it.
        if classic:
            before = (theta, zero, zero, zero) if revolute else (theta, d, zero, zero)
        else:
            before = (theta, d, row.a, row.alpha)
        link = self._add_link(i)
        parent = self._add_frame(f"{row.joint}_parent", previous, *before, alpha_first=True)
        kind = RevoluteJoint if revolute else PrismaticJoint
        lower, upper = _limits(row)
        axis: Any = np.array([0.0, 0.0, row.sign])
        joint = self.plant.AddJoint(
            kind(row.joint, parent, link.body_frame(), axis, pos_lower_limit=lower, pos_upper_limit=upper)
        )
        if not classic:
            return joint, link.body_frame()
        after = (zero, d if revolute else zero, row.a, row.alpha)
        return joint, self._add_frame(f"frame_{i}", link.body_frame(), *after, alpha_first=False)

    def _add_link(self, i: int) -> Any:
        from pydrake.multibody.tree import SpatialInertia

        inertia = SpatialInertia.SolidSphereWithMass(mass=1.0, radius=0.05)
        return self.plant.AddRigidBody(f"link_{i}", inertia)

    def _add_frame(
        self,
        name: str,
        parent: Any,
        theta: LinearForm,
        z: LinearForm,
        x: LinearForm,
        alpha: LinearForm,
        *,
        alpha_first: bool,
    ) -> Any:
        """Add the frame Rx(α) T(x, 0, z) Rz(θ) if alpha_first, else Rz(θ) T(x, 0, z) Rx(α), with T in the axes so far."""
        from pydrake.math import RigidTransform, RotationMatrix

        Rx = RigidTransform(RotationMatrix.MakeXRotation(alpha.value(self.values)))
        Rz = RigidTransform(RotationMatrix.MakeZRotation(theta.value(self.values)))
        T = RigidTransform(np.array([x.value(self.values), 0.0, z.value(self.values)]))
        X_PF = Rx @ T @ Rz if alpha_first else Rz @ T @ Rx
        first, last = rotation(0, cos_sin(alpha)), rotation(2, cos_sin(theta))
        if not alpha_first:
            first, last = last, first
        column: Rows = ((exact_length(x),), (number(0),), (exact_length(z),))
        translation = tuple(row[0] for row in matrix_product(first, column))
        return self._add_fixed(name, parent, X_PF, Offset(matrix_product(first, last), translation))

    def _add_fixed(self, name: str, parent: Any, X_PF: Any, exact: Offset) -> Any:
        from pydrake.multibody.tree import FixedOffsetFrame

        frame = self.plant.AddFrame(FixedOffsetFrame(name, parent, X_PF))
        self.offsets[int(frame.index())] = exact
        return frame


def cos_sin(form: LinearForm) -> tuple[Entry, Entry]:
    """Return the cosine and sine of an angle of constants and symbols, by the angle-sum formulas."""
    total = add_angles(cos_sin_of_pi(form.pi), cos_sin_of_radians(form.number))
    for symbol, coefficient in form.symbols:
        sign = 1 if coefficient > 0 else -1
        angle = generator("cos", symbol), scale(generator("sin", symbol), sign)
        for _ in range(abs(int(coefficient))):
            total = add_angles(total, angle)
    return total


def exact_length(form: LinearForm) -> Entry:
    """Return a length of numbers and symbols as an entry."""
    terms = (scale(generator("symbol", symbol), coefficient) for symbol, coefficient in form.symbols)
    return add(number(form.number), *terms)
