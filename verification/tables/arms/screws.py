r"""The arm of a product of exponentials, T(θ) = e^{[S_1]θ_1} … e^{[S_n]θ_n} M, whose axes are printed as twists, or as ω_i with a point or a velocity.

Lynch and Park, Modern Robotics, ch. 4; Murray, Li and Sastry, A Mathematical Introduction to Robotic Manipulation, ch. 3.
"""

from __future__ import annotations

from contextlib import suppress
from dataclasses import dataclass, replace
from functools import reduce

from armproof.verification.algebra.matrix import Matrix
from armproof.verification.algebra.protocol import Value
from armproof.verification.algebra.ring import Ring, Scalar
from armproof.verification.document import Document
from armproof.verification.errors import EvaluationError
from armproof.verification.evaluation.exact import ExactAlgebra
from armproof.verification.evaluation.screws import Twist, exponents_in, in_brackets, key_of, split, written_out
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare, bare_key
from armproof.verification.naming.names import Names
from armproof.verification.tables.arms.candidate import Candidate, renamed
from armproof.verification.tables.arms.letters import equations_of, value_in_letters
from armproof.verification.tables.arms.poses import candidate_with_pose

Place = tuple[int | None, int]
Vector = tuple[Scalar, ...]

_OF_A_DIRECTION, _OF_A_VELOCITY, _OF_A_POINT = ("omega", "w"), ("v",), ("q", "r", "p")


@dataclass(frozen=True)
class _Axis:
    """What is printed of one joint's axis, and where: its twist, as velocity and direction, with the letters in it."""

    twist: Twist
    letters: tuple[n.Name, ...]
    places: tuple[Place, ...] = ()


def candidate_of_screws(document: Document, names: Names) -> Candidate | None:
    """Return the arm of the first product of exponentials of which a document prints each axis and the pose at zero, or None.

    None, too, where an axis is not along one of the base's.
    """
    if not names.reader.spelling.screws:
        return None
    printed = _Printed(document, names, ExactAlgebra(Ring(), None))
    for display in document.displays:
        for chain in equations_of(display, names):
            for member in chain.members[1:]:
                with suppress(EvaluationError, LookupError, RecursionError):
                    if (found := printed.arm_of(bare(member), display.place)) is not None:
                        key = bare_key(chain.members[0])
                        return replace(found, quantities={key: {"pose": found.frames[-1]}} if key else {})
    return None


class _Printed:
    """What a document prints of axes and of the pose at zero: the values of names, with their letters and places."""

    def __init__(self, document: Document, names: Names, algebra: ExactAlgebra) -> None:
        self.names, self.algebra = names, algebra
        self.values: dict[str, tuple[Value, tuple[n.Name, ...], Place]] = {}
        for display in document.displays:
            for chain in equations_of(display, names):
                key, told = bare_key(chain.members[0]), value_in_letters(chain.members[-1], names, algebra)
                if key and told is not None and isinstance(told[0], Matrix | list):
                    self.values.setdefault(key, (*told, display.place))

    def arm_of(self, node: n.Node, place: Place) -> Candidate | None:
        """Return the arm of a product, None where something of it is not printed; raises EvaluationError, LookupError."""
        factors = written_out(node).factors if isinstance(node, n.Product) else ()
        poses: list[Matrix] = []
        joints: list[str] = []
        letters: list[n.Name] = []
        places = [place]
        for factor in factors:
            (exponent, *more) = tuple(exponents_in(factor)) or (None,)
            found = self._motion(exponent) if exponent is not None and not more else self._home(factor)
            if found is None:
                return None
            pose, joint, own, at = found
            poses.append(pose)
            joints += filter(None, [joint])
            letters += own
            places += at
        if len(joints) < 2 or len(set(joints)) != len(joints) or len(poses) != len(joints) + 1:
            return None
        pose = reduce(Matrix.__matmul__, poses).map(lambda cell: cell.normal())
        arm = candidate_with_pose(pose, joints, place, self.algebra)
        given = tuple(dict.fromkeys(places))
        return replace(arm, symbols=renamed(letters), more_lines=given, products=given) if arm else None

    def _motion(self, exponent: n.Node) -> tuple[Matrix, str, tuple[n.Name, ...], tuple[Place, ...]] | None:
        """Return the exponential of a joint's twist, with the joint."""
        written, amount = split(exponent)
        joint, axis = bare(amount), self._axis(written)
        if not isinstance(joint, n.Name) or axis is None:
            return None
        motion = axis.twist.motion(self.algebra, self.algebra.ring.symbol(joint.key))
        return (motion, joint.key, (joint, *axis.letters), axis.places) if motion is not None else None

    def _home(self, factor: n.Node) -> tuple[Matrix, str, tuple[n.Name, ...], tuple[Place, ...]] | None:
        """Return the pose at zero that a name has, M or g_{st}(0)."""
        value, letters, place = self.values.get(bare_key(factor) or "", (None, (), (None, 0)))
        is_pose = isinstance(value, Matrix) and value.shape == (4, 4)
        return (value, "", letters, (place,)) if is_pose and isinstance(value, Matrix) else None

    def _axis(self, written: n.Node) -> _Axis | None:
        r"""Return the axis that [S_1] or \hat\xi_1 is of: as its own letter tells it, else those of its parts."""
        key, is_direction_first = key_of(written), in_brackets(written) is not None
        number = key.rpartition("_")[2]
        if (told := self._part((key.rpartition("_")[0],), number, 6)) is not None:
            cells, letters, place = told
            first, second = cells[:3], cells[3:]
            twist = Twist(first, second) if is_direction_first else Twist(second, first)
            return _Axis(twist, letters, (place,))
        return self._of_parts(number)

    def _of_parts(self, number: str) -> _Axis | None:
        """Return the axis of the ω_1 that a display prints, beside its v_1 or a point q_1 on it."""
        direction = self._part(_OF_A_DIRECTION, number)
        for letters, is_point in ((_OF_A_VELOCITY, False), (_OF_A_POINT, True)):
            if direction is not None and (other := self._part(letters, number)) is not None:
                twist = _twist(direction[0], other[0], is_point)
                return _Axis(twist, (*direction[1], *other[1]), (direction[2], other[2]))
        return None

    def _part(
        self, letters: tuple[str, ...], number: str, size: int = 3
    ) -> tuple[Vector, tuple[n.Name, ...], Place] | None:
        found = (self.values[key] for letter in letters if (key := f"{letter}_{number}") in self.values)
        return next(((_cells(value), own, place) for value, own, place in found if len(_cells(value)) == size), None)


def _cells(value: Value) -> Vector:
    """Return the numbers of a vector, a column, a row or a list; none of anything else."""
    cells = tuple(value) if isinstance(value, list) else value.cells if isinstance(value, Matrix) else ()
    is_vector = not isinstance(value, Matrix) or 1 in value.shape
    return cells if is_vector and not any(isinstance(each, Matrix | list) for each in cells) else ()


def _twist(direction: Vector, other: Vector, is_point: bool) -> Twist:
    """Return the twist of a direction and the velocity v, or v = −ω × q of a point q on its line."""
    if not is_point:
        return Twist(direction, other)
    x, y, z = (-each for each in direction)
    a, b, c = other
    return Twist(direction, (y * c - z * b, z * a - x * c, x * b - y * a))
