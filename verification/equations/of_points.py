"""Jacobians of points that a document gives itself: J_{v2} beside p_{c2}, and J beside x and y where there is no arm."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import permutations, product

from armproof.verification.algebra.calculus import angles_in, derivative, symbols_in
from armproof.verification.algebra.matrix import Matrix, as_matrix, stacked
from armproof.verification.algebra.quantity import Quantity
from armproof.verification.algebra.ring import Scalar
from armproof.verification.equations.alignment import Pair, agree_exactly, different_entries, exactly_equal, is_near
from armproof.verification.equations.outcome import Outcome
from armproof.verification.equations.sides import Members
from armproof.verification.errors import EvaluationError, UnboundName
from armproof.verification.evaluation.blocks import cells_of
from armproof.verification.evaluation.exact import ExactAlgebra
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare, bare_key
from armproof.verification.naming.conventions import LINEAR_VELOCITIES
from armproof.verification.naming.moving import FIRST_LETTERS, index_of, place_of
from armproof.verification.patterns import regex
from armproof.verification.verdict import Role, Verdict

MOST_ROWS = 3  # of the Jacobian of a point
_OF_POINT = regex(r"(?:v|P|p|L|T)?_?,?(?:c|cm|G|C)?,?_?(\d)")
_SLIDE = regex(r"[dr]_\d")
ENDS = (
    "",
    "_e",
    "_E",
    "_ee",
    "_EE",
    "_P",
    "_p",
    "_A",
    "_tip",
    "_t",
    "_T",
    "_f",
    "_foot",
)  # of x, the tool's coordinate
_POINTS = ("p", "P", "X")
ANGLES = ("phi", "varphi", "psi", "alpha", "gamma")  # of the tool in its plane
_REACHES = ("r", "rho", "d", "R")  # of x = r cos θ: a joint that slides along what another turns
_CENTRES = ("c{}", "c_{}", "C{}", "C_{}", "G{}", "G_{}", "cm{}", "cm_{}", "c,{}")


@dataclass(frozen=True)
class OfPoints:
    """Compares a matrix that gives a Jacobian its meaning with the derivatives of the point that has its index."""

    members: Members

    def judge(self, outcome: Outcome) -> Outcome:
        """Return a claim where the matrix holds the derivatives; a row that is no point's is wrong, if it is a slip away."""
        name = bare(outcome.printed.node) if outcome.printed is not None else None
        value = outcome.true.value if outcome.true is not None else None
        if (
            isinstance(name, n.Name)
            and name.base in LINEAR_VELOCITIES
            and name.sup == "2"
            and isinstance(value, Scalar)
        ):
            return self._of_speed(outcome, name, value)
        if not (isinstance(name, n.Name) and name.base == "J" and isinstance(value, Matrix)):
            return outcome
        if not all(isinstance(cell, Scalar) for cell in value.cells):
            return outcome
        consulted = frozenset(self.members.names.state.consulted)
        for point in self._points(name):
            for by in self._variables(point, value.shape[1]) if len(point) <= value.shape[0] <= MOST_ROWS else ():
                rows = [[derivative(cell, cell.ring.symbol(each)).normal() for each in by] for cell in point]
                rows += [[value.cells[0].ring.zero] * len(by)] * (value.shape[0] - len(rows))
                pair = Pair(Matrix(tuple(map(tuple, rows))), value)
                if agree_exactly(pair):
                    return _proved(outcome, by)
                if self._is_of(name) and is_near(pair) and (wrong := different_entries(pair, exactly_equal)):
                    return self._wrong(outcome, pair, wrong, by)
            if by := self._by_columns(point, value) if self.members.names.arm is None else ():
                return _proved(outcome, by)
        self.members.names.state.consulted.intersection_update(consulted)  # it rests on no point
        if self.members.names.arm is None and self._is_transposed(name, value):
            doubt = say(Kind.MAY_BE_TRANSPOSED, name=name.key)
            self.members.names.leave_open(name.key, doubt)
            return outcome.left_open(doubt)
        return outcome

    def _is_of(self, name: n.Name) -> bool:
        """Whether the index of a Jacobian is that of a point, so that it is no other's: J_{2R} may be."""
        made = self.members.names.state.definitions
        of_point = _OF_POINT.fullmatch(name.sub) is not None or name.base in LINEAR_VELOCITIES or not name.sub
        return of_point or any(f"{letter}_{name.sub}" in made for letter in "prPsxyz")

    @staticmethod
    def _by_columns(point: Sequence[Scalar], value: Matrix) -> tuple[str, ...]:
        """Return the letters by which the columns of a matrix are the derivatives of a point, each another; nothing where one is by none.

        Letters with numbers stand in their order; of others each order may be meant.
        """
        if not len(point) <= value.shape[0] <= MOST_ROWS or value.shape[1] < 2:
            return ()
        letters = sorted(symbols_in(point), key=place_of)
        slopes = {each: [derivative(cell, cell.ring.symbol(each)) for cell in point] for each in letters}
        found: list[str] = []
        for k in range(value.shape[1]):
            column = [row[k] for row in value.rows]
            rest = column[len(point) :]
            own = (each for each in letters if each not in found and _are_equal(column, slopes[each]))
            letter = next(own, "") if all(cell.is_zero() for cell in rest) else ""
            if not letter or all(cell.is_zero() for cell in column):
                return ()
            found.append(letter)
        counted = [each for each in found if index_of(each) or each in FIRST_LETTERS]
        return tuple(found) if counted == sorted(counted, key=place_of) else ()

    def _is_transposed(self, name: n.Name, value: Matrix) -> bool:
        """Whether the columns of a J are the derivatives of coordinates, and the rows of none."""
        turned = [[row[k] for row in value.rows] for k in range(value.shape[1])]
        by, by_turned = (next(self._variables(value.cells, k), None) for k in (value.shape[1], value.shape[0]))
        if name.sub or by is None or by_turned is None or value.shape[0] < 2 or value.shape[1] < 2:
            return False
        of_rows = all(_is_gradient(row, by) for row in value.rows)
        return not of_rows and all(_is_gradient(column, by_turned) for column in turned)

    def _of_speed(self, outcome: Outcome, name: n.Name, value: Scalar) -> Outcome:
        r"""Return v_{c2}^2 = … as a claim where it is \dot x_{c2}^2 + \dot y_{c2}^2, or a slip away from that."""
        for velocity, moving in self._velocities(name, value):
            square = sum((cell * cell for cell in velocity[1:]), velocity[0] * velocity[0]).normal()
            pair = Pair(as_matrix(square), as_matrix(value), is_scalar=True)
            if agree_exactly(pair):
                return _proved(outcome, moving)
            if is_near(pair):
                return outcome.as_wrong_claim(pair, [(0, 0)])
        return outcome

    def _velocities(self, name: n.Name, value: Scalar) -> Iterator[tuple[list[Scalar], list[str]]]:
        """Yield the velocity of the point with the index of a speed: by its coordinates in the document, or of the arm's frame."""
        arm, exact = self.members.names.arm, self.members.exact
        for point in self._points(name):
            letters = {each for cell in point for each in symbols_in([cell])}
            moving = sorted(each for each in letters if f"dot {each}" in symbols_in([value]))
            if {angle for cell in point for angle in angles_in(cell)} <= {*moving}:
                yield [_rate(cell, moving, exact) for cell in point], moving
        if arm is not None and name.sub in arm.frames:
            velocity = as_matrix(exact.quantity(Quantity("velocity", name.sub, arm.frames[0], rows=(1, 2, 3))))
            yield [*velocity.cells], [*self.members.names.joints]

    def _wrong(self, outcome: Outcome, pair: Pair, wrong: list[tuple[int, int]], by: Sequence[str]) -> Outcome:
        """Refute rows that are the derivatives of nothing; where they are those of another point, that may hold the slip."""
        if any(_is_gradient(pair.printed.rows[row], by) for row, _ in wrong):
            return self._left_open(outcome)
        return outcome.as_wrong_claim(pair, wrong)

    def _left_open(self, outcome: Outcome) -> Outcome:
        """Leave a matrix open with its name: it, or what says the coordinates, holds the slip."""
        assert outcome.printed is not None
        names, name = self.members.names, bare(outcome.printed.node)
        used = names.state.consulted & {(key, each.line) for key, each in names.state.definitions.items()}
        doubt = say(Kind.CONTRADICTED, name=name.key, lines=sorted({line for _, line in used}))  # type: ignore[attr-defined]
        names.leave_open(name.key, doubt)  # type: ignore[attr-defined]
        return outcome.left_open(doubt)

    def _points(self, name: n.Name) -> Iterator[tuple[Scalar, ...]]:
        """Yield the points with the index of a Jacobian, as the document gives them; x and y for J itself."""
        found = _OF_POINT.fullmatch(name.sub)
        subs = [each.format(found[1]) for each in _CENTRES] if found is not None else []
        has_arm = self.members.names.arm is not None
        subs = [name.sub] if name.base in LINEAR_VELOCITIES or (name.sub and not (subs or has_arm)) else subs
        of_tool = self._of_tool() if not has_arm and (not name.sub or not self._is_of(name)) else []
        keys = [*((f"{letter}_{sub}",) for sub in subs for letter in "prPs"), *of_tool]
        keys += [tuple(f"{axis}_{sub}" for axis in axes) for sub in subs for axes in ("xyz", "xy", "xz")]
        for each in keys:
            if all(key in self.members.names.state.definitions for key in each):
                yield from self._value(each)

    def _of_tool(self) -> list[tuple[str, ...]]:
        """Return the names of the tool's coordinates that a document gives: all, or those of a plane, with its angle there or not; or of its point."""
        made = self.members.names.state.definitions
        for end, letters in product(ENDS, ("xyz", "XYZ")):
            axes = tuple(f"{axis}{end}" for axis in letters if f"{axis}{end}" in made)
            angles = [
                (*axes[:2], key) for letter in ANGLES if (key := f"{letter}{end}") in made or (key := letter) in made
            ]
            if len(axes) > 1:
                return [*([axes] if len(axes) > 2 else angles), axes[:2]]
        return [(letter,) for letter in _POINTS]

    def _value(self, keys: Sequence[str]) -> Iterator[tuple[Scalar, ...]]:
        names, algebra = self.members.names, self.members.exact
        try:
            values = [as_matrix(stacked(names.defined_value(key, algebra))) for key in keys]  # type: ignore[arg-type]
        except (EvaluationError, UnboundName):
            return
        cells = tuple(cell for value in values for cell in value.cells if value.shape[1] == 1)
        if 1 < len(cells) <= MOST_ROWS and all(isinstance(cell, Scalar) for cell in cells):
            yield cells

    def _variables(self, point: Sequence[Scalar], count: int) -> Iterator[tuple[str, ...]]:
        """Yield the joints of so many columns: the arm's, those of q = (r, θ), or the angles of the point and those with smaller numbers."""
        arm = self.members.names.arm
        if arm is not None:
            joints = tuple(joint.symbol for joint in arm.joints)
        else:
            joints = self._told(count) or self._numbered(point, count)
        angles = {angle for cell in point for angle in angles_in(cell)}
        if len(joints) == count:
            yield joints
        elif angles == {*FIRST_LETTERS[:count]}:
            yield FIRST_LETTERS[:count]
        elif arm is None and len(angles) == 1 and count == len(angles) + 1:
            slides = sorted(symbols_in(point) & {*_REACHES})
            yield from permutations((*angles, *slides)) if len(slides) == 1 else ()

    def _told(self, count: int) -> tuple[str, ...]:
        """Return the joints that a document lists, q = (θ, r); nothing where it lists none, or others."""
        told = self.members.names.state.definitions.get("q")
        cells = cells_of(told.node) if told is not None and told.node is not None else ()
        joints = tuple(key for cell in cells if (key := bare_key(cell)))
        return joints if len(joints) == count == len(cells) else ()

    def _numbered(self, point: Sequence[Scalar], count: int) -> tuple[str, ...]:
        """Return the joints by their numbers, of which each angle of a point has one; where θ_2 is nowhere, d_2 slides."""
        angles = {angle for cell in point for angle in angles_in(cell)}
        letters = {angle.partition("_")[0] for angle in angles}
        slides = {each.partition("_")[2]: each for each in symbols_in(point) if _SLIDE.fullmatch(each)}
        turning = {angle.partition("_")[2] for angle in angles}
        numbers = [str(k) for k in range(1, count + 1)]
        joints = tuple(
            slides[k] if k in slides and k not in turning else f"{letter}_{k}" for letter in letters for k in numbers
        )
        return joints if len(letters) == 1 and angles <= {*joints} else ()


def _proved(outcome: Outcome, by: Sequence[str]) -> Outcome:
    said = say(Kind.DERIVATIVES_OF_POINT, letters=[*by])
    return replace(outcome, verdict=Verdict.PROVED, findings=(said,), role=Role.CLAIM, defines=())


def _are_equal(one: Sequence[Scalar], other: Sequence[Scalar]) -> bool:
    return all((a - b).normal().is_zero() for a, b in zip(one, other, strict=False))


def _rate(value: Scalar, moving: Sequence[str], exact: ExactAlgebra) -> Scalar:
    """Return the derivative of a coordinate in time, by the letters that have rates."""
    terms = (derivative(value, value.ring.symbol(each)) * exact.symbol(f"dot {each}") for each in moving)
    return sum(terms, value.ring.zero).normal()


def _is_gradient(row: Sequence[Scalar], by: Sequence[str]) -> bool:
    """Whether the entries of a row may be the derivatives of one coordinate: theirs do not depend on the order."""
    symbols = [row[0].ring.symbol(each) for each in by]
    return all(
        (derivative(row[a], symbols[b]) - derivative(row[b], symbols[a])).normal().is_zero()
        for a in range(len(by))
        for b in range(a)
    )
