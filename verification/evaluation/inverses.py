"""Transposes, inverses and pseudo-inverses, and the square rows of a Jacobian that an inverse is of."""

from __future__ import annotations

from fractions import Fraction
from typing import TYPE_CHECKING, Any

from armproof.verification.algebra.matrix import Matrix
from armproof.verification.algebra.protocol import Algebra, Value
from armproof.verification.algebra.values import Identity, as_scalar, is_zero
from armproof.verification.errors import EvaluationError, ShapeError
from armproof.verification.evaluation.sampled import SampledAlgebra
from armproof.verification.latex import nodes as n

if TYPE_CHECKING:
    from armproof.verification.evaluation.evaluator import Evaluator


def postfix_value(evaluator: Evaluator, node: n.Postfix) -> Value:
    """Return a transpose, an inverse, a pseudo-inverse or degrees."""
    if node.operator == "deg":
        return evaluator.scalar(node.base) * evaluator.algebra.pi() / evaluator.algebra.rational(Fraction(180))
    value = as_scalar(evaluator.evaluate(node.base))
    if node.operator == "-1":
        value = printed_rows(evaluator, node.base, value)
    if isinstance(value, list):
        value = Matrix((tuple(value),))
    if isinstance(value, Identity):
        one = evaluator.algebra.rational(Fraction(1))
        return value if node.operator == "T" else Identity(one / value.scale)
    if not isinstance(value, Matrix):
        if node.operator == "T":
            return value
        if node.operator == "-1":
            return evaluator.algebra.rational(Fraction(1)) / value
        raise EvaluationError(f"'{node.operator}' on a scalar")
    if node.operator == "T":
        return value.transpose
    if node.operator == "-1":
        return inverse(evaluator, value)
    if node.operator == "-T":
        return inverse(evaluator, value).transpose
    return _pseudo_inverse(evaluator, value)


def inverse(evaluator: Evaluator, matrix: Matrix) -> Matrix:
    """Return the inverse of a square matrix; raises ShapeError where it has none."""
    if matrix.shape[0] != matrix.shape[1]:
        raise ShapeError(f"a {matrix.size} matrix has no inverse")
    one = evaluator.algebra.rational(Fraction(1))
    determinant = matrix.determinant()
    if is_zero(determinant):
        raise ShapeError(f"the {matrix.size} matrix has no inverse: its determinant is 0 for every configuration")
    divide_by(evaluator.algebra, determinant)
    factor = one / determinant
    return matrix.adjugate().map(lambda cell: cell * factor)


def _pseudo_inverse(evaluator: Evaluator, matrix: Matrix) -> Matrix:
    """J^T (J J^T)^{-1} where J is wide, (J^T J)^{-1} J^T where it is tall (each for full rank)."""
    size, width = matrix.shape
    if size == width:
        return inverse(evaluator, matrix)
    transposed = matrix.transpose
    if size < width:
        return transposed @ inverse(evaluator, matrix @ transposed)
    return inverse(evaluator, transposed @ matrix) @ transposed


def printed_rows(evaluator: Evaluator, node: n.Node, value: Value) -> Value:
    """The determinant and the inverse of a Jacobian are of the square part that the document prints."""
    node = n.ungrouped(node)
    if isinstance(node, n.Call) and node.function == "name":
        node = node.arguments[0]
    rows = (
        evaluator.names.state.shown.get(node.key)
        if isinstance(node, n.Name) and node.key not in evaluator.names.quantities
        else None
    )
    if rows is None or not isinstance(value, Matrix) or value.shape[0] != 6 or len(rows) != value.shape[1]:
        return value
    return value.block([row - 1 for row in rows], range(value.shape[1]))


def divide_by(algebra: Algebra, denominator: Any) -> None:
    """Leave samples out at which a denominator is all but zero: rounding decides the quotient there."""
    if isinstance(algebra, SampledAlgebra):
        algebra.exclude_near_zeros(denominator)
