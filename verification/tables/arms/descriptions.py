"""The arms that a text may tell of in words: chains of the joints, lengths and heights that its sentences name, in the ways in which they may be joined.

Nothing tells one of them from another but the equations beside: an arm is taken that most of these hold for.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import product
from typing import Any

from armproof.verification.document import Document
from armproof.verification.document.model import ToldPart
from armproof.verification.document.told_chains import (
    ABSOLUTE,
    ALONG_X,
    ALONG_Y,
    DISTANCE,
    DOWN,
    END,
    FROM_VERTICAL,
    HEIGHT,
    LENGTH,
    LIFTS,
    OF_EACH,
    OFFSET,
    OUTWARDS,
    PLANE,
    RELATIVE,
    SLIDE,
    TURN,
    UP,
    UPRIGHT,
    YZ,
)
from armproof.verification.naming.moving import index_of, rates_in
from armproof.verification.naming.names import Names
from armproof.verification.patterns import regex
from armproof.verification.tables.arms.candidate import Candidate, symbol_of
from armproof.verification.tables.arms.moves import Moves
from armproof.verification.tables.row import SCALES

SOURCE = "description"
MOST = 8  # readings that are weighed
_MOST_LETTERS = 9
_EACH = regex(r"_\s*\{?\s*[ik]\s*\}?$")  # the angle of each link
_OF_Q = regex(r"(?<![A-Za-z\\])q\s*_\s*\{?\s*1(?!\d)")
_WRITTEN = regex(r"(?<![A-Za-z\\])[yz](?![A-Za-z])")
_NUMBER = regex(r"(?<![\d._{])\d+(?:\.\d+)?(?![\d.])")
_REACH = ("r", "d", "s", "rho")  # distances that mostly vary
_FLAT, _UPRIGHT, _TURNED, _RAISED, _SIDEWAYS = (
    "flat",
    "upright",
    "turned",
    "raised",
    "sideways",
)  # planes: level, upright, upright and turned by the first joint, with y upwards
_WAYS = {UP: "up", DOWN: "down", ALONG_X: "x", ALONG_Y: "y", OUTWARDS: "x"}

# a column of a DH table or an axis to slide along; how far; the joint that moves it
Step = tuple[str, str, str]


@dataclass(frozen=True)
class _Part:
    """A letter of the build: its kind, and the words about it."""

    key: str
    kind: str
    marks: frozenset[str]

    @property
    def moves(self) -> bool:
        return self.kind in (TURN, SLIDE)


@dataclass(frozen=True)
class _Build:
    """The letters of an arm in the order of its text, joints by their numbers where they have some."""

    joints: tuple[_Part, ...]
    lengths: tuple[_Part, ...]
    heights: tuple[_Part, ...]
    offsets: tuple[_Part, ...] = ()
    told_planes: frozenset[str] = frozenset()
    written: frozenset[str] = frozenset()  # which of y and z the displays write

    def chains(self) -> Iterator[list[Step]]:
        """Yield the chains that these can be of."""
        for plane in self._planes():
            for ways in self._ways():
                for places, is_towards_x in product(self._places(plane), self._senses()):
                    yield from self._with_offsets(plane, self._steps(plane, ways, places, is_towards_x))

    def _with_offsets(self, plane: str, steps: list[Step]) -> Iterator[list[Step]]:
        """Yield the chain with what is shifted aside at its end, or in the turned plane before that stands up, to either side."""
        at = (
            next((k for k, (where, _, _) in enumerate(steps) if where == "alpha"), len(steps))
            if plane == _TURNED
            else len(steps)
        )
        is_told = all(ALONG_Y in each.marks for each in self.offsets)
        for sign in ("",) if is_told else ("", "-"):
            yield [*steps[:at], *(("y", sign + each.key, "") for each in self.offsets), *steps[at:]]

    @property
    def _turns(self) -> list[_Part]:
        return [each for each in self.joints if each.kind == TURN]

    def _senses(self) -> tuple[bool, ...]:
        """Return the ways in which what stands up may lean: towards x, or away from it."""
        return (True, False) if any(map(_is_from_vertical, self._turns)) else (True,)

    def _planes(self) -> list[str]:
        turns = self._turns
        if self.told_planes and not (turns and UPRIGHT in turns[0].marks and len(self.joints) > 2):
            return [_SIDEWAYS if YZ in self.told_planes else _UPRIGHT]
        if not turns or all(UPRIGHT in each.marks for each in turns):
            return [_FLAT]
        lifts = [LIFTS in each.marks for each in turns]
        raised = [_RAISED] if self.heights else []
        if UPRIGHT in turns[0].marks:
            is_level = not any(lifts[1:]) and not any(map(_is_absolute, turns[1:]))
            return [_TURNED, *([_FLAT] if is_level else [])] if len(turns) > 1 else [_FLAT]
        if any(lifts):
            return [_UPRIGHT, *raised, *([_TURNED] if len(turns) > 1 and not lifts[0] else [])]
        plain = {"y": [_FLAT], "z": [_UPRIGHT]}.get("".join(sorted(self.written)), [_FLAT, _UPRIGHT])
        return [*plain, *raised, *([_TURNED] if len(turns) > 2 else [])]

    def _ways(self) -> Iterator[dict[str, str]]:
        """Yield where each joint that slides may go."""
        slides = [each for each in self.joints if each.kind == SLIDE]
        told = [sorted(_WAYS[mark] for mark in each.marks if mark in _WAYS) for each in slides]
        for chosen in product(*((own if len(own) == 1 else ["x", "up", "down"]) for own in told)):
            yield {each.key: way for each, way in zip(slides, chosen, strict=True)}

    def _places(self, plane: str) -> Iterator[dict[str, list[_Part]]]:
        """Yield behind which joint each length may stand, "" for the base."""
        turns = self._turns[1:] if plane == _TURNED else self._turns
        first, numbers = self.joints[0].key, {_index(each.key): each.key for each in self.joints}
        own = [_index(each.key) for each in self.lengths]
        if all(own) and 0 not in numbers:
            by_number: dict[str, list[_Part]] = {}
            for each, number in zip(self.lengths, own, strict=True):
                behind = max((k for k in numbers if k <= number), default=0)
                by_number.setdefault(numbers.get(behind, ""), []).append(each)
            yield by_number
        extra = len(self.lengths) - len(turns)
        if extra in (0, -1):
            yield {turn.key: [each] for turn, each in zip(turns, self.lengths, strict=False)}
        if extra == 1:
            begin = first if plane == _TURNED else ""
            yield {
                begin: [self.lengths[0]],
                **{turn.key: [each] for turn, each in zip(turns, self.lengths[1:], strict=True)},
            }

    def _steps(
        self, plane: str, ways: dict[str, str], places: dict[str, list[_Part]], is_towards_x: bool
    ) -> list[Step]:
        """Return the steps of a chain; what stands up goes first, where its height counts in the base."""
        heights: list[Step] = [("d", f"-{each.key}" if DOWN in each.marks else each.key, "") for each in self.heights]
        if plane == _RAISED:
            heights = [("y", each.key, "") for each in self.heights]
        found, is_up = [*heights, *_along(places.get("", ()))], False
        if plane == _SIDEWAYS:  # its x is the y of the base, its y the z
            found, is_up = [*heights, ("theta", "pi/2", ""), ("alpha", "pi/2", ""), *_along(places.get("", ()))], True
        for k, joint in enumerate(self.joints):
            turns = joint.kind == TURN
            stands = (plane == _UPRIGHT and (turns or ways[joint.key] == "x")) or (plane == _TURNED and turns and k > 0)
            if _is_from_vertical(joint) and not is_up and (stands or plane == _FLAT):
                found += _standing(joint, plane == _FLAT, is_towards_x)
                is_up = True
            if stands and not is_up:
                found.append(("alpha", "-pi/2" if self._leads_down() else "pi/2", ""))
                is_up = True
            is_in_plane = is_up or plane == _RAISED
            found.append(
                ("theta", joint.key, joint.key) if turns else self._slide(joint.key, ways[joint.key], is_in_plane)
            )
            found += _along(places.get(joint.key, ()))
        return [*found, ("alpha", "-pi/2", ""), ("theta", "-pi/2", "")] if plane == _SIDEWAYS else found

    def _leads_down(self) -> bool:
        return any(DOWN in each.marks for each in self._turns[1:])

    @staticmethod
    def _slide(key: str, way: str, is_in_plane: bool) -> Step:
        if is_in_plane:
            return ("y", key, key) if way == "up" else ("y", f"-{key}", key) if way == "down" else ("x", key, key)
        return {"up": ("d", key, key), "down": ("-z", key, key), "x": ("x", key, key), "y": ("y", key, key)}[way]


def _is_from_vertical(part: _Part) -> bool:
    return FROM_VERTICAL in part.marks and UPRIGHT not in part.marks


def _standing(joint: _Part, is_flat: bool, is_towards_x: bool) -> list[Step]:
    """Return the steps to a frame whose x points up, or down, at the zero of an angle from the vertical, and whose y lies along the base's x, or against it; y is up in a flat plane."""
    is_down = DOWN in joint.marks
    turn = "-pi/2" if is_towards_x else "pi/2"
    if is_flat:
        return [*([("alpha", "pi", "")] if is_down != is_towards_x else []), ("theta", turn, "")]
    return [("alpha", "-pi/2" if is_down != is_towards_x else "pi/2", ""), ("theta", turn, "")]


