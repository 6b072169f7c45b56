"""One reading of a DH table against an arm: which rows are right, which entries are wrong, what is left open."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

from models.arm import Arm
from verification.algebras import ExactAlgebra
from verification.tables.row import (
    ANGLES,
    PARAMETERS,
    SCALES,
    RightRow,
    angle_as_scalar,
    constant_angle,
    is_free_of,
    right_row,
    row_matrix,
    to_radians,
)
from verification.errors import EvaluationError, UnboundName
from verification.matrix import Matrix
from verification.names import Names
from verification.quantities import Quantity
from verification.tables.cells import Cell, Frames, cell_values, unbound_name
from verification.tables.columns import Columns, Reading
from verification.tables.words import letter_of
from verification.trig import Scalar


@dataclass(frozen=True)
class Row:
    """A row of the body: its number from 1, its frames (None: the arm has none for it), its cells by column."""

    number: int
    frames: Frames | None
    cells: Mapping[int, Cell]


@dataclass
class RowVerdict:
    """What became of a row. `values` are the printed ones, `right` what the frames call for (None: no DH frames)."""

    row: Row
    right: RightRow | None = None
    values: dict[str, Scalar] = field(default_factory=dict)
    wrong: list[str] = field(default_factory=list)
    problems: dict[str, str] = field(default_factory=dict)  # parameter → why it has no value
    unbound: dict[str, str] = field(default_factory=dict)  # parameter → the one name that the cell consists of

    @property
    def holds(self) -> bool:
        """Whether the row is the one that the frames call for."""
        if self.row.frames is None:
            return self.is_identity
        return self.right is not None and not self.wrong and not self.problems

    @property
    def is_identity(self) -> bool:
        """Whether nothing but zeros stands in the row."""
        return len(self.values) == len(PARAMETERS) and all(value.is_zero() for value in self.values.values())


@dataclass(frozen=True)
class Claim:
    """A table's claim about an arm. `lengths`: values for the arm's lengths, where the table gives them in numbers."""

    names: Names
    arm: Arm
    algebra: ExactAlgebra
    columns: Columns
    rows: tuple[Row, ...]
    lengths: Mapping[str, Scalar] = field(default_factory=dict)
    notes: dict[str, None] = field(default_factory=dict)  # what was taken for granted

    def pose(self, frame: str, reference: str) -> Matrix:
        """Return the arm's pose {}^{reference}T_{frame}."""
        pose: Matrix = self.algebra.quantity(Quantity("pose", frame, reference))
        return self.algebra.substitute(pose, self.lengths) if self.lengths else pose


