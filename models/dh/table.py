"""DH tables, classic and modified: validated rows, and the MultibodyPlant that is built from them.

Classic:  A_i = Rz(θ_i) Tz(d_i) Tx(a_i) Rx(α_i), the transform {}^{i-1}T_i.
Modified: A_i = Rx(α_{i-1}) Tx(a_{i-1}) Rz(θ_i) Tz(d_i), the transform {}^{i-1}T_i (Craig; row i holds a and α of i−1).

A row may have no joint: a fixed step between two, the pose of the base before them or of the tool behind.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import pi
from typing import Any, Literal

from armproof.models.dh.entry import FORMS, LinearForm, as_typed, read_entry
from armproof.models.dh.pose import FixedPose, read_pose, write_pose
from armproof.models.errors import Fault, ModelError

KEYS = ("dh", "rows", "joints", "first", "frames", "base", "tool")
COLUMNS = ("a", "alpha", "d", "theta")
_ANGLES = ("alpha", "theta")
_MOST_TIMES = 4
_REVOLUTE_NAME = re.compile(r"(theta|q)_?\d+'*$")
_FRAME = re.compile(r"[A-Za-z0-9]+")
_PRISMATIC_NAME = re.compile(r"(d|q)_?\d+'*$")


@dataclass(frozen=True)
class DHRow:
    """One row of a DH table: a and d in metres, alpha and theta in radians.

    Attributes:
        joint: the joint variable, in theta (revolute) or d (prismatic); "" where nothing moves.
        kind: revolute, prismatic or fixed.
        sign: the sign, ±1, of the joint variable in its entry.
    """

    a: LinearForm
    alpha: LinearForm
    d: LinearForm
    theta: LinearForm
    joint: str
    kind: Literal["revolute", "prismatic", "fixed"]
    sign: int


@dataclass(frozen=True)
class DHTable:
    """A DH table: its convention, its rows from base to tool, the poses of base and tool beside them, all frames by name."""

    convention: Literal["classic", "modified"]
    rows: tuple[DHRow, ...]
    frames: tuple[str, ...]
    base: FixedPose | None = None
    tool: FixedPose | None = None

    @property
    def joint_rows(self) -> tuple[DHRow, ...]:
        """The rows with a joint."""
        return tuple(row for row in self.rows if row.joint)

    @property
    def has_fixed(self) -> bool:
        """Whether there are more steps from frame to frame than joints."""
        return len(self.frames) > len(self.joint_rows) + 1

    @property
    def length_symbols(self) -> tuple[str, ...]:
        """The symbols in lengths that are not joint variables, in order of appearance."""
        return self._symbols("a", "d", "xyz")

    @property
    def angle_symbols(self) -> tuple[str, ...]:
        """The symbols in angles that are not joint variables, in order of appearance."""
        return self._symbols("alpha", "theta", "rpy")

    def _symbols(self, *parts: str) -> tuple[str, ...]:
        joints = {row.joint for row in self.rows}
        steps = [step for step in (self.base, *self.rows, self.tool) if step is not None]
        found = [getattr(step, part) for step in steps for part in parts if hasattr(step, part)]
        forms = (form for each in found for form in (each if isinstance(each, tuple) else (each,)))
        return tuple(dict.fromkeys(symbol for form in forms for symbol, _ in form.symbols if symbol not in joints))


def read_table(spec: Mapping[str, Any]) -> DHTable:
    """Read a DH table {dh: classic | modified, rows: [{a, alpha, d, theta}, ...], joints: [...], first: 0}.

    Without `joints`, the variable of a row is the symbol in its theta that looks like a joint (theta_i, q_i), else the
    symbol in its d. Where `joints` are fewer than the rows, those that hold none of them are fixed. `base` and `tool` are
    fixed poses before and behind the rows; `frames` names all frames, else they are numbered from `first`, between B and E.

    Raises:
        ModelError: an unknown key or convention, a bad row or entry, a joint variable in no row or in two.
    """
    for key in spec:
        if key not in KEYS:
            raise ModelError(Fault.UNKNOWN_TABLE_KEY, key=key, keys=list(KEYS))
    convention = spec.get("dh")
    if convention not in ("classic", "modified"):
        raise ModelError(Fault.NO_CONVENTION, given=repr(convention))
    raw = spec.get("rows")
    if not isinstance(raw, Sequence) or isinstance(raw, str) or not raw:
        raise ModelError(Fault.NO_ROWS, given=repr(raw))
    entries = [_read_row(number, row) for number, row in enumerate(raw, start=1)]
    joints = _read_joints(spec.get("joints"), entries)
    rows = tuple(_make_row(number, row, joints) for number, row in enumerate(entries, start=1))
    base, tool = (read_pose(key, spec.get(key)) for key in ("base", "tool"))
    table = DHTable(convention, rows, _read_frames(spec, len(rows)), base, tool)
    both = set(table.length_symbols) & set(table.angle_symbols)
    if both:
        raise ModelError(Fault.LENGTH_AND_ANGLE, symbol=min(both))
    return table


def write_table(table: DHTable) -> dict[str, Any]:
    """Return the mapping that `read_table` reads as this table."""
    rows = [{column: str(getattr(row, column)) for column in COLUMNS} for row in table.rows]
    poses = {key: write_pose(pose) for key, pose in (("base", table.base), ("tool", table.tool)) if pose is not None}
    joints = [row.joint for row in table.joint_rows]
    return {"dh": table.convention, "rows": rows, "joints": joints, "frames": list(table.frames), **poses}


def _read_joints(given: object, rows: Sequence[Mapping[str, LinearForm]]) -> list[str]:
    """Return the joint variable of each row, "" for one without."""
    if given is None:
        return [_guess_joint(number, row) for number, row in enumerate(rows, start=1)]
    if not isinstance(given, Sequence) or isinstance(given, str) or not all(isinstance(joint, str) for joint in given):
        raise ModelError(Fault.NO_JOINTS, given=repr(given))
    joints = [as_typed(joint).strip() for joint in given]
    if len(joints) == len(rows):
        return joints
    left = list(joints)
    found = [left.pop(0) if left and _columns_with(row, left[0]) else "" for row in rows]
    unnamed = [row for row, joint in zip(rows, found, strict=True) if not joint and _turns(row)]
    if left or unnamed or not joints:
        raise ModelError(Fault.ROWS_AND_JOINTS, rows=len(rows), count=len(joints), joints=joints)
    return found


def _turns(row: Mapping[str, LinearForm]) -> list[str]:
    """Return the symbols in a row's theta that look like joint variables."""
    return [symbol for symbol, _ in row["theta"].symbols if _REVOLUTE_NAME.match(symbol)]


