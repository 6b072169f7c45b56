"""Tables of joint origins are claims: x, y, z, roll, pitch, yaw, links, type and axis of each joint, as in a URDF."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace

from models.entry import generators
from models.exact import exact_number
from models.origins import JointOrigin, joint_origins
from verification.document import Table
from verification.equation import ChainChecker
from verification.errors import EvaluationError
from verification.latex import nodes as n
from verification.matrix import Matrix
from verification.tables.cells import Cell, UnreadableCell, cell_values, read_cell
from verification.tables.columns import plain, read_header
from verification.tables.row import SCALES, Angle, angle_as_scalar, constant_angle, to_radians
from verification.tables.words import Notation, change_of_angle, change_of_length
from verification.trig import Ring, Scalar
from verification.verdict import Record, Verdict, WrongEntry

XYZ, RPY = ("x", "y", "z"), ("roll", "pitch", "yaw")
_HEADERS = {
    "joint": r"(?:joint|liaison|articulation)s?(?: name)?|name|nom|",
    "parent": r"parent(?: link)?",
    "child": r"child(?: link)?",
    "type": r"(?:joint )?(?:type|kind)",
    "axis": r"(?:joint )?axis",
    **{letter: letter for letter in (*XYZ, *RPY)},
}
_UNIT = re.compile(r"\s*(?:[(\[].*[)\]]|,\s*\w+|\sin\s+\w+)$")
_KINDS = {"revolute": r"r|rev\w*|rot\w*|continuous|pivot", "prismatic": r"p|pris\w*|slid\w*|gliss\w*", "fixed": r"f|fix\w*|weld"}
_AXES = {"x": (1.0, 0.0, 0.0), "y": (0.0, 1.0, 0.0), "z": (0.0, 0.0, 1.0)}


def check_origins(checker: ChainChecker, table: Table, blank: Record) -> Record | None:
    """Return the record of a table of joint origins, or None where it is none: most rows must name joints of the arm."""
    columns = origin_columns(table.header)
    arm = checker.names.arm
    if columns is None or arm is None:
        return None
    origins = joint_origins(arm)
    first = columns["joint"]
    named = [_named(origins, row[first]) if first < len(row) else None for row in table.rows]
    if 2 * sum(name is not None for name in named) <= len(named):
        return None
    try:
        return _OriginTable(checker, table, columns, origins).record(blank)
    except UnreadableCell as problem:
        return replace(blank, verdict=Verdict.UNREADABLE, message=str(problem))


def origin_columns(header: tuple[str, ...]) -> dict[str, int] | None:
    """Return the column (from 0) of each role, or None where the header has no joint, x, y and z.

    A column of anything else makes x, y and z those of something else (masses), unless links or angles stand there too.
    """
    place: dict[str, int] = {}
    for k, text in enumerate(header):
        spelt = _UNIT.sub("", plain(text).lower()).strip()
        if role := next((role for role, words in _HEADERS.items() if re.fullmatch(words, spelt)), None):
            place.setdefault(role, k)
    only_origins = len(place) == len(header) or bool(place.keys() & {"parent", "child", *RPY})
    return place if {"joint", *XYZ} <= place.keys() and only_origins else None


def _spelt(name: str) -> str:
    """A name without what makes no difference: its case, backslashes, and - or a blank for _."""
    return re.sub(r"[-_\s]+", "_", re.sub(r"[\\{}`*]", "", plain(name)).strip().lower())


def _named(names: Mapping[str, JointOrigin], text: str) -> str | None:
    return next((name for name in names if _spelt(name) == _spelt(text)), None)


@dataclass(frozen=True)
class _Row:
    """A row and the joint that it is about: by its name, else by its child link."""

    number: int
    texts: Mapping[str, str]
    joint: str
    origin: JointOrigin


class _OriginTable:
    """Compares the cells of one table with the joint origins of the arm."""

    def __init__(
        self, checker: ChainChecker, table: Table, columns: dict[str, int], origins: Mapping[str, JointOrigin]
    ) -> None:
        self.names, self.algebra = checker.names, checker.exact
        self.ring: Ring = checker.exact.ring
        self.columns, self.origins = columns, origins
        self.units = {role: read_header(table.header[k]).unit for role, k in columns.items()}
        assert checker.names.arm is not None
        self.lengths = {s: self.ring.rational(exact_number(v)) for s, v in checker.names.arm.lengths.items()}
        self.problems: list[str] = []
        self.notes: dict[str, None] = {}
        self.rows = [row for number, texts in enumerate(table.rows, 1) if (row := self._row(number, texts))]
        self.cells = {
            (row.number, role): self._cell(row, role) for row in self.rows for role in (*XYZ, *RPY) if role in columns
        }
        xyz = [tree for (_, role), cell in self.cells.items() if role in XYZ for tree in cell.trees]
        self.has_letters = any(isinstance(node, n.Name) for tree in xyz for node in n.walk(tree))
        self.notation = Notation(self.names, self.cells.values())

    def record(self, blank: Record) -> Record:
        """Return the record of the table."""
        entries = [entry for row in self.rows for entry in self._wrong_entries(row)]
        without = [name for name in self.origins if name not in {row.joint for row in self.rows}]
        said = [f"row {e.row}: {e.printed or 'empty'} should be {e.correct}: {e.change}" for e in entries]
        said += [*self.problems, *self.notes]
        said += [f"no row for {', '.join(without)}"] if without else []
        if entries or self.problems:
            verdict = Verdict.REFUTED if entries else Verdict.UNCHECKED
            return replace(blank, verdict=verdict, message="; ".join(said), entries=tuple(entries))
        holds = f"the origins of {len(self.rows)} joints of the model"
        return replace(blank, verdict=Verdict.PROVED, message="; ".join([holds, *said]))

    # -- reading -----------------------------------------------------------------------------------------------------

    def _row(self, number: int, cells: tuple[str, ...]) -> _Row | None:
        texts = {role: cells[k] if k < len(cells) else "" for role, k in self.columns.items()}
        joint = _named(self.origins, texts["joint"])
        if joint is None and "child" in texts:
            joint = next((j for j, o in self.origins.items() if _spelt(o.child) == _spelt(texts["child"])), None)
        if joint is None:
            known = ", ".join(self.origins)
            self.problems.append(f"row {number}: no joint '{texts['joint']}' in the model; its joints are {known}")
            return None
        return _Row(number, texts, joint, self.origins[joint])

    def _cell(self, row: _Row, role: str) -> Cell:
        try:
            cell = read_cell(self.names, row.texts[role])
            if cell.kind == "variable":
                raise UnreadableCell(f"'{cell.text}' is no coordinate")
            return replace(read_cell(self.names, "0"), text=cell.text) if cell.kind == "blank" else cell
        except UnreadableCell as problem:
            raise UnreadableCell(f"row {row.number}, column {self.columns[role] + 1}: {problem}") from None

    # -- comparing ---------------------------------------------------------------------------------------------------

    def _wrong_entries(self, row: _Row) -> Iterator[WrongEntry]:
        """Yield the wrong cells of a row, in the order of the columns."""
        checks: dict[str, Callable[[_Row, str], tuple[str, str] | None]] = {
            "joint": lambda r, _: self._name(r.texts["joint"], r.joint, "the joint's name"),
            "parent": lambda r, _: self._name(r.texts["parent"], r.origin.parent, "the parent link"),
            "child": lambda r, _: self._name(r.texts["child"], r.origin.child, "the child link"),
            "type": self._kind,
            "axis": self._axis,
            **dict.fromkeys(XYZ, self._length),
            **({} if self._same_rotation(row) else dict.fromkeys(RPY, self._angle)),
        }
        for role, column in sorted(self.columns.items(), key=lambda item: item[1]):
            try:
                wrong = checks[role](row, role) if role in checks else None
            except EvaluationError as problem:
                self.problems.append(f"row {row.number}: {role}: {problem}")
                continue
            if wrong is not None:
                yield WrongEntry(1, row.number, column + 1, row.texts[role].strip(), wrong[0], wrong[1])

    def _name(self, printed: str, name: str, what: str) -> tuple[str, str] | None:
        return None if _spelt(printed) == _spelt(name) else (name, what)

    def _kind(self, row: _Row, role: str) -> tuple[str, str] | None:
        kind = row.origin.kind
        return None if re.fullmatch(_KINDS[kind], _spelt(row.texts[role])) else (kind, f"the joint is {kind}")

    def _axis(self, row: _Row, role: str) -> tuple[str, str] | None:
        axis, text = row.origin.axis, plain(row.texts[role]).lower()
        printed = tuple(float(part) for part in re.findall(r"[-+]?\d*\.?\d+", text))
        if letter := re.fullmatch(r"([-+]?)\s*([xyz])", text):
            printed = tuple((letter.group(1) != "-" or -1) * part for part in _AXES[letter.group(2)])
        if axis is None or len(printed) != 3:
            return None
        if max(abs(a - b) for a, b in zip(axis, printed, strict=True)) < 1e-9:
            return None
        return " ".join(f"{part:g}" for part in axis), "the axis"

    def _length(self, row: _Row, role: str) -> tuple[str, str] | None:
        """Compare a coordinate: symbols with the symbol of the place, numbers with its number."""
        symbol = self.ring.from_entry(row.origin.xyz[XYZ.index(role)])
        number = self.algebra.substitute(symbol, self.lengths)
        scale = self.ring.rational(SCALES.get(self.units[role], 1))
        rights, changes = [], []
        values = self._values(row, role)
        for value in values:
            is_number = value.as_fraction() is not None
            printed, right = (value * scale, number) if is_number else (value, symbol)
            in_numbers = is_number and (len(values) > 1 or not self.has_letters)
            rights.append(self.notation.value(number / scale if in_numbers else symbol))
            if not (printed - right).is_zero():
                changes.append(change_of_length(printed, right) or "another length")
        return (" = ".join(rights), changes[0]) if changes else None

    def _angle(self, row: _Row, role: str) -> tuple[str, str] | None:
        cosine, sine = self._right_angle(row, role)
        for value in self._values(row, role):
            printed = self.ring.cos_sin(value)
            if (printed[0] - cosine).is_zero() and (printed[1] - sine).is_zero():
                continue
            names = {name for kind, name in generators(row.origin.rpy[RPY.index(role)]) if kind == "cos"}
            right = angle_as_scalar(self.ring, (cosine, sine), (), [constant_angle(self.ring, name) for name in names])
            if right is None:
                return "another angle", "the angle"
            degrees = "" if self.units[role] == "deg" else None
            return self.notation.value(right, degrees), change_of_angle(value, right) or "the angle"
        return None

    def _right_angle(self, row: _Row, role: str) -> Angle:
        cosine, sine = row.origin.rpy[RPY.index(role)]
        return self.ring.from_entry(cosine), self.ring.from_entry(sine)

    def _values(self, row: _Row, role: str) -> tuple[Scalar, ...]:
        values = cell_values(self.names, self.algebra, self.cells[row.number, role])
        if role in XYZ:
            return values
        read = [to_radians(value, self.units[role]) for value in values]
        self.notes.update(dict.fromkeys(note for _, note in read if note))
        return tuple(value for value, _ in read)

    def _same_rotation(self, row: _Row) -> bool:
        """Whether the three angles make the joint's rotation: they need not be its own three (pitch ± π/2)."""
        if not set(RPY) <= self.columns.keys():
            return False
        try:
            printed = [self.ring.cos_sin(self._values(row, role)[-1]) for role in RPY]
        except EvaluationError:
            return False
        difference = _rotation(self.ring, printed) + -_rotation(self.ring, [self._right_angle(row, r) for r in RPY])
        return all(cell.is_zero() for cells in difference.rows for cell in cells)


def _rotation(ring: Ring, rpy: list[Angle]) -> Matrix:
    """Rz(yaw) Ry(pitch) Rx(roll)."""
    (cr, sr), (cp, sp), (cy, sy) = rpy
    o, i = ring.zero, ring.one
    yaw, pitch = Matrix(((cy, -sy, o), (sy, cy, o), (o, o, i))), Matrix(((cp, o, sp), (o, i, o), (-sp, o, cp)))
    return yaw @ pitch @ Matrix(((i, o, o), (o, cr, -sr), (o, sr, cr)))
