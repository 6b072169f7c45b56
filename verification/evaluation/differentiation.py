"""Derivatives: by joint variables, and in time with the rates as free symbols."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from functools import partial

from armproof.verification.algebra.matrix import Matrix, as_matrix, column, sized
from armproof.verification.algebra.protocol import Value
from armproof.verification.errors import EvaluationError, UnboundName
from armproof.verification.evaluation.evaluating import Evaluating
from armproof.verification.evaluation.mass_matrix import entry_of_masses
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare, bare_key
from armproof.verification.patterns import regex


def derivative_value(evaluator: Evaluating, node: n.Derivative) -> Value:
    """Return a partial derivative, or one in time."""
    if (exact := evaluator.algebra.exact) is not None:
        return evaluator.algebra.from_exact(evaluator.within(exact).evaluate(node))
    value = sized(evaluator.evaluate(node.operand))
    variable, operand = node.variable, bare(node.operand)
    if evaluator.names.arm is None and isinstance(operand, n.Name) and _is_unknown(evaluator, operand, bare(variable)):
        raise UnboundName(operand.key)
    if evaluator.names.arm is None and bare_key(variable) == "t" and _may_change(evaluator, value):
        raise EvaluationError(say(Kind.RATE_WITHOUT_ARM))
    if bare_key(variable) == "t" and (length := _length_alone(evaluator, value)) is not None:
        raise EvaluationError(say(Kind.RATE_OF_LENGTH, name=length))  # as of its dotted letter: it moves
    for _ in range(node.order):
        value = _differentiate(evaluator, value, variable)
    return value


def _is_unknown(evaluator: Evaluating, operand: n.Name, variable: n.Node) -> bool:
    """Whether a letter that nothing binds may depend on any other."""
    names = evaluator.names
    is_open = names.is_free(operand) and operand.key not in names.state.definitions
    return operand != variable and is_open and entry_of_masses(evaluator, operand) is None


def _may_change(evaluator: Evaluating, value: Value) -> bool:
    """Whether an entry is of letters, and not of the time as a_0 + a_1 t is: they may be functions of it."""
    letters = [evaluator.algebra.symbols(cell) for cell in as_matrix(value).cells]
    return any(found and "t" not in found for found in letters)


def _length_alone(evaluator: Evaluating, value: Value) -> str | None:
    """Return a length of the arm that an entry is of, and of nothing that moves; None where each entry moves, or is a number."""
    arm = evaluator.names.arm
    for cell in as_matrix(value).cells if arm is not None else ():
        symbols = evaluator.algebra.symbols(cell)
        if arm is not None and symbols and all(symbol in arm.lengths for symbol in symbols):
            return min(symbols)
    return None


def _differentiate(evaluator: Evaluating, value: Value, variable: n.Node) -> Value:
    if evaluator.names.arm is not None and isinstance(variable, n.Name) and variable.key == "t":
        return _in_time(evaluator, value)
    symbol = evaluator.names.known_symbol(variable.key) if isinstance(variable, n.Name) else None
    variable = _all_joints(evaluator, variable)
    by = evaluator.algebra.symbol(symbol) if symbol is not None else sized(evaluator.evaluate(variable))
    if symbol is not None and isinstance(variable, n.Name) and evaluator.names.turn_of(symbol, variable.key) == -1:
        value = -value
    if isinstance(by, Matrix):  # ∂P/∂q: one column a variable
        cells = by.vector()
        value = value if isinstance(value, Matrix) else column([value])
        return Matrix(tuple(tuple(evaluator.algebra.derivative(f, x) for x in cells) for f in value.vector()))
    if isinstance(value, Matrix):
        return value.map(lambda cell: evaluator.algebra.derivative(cell, by))
    return evaluator.algebra.derivative(value, by)


def _all_joints(evaluator: Evaluating, variable: n.Node) -> n.Node:
    """Return q for the θ by which ∂p/∂θ is, where all joints turn and the document gives θ no meaning of its own."""
    names = evaluator.names
    if names.arm is None or not isinstance(variable, n.Name) or variable != n.Name("theta"):
        return variable
    is_other = (
        "theta" in names.state.definitions or "theta" in names.quantities or names.known_symbol("theta") is not None
    )
    turns = all(joint.kind == "revolute" for joint in names.arm.joints)
    return n.Name("q", span=variable.span) if turns and not is_other else variable


_JOINT = regex(r"(?:theta|q)(?:_\d+)?")  # where there is no arm, what moves, and what never does
_MAY_GROW = ("r", "R", "rho", "d", "D", "s", "x", "y", "z", "X", "Y", "Z")  # distances that a text tells, too
_JOINT_OR_LENGTH = regex(rf"(?:dot )*(?:{_JOINT.pattern}|[lLabcehmgI](?:_\w+)?)")


def time_derivative(evaluator: Evaluating, node: n.Name) -> Value:
    """x-dot: a joint rate where x is a joint variable, else the derivative of what x stands for; a length has none."""
    plain = replace(node, dots=0)
    symbol = evaluator.names.known_symbol(plain.key)
    if symbol is not None and _is_variable(evaluator, symbol):
        rate, sign = (
            evaluator.algebra.symbol(rate_symbol(symbol, node.dots)),
            evaluator.names.turn_of(symbol, plain.key),
        )
        return rate * evaluator.algebra.rational(Fraction(sign))
    if symbol is not None and evaluator.names.arm is not None and symbol in evaluator.names.arm.lengths:
        raise EvaluationError(say(Kind.RATE_OF_LENGTH, name=plain.key))  # it moves: the arm was not understood
    is_of_column = evaluator.names.component(plain) is not None
    if evaluator.names.is_free(plain) and plain.key not in evaluator.names.state.definitions and not is_of_column:
        evaluator.names.used.add(node.key)
        return evaluator.algebra.symbol(rate_symbol(plain.key, node.dots))
    if node.key in evaluator.names.state.definitions:
        return evaluator.names.defined_value(node.key, evaluator.algebra)
    if (exact := evaluator.algebra.exact) is not None:
        return evaluator.algebra.from_exact(evaluator.within(exact).evaluate(node))
    value = sized(evaluator.evaluate(plain))
    for _ in range(node.dots):
        value = _in_time(evaluator, value)
    return value


def _is_variable(evaluator: Evaluating, symbol: str) -> bool:
    if evaluator.names.arm is None:
        return _JOINT.fullmatch(symbol) is not None or symbol in evaluator.names.reader.spelling.moving
    return any(joint.symbol == symbol for joint in evaluator.names.arm.joints)


def _in_time(evaluator: Evaluating, value: Value) -> Value:
    """Return the derivative in time, by each joint variable, and each rate of one, that stands in a value."""
    if isinstance(value, Matrix):
        return value.map(lambda cell: _in_time(evaluator, cell))
    algebra = evaluator.algebra
    if evaluator.names.arm is None and not all(map(partial(_may_stand, evaluator), algebra.symbols(value))):
        raise EvaluationError(say(Kind.RATE_WITHOUT_ARM))
    total = algebra.rational(Fraction(0))
    for symbol in sorted(algebra.symbols(value)):
        if _is_variable(evaluator, symbol.rpartition(" ")[2]):
            total = total + algebra.derivative(value, algebra.symbol(symbol)) * algebra.symbol(rate_symbol(symbol, 1))
    return total


def _may_stand(evaluator: Evaluating, symbol: str) -> bool:
    """Whether a symbol moves as the document shows, or never does, as a size that the text tells; any other letter may be a function of time."""
    is_told = symbol in evaluator.names.reader.spelling.scalars and symbol not in _MAY_GROW
    return (
        is_told or _JOINT_OR_LENGTH.fullmatch(symbol) is not None or _is_variable(evaluator, symbol.rpartition(" ")[2])
    )


def rate_symbol(symbol: str, order: int) -> str:
    """The free symbol that stands for the order-th time derivative of a variable."""
    return f"{'dot ' * order}{symbol}"