def _read_frames(spec: Mapping[str, Any], rows: int) -> tuple[str, ...]:
    first, given = spec.get("first", 0), spec.get("frames")
    if not isinstance(first, int) or isinstance(first, bool) or first < 0:
        raise ModelError(Fault.NO_FIRST_FRAME, given=repr(first))
    outer = [[name] if spec.get(key) is not None else [] for key, name in (("base", "B"), ("tool", "E"))]
    numbered = (*outer[0], *map(str, range(first, first + rows + 1)), *outer[1])
    if given is None:
        return numbered
    names = tuple(map(str, given)) if isinstance(given, list | tuple) else ()
    if len(set(names)) != len(numbered) or not all(_FRAME.fullmatch(name) for name in names):
        raise ModelError(Fault.FRAME_NAMES, count=len(numbered), given=repr(given))
    return names


def _read_row(number: int, row: object) -> dict[str, LinearForm]:
    if not isinstance(row, Mapping) or set(row) != set(COLUMNS):
        given = ", ".join(map(str, row)) or "none" if isinstance(row, Mapping) else repr(row)
        raise ModelError(Fault.ROW_KEYS, number=number, keys=list(COLUMNS), given=given)
    entries = {}
    for column in COLUMNS:
        try:
            entries[column] = read_entry(row[column])
        except ModelError as error:
            raise ModelError(Fault.IN_TABLE, number=number, column=column, reason=error) from None
        _check_unit(number, column, row[column], entries[column])
    return entries


