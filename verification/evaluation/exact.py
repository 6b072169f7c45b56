"""The exact algebra: scalars of a ring, the arm's quantities from its symbolic trace."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from typing import Any

from armproof.models.arm import Arm
from armproof.models.exact.polynomial import Rows
from armproof.models.exact.trace import trace_of
from armproof.verification.algebra.angles import cos_sin
from armproof.verification.algebra.budget import Budget
from armproof.verification.algebra.calculus import derivative, substitute
from armproof.verification.algebra.matrix import Matrix, column, exact_rank
from armproof.verification.algebra.protocol import Algebra, OutsideAlgebra, Value, link_matrix
from armproof.verification.algebra.quantity import COMPONENTS, Quantity
from armproof.verification.algebra.ring import Ring, Scalar
from armproof.verification.algebra.roots import arc, atan2, sqrt
from armproof.verification.errors import EvaluationError, TooComplex
from armproof.verification.findings import Kind, finding_of, say


class ArmAlgebra(Algebra):
    """An algebra that takes the poses and Jacobians of an arm from its plant; without an arm it has link matrices only."""

    def __init__(self, arm: Arm | None) -> None:
        self.arm = arm
        self._cache: dict[Quantity, Value] = {}

    @property
    def exact(self) -> Algebra | None:
        """An algebra of its own, which samples no other."""
        return None

    def from_exact(self, value: Value) -> Value:
        """Return a value of the algebra itself."""
        return value

    def at(self, values: Mapping[str, Any]) -> Algebra | None:
        """Values are substituted afterwards."""
        return None

    def divide_by(self, denominator: Any) -> None:
        """Divide by anything that is not zero."""

    @abstractmethod
    def pose(self, frame: str, reference: str) -> Matrix:
        """Return ^{reference}T_{frame}, 4×4."""

    @abstractmethod
    def jacobian(self, frame: str, expressed_in: str) -> Matrix:
        """Return the 6×n Jacobian at the frame's origin, relative to the arm's first frame, rows [v; ω]."""

    def quantity(self, quantity: Quantity) -> Value:
        """Return a quantity of the arm: a Matrix, or a scalar where one component is meant."""
        if quantity not in self._cache:
            whole = self.whole(quantity)
            self._cache[quantity] = whole.rows[0][0] if whole.shape == (1, 1) else _select(quantity, whole)
        return self._cache[quantity]

    def whole(self, quantity: Quantity) -> Matrix:
        """Return the matrix or column of which the quantity may be a few rows and columns."""
        if quantity.kind == "link":
            return link_matrix(self, quantity.frame)
        assert self.arm is not None
        if quantity.kind == "joint":
            return column([self.symbol(quantity.frame)])
        if quantity.kind == "vector":
            return column([self.symbol(joint.symbol) for joint in self.arm.joints])
        if quantity.kind == "jacobian":
            return self.jacobian(quantity.frame, quantity.reference)
        if quantity.kind in _OF_JACOBIAN:
            return _OF_JACOBIAN[quantity.kind](self, quantity)
        pose = self.pose(quantity.frame, quantity.reference)
        if quantity.kind == "difference":
            start = self.pose(quantity.start, quantity.reference)
            pairs = zip(_origin(pose), _origin(start), strict=True)
            return column([to - since for to, since in pairs])
        return _part_of_pose(quantity, pose)


def _velocity(algebra: ArmAlgebra, quantity: Quantity) -> Matrix:
    assert algebra.arm is not None
    rates = column([algebra.symbol(f"dot {joint.symbol}") for joint in algebra.arm.joints])
    return algebra.jacobian(quantity.frame, quantity.reference) @ rates


def _angle(algebra: ArmAlgebra, quantity: Quantity) -> Matrix:
    """The sum of the joints' angles of a planar arm, each with the sign of its axis: what J's last row holds."""
    assert algebra.arm is not None
    joints = column([algebra.symbol(joint.symbol) for joint in algebra.arm.joints])
    return algebra.jacobian(quantity.frame, algebra.arm.frames[0]).block([5], range(len(algebra.arm.joints))) @ joints


def _task(algebra: ArmAlgebra, quantity: Quantity) -> Matrix:
    pose = algebra.pose(quantity.frame, quantity.reference)
    return Matrix((*pose.block(range(2), [3]).rows, *_angle(algebra, quantity).rows))


def _determinant(algebra: ArmAlgebra, quantity: Quantity) -> Matrix:
    return column([_rows_of_jacobian(algebra, quantity).determinant()])


def _manipulability(algebra: ArmAlgebra, quantity: Quantity) -> Matrix:
    part = _rows_of_jacobian(algebra, quantity)
    return column([algebra.sqrt((part @ part.transpose).determinant())])


def _rows_of_jacobian(algebra: ArmAlgebra, quantity: Quantity) -> Matrix:
    whole = algebra.jacobian(quantity.frame, quantity.reference)
    return whole.block([row - 1 for row in quantity.rows or range(1, 7)], range(whole.shape[1]))


_OF_JACOBIAN: Mapping[str, Callable[[ArmAlgebra, Quantity], Matrix]] = {
    "velocity": _velocity,
    "angle": _angle,
    "task": _task,
    "determinant": _determinant,
    "manipulability": _manipulability,
}


def _origin(pose: Matrix) -> Sequence[Any]:
    return pose.block(range(3), [3]).vector()


def _part_of_pose(quantity: Quantity, pose: Matrix) -> Matrix:
    if quantity.kind == "rotation":
        return pose.block(range(3), range(3))
    if quantity.kind == "origin":
        return pose.block(range(4 if quantity.homogeneous else 3), [3])
    if quantity.kind == "axis":
        return pose.block(range(4 if quantity.homogeneous else 3), [COMPONENTS[quantity.along]])
    return pose


def _select(quantity: Quantity, whole: Matrix) -> Value:
    size, width = whole.shape
    rows = quantity.rows or tuple(range(1, size + 1))
    columns = quantity.columns or tuple(range(1, width + 1))
    if max(rows) > size or max(columns) > width:
        raise EvaluationError(say(Kind.BEYOND_MATRIX, last_row=max(rows), last_column=max(columns), size=whole.size))
    chosen = whole.block([r - 1 for r in rows], [c - 1 for c in columns])
    return chosen.rows[0][0] if quantity.scalar else chosen


class ExactAlgebra(ArmAlgebra):
    """Scalars of a ring; the arm's quantities as its symbolic trace gives them."""

    def __init__(self, ring: Ring, arm: Arm | None) -> None:
        super().__init__(arm)
        self.ring = ring

    @property
    def budget(self) -> Budget:
        return self.ring.budget

    def rational(self, value: Fraction) -> Scalar:
        return self.ring.rational(value)

    def pi(self) -> Scalar:
        return self.ring.generator(("pi", ""))

    def symbol(self, name: str) -> Scalar:
        return self.ring.symbol(name)

    def cos_sin(self, angle: Scalar) -> tuple[Scalar, Scalar]:
        """Return (cos, sin) of a sum of angles; raises OutsideAlgebra for what is none, such as cos(ω t)."""
        try:
            return cos_sin(angle)
        except TooComplex:
            raise
        except EvaluationError as problem:
            raise OutsideAlgebra(finding_of(problem)) from None

    def sqrt(self, value: Scalar) -> Scalar:
        return sqrt(value)

    def atan2(self, y: Scalar, x: Scalar) -> Scalar:
        """Return the angle of the point (x, y)."""
        return atan2(y, x)

    def arc(self, function: str, arguments: list[Scalar]) -> Scalar:
        """Return an arc function as an angle whose cosine and sine are known."""
        if function == "atan2":
            return self.atan2(*arguments)
        (u,) = arguments
        if function == "atan":
            return self.atan2(u, self.ring.one)
        other = self.sqrt(self.ring.one - u * u)
        return arc(u, other) if function == "acos" else arc(other, u)

    def absolute(self, value: Scalar) -> Scalar:
        number = value.as_fraction()
        if number is None:
            raise OutsideAlgebra(say(Kind.ABSOLUTE_VALUE))
        return self.ring.rational(abs(number))

    def derivative(self, value: Scalar, variable: Scalar) -> Scalar:
        return derivative(value, variable)

    def rank(self, matrix: Matrix) -> Scalar:
        return self.ring.rational(exact_rank(matrix))

    def substitute(self, value: Value, values: Mapping[str, Scalar]) -> Value:
        """Return a value with joint variables and lengths replaced."""
        if isinstance(value, Matrix):
            return value.map(lambda cell: substitute(cell, values))
        return substitute(value, values)

    def pose(self, frame: str, reference: str) -> Matrix:
        assert self.arm is not None
        return self._from_entries(trace_of(self.arm).pose(frame, reference))

    def jacobian(self, frame: str, expressed_in: str) -> Matrix:
        assert self.arm is not None
        return self._from_entries(trace_of(self.arm).jacobian(frame, expressed_in, self.arm.frames[0]))

    def _from_entries(self, rows: Rows) -> Matrix:
        return Matrix(tuple(tuple(self.ring.from_entry(entry) for entry in row) for row in rows))
