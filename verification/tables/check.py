"""DH tables are claims: each row is checked against the frames of the arm."""

from __future__ import annotations

import re
from dataclasses import replace
from fractions import Fraction

from models.arm import Arm
from verification.document import Display, Table
from verification.equation import ChainChecker
from verification.errors import EvaluationError, TooComplex
from verification.latex import nodes as n
from verification.quantities import numbered_frames
from verification.tables.array import read_array
from verification.tables.cells import Cell, UnreadableCell, read_cell, row_frames
from verification.tables.columns import CONVENTIONS, Columns, read_columns
from verification.tables.faults import Faults
from verification.tables.mend import single_mends
from verification.tables.origins import check_origins
from verification.tables.plant import confirm_rows, confirm_tool, counterexample
from verification.tables.reading import Claim, Row, TableReading
from verification.tables.tool import turned_tool
from verification.verdict import Record, Verdict

MOST_WORDS = 6  # wrong entries spelt out in a message; all are listed


def check_table(checker: ChainChecker, table: Table) -> Record | None:
    """Return the record of a DH table, or None where a table is not one (no α and θ columns)."""
    if (columns := read_columns(table.header)) is not None:
        return _Check(checker, table, columns).record()
    if (found := check_origins(checker, table, _Check(checker, table, None).blank)) is not None:
        return found
    turned = _turned(table)
    if turned is None or (columns := read_columns(turned.header)) is None:
        return None
    found = _Check(checker, turned, columns).record()
    entries = tuple(
        replace(e, row=e.column - 1, column=e.row + 1) if e.row is not None and e.column is not None else e
        for e in found.entries
    )
    return replace(found, latex=_latex(table), entries=entries)


def check_array_table(checker: ChainChecker, display: Display) -> Record | None:
    """Return the record of a display that is a DH table set as an array, or None where it is not."""
    array = read_array(display)
    found = check_table(checker, array.table) if array is not None else None
    if array is None or found is None:
        return None
    entries = [replace(entry, span=array.span(entry.row, entry.column, entry.printed)) for entry in found.entries]
    return replace(found, latex=display.latex, entries=tuple(entries))


def _turned(table: Table) -> Table | None:
    """A table that has a column a joint, turned."""
    grid = (table.header, *table.rows)
    if len({len(row) for row in grid}) != 1 or len(table.header) < 2:
        return None
    header, *rows = zip(*grid, strict=True)
    return replace(table, header=header, rows=tuple(rows))


def _latex(table: Table) -> str:
    return " \\\\\n".join(" & ".join(row) for row in (table.header, *table.rows))


