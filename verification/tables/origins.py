"""Tables of joint origins are claims: x, y, z, roll, pitch, yaw, links, type and axis of each joint, as in a URDF."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction

from armproof.models.exact.numbers import exact_number
from armproof.models.exact.polynomial import generators
from armproof.models.loading.origins import JointOrigin, joint_origins
from armproof.verification.algebra.angles import cos_sin
from armproof.verification.algebra.ring import Ring, Scalar
from armproof.verification.document import Table
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.errors import EvaluationError
from armproof.verification.findings import Finding, Kind, finding_of, say
from armproof.verification.latex import nodes as n
from armproof.verification.tables.angles import (
    Angle,
    angle_as_scalar,
    change_of_angle,
    change_of_length,
    constant_angle,
    roll_pitch_yaw,
    to_radians,
)
from armproof.verification.tables.cells import Cell, Notation, UnreadableCell, read_axis, read_cell, read_kind
from armproof.verification.tables.columns import RPY, XYZ, origin_columns, read_header, spelt_name
from armproof.verification.tables.row import SCALES, equal
from armproof.verification.verdict import Record, Verdict, WrongEntry


def check_origins(checker: ChainChecker, table: Table, unchecked: Record) -> Record | None:
    """Return the record of a table of joint origins, or None where it is none: most rows must name joints of the arm."""
    columns = origin_columns(table.header)
    if columns is None or checker.names.arm is None:
        return None
    origins = joint_origins(checker.names.arm)
    named = [_find_joint(origins, row[columns["joint"]]) is not None for row in table.rows]
    if 2 * sum(named) <= len(named):
        return None
    return _OriginTable(checker, table, columns, origins).record(unchecked)


def _find_joint(origins: Mapping[str, JointOrigin], name: str, child: str = "") -> str | None:
    """Return the joint of that name, or else the one with that child link."""
    by_name = (joint for joint in origins if spelt_name(joint) == spelt_name(name))
    by_child = (joint for joint, origin in origins.items() if spelt_name(origin.child) == spelt_name(child))
    return next(by_name, next(by_child, None))


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
        self.problems: list[Finding] = []
        self.notes: dict[str, Finding] = {}
        self.rows = [row for number, texts in enumerate(table.rows, 1) if (row := self._row(number, texts))]
        self.cells = {
            (row.number, role): self._cell(row, role) for row in self.rows for role in (*XYZ, *RPY) if role in columns
        }
        self.has_letters = any(cell.has_letters for (_, role), cell in self.cells.items() if role in XYZ)
        self.notation = Notation(self.names, self.cells.values())

    def record(self, unchecked: Record) -> Record:
        """Return the record of the table."""
        entries = [entry for row in self.rows for entry in self._wrong_entries(row)]
        without = [name for name in self.origins if name not in {row.joint for row in self.rows}]
        said = [_wrong(entry) for entry in entries]
        said += [*self.problems, *self.notes.values()]
        said += [say(Kind.NO_ROW_FOR, joints=without)] if without else []
        if entries or self.problems:
            verdict = Verdict.REFUTED if entries else Verdict.UNCHECKED
            return replace(unchecked, verdict=verdict, findings=tuple(said), entries=tuple(entries))
        holds = say(Kind.ORIGINS, count=len(self.rows))
        return replace(unchecked, verdict=Verdict.PROVED, findings=(holds, *said))

    # -- reading -----------------------------------------------------------------------------------------------------

    def _row(self, number: int, cells: tuple[str, ...]) -> _Row | None:
        texts = {role: cells[column] for role, column in self.columns.items()}
        joint = _find_joint(self.origins, texts["joint"], texts.get("child", ""))
        if joint is None:
            unknown = say(Kind.NO_SUCH_JOINT, number=number, name=texts["joint"], joints=list(self.origins))
            self.problems.append(unknown)
            return None
        return _Row(number, texts, joint, self.origins[joint])

    def _cell(self, row: _Row, role: str) -> Cell:
        cell = read_cell(self.names, row.texts[role], row.number, self.columns[role])
        if cell.kind == "variable":
            place = {"row": row.number, "column": self.columns[role] + 1}
            raise UnreadableCell(say(Kind.NO_COORDINATE, **place, cell=cell.text))
        return replace(cell, trees=(n.Number(Fraction(0), "0"),)) if cell.kind == "blank" else cell

    # -- comparing ---------------------------------------------------------------------------------------------------

    def _wrong_entries(self, row: _Row) -> Iterator[WrongEntry]:
        """Yield the wrong cells of a row, in the order of the columns."""
        roles = set(self.columns) - (set(RPY) if self._same_rotation(row) else set())
        for role in sorted(roles, key=self.columns.__getitem__):
            try:
                wrong = self._judge(row, role)
            except EvaluationError as problem:
                self.problems.append(say(Kind.ROW_OPEN, number=row.number, parameter=role, problem=finding_of(problem)))
            else:
                if wrong is not None:
                    yield WrongEntry(1, row.number, self.columns[role] + 1, row.texts[role].strip(), *wrong)

    def _judge(self, row: _Row, role: str) -> tuple[str, Finding] | None:
        """Return the correct entry and what is wrong with the printed one, or None where it is right."""
        origin, printed = row.origin, spelt_name(row.texts[role])
        if role in XYZ:
            return self._length(row, role)
        if role in RPY:
            return self._angle(row, role)
        if role == "axis":
            if origin.axis is None or _is_axis(origin.axis, read_axis(row.texts[role])):
                return None
            return " ".join(f"{part:g}" for part in origin.axis), say(Kind.THE_AXIS)
        if role == "type":
            is_right = read_kind(row.texts[role]) == origin.kind
            return None if is_right else (origin.kind, say(Kind.JOINT_IS, joint_kind=origin.kind))
        names = {"joint": (row.joint, Kind.THE_NAME), "parent": (origin.parent, Kind.THE_PARENT)}
        name, what = names.get(role, (origin.child, Kind.THE_CHILD))
        return None if printed == spelt_name(name) else (name, say(what))

    def _length(self, row: _Row, role: str) -> tuple[str, Finding] | None:
        """Compare a coordinate: symbols with the symbol of the place, numbers with its number."""
        symbol = self.ring.from_entry(row.origin.xyz[XYZ.index(role)])
        number = self.algebra.substitute(symbol, self.lengths)
        scale = SCALES.get(self.units[role], 1)
        rights, changes = [], []
        values = self._values(row, role)
        for value in values:
            is_number = value.as_fraction() is not None
            printed, right = (value * scale, number) if is_number else (value, symbol)
            in_numbers = is_number and (len(values) > 1 or not self.has_letters)
            rights.append(self.notation.value(number / scale if in_numbers else symbol))
            if not (printed - right).is_zero():
                changes.append(change_of_length(printed, right) or say(Kind.ANOTHER_LENGTH))
        return (" = ".join(rights), changes[0]) if changes else None

    def _angle(self, row: _Row, role: str) -> tuple[str, Finding] | None:
        entries = row.origin.rpy[RPY.index(role)]
        cosine, sine = self._right_angle(row, role)
        for value in self._values(row, role):
            printed = cos_sin(value)
            if (printed[0] - cosine).is_zero() and (printed[1] - sine).is_zero():
                continue
            constants = [constant_angle(self.ring, name) for kind, name in generators(entries) if kind == "cos"]
            right = angle_as_scalar(self.ring, (cosine, sine), constants)
            if right is None:
                return "another angle", say(Kind.THE_ANGLE)
            degrees = "" if self.units[role] == "deg" else None
            return self.notation.value(right, degrees), change_of_angle(value, right) or say(Kind.ANOTHER_ANGLE)
        return None

    def _right_angle(self, row: _Row, role: str) -> Angle:
        cosine, sine = row.origin.rpy[RPY.index(role)]
        return self.ring.from_entry(cosine), self.ring.from_entry(sine)

    def _same_rotation(self, row: _Row) -> bool:
        """Whether the three angles make the joint's rotation: they need not be its own three (pitch ± π/2)."""
        if not set(RPY) <= self.columns.keys():
            return False
        try:
            values = [self._values(row, role) for role in RPY]
            printed = [cos_sin(value) for value, *_ in values]
        except EvaluationError:
            return False
        right = [self._right_angle(row, role) for role in RPY]
        return all(len(value) == 1 for value in values) and equal(roll_pitch_yaw(*printed), roll_pitch_yaw(*right))

    def _values(self, row: _Row, role: str) -> list[Scalar]:
        values = self.cells[row.number, role].values(self.names, self.algebra)
        if role in XYZ:
            return values
        read = [to_radians(value, self.units[role]) for value in values]
        self.notes |= {repr(note): note for _, note in read if note is not None}
        return [value for value, _ in read]


def _wrong(entry: WrongEntry) -> Finding:
    """Return a wrong cell with what it should be, and why."""
    terms = {"printed": entry.printed or say(Kind.EMPTY), "correct": entry.correct, "change": entry.finding}
    return say(Kind.WRONG_ORIGIN, **terms).at(row=entry.row, column=entry.column)


def _is_axis(axis: Sequence[float], printed: Sequence[float]) -> bool:
    return all(abs(a - b) <= 1e-9 for a, b in zip(axis, printed, strict=True))
