"""Sums, products, quotients and powers of scalars and matrices; printed matrices, transposes and inverses."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from typing import Any

from armproof.verification.algebra.matrix import Identity, Matrix, as_scalar, is_zero, no_size, stacked
from armproof.verification.algebra.protocol import Value, elementary, identity
from armproof.verification.errors import EvaluationError, ShapeError, UnboundName
from armproof.verification.evaluation.evaluating import Evaluating
from armproof.verification.evaluation.screws import exponential, is_exponential, written_out
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare, bare_key
from armproof.verification.latex.units import read_unit


def sum_value(evaluator: Evaluating, node: n.Sum) -> Value:
    """Return a sum; ± takes the sign of the branch, ∓ the other."""
    total: Value = None
    if (unit := _hypercomplex(node)) is not None and not isinstance(evaluator.evaluate(unit), Matrix):
        raise UnboundName(unit.key)
    for sign, term in node.terms:
        value = stacked(as_scalar(evaluator.evaluate(term)))
        if sign == "-" or (sign == "±" and evaluator.branch < 0) or (sign == "∓" and evaluator.branch > 0):
            value = Identity(-value.scale) if isinstance(value, Identity) else -value
        total = value if total is None else _add(evaluator, total, value)
    return total


def _hypercomplex(node: n.Sum) -> n.Name | None:
    """Return the i of q_0 + q_1 i + q_2 j + q_3 k: units of a quaternion or directions, which are no numbers."""
    factors = [factor for _, term in node.terms if isinstance(term, n.Product) for factor in term.factors]
    units = {factor.key: factor for factor in factors if isinstance(factor, n.Name) and factor.key in ("i", "j", "k")}
    return units["i"] if len(units) == 3 else None


def _add(evaluator: Evaluating, a: Value, b: Value) -> Value:
    if isinstance(a, Identity) and isinstance(b, Matrix):
        a = identity(evaluator.algebra, b.shape[0], a.scale)
    if isinstance(b, Identity) and isinstance(a, Matrix):
        b = identity(evaluator.algebra, a.shape[0], b.scale)
    if isinstance(a, Identity) and isinstance(b, Identity):
        return Identity(a.scale + b.scale)
    if isinstance(a, Identity) or isinstance(b, Identity):
        no_size()
    if isinstance(a, Matrix) != isinstance(b, Matrix):
        matrix, other = (a, b) if isinstance(a, Matrix) else (b, a)
        if is_zero(other):
            return matrix
        raise ShapeError(say(Kind.SUM_WITH_SCALAR, size=matrix.size))
    return a + b


def product_value(evaluator: Evaluating, node: n.Product) -> Value:
    """Return a product, from left to right."""
    if any(n.is_call(f, "Trans") for f in node.factors):  # R_z(θ) T_z(d), all 4×4
        whole = (_in_four_rows(factor) for factor in node.factors)
        node = replace(node, factors=tuple(whole))
    if (turned := _in_plane(evaluator, node)) is not None:
        return turned
    node = written_out(node) if evaluator.names.reader.spelling.screws else node
    result = evaluator.evaluate(node.factors[0])
    for before, operator, factor in zip(node.factors, node.operators, node.factors[1:], strict=False):
        if not operator and isinstance(before, n.Name) and _is_nought(factor):
            raise UnboundName(before.key + "(0)")  # θ(0) is no product: it is the value at the time 0
        value = evaluator.evaluate(factor)
        is_vector = isinstance(value, Matrix) and value.shape == (3, 1)
        if is_vector and _is_point(factor) and _is_pose(result):
            result = result.block(range(3), range(3)) @ value + result.block(range(3), range(3, 4))
            continue  # {}^AP = {}^A_BT {}^BP, of which the 1 below is left to the reader
        if isinstance(bare(factor), n.Name) and not isinstance(value, Matrix | Identity) and _is_pose(result):
            raise EvaluationError(say(Kind.PRODUCT_OF_POSE, one="4×4", other="1×1"))  # T x_N, where x_N is a vector
        result = multiply(result, operator, value)
    return result


def _in_plane(evaluator: Evaluating, node: n.Product) -> Matrix | None:
    """Return R(θ) v for a v of two components, where the document says nothing else of R: v turned by θ."""
    first, *others = node.factors
    is_turn = n.is_call(first, "name") and bare_key(first.arguments[0]) == "R"
    if not (is_turn and isinstance(first, n.Call) and len(first.arguments) == 2) or node.operators[0] not in ("", "⋅"):
        return None
    if any(key == "R" or key.startswith("R(") for key in evaluator.names.state.definitions):
        return None
    rest = evaluator.evaluate(
        others[0] if len(others) == 1 else n.Product(tuple(others), node.operators[1:], span=node.span)
    )
    if not isinstance(rest, Matrix) or rest.shape[0] != 2:
        return None
    turn = elementary(evaluator.algebra, "Rot", "z", evaluator.scalar(first.arguments[1]))
    return turn.block(range(2), range(2)) @ rest


def _is_pose(value: Value) -> bool:
    """Whether a value is 4×4 with the last row of a transform."""
    return isinstance(value, Matrix) and value.shape == (4, 4) and all(map(is_zero, value.rows[3][:3]))


def _is_point(node: n.Node) -> bool:
    """Whether a name is that of a point."""
    name = bare(node)
    return isinstance(name, n.Name) and name.base in ("p", "P")


def _is_nought(node: n.Node) -> bool:
    """Whether a 0 stands alone in brackets."""
    return isinstance(node, n.Group) and isinstance(node.inner, n.Number) and node.inner.value == 0


def _in_four_rows(node: n.Node) -> n.Node:
    return replace(node, function="Rot") if n.is_call(node, "Rot3") else node


def multiply(a: Value, operator: str, b: Value) -> Value:
    """Return the product of two values: of matrices, scaled, × of vectors, ⋅ of columns."""
    is_tuple = isinstance(a, list)
    if is_tuple and not isinstance(b, Matrix | Identity | list):
        return [cell * b for cell in stacked(a).cells]
    a, b = stacked(a), stacked(b)
    if is_tuple and isinstance(a, Matrix) and isinstance(b, Matrix) and b.shape[0] == a.shape[0] and b.shape[1] > 1:
        a = a.transpose  # (x, y) M: it can be a row alone
    if isinstance(a, Identity) and isinstance(b, Identity):
        return Identity(a.scale * b.scale)
    if isinstance(a, Identity):
        return b.map(lambda cell: a.scale * cell) if isinstance(b, Matrix) else Identity(a.scale * b)
    if isinstance(b, Identity):
        return a.map(lambda cell: cell * b.scale) if isinstance(a, Matrix) else Identity(a * b.scale)
    if isinstance(a, Matrix) and isinstance(b, Matrix):
        if operator == "×" and 1 in a.shape and 1 in b.shape and max(a.shape) == 3 and max(b.shape) == 3:
            return a.cross(b)
        if operator == "⋅" and a.shape[1] == b.shape[1] == 1 and a.shape == b.shape and a.shape[0] > 1:
            return (a.transpose @ b).rows[0][0]
        return as_scalar(a @ b)
    if isinstance(a, Matrix):
        return a.map(lambda cell: cell * b)
    if isinstance(b, Matrix):
        return b.map(lambda cell: a * cell)
    return a * b


def quotient_value(evaluator: Evaluating, node: n.Quotient) -> Value:
    """Return a quotient by a scalar."""
    above = stacked(evaluator.evaluate(node.numerator))
    below = evaluator.scalar(node.denominator)
    evaluator.algebra.divide_by(below)
    if isinstance(above, Identity):
        return Identity(above.scale / below)
    if isinstance(above, Matrix):
        return above.map(lambda cell: cell / below)
    return above / below


def ambiguous(evaluator: Evaluating, node: n.Ambiguous) -> Value:
    """Refuse a/2b, which has two readings."""
    raise EvaluationError(say(Kind.TWO_READINGS, text=node.text))


def power_value(evaluator: Evaluating, node: n.Power) -> Value:
    """Return an integer power, or the square root that a power of one half is."""
    screws = evaluator.names.reader.spelling.screws
    if screws and is_exponential(node) is not None and (motion := exponential(evaluator, node.exponent)) is not None:
        return motion
    base = stacked(as_scalar(evaluator.evaluate(node.base)))
    exponent = _integer(node.exponent)
    if isinstance(base, Identity) and exponent is not None:
        scale = base.scale if exponent >= 0 else evaluator.algebra.rational(Fraction(1)) / base.scale
        return Identity(scale ** abs(exponent))
    if exponent is None:
        if _is_half(node.exponent) and not isinstance(base, Matrix | Identity):
            return evaluator.algebra.sqrt(base)
        raise EvaluationError(say(Kind.BROKEN_EXPONENT))
    if isinstance(base, Matrix):
        if exponent < 0:
            base, exponent = inverse(evaluator, base), -exponent
        if exponent == 0:
            return identity(evaluator.algebra, base.shape[0])
        if base.shape[1] == 1 and exponent == 2:
            return (base.transpose @ base).rows[0][0]
        result = base
        for _ in range(exponent - 1):
            result = result @ base
        return result
    return base**exponent


def _integer(node: n.Node) -> int | None:
    sign = 1
    node = n.ungrouped(node)
    if isinstance(node, n.Sum) and len(node.terms) == 1:
        sign = -1 if node.terms[0][0] == "-" else 1
        node = node.terms[0][1]
    if isinstance(node, n.Number) and node.value.denominator == 1:
        return sign * int(node.value)
    return None


def _is_half(node: n.Node) -> bool:
    if isinstance(node, n.Number):
        return node.value == Fraction(1, 2)
    return isinstance(node, n.Quotient) and _integer(node.numerator) == 1 and _integer(node.denominator) == 2


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
    """Return a transpose, an inverse, a pseudo-inverse, degrees or metres."""
    if node.operator == "deg":
        return evaluator.scalar(node.base) * evaluator.algebra.pi() / evaluator.algebra.rational(Fraction(180))
    if (unit := read_unit(node.operator)) is not None:
        one = evaluator.algebra.rational(unit.number)
        for _ in range(abs(unit.of_pi)):
            one = one * evaluator.algebra.pi() if unit.of_pi > 0 else one / evaluator.algebra.pi()
        measured = as_scalar(evaluator.evaluate(node.base))
        if isinstance(measured, Matrix):
            return measured.map(lambda cell: cell * one)
        return evaluator.scalar(node.base) * one
    value = as_scalar(evaluator.evaluate(node.base))
    if node.operator == "-":  # of several solutions, or any generalised inverse
        raise EvaluationError(say(Kind.OPERATOR_ON_SCALAR, operator=node.operator))
    if isinstance(value, list):
        if any(isinstance(item, Matrix | Identity | list) for item in value):
            raise EvaluationError(say(Kind.LIST_OF_MATRICES))
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
    if matrix.shape[1] == 1 < matrix.shape[0]:  # q^{-1} is that of a quaternion
        raise EvaluationError(say(Kind.NO_INVERSE_OF_SIZE, size=matrix.size))
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
