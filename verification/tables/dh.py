"""DH tables are claims: each row is checked against the frames of the arm."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import suppress
from dataclasses import replace

from armproof.models.arm import Arm
from armproof.models.exact.numbers import exact_number
from armproof.verification.document import Table
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.errors import NotSampled
from armproof.verification.findings import Finding, Kind, say
from armproof.verification.tables.beyond import check_beyond_frames
from armproof.verification.tables.cells import Cell, UnreadableCell, read_cell
from armproof.verification.tables.claim import Claim, Row
from armproof.verification.tables.columns import CONVENTIONS, Columns
from armproof.verification.tables.entries import WrongEntries
from armproof.verification.tables.faults import fault_of_table, letter
from armproof.verification.tables.frames import row_frames
from armproof.verification.tables.reading import TableReading
from armproof.verification.verdict import Record, Verdict

MOST_WORDS = 6  # wrong entries spelt out in a message; all are listed


class DHTableCheck:
    """Checks one DH table. `unchecked` is the record to fill in."""

    def __init__(self, checker: ChainChecker, table: Table, columns: Columns, unchecked: Record) -> None:
        self.checker, self.names = checker, checker.names
        self.table, self.columns = table, columns
        self.unchecked = unchecked
        self.notes: list[Finding] = []

    def record(self) -> Record:
        """Return the record of the table; raises UnreadableCell, EvaluationError."""
        cells = self._cells()
        if self._is_general(cells):
            return replace(self.unchecked, verdict=Verdict.DEFINED, findings=(say(Kind.GENERAL_LINK),))
        if self.names.arm is None:
            return replace(self.unchecked, findings=(say(Kind.NO_ARM_FOR_TABLE),))
        if not cells:
            return replace(self.unchecked, findings=(say(Kind.NO_ROWS),))
        found = self._find_reading(self.names.arm, cells)
        if not found.is_right and not any(r.fits_frames for r in self._readings(found.claim, CONVENTIONS)):
            wrong = WrongEntries(found, self.table.rows)
            left_open = [*self._left_open(found, wrong), *self._remarks(found)]
            return check_beyond_frames(self.checker, found, wrong, self.unchecked, left_open)
        return self._judge(found)

    # -- the body ----------------------------------------------------------------------------------------------------

    def _cells(self) -> list[Mapping[int, Cell]]:
        """Read the entries of the columns that hold parameters, and of the one that names the variables."""
        parameters = {self.columns.alpha, self.columns.theta, *(k for pair in self.columns.lengths for k in pair)}
        variable = self.columns.first("q")
        rows: list[Mapping[int, Cell]] = []
        for number, texts in enumerate(self.table.rows, start=1):
            if len(texts) != len(self.table.header):
                width = len(self.table.header)
                raise UnreadableCell(say(Kind.ROW_LENGTH, number=number, count=len(texts), width=width))
            row = {column: read_cell(self.names, texts[column], number, column) for column in sorted(parameters)}
            if variable is not None and variable not in row:
                with suppress(UnreadableCell):
                    row[variable] = read_cell(self.names, texts[variable], number, variable)
            rows.append(row)
        return rows

    def _is_general(self, cells: list[Mapping[int, Cell]]) -> bool:
        """Whether the rows only give names to the parameters of any link: a_i, α_i, d_i, θ_i."""
        names = [cell.name for row in cells for cell in row.values()]
        indices = {name.sub.rpartition("-")[0] or name.sub for name in names if name is not None}
        return bool(names) and None not in names and (self.names.arm is None or indices <= set("ijkn"))

    # -- the reading -------------------------------------------------------------------------------------------------

    def _find_reading(self, arm: Arm, cells: list[Mapping[int, Cell]]) -> TableReading:
        label = self.columns.first("label")
        labels = [texts[label] for texts in self.table.rows] if label is not None else []
        frames, passed_over = row_frames(self.names, arm, labels, len(cells))
        rows = tuple(Row(number, frames[number - 1], row) for number, row in enumerate(cells, start=1))
        claim = Claim(self.names, arm, self.checker.exact, self.columns, rows)
        found = self._best(claim)
        if passed_over:
            self.notes.append(say(Kind.ROWS_IN_ORDER))
        if not found.is_right and arm.dh is None and self._has_lengths_in_numbers(rows):
            rational = self.checker.exact.rational
            lengths = {symbol: rational(exact_number(value)) for symbol, value in arm.lengths.items()}
            measured = self._best(replace(claim, lengths=lengths))
            if measured.score > found.score or not found.fits_frames:
                self.notes.append(say(Kind.LENGTHS_IN_NUMBERS))
                return measured
        return found

    def _has_lengths_in_numbers(self, rows: tuple[Row, ...]) -> bool:
        cells = [row.cells[column] for row in rows for pair in self.columns.lengths for column in pair]
        return any(cell.trees and not cell.has_letters and any(c in "123456789" for c in cell.text) for cell in cells)

    def _readings(self, claim: Claim, conventions: tuple[str, ...]) -> list[TableReading]:
        return [TableReading(claim, reading) for reading in self.columns.readings(conventions)]

    def _best(self, claim: Claim) -> TableReading:
        """Return the reading that the headers state; where they leave it open, the one under which most rows hold.

        The headers are overruled where more rows hold in the other convention, and where the arm's frames are DH frames
        of the other one only.
        """
        by_arm = claim.arm.dh.convention if claim.arm.dh else "classic"
        likely = self.columns.stated or ("modified" if self.columns.is_khalil else by_arm)
        readings = self._readings(claim, tuple(sorted(CONVENTIONS, key=lambda convention: convention != likely)))
        best = max(readings, key=lambda one: (one.score, one.fits_frames))  # the first of the best
        as_stated = max((one for one in readings if one.convention == likely), key=lambda one: one.score)
        overruled = best.score > as_stated.score or (best.fits_frames and not as_stated.fits_frames)
        return best if overruled or not self.columns.stated else as_stated

    # -- the verdict -------------------------------------------------------------------------------------------------

    def _judge(self, found: TableReading) -> Record:
        wrong = WrongEntries(found, self.table.rows)
        whole = fault_of_table(found)
        single = [*([] if whole and whole.is_all else wrong.of_rows()), *wrong.of_kinds()]
        faults = [*([whole] if whole else []), *single]
        if faults:
            more = [say(Kind.AND_MORE, count=len(single) - MOST_WORDS)] if len(single) > MOST_WORDS else []
            findings = [fault.finding for fault in faults[: MOST_WORDS + bool(whole)]]
            return replace(
                self.unchecked,
                verdict=Verdict.REFUTED,
                findings=(*findings, *more, *self._remarks(found)),
                entries=tuple(entry for fault in faults for entry in fault.entries),
                counterexample=self._counterexample(found.otherwise if found.is_right and whole else found),
            )
        if left_open := self._left_open(found, wrong):
            return replace(self.unchecked, findings=(*left_open, *self._remarks(found)))
        holds = (*self._convention(found), *self._remarks(found))
        proved = replace(self.unchecked, verdict=Verdict.PROVED, findings=holds)
        if not self.checker.confirm:
            return proved
        sampled = self.checker.sampled()
        with self.checker.exact.budget.paused():
            from armproof.verification.tables.plant import confirm_rows

        return confirm_rows(found, proved, sampled)

    def _counterexample(self, found: TableReading) -> dict[str, float]:
        try:
            self.checker.sampled()
        except NotSampled:
            return {}
        with self.checker.exact.budget.paused():
            from armproof.verification.tables.plant import counterexample

        return counterexample(found)

    def _convention(self, found: TableReading) -> Iterator[Finding]:
        if self.columns.stated:
            holds = say(Kind.DH_CONVENTION, convention=found.convention)
        else:
            yield say(Kind.HEADERS_CONTRADICT if self.columns.contradictory else Kind.HEADERS_OPEN)
            kind = Kind.HOLDS_IN_BOTH if found.otherwise.is_right else Kind.HOLDS_IN_CONVENTION
            holds = say(kind, convention=found.convention)
        letter_of_a = self.columns.headers[found.reading.a].role
        yield say(Kind.LENGTH_ALONG_X, holds=holds, letter=letter_of_a) if self.columns.is_khalil else holds

    def _left_open(self, found: TableReading, wrong: WrongEntries) -> list[Finding]:
        """Say why rows could not be judged."""
        said = []
        for verdict in found.verdicts:
            row = verdict.row.number
            if verdict.row.is_empty:
                said.append(say(Kind.EMPTY_ROW, number=row))
                continue
            for parameter, problem in verdict.problems.items():
                right = found.right_value(verdict, parameter)
                terms = {"number": row, "parameter": letter(found, parameter), "problem": problem}
                if parameter in verdict.unbound and right is not None and not found.claim.lengths:
                    said.append(say(Kind.ROW_OPEN_BUT, **terms, meaning=wrong.notation.value(right)))
                else:
                    said.append(say(Kind.ROW_OPEN, **terms))
            if verdict.row.frames is None and not verdict.problems and not verdict.is_identity:
                said.append(say(Kind.ROW_WITHOUT_FRAME, number=row))
        return said

    def _remarks(self, found: TableReading) -> list[Finding]:
        """Say which joints have no row, which rows no frame, and what was taken for granted."""
        counts = {"rows": len(found.rows), "joints": len(found.arm.joints)}
        with_row = {row.frames.joint for row in found.rows if row.frames is not None}
        without = [joint.symbol for joint in found.arm.joints if joint.index not in with_row]
        beyond = [row.number for row in found.rows if row.frames is None]
        said = [say(Kind.JOINTS_WITHOUT_ROW, **counts, without=without)] if without else []
        if beyond and not without:
            said = [say(Kind.ROWS_BEYOND_ARM, **counts, beyond=beyond)]
        return [*said, *self.notes, *found.notes]
