"""The sides of an equation: their values, and how far each may be trusted."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from math import pi
from typing import TYPE_CHECKING, Any

from armproof.models.errors import Sentence, together
from armproof.verification.algebra.matrix import Matrix
from armproof.verification.algebra.protocol import OutsideAlgebra, Value
from armproof.verification.algebra.quantity import Quantity
from armproof.verification.algebra.quantity_kinds import kind_of
from armproof.verification.algebra.ring import Scalar
from armproof.verification.errors import EvaluationError, TooComplex
from armproof.verification.evaluation.blocks import Block
from armproof.verification.evaluation.calls import is_variable
from armproof.verification.evaluation.evaluator import Evaluator
from armproof.verification.evaluation.exact import ExactAlgebra
from armproof.verification.findings import Kind, finding_of, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import call_key
from armproof.verification.naming.names import Names
from armproof.verification.naming.quantities import numbered_frames

if TYPE_CHECKING:
    from armproof.verification.evaluation.sampled import SampledAlgebra


@dataclass(frozen=True)
class Member:
    """One side of a chain: its tree, and its exact value or why it has none."""

    node: n.Node
    value: Value = None
    problem: EvaluationError | None = None
    rank: int = 0  # how far it may be trusted: 4 a quantity of the arm, 3 or 2 made of such, 1 a formula, 0 none

    @property
    def known(self) -> bool:
        """Whether it has a value."""
        return self.problem is None and self.value is not None


TOO_LARGE = (Kind.LARGE_PRODUCT, Kind.LARGE_EXPRESSION)


def beyond_size(problem: TooComplex) -> OutsideAlgebra:
    """Return what is too large to be decided exactly as what samples can confirm; what takes too long is raised again."""
    found = finding_of(problem)
    if found.kind in TOO_LARGE:
        return OutsideAlgebra(found)
    raise problem


class Members:
    """Evaluates the sides of equations: exactly, and on samples."""

    def __init__(self, names: Names, exact: ExactAlgebra, sampled: Callable[[], SampledAlgebra]) -> None:
        self.names = names
        self.exact = exact
        self.sampled = sampled

    def evaluate(self, node: n.Node) -> Member:
        """Evaluate one side exactly."""
        try:
            value = Evaluator(self.names, self.exact).evaluate(node)
            return Member(node, value, None, self._rank(node))
        except OutsideAlgebra as problem:
            return Member(node, None, problem, self._rank(node))
        except TooComplex as problem:
            return Member(node, None, beyond_size(problem), self._rank(node))
        except EvaluationError as problem:
            return Member(node, None, problem)

    def number(self, value: Scalar) -> float:
        """Return the number that a scalar without symbols is."""
        if (number := value.as_fraction()) is not None:
            return float(number)
        if (turns := (value / self.exact.pi()).as_fraction()) is not None:
            return float(turns) * pi
        return float(self.sampled().from_exact(value)[0])

    def _rank(self, node: n.Node) -> int:
        if isinstance(node, n.Group | n.Labelled):
            return self._rank(node.inner)
        if isinstance(node, n.Derivative) and self._rank(node.operand) == 4:
            return 4
        quantity = self.quantity_of(node)
        if quantity is not None or (
            isinstance(node, n.Name) and node.dots and self.names.quantity(node.undotted) is not None
        ):
            return 4
        if (
            isinstance(node, n.Name)
            and self.names.arm is not None
            and (symbol := self.names.known_symbol(node.key)) is not None
        ):
            return 3 if any(joint.symbol == symbol for joint in self.names.arm.joints) else 1
        names = [below for below in n.walk(node) if isinstance(below, n.Name | n.Call)]
        if any(isinstance(below, n.Matrix) for below in n.walk(node)):
            return 2 if any(self.quantity_of(below) is not None for below in names) else 1
        if any(self.quantity_of(below) is not None for below in names):
            return 3
        if any(isinstance(below, n.Name) and below.key in self.names.state.definitions for below in names):
            return 3 if isinstance(node, n.Name) else 2
        return 1

    def quantity_of(self, node: n.Node) -> Quantity | None:
        """Return the arm's quantity that a name, with or without arguments, stands for."""
        if n.is_call(node, "name") and all(isinstance(a, n.Name) for a in node.arguments):
            found = self.names.quantities.get(call_key(node))
            return found or self.quantity_of(node.arguments[0])
        return self.names.quantity(node) if isinstance(node, n.Name) else None

    def is_of_tool(self, node: n.Node) -> bool:
        """Whether a tree is a quantity of the tool or of the last frame, in the base."""
        quantity, arm = self.quantity_of(node), self.names.arm
        if quantity is None or arm is None or quantity.reference != arm.frames[0]:
            return False
        return quantity.frame in (arm.frames[-1], numbered_frames(arm)[-1])

    def read_as(self, node: n.Node) -> str:
        """Return in words what a side is taken for: its quantity, or those of the names in it; empty for a plain formula."""
        found: dict[str, str] = {}
        for below in n.walk(node):
            if isinstance(below, n.Name) and (quantity := self.quantity_of(below.undotted)) is not None:
                words = kind_of(quantity).tell(quantity)
                if below.dots == 1:
                    words = Sentence("rate of change of the {what}", what=words)
                elif below.dots:
                    words = Sentence("derivative of the {what}", what=words)
                found.setdefault(replace(below, sub=below.sub.partition("rows ")[0]).key, words)
        alone = len(found) == 1 and isinstance(n.ungrouped(node), n.Name | n.Call)
        named = [Sentence("{name}: {what}", name=key, what=words) for key, words in found.items()]
        return next(iter(found.values())) if alone else together(named)

    def jacobian_name(self, node: n.Node, parts: bool = False) -> n.Name | None:
        """Return the name of a Jacobian that notation implies (the front matter lists no rows for it), or None.

        It is that of all six rows, or with `parts` that of some, J_v; J(q) and J(θ_1, θ_2) are J.
        """
        node = self._without_variables(n.ungrouped(node))
        if not isinstance(node, n.Name) or node.base != "J" or node.key in self.names.quantities:
            return None
        quantity = self.names.quantity(node.undotted)
        return (
            node if quantity is not None and quantity.kind == "jacobian" and (parts or quantity.rows is None) else None
        )

    def _without_variables(self, node: n.Node) -> n.Node:
        if not n.is_call(node, "name"):
            return node
        name, *arguments = node.arguments
        return name if all(is_variable(argument, self.names) for argument in arguments) else node

    def speaks_of_jacobian(self, *chains: n.Chain) -> bool:
        """Whether the name of a Jacobian that notation implies stands in chains."""
        return any(self.jacobian_name(below, True) is not None for chain in chains for below in n.walk(chain))

    def decimals(self, *nodes: n.Node, least: int = 3) -> int | None:
        """Return the fewest decimals, from `least` on, of the numbers in trees and of the names made of such; None without."""
        places = []
        for below in (below for node in nodes for below in n.walk(node)):
            if isinstance(below, n.Number):
                places.append(below.decimals)
            elif isinstance(below, n.Name):
                places.append(self.names.state.rounded.get(below.key, 0))
        return min((count for count in places if count >= least), default=None)

    def is_symbol(self, node: n.Node) -> bool:
        """Whether a tree is the name of a joint variable or a length."""
        return isinstance(node, n.Name) and self.names.known_symbol(node.key) is not None

    def meaning(self, node: n.Node, block: Block | None = None) -> Callable[[Any], Value]:
        """Return a definition's meaning: the value of `node`, or a block of it, in whichever algebra asks."""

        def evaluate(algebra: Any) -> Value:
            value = Evaluator(self.names, algebra).evaluate(node)
            if block is None:
                return value
            if not isinstance(value, Matrix):
                raise EvaluationError(say(Kind.ENTRY_OF_SCALAR))
            if block.rows[-1] >= value.shape[0] or block.columns[-1] >= value.shape[1]:  # J has fewer rows elsewhere
                raise EvaluationError(say(Kind.NO_SUCH_BLOCK, size=value.size))
            return block.of(value)

        return evaluate
