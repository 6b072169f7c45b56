"""The target as a function of the configuration: what the inverse is the inverse of."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from armproof.verification.algebra.quantity import Quantity
from armproof.verification.errors import EvaluationError
from armproof.verification.inverse.derivation import Derivation, SolvingAlgebra
from armproof.verification.inverse.resolution import Resolution
from armproof.verification.inverse.target import Slot, Target


def forward_values(derivation: Derivation, algebra: SolvingAlgebra) -> list[Any]:
    """Return each slot of the target as a value of the algebra, in which every joint must have one.

    Raises:
        EvaluationError: a name of the target that no display gives a value by the joints.
    """
    free = replace(derivation, target=Target((), (0,), ()), choice={})
    resolution = Resolution(free, algebra, {})
    return [_value(slot, resolution, algebra) for slot in derivation.target.slots]


def _value(slot: Slot, resolution: Resolution, algebra: SolvingAlgebra) -> Any:
    if not slot.is_name:
        quantity = Quantity("pose", slot.frame, slot.reference, (slot.row + 1,), (slot.column + 1,), scalar=True)
        return algebra.quantity(quantity)
    try:
        return resolution.value(slot.key)
    except EvaluationError as error:
        raise EvaluationError(
            f"'{slot.label}' of the target is neither in `quantities` nor defined by a display: {error}"
        ) from None
