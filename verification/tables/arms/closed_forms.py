"""The arm of a closed form that pins it: the coordinates of a chain of turns and slides in a plane, or in one that a first joint turns."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from armproof.verification.algebra.calculus import angles_in, derivative, substitute, symbols_in
from armproof.verification.algebra.ring import Ring, Scalar
from armproof.verification.document import Display, Document
from armproof.verification.document.other_meanings import ORDER
from armproof.verification.errors import EvaluationError
from armproof.verification.evaluation.exact import ExactAlgebra
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare, bare_key
from armproof.verification.naming.moving import FIRST_LETTERS, index_of, place_of, rates_in
from armproof.verification.naming.names import Names
from armproof.verification.patterns import regex
from armproof.verification.tables.arms.candidate import Candidate, entry_text, renamed, symbol_of
from armproof.verification.tables.arms.coordinate_slips import (
    Found,
    are_equal,
    goes_on_from,
    mended_coordinates,
)
from armproof.verification.tables.arms.jacobians import coordinates_of_jacobian
from armproof.verification.tables.arms.letters import equations_of, unapplied, value_in_letters
from armproof.verification.tables.arms.moves import Moves
from armproof.verification.tables.arms.poses import candidate_of_pose, frame_of_tool

_COORDINATE = regex(
    r"([xyzXYZ])(?:_(?:e|E|ee|EE|tool|tip|tcp|TCP|eff|endeffector|effector|end|n|\d))?"
    r"|[pP]_(?:e|E|ee|EE|tool|tip|tcp|TCP|(?P<point>\d))?,?([xyz])"
)
_OF_WRIST = regex(r"[pP]_(?:W|w|WC|wc),?([xyz])|(?:WC|wc)_([xyz])|([xyzXYZ])_(?:WC|wc)")
_OF_FIGURE = regex(r"[xyz]_([A-Z])")
_POINTS = ("p", "P", "X", "x")
_ENDS_OF = {letter: [f"{letter}_{end}" for end in ("e", "E", "ee", "EE", "tool", "n", "tip")] for letter in _POINTS}
_ANGLE = regex(r"(?:theta|q|phi|varphi)(?:_?\d+)?")
_OTHER_ANGLE = regex(r"(alpha|beta|gamma|delta|epsilon|zeta|eta|xi|psi|chi)_?\d+")
_SUM = regex(r"(theta|q)_(\d{2,})")
_SLIDE = regex(r"[dqr]_?\d+")
_NAMED = regex(r"[A-Za-z]\w*")
_LETTER = regex(r"(?:r|R|rho|w|k|u|d|D|phi|psi|beta|gamma|alpha)(?:_?\w+)?")
SECONDS = 0.3


def candidates_of_closed_form(document: Document, names: Names, has_table: bool = False) -> list[Candidate]:
    """Return the arm whose tool has the coordinates that a document gives first, or the pose; else that whose wrist has them.

    Beside a table, which gives another arm or none, a pose may be what is wrong. The coordinates in a pose tell nothing of a
    joint that turns the tool about its own origin: the pose of a frame beyond theirs does.
    """
    found = _of_point(document, names, _COORDINATE)
    beyond = len(found[0].joints) if found else 0
    algebra = ExactAlgebra(Ring(), None)
    with algebra.budget.of(SECONDS):
        of_pose = candidate_of_pose(document, names, algebra, beyond) if not has_table else None
    if of_pose is not None and all({*each.more_lines} == {*of_pose.more_lines} for each in found):
        return [of_pose]
    found = found or _of_point(document, names, _OF_WRIST) or _of_components(document, names)
    return found or _of_lettered_point(document, names)


def _of_point(document: Document, names: Names, spelt: re.Pattern[str]) -> list[Candidate]:
    """Return the arm whose point has the coordinates, spelt so, that a document gives first; those by one of two that do not fit together."""
    try:
        return _of_coordinates(document, names, spelt)
    except EvaluationError:  # too large to decide whether they fit together
        return []


def _of_coordinates(document: Document, names: Names, spelt: re.Pattern[str]) -> list[Candidate]:
    algebra = ExactAlgebra(Ring(), None)
    letters: dict[str, n.Name] = {}
    with algebra.budget.of(SECONDS):
        found: Found = {}
        meant = _meanings(document, names, algebra)
        points: dict[str, int] = {}  # the number of the point whose coordinate was found: x_1, before x_2 = x_1 + …
        for display in document.displays:
            given = [
                (axis, key, _with_meanings(value, {**_sums_of_angles(value, names, algebra), **meant}))
                for axis, key, value in _coordinates(display, names, algebra, letters, spelt)
                if "=" in display.latex
            ]
            given = [] if _are_of_another_point(given, found, points) else given
            for axis, key, value in given:
                number = _number(key)
                before = found[axis][0] if axis in found and points[axis] else None
                beside = [(each, other) for each, own, other in given if _number(own) == number and points.get(each)]
                goes_on = any(points[each] == number or goes_on_from(other, found[each][0]) for each, other in beside)
                is_next = before is not None and number > points[axis] and goes_on  # a slip is in one of two
                if axis not in found or is_next or (before is not None and not number):
                    found[axis], points[axis] = (value, display), number
                meant = {**meant, key: value} if number else meant
        rates, order = rates_in(document.displays), _told_order(document, names)
        arms = _arms(found, letters, algebra, rates, order) if {"x", "y"} <= found.keys() else []
        if any(each.mended for each in arms) and (as_told := _told_in_words(document, arms)) is not None:
            arms = [as_told]
        above = _arm_of_jacobian(document, names, algebra, rates, order) if not arms and spelt is _COORDINATE else []
        told = [(display.cell or 0, display.line) for _, display in found.values()]
        return arms or [each for each in above if all((each.cell or 0, each.line) < place for place in told)]


def _of_lettered_point(document: Document, names: Names) -> list[Candidate]:
    """Return the arm whose tool is a point of a figure, B of x_B and y_B, where a document has no other coordinates; of A and B the last."""
    told = [
        found[1]
        for display in document.displays
        for chain in equations_of(display, names)
        if (found := _OF_FIGURE.fullmatch(bare_key(chain.members[0]) or "")) is not None
    ]
    for letter in dict.fromkeys(reversed(told)):
        arms = _of_point(document, names, re.compile(f"([xyz])_{letter}"))
        if arms:
            named = [(f"{axis}_{letter}", axis) for axis in "xyz" if document.writes(f"{axis}_{letter}")]
            return [
                replace(each, quantities={key: {"origin": each.last, "component": axis} for key, axis in named})
                for each in arms
            ]
    return []


def _of_components(document: Document, names: Names) -> list[Candidate]:
    """Return the arm whose tool is at (x_1, x_2), where a document has no other coordinates: both are of the same lengths and angles."""
    algebra, letters = ExactAlgebra(Ring(), None), dict[str, n.Name]()
    with algebra.budget.of(SECONDS):
        given = [
            (key, value, display)
            for display in document.displays
            for _, key, value in _coordinates(display, names, algebra, letters, _COORDINATE)
        ]
        first = {key: (value, display) for key, value, display in reversed(given)}
        held = [symbols_in([value]) for value, _ in first.values()]
        if [*sorted(first)] != ["x_1", "x_2"] or held[0] != held[1]:
            return []
        found: Found = {"x": first["x_1"], "y": first["x_2"]}
        arms = _arms(found, letters, algebra, rates_in(document.displays), _told_order(document, names))
    return [
        replace(
            each,
            quantities={key: {"origin": each.last, "component": axis} for key, axis in (("x_1", "x"), ("x_2", "y"))},
        )
        for each in arms
    ]


def _told_order(document: Document, names: Names) -> tuple[str, ...]:
    """Return the joints in the order in which the text lists them, "in the order $\\theta, h, r$"; nothing where it lists none, or two orders."""
    told = {
        each.removeprefix(f"{ORDER} ")
        for display in document.displays
        for each in display.meant
        if each.startswith(f"{ORDER} ")
    }
    orders = {
        keys
        for each in told
        if all(keys := tuple(names.reader.key_of(part) for part in each.split())) and len(keys) > 1
    }
    return orders.pop() if len(orders) == 1 else ()


def _arms(
    found: Found, letters: Mapping[str, n.Name], algebra: ExactAlgebra, rates: set[str], order: tuple[str, ...]
) -> list[Candidate]:
    """Return the arm whose tool has these coordinates; those by one of two that do not fit together."""
    moves = _ClosedForm(algebra, {axis: value for axis, (value, _) in found.items()}, rates, order).moves()
    if moves is not None:
        return [_candidate(moves, found, letters)]
    tried = [
        (_ClosedForm(algebra, values, rates, order).moves(), told)
        for values, told in mended_coordinates(found, algebra)
    ]
    mended = [_candidate(moves, told, letters) for moves, told in tried if moves is not None]
    mended = [replace(each, mended=frozenset(range(1, len(each.rows) + 1))) for each in mended]
    return [each for each in mended if not _turns_back(each)]  # else it is seen from below, and a slip is in either


def _arm_of_jacobian(
    document: Document, names: Names, algebra: ExactAlgebra, rates: set[str], order: tuple[str, ...]
) -> list[Candidate]:
    """Return the arm whose tool has the Jacobian that a document prints, which another display, or the text, must show to be meant."""
    letters: dict[str, n.Name] = {}
    points, has_slip = coordinates_of_jacobian(document, names, algebra, letters)
    arms = [each for found in points for each in _arms(found, letters, algebra, rates, order)]
    if has_slip:
        arms = [replace(each, mended=frozenset(range(1, len(each.rows) + 1))) for each in arms]
    told = _told_in_words(document, arms)
    return [told] if told is not None else [replace(each, is_alone=True) for each in arms]


def _told_in_words(document: Document, arms: Sequence[Candidate]) -> Candidate | None:
    """Return the one of the arms that the text names, "a planar two-link arm": of its revolute joints alone, each link of a length of its own."""
    told = [each for each in arms if _is_plain(each) and len(each.joints) in document.planar]
    return replace(told[0], in_words=True, mended=frozenset()) if len(told) == 1 else None


def _is_plain(found: Candidate) -> bool:
    """Whether an arm is a planar one, whose links have the letters of different lengths."""
    rows = list(zip(found.rows, found.joints, strict=True))
    turns = all(row["theta"] == joint and row["d"] == row["alpha"] == "0" for row, joint in rows)
    lengths = [row["a"] for row in found.rows]
    return turns and all(map(_NAMED.fullmatch, lengths)) and len({*lengths}) == len(lengths)


def _are_of_another_point(given: Sequence[tuple[str, str, Scalar]], found: Found, points: Mapping[str, int]) -> bool:
    """Whether a display gives x and y anew, and not those that were found: its z is not of that point either."""
    anew = {axis: value for axis, key, value in given if key == axis and not points.get(axis)}
    return {"x", "y"} <= anew.keys() & found.keys() and not all(are_equal(anew[axis], found[axis][0]) for axis in "xy")


def _turns_back(found: Candidate) -> bool:
    """Whether a link leads backwards, a = -l_2: an author who says so of one coordinate alone has slipped there."""
    return any(row["a"].startswith("-") for row in found.rows)


def candidate_of_closed_form(document: Document, names: Names) -> Candidate | None:
    """Return the first arm that the coordinates which a document gives first can be of, or None."""
    return next(iter(candidates_of_closed_form(document, names)), None)


def point_given_anew(document: Document, names: Names) -> Display | None:
    """Return the first display that gives a point, p_2 or the tool, other coordinates than one before it."""
    algebra = ExactAlgebra(Ring(), None)
    met: dict[str, Scalar] = {}
    with algebra.budget.of(SECONDS):
        for display in document.displays:
            given = [
                (key, value)
                for _, key, value in _coordinates(display, names, algebra, {}, _COORDINATE)
                if key[2:].isdigit() or key in ("x", "y")
            ]
            if any(key in met and not are_equal(met[key], value) for key, value in given):
                return display
            met.update(given)
    return None


def coordinates_of_tool(document: Document, names: Names) -> Iterator[tuple[Display, dict[str, Scalar]]]:
    """Yield the displays that give coordinates of the tool by letters, x and y or x and z, each with these."""
    algebra = ExactAlgebra(Ring(), None)
    with algebra.budget.of(SECONDS):
        for display in document.displays:
            given = _coordinates(display, names, algebra, {}, _COORDINATE) if "=" in display.latex else ()
            own = {axis: value for axis, key, value in given if key == axis}
            if own:
                yield display, own


def _candidate(moves: Moves, told: Found, letters: Mapping[str, n.Name]) -> Candidate:
    """Return the arm that moves so, as some of the coordinates told it."""
    places = [(display.cell, display.line) for _, display in told.values()]
    cell, line = min(places, key=lambda place: (place[0] or 0, place[1]))
    joints = tuple(symbol_of(joint) if joint else "" for joint in moves.joints)
    return Candidate(
        "closed form", line, cell, tuple(moves.rows), joints, renamed(letters.values()), ("classic",), tuple(places),
        moves.frames,
    )  # fmt: skip


def _meanings(document: Document, names: Names, algebra: ExactAlgebra) -> dict[str, Scalar]:
    """Return what a document says of letters that are no coordinates and no joints, by angles: r = l_2 c_2 + l_3 c_23, φ = θ_2 + θ_3."""
    found: dict[str, set[Scalar]] = {}
    for display in document.displays:
        for chain in equations_of(display, names) if "=" in display.latex else ():
            key = bare_key(chain.members[0]) or ""
            if len(chain.members) != 2 or not _LETTER.fullmatch(key):
                continue
            evaluated = value_in_letters(chain.members[1], names, algebra)
            value = evaluated[0].normal() if evaluated is not None and isinstance(evaluated[0], Scalar) else None
            if value is not None and any(map(_ANGLE.fullmatch, symbols_in([value]))):
                found.setdefault(key, set()).add(_with_meanings(value, _sums_of_angles(value, names, algebra)))
    return {key: values.pop() for key, values in found.items() if len(values) == 1}


def _sums_of_angles(value: Scalar, names: Names, algebra: ExactAlgebra) -> dict[str, Scalar]:
    """Return what θ_{12} and θ_{123} in a coordinate are, the sums of angles; nothing where θ_{11} shows that digits number legs."""
    found = {key: match for key in symbols_in([value]) if (match := _SUM.fullmatch(key))}
    if any([*match[2]] != sorted({*match[2]}) for match in found.values()):
        return {}
    ring, signs = algebra.ring, names.reader.spelling.joint_signs
    return {
        key: sum((ring.symbol(f"{base}_{k}") * sign for sign, k in zip(signs(digits), digits, strict=True)), ring.zero)
        for key, (base, digits) in ((key, match.groups()) for key, match in found.items())
    }


def _number(key: str) -> int:
    """Return the number of the point of which a name is a coordinate, 0 for the tool."""
    return int(key[2:]) if key[2:].isdigit() else 0


def _with_meanings(value: Scalar, meant: Mapping[str, Scalar]) -> Scalar:
    """Return a coordinate with letters for what the document says they are."""
    used = {key: meant[key] for key in symbols_in([value]) if key in meant}
    try:
        return substitute(value, used).normal() if used else value
    except EvaluationError:
        return value


def _coordinates(
    display: Display, names: Names, algebra: ExactAlgebra, letters: dict[str, n.Name], spelt: re.Pattern[str]
) -> Iterator[tuple[str, str, Scalar]]:
    """Yield axis, name and value of the coordinates that a display gives: x = …, [x; y] = …, p = ….

    One that is a number, a bare length or a coordinate's letter tells nothing.
    """
    for chain in equations_of(display, names):
        for axis, key, node in _given(chain, spelt):
            evaluated = value_in_letters(node, names, algebra)
            is_letter = _COORDINATE.fullmatch(bare_key(node) or "") is not None
            if is_letter or evaluated is None or not isinstance(evaluated[0], Scalar):
                continue
            value = evaluated[0].normal()
            if axis == "z" or angles_in(value) or any(map(_SLIDE.fullmatch, symbols_in([value]))):
                letters.update({name.key: name for name in evaluated[1]})
                yield axis, key, value


def _given(chain: n.Chain, spelt: re.Pattern[str]) -> Iterator[tuple[str, str, n.Node]]:
    """Yield the axes with a name and what is printed for them: alone, in a column, or in the last column of a pose of the tool."""
    members = [unapplied(each) for each in chain.members]
    is_turned = _is_of_point(members[-1], spelt) and isinstance(members[0], n.Sum | n.Product | n.Matrix)
    name, *others = members[::-1] if is_turned and not _is_of_point(members[0], spelt) else members
    own = _coordinate(bare_key(name) or "", spelt)
    if own is not None and not isinstance(others[-1], n.Matrix):  # x = x_1 + l_2 c_12 = l_1 c_1 + l_2 c_12
        yield *own, others[-1]
    columns = [cells for other in reversed(others) if (cells := _column(name, other, spelt))]
    column = next((cells for cells in columns if not all(isinstance(bare(cell), n.Name) for cell in cells)), ())
    letters = [_coordinate(bare_key(row[0]) or "", spelt) for row in name.rows] if isinstance(name, n.Matrix) else []
    number = f"_{name.sub}" if isinstance(name, n.Name) and name.sub.isdigit() and name.base in _POINTS else ""
    named = letters if letters and None not in letters else [(axis, f"{axis}{number}") for axis in "xyz"]
    yield from ((*each, cell) for each, cell in zip(named, column, strict=False) if each is not None)


def _is_of_point(node: n.Node, spelt: re.Pattern[str]) -> bool:
    """Whether a side is a coordinate, or a column of them, and no formula: d_2 c_1 = x gives x as well as x = d_2 c_1 does."""
    cells = node.cells if isinstance(node, n.Matrix) else (node,)
    return all(_coordinate(bare_key(cell) or "", spelt) is not None for cell in cells)


def _coordinate(key: str, spelt: re.Pattern[str]) -> tuple[str, str] | None:
    """Return the axis along which a name is a coordinate, with its name by that axis: P_{2,x} is x_2."""
    match = spelt.fullmatch(key)
    if match is None:
        return None
    axis = str(match[match.lastindex or 0]).lower()
    point = match.groupdict().get("point")
    return axis, f"{axis}_{point}" if point else match[0]


def _column(name: n.Node, printed: n.Node, spelt: re.Pattern[str]) -> tuple[n.Node, ...]:
    """Return the coordinates in a matrix that a name of the tool's position or pose, or a column of x, y and z, is equated to."""
    if spelt is not _COORDINATE:
        return ()
    rows = printed.rows if isinstance(printed, n.Matrix) else ()
    if [len(row) for row in rows] == [4] * 4 and isinstance(name, n.Name) and frame_of_tool(name):
        return tuple(row[3] for row in rows[:3])
    if len(rows) not in (2, 3) or any(len(row) != 1 for row in rows):
        return ()
    letters = [bare_key(row[0]) for row in name.rows] if isinstance(name, n.Matrix) else []
    axes = [own[0] for key in letters if (own := _coordinate(key or "", spelt))]
    is_point = isinstance(name, n.Name) and name.base in _POINTS and _is_end_or_numbered(name)
    return tuple(row[0] for row in rows) if is_point or axes == list("xyz")[: len(rows)] else ()


