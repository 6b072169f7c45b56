r"""The arm of a figure that a document tells by vectors: \overrightarrow{OA} = l_1 \vec x_1, θ_1 = (\vec x_0, \vec x_1).

Solids bear numbers, and each turns on the one before it by an angle between axes; a vector whose size moves slides.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from itertools import islice, product
from typing import Any

from armproof.verification.document import Document
from armproof.verification.errors import ReadError
from armproof.verification.latex import nodes as n
from armproof.verification.latex.reader import key_as_latex
from armproof.verification.latex.solids import ARROWS
from armproof.verification.naming.moving import index_of, rates_in
from armproof.verification.naming.names import Names
from armproof.verification.patterns import regex
from armproof.verification.tables.arms.candidate import Candidate, renamed, symbol_of
from armproof.verification.tables.arms.moves import Moves

SOURCE = "figure"
MOST = 4  # ways in which the axes may lie that are weighed
_AXES = dict(zip("xyzijk", "xyzxyz", strict=True))
_ARROWS = tuple(f"\\{arrow}" for arrow in ARROWS)
_ANGLE = regex(r"(?:theta|phi|psi|alpha|beta|gamma|q)(?:_\d)?")
_OFFSETS = (" + pi/2", " - pi/2")
_OF_TIME = regex(r"\(\s*t\s*\)")
_NOTHING = {"a": "0", "alpha": "0", "d": "0", "theta": "0"}


@dataclass(frozen=True)
class _Turn:
    """A turn of one solid on another by an angle, which axes tell; about one of the others."""

    start: str
    end: str
    angle: str
    told: frozenset[str]
    offset: str = ""  # of its zero, where a picture alone tells that

    @property
    def about(self) -> tuple[str, ...]:
        """The axes about which it may be, the likelier first."""
        return tuple(axis for axis in "zyx" if axis not in self.told)


@dataclass(frozen=True)
class _Vector:
    """A vector between two points of a figure: its terms are letters along axes of solids."""

    start: str
    end: str
    terms: tuple[tuple[str, str, str], ...]  # size, axis, solid
    place: tuple[int | None, int]
    is_shown: bool  # in a display


@dataclass
class _Chain:
    """A chain that is built from the base, and which of its frames bear names."""

    moves: Moves = field(default_factory=Moves)
    solids: dict[str, int] = field(default_factory=lambda: {"0": 0})  # solid → frame, by its row
    points: dict[str, int] = field(default_factory=dict)
    solid: str = "0"

    @property
    def here(self) -> int:
        return len(self.moves.rows)

    def mark(self, point: str) -> None:
        """Let a point be where the chain has come, and the frame of its solid, unless that has a point of its number."""
        self.points[point] = self.here
        self._place_solid(point == f"O_{self.solid}")

    def turn(self, turn: _Turn, axis: str) -> None:
        """Turn on to the next solid about an axis, both ways of which the same frame has."""
        before: dict[str, list[tuple[str, str]]] = {
            "z": [], "y": [("alpha", "-pi/2")], "x": [("theta", "pi/2"), ("alpha", "pi/2")]
        }  # fmt: skip
        point = next((each for each, at in self.points.items() if at == self.here), "")
        self.solid = turn.end
        self._begin()
        for column, value in before[axis]:
            self.moves.add(column, value)
        self.moves.add("theta", symbol_of(turn.angle) + turn.offset, symbol_of(turn.angle))
        for column, value in reversed(before[axis]):
            self.moves.add(column, value.removeprefix("-") if value.startswith("-") else f"-{value}")
        self.solids[self.solid] = self.here
        if point == f"O_{turn.end}":
            self.points[point] = self.here

    def shift(self, size: str, axis: str, slider: str) -> None:
        """Go along an axis of the solid; what moves leads on to another solid, whose axes lie as its do."""
        sign, letter = "-" if size.startswith("-") else "", symbol_of(size.removeprefix("-"))
        self.solid = slider or self.solid
        self._begin()
        if slider and (sign or axis != "z"):
            self.moves.slide(f"{sign}{axis}", letter, letter)
        elif axis == "y":
            self.moves.slide("y", sign + letter, "")
        else:
            self.moves.add("d" if axis == "z" else "a", sign + letter, letter if slider else "")
        self._place_solid()

    def _place_solid(self, is_its_point: bool = False) -> None:
        if self.solid != "0" and (is_its_point or f"O_{self.solid}" not in self.points):
            self.solids[self.solid] = self.here

    def _begin(self) -> None:
        """Begin a row of its own behind a frame that has a name."""
        named = {*self.points.values(), *(at for solid, at in self.solids.items() if solid != self.solid)}
        if self.here in named and self.here:
            self.moves.rows.append(dict(_NOTHING))
            self.moves.joints.append("")

    @property
    def frames(self) -> tuple[str, ...]:
        """The names of all frames: solids by their numbers, O_3 beyond them by its own."""
        names = {at: solid for solid, at in self.solids.items()}
        for point, at in self.points.items():
            index = point.removeprefix("O_")
            if at not in names and index != point and index not in self.solids:
                names[at] = index
        return tuple("0" if k == 0 else names.get(k, f"f{k}") for k in range(self.here + 1))

    def candidate(self, path: Sequence[_Vector], angles: Sequence[str]) -> Candidate:
        """Return the arm, with the points that bear letters at its frames."""
        frames = self.frames
        quantities: dict[str, Any] = {
            point if point.startswith("O") else f"O_{point}": {"origin": frames[at]}
            for point, at in self.points.items()
            if point != f"O_{frames[at]}" and (at or point != "O")
        }
        shown = tuple(dict.fromkeys(each.place for each in path if each.is_shown))
        cell, line = path[0].place
        plain = "" not in self.moves.joints and frames == tuple(map(str, range(len(frames))))
        letters = [n.Name(*angle.partition("_")[::2]) for angle in angles]
        return Candidate(
            SOURCE, line, cell, tuple(self.moves.rows), tuple(self.moves.joints), renamed(letters), ("classic",),
            more_lines=shown, frames=() if plain else frames, quantities=quantities,
        )  # fmt: skip


def figure_arms(document: Document, names: Names) -> tuple[list[Candidate], list[Candidate]]:
    """Return the arms that the vectors of a document's figure may be of, and those with the zero of an angle elsewhere that no formula tells.

    Nothing where they make no chain, or where an angle is one between other axes.
    """
    turns: list[_Turn] = []
    vectors: list[_Vector] = []
    for place, latex, is_shown in _formulas(document):
        with suppress(ReadError, RecursionError):
            for statement in names.reader.read(_OF_TIME.sub(" ", latex)):
                if not isinstance(statement, n.Chain):
                    continue
                found = [*_turns(statement)]
                if not found and any(map(_is_pair, n.walk(statement))):
                    return [], []
                turns += found
                vectors += _vectors(statement, place, is_shown)
    path, moving = _path(vectors), {names.reader.key_of(key_as_latex(each)) for each in rates_in(document.displays)}
    guessed = _untold(turns, path, moving, document)
    order = _in_order([*turns, *guessed])
    if not order or not path:
        return [], []
    zeros = [
        [replace(turn, offset=offset) if turn == other else turn for turn in order]
        for other in guessed
        for offset in _OFFSETS
    ]
    return _arms(order, path, moving), [each for ways in zeros for each in _arms(ways, path, moving)[:2]]


def _arms(turns: Sequence[_Turn], path: Sequence[_Vector], moving: set[str]) -> list[Candidate]:
    ways = islice(product(*(turn.about for turn in turns)), MOST * MOST)
    found = (_candidate(turns, axes, path, moving) for axes in ways)
    return list({repr((each.rows, each.joints)): each for each in found if each is not None}.values())[:MOST]


def _is_pair(node: n.Node) -> bool:
    """Whether a node is the angle between axes of two solids."""
    inner = n.ungrouped(node)
    axes = [_axis(item) for item in inner.items] if isinstance(inner, n.Sequence) and len(inner.items) == 2 else []
    solids = {axis[1] for axis in axes if axis is not None}
    return len(solids) == 2


def _formulas(document: Document) -> Iterator[tuple[tuple[int | None, int], str, bool]]:
    yield from (((cell, line), latex, False) for cell, line, latex in document.figures)
    for each in document.displays:
        if each.closed and not (each.erratum or each.denied or each.supposed) and "\\" in each.latex:
            yield each.place, each.latex, True


def _turns(chain: n.Chain) -> Iterator[_Turn]:
    """Yield the turn that an angle is of: θ_1 = (x_0, x_1) = (y_0, y_1)."""
    pairs = [pair for member in chain.members if (pair := _between(member)) is not None]
    angles = [member for member in map(n.bare, chain.members) if isinstance(member, n.Name) and not member.dots]
    if not pairs or len(angles) != 1 or set(chain.relations) != {"="}:
        return
    (start, end, _), *_ = pairs
    if len(pairs) + 1 == len(chain.members) and all(pair[:2] == (start, end) for pair in pairs):
        yield _Turn(start, end, angles[0].key, frozenset(axis for *_, axis in pairs))


def _between(node: n.Node) -> tuple[str, str, str] | None:
    """Return the solids and the axis of (x_0, x_1), None of anything else."""
    inner = n.ungrouped(node)
    if not isinstance(inner, n.Sequence) or len(inner.items) != 2:
        return None
    one, other = (_axis(item) for item in inner.items)
    if one is None or other is None or one[0] != other[0] or one[1] == other[1]:
        return None
    return one[1], other[1], one[0]


def _axis(node: n.Node) -> tuple[str, str] | None:
    name = n.bare(node)
    is_axis = isinstance(name, n.Name) and name.base in _AXES and name.text.startswith(_ARROWS)
    if not (is_axis and isinstance(name, n.Name) and name.sub.isdigit() and not name.dots):
        return None
    return _AXES[name.base], name.sub


def _vectors(chain: n.Chain, place: tuple[int | None, int], is_shown: bool) -> Iterator[_Vector]:
    """Yield the vector between two points that a chain gives by letters along axes."""
    if set(chain.relations) != {"="}:
        return
    points = next((pair for member in chain.members if (pair := _points(member)) is not None), None)
    terms = next((found for member in chain.members if (found := _terms(member))), ())
    if points is not None and terms:
        yield _Vector(*points, terms, place, is_shown)


def _points(node: n.Node) -> tuple[str, str] | None:
    """Return the points between which a vector leads: OA, O_1O_2."""
    inner = n.bare(node)
    if isinstance(inner, n.Name) and re.fullmatch("[A-Z]{2}", inner.base) and inner == n.Name(inner.base):
        return inner.base[0], inner.base[1]
    while isinstance(inner, n.Group):
        inner = inner.inner
    pair = inner.factors if isinstance(inner, n.Product) and inner.operators == ("",) else ()
    one, other = pair if len(pair) == 2 else (None, None)
    if not (isinstance(one, n.Name) and isinstance(other, n.Name) and one.base == other.base == "O"):
        return None
    return _origin(one), _origin(other)


def _origin(name: n.Name) -> str:
    return f"O_{name.sub}" if name.sub else "O"


def _terms(node: n.Node) -> tuple[tuple[str, str, str], ...]:
    """Return the sizes along axes of which a vector is the sum, nothing of another formula."""
    inner = n.bare(node)
    found = []
    for sign, term in inner.terms if isinstance(inner, n.Sum) else (("+", inner),):
        product_of = n.bare(term)
        if not isinstance(product_of, n.Product) or len(product_of.factors) != 2 or sign not in ("+", "-"):
            return ()
        size, axis = n.bare(product_of.factors[0]), _axis(product_of.factors[1])
        if axis is None or not isinstance(size, n.Name) or size.dots or size.primes:
            return ()
        found.append((("-" if sign == "-" else "") + size.key, axis[0], axis[1]))
    return tuple(found)


def _in_order(turns: Sequence[_Turn]) -> list[_Turn]:
    """Return the turns in their order from the base on, each once; nothing where one solid turns in two ways."""
    merged: dict[tuple[str, str], _Turn] = {}
    for turn in turns:
        before = merged.get((turn.start, turn.end))
        if before is not None and before.angle != turn.angle:
            return []
        told = turn.told | (before.told if before is not None else frozenset())
        merged[turn.start, turn.end] = _Turn(turn.start, turn.end, turn.angle, told)
    found = sorted(merged.values(), key=lambda turn: turn.start)
    ways = [(turn.start, turn.end) for turn in found]
    forward = all(start < end for start, end in ways)
    is_chain = len({start for start, _ in ways}) == len({end for _, end in ways}) == len(ways)
    return found if forward and is_chain and found and found[0].start == "0" else []


def _untold(turns: Sequence[_Turn], path: Sequence[_Vector], moving: set[str], document: Document) -> list[_Turn]:
    """Return the turns that a picture alone tells: to each solid without one by the angle that moves, if these are as many."""
    used = {solid for vector in path for *_, solid in vector.terms}
    ends = [str(k) for k in range(1, int(max(used, default="0")) + 1) if str(k) not in {turn.end for turn in turns}]
    written = " ".join((*(each for *_, each in document.figures), *(each.latex for each in document.displays)))
    angles = {each for each in moving if _ANGLE.fullmatch(each)} - {turn.angle for turn in turns}
    order = sorted(angles, key=lambda angle: (index_of(angle), _first_place(angle.partition("_")[0], written)))
    if len(order) != len(ends):
        return []
    return [_Turn(str(int(end) - 1), end, angle, frozenset()) for end, angle in zip(ends, order, strict=True)]


def _first_place(letter: str, written: str) -> int:
    found = re.search(rf"\\(?:var)?{letter}(?![A-Za-z])|(?<![A-Za-z\\]){letter}(?![A-Za-z])", written)
    return found.start() if found is not None else len(written)


def _path(vectors: Sequence[_Vector]) -> list[_Vector]:
    """Return the vectors from the first point on, of two to one point the one that the text tells; nothing where it tells one twice otherwise."""
    steps: dict[tuple[str, str], _Vector] = {}
    for each in sorted(vectors, key=lambda vector: vector.is_shown):
        before = steps.setdefault((each.start, each.end), each)
        if before.terms != each.terms and not each.is_shown:
            return []
    ends = {end for _, end in steps}
    starts = [start for start, _ in steps if start not in ends]
    if len(set(starts)) != 1:
        return []
    found: list[_Vector] = []
    at, seen = starts[0], {starts[0]}
    while next_steps := [step for (start, end), step in steps.items() if start == at and end not in seen]:
        found.append(min(next_steps, key=lambda step: (step.is_shown, len(step.terms))))
        at = found[-1].end
        seen.add(at)
    return found


def _candidate(
    turns: Sequence[_Turn], axes: Sequence[str], path: Sequence[_Vector], moving: set[str]
) -> Candidate | None:
    """Return the arm of a chain; None where a vector lies along a solid that no turn leads to."""
    chain, left = _Chain(), [*zip(turns, axes, strict=True)]
    angles = {turn.angle for turn in turns}
    slides = [size for vector in path for size, *_ in vector.terms if size.removeprefix("-") in moving]
    if angles & {size.removeprefix("-") for size in slides}:
        return None
    free = _of_slides(turns, len(slides))
    chain.points[path[0].start] = 0
    for vector in path:
        for size, axis, solid in vector.terms:
            needed = str(int(free[0]) - 1) if size in slides else solid
            while chain.solid < needed and left and left[0][0].start == chain.solid:
                chain.turn(*left.pop(0))
            between = [about for turn, about in zip(turns, axes, strict=True) if solid <= turn.start < chain.solid]
            if solid > chain.solid or any(about != axis for about in between) or chain.solid < needed:
                return None  # it lies along an axis that has turned since, or that nothing leads to
            if size in slides and size.startswith("-") and axis != "z":
                return None
            chain.shift(size, axis, free.pop(0) if size in slides else "")
        chain.mark(vector.end)
    for turn, axis in left:
        if turn.start != chain.solid:
            return None
        chain.turn(turn, axis)
    return chain.candidate(path, [turn.angle for turn in turns])


def _of_slides(turns: Sequence[_Turn], count: int) -> list[str]:
    """Return the numbers of the solids that slide: those that turns leave."""
    turned = {turn.end for turn in turns}
    return [str(k) for k in range(1, len(turns) + count + 1) if str(k) not in turned][:count]
