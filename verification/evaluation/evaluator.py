"""The value of an expression tree in an algebra, under a document's bindings."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import replace
from typing import Any

from armproof.verification.algebra.matrix import Identity, Matrix, as_scalar, sized
from armproof.verification.algebra.protocol import Algebra, Value
from armproof.verification.errors import EvaluationError, ShapeError, UnboundName
from armproof.verification.evaluation.arithmetic import (
    ambiguous,
    matrix_value,
    postfix_value,
    power_value,
    product_value,
    quotient_value,
    sum_value,
)
from armproof.verification.evaluation.calls import (
    call_value,
    ellipsis,
    joint_angle_sum,
    layout,
    name_value,
    number_value,
)
from armproof.verification.evaluation.differentiation import derivative_value
from armproof.verification.evaluation.screws import screw_matrix
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.naming.names import Names

MAX_DEPTH = 150


class Evaluator:
    """Evaluates nodes; `branch` is the sign that ± takes (∓ takes the other)."""

    def __init__(self, names: Names, algebra: Algebra, branch: int = 1) -> None:
        self.names = names
        self.algebra = algebra
        self.branch = branch
        self.depth = 0

    def within(self, algebra: Algebra) -> Evaluator:
        """Return an evaluator of the same names and branch in another algebra."""
        return Evaluator(self.names, algebra, self.branch)

    def evaluate(self, node: n.Node) -> Value:
        """Return the value; raises UnboundName, EvaluationError."""
        self.depth += 1
        try:
            self.algebra.budget.check()
            if self.depth > MAX_DEPTH:
                raise EvaluationError(say(Kind.NESTED))
            method = _METHODS.get(type(node))
            if method is None:
                raise EvaluationError(say(Kind.LONE_DIFFERENTIAL))
            return method(self, node)
        finally:
            self.depth -= 1

    def scalar(self, node: n.Node) -> Any:
        """Return the value of a node that must be a scalar."""
        value = as_scalar(self.evaluate(node))
        if isinstance(value, Matrix | Identity | list):
            raise EvaluationError(say(Kind.MATRIX_FOR_SCALAR))
        return value

    def _group(self, node: n.Group) -> Value:
        if self.names.reader.spelling.screws and (screw := screw_matrix(self, node)) is not None:
            return screw
        return self.evaluate(node.inner)

    def _sequence(self, node: n.Sequence) -> Value:
        values = [as_scalar(self.evaluate(item)) for item in node.items]
        if node.brackets == "[]" and not any(isinstance(value, Matrix | Identity) for value in values):
            return Matrix((tuple(values),))
        return values

    def _labelled(self, node: n.Labelled) -> Value:
        value = self.evaluate(node.inner)
        if node.size is not None and isinstance(value, Matrix) and value.shape != node.size:
            raise ShapeError(say(Kind.SIZE_OF_LABEL, size=value.size, label=f"{node.size[0]}×{node.size[1]}"))
        return value

    def _cases(self, _node: n.Cases) -> Value:
        raise UnboundName("cases", say(Kind.CASES_IN_WORDS))

    def _at(self, node: n.At) -> Value:
        values: dict[str, Any] = {}
        for left, right in (each for pair in node.values for each in self._of_joints(*pair)):
            symbol = self._symbol(left) if isinstance(left, n.Name) else None
            if symbol is None and isinstance(left, n.Name) and self.names.is_free(left):
                symbol = left.key
            if symbol is None:
                raise EvaluationError(say(Kind.NO_CONFIGURATION))
            key = left.key if isinstance(left, n.Name) else ""
            value = self.scalar(right)
            values[symbol] = (
                value if symbol.startswith("dot") else self.names.variable_at(symbol, value, self.algebra, key)
            )
        return self.at_values(values, _with_ranks_there(node))

    def _symbol(self, name: n.Name) -> str | None:
        """Return the model's symbol for a name or a rate."""
        symbol = self.names.known_symbol(name.undotted.key)
        return symbol if symbol is None or not name.dots else "dot" * name.dots + f" {symbol}"

    def _of_joints(self, left: n.Node, right: n.Node) -> Iterable[tuple[n.Node, n.Node]]:
        """q = 0 and q = (0, 0) give each joint variable its value."""
        arm = self.names.arm
        is_vector = (
            isinstance(left, n.Name) and left.key in ("q", "theta") and self.names.known_symbol(left.key) is None
        )
        if arm is None or not is_vector or self.names.offset_joints:
            return [(left, right)]
        if left.key == "theta" and any(joint.kind != "revolute" for joint in arm.joints):  # type: ignore[attr-defined]
            return [(left, right)]
        items = right.items if isinstance(right, n.Sequence) else ()
        if isinstance(right, n.Number) and right.value == 0:
            items = (right,) * len(arm.joints)
        if len(items) != len(arm.joints):
            return [(left, right)]
        names = [n.Name(*joint.symbol.partition("_")[::2], span=left.span) for joint in arm.joints]
        return zip(names, items, strict=True)

    def at_values(self, values: dict[str, Any], node: n.Node) -> Value:
        """Return a tree's value where some joint variables or lengths have the values given."""
        if (moved := self.algebra.at(values)) is not None:
            return self.within(moved).evaluate(node)
        return self.algebra.substitute(sized(self.evaluate(node)), values)


def _with_ranks_there(node: n.At) -> n.Node:
    """Return an expression with each rank of the matrix as it is at the values: that of a generic configuration is another."""
    ranks = [below for below in n.walk(node.inner) if n.is_rank(below)]
    there = {id(each): tuple(n.At(a, node.values, span=a.span) for a in each.arguments) for each in ranks}
    return n.substitute_each(node.inner, {id(each): replace(each, arguments=there[id(each)]) for each in ranks})


_METHODS: dict[type[n.Node], Callable[[Evaluator, Any], Value]] = {
    n.Number: number_value,
    n.Name: name_value,
    n.JointAngles: joint_angle_sum,
    n.Dots: ellipsis,
    n.Layout: layout,
    n.Sum: sum_value,
    n.Product: product_value,
    n.Quotient: quotient_value,
    n.Ambiguous: ambiguous,
    n.Power: power_value,
    n.Postfix: postfix_value,
    n.Group: Evaluator._group,
    n.Sequence: Evaluator._sequence,
    n.Labelled: Evaluator._labelled,
    n.Cases: Evaluator._cases,
    n.At: Evaluator._at,
    n.Matrix: matrix_value,
    n.Call: call_value,
    n.Derivative: derivative_value,
}