class TableReading:
    """A table read in one convention, with the parameters in given columns."""

    def __init__(self, claim: Claim, reading: Reading, given: list[RowVerdict] | None = None) -> None:
        self.claim = claim
        self.arm = claim.arm
        self.rows = claim.rows
        self.reading = reading
        self.convention = reading.convention
        self._notes: dict[str, None] = {}
        self._given = given
        self._variables = [joint.symbol for joint in claim.arm.joints]

    def but(self, **changes: Any) -> TableReading:
        """Return the reading with another convention, or with parameters in other columns."""
        return TableReading(self.claim, replace(self.reading, **changes))

    def mended(self, verdict: RowVerdict, parameter: str, value: Scalar) -> TableReading:
        """Return the reading with another value of one entry."""
        other = replace(verdict, values={**verdict.values, parameter: value})
        return TableReading(self.claim, self.reading, [other if one is verdict else one for one in self.verdicts])

    @property
    def otherwise(self) -> TableReading:
        """The reading in the other convention."""
        return self.but(convention="classic" if self.convention == "modified" else "modified")

    @cached_property
    def verdicts(self) -> list[RowVerdict]:
        """The verdict of each row, in order."""
        if self._given is not None:
            return self._given
        found = [self._judge(row) for row in self.rows]
        self._judge_unbound(found)
        return found

    @property
    def notes(self) -> list[str]:
        """What was taken for granted."""
        return list(dict.fromkeys([*self.claim.notes, *self._notes])) if self.verdicts else []

    @property
    def score(self) -> int:
        """How many rows hold."""
        return sum(verdict.holds for verdict in self.verdicts)

    @property
    def is_right(self) -> bool:
        """Whether all rows hold."""
        return self.score == len(self.rows)

    @property
    def fits_frames(self) -> bool:
        """Whether the arm's frames are DH frames of this convention, at all rows that have frames."""
        return all(verdict.right is not None for verdict in self.verdicts if verdict.row.frames is not None)

    @property
    def wrong(self) -> list[RowVerdict]:
        """The rows with a wrong entry."""
        return [verdict for verdict in self.verdicts if verdict.wrong]

    def joint_symbol(self, row: Row) -> str | None:
        """Return the variable of a row's joint."""
        joint = row.frames.joint if row.frames is not None else None
        return self.arm.joints[joint - 1].symbol if joint is not None else None

    def pose(self, frames: Frames) -> Matrix:
        """Return the arm's pose of a row's frame in the one before."""
        return self.claim.pose(frames.frame, frames.reference)

    def matrix(self, verdict: RowVerdict) -> Matrix:
        """Return the link matrix of the row as printed; raises EvaluationError where an entry has no value."""
        if verdict.problems:
            raise EvaluationError(next(iter(verdict.problems.values())))
        return row_matrix(self.claim.algebra, self.convention, *(verdict.values[parameter] for parameter in PARAMETERS))

    @cached_property
    def product(self) -> Matrix | None:
        """The product of all link matrices as printed, or None where an entry has no value."""
        total: Matrix | None = None
        try:
            for verdict in self.verdicts:
                total = self.matrix(verdict) if total is None else total @ self.matrix(verdict)
        except EvaluationError:
            return None
        return total

    def right_value(self, verdict: RowVerdict, parameter: str) -> Scalar | None:
        """Return what a parameter should be; an angle as ±variable + k·π/12, or None if it is nothing like that."""
        if verdict.right is None:
            return None
        right: Any = getattr(verdict.right, parameter)
        if parameter not in ANGLES:
            return right  # type: ignore[no-any-return]
        ring = self.claim.algebra.ring
        own = self.joint_symbol(verdict.row)
        symbols = [*([own] if own else []), *(s for s in self._variables if s != own), *self.arm.angles]
        constants = [constant_angle(ring, name) for name in self.arm.trace.constants if name not in self.arm.angles]
        return angle_as_scalar(ring, right, symbols, constants)

    # -- one row -----------------------------------------------------------------------------------------------------

    def _judge(self, row: Row) -> RowVerdict:
        verdict = RowVerdict(row)
        if row.frames is not None:
            verdict.right = right_row(self.pose(row.frames), self.convention, self._variables)
        for parameter in PARAMETERS:
            column = self.reading.columns[parameter]
            cell = row.cells[column] if column is not None else Cell("", kind="blank")
            try:
                values = self._values(parameter, column, cell, verdict)
            except EvaluationError as problem:
                verdict.problems[parameter] = str(problem)
                if isinstance(problem, UnboundName) and (
                    name := unbound_name(self.claim.names, self.claim.algebra, cell)
                ):
                    verdict.unbound[parameter] = name
                continue
            verdict.values[parameter] = values[0]
            if verdict.right is not None and not all(verdict.right.agrees(parameter, value) for value in values):
                verdict.wrong.append(parameter)
        return verdict

    def _values(self, parameter: str, column: int | None, cell: Cell, verdict: RowVerdict) -> list[Scalar]:
        zero = self.claim.algebra.ring.zero
        if cell.kind == "blank":
            if column is not None:
                self._notes["an empty entry is read as 0"] = None
            return [zero]
        if cell.kind == "variable":
            own = self.joint_symbol(verdict.row)
            if own is None:
                raise EvaluationError(f"'{cell.text}' names the variable of a row that has no joint")
            variable = self.claim.algebra.symbol(own)
            right = self.right_value(verdict, parameter)
            return [variable if right is None or is_free_of(right, [own]) else right]
        assert column is not None
        unit = self.claim.columns.headers[column].unit
        values = list(cell_values(self.claim.names, self.claim.algebra, cell))
        if self.claim.lengths:
            values = [self.claim.algebra.substitute(value, self.claim.lengths) for value in values]
        if parameter not in ANGLES:
            scale = SCALES.get(unit)
            return [
                v * self.claim.algebra.rational(scale) if scale and v.as_fraction() is not None else v for v in values
            ]
        read = [to_radians(value, unit) for value in values]
        self._notes.update(dict.fromkeys(note for _, note in read if note))
        return [value for value, _ in read]

    def _judge_unbound(self, verdicts: list[RowVerdict]) -> None:
        """A lone unbound name is wrong where it cannot be the document's letter for what should stand there.

        It cannot where a number should stand, where another index of the arm's own letter should, and where one name
        would have to mean two things.
        """
        meanings: dict[str, list[Any]] = {}
        for verdict in verdicts:
            for parameter, name in verdict.unbound.items():
                right = self.right_value(verdict, parameter)
                if right is None:
                    continue
                known = [n for powers, _ in right.ring.terms(right.numerator) for kind, n in powers if kind == "symbol"]
                others = meanings.setdefault(name, [])
                clash = any(not (right - other).is_zero() for other in others)
                others.append(right)
                if not known or clash or letter_of(known[0]) == letter_of(name):
                    verdict.wrong.append(parameter)
