"""The kinds of quantities of an arm: what each is called, what a document may say of it, its value and its units.

A new kind is a class here, or a line of KINDS: front matter, both algebras, functions, feedback and words follow from it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any, ClassVar, Protocol

from armproof.models.arm import Arm, once_per_arm
from armproof.models.errors import Sentence
from armproof.models.exact.trace import trace_of
from armproof.verification.algebra.matrix import Matrix, column
from armproof.verification.algebra.protocol import Algebra, link_matrix
from armproof.verification.algebra.quantity import COMPONENTS, Quantity
from armproof.verification.findings import Finding, Kind, say


class OfArm(Algebra, Protocol):
    """An algebra that has the poses and the Jacobians of an arm."""

    arm: Arm | None

    def pose(self, frame: str, reference: str) -> Matrix:
        """Return ^{reference}T_{frame}, 4×4."""
        ...

    def jacobian(self, frame: str, expressed_in: str) -> Matrix:
        """Return the 6×n Jacobian at the frame's origin, relative to the arm's first frame, rows [v; ω]."""
        ...


@dataclass(frozen=True)
class QuantityKind:
    """A kind of quantity.

    Attributes:
        name: as the front matter calls it.
        words: what one is, for a reader, with {frame}, {start}, {along} and, where `rows` are of something in it, {rows}.
        options: what the front matter may say of it beside its frame.
        height, width: its rows and columns; no width is one column a joint.
        matrix: that of which it is a block, "pose" or "jacobian"; else empty.
        placed: whether it is expressed in a frame.
        scalar: whether it is one number.
        of_joints: whether the joints' values decide it.
    """

    name: str
    words: str
    options: frozenset[str] = frozenset()
    height: int = 3
    width: int | None = 1
    matrix: ClassVar[str] = ""
    placed: ClassVar[bool] = False
    scalar: ClassVar[bool] = False
    of_joints: ClassVar[bool] = True

    def whole(self, quantity: Quantity, algebra: OfArm) -> Matrix:
        """Return the matrix of which the quantity may be a few rows and columns."""
        raise NotImplementedError

    def unit(self, quantity: Quantity, arm: Arm, row: int, column: int) -> str:
        """Return the unit of an entry (from 0): m, rad, m/rad, …, or – for none."""
        return "–"

    def problem(self, quantity: Quantity, arm: Arm) -> Finding | None:
        """Say why an arm has no such quantity, or return None."""
        return None

    def tell(self, quantity: Quantity) -> Sentence:
        """Return what a quantity is, for a reader: "origin of frame 2 in frame 0, x"."""
        rows, columns = _rows(quantity.rows), _columns(quantity.columns)
        what = Sentence(self.words, frame=quantity.frame, along=quantity.along, start=quantity.start, rows=rows)
        if self.placed:
            what = Sentence("{what} in frame {reference}", what=what, reference=quantity.reference)
        if quantity.scalar and quantity.rows is not None and "component" in self.options and quantity.columns is None:
            return Sentence("{what}, {axis}", what=what, axis="xyz"[quantity.rows[0] - 1])
        rows = "" if "{rows}" in self.words else rows
        return Sentence("{rows}{columns}{what}", rows=rows, columns=columns, what=what) if rows or columns else what

    def component(self, quantity: Quantity, axis: str) -> Quantity:
        """Return the x, y or z of a column."""
        return replace(quantity, rows=(COMPONENTS[axis] + 1,), scalar=True)

    def block(self, quantity: Quantity, joints: int = 0) -> tuple[list[int], list[int]]:
        """Return the rows and columns, from 0, of its matrix that a quantity is."""
        return _chosen(range(self.height), quantity.rows), _chosen(range(self.width or joints), quantity.columns)


@dataclass(frozen=True)
class PartOfPose(QuantityKind):
    """A block of a 4×4 pose, X_{reference,frame}: all of it, its rotation, the frame's origin or one of its axes."""

    first: int | None = 0  # of its columns; None where the axis is meant
    matrix: ClassVar[str] = "pose"
    placed: ClassVar[bool] = True

    def whole(self, quantity: Quantity, algebra: OfArm) -> Matrix:
        rows, columns = self.block(replace(quantity, rows=None, columns=None))
        return algebra.pose(quantity.frame, quantity.reference).block(rows, columns)

    def unit(self, quantity: Quantity, arm: Arm, row: int, column: int) -> str:
        rows, columns = self.block(quantity)
        return "m" if columns[column] == 3 and rows[row] < 3 else "–"

    def block(self, quantity: Quantity, joints: int = 0) -> tuple[list[int], list[int]]:
        assert self.width is not None
        first = COMPONENTS[quantity.along] if self.first is None else self.first
        rows = range(4 if quantity.homogeneous else self.height)
        return _chosen(rows, quantity.rows), _chosen(range(first, first + self.width), quantity.columns)


