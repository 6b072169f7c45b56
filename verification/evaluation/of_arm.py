"""An algebra over an arm: how each quantity of the arm is made of its poses and Jacobians, in either algebra."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Mapping, Sequence
from typing import Any

from armproof.models.arm import Arm
from armproof.verification.algebra.matrix import Matrix, column
from armproof.verification.algebra.protocol import Algebra, Value, link_matrix
from armproof.verification.algebra.quantity import COMPONENTS, Quantity
from armproof.verification.errors import EvaluationError
from armproof.verification.findings import Kind, say


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
            self._cache[quantity] = _select(quantity, self.whole(quantity))
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
        pose = self.pose(quantity.frame, quantity.reference)
        if quantity.kind == "difference":
            start = self.pose(quantity.start, quantity.reference)
            pairs = zip(_origin(pose), _origin(start), strict=True)
            return column([to - since for to, since in pairs])
        return _part_of_pose(quantity, pose)


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
