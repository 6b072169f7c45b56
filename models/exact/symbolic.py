"""The symbolic plant of an arm: exact poses in, polynomials out."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np

from armproof.models.arm import Arm
from armproof.models.errors import ModelError
from armproof.models.exact.numbers import IDENTITY
from armproof.models.exact.offset import Offset, exact_offsets, frame_at
from armproof.models.exact.polynomial import Entry, Generator, Monomial, Rows, normal_form, number
from armproof.models.exact.polynomial import generators as generators_of

_MOST_WORK = 19
_ZERO_OFFSET = Offset(IDENTITY, (number(0),) * 3)


class SymbolicPlant:
    """`plant.ToSymbolic()` with the fixed poses of the arm made exact.

    Depth d of a frame: the number of moving joints between the base and its body. A pose relative to a frame of depth d
    does not depend on anything nearer to the base, and `context(d)` leaves that out: joints at zero, offsets at identity.
    That keeps the polynomials short.
    """

    def __init__(self, arm: Arm) -> None:
        from pydrake.symbolic import Variable

        self._arm = arm
        self.plant = arm.plant.ToSymbolic()
        self._depths = _body_depths(arm)
        self._offsets = {**exact_offsets(arm.plant), **arm.offsets}
        self._offset_depths = {
            index: self._depths[int(frame_at(arm.plant, index).body().index())] for index in self._offsets
        }
        self._contexts: dict[int, Any] = {}
        self._variables: dict[Generator | Fraction, Any] = {}
        self._meanings: dict[int, Generator | Fraction] = {}
        self._joint_variables = [Variable(joint.symbol) for joint in arm.joints]
        self._sine_cosine = {}
        for joint, variable in zip(arm.joints, self._joint_variables, strict=True):
            if joint.kind == "revolute":
                self._sine_cosine[variable] = self._sin_cos(joint.symbol)
            else:
                self._meanings[variable.get_id()] = ("symbol", joint.symbol)

    def frame(self, name: str) -> Any:
        """Return the frame of the symbolic plant for a document frame."""
        return self.plant.get_frame(self._arm.frame(name).index())

    def depth(self, name: str) -> int:
        """Return the number of moving joints between the base and a document frame."""
        return self._depths[int(self._arm.frame(name).body().index())]

    @property
    def generators(self) -> set[Generator]:
        """The constants and lengths that the fixed poses hold."""
        return generators_of(
            entry
            for offset in self._offsets.values()
            for entry in (*offset.translation, *(entry for row in offset.rotation for entry in row))
        )

    def context(self, depth: int) -> Any:
        """Return the context with joint variables and exact poses from a depth onward."""
        if depth not in self._contexts:
            self._contexts[depth] = self._create_context(depth)
        return self._contexts[depth]

    def check_size(self, depth: int, frames: tuple[str, ...], expressed_in: str | None = None) -> None:
        """Refuse a trace whose rotations from a depth to the frames multiply to more terms than two seconds allow.

        Raises:
            ModelError: the estimate, in bits, of the work is above 19 (a 12R arm with right angles, or 6R with symbols).
        """
        work = sum(self._work(depth, self.depth(frame)) for frame in frames)
        if expressed_in is not None:
            work += self._work(depth, self.depth(expressed_in)) / 2
        if work > _MOST_WORK:
            raise ModelError(
                f"arm '{self._arm.name}': too many symbolic angles between frames {', '.join(frames)} to multiply out; "
                "choose frames nearer to each other, or make constant angles multiples of pi/2"
            )

    def _work(self, depth: int, end: int) -> float:
        """Return how many times (log2, as measured) the angles and roots from one depth to another double the work."""
        work = 1.5 * sum(joint.kind == "revolute" for joint in self._arm.joints[max(depth, 0) : max(end, 0)])
        for index, offset in self._offsets.items():
            if depth <= self._offset_depths[index] < end:
                found = generators_of(entry for row in offset.rotation for entry in row)
                work += sum({"cos": 1.5, "sqrt": 1.0}.get(kind, 0.0) for kind, _ in found)
        return work

    def entries(self, expressions: np.ndarray) -> Rows:
        """Return a matrix of expressions as exact entries in normal form."""
        from pydrake.symbolic import Polynomial, Substitute

        flat: Any = np.asarray(expressions).reshape(-1, 1)
        if self._sine_cosine:
            flat = Substitute(flat, self._sine_cosine)
        entries = [self._entry(Polynomial(expression)) for expression in np.asarray(flat).ravel()]
        width = expressions.shape[1]
        return tuple(tuple(entries[i : i + width]) for i in range(0, len(entries), width))

    def _create_context(self, depth: int) -> Any:
        from pydrake.math import RigidTransform_, RotationMatrix_
        from pydrake.multibody.tree import BodyIndex, SpatialInertia_, UnitInertia_
        from pydrake.symbolic import Expression

        plant, context = self.plant, self.plant.CreateDefaultContext()
        one = Expression(1.0)
        # Drake evaluates inertias along with the kinematics and divides by zero at a body without mass.
        inertia = SpatialInertia_[Expression](one, [0 * one] * 3, UnitInertia_[Expression](one, one, one))
        for i in range(1, plant.num_bodies()):
            plant.get_body(BodyIndex(i)).SetSpatialInertiaInBodyFrame(context, inertia)
        for index, offset in self._offsets.items():
            frame = frame_at(plant, index)
            if self._offset_depths[index] < depth:
                offset = _ZERO_OFFSET
            R = RotationMatrix_[Expression](np.array([[self._expression(e) for e in row] for row in offset.rotation]))
            p = np.array([self._expression(entry) for entry in offset.translation])
            frame.SetPoseInParentFrame(context, RigidTransform_[Expression](R, p))
        q = np.full(plant.num_positions(), Expression(0.0))
        for joint, position in enumerate(self._arm.position_indices):
            if joint >= depth:
                q[position] = Expression(self._joint_variables[joint])
        plant.SetPositions(context, q)
        return context

    def _variable(self, meaning: Generator | Fraction) -> Any:
        """Return the variable that stands for a generator, or for a rational that a double cannot hold."""
        if meaning not in self._variables:
            from pydrake.symbolic import Variable

            variable = Variable(str(meaning))
            self._variables[meaning] = variable
            self._meanings[variable.get_id()] = meaning
        return self._variables[meaning]

    def _sin_cos(self, symbol: str) -> Any:
        from pydrake.symbolic import SinCos

        return SinCos(s=self._variable(("sin", symbol)), c=self._variable(("cos", symbol)))

    def _expression(self, entry: Entry) -> Any:
        from pydrake.symbolic import Expression

        total = Expression(0.0)
        for monomial, coefficient in entry.items():
            term = Expression(float(coefficient.numerator))
            if coefficient.denominator != 1:
                size = self._variable(abs(coefficient))
                term = Expression(size) if coefficient > 0 else -Expression(size)
            for generator, power in monomial:
                term = term * Expression(self._variable(generator)) ** power
            total = total + term
        return total

    def _entry(self, polynomial: Any) -> Entry:
        entry: dict[Monomial, Fraction] = {}
        for drake_monomial, expression in polynomial.monomial_to_coefficient_map().items():
            value = expression.Evaluate()
            if value != round(value):
                raise ModelError(f"arm '{self._arm.name}': {value} in the symbolic trace is not exact")
            coefficient = Fraction(round(value))
            powers: dict[Generator, int] = {}
            for variable, power in drake_monomial.get_powers().items():
                meaning = self._meanings[variable.get_id()]
                if isinstance(meaning, Fraction):
                    coefficient *= meaning**power
                else:
                    powers[meaning] = power
            monomial = tuple(sorted(powers.items()))
            entry[monomial] = entry.get(monomial, Fraction(0)) + coefficient
        return normal_form(entry)


def _body_depths(arm: Arm) -> dict[int, int]:
    """Return the number of moving joints between the base and each body, by the index of the body; −1 below the base."""
    plant = arm.plant
    moving = {joint.index() for joint in arm.drake_joints}
    joints = [plant.get_joint(index) for index in plant.GetJointIndices()]
    depths = dict.fromkeys(range(plant.num_bodies()), -1)
    reached = [arm.drake_base.index()]
    depths[int(reached[0])] = 0
    for parent in reached:
        for joint in joints:
            if joint.parent_body().index() == parent:
                reached.append(joint.child_body().index())
                depths[int(reached[-1])] = depths[int(parent)] + (joint.index() in moving)
    return depths