class Difference(QuantityKind):
    """The vector p_frame − p_start in the reference."""

    placed = True

    def whole(self, quantity: Quantity, algebra: OfArm) -> Matrix:
        end, start = (
            algebra.pose(frame, quantity.reference).block(range(3), [3]).vector()
            for frame in (quantity.frame, quantity.start)
        )
        return column([to - since for to, since in zip(end, start, strict=True)])

    def unit(self, quantity: Quantity, arm: Arm, row: int, column: int) -> str:
        return "m"

    def block(self, quantity: Quantity, joints: int = 0) -> tuple[list[int], list[int]]:
        return super().block(quantity, joints)[0], [3]


class Jacobian(QuantityKind):
    """The geometric Jacobian of the frame's origin with respect to the first frame, 6×n, rows [v; ω]."""

    matrix = "jacobian"
    placed = True

    def whole(self, quantity: Quantity, algebra: OfArm) -> Matrix:
        return algebra.jacobian(quantity.frame, quantity.reference)

    def unit(self, quantity: Quantity, arm: Arm, row: int, column: int) -> str:
        rows, columns = self.block(quantity, len(arm.joints))
        above = "m" if rows[row] < 3 else "rad"
        below = _unit_of_joint(arm, arm.joints[columns[column]].symbol)
        return "–" if above == below else f"{above}/{below}"


class SpatialJacobian(Jacobian):
    """The twists in space that the joints' rates give, 6×n, rows [v; ω]: v of the point of the body that passes the reference's origin."""

    matrix = ""

    def whole(self, quantity: Quantity, algebra: OfArm) -> Matrix:
        moving = algebra.jacobian(quantity.frame, quantity.reference)
        place = algebra.pose(quantity.frame, quantity.reference).block(range(3), [3])
        columns = [_at_origin(each, place) for each in zip(*moving.rows, strict=True)]
        return Matrix(tuple(zip(*columns, strict=True)))


class Velocity(QuantityKind):
    """The Jacobian times the joint rates, 6×1, rows [v; ω]."""

    placed = True
    of_joints = False

    def whole(self, quantity: Quantity, algebra: OfArm) -> Matrix:
        assert algebra.arm is not None
        rates = column([algebra.symbol(f"dot {joint.symbol}") for joint in algebra.arm.joints])
        return algebra.jacobian(quantity.frame, quantity.reference) @ rates

    def unit(self, quantity: Quantity, arm: Arm, row: int, column: int) -> str:
        return "m/s" if self.block(quantity)[0][row] < 3 else "rad/s"

    def tell(self, quantity: Quantity) -> Sentence:
        if quantity.rows is None:
            return super().tell(quantity)
        rows = tuple((row - 1) % 3 + 1 for row in quantity.rows)
        if min(quantity.rows) <= 3 < max(quantity.rows):  # (v_x, v_y, ω)
            return super().tell(quantity)
        whole = super().tell(replace(quantity, rows=None if rows == (1, 2, 3) else rows))
        return (
            Sentence("linear {what}", what=whole) if max(quantity.rows) <= 3 else Sentence("angular {what}", what=whole)
        )

    def component(self, quantity: Quantity, axis: str) -> Quantity:
        first = 4 if quantity.rows and max(quantity.rows) > 3 else 1
        return replace(quantity, rows=(first + COMPONENTS[axis],), scalar=True)


class SpatialVelocity(Velocity):
    """The twist in space, 6×1, rows [v; ω]."""

    def whole(self, quantity: Quantity, algebra: OfArm) -> Matrix:
        place = algebra.pose(quantity.frame, quantity.reference).block(range(3), [3])
        return column(_at_origin(super().whole(quantity, algebra).cells, place))


class SolidVelocity(Velocity):
    """The velocity of a point of the solid of a frame as it is seen from that of another, and the rate at which it turns there, 6×1."""

    def whole(self, quantity: Quantity, algebra: OfArm) -> Matrix:
        place = algebra.pose(quantity.point or quantity.frame, quantity.reference).block(range(3), [3])
        own, other = (self._at(frame, place, quantity.reference, algebra) for frame in (quantity.frame, quantity.start))
        return column([one - two for one, two in zip(own.cells, other.cells, strict=True)])

    def _at(self, frame: str, place: Matrix, reference: str, algebra: OfArm) -> Matrix:
        twist = super().whole(Quantity("velocity", frame, reference), algebra)
        origin = algebra.pose(frame, reference).block(range(3), [3])
        lever = column([to - since for to, since in zip(origin.cells, place.cells, strict=True)])
        return column(_at_origin(twist.cells, lever))

    def tell(self, quantity: Quantity) -> Sentence:
        angular = quantity.rows is not None and min(quantity.rows) > 3
        point, solid, seen = quantity.point or quantity.frame, quantity.frame, quantity.start
        if angular:
            return Sentence("angular velocity of link {solid} seen from link {seen}", solid=solid, seen=seen)
        return Sentence(
            "velocity of the origin of frame {point} as a point of link {solid}, seen from link {seen}",
            point=point,
            solid=solid,
            seen=seen,
        )


