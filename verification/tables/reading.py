"""One reading of a DH table against an arm: which rows are right, which entries are wrong, what is left open."""

from __future__ import annotations

from dataclasses import replace
from functools import cached_property, reduce
from typing import Any

from armproof.models.exact.trace import trace_of
from armproof.verification.algebra.calculus import symbols_in
from armproof.verification.algebra.matrix import Matrix
from armproof.verification.algebra.ring import Scalar
from armproof.verification.errors import EvaluationError, UnboundName
from armproof.verification.findings import Finding, Kind, finding_of, say
from armproof.verification.tables.angles import angle_as_scalar, constant_angle, letter_of, symbols_of, to_radians
from armproof.verification.tables.cells import Cell
from armproof.verification.tables.claim import Claim, Row, RowVerdict
from armproof.verification.tables.columns import Reading
from armproof.verification.tables.frames import Frames
from armproof.verification.tables.row import ANGLES, PARAMETERS, SCALES, row_matrix


class TableReading:
    """A table read in one convention, with the parameters in given columns."""

    def __init__(self, claim: Claim, reading: Reading, given: list[RowVerdict] | None = None) -> None:
        self.claim, self.arm, self.rows = claim, claim.arm, claim.rows
        self.reading, self.convention = reading, reading.convention
        self._notes: dict[str, Finding] = {}  # what was taken for granted
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
    def notes(self) -> list[Finding]:
        """What was taken for granted."""
        return list(self._notes.values()) if self.verdicts else []

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

    def pose(self, frames: Frames) -> Matrix:
        """Return the arm's pose of a row's frame in the one before."""
        return self.claim.pose(frames.frame, frames.reference)

    def matrix(self, verdict: RowVerdict) -> Matrix:
        """Return the link matrix of a row as printed, all of whose entries have a value."""
        return row_matrix(self.claim.algebra, self.convention, *(verdict.values[parameter] for parameter in PARAMETERS))

    @cached_property
    def product(self) -> Matrix | None:
        """The product of all link matrices as printed, or None where an entry has no value."""
        if any(verdict.problems for verdict in self.verdicts):
            return None
        try:
            return reduce(Matrix.__matmul__, (self.matrix(verdict) for verdict in self.verdicts))
        except EvaluationError:
            return None

    def right_value(self, verdict: RowVerdict, parameter: str) -> Scalar | None:
        """Return what a parameter should be; an angle as ±variable + k·π/12, or None if it is nothing like that."""
        if verdict.right is None:
            return None
        right: Any = getattr(verdict.right, parameter)
        if parameter not in ANGLES:
            return right  # type: ignore[no-any-return]
        ring, arm = self.claim.algebra.ring, self.arm
        symbols = sorted(self._variables, key=lambda symbol: symbol != self.claim.joint_symbol(verdict.row))
        constants = [constant_angle(ring, name) for name in trace_of(arm).constants if name not in arm.angles]
        return angle_as_scalar(ring, right, [*(ring.symbol(symbol) for symbol in (*symbols, *arm.angles)), *constants])

    # -- one row -----------------------------------------------------------------------------------------------------

    def _judge(self, row: Row) -> RowVerdict:
        verdict = RowVerdict(row)
        if row.frames is not None:
            verdict.right = self.claim.right_row(row.frames, self.convention)
        for parameter in PARAMETERS:
            cell = row.cells[self.reading.columns[parameter]]
            try:
                values = self._values(parameter, verdict)
            except EvaluationError as problem:
                verdict.problems[parameter] = finding_of(problem)
                if isinstance(problem, UnboundName) and cell.name is not None:
                    verdict.unbound[parameter] = problem.name
                continue
            verdict.values[parameter] = values[0]
            if parameter in ANGLES and symbols_of(values[0]):  # a number beside a joint is where it stands
                values = values[:1]
            elif self.arm.dh is not None:  # its lengths are letters: a number beside one is its value
                values = values[:1]
                if (length := self._without_value(values[0], self.right_value(verdict, parameter))) is not None:
                    verdict.problems[parameter] = say(Kind.LENGTH_WITHOUT_VALUE, length=length)
                    continue
            if verdict.right is not None and not all(verdict.right.agrees(parameter, value) for value in values):
                verdict.wrong.append(parameter)
        return verdict

    def _without_value(self, printed: Scalar, right: Scalar | None) -> str | None:
        """Return the letter with which a printed number cannot be compared."""
        number = printed.as_fraction()
        letters = symbols_of(right) & set(self.arm.lengths) if number and right is not None else set()
        return min(letters) if number and letters else None

    def _values(self, parameter: str, verdict: RowVerdict) -> list[Scalar]:
        column = self.reading.columns[parameter]
        cell = verdict.row.cells[column]
        if cell.kind == "blank":
            if (empty := next((row for row in self.rows if row.is_empty), None)) is not None:
                raise EvaluationError(say(Kind.EMPTY_ROW, number=empty.number))
            self._note(say(Kind.EMPTY_AS_ZERO))
            return [self.claim.algebra.ring.zero]
        if cell.kind == "variable":
            return [self._variable(parameter, cell, verdict)]
        unit = self.claim.columns.headers[column].unit
        values = self.claim.values(verdict.row, column)
        if parameter not in ANGLES:
            scale = 1 if cell.has_unit else SCALES.get(unit, 1)
            return [v * scale if v.as_fraction() is not None else v for v in values]
        read = [to_radians(value, unit) for value in values]
        for _, note in read:
            if note is not None:
                self._note(note)
        return [value for value, _ in read]

    def _note(self, note: Finding) -> None:
        self._notes.setdefault(repr(note), note)

    def _variable(self, parameter: str, cell: Cell, verdict: RowVerdict) -> Scalar:
        """The value of a cell that only says that it is the variable: its offset is taken to be right."""
        own = self.claim.joint_symbol(verdict.row)
        if own is None:
            raise EvaluationError(say(Kind.VARIABLE_WITHOUT_JOINT, cell=cell.text))
        right = self.right_value(verdict, parameter)
        return self.claim.algebra.symbol(own) if right is None or own not in symbols_in([right]) else right

    def _judge_unbound(self, verdicts: list[RowVerdict]) -> None:
        """A lone unbound name is wrong where it cannot be the document's letter for what should stand there.

        It cannot where a number should stand, where another index of the arm's own letter should, and where one name
        would have to mean two things.
        """
        meanings: dict[str, Scalar] = {}
        for verdict in verdicts:
            for parameter, name in verdict.unbound.items():
                right = self.right_value(verdict, parameter)
                if right is None:
                    continue
                letters = {letter_of(symbol) for symbol in symbols_of(right)}
                if (
                    not letters
                    or letter_of(name) in letters
                    or not (right - meanings.setdefault(name, right)).is_zero()
                ):
                    verdict.wrong.append(parameter)