def _is_end_or_numbered(name: n.Name) -> bool:
    """Whether a point is the tool, p or p_e, or one of the points of a chain: p_1, p_2, p_3."""
    is_numbered = name.sub.isdigit() and name.sub != "0" and name.key == f"{name.base}_{name.sub}"
    return name.key in (name.base, *_ENDS_OF[name.base]) or is_numbered


def _are_joints(angles: Sequence[str], rates: Collection[str]) -> bool:
    """Whether angles are called as joints are: θ_1, q_2; α_1 and α_2, of one letter alone; or α, β, γ, by the first letters.

    Beside a θ an α is what does not move; so is a β without a rate where the α before it alone has one.
    """
    moving = [angle in rates for angle in angles]
    if sum(moving) == 1 and not moving[-1] and not all(map(_ANGLE.fullmatch, angles)):
        return False
    others = [_OTHER_ANGLE.fullmatch(angle) for angle in angles]
    if angles and None not in others:
        return len({match[1] for match in others if match is not None}) == 1
    return all(map(_ANGLE.fullmatch, angles)) or {*angles} == {*FIRST_LETTERS[: len(angles)]}


# where to: a column of a DH table or an axis to slide along; how far; the joint that moves it
Step = tuple[str, Scalar, str]


@dataclass(frozen=True)
class _ClosedForm:
    """The coordinates of a tool in letters.

    Attributes:
        rates: the letters whose rates the document has.
        order: the joints as its text lists them.
    """

    algebra: ExactAlgebra
    values: Mapping[str, Scalar]
    rates: set[str]
    order: tuple[str, ...] = ()

    def moves(self) -> Moves | None:
        """Return the chain that has these coordinates, or None."""
        try:
            return self._moves()
        except EvaluationError:  # a coefficient is no sum of lengths
            return None

    def _moves(self) -> Moves | None:
        x, y, z = (self.values.get(axis, self.algebra.ring.zero) for axis in "xyz")
        angles, above = sorted(angles_in(x) | angles_in(y), key=place_of), angles_in(z)
        slides = self._slides(angles, strictly=bool(above))
        if not _are_joints(angles, self.rates) or len(angles) + len(slides) < 2:
            return None
        are_ordered = all(map(index_of, angles)) or set(angles) <= {*FIRST_LETTERS}
        if not (slides or are_ordered) or not (angles or len(slides) == 3):
            return None
        steps = self._turned(x, y, z, angles, slides) if above else self._level(x, y, z, angles, slides)
        order = [index_of(joint) for _, _, joint in steps or () if joint]
        if steps is None or len(order) < len(angles) + len(slides) or (all(order) and order != sorted(order)):
            return None
        moves = Moves()
        for where, value, joint in steps:
            if where in ("x", "y", "-z"):
                moves.slide(where, entry_text(value), joint)
            else:
                moves.add(where, entry_text(value), joint)
        return moves

    def _slides(self, angles: Sequence[str], strictly: bool) -> list[str]:
        """Return the letters of joints that slide: those with rates, or that have the numbers which angles leave out."""
        letters = sorted(symbols_in(self.values.values()) - set(angles), key=place_of)
        told = [letter for letter in letters if letter in self.rates or letter.startswith("q_")]
        found = [
            letter for letter in letters if _SLIDE.fullmatch(letter) and index_of(letter) not in map(index_of, angles)
        ]
        numbers = sorted(map(index_of, (*angles, *found)))
        are_all = {*told} <= {*found} and numbers == list(range(1, len(numbers) + 1))
        return found if not strictly and are_all else told

    def _level(
        self, x: Scalar, y: Scalar, z: Scalar, angles: Sequence[str], slides: Sequence[str]
    ) -> list[Step] | None:
        """A chain that turns about z and slides along itself and the axes: a planar arm, a SCARA, a cylinder, a gantry."""
        plane, up = self._in_plane(x, y, angles, slides), self._up(z, slides)
        return None if plane is None or up is None else self._with(up, plane)

    def _turned(
        self, x: Scalar, y: Scalar, z: Scalar, angles: Sequence[str], slides: Sequence[str]
    ) -> list[Step] | None:
        """A chain in an upright plane that a first joint turns: x = cos θ_1 (l_2 c_2 + l_3 c_23), z = l_1 + …."""
        first, *others = sorted(angles, key=lambda angle: angle in angles_in(z))
        if first in angles_in(z) or set(others) != angles_in(z):
            return None
        ring, zero = self.algebra.ring, self.algebra.ring.zero
        cosine, sine = self.algebra.cos_sin(ring.symbol(first))
        reach, base = substitute(x, {first: zero}), substitute(z, self._stretched(others))
        if not (are_equal(x, reach * cosine) and are_equal(y, reach * sine)):
            return None
        up, pi = self._up(base, slides), self.algebra.pi()
        for turn, height in ((pi / 2, z - base), (-pi / 2, base - z)):  # R_z R_y: positive angles lead down
            plane = self._in_plane(reach, height, others, slides)
            if plane is not None and up is not None:
                return [*self._with(up, [("theta", ring.symbol(first), first)]), ("alpha", turn, ""), *plane]
        return self._turned_from_upright(reach, z, first, others, slides)

    def _turned_from_upright(
        self, reach: Scalar, z: Scalar, first: str, others: Sequence[str], slides: Sequence[str]
    ) -> list[Step] | None:
        """Such a chain whose angles are counted from the vertical: x = cos θ_1 (l_2 s_2 + l_3 s_23), z = l_1 + l_2 c_2 + l_3 c_23."""
        ring, zero = self.algebra.ring, self.algebra.ring.zero
        quarter = dict.fromkeys(others[:1], self.algebra.pi() / 2)
        base = substitute(substitute(z, dict.fromkeys(others[1:], zero)), quarter)
        up, plane = self._up(base, slides), self._in_plane(z - base, reach, others, slides)
        if plane is None or up is None:
            return None
        back = -self.algebra.pi() / 2
        turn = [("alpha", back, ""), ("theta", back, "")]
        return [*self._with(up, [("theta", ring.symbol(first), first)]), *turn, *plane]

    def _stretched(self, angles: Sequence[str]) -> dict[str, Scalar]:
        return dict.fromkeys(angles, self.algebra.ring.zero)

    def _in_plane(self, u: Scalar, v: Scalar, angles: Sequence[str], slides: Sequence[str]) -> list[Step] | None:
        """Return the steps to (Σ r_k cos φ_k, Σ r_k sin φ_k), where φ_k is the sum of the first k angles."""
        links: list[Step] = []
        for count in range(len(angles), 0, -1):
            angle = self.algebra.ring.symbol(angles[count - 1])
            length = -substitute(derivative(derivative(u, angle), angle), self._stretched(angles))
            total = sum((self.algebra.ring.symbol(each) for each in angles[:count]), self.algebra.ring.zero)
            cosine, sine = self.algebra.cos_sin(total)
            u, v = (u - length * cosine).normal(), (v - length * sine).normal()
            slide = self._slide_in(length, slides)
            if slide is None or not symbols_in([length]):  # with numbers for lengths it is an example
                return None
            links = [("theta", angle, angles[count - 1]), ("x" if slide else "a", length, slide), *links]
        before = [
            (axis, value, self._slide_in(value, slides)) for axis, value in (("x", u), ("y", v)) if not value.is_zero()
        ]
        lengths = symbols_in(value for _, value, _ in links)
        unclear = any(
            slide is None or (axis == "y" and not lengths.isdisjoint(symbols_in([value])))
            for axis, value, slide in before
        )
        if unclear or angles_in(u) or angles_in(v):
            return None
        return [*((axis if slide or axis == "y" else "a", value, str(slide)) for axis, value, slide in before), *links]

    def _up(self, z: Scalar, slides: Sequence[str]) -> list[Step] | None:
        """Return the steps along z: a length and a joint that slides, at most."""
        slide = self._slide_in(z, slides, (1, -1))
        if slide is None:
            return None
        if slide and not are_equal(derivative(z, self.algebra.ring.symbol(slide)), self.algebra.ring.one):
            symbol = self.algebra.ring.symbol(slide)
            return [("d", z + symbol, ""), ("-z", symbol, slide)]
        return [("d", z, slide)] if not z.is_zero() else []

    def _slide_in(self, value: Scalar, slides: Sequence[str], factors: tuple[int, ...] = (1,)) -> str | None:
        """Return the joint that slides in a length, "" where none does, None for several or another multiple of one."""
        found = sorted(symbols_in([value]) & set(slides))
        if len(found) > 1:
            return None
        rates = [derivative(value, self.algebra.ring.symbol(joint)) for joint in found]
        fits = all(any((rate - factor).is_zero() for factor in factors) for rate in rates)
        return None if not fits else found[0] if found else ""

    def _with(self, up: Sequence[Step], steps: Sequence[Step]) -> list[Step]:
        """Return steps with those along z between, as the numbers of joints say, or the text: they may be taken anywhere."""
        fixed, sliding = [step for step in up if not step[2]], [step for step in up if step[2]]
        number = index_of(sliding[0][2]) if sliding else 0
        after = [k for k, (_, _, joint) in enumerate(steps) if number and index_of(joint) > number]
        if sliding and sliding[0][2] in self.order:
            behind = self.order[self.order.index(sliding[0][2]) + 1 :]
            after = [k for k, (_, _, joint) in enumerate(steps) if joint in behind]
        place = min(after, default=len(steps))
        return [*fixed, *steps[:place], *sliding, *steps[place:]]