class Angle(QuantityKind):
    """The sum of the joints' angles of a planar arm up to the frame, each with the sign of its axis: J's last row holds it."""

    scalar = True

    def whole(self, quantity: Quantity, algebra: OfArm) -> Matrix:
        assert algebra.arm is not None
        joints = column([algebra.symbol(joint.symbol) for joint in algebra.arm.joints])
        rates = algebra.jacobian(quantity.frame, algebra.arm.frames[0])
        return rates.block([5], range(len(algebra.arm.joints))) @ joints

    def unit(self, quantity: Quantity, arm: Arm, row: int, column: int) -> str:
        return "rad"

    def problem(self, quantity: Quantity, arm: Arm) -> Finding | None:
        return None if is_planar(arm) else say(Kind.NOT_PLANAR, kind_name=self.name, arm=arm.name)


class Task(Angle):
    """x, y and the angle of a planar arm's frame, 3×1."""

    placed = True
    scalar = False

    def whole(self, quantity: Quantity, algebra: OfArm) -> Matrix:
        position = algebra.pose(quantity.frame, quantity.reference).block(range(2), [3])
        return Matrix((*position.rows, *super().whole(quantity, algebra).rows))

    def unit(self, quantity: Quantity, arm: Arm, row: int, column: int) -> str:
        return "m" if self.block(quantity)[0][row] < 2 else "rad"


class Determinant(QuantityKind):
    """The determinant of the rows of a Jacobian."""

    scalar = True

    def whole(self, quantity: Quantity, algebra: OfArm) -> Matrix:
        return column([_rows_of_jacobian(quantity, algebra).determinant()])

    def problem(self, quantity: Quantity, arm: Arm) -> Finding | None:
        count = len(self.block(quantity)[0])
        return None if count == len(arm.joints) else say(Kind.NOT_SQUARE_ROWS, rows=count, joints=len(arm.joints))


class Manipulability(Determinant):
    """√det(J Jᵀ) of the rows of a Jacobian (Yoshikawa 1985)."""

    def whole(self, quantity: Quantity, algebra: OfArm) -> Matrix:
        part = _rows_of_jacobian(quantity, algebra)
        if part.shape[0] == part.shape[1]:  # det(J Jᵀ) = (det J)², which has fewer terms by far
            determinant = part.determinant()
            return column([algebra.sqrt(determinant * determinant)])
        return column([algebra.sqrt((part @ part.transpose).determinant())])

    def problem(self, quantity: Quantity, arm: Arm) -> Finding | None:
        count = len(self.block(quantity)[0])
        return None if count <= len(arm.joints) else say(Kind.TOO_MANY_ROWS, rows=count, joints=len(arm.joints))


class Link(QuantityKind):
    """The general link matrix of a convention, in the letters of any link."""

    of_joints = False

    def whole(self, quantity: Quantity, algebra: OfArm) -> Matrix:
        return link_matrix(algebra, quantity.frame)


class JointVariable(QuantityKind):
    """A joint's variable."""

    scalar = True

    def whole(self, quantity: Quantity, algebra: OfArm) -> Matrix:
        return column([algebra.symbol(quantity.frame)])

    def unit(self, quantity: Quantity, arm: Arm, row: int, column: int) -> str:
        return _unit_of_joint(arm, quantity.frame)


class JointVector(QuantityKind):
    """All joint variables."""

    def whole(self, quantity: Quantity, algebra: OfArm) -> Matrix:
        assert algebra.arm is not None
        return column([algebra.symbol(joint.symbol) for joint in algebra.arm.joints])

    def unit(self, quantity: Quantity, arm: Arm, row: int, column: int) -> str:
        return _unit_of_joint(arm, arm.joints[row].symbol)


def _options(text: str) -> frozenset[str]:
    return frozenset(text.split())


