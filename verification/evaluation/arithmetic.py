"""Sums, products, quotients and powers of scalars and matrices."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

from armproof.verification.algebra.matrix import Matrix
from armproof.verification.algebra.protocol import Value
from armproof.verification.algebra.values import Identity, as_scalar, identity, is_zero, no_size, stacked
from armproof.verification.errors import EvaluationError, ShapeError
from armproof.verification.evaluation.evaluating import Evaluating
from armproof.verification.evaluation.matrices import inverse
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n


def sum_value(evaluator: Evaluating, node: n.Sum) -> Value:
    """Return a sum; ± takes the sign of the branch, ∓ the other."""
    total: Value = None
    for sign, term in node.terms:
        value = stacked(as_scalar(evaluator.evaluate(term)))
        if sign == "-" or (sign == "±" and evaluator.branch < 0) or (sign == "∓" and evaluator.branch > 0):
            value = Identity(-value.scale) if isinstance(value, Identity) else -value
        total = value if total is None else _add(evaluator, total, value)
    return total


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
    if any(isinstance(f, n.Call) and f.function == "Trans" for f in node.factors):  # R_z(θ) T_z(d), all 4×4
        whole = (_in_four_rows(factor) for factor in node.factors)
        node = replace(node, factors=tuple(whole))
    result = evaluator.evaluate(node.factors[0])
    for operator, factor in zip(node.operators, node.factors[1:], strict=True):
        result = multiply(result, operator, evaluator.evaluate(factor))
    return result


def _in_four_rows(node: n.Node) -> n.Node:
    return replace(node, function="Rot") if isinstance(node, n.Call) and node.function == "Rot3" else node


def multiply(a: Value, operator: str, b: Value) -> Value:
    """Return the product of two values: of matrices, scaled, × of vectors, ⋅ of columns."""
    a, b = stacked(a), stacked(b)
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
    if exponent < 0:
        return evaluator.algebra.rational(Fraction(1)) / base**-exponent
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
