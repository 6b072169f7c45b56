"""Matrices put together from scalars and blocks."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from armproof.verification.algebra.matrix import Matrix
from armproof.verification.algebra.protocol import Value
from armproof.verification.algebra.values import Identity, as_scalar, identity, is_zero
from armproof.verification.errors import ShapeError
from armproof.verification.latex import nodes as n

if TYPE_CHECKING:
    from armproof.verification.evaluation.evaluator import Evaluator


def matrix_value(evaluator: Evaluator, node: n.Matrix) -> Value:
    """Return a matrix of scalars or blocks, or the determinant that its bars stand for."""
    rows = [[as_scalar(evaluator.evaluate(cell)) for cell in row] for row in node.rows]
    rows = [[cell for value in row for cell in (value if isinstance(value, list) else [value])] for row in rows]
    if not any(isinstance(cell, Matrix | Identity) for row in rows for cell in row):
        widths = {len(row) for row in rows}
        if len(widths) > 1:
            raise ShapeError(f"the rows of a matrix have {', '.join(map(str, sorted(widths)))} cells")
        whole = Matrix(tuple(tuple(row) for row in rows))
    else:
        whole = _assemble(evaluator, rows)
    return whole.determinant() if node.environment in ("vmatrix", "Vmatrix") else whole


def _assemble(evaluator: Evaluator, rows: list[list[Any]]) -> Matrix:
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
            raise ShapeError(f"blocks of {', '.join(b.size for b in blocks)} stand in one row")
        assembled.extend(tuple(cell for block in blocks for cell in block.rows[line]) for line in range(heights[r]))
    widths = {len(row) for row in assembled}
    if len(widths) > 1:
        raise ShapeError(f"the rows of a block matrix have {', '.join(map(str, sorted(widths)))} columns")
    return Matrix(tuple(assembled))


def _fit(evaluator: Evaluator, cell: Any, height: int, width: int) -> Matrix:
    if isinstance(cell, Matrix):
        return cell
    if isinstance(cell, Identity):
        return identity(evaluator.algebra, height, cell.scale)
    if (height, width) == (1, 1) or is_zero(cell):
        return Matrix(tuple((cell,) * width for _ in range(height)))
    raise ShapeError(f"a scalar stands where a {height}×{width} block is expected")
