"""The exact algebra: scalars of a ring, the arm's quantities from its symbolic trace."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from armproof.models.arm import Arm
from armproof.models.exact.polynomial import Entry, Rows
from armproof.models.exact.trace import trace_of
from armproof.verification.algebra.angles import cos_sin
from armproof.verification.algebra.budget import Budget
from armproof.verification.algebra.calculus import derivative, substitute, symbols_in
from armproof.verification.algebra.matrix import Matrix, exact_rank
from armproof.verification.algebra.protocol import OutsideAlgebra, Value
from armproof.verification.algebra.quantity import Quantity
from armproof.verification.algebra.quantity_kinds import OfArm, kind_of
from armproof.verification.algebra.ring import Ring, Scalar
from armproof.verification.algebra.roots import arc, atan2, sqrt
from armproof.verification.errors import EvaluationError, TooComplex
from armproof.verification.findings import Kind, finding_of, say


class ArmAlgebra(OfArm):
    """An algebra that takes the poses and Jacobians of an arm from its plant; without an arm it has link matrices only."""

    def __init__(self, arm: Arm | None) -> None:
        self.arm = arm
        self._cache: dict[Quantity, Value] = {}

    def quantity(self, quantity: Quantity) -> Value:
        """Return a quantity of the arm: a Matrix, or a scalar where one component is meant; raises EvaluationError."""
        if (
            self.arm is None and quantity.kind != "link"
        ):  # a definition of an arm's document, in a statement of any link
            raise EvaluationError(say(Kind.NO_ARM_TO_COMPARE))
        if quantity not in self._cache:
            whole = self.whole(quantity)
            self._cache[quantity] = whole.rows[0][0] if whole.shape == (1, 1) else _select(quantity, whole)
        return self._cache[quantity]

    def whole(self, quantity: Quantity) -> Matrix:
        """Return the matrix or column of which the quantity may be a few rows and columns."""
        return kind_of(quantity).whole(quantity, self)


class TracedAlgebra(ArmAlgebra):
    """An algebra that takes the poses and Jacobians of an arm from its exact trace, entry by entry, each once."""

    def __init__(self, arm: Arm | None) -> None:
        super().__init__(arm)
        self._poses: dict[tuple[str, str], Matrix] = {}
        self._jacobians: dict[tuple[str, str], Matrix] = {}

    @abstractmethod
    def from_entry(self, entry: Entry) -> Any:
        """Return an exact entry as a scalar."""

    def pose(self, frame: str, reference: str) -> Matrix:
        assert self.arm is not None
        if (frame, reference) not in self._poses:
            self._poses[frame, reference] = self._from_entries(trace_of(self.arm).pose(frame, reference))
        return self._poses[frame, reference]

    def jacobian(self, frame: str, expressed_in: str) -> Matrix:
        assert self.arm is not None
        if (frame, expressed_in) not in self._jacobians:
            rows = trace_of(self.arm).jacobian(frame, expressed_in, self.arm.frames[0])
            self._jacobians[frame, expressed_in] = self._from_entries(rows)
        return self._jacobians[frame, expressed_in]

    def _from_entries(self, rows: Rows) -> Matrix:
        return Matrix(tuple(tuple(self.from_entry(entry) for entry in row) for row in rows))


def _select(quantity: Quantity, whole: Matrix) -> Value:
    size, width = whole.shape
    rows = quantity.rows or tuple(range(1, size + 1))
    columns = quantity.columns or tuple(range(1, width + 1))
    if max(rows) > size or max(columns) > width:
        raise EvaluationError(say(Kind.BEYOND_MATRIX, last_row=max(rows), last_column=max(columns), size=whole.size))
    chosen = whole.block([r - 1 for r in rows], [c - 1 for c in columns])
    return chosen.rows[0][0] if quantity.scalar else chosen


class ExactAlgebra(TracedAlgebra):
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

    def symbols(self, value: Scalar) -> set[str]:
        return symbols_in([value])

    def rank(self, matrix: Matrix) -> Scalar:
        return self.ring.rational(exact_rank(matrix))

    def substitute(self, value: Value, values: Mapping[str, Scalar]) -> Value:
        """Return a value with joint variables and lengths replaced."""
        if isinstance(value, Matrix):
            return value.map(lambda cell: substitute(cell, values))
        return substitute(value, values)

    def from_entry(self, entry: Entry) -> Scalar:
        return self.ring.from_entry(entry)
