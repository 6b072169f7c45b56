"""Matrices put together from scalars and blocks; their transposes, inverses and pseudo-inverses."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from armproof.verification.algebra.matrix import Matrix
from armproof.verification.algebra.protocol import Value
from armproof.verification.algebra.values import Identity, as_scalar, identity, is_zero
from armproof.verification.errors import EvaluationError, ShapeError
from armproof.verification.evaluation.evaluating import Evaluating
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n


def matrix_value(evaluator: Evaluating, node: n.Matrix) -> Value:
    """Return a matrix of scalars or blocks, or the determinant that its bars stand for."""
    rows = [[as_scalar(evaluator.evaluate(cell)) for cell in row] for row in node.rows]
    rows = [[cell for value in row for cell in (value if isinstance(value, list) else [value])] for row in rows]
    if not any(isinstance(cell, Matrix | Identity) for row in rows for cell in row):
        widths = {len(row) for row in rows}
        if len(widths) > 1:
            raise ShapeError(say(Kind.RAGGED_ROWS, widths=sorted(widths)))
        whole = Matrix(tuple(tuple(row) for row in rows))
    else:
        whole = _assemble(evaluator, rows)
    return whole.determinant() if node.environment in ("vmatrix", "Vmatrix") else whole


def _assemble(evaluator: Evaluating, rows: list[list[Any]]) -> Matrix:
    """Assemble blocks: 0 and I take the size that their row and column leave them."""
    heights = [max([cell.shape[0] for cell in row if isinstance(cell, Matrix)], default=1) for row in rows]
    width_of: dict[int, int] = {}
    aligned = len({len(row) for row in rows}) == 1
    if aligned:
        for k in range(len(rows[0])):
            width_of[k] = max([row[k].shape[1] for row in rows if isinstance(row[k], Matrix)], default=0)
        for r, row in enumerate(rows):
            for k, cell in enumerate(row):
                if isinstance(cell, Identity) and not width_of[k]:
                    width_of[k] = heights[r]
                elif isinstance(cell, Identity) and heights[r] == 1:
                    heights[r] = width_of[k]
    assembled: list[tuple[Any, ...]] = []
    for r, row in enumerate(rows):
        blocks = [
            _fit(evaluator, cell, heights[r], (width_of.get(k) or 1) if aligned else 1) for k, cell in enumerate(row)
        ]
        if any(block.shape[0] != heights[r] for block in blocks):
            raise ShapeError(say(Kind.RAGGED_BLOCKS, sizes=[b.size for b in blocks]))
        assembled.extend(tuple(cell for block in blocks for cell in block.rows[line]) for line in range(heights[r]))
    widths = {len(row) for row in assembled}
    if len(widths) > 1:
        raise ShapeError(say(Kind.RAGGED_BLOCK_ROWS, widths=sorted(widths)))
    return Matrix(tuple(assembled))


def _fit(evaluator: Evaluating, cell: Any, height: int, width: int) -> Matrix:
    if isinstance(cell, Matrix):
        return cell
    if isinstance(cell, Identity):
        return identity(evaluator.algebra, height, cell.scale)
    if (height, width) == (1, 1) or is_zero(cell):
        return Matrix(tuple((cell,) * width for _ in range(height)))
    raise ShapeError(say(Kind.SCALAR_FOR_BLOCK, size=f"{height}×{width}"))


def postfix_value(evaluator: Evaluating, node: n.Postfix) -> Value:
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
        raise EvaluationError(say(Kind.OPERATOR_ON_SCALAR, operator=node.operator))
    if node.operator == "T":
        return value.transpose
    if node.operator == "-1":
        return inverse(evaluator, value)
    if node.operator == "-T":
        return inverse(evaluator, value).transpose
    return _pseudo_inverse(evaluator, value)


def inverse(evaluator: Evaluating, matrix: Matrix) -> Matrix:
    """Return the inverse of a square matrix; raises ShapeError where it has none."""
    if matrix.shape[0] != matrix.shape[1]:
        raise ShapeError(say(Kind.NO_INVERSE_OF_SIZE, size=matrix.size))
    one = evaluator.algebra.rational(Fraction(1))
    determinant = matrix.determinant()
    if is_zero(determinant):
        raise ShapeError(say(Kind.SINGULAR, size=matrix.size))
    evaluator.algebra.divide_by(determinant)
    factor = one / determinant
    return matrix.adjugate().map(lambda cell: cell * factor)


def _pseudo_inverse(evaluator: Evaluating, matrix: Matrix) -> Matrix:
    """J^T (J J^T)^{-1} where J is wide, (J^T J)^{-1} J^T where it is tall (each for full rank)."""
    size, width = matrix.shape
    if size == width:
        return inverse(evaluator, matrix)
    transposed = matrix.transpose
    if size < width:
        return transposed @ inverse(evaluator, matrix @ transposed)
    return inverse(evaluator, transposed @ matrix) @ transposed


def printed_rows(evaluator: Evaluating, node: n.Node, value: Value) -> Value:
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
