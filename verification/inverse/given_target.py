"""An algebra to which the target is given: cells of poses and named angles have values of their own."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Sequence
from fractions import Fraction
from typing import Any

from armproof.models.arm import Arm
from armproof.verification.algebra.matrix import Matrix, as_matrix
from armproof.verification.algebra.protocol import Value
from armproof.verification.algebra.quantity import Quantity
from armproof.verification.errors import EvaluationError
from armproof.verification.evaluation.exact import TracedAlgebra
from armproof.verification.findings import Kind, say
from armproof.verification.inverse.target import Target


class GivenTarget(TracedAlgebra):
    """An algebra over an arm in which the poses of the target are what is given, and every other is that of the joints."""

    arm: Arm
    target: Target
    solved: dict[str, Any]  # the value of each joint; filled as a derivation goes on
    given: dict[str, Any]  # the value of each slot that a display defines

    def give(self, target: Target, values: Sequence[Any]) -> None:
        """Take the value of each slot of the target."""
        self.target = target
        self.given = {slot.key: value for slot, value in zip(target.slots, values, strict=True) if slot.is_name}
        self._values = tuple(values)

    @abstractmethod
    def solve(self, joint: str, value: Any) -> None:
        """Give a joint its value."""

    def named(self, key: str, value: Value) -> Value:
        """Return what stands for the value of a name from here on: the value itself."""
        return value

    def quantity(self, quantity: Quantity) -> Value:
        """Return a quantity: of the target if it is made of what is given, else of the joints solved so far."""
        if (quantity.frame, quantity.reference) not in self.target.pairs or quantity.kind == "jacobian":
            return super().quantity(quantity)
        try:
            value = super().quantity(quantity)
            cells = as_matrix(value).cells
        except TypeError:  # a difference of an origin that is not given
            cells = (None,)
        if any(cell is None for cell in cells):
            self._cache.pop(quantity, None)
            raise EvaluationError(say(Kind.NOT_IN_TARGET, frame=quantity.frame))
        return value

    def pose(self, frame: str, reference: str) -> Matrix:
        """Return the pose, with None for the cells that the target leaves open."""
        if (frame, reference) not in self.target.pairs:
            return super().pose(frame, reference)
        cells = self.target.cells((frame, reference))
        last = tuple(self.rational(Fraction(number)) for number in (0, 0, 0, 1))
        given = {place: self._values[index] for place, index in cells.items()}
        return Matrix((*(tuple(given.get((r, c)) for c in range(4)) for r in range(3)), last))
