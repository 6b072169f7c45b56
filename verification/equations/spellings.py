"""Spellings of names: points of a figure O_0O_2, arguments p_e(θ), an index above p^1_2, links left out A_1 ⋯ A_n."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

from armproof.verification.equations.compositions import arguments_fit
from armproof.verification.equations.sides import Members
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare
from armproof.verification.naming.quantities import numbered_frames

MOST_LINKS = 12
SCRIPTS = ("pre_sup", "pre_sub", "sup", "sub")
POINTS, INDEXED = frozenset("OPAEC"), frozenset("pPoOdRJvz")


class Spellings:
    """Reads as names what is spelt otherwise."""

    def __init__(self, members: Members) -> None:
        self.members = members
        self.names = members.names

    def read(self, node: n.Node) -> n.Node:
        """Return a side as the name that it is, or one in which points between braces are vectors."""
        return self._as_name(self._with_arrows(self._written_out(node)))

    def _written_out(self, node: n.Node) -> n.Node:
        """Return A_1 A_2 ⋯ A_n, or T_0^1 T_1^2 ⋯ T_{n-1}^n, with the links that its dots leave to the reader."""
        inner = bare(node)
        factors = tuple(map(_unapplied, inner.factors)) if isinstance(inner, n.Product) else ()
        at = next((k for k, factor in enumerate(factors) if isinstance(factor, n.Dots)), 0)
        names = [factor for factor in factors if isinstance(factor, n.Name)]
        if not 0 < at == len(factors) - 2 or len(names) != len(factors) - 1 or len({name.base for name in names}) > 1:
            return node
        first, last = map(self._indices, (names[0], names[-1]))
        steps = {one - other for one, other in zip(last.values(), first.values(), strict=False)}
        if not first or first.keys() != last.keys() or len(steps) != 1 or not at <= max(steps) <= MOST_LINKS:
            return node
        links = [
            _numbered(names[0], {script: index + k for script, index in first.items()}) for k in range(max(steps) + 1)
        ]
        shown = [self._indices(name) for name in names[:-1]]
        if shown != [self._indices(link) for link in links[: len(shown)]]:
            return node
        if not all(arguments_fit(inner, reference) for reference in ("upper", "lower")):
            return node  # A_1(q_1) A_2(q_3)
        return n.Product(tuple(links), ("",) * max(steps), span=node.span)

    def _indices(self, name: n.Name) -> dict[str, int]:
        """Return the numbers in the scripts of a name, n being that of the last frame; nothing where there is anything else."""
        assert self.names.arm is not None
        last = int(found) if (found := numbered_frames(self.names.arm)[-1]).isdigit() else 0
        scripts = dict(zip(SCRIPTS, (name.pre_sup, name.pre_sub, name.sup, name.sub), strict=True))
        values = {"n": last, "N": last, "n-1": last - 1, "N-1": last - 1}
        read = {key: values.get(text, int(text) if text.isdigit() else -1) for key, text in scripts.items() if text}
        return read if min(read.values(), default=-1) >= 0 and not (name.primes or name.dots) else {}

    def _with_arrows(self, node: n.Node) -> n.Node:
        """Two points in braces are what stands under an arrow; two origins side by side are a vector, too."""
        for below in [*n.walk(node)]:
            pair = below.inner if isinstance(below, n.Group) and below.brackets == "{}" else below
            origins = pair is below and all(isinstance(b, n.Name) and b.base == "O" and b.sub for b in n.children(pair))
            if (pair is not below or origins) and (name := self._between(pair)) is not None:
                node = n.substitute(node, below, name)
        return node

    def _between(self, node: n.Node) -> n.Name | n.Matrix | None:
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
        if start == end and start in self.names.arm.frames:  # O_3O_3
            return n.Matrix(((n.Number(Fraction(0), span=node.span),),) * 3, span=node.span)
        between = n.Name("O", f"{start}to{end}", pre_sup=second.pre_sup, span=node.span)
        return between if self.names.usual(between) else None

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
        return self._between(inner) or node


def _unapplied(node: n.Node) -> n.Node:
    """Return the A_1 of A_1(q_1)."""
    applied = n.is_call(node, "name") and len(node.arguments) == 2
    return node.arguments[0] if applied and isinstance(node, n.Call) else node


def _numbered(name: n.Name, indices: dict[str, int]) -> n.Name:
    """Return a name with these numbers for its scripts."""
    pre_sup, pre_sub, sup, sub = (str(indices.get(script, "")) for script in SCRIPTS)
    return replace(name, pre_sup=pre_sup, pre_sub=pre_sub, sup=sup, sub=sub)
