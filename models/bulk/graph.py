"""Straight-line expressions with every common subexpression shared: what models/bulk/program.py evaluates over arrays.

A graph grows from the cosines, sines and variables of the joints by sums and products. Equal subexpressions are one node,
products with 0 and 1 vanish, and a constant factor stays outside of the node, so that x, −x and 2x are one node too.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from math import prod
from typing import NamedTuple

from armproof.models.bulk.operations import OPERATIONS
from armproof.models.exact.polynomial import Entry, Generator, Monomial

Matrix = list[list["Term"]]


class Term(NamedTuple):
    """A constant factor times a node of a graph; the factor 0 is zero, the node 0 is the number 1."""

    node: int
    factor: float


class Node(NamedTuple):
    """An input, or an operation on one or two nodes.

    Attributes:
        operation: "one", "input", or one of models/bulk/operations.py: of `left` and `right`, of `left` alone, or of `left`
            and the number `value`.
    """

    operation: str
    left: int = 0
    right: int = 0
    value: float = 0.0
    generator: Generator = ("", "")

    @property
    def operands(self) -> tuple[int, ...]:
        """The nodes that it is made of."""
        if self.operation in ("one", "input"):
            return ()
        return (self.left, self.right)[: OPERATIONS[self.operation].arity]


ZERO, ONE = Term(0, 0.0), Term(0, 1.0)


class Graph:
    """Nodes in an order in which each follows what it is made of."""

    def __init__(self, constant: Callable[[Generator], float | None]) -> None:
        """Take what gives each constant generator its number, and None for those that vary with the configuration."""
        self._constant = constant
        self.nodes: list[Node] = [Node("one")]
        self._places: dict[Node, int] = {self.nodes[0]: 0}

    def entry(self, entry: Entry) -> Term:
        """Return an exact entry, by Horner's rule: the generator in the most monomials is factored out first."""
        return self._horner({monomial: coefficient for monomial, coefficient in entry.items() if coefficient})

    def matrix(self, rows: Sequence[Sequence[Entry]]) -> Matrix:
        """Return a matrix of exact entries."""
        return [[self.entry(entry) for entry in row] for row in rows]

    def scale(self, term: Term, number: float) -> Term:
        """Return a term times a number."""
        return Term(term.node, term.factor * number) if term.factor and number else ZERO

    def multiply(self, left: Term, right: Term) -> Term:
        """Return the product of two terms."""
        factor = left.factor * right.factor
        if not factor or not left.node or not right.node:
            return Term(left.node or right.node, factor) if factor else ZERO
        low, high = sorted((left.node, right.node))
        return Term(self._node(Node("multiply", low, high)), factor)

    def add(self, *terms: Term) -> Term:
        """Return the sum of terms."""
        total = ZERO
        for term in terms:
            total = self._add(total, term)
        return total

    def dot(self, left: Sequence[Term], right: Sequence[Term]) -> Term:
        """Return the sum of the products of two rows of terms."""
        return self.add(*(self.multiply(a, b) for a, b in zip(left, right, strict=True)))

    def needed(self, terms: Sequence[Term]) -> list[int]:
        """Return the nodes that terms are made of, each after what it is made of; a constant term needs none."""
        needed = {term.node for term in terms if term.factor and term.node}
        for place in range(max(needed, default=0), 0, -1):
            if place in needed:
                needed.update(self.nodes[place].operands)
        return sorted(needed)

    def _add(self, left: Term, right: Term) -> Term:
        if not left.factor or not right.factor:
            return left if left.factor else right
        if left.node == right.node:
            factor = left.factor + right.factor
            return Term(left.node, factor) if factor else ZERO
        if not left.node or not right.node:
            term, number = (left, right.factor) if left.node else (right, left.factor)
            return Term(self._node(Node("offset", self._scaled(term.node, term.factor), value=number)), 1.0)
        # The larger factor goes outside, so that no quotient overflows.
        large, small = sorted((left, right), key=lambda term: (-abs(term.factor), term.node))
        ratio = small.factor / large.factor
        operation = "add" if ratio > 0 else "subtract"
        node = Node(operation, large.node, self._scaled(small.node, abs(ratio)))
        return Term(self._node(node), large.factor) if ratio else large

    def _scaled(self, node: int, factor: float) -> int:
        return node if factor == 1 else self._node(Node("scale", node, value=factor))

    def _node(self, node: Node) -> int:
        if node not in self._places:
            self._places[node] = len(self.nodes)
            self.nodes.append(node)
        return self._places[node]

    def _horner(self, entry: Mapping[Monomial, Fraction]) -> Term:
        varying = Counter(
            generator for monomial in entry for generator, _ in monomial if self._constant(generator) is None
        )
        if not varying:
            return self.scale(ONE, sum(self._number(monomial, coefficient) for monomial, coefficient in entry.items()))
        common = max(sorted(varying), key=varying.__getitem__)
        quotient: dict[Monomial, Fraction] = {}
        rest: dict[Monomial, Fraction] = {}
        for monomial, coefficient in entry.items():
            powers = dict(monomial)
            if common not in powers:
                rest[monomial] = coefficient
                continue
            powers[common] -= 1
            quotient[tuple((generator, power) for generator, power in powers.items() if power)] = coefficient
        factor = Term(self._node(Node("input", generator=common)), 1.0)
        return self._add(self.multiply(factor, self._horner(quotient)), self._horner(rest))

    def _number(self, monomial: Monomial, coefficient: Fraction) -> float:
        return float(coefficient) * prod((self._constant(generator) or 0.0) ** power for generator, power in monomial)
