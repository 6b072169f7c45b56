"""Function calls: trigonometry and roots, determinants and traces, elementary matrices, names with arguments."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import Any

from armproof.verification.algebra.matrix import Matrix
from armproof.verification.algebra.protocol import OutsideAlgebra, Value, elementary
from armproof.verification.errors import EvaluationError, UnboundName
from armproof.verification.evaluation.arithmetic import multiply
from armproof.verification.evaluation.evaluating import Evaluating
from armproof.verification.evaluation.matrices import printed_rows
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.naming.trees import call_key

_MATRIX_CALLS: dict[str, Callable[[Matrix], Value]] = {
    "det": Matrix.determinant,
    "adj": Matrix.adjugate,
    "com": Matrix.cofactors,
    "tr": lambda m: sum((m.rows[k][k] for k in range(1, min(m.shape))), m.rows[0][0]),
    "rank": lambda m: m,
}


def call_value(evaluator: Evaluating, node: n.Call) -> Value:
    """Return the value of a function, an elementary matrix or an applied name."""
    function = node.function
    if function == "name":
        return _applied_name(evaluator, node)
    if function in ("Rot", "Trans", "Rot3"):
        return _elementary(evaluator, node)
    if function == "diag":
        values = [evaluator.scalar(a) for a in node.arguments]
        zero = evaluator.algebra.rational(Fraction(0))
        return Matrix(tuple(tuple(v if r == c else zero for c in range(len(values))) for r, v in enumerate(values)))
    if function == "abs" and isinstance(matrix := evaluator.evaluate(node.arguments[0]), Matrix):  # |J|, |p|
        if matrix.shape[1] == 1:
            return evaluator.algebra.sqrt((matrix.transpose @ matrix).rows[0][0])
        return printed_rows(evaluator, node.arguments[0], matrix).determinant()
    if function in _MATRIX_CALLS:
        value = printed_rows(evaluator, node.arguments[0], evaluator.evaluate(node.arguments[0]))
        if not isinstance(value, Matrix):
            if function in ("det", "tr"):
                return value
            raise EvaluationError(say(Kind.FUNCTION_OF_SCALAR, function=function))
        if function == "rank":
            return evaluator.algebra.rank(value)
        return _MATRIX_CALLS[function](value)
    arguments = [evaluator.scalar(argument) for argument in node.arguments]
    return _scalar_function(evaluator, function, arguments)


def _scalar_function(evaluator: Evaluating, function: str, arguments: list[Any]) -> Any:
    wanted = 2 if function == "atan2" else 1
    if len(arguments) != wanted:
        kind = Kind.TAKES_TWO_ARGUMENTS if wanted == 2 else Kind.TAKES_ONE_ARGUMENT
        raise EvaluationError(say(kind, function=function, given=len(arguments)))
    if function in ("cos", "sin", "tan", "cot", "sec", "csc"):
        c, s = evaluator.algebra.cos_sin(arguments[0])
        one = evaluator.algebra.rational(Fraction(1))
        return {"cos": lambda: c, "sin": lambda: s, "tan": lambda: s / c, "cot": lambda: c / s, "sec": lambda: one / c,
                "csc": lambda: one / s}[function]()  # fmt: skip
    if function == "sqrt":
        return evaluator.algebra.sqrt(arguments[0])
    if function == "abs":
        return evaluator.algebra.absolute(arguments[0])
    if function in ("acos", "asin", "atan", "atan2"):
        return evaluator.algebra.arc(function, arguments)
    raise OutsideAlgebra(say(Kind.THE_FUNCTION, function=function))


def _applied_name(evaluator: Evaluating, node: n.Call) -> Value:
    key = call_key(node)
    names = evaluator.names
    if (quantity := names.quantities.get(key)) is not None:
        return evaluator.algebra.quantity(quantity)
    if key in names.state.definitions:
        return names.defined_value(key, evaluator.algebra)
    name, *arguments = node.arguments
    assert isinstance(name, n.Name)
    joints = names.arm.joints if names.arm is not None else ()
    if arguments and not any(isinstance(a, n.Name) for a in arguments):
        if len(arguments) == len(joints):
            values = zip(joints, arguments, strict=True)
            return evaluator.at_values({joint.symbol: evaluator.scalar(argument) for joint, argument in values}, name)
        if len(arguments) == 1:
            return multiply(evaluator.evaluate(name), "", evaluator.evaluate(arguments[0]))
        raise EvaluationError(say(Kind.WRONG_NUMBER_OF_VALUES, name=name.key, given=len(arguments), joints=len(joints)))
    ignorable = all(
        isinstance(a, n.Name) and (a.key in ("q", "t", "theta") or names.known_symbol(a.key)) for a in arguments
    )
    if ignorable or names.arm is not None:
        return evaluator.evaluate(name)
    raise UnboundName(key)


def _elementary(evaluator: Evaluating, node: n.Call) -> Matrix:
    axis, amounts = "", []
    for argument in node.arguments:
        if not axis and isinstance(argument, n.Name) and argument.base.lower() in ("x", "y", "z"):
            axis = argument.base.lower()
        else:
            amounts.append(argument)
    if node.function == "Trans" and not axis and len(amounts) == 3:
        return _translation(evaluator, amounts)
    if node.function == "Trans" and axis and len(amounts) == 2 and len(node.arguments) == 3:
        return _translation(evaluator, node.arguments)
    if not axis or len(amounts) != 1:
        raise EvaluationError(say(Kind.AXIS_AND_AMOUNT, function=node.function))
    kind = "Rot" if node.function == "Rot3" else node.function
    whole = elementary(evaluator.algebra, kind, axis, evaluator.scalar(amounts[0]))
    return whole.block(range(3), range(3)) if node.function == "Rot3" else whole


def _translation(evaluator: Evaluating, amounts: Sequence[n.Node]) -> Matrix:
    x, y, z = (
        elementary(evaluator.algebra, "Trans", k, evaluator.scalar(a)) for k, a in zip("xyz", amounts, strict=True)
    )
    return x @ y @ z