def _along(lengths: Sequence[_Part]) -> list[Step]:
    return [("d" if UP in each.marks else "a", each.key, "") for each in lengths]


def described_arms(document: Document, names: Names) -> tuple[list[Candidate], list[Candidate]]:
    """Return the arms that a document's sentences may tell of, and those in which one of their directions is turned round.

    Nothing where they tell of no chain, or of absolute angles.
    """
    build = _build(document, names) if document.told else None
    told: list[Candidate] = []
    turned: list[Candidate] = []
    for steps in build.chains() if build is not None else ():
        _add(_candidate(steps, document), told)
        for other in _turned_round(steps):
            _add(_candidate(other, document), turned)
    return told[:MOST], [each for each in turned if not _is_among(each, told)][:MOST]


def _add(made: Candidate, found: list[Candidate]) -> None:
    if not _is_among(made, found):
        found.append(made)


def _is_among(made: Candidate, found: Sequence[Candidate]) -> bool:
    return any((each.rows, each.joints) == (made.rows, made.joints) for each in found)


def _turned_round(steps: Sequence[Step]) -> Iterator[list[Step]]:
    """Yield a chain with each of its directions turned round: along z, aside, or how it stands up."""
    for k, (where, value, joint) in enumerate(steps):
        if where in ("d", "-z") and joint:
            yield [*steps[:k], ("-z" if where == "d" else "d", value, joint), *steps[k + 1 :]]
        elif where in ("d", "y", "alpha"):
            other = value.removeprefix("-") if value.startswith("-") else f"-{value}"
            yield [*steps[:k], (where, other, joint), *steps[k + 1 :]]


