"""Names that sizes tell: x_2 beside a scalar is a coordinate, ṗ behind J^{-1} has as many rows as J."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction

from armproof.verification.algebra.matrix import Matrix, is_zero
from armproof.verification.algebra.quantity import Quantity
from armproof.verification.algebra.ring import Scalar
from armproof.verification.equations.alignment import exactly_equal
from armproof.verification.equations.doubts import Doubts
from armproof.verification.equations.sides import Member, Members
from armproof.verification.errors import ShapeError
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare
from armproof.verification.naming.conventions import AXES

IN_PLANE = (1, 2)


@dataclass(frozen=True)
class BySize:
    """Reads the members of a chain that do not fit together as their sizes tell."""

    members: Members
    doubts: Doubts

    def read(self, members: list[Member]) -> list[Member]:
        """Return the members, with those read otherwise that fit so."""
        members = [self._in_plane(each) if isinstance(each.problem, ShapeError) else each for each in members]
        scalars = [each.value for each in members if isinstance(each.value, Scalar)]
        return [self._with_coordinates(each, scalars) for each in members] if scalars else members

    def _in_plane(self, member: Member) -> Member:
        """Vectors without a third coordinate are read as columns of two."""
        node, names = member.node, self.members.names
        for below in [*n.names(node)]:
            plain = replace(below, dots=0)
            quantity = names.quantity(plain) if plain.key not in names.quantities else None
            if quantity is None or quantity.kind != "origin" or quantity.rows is not None:
                continue
            value = self.members.evaluate(plain).value
            if isinstance(value, Matrix) and is_zero(value.rows[2][0]):
                part = replace(below, sub=f"{plain.sub}rows {IN_PLANE}")
                names.state.inferred[replace(part, dots=0).key] = replace(quantity, rows=IN_PLANE)
                node = n.substitute(node, below, part)
        tried = self.members.evaluate(node) if node is not member.node else member
        return tried if tried.known else member

    def _with_coordinates(self, member: Member, scalars: Sequence[Scalar]) -> Member:
        """x_1^2 + y_1^2, and z_4 beside the height of the frame's origin, are made of coordinates and no axes."""
        if isinstance(member.value, Scalar):
            return member
        node, found, names = member.node, {}, self.members.names.state
        for below in [*n.walk(node)]:
            if not isinstance(below, n.Name) or not (below is bare(member.node) or below.sup):
                continue  # J^T z_1 is no square
            if (quantity := self._coordinate(below)) is not None:
                plain = replace(below, sup="", dots=0)
                found[plain.key] = quantity
                square = n.Power(replace(below, sup=""), n.Number(Fraction(2), "2"), span=below.span)
                node = n.substitute(node, below, square) if below.sup else node
        for key, quantity in found.items():
            names.infer_usual(key, quantity)
        tried = self.members.evaluate(node) if found else member
        value = tried.value
        if isinstance(value, Scalar) and not isinstance(bare(node), n.Name):
            self.doubts.weak |= found.keys()
            return tried
        if isinstance(value, Scalar) and any(exactly_equal(value, other) for other in scalars):
            return tried
        names.forget_usual(found)
        return member

    def _coordinate(self, name: n.Name) -> Quantity | None:
        """Return the coordinate that a name may be: x_1, or x_1^2 that was read as an axis in frame 2."""
        names = self.members.names
        plain = replace(name, dots=0)
        if name.base.lower() not in AXES or len(name.base) > 1 or name.sup not in ("", "2") or names.arm is None:
            return None
        if plain.key in (*names.quantities, *names.state.definitions) or names.known_symbol(plain.key) is not None:
            return None
        usual = names.usual(replace(plain, sup=""))
        return next((each for each in usual if each.kind == "origin" and each.scalar), None)