class _Check:
    """Checks one table."""

    def __init__(self, checker: ChainChecker, table: Table, columns: Columns) -> None:
        self.names = checker.names
        self.checker = checker
        self.table = table
        self.columns = columns
        self.blank = Record(
            table.line, _latex(table), Verdict.UNREADABLE, table.erratum, cell=table.cell, section=table.section
        )

    def record(self) -> Record:
        """Return the record of the table."""
        try:
            cells = self._cells()
        except UnreadableCell as problem:
            return replace(self.blank, message=str(problem))
        try:
            if self._is_general(cells):
                return replace(self.blank, verdict=Verdict.DEFINED, message="names the parameters of a general link")
            if self.names.arm is None:
                return replace(
                    self.blank,
                    verdict=Verdict.UNCHECKED,
                    message="the front matter names no arm to check the table against",
                )
            return self._against(self.names.arm, cells)
        except (TooComplex, RecursionError) as problem:
            return replace(self.blank, verdict=Verdict.UNCHECKED, message=f"too large to decide: {problem}")
        except EvaluationError as problem:
            return replace(self.blank, verdict=Verdict.UNCHECKED, message=str(problem))

    # -- the body ----------------------------------------------------------------------------------------------------

    def _cells(self) -> list[dict[int, Cell]]:
        """Read the entries of the columns that hold parameters."""
        read = sorted(
            {
                self.columns.alpha,
                self.columns.theta,
                *(k for pair in self.columns.lengths for k in pair if k is not None),
            }
        )
        variable = self.columns.first("q")
        rows = []
        for number, texts in enumerate(self.table.rows, start=1):
            if len(texts) > len(self.table.header):
                raise UnreadableCell(f"row {number} has {len(texts)} entries, the header has {len(self.table.header)}")
            row = {}
            for column in read:
                try:
                    row[column] = read_cell(self.names, texts[column] if column < len(texts) else "")
                except UnreadableCell as problem:
                    raise UnreadableCell(f"row {number}, column {column + 1}: {problem}") from None
            if variable is not None and variable not in row:
                try:
                    row[variable] = read_cell(self.names, texts[variable] if variable < len(texts) else "")
                except UnreadableCell:
                    row[variable] = Cell("", kind="blank")
            rows.append(row)
        return rows

    def _is_general(self, cells: list[dict[int, Cell]]) -> bool:
        """Whether the rows only give names to the parameters of any link: a_i, α_i, d_i, θ_i."""
        entries = [cell for row in cells for cell in row.values()]
        names = [cell.trees[0] if len(cell.trees) == 1 else None for cell in entries]
        if not names or not all(isinstance(node, n.Name) for node in names):
            return False
        indices = {node.sub.rpartition("-")[0] or node.sub for node in names if isinstance(node, n.Name)}
        return self.names.arm is None or indices <= set("ijkn")

    # -- against an arm ----------------------------------------------------------------------------------------------

    def _against(self, arm: Arm, cells: list[dict[int, Cell]]) -> Record:
        label = self.columns.first("label")
        labels = (
            [texts[label] if label < len(texts) else "" for texts in self.table.rows] if label is not None else None
        )
        frames, passed_over = row_frames(self.names, arm, labels, len(cells))
        rows = tuple(Row(number, frames[number - 1], row) for number, row in enumerate(cells, start=1))
        claim = Claim(self.names, arm, self.checker.exact, self.columns, rows)
        found = self._best(claim)
        if passed_over:
            claim.notes["the labels name no frames of the arm: the rows are taken in order"] = None
        if not found.is_right and arm.lengths and self._has_lengths_in_numbers(rows):
            values = {
                symbol: self.checker.exact.rational(Fraction(str(value))) for symbol, value in arm.lengths.items()
            }
            measured = self._best(replace(claim, lengths=values))
            if measured.score > found.score or not found.fits_frames:
                claim.notes["lengths in numbers are compared with those of the model"] = None
                found = measured
        if not found.is_right and not any(
            TableReading(claim, one).fits_frames for one in self.columns.readings(CONVENTIONS)
        ):
            return self._beyond_frames(found)
        return self._judge(found)

    def _has_lengths_in_numbers(self, rows: tuple[Row, ...]) -> bool:
        columns = {column for pair in self.columns.lengths for column in pair if column is not None}
        cells = [row.cells[column] for row in rows for column in columns]
        return any(cell.trees and not any(isinstance(node, n.Name) for node in n.walk(cell.trees[-1]))
                   and re.search(r"[1-9]", cell.text) for cell in cells)  # fmt: skip

    def _best(self, claim: Claim) -> TableReading:
        """Return the reading that the headers state; where they leave it open, the one under which most rows hold.

        The headers are overruled where more rows hold in the other convention, and where the arm's frames are DH frames
        of the other one only.
        """
        likely = self.columns.stated or (
            "modified" if self.columns.is_khalil else claim.arm.dh.convention if claim.arm.dh else "classic"
        )
        conventions = sorted(CONVENTIONS, key=lambda convention: convention != likely)
        readings = [TableReading(claim, reading) for reading in self.columns.readings(conventions)]
        best = max(readings, key=lambda one: (one.score, one.fits_frames))  # the first of the best
        as_stated = max((one for one in readings if one.convention == likely), key=lambda one: one.score)
        overruled = best.score > as_stated.score or (best.fits_frames and not as_stated.fits_frames)
        return best if overruled or not self.columns.stated else as_stated

    # -- verdicts ----------------------------------------------------------------------------------------------------

    def _judge(self, found: TableReading) -> Record:
        faults = Faults(found, self.table.rows)
        whole = faults.of_table()
        single = [*([] if faults.is_only_headers else faults.of_rows()), *faults.of_kinds()]
        if whole or single:
            words = [fault.words for fault in single]
            more = [f"and {len(words) - MOST_WORDS} more"] if len(words) > MOST_WORDS else []
            said = [*([whole.words] if whole else []), *words[:MOST_WORDS], *more, *_counts(found), *found.notes]
            entries = tuple(entry for fault in [*([whole] if whole else []), *single] for entry in fault.entries)
            record = replace(self.blank, verdict=Verdict.REFUTED, message="; ".join(said), entries=entries)
            other = bool(self.columns.stated) and self.columns.stated != found.convention and found.is_right
            return replace(record, counterexample=counterexample(found.otherwise if other else found))
        if unknown := self._open(found, faults):
            return replace(
                self.blank, verdict=Verdict.UNCHECKED, message="; ".join([*unknown, *_counts(found), *found.notes])
            )
        said = [self._convention_words(found), *_counts(found), *found.notes]
        proved = replace(self.blank, verdict=Verdict.PROVED, message="; ".join(said))
        return confirm_rows(found, proved, self.checker.sampled()) if self.checker.confirm else proved

    def _convention_words(self, found: TableReading) -> str:
        roles = ""
        if self.columns.is_khalil and found.reading.a is not None:
            roles = f", {self.columns.headers[found.reading.a].role} the length along x"
        if self.columns.stated:
            return f"{found.convention} DH{roles}"
        why = "contradict each other" if self.columns.contradictory else "leave the convention open"
        holds = "both conventions" if found.otherwise.is_right else f"the {found.convention} one"
        return f"the headers {why}; the rows hold in {holds}{roles}"

    def _open(self, found: TableReading, faults: Faults) -> list[str]:
        """Say why rows could not be judged."""
        said = []
        for verdict in found.verdicts:
            for parameter, problem in verdict.problems.items():
                text = f"row {verdict.row.number}: {faults.letter(parameter)}: {problem}"
                right = found.right_value(verdict, parameter)
                if parameter in verdict.unbound and right is not None and not found.claim.lengths:
                    text += f"; the entry holds if it means {faults.notation.value(right)}: bind it under 'symbols'"
                said.append(text)
            if verdict.row.frames is None and not verdict.problems and not verdict.is_identity:
                said.append(f"row {verdict.row.number} has no frame on the arm to be checked against")
        return said

    def _beyond_frames(self, found: TableReading) -> Record:
        """The arm's frames are no DH frames: only the pose of the last one can be compared, but for its axes."""
        first = numbered_frames(found.arm)[0]
        reason = f"the frames of arm '{found.arm.name}' are DH frames of neither convention: the rows cannot be checked one by one"
        readings = (found,) if self.columns.stated else (found, found.otherwise)
        for reading in readings:
            if (tool := turned_tool(reading)) is not None:
                place = "" if tool.origin == tool.frame else f", with its origin in that of frame {tool.origin}"
                words = f"the last row's frame moves with frame {tool.frame} for every configuration{place}"
                proved = replace(self.blank, verdict=Verdict.PROVED, message="; ".join([words, reason, *reading.notes]))
                return (
                    confirm_tool(reading, tool, first, proved, self.checker.sampled())
                    if self.checker.confirm
                    else proved
                )
        for reading in readings:
            faults = Faults(reading, self.table.rows)
            for mend in single_mends(reading):
                if (tool := turned_tool(reading.mended(mend.verdict, mend.parameter, mend.value))) is None:
                    continue
                fault = faults.wrong_entry(mend.verdict, mend.parameter, mend.value)
                said = [
                    fault.words,
                    f"so mended, the last row's frame moves with frame {tool.frame}",
                    reason,
                    *reading.notes,
                ]
                return replace(self.blank, verdict=Verdict.REFUTED, message="; ".join(said), entries=fault.entries)
        said = [reason, "and the last row's frame lies at none of the arm's last frames"]
        said += [*self._open(found, Faults(found, self.table.rows)), *_counts(found), *found.notes]
        return replace(self.blank, verdict=Verdict.UNCHECKED, message="; ".join(said))


def _counts(found: TableReading) -> list[str]:
    """Say which joints have no row, and which rows no frame."""
    joints = len(found.arm.joints)
    with_row = {row.frames.joint for row in found.rows if row.frames is not None}
    without = [joint.symbol for joint in found.arm.joints if joint.index not in with_row]
    if without:
        return [f"{len(found.rows)} rows for an arm of {joints} joints: none for {', '.join(without)}"]
    beyond = [str(row.number) for row in found.rows if row.frames is None]
    return (
        [f"{len(found.rows)} rows for an arm of {joints} joints, which has no frame for row {', '.join(beyond)}"]
        if beyond
        else []
    )
