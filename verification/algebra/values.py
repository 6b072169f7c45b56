"""Values of expressions: scalars, matrices, lists that stand for columns, identities without a size."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from armproof.verification.algebra.matrix import Matrix, column
from armproof.verification.algebra.protocol import Algebra, Value
from armproof.verification.errors import EvaluationError
from armproof.verification.findings import Kind, say


@dataclass(frozen=True)
class Identity:
    """An identity matrix times a scalar, as in λ²I, whose size is left to its surroundings."""

    scale: Any


def identity(algebra: Algebra, size: int, scale: Any = None) -> Matrix:
    """Return the identity matrix of a size, times a scalar if one is given."""
    one, zero = algebra.rational(Fraction(1)) if scale is None else scale, algebra.rational(Fraction(0))
    return Matrix(tuple(tuple(one if r == c else zero for c in range(size)) for r in range(size)))


def no_size() -> Any:
    """Refuse an identity matrix of unknown size where the size matters."""
    raise EvaluationError(say(Kind.IDENTITY_OF_NO_SIZE))


def stacked(value: Value) -> Value:
    """Return a list of values as the column that it stands for."""
    if not isinstance(value, list):
        return value
    if any(isinstance(cell, Matrix | Identity | list) for cell in value):
        raise EvaluationError(say(Kind.MATRICES_FOR_VALUE))
    return column(value)


def sized(value: Value) -> Value:
    """Return a value of which the size is known."""
    return no_size() if isinstance(value, Identity) else stacked(value)


def as_scalar(value: Value) -> Value:
    """Return the entry of a 1×1 matrix, anything else as it is."""
    return value.rows[0][0] if isinstance(value, Matrix) and value.shape == (1, 1) else value


def is_zero(value: Any) -> bool:
    """Whether a scalar of either algebra vanishes everywhere."""
    if hasattr(value, "is_zero"):
        return bool(value.is_zero())
    return bool((value == 0).all()) if hasattr(value, "all") else value == 0