def _check_unit(number: int, column: str, text: object, form: LinearForm) -> None:
    """Refuse an angle where a length stands, and an angle that must have been meant otherwise."""
    if column not in _ANGLES:
        if form.pi:
            raise ModelError(Fault.ANGLE_AS_LENGTH, number=number, column=column, text=text)
        return
    radians = float(form.number)
    if abs(radians) > 2 * pi:
        raise ModelError(Fault.MORE_THAN_A_TURN, number=number, column=column, text=text, degrees=form.number)
    quarters = round(radians / (pi / 4))
    if quarters and form.number and abs(radians - quarters * pi / 4) < 2e-3:
        multiple = Fraction(quarters, 4)
        name = f"{multiple.numerator}*pi/{multiple.denominator}".replace("1*pi", "pi").removesuffix("/1")
        raise ModelError(Fault.NEARLY, number=number, column=column, text=text, multiple=name)


def _guess_joint(number: int, row: Mapping[str, LinearForm]) -> str:
    """Return the joint variable of a row: what looks like one in theta, else the symbol in d."""
    named = _turns(row)
    if not named:
        in_d = [symbol for symbol, _ in row["d"].symbols]
        named = in_d if len(in_d) == 1 else [symbol for symbol in in_d if _PRISMATIC_NAME.match(symbol)]
    if len(named) != 1:
        raise ModelError(
            Fault.JOINT_UNCLEAR if named else Fault.JOINT_NOWHERE, number=number, joints=" or ".join(named)
        )
    return named[0]


def _make_row(number: int, row: Mapping[str, LinearForm], joints: Sequence[str]) -> DHRow:
    joint = joints[number - 1]
    _check_one_row_a_joint(number, row, joints)
    if not joint:
        _check_factors(number, row)
        return DHRow(**row, joint="", kind="fixed", sign=0)
    column = _joint_column(number, row, joint)
    coefficient = row[column].coefficient(joint)
    if abs(coefficient) != 1:
        raise ModelError(Fault.JOINT_FACTOR, number=number, joint=joint, factor=coefficient)
    _check_factors(number, row)
    return DHRow(**row, joint=joint, kind="revolute" if column == "theta" else "prismatic", sign=int(coefficient))


def _check_one_row_a_joint(number: int, row: Mapping[str, LinearForm], joints: Sequence[str]) -> None:
    """Refuse a row that holds the joint variable of another one, or has that of an earlier one for its own."""
    joint = joints[number - 1]
    for symbol in dict.fromkeys(joints):
        columns = _columns_with(row, symbol)
        if symbol != joint and columns:
            raise ModelError(
                Fault.JOINT_OF_ANOTHER_ROW,
                number=number,
                column=columns[0],
                symbol=symbol,
                other=joints.index(symbol) + 1,
            )
    if joint and joints.index(joint) != number - 1:
        raise ModelError(Fault.JOINT_TAKEN, number=number, joint=joint, other=joints.index(joint) + 1)


def _joint_column(number: int, row: Mapping[str, LinearForm], joint: str) -> str:
    """Return the column, theta or d, that holds the joint variable of a row."""
    columns = _columns_with(row, joint)
    if columns not in (["theta"], ["d"]):
        kind = Fault.JOINT_ELSEWHERE if columns else Fault.JOINT_NOT_IN_ROW
        raise ModelError(kind, number=number, joint=joint, columns=" and ".join(columns))
    return columns[0]


def _check_factors(number: int, row: Mapping[str, LinearForm]) -> None:
    """Refuse an angle that is not a sum of a few whole multiples of its symbols."""
    for column in _ANGLES:
        for symbol, factor in row[column].symbols:
            if factor.denominator != 1 or abs(factor) > _MOST_TIMES:
                raise ModelError(
                    Fault.ANGLE_FACTOR,
                    number=number,
                    column=column,
                    symbol=symbol,
                    factor=factor,
                    most=_MOST_TIMES,
                    forms=FORMS,
                )


def _columns_with(row: Mapping[str, LinearForm], symbol: str) -> list[str]:
    return [column for column in COLUMNS if row[column].coefficient(symbol)]
