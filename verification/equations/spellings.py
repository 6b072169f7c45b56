"""Spellings of names: points of a figure O_0O_2, arguments p_e(θ), an index above p^1_2."""

from __future__ import annotations

from dataclasses import replace

from armproof.verification.equations.sides import Members
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare
from armproof.verification.naming.conventions import conventional

POINTS, INDEXED = frozenset("OPAEC"), frozenset("pPoOdRJvz")


class Spellings:
    """Reads as names what is spelt otherwise."""

    def __init__(self, members: Members) -> None:
        self.members = members
        self.names = members.names

    def read(self, node: n.Node) -> n.Node:
        """Return a side as the name that it is, or one in which points between braces are vectors."""
        return self._as_name(self._with_arrows(node))

    def _with_arrows(self, node: n.Node) -> n.Node:
        """Two points in braces are what stands under an arrow; two origins side by side are a vector, too."""
        for below in [*n.walk(node)]:
            pair = below.inner if isinstance(below, n.Group) and below.brackets == "{}" else below
            origins = pair is below and all(isinstance(b, n.Name) and b.base == "O" and b.sub for b in n.children(pair))
            if (pair is not below or origins) and (name := self._between(pair)) is not None:
                node = n.substitute(node, below, name)
        return node

    def _between(self, node: n.Node) -> n.Name | None:
        if not isinstance(node, n.Product) or len(node.factors) != 2 or node.operators != ("",):
            return None
        first, second = node.factors
        if not (isinstance(first, n.Name) and isinstance(second, n.Name)):
            return None
        if not (self._is_point(first) and self._is_point(replace(second, pre_sup=""))):
            return None
        assert self.names.arm is not None
        start, end = (
            (first.sub or (first.base if first.base != "O" else self.names.arm.frames[0])),
            second.sub or second.base,
        )
        between = n.Name("O", f"{start}to{end}", pre_sup=second.pre_sup, span=node.span)
        return between if conventional(between, self.names.arm, self.names.transforms) else None

    def _is_point(self, name: n.Name) -> bool:
        """Whether a letter may be a point of a figure: it is no matrix A_1, and the document gives it no value."""
        placed = name.sup or name.pre_sub or name.pre_sup or name.primes or name.dots
        if name.base not in POINTS or placed or name.key in self.names.state.definitions:
            return False
        quantity = self.names.quantity(name)
        return self.names.known_symbol(name.key) is None and (quantity is None or quantity.kind == "origin")

    def _as_name(self, node: n.Node) -> n.Node:
        inner = bare(node)
        if isinstance(inner, n.Name) and len(inner.key) == 2 and set(inner.key) <= POINTS and self.names.is_open(inner):
            points = tuple(n.Name(letter, span=node.span) for letter in inner.base)
            return self._between(n.Product(points, ("",), span=node.span)) or node
        if isinstance(inner, n.Power) and isinstance(inner.base, n.Name) and isinstance(inner.exponent, n.Number):
            name, index = inner.base, str(inner.exponent.value)
            assert self.names.arm is not None
            placed = name.base in INDEXED and name.sub and not name.pre_sup and index in self.names.arm.frames
            return replace(name, sup=index) if placed and self.names.known_symbol(name.key) is None else node
        if (between := self._between(inner)) is not None:
            return between
        if not isinstance(inner, n.Product) or len(inner.factors) != 2 or inner.operators != ("",):
            return node
        first, second = inner.factors
        if not isinstance(first, n.Name):
            return node
        if isinstance(second, n.Group | n.Sequence) and not self.members.evaluate(first).known:
            arguments = second.items if isinstance(second, n.Sequence) else (second.inner,)
            if all(self._is_configuration(argument) for argument in arguments):
                return first
        return node

    def _is_configuration(self, node: n.Node) -> bool:
        return isinstance(node, n.Name) and (node.key in ("q", "theta", "Theta") or self.members.is_symbol(node))
