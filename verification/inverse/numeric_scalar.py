"""A scalar that is compiled: a term of a graph, with the operators that the evaluator uses."""

from __future__ import annotations

from typing import Any

from armproof.models.bulk.graph import ONE, ZERO, Term
from armproof.verification.algebra.protocol import OutsideAlgebra
from armproof.verification.findings import Kind, say
from armproof.verification.inverse.branch_graph import BranchGraph

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
            raise OutsideAlgebra(f"a power of {exponent}")
        if exponent < 0:
            return self._with(self.graph.divide(ONE, (self**-exponent).term))
        result = ONE
        for _ in range(exponent):
            result = self.graph.multiply(result, self.term)
        return self._with(result)

    def is_zero(self) -> bool:
        """Whether the term is the number 0."""
        return not self.term.factor