KINDS = {
    kind.name: kind
    for kind in (
        PartOfPose("pose", "pose of frame {frame}", _options("in rows columns component"), 4, 4),
        PartOfPose("rotation", "rotation of frame {frame}", _options("in rows columns"), 3, 3),
        PartOfPose("origin", "origin of frame {frame}", _options("in component rows homogeneous"), first=3),
        PartOfPose("axis", "{along} axis of frame {frame}", _options("in component along rows homogeneous"), first=None),
        Jacobian("jacobian", "the Jacobian of frame {frame}", _options("in rows columns"), 6, None),
        SpatialJacobian("spatial_jacobian", "the spatial Jacobian of frame {frame}", _options("in rows columns"), 6, None),
        Link("link", "general link matrix, {frame}", _options("rows columns"), 4, 4),
        Difference("difference", "vector from the origin of frame {start} to that of frame {frame}",
                   _options("in component rows homogeneous")),
        JointVariable("joint", "joint variable {frame}"),
        JointVector("vector", "the joint variables"),
        Velocity("velocity", "velocity of frame {frame}", _options("in rows component"), 6),
        SpatialVelocity("spatial_velocity", "spatial twist of frame {frame}", _options("in rows"), 6),
        SolidVelocity("solid_velocity", "velocity of link {frame} seen from link {start}", _options("in rows component"), 6),
        Angle("angle", "angle of frame {frame} about z"),
        Task("task", "x, y and angle of frame {frame}", _options("in rows")),
        Determinant("determinant", "determinant of {rows}the Jacobian of frame {frame}", _options("in rows"), 6),
        Manipulability("manipulability", "manipulability at frame {frame}", _options("in rows"), 6),
    )
}  # fmt: skip


def kind_of(quantity: Quantity) -> QuantityKind:
    """Return the kind of a quantity."""
    return KINDS[quantity.kind]


def as_front_matter(quantity: Quantity) -> dict[str, Any]:
    """Return a quantity of a frame as a front matter writes it."""
    frame, start, reference = (
        int(f) if f.isdigit() else f for f in (quantity.frame, quantity.start, quantity.reference)
    )
    spec: dict[str, Any] = {quantity.kind: [frame, start] if quantity.kind == "difference" else frame}
    plain = Quantity(quantity.kind, quantity.frame)
    if quantity.reference != plain.reference:
        spec["in"] = reference
    if quantity.along != plain.along:
        spec["along"] = quantity.along
    if quantity.homogeneous:
        spec["homogeneous"] = True
    if not quantity.scalar or "component" not in kind_of(quantity).options:
        parts = {"rows": quantity.rows, "columns": quantity.columns}
        return spec | {key: list(value) for key, value in parts.items() if value is not None}
    row = (quantity.rows or (1,))[0]
    if quantity.kind == "pose":
        return spec | {"component": [row, (quantity.columns or (1,))[0]]}
    part = {"rows": [4, 5, 6]} if row > 3 else {}
    return spec | part | {"component": list(COMPONENTS)[(row - 1) % 3]}


def as_line(name: str, quantity: Quantity) -> str:
    """Return the line of front matter that binds a name to a quantity."""
    spec = ", ".join(f"{option}: {value}" for option, value in as_front_matter(quantity).items())
    return f'quantities: {{"{name}": {{{spec}}}}}'


@once_per_arm
def is_planar(arm: Arm) -> bool:
    """Whether every revolute axis is parallel to z_0: then the tool's orientation is a sum of the joints' angles."""
    base, trace = arm.frames[0], trace_of(arm)
    turning = [index for index, joint in enumerate(arm.joints) if joint.kind == "revolute"]
    for frame in arm.frames[1:]:  # the nearest axis that is not parallel tells, and its trace is the shortest
        rows = trace.jacobian(frame, base, base)
        if any(rows[row][index] for row in (3, 4) for index in turning):
            return False
    return bool(turning)


def _chosen(places: Sequence[int], numbers: tuple[int, ...] | None) -> list[int]:
    return [places[number - 1] for number in numbers] if numbers else list(places)


def _rows(numbers: tuple[int, ...] | None) -> str:
    if numbers is None or len(numbers) == 1:
        return Sentence("row {number} of ", number=numbers[0]) if numbers else ""
    return Sentence("rows {numbers} of ", numbers=list(numbers))


def _columns(numbers: tuple[int, ...] | None) -> str:
    if numbers is None or len(numbers) == 1:
        return Sentence("column {number} of ", number=numbers[0]) if numbers else ""
    return Sentence("columns {numbers} of ", numbers=list(numbers))


def _unit_of_joint(arm: Arm, symbol: str) -> str:
    return "rad" if arm.joint(symbol).kind == "revolute" else "m"


def _at_origin(twist: Sequence[Any], place: Matrix) -> tuple[Any, ...]:
    """Return the twist [v + p × ω; ω] of a body of which the point at p moves with v."""
    linear, angular = column(twist[:3]), column(twist[3:])
    return (*(linear + place.cross(angular)).cells, *angular.cells)


def _rows_of_jacobian(quantity: Quantity, algebra: OfArm) -> Matrix:
    whole = algebra.jacobian(quantity.frame, quantity.reference)
    return whole.block(_chosen(range(6), quantity.rows), range(whole.shape[1]))