def _build(document: Document, names: Names) -> _Build | None:
    """Return what a document's sentences tell of one chain, or None."""
    told = [each for each in document.told if each.kind not in (END, PLANE)]
    parts = _of_joints(_parts(told, document, names))
    parts = [*_turns_of_named(document, parts), *parts]
    joints = [each for each in parts if each.moves]
    moving = rates_in(document.displays)
    if len(joints) < 2 or len(parts) > _MOST_LETTERS or any(_is_of_each(each) for each in told):
        return None
    if any(each.key in moving for each in joints) and any(_stands(each, moving) for each in joints):
        return None
    numbers = [_index(each.key) for each in joints]
    if all(numbers) and len({*numbers}) == len(numbers):
        joints.sort(key=lambda each: _index(each.key))
    turns = [each for each in joints if each.kind == TURN]
    in_plane = turns[1:] if turns and UPRIGHT in turns[0].marks else turns
    if any(map(_is_absolute, in_plane[1:])) or any(OF_EACH in each.marks for each in in_plane):
        return None
    if len(in_plane) - 1 > sum(each.kind == LENGTH for each in parts) + sum(each.kind == SLIDE for each in joints):
        return None  # the text does not tell all
    of_kind = {kind: tuple(each for each in parts if each.kind == kind) for kind in (LENGTH, HEIGHT, OFFSET)}
    planes = frozenset(each.letter for each in document.told if each.kind == PLANE)
    written = frozenset(each for display in document.displays for each in _WRITTEN.findall(display.latex))
    return _Build(tuple(joints), of_kind[LENGTH], of_kind[HEIGHT], of_kind[OFFSET], planes, written)


def _turns_of_named(document: Document, parts: Sequence[_Part]) -> Iterator[_Part]:
    """Yield the joints of a planar arm that the text names, "a planar two-link arm", and of which it tells the lengths alone."""
    lengths = [each for each in parts if each.kind == LENGTH]
    if any(each.moves for each in parts) or {*document.planar} != {len(lengths)}:
        return
    letter = "q" if any(_OF_Q.search(display.latex) for display in document.displays) else "theta"
    for number in range(1, len(lengths) + 1):
        yield _Part(f"{letter}_{number}", TURN, frozenset())


