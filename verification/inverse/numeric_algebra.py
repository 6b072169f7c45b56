"""The algebra in which a derivation is compiled: its scalars are terms of a graph, evaluated later over many targets."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from math import pi, prod
from typing import Any

from armproof.models.arm import Arm
from armproof.models.bulk.graph import ONE, ZERO, Term
from armproof.models.exact.numbers import angle_value
from armproof.models.exact.polynomial import Entry, root_value
from armproof.verification.algebra.budget import Budget
from armproof.verification.algebra.matrix import Matrix
from armproof.verification.algebra.protocol import OutsideAlgebra, Value
from armproof.verification.findings import Kind, say
from armproof.verification.inverse.branch_graph import BranchGraph
from armproof.verification.inverse.derivation import UnsolvedJoint
from armproof.verification.inverse.given_target import GivenTarget
from armproof.verification.inverse.target import Target

HIGHEST_POWER = 64


class NumericScalar:
    """A term of a graph, with the operators that the evaluator uses."""

    __slots__ = ("graph", "term")

    def __init__(self, graph: BranchGraph, term: Term) -> None:
        self.graph, self.term = graph, term

    def _with(self, term: Term) -> NumericScalar:
        return NumericScalar(self.graph, term)

    def _term(self, other: Any) -> Term:
        return other.term if isinstance(other, NumericScalar) else self.graph.number(float(other))

    def __add__(self, other: Any) -> NumericScalar:
        return self._with(self.graph.add(self.term, self._term(other)))

    def __sub__(self, other: Any) -> NumericScalar:
        return self._with(self.graph.subtract(self.term, self._term(other)))

    def __rsub__(self, other: Any) -> NumericScalar:
        return self._with(self.graph.subtract(self._term(other), self.term))

    def __neg__(self) -> NumericScalar:
        return self._with(Term(self.term.node, -self.term.factor) if self.term.factor else ZERO)

    def __mul__(self, other: Any) -> NumericScalar:
        return self._with(self.graph.multiply(self.term, self._term(other)))

    def __truediv__(self, other: Any) -> NumericScalar:
        divisor = self._term(other)
        if not divisor.factor:
            raise OutsideAlgebra(say(Kind.DIVISION_BY_ZERO))
        return self._with(self.graph.divide(self.term, divisor))

    __radd__ = __add__
    __rmul__ = __mul__

    def __pow__(self, exponent: int) -> NumericScalar:
        if abs(exponent) > HIGHEST_POWER:
            raise OutsideAlgebra("a power of {exponent}", exponent=exponent)
        if exponent < 0:
            return self._with(self.graph.divide(ONE, (self**-exponent).term))
        result = ONE
        for _ in range(exponent):
            result = self.graph.multiply(result, self.term)
        return self._with(result)

    def is_zero(self) -> bool:
        """Whether the term is the number 0."""
        return not self.term.factor


class NumericAlgebra(GivenTarget):
    """Terms of one graph: the target's slots are inputs, lengths are numbers, joints have the values solved for.

    Args:
        values: the number of each length and constant angle.
    """

    def __init__(self, arm: Arm, target: Target, graph: BranchGraph, values: Mapping[str, float]) -> None:
        slots = [NumericScalar(graph, graph.input("target", str(index))) for index in range(len(target.slots))]
        super().__init__(arm)
        self.give(target, slots)
        self.graph = graph
        self.values = values
        self.solved: dict[str, NumericScalar] = {}

    def solve(self, joint: str, value: NumericScalar) -> None:
        """Give a joint its value."""
        self.solved[joint] = value

    budget = Budget()  # compiling is not timed

    def rational(self, value: Fraction) -> NumericScalar:
        return self._number(float(value))

    def pi(self) -> NumericScalar:
        return self._number(pi)

    def symbol(self, name: str) -> NumericScalar:
        if any(joint.symbol == name for joint in self.arm.joints):
            if name not in self.solved:
                raise UnsolvedJoint(name)
            return self.solved[name]
        if name not in self.values:
            raise OutsideAlgebra("'{name}', which has no value,", name=name)
        return self._number(self.values[name])

    def cos_sin(self, angle: NumericScalar) -> tuple[NumericScalar, NumericScalar]:
        cosine, sine = self.graph.cos_sin(angle.term)
        return NumericScalar(self.graph, cosine), NumericScalar(self.graph, sine)

    def sqrt(self, value: NumericScalar) -> NumericScalar:
        return NumericScalar(self.graph, self.graph.sqrt(value.term))

    def arc(self, function: str, arguments: list[NumericScalar]) -> NumericScalar:
        terms = [argument.term for argument in arguments]
        graph = self.graph
        if function == "atan":
            return NumericScalar(graph, graph.atan2(terms[0], ONE))
        arcs: dict[str, Any] = {"atan2": graph.atan2, "acos": graph.acos, "asin": graph.asin}
        return NumericScalar(graph, arcs[function](*terms))

    def absolute(self, value: NumericScalar) -> NumericScalar:
        return NumericScalar(self.graph, self.graph.absolute(value.term))

    def derivative(self, value: Any, variable: Any) -> Any:
        raise OutsideAlgebra("a derivative")

    def symbols(self, value: Any) -> set[str]:
        raise OutsideAlgebra("a derivative")

    def rank(self, matrix: Matrix) -> Any:
        raise OutsideAlgebra("a rank")

    def substitute(self, value: Value, values: Mapping[str, Any]) -> Value:
        raise OutsideAlgebra("a value at a configuration")

    def _number(self, value: float) -> NumericScalar:
        return NumericScalar(self.graph, self.graph.number(value))

    def from_entry(self, entry: Entry) -> NumericScalar:
        terms = (
            prod(
                (self._generator(*generator) ** power for generator, power in monomial),
                start=self._number(float(factor)),
            )
            for monomial, factor in entry.items()
        )
        return sum(terms, self._number(0.0))

    def _generator(self, kind: str, name: str) -> NumericScalar:
        if kind == "sqrt":
            return self._number(root_value(name))
        known = name in self.values or any(joint.symbol == name for joint in self.arm.joints)
        value = self.symbol(name) if known else self._number(angle_value(name))
        return value if kind == "symbol" else self.cos_sin(value)[0 if kind == "cos" else 1]
