"""The arm of a pose that a document prints whole: at zero its rate by each joint is that joint's axis, which must be one of the base's."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import partial, reduce
from itertools import product

from armproof.verification.algebra.calculus import angles_in, derivative, substitute, symbols_in
from armproof.verification.algebra.matrix import Matrix, column, inverse_pose, pose_of
from armproof.verification.algebra.protocol import elementary
from armproof.verification.algebra.ring import Scalar
from armproof.verification.document import Display, Document
from armproof.verification.errors import EvaluationError
from armproof.verification.evaluation.exact import ExactAlgebra
from armproof.verification.latex import nodes as n
from armproof.verification.naming.names import Names
from armproof.verification.patterns import regex
from armproof.verification.tables.arms.candidate import Candidate, entry_text, renamed, symbol_of
from armproof.verification.tables.arms.letters import equations_of, unapplied, value_in_letters
from armproof.verification.tables.arms.moves import Moves

_ANGLE = regex(r"(?:theta|q)_\d+")
_SLIDE = regex(r"[dqr]_\d+")
_QUARTERS = {1: "pi/2", 2: "pi", 3: "-pi/2"}
_UNITS = [tuple(sign * (row == axis) for row in range(3)) for axis in (2, 0, 1) for sign in (1, -1)]

_PAIRS = ((1, 2), (2, 0), (0, 1))  # of a cross product

Axis = tuple[int, ...]
Place3 = tuple[Scalar, Scalar, Scalar]
Turn = tuple[Axis, Axis, Axis]  # the columns of a rotation by right angles


def candidate_of_pose(document: Document, names: Names, algebra: ExactAlgebra, beyond: int = 0) -> Candidate | None:
    """Return the arm of the first pose of a tool that a document prints, of a frame beyond one of that number, or None."""
    for display in document.displays:
        for chain in equations_of(display, names) if "=" in display.latex else ():
            name = unapplied(chain.members[0])
            frame = frame_of_tool(name) if isinstance(name, n.Name) else ""
            if (
                frame.isdigit()
                and int(frame) > beyond
                and (found := _of_matrix(chain.members[-1], int(frame), display, names, algebra)) is not None
            ):
                return found
    return None


def pose_of_tool(document: Document, names: Names) -> tuple[Display, frozenset[str]] | None:
    """Return the first display that prints the pose of a tool entry by entry, of whatever arm, with its letters; or None."""
    for display in document.displays:
        for chain in equations_of(display, names) if "=" in display.latex else ():
            name, printed = unapplied(chain.members[0]), n.bare(chain.members[-1])
            rows = printed.rows if isinstance(printed, n.Matrix) else ()
            if isinstance(name, n.Name) and frame_of_tool(name) and [len(row) for row in rows] == [4] * 4:
                return display, frozenset(each.key for each in n.names(printed))
    return None


def frame_of_tool(name: n.Name) -> str:
    """Return the frame beyond the first whose pose in the base has a name, "" for any other."""
    scripts = sorted(part for part in (name.pre_sup, name.pre_sub, name.sup, name.sub) if part)
    pair = tuple(scripts[0]) if len(scripts) == 1 and len(scripts[0]) == 2 else tuple(scripts)
    return pair[1] if name.base in "THA" and len(pair) == 2 and pair[0] == "0" and pair[1] not in ("0", "1") else ""


def _of_matrix(node: n.Node, count: int, display: Display, names: Names, algebra: ExactAlgebra) -> Candidate | None:
    evaluated = value_in_letters(node, names, algebra) if isinstance(n.bare(node), n.Matrix) else None
    if evaluated is None or not isinstance(evaluated[0], Matrix) or evaluated[0].shape != (4, 4):
        return None
    pose = evaluated[0].map(lambda cell: cell.normal())
    try:
        found = candidate_with_pose(pose, _joints(pose, count), display.place, algebra)
    except (EvaluationError, LookupError):
        return None
    return replace(found, symbols=renamed(evaluated[1])) if found is not None else None


def candidate_with_pose(
    pose: Matrix, joints: Sequence[str], place: tuple[int | None, int], algebra: ExactAlgebra
) -> Candidate | None:
    """Return the arm whose tool has a pose, by its joints from the base on, or None; raises EvaluationError, LookupError."""
    chain = moves_with_pose(pose, joints, algebra)
    if chain is None:
        return None
    named = tuple(symbol_of(joint) if joint else "" for joint in chain.joints)
    frames = _frames(chain, len(joints))
    cell, line = place
    return Candidate(
        "closed form", line, cell, tuple(chain.rows), named, conventions=("classic",), more_lines=(place,), frames=frames
    )  # fmt: skip


def moves_with_pose(pose: Matrix, joints: Sequence[str], algebra: ExactAlgebra) -> Moves | None:
    """Return the rows of the chain of axes along those of its base that has a pose, or None; raises EvaluationError, LookupError."""
    return _Chain(algebra, pose, joints).moves()


def _joints(pose: Matrix, count: int) -> list[str]:
    """Return the joint of each number up to that of the last frame; raises LookupError where one is missing or none is the only one."""
    angles, letters = set().union(*map(angles_in, pose.cells)), symbols_in(pose.cells)
    found = []
    for number in range(1, count + 1):
        turning = {each for each in angles if _ANGLE.fullmatch(each) and each.endswith(f"_{number}")}
        sliding = {each for each in letters - angles if _SLIDE.fullmatch(each) and each.endswith(f"_{number}")}
        (joint,) = turning or sliding or {""}
        if not joint or len(turning or sliding) != 1:
            raise LookupError(number)
        found.append(joint)
    if angles - set(found):
        raise LookupError(count)
    return found


def _frames(chain: Moves, count: int) -> tuple[str, ...]:
    """Return names that no document has for the frames between, of which a pose tells nothing."""
    between = [f"{place // 8}{'stuvwxyz'[place % 8]}" for place in range(len(chain.rows) - 1)]
    return ("0", *between, str(count))


@dataclass(frozen=True)
class _Step:
    """A frame at zero, seen from the base: its axes and its origin, and the joint along its z, "" for that of the tool."""

    turn: Turn
    place: Place3
    joint: str = ""
    slides: bool = False


@dataclass(frozen=True)
class _Chain:
    """A pose, and the joints that it is made by, from the base on."""

    algebra: ExactAlgebra
    pose: Matrix
    joints: Sequence[str]

    def moves(self) -> Moves | None:
        """Return the chain of axes along those of the base that has this pose, or None; raises EvaluationError, LookupError."""
        moves, factors, before = Moves(), [], self._base
        for step in self._steps():
            shift = [
                self._along(axis, [b - a for a, b in zip(before.place, step.place, strict=True)])
                for axis in before.turn
            ]
            turned = tuple(tuple(_dot(axis, other) for axis in before.turn) for other in step.turn)
            _shift(moves, shift)
            _turn(moves, turned)  # type: ignore[arg-type]
            factors.append(self._matrix(turned, shift))
            if step.joint:
                moves.add("d" if step.slides else "theta", symbol_of(step.joint), step.joint)
                by = self.algebra.ring.symbol(step.joint)
                factors.append(elementary(self.algebra, "Trans" if step.slides else "Rot", "z", by))
            before = step
        made = reduce(Matrix.__matmul__, factors)
        same = all((a - b).normal().is_zero() for a, b in zip(made.cells, self.pose.cells, strict=True))
        return moves if same else None

    @property
    def _base(self) -> _Step:
        zero = self.algebra.ring.zero
        return _Step((_UNITS[2], _UNITS[4], _UNITS[0]), (zero, zero, zero))

    def _steps(self) -> Iterator[_Step]:
        """Yield the frame of each joint, then that of the tool."""
        at_zero = dict.fromkeys(self.joints, self.algebra.ring.zero)
        home = self.pose.map(lambda cell: substitute(cell, at_zero).normal())
        before = self._base
        for joint in self.joints:
            by_joint = partial(derivative, variable=self.algebra.ring.symbol(joint))
            rate = self.pose.map(by_joint).map(partial(substitute, values=at_zero))
            before = self._behind(before, joint, (rate @ inverse_pose(home)).map(Scalar.normal))
            yield before
        columns = tuple(_unit([home.rows[row][column] for row in range(3)]) for column in range(3))
        yield _Step(columns, tuple(home.rows[row][3] for row in range(3)))  # type: ignore[arg-type]

    def _behind(self, before: _Step, joint: str, twist: Matrix) -> _Step:
        """Return the frame of a joint by its twist in the base, [ω]× and v: the joint turns about a line, or slides where ω is none."""
        rows = twist.rows
        spin, velocity = (rows[2][1], rows[0][2], rows[1][0]), [row[3] for row in rows[:3]]
        slides = all(each.is_zero() for each in spin)
        axis = _unit(velocity if slides else spin)
        turn = _turned_to(axis, before.turn)
        if slides:
            return _Step(turn, before.place, joint, True)
        along, point = self._along(axis, before.place), self._cross(axis, velocity)
        x, y, z = (p + along * k for p, k in zip(point, axis, strict=True))
        return _Step(turn, (x, y, z), joint)

    def _along(self, axis: Axis, values: Sequence[Scalar]) -> Scalar:
        return sum((value * k for value, k in zip(values, axis, strict=True)), self.algebra.ring.zero)

    def _cross(self, axis: Axis, values: Sequence[Scalar]) -> list[Scalar]:
        return [(values[b] * axis[a] - values[a] * axis[b]).normal() for a, b in _PAIRS]

    def _matrix(self, turned: Sequence[Axis], shift: Sequence[Scalar]) -> Matrix:
        ring = self.algebra.ring
        turn = Matrix(tuple(tuple(ring.rational(axis[row]) for axis in turned) for row in range(3)))
        return pose_of(turn, column(shift), ring.zero, ring.one)


def _unit(values: Sequence[Scalar]) -> Axis:
    """Return the axis of the base that a vector is; raises LookupError where it is none."""
    for unit in _UNITS:
        if all((value - k).normal().is_zero() for value, k in zip(values, unit, strict=True)):
            return unit
    raise LookupError(values)


def _dot(one: Axis, other: Axis) -> int:
    return sum(a * b for a, b in zip(one, other, strict=True))


def _turned_to(axis: Axis, turn: Turn) -> Turn:
    """Return the rotation with an axis for its z, the x of the one before if that is at right angles to it."""
    if turn[2] == axis:
        return turn
    across = next(each for each in (turn[0], turn[1], turn[2]) if _dot(each, axis) == 0)
    other = tuple(axis[a] * across[b] - axis[b] * across[a] for a, b in _PAIRS)
    return across, other, axis


def _shift(moves: Moves, shift: Sequence[Scalar]) -> None:
    for parameter, value in zip(("a", "y", "d"), shift, strict=True):
        if (text := entry_text(value)) != "0":
            if parameter == "y":
                moves.slide("y", text, "")
            else:
                moves.add(parameter, text)


def _turn(moves: Moves, turned: Turn) -> None:
    """Add the turns about z, x and z by right angles that make a rotation."""
    for quarters in sorted(product(range(4), repeat=3), key=lambda each: sum(map(bool, each))):
        if _made(quarters) == turned:
            for column, count in zip(("theta", "alpha", "theta"), quarters, strict=True):
                if count:
                    moves.add(column, _QUARTERS[count])
            return
    raise LookupError(turned)


def _made(quarters: Sequence[int]) -> Turn:
    """Return the columns of R_z R_x R_z by numbers of right angles."""
    columns = [list(each) for each in ((1, 0, 0), (0, 1, 0), (0, 0, 1))]
    for (a, b), count in zip(((0, 1), (1, 2), (0, 1)), quarters, strict=True):
        for _ in range(count):  # the columns of R·R_z(π/2) are y and -x of R
            columns[a], columns[b] = columns[b], [-each for each in columns[a]]
    return tuple(map(tuple, columns))  # type: ignore[return-value]