def _is_absolute(part: _Part) -> bool:
    """Whether the angle of a link counts from one direction, as the others do."""
    return FROM_VERTICAL in part.marks or (ABSOLUTE in part.marks and RELATIVE not in part.marks)


def _is_of_each(told: ToldPart) -> bool:
    """Whether a sentence counts the angle of each link from one axis."""
    return ABSOLUTE in told.marks and _EACH.search(told.letter) is not None


def _stands(part: _Part, moving: set[str]) -> bool:
    """Whether a slide has neither a number nor a rate, where other joints have: it may be a length."""
    return part.kind == SLIDE and not _index(part.key) and part.key not in moving


def _of_joints(parts: Sequence[_Part]) -> list[_Part]:
    """Return the parts without angles that number no joint beside such that do, φ of a hand, and distances beside joints enough."""
    numbered = any(each.kind == TURN and _index(each.key) for each in parts)
    found = [each for each in parts if not (numbered and each.kind == TURN and not _index(each.key))]
    joints = sum(each.moves for each in found)
    return [
        each if each.kind != DISTANCE else replace(each, kind=SLIDE)
        for each in found
        if each.kind != DISTANCE or joints < 2
    ]


def _parts(all_told: Sequence[ToldPart], document: Document, names: Names) -> list[_Part]:
    """Return the letters of the build in their order, each once; a length that moves slides."""
    moving = rates_in(document.displays)
    kinds: dict[str, list[str]] = {}
    marks: dict[str, frozenset[str]] = {}
    for told in all_told:
        key = _size_in(document, told.letter) if told.letter[0].isdigit() else names.reader.key_of(told.letter)
        kinds.setdefault(key, []).append(told.kind)
        marks[key] = marks.get(key, frozenset()) | told.marks
    return [_Part(key, _kind(key, own, moving), _marks(own, marks[key])) for key, own in kinds.items() if key]


def _size_in(document: Document, told: str) -> str:
    """Return a length that the text has with its unit, 0.4 m, as the displays print it, in that unit or in metres; "" where none does."""
    number, unit = told.split()
    in_metres = f"{float(number) * SCALES.get(unit, 1):.6f}".rstrip("0").rstrip(".")
    printed = {each for display in document.displays for each in _NUMBER.findall(display.latex)}
    return next((each for each in (number, in_metres) if each in printed), "")


def _index(key: str) -> int:
    """Return the number that a letter has, 0 for a length that is a number itself."""
    return 0 if key[0].isdigit() else index_of(key)


def _kind(key: str, kinds: Sequence[str], moving: set[str]) -> str:
    if TURN in kinds:
        return TURN
    if SLIDE in kinds or key in moving:
        return SLIDE
    if OFFSET in kinds:
        return OFFSET
    if DISTANCE in kinds and not _index(key) and key in _REACH:
        return DISTANCE
    return LENGTH if LENGTH in kinds else HEIGHT if HEIGHT in kinds else SLIDE if _index(key) else LENGTH


def _marks(kinds: Sequence[str], marks: frozenset[str]) -> frozenset[str]:
    return marks | {UP} if HEIGHT in kinds and not marks & {DOWN} else marks


def _candidate(steps: Sequence[Step], document: Document) -> Candidate:
    moves = Moves()
    for where, value, joint in steps:
        sign = "-" if value.startswith("-") else ""
        length = value.removeprefix("-")
        text = value if value.endswith("pi/2") or length[0].isdigit() else sign + symbol_of(length)
        own = symbol_of(joint) if joint else ""
        if where in ("x", "y", "-z"):
            moves.slide(where, text, own)
        else:
            moves.add(where, text, own)
    cell, line = document.told[0].place
    found = Candidate(
        SOURCE, line, cell, tuple(moves.rows), tuple(moves.joints), conventions=("classic",), frames=moves.frames
    )
    return replace(found, quantities=_of_end(found, document))


def _of_end(found: Candidate, document: Document) -> dict[str, Any]:
    """Return the coordinates that have the name of the tool's point, x_P, where the text says which one that is."""
    count = str(sum(map(bool, found.joints)))
    ends = {each.letter for each in document.told if each.kind == END and each.marks <= {count}}
    frame = (found.frames or tuple(map(str, range(found.first, found.last + 1))))[-1]
    return {
        f"{axis}_{letter}": {"origin": frame, "component": axis}
        for letter in sorted(ends)
        for axis in "xyz"
        if any(
            re.search(rf"(?<![A-Za-z]){axis}\s*\}}?\s*_\s*\{{?\s*{letter}(?![A-Za-z])", each.latex)
            for each in document.displays
        )
    }
