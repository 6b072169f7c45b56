"""What the meaning of a node needs of the evaluator that asks for it."""

from __future__ import annotations

from typing import Any, Protocol

from armproof.verification.algebra.protocol import Algebra, Value
from armproof.verification.latex import nodes as n
from armproof.verification.naming.names import Names


class Evaluating(Protocol):
    """Evaluates the parts of a node; `branch` is the sign that ± takes (∓ takes the other)."""

    names: Names
    algebra: Algebra
    branch: int

    def evaluate(self, node: n.Node) -> Value:
        """Return the value; raises UnboundName, EvaluationError."""
        ...

    def scalar(self, node: n.Node) -> Any:
        """Return the value of a node that must be a scalar."""
        ...

    def within(self, algebra: Algebra) -> Evaluating:
        """Return an evaluator of the same names and branch in another algebra."""
        ...

    def at_values(self, values: dict[str, Any], node: n.Node) -> Value:
        """Return a tree's value where some joint variables or lengths have the values given."""
        ...
