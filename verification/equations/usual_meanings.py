"""What a name that only convention binds may mean: its usual meanings, and which of them equations have shown."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from armproof.verification.algebra.calculus import degree_in, symbols_in
from armproof.verification.algebra.matrix import Matrix, as_scalar
from armproof.verification.algebra.quantity import Quantity
from armproof.verification.algebra.ring import Scalar
from armproof.verification.document.heading import sections_around
from armproof.verification.equations.alignment import (
    Pair,
    agree_exactly,
    align,
    different_entries,
    exactly_equal,
    square_rows,
)
from armproof.verification.equations.sides import Member, Members
from armproof.verification.errors import WhereDefined
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare
from armproof.verification.naming.conventions import (
    AXES,
    LETTERS,
    applied,
    is_usual,
    seen_from_wrist,
)
from armproof.verification.naming.shown import letters_of_point, point_of

MOST_ROWS = 3  # of a Jacobian whose determinant is only looked for


class UsualMeanings:
    """Tells what a name usually is, and what the document has shown it to be."""

    def __init__(self, members: Members) -> None:
        self.members = members
        self.names = members.names

    def usual(self, key: str) -> Quantity | None:
        """Return what an equation under this heading has shown a name to be, as convention says."""
        section, usual = self.names.state.section, self.names.state.usual
        if not usual:
            return None
        return next((usual[key, each] for each in (section, *sections_around(section)) if (key, each) in usual), None)

    def meant(self, key: str) -> set[Quantity]:
        """Return what equations have shown a name to be, under whatever heading."""
        return {quantity for (each, _), quantity in self.names.state.usual.items() if each == key}

    def shown(self, node: n.Node, name: n.Name) -> Quantity | None:
        """Return what a name has been shown to be under this heading, or always under others and what convention says first."""
        shown = self.meant(name.key)
        first = self.candidates(node, name)[:1] if len(shown) == 1 and is_usual(name) else ()
        return self.usual(name.key) or next((quantity for quantity in first if quantity in shown), None)

    def candidates(self, node: n.Node, name: n.Name) -> tuple[Quantity, ...]:
        """Return the usual meanings of a name that is open, the likelier first."""
        arm = self.names.arm
        if arm is None or name.base not in LETTERS or not self.names.is_open(name):
            return ()
        found = self.names.usual(name)
        if isinstance(bare(node), n.Call):
            found = tuple(dict.fromkeys((*found, *applied(name, arm))))
        found = tuple(quantity for quantity in found if self.names.may_be(name, quantity))
        return tuple(each for quantity in found if (each := self.with_rows(quantity)) is not None)

    def that_values_tell(self, node: n.Node, name: n.Name) -> tuple[Quantity, ...]:
        """Return the quantities that a name may be where one has exactly the value of the other side; it is no slip in any."""
        arm = self.names.arm
        if arm is None or not self.names.is_open(name) or isinstance(bare(node), n.Call):
            return ()
        return seen_from_wrist(name, arm, self.names.transforms)

    def with_rows(self, quantity: Quantity) -> Quantity | None:
        """A determinant and a manipulability are those of the rows in which J is printed, or that make it square."""
        if quantity.kind not in ("determinant", "manipulability"):
            return quantity
        whole = self.members.exact.jacobian(quantity.frame, quantity.reference)
        square = square_rows(whole)
        rows = self.names.rows_of("J") or (tuple(row + 1 for row in square) if square is not None else None)
        return replace(quantity, rows=rows) if rows is not None and len(rows) <= MOST_ROWS else None

    def measures_otherwise(self, quantity: Quantity, printed: Matrix) -> bool:
        """Whether a coordinate is beside what is no length: X = -2 P_z D_3, a coefficient of X s_2 + Y c_2 = Z."""
        if quantity.kind != "origin" or not quantity.scalar or printed.shape != (1, 1):
            return False
        arm = self.names.arm
        assert arm is not None
        slides = [symbol for symbol, joint in self.names.joints.items() if joint.kind == "prismatic"]
        degree = degree_in(printed.rows[0][0].normal(), {*arm.lengths, *slides})
        return degree is not None and degree > 1

    def is_usual(self, name: n.Name) -> bool:
        """Whether a name is so common, its index the letter of a frame of the arm or not: y_G where the arm has a G."""
        assert self.names.arm is not None
        is_of_frame = name.sub in self.names.arm.frames and not name.sub.isdigit()
        return is_usual(name) or (is_of_frame and is_usual(replace(name, sub="")))

    def is_beside_shown(self, name: n.Name, quantity: Quantity) -> bool:
        """Whether the other coordinates of a point have been shown under the names beside this one: x_G and z_G beside y_G."""
        shown = self.names.state.usual.items() if (point := point_of(quantity)) is not None else ()
        letters = letters_of_point(name.key)
        return any(point_of(other) == point and letters_of_point(key) == letters for (key, _), other in shown)

    def left_of_point(self, name: n.Name, cells: Sequence[n.Node], value: Matrix) -> Quantity | None:
        """Return what the name of a coordinate is in a column whose two others are those of a point, [x; y; z]; None where the column is that of another point."""
        names = [found for each in cells if (found := n.plain_name(each)) is not None]
        inferred = self.names.state.inferred
        beside = [inferred[each.key] for each in names if each.key != name.key and each.key in inferred]
        points = {*map(point_of, beside)}
        if len(names) != len(AXES) or value.shape != (len(AXES), 1) or len(beside) != len(AXES) - 1 or len(points) > 1:
            return None
        if len({letters_of_point(each.key) for each in names}) > 1 or self.is_of_another([Member(name, value)]):
            return None
        left = next((q for q in self.names.usual(name) if point_of(q) in points - {None} and q not in beside), None)
        whole = as_scalar(self.members.exact.quantity(left)) if left is not None else None
        printed = value.cells[names.index(name)]
        if not isinstance(whole, Scalar) or not isinstance(printed, Scalar):
            return None
        moves = symbols_in([whole - printed]) & self.names.joints.keys()  # where it stands its origin may be another
        return left if moves else None

    def is_named_in(self, member: Member, quantity: Quantity, key: str) -> bool:
        """Whether a side holds another name of a quantity: then an author who has both means something else by this one."""
        names = (below for below in n.names(member.node) if below.key != key)
        return any(self.names.quantity(each) == quantity for each in names)

    def is_of_own_letter(self, name: n.Name) -> bool:
        """Whether the letter of a name with an index means something of the document's own without it."""
        return bool(name.sub) and name.base in AXES and name.base in self.names.state.definitions

    def closest(self, tried: Member, other: Member) -> Pair | None:
        """Return the readings of both in one shape that differ in the fewest entries, or None."""
        if not (tried.known and other.known):
            return None
        with WhereDefined():
            pairs = list(align(tried.value, other.value, self.members.exact))
            return min(pairs, key=lambda pair: len(different_entries(pair, exactly_equal)), default=None)
        return None

    def is_of_another(self, known: list[Member]) -> bool:
        """Whether the value is exactly that of another frame: a wrist, an elbow under a name that the tool's has elsewhere."""
        values = [member.value for member in known if isinstance(member.value, Matrix)]
        return any(self._equals(quantity, value) for value in values for quantity in self.others())

    def others(self) -> Iterator[Quantity]:
        """Yield the origins, rotations and poses of all frames of the arm."""
        assert self.names.arm is not None
        for kind in ("origin", "rotation", "pose"):
            for frame in self.names.arm.frames[1:]:
                yield Quantity(kind, frame, self.names.base)

    def _equals(self, quantity: Quantity, value: Matrix) -> bool:
        whole = self.members.exact.quantity(quantity)
        same = isinstance(whole, Matrix) and whole.shape == value.shape
        return same and agree_exactly(Pair(whole, value))
