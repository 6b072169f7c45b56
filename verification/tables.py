"""DH tables are claims: each row is checked against the frames of the arm."""

from __future__ import annotations

import re
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import combinations

import numpy as np

from models.arm import Arm
from verification.algebras import ExactAlgebra, SampledAlgebra
from verification.compare import Pair, entry_errors
from verification.dh_row import ANGLES, PARAMETERS, row_matrix
from verification.document import Display, Table
from verification.equation import TOLERANCE, ChainChecker
from verification.errors import EvaluationError, TooComplex
from verification.latex import nodes as n
from verification.matrix import Matrix
from verification.quantities import Quantity, numbered_frames
from verification.table_array import read_array
from verification.table_cells import Cell, UnreadableCell, read_cell, row_frames
from verification.table_columns import CONVENTIONS, Columns, Reading, plain, read_columns
from verification.table_reading import Row, RowVerdict, TableReading
from verification.table_words import LETTERS, Notation, change_of_angle, change_of_length
from verification.verdict import Record, Verdict, WrongEntry

MOST_WORDS = 6  # wrong entries spelt out in a message; all are listed
_REVOLUTE = re.compile(r"0|r|rev\w*|rot\w*|pivot|hinge|dreh\w*", re.IGNORECASE)
_PRISMATIC = re.compile(r"1|p|t|pris\w*|trans\w*|gliss\w*|slid\w*|schub\w*", re.IGNORECASE)


def check_table(checker: ChainChecker, table: Table) -> Record | None:
    """Return the record of a DH table, or None where a table is not one (no α and θ columns)."""
    if (columns := read_columns(table.header)) is not None:
        return _Check(checker, table, columns).record()
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
    entries = []
    for entry in found.entries:
        row, column = (entry.row or 0) - 1, (entry.column or 0) - 1
        inside = 0 <= row < len(array.spans) and 0 <= column < len(array.spans[row])
        entries.append(replace(entry, span=array.spans[row][column]) if inside else entry)
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


@dataclass(frozen=True)
class _Cause:
    """What is wrong with the table as a whole: words, and the headers that should read otherwise."""

    words: str = ""
    entries: tuple[WrongEntry, ...] = ()


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

    def _rows(self, arm: Arm, cells: list[dict[int, Cell]]) -> list[Row]:
        label = self.columns.first("label")
        labels = (
            [texts[label] if label < len(texts) else "" for texts in self.table.rows] if label is not None else None
        )
        frames, _ = row_frames(self.names, arm, labels, len(cells))
        return [Row(number, frames[number - 1], row) for number, row in enumerate(cells, start=1)]

    # -- against an arm ----------------------------------------------------------------------------------------------

    def _against(self, arm: Arm, cells: list[dict[int, Cell]]) -> Record:
        rows = self._rows(arm, cells)
        exact = self.checker.exact
        found = self._best(arm, exact, rows)
        numbers = any(self._is_number(row, column) for row in rows for pair in self.columns.lengths for column in pair)
        if not found.is_right and numbers and arm.lengths:
            model = exact.at({symbol: exact.rational(Fraction(str(value))) for symbol, value in arm.lengths.items()})
            measured = self._best(arm, model, rows)
            if measured.score > found.score or (measured.fits_frames is False and found.fits_frames is False):
                measured.notes["lengths in numbers are compared with those of the model"] = None
                found = measured
        if not found.is_right and not any(self._fits(arm, exact, rows, convention) for convention in CONVENTIONS):
            return self._beyond_frames(found)
        return self._judge(found)

    def _is_number(self, row: Row, column: int | None) -> bool:
        cell = row.cells.get(column) if column is not None else None
        if cell is None or not cell.trees:
            return False
        return (
            not any(isinstance(node, n.Name) for node in n.walk(cell.trees[-1]))
            and re.search(r"[1-9]", cell.text) is not None
        )

    def _best(self, arm: Arm, algebra: ExactAlgebra, rows: list[Row]) -> TableReading:
        """Return the reading that the headers state; where they leave it open, the one under which most rows hold.

        Headers are overruled where the frames are DH frames of the other convention only, or where more rows hold in it.
        """
        readings = [
            TableReading(self.names, arm, algebra, self.columns, rows, reading)
            for reading in self.columns.readings(self._conventions(arm))
        ]
        first = readings[0]
        best = max(readings, key=lambda one: (one.score, one.fits_frames))  # the first of the best
        if not self.columns.stated or best.score > first.score or (best.fits_frames and not first.fits_frames):
            return best
        return max(
            (one for one in readings if one.reading.convention == self.columns.stated), key=lambda one: one.score
        )

    def _conventions(self, arm: Arm) -> list[str]:
        """The conventions, the likeliest first."""
        likely = self.columns.stated or (
            "modified" if self.columns.is_khalil else arm.dh.convention if arm.dh else "classic"
        )
        return sorted(CONVENTIONS, key=lambda convention: convention != likely)

    def _fits(self, arm: Arm, algebra: ExactAlgebra, rows: list[Row], convention: str) -> bool:
        reading = next(iter(self.columns.readings([convention])))
        return TableReading(self.names, arm, algebra, self.columns, rows, reading).fits_frames

    # -- verdicts ----------------------------------------------------------------------------------------------------

    def _judge(self, found: TableReading) -> Record:
        notation = Notation(self.names, (cell for row in found.rows for cell in row.cells.values()))
        convention = found.reading.convention
        stated = self.columns.stated
        cause = self._cause(found)
        entries = [*cause.entries]
        words: list[str] = [cause.words] if cause.words else []
        swapped = bool(cause.entries) and not stated.strip(convention)
        spoken: list[str] = []
        for verdict in [] if swapped else found.wrong:
            for parameter in verdict.wrong:
                entry, text = self._wrong_entry(found, notation, verdict, parameter)
                entries.append(entry)
                spoken.append(text)
        for row in found.rows:
            for entry, text in self._wrong_kind(found, notation, row):
                entries.append(entry)
                spoken.append(text)
        departed = [v for v in found.verdicts if v.right is None and v.row.frames is not None]
        for verdict in departed:
            frames = verdict.row.frames
            assert frames is not None
            spoken.append(
                f"row {verdict.row.number}: frames {frames.reference} and {frames.frame} of the arm are not {convention} DH frames"
            )
        words += spoken[:MOST_WORDS] + ([f"and {len(spoken) - MOST_WORDS} more"] if len(spoken) > MOST_WORDS else [])
        if entries or cause.words or departed:
            message = "; ".join([*words, *self._counts(found), *found.notes])
            counterexample = self._counterexample(found)
            return replace(
                self.blank,
                verdict=Verdict.REFUTED,
                message=message,
                entries=tuple(entries),
                counterexample=counterexample,
            )
        open_rows = self._open(found, notation)
        if open_rows:
            return replace(
                self.blank,
                verdict=Verdict.UNCHECKED,
                message="; ".join([*open_rows, *self._counts(found), *found.notes]),
            )
        notes = [self._proved_words(found), *self._counts(found), *found.notes]
        return self._confirm(found, replace(self.blank, verdict=Verdict.PROVED, message="; ".join(notes)))

    def _proved_words(self, found: TableReading) -> str:
        convention = found.reading.convention
        roles = f", {self._header(found, 'a')} the length along x" if self.columns.is_khalil else ""
        if self.columns.stated:
            return f"{convention} DH{roles}"
        why = "contradict each other" if self.columns.contradictory else "leave the convention open"
        other = replace_convention(found)
        if other.is_right:
            return f"the headers {why}; the rows hold in both conventions{roles}"
        return f"the headers {why}; the rows hold in the {convention} one{roles}"

    def _counts(self, found: TableReading) -> list[str]:
        """Say which joints have no row, and which rows no frame."""
        joints = len(found.arm.joints)
        with_row = {row.frames.joint for row in found.rows if row.frames is not None}
        without = [joint.symbol for joint in found.arm.joints if joint.index not in with_row]
        said = []
        if without:
            said.append(f"{len(found.rows)} rows for an arm of {joints} joints: none for {', '.join(without)}")
        elif len(found.rows) > joints and (beyond := [row for row in found.rows if row.frames is None]):
            numbers = ", ".join(str(row.number) for row in beyond)
            said.append(f"{len(found.rows)} rows for an arm of {joints} joints, which has no frame for row {numbers}")
        return said

    def _open(self, found: TableReading, notation: Notation) -> list[str]:
        """Say why rows could not be judged."""
        said = []
        for verdict in found.verdicts:
            for parameter, problem in verdict.problems.items():
                text = f"row {verdict.row.number}: {self._header(found, parameter)}: {problem}"
                right = found.right_value(verdict, parameter)
                if parameter in verdict.unbound and right is not None and found.algebra is self.checker.exact:
                    text += f"; the row holds if it means {notation.value(right)} (bind it under 'symbols')"
                said.append(text)
            if verdict.row.frames is None and not verdict.problems:
                said.append(f"row {verdict.row.number} has no frame on the arm to be checked against")
        return said

    # -- what is wrong -----------------------------------------------------------------------------------------------

    def _cause(self, found: TableReading) -> _Cause:
        """Return what is wrong with the table as a whole, if one thing is."""
        if (same := self._same_tool(found)) is not None:
            return _Cause(same)
        stated = self.columns.stated
        convention = found.reading.convention
        if stated and stated != convention:
            printed = [k for k in (found.reading.a, found.reading.alpha) if k is not None]
            entries = tuple(
                WrongEntry(
                    1,
                    None,
                    None,
                    self.columns.headers[k].text,
                    _with_index(self.columns.headers[k].text, convention),
                    "the header",
                )
                for k in printed
            )
            if found.is_right:
                return _Cause(f"the rows hold in the {convention} convention, the headers say {stated}", entries)
            return _Cause(f"the arm's frames are {convention} DH frames, the headers say {stated}", entries)
        if len(found.wrong) > 1:
            for one, other in combinations(PARAMETERS, 2):
                columns = found.reading.columns
                if columns[one] is None or columns[other] is None:
                    continue
                if found.in_columns(**{one: columns[other], other: columns[one]}).is_right:
                    first, second = self._header(found, one), self._header(found, other)
                    texts = [self.columns.headers[columns[p] or 0].text for p in (one, other)]
                    entries = (
                        WrongEntry(1, None, None, texts[0], texts[1], "the header"),
                        WrongEntry(1, None, None, texts[1], texts[0], "the header"),
                    )
                    return _Cause(f"columns {first} and {second} swapped: the headers", entries)
            if shifted := self._shifted(found):
                return _Cause(shifted)
        return _Cause()

    def _shifted(self, found: TableReading) -> str:
        """Rows of a and α that stand one row too low or too high belong to the other convention."""
        verdicts = found.verdicts
        if any(v.right is None or v.problems for v in verdicts) or {p for v in verdicts for p in v.wrong} - {
            "a",
            "alpha",
        }:
            return ""
        for printed, right, words in ((verdicts[1:], verdicts[:-1], "low"), (verdicts[:-1], verdicts[1:], "high")):
            if all(
                r.right is not None and r.right.agrees(p, v.values[p])
                for v, r in zip(printed, right, strict=True)
                for p in ("a", "alpha")
            ):
                other = "modified" if found.reading.convention == "classic" else "classic"
                return f"a and α stand one row too {words}, as in a table of the {other} convention"
        return ""

    def _same_tool(self, found: TableReading) -> str | None:
        """Say so if the table describes the pose of the last frame rightly, by other frames than the arm's."""
        arm = found.arm
        readings = [found, replace_convention(found)] if found.reading.convention != self.columns.stated else [found]
        frames = numbered_frames(arm)
        for reading in readings:
            product = reading.product
            if product is None or reading.is_right:
                continue
            for frame in [frames[-1], *(f for f in arm.frames if f not in frames)]:
                if _equal(product, reading.algebra.quantity(Quantity("pose", frame, frames[0]))):
                    parts = next((v.row for v in reading.verdicts if not v.holds), None)
                    where = f" from row {parts.number} on" if parts is not None else ""
                    pose = f"{{}}^{frames[0]}T_{frame}"
                    return (
                        f"the table gives the arm's {pose}, but by other frames{where}: "
                        f"a {reading.reading.convention} DH table whose intermediate frames are not the arm's"
                    )
        return None

    def _beyond_frames(self, found: TableReading) -> Record:
        """The arm's frames are no DH frames: only the pose of the last frame can be compared, but for its axes."""
        arm = found.arm
        frames = numbered_frames(arm)
        reason = f"the frames of arm '{arm.name}' are DH frames of neither convention, so the rows cannot be checked one by one"
        for reading in (found, replace_convention(found)) if not self.columns.stated else (found,):
            product = reading.product
            if product is None:
                continue
            for frame in [frames[-1], *(f for f in arm.frames if f not in frames)]:
                pose = reading.algebra.quantity(Quantity("pose", frame, frames[0]))
                turn = product.block(range(3), range(3)).transpose @ pose.block(range(3), range(3))
                constant = all(cell.as_fraction() is not None for row in turn.rows for cell in row)
                if constant and _equal(product.block(range(3), [3]), pose.block(range(3), [3])):
                    words = (
                        f"the last row's frame moves with frame {frame}, from the same origin, for every configuration"
                    )
                    proved = replace(
                        self.blank, verdict=Verdict.PROVED, message="; ".join([words, reason, *reading.notes])
                    )
                    return self._confirm_tool(reading, frame, turn, proved)
        problems = self._open(found, Notation(self.names, ()))
        return replace(
            self.blank,
            verdict=Verdict.UNCHECKED,
            message="; ".join([reason, *problems, *self._counts(found), *found.notes]),
        )

    def _wrong_entry(
        self, found: TableReading, notation: Notation, verdict: RowVerdict, parameter: str
    ) -> tuple[WrongEntry, str]:
        column = found.reading.columns[parameter]
        cell = verdict.row.cells[column] if column is not None else Cell("0")
        right = found.right_value(verdict, parameter)
        printed = verdict.values.get(parameter)
        degrees = self._degrees(found, column) if parameter in ANGLES else None
        correct = (
            notation.value(self._in_unit(right, column, parameter), degrees) if right is not None else "another angle"
        )
        change = self._swapped(found, verdict, parameter)
        if not change and right is not None and printed is not None:
            try:
                change = (change_of_angle if parameter in ANGLES else change_of_length)(printed, right)
            except EvaluationError:
                change = ""
        elif not change and parameter in verdict.unbound:
            change = f"'{verdict.unbound[parameter]}' is not bound"
        text = cell.text or "empty"
        said = f"row {verdict.row.number}: {self._header(found, parameter)} is {text}, should be {correct}"
        row, place = (verdict.row.number, column + 1) if column is not None else (verdict.row.number, None)
        if place is None:
            said, change = f"{said} (the table has no such column)", "the column is missing"
        return WrongEntry(1, row, place or 0, text, correct, change), said + (f": {change}" if change and place else "")

    def _in_unit(self, value: object, column: int | None, parameter: str) -> object:
        unit = self.columns.headers[column].unit if column is not None else ""
        number = value.as_fraction() if parameter not in ANGLES else None  # type: ignore[attr-defined]
        if number is not None and unit in ("mm", "cm"):
            return self.checker.exact.rational(number * (1000 if unit == "mm" else 100))
        return value

    def _swapped(self, found: TableReading, verdict: RowVerdict, parameter: str) -> str:
        """Two entries of one row that stand in each other's place."""
        for other in verdict.wrong:
            if (
                other == parameter
                or verdict.right is None
                or other not in verdict.values
                or parameter not in verdict.values
            ):
                continue
            if verdict.right.agrees(other, verdict.values[parameter]) and verdict.right.agrees(
                parameter, verdict.values[other]
            ):
                return f"{self._header(found, parameter)} and {self._header(found, other)} are swapped"
        return ""

    def _wrong_kind(self, found: TableReading, notation: Notation, row: Row) -> list[tuple[WrongEntry, str]]:
        """The kind of joint (σ_i, R or P) and its variable, where the table has columns for them."""
        joint = next((j for j in found.arm.joints if row.frames is not None and j.index == row.frames.joint), None)
        if joint is None:
            return []
        wrong = []
        texts = self.table.rows[row.number - 1]
        kind = self.columns.first("sigma")
        if kind is not None and kind < len(texts):
            printed = plain(texts[kind])
            said = (
                "revolute"
                if _REVOLUTE.fullmatch(printed)
                else "prismatic"
                if _PRISMATIC.fullmatch(printed)
                else joint.kind
            )
            if said != joint.kind:
                correct = (
                    str(int(joint.kind == "prismatic"))
                    if printed in "01"
                    else joint.kind[0].upper()
                    if len(printed) == 1
                    else joint.kind
                )
                entry = WrongEntry(1, row.number, kind + 1, texts[kind], correct, f"the joint is {joint.kind}")
                wrong.append((entry, f"row {row.number}: the joint is {joint.kind}, not {said}"))
        variable = self.columns.first("q")
        if variable is not None and variable != found.reading.theta and (cell := row.cells[variable]).trees:
            node = cell.trees[0]
            symbol = self.names.known_symbol(node.key) if isinstance(node, n.Name) else None
            if symbol in {j.symbol for j in found.arm.joints} and symbol != joint.symbol:
                correct = notation.symbol(joint.symbol)
                entry = WrongEntry(1, row.number, variable + 1, cell.text, correct, "the variable of another joint")
                wrong.append((entry, f"row {row.number}: the variable is {correct}, not {cell.text}"))
        return wrong

    def _header(self, found: TableReading, parameter: str) -> str:
        """The letter of a parameter's column."""
        column = found.reading.columns[parameter]
        role = self.columns.headers[column].role if column is not None else parameter
        return LETTERS.get(role, role)

    def _degrees(self, found: TableReading, column: int | None) -> str | None:
        """The sign after a number of degrees in a column of angles, None where its angles are in radians."""
        if column is None:
            return None
        texts = " ".join(row.cells[column].text for row in found.rows)
        if found_sign := re.search(r"\^\s*\{?\s*\\circ\s*\}?|°|\\degree", texts):
            return found_sign.group()
        numbers = re.search(r"(?<![\d.{_])(?:15|30|45|60|75|90|120|135|150|180|270)(?![\d.}])", texts) is not None
        is_degrees = self.columns.headers[column].unit == "deg" or (
            numbers and self.columns.headers[column].unit != "rad"
        )
        return "" if is_degrees and "\\pi" not in texts and "π" not in texts else None

    # -- the double plant --------------------------------------------------------------------------------------------

    def _confirm(self, found: TableReading, proved: Record) -> Record:
        """Evaluate the rows on the double plant as well."""
        if not self.checker.confirm:
            return proved
        sampled = self.checker.sampled()
        worst = 0.0
        for verdict in found.verdicts:
            frames = verdict.row.frames
            assert frames is not None
            values = [sampled.from_exact(verdict.values[parameter]) for parameter in PARAMETERS]
            link = row_matrix(sampled, found.reading.convention, *values)
            worst = max(
                worst, _largest_error(sampled, sampled.quantity(Quantity("pose", frames.frame, frames.reference)), link)
            )
        return self._confirmed(proved, sampled, worst)

    def _confirm_tool(self, reading: TableReading, frame: str, turn: Matrix, proved: Record) -> Record:
        if not self.checker.confirm:
            return proved
        sampled = self.checker.sampled()
        total: Matrix | None = None
        for verdict in reading.verdicts:
            values = [sampled.from_exact(verdict.values[parameter]) for parameter in PARAMETERS]
            link = row_matrix(sampled, reading.reading.convention, *values)
            total = link if total is None else total @ link
        assert total is not None
        zero, one = turn.rows[0][0] * 0, turn.rows[0][0] * 0 + 1
        last = Matrix((*((*row, zero) for row in turn.rows), (zero, zero, zero, one)))
        pose = sampled.quantity(Quantity("pose", frame, numbered_frames(reading.arm)[0]))
        return self._confirmed(proved, sampled, _largest_error(sampled, pose, total @ sampled.from_exact(last)))

    def _confirmed(self, proved: Record, sampled: SampledAlgebra, worst: float) -> Record:
        if worst > TOLERANCE:
            return replace(
                proved,
                verdict=Verdict.REFUTED,
                message="the exact proof and the double plant disagree",
                max_error=worst,
            )
        return replace(proved, samples=sampled.samples, max_error=worst)

    def _counterexample(self, found: TableReading) -> dict[str, float]:
        """Return a configuration, and the lengths, at which the first wrong row's matrix is not the arm's."""
        arm = found.arm
        for verdict in found.verdicts:
            if verdict.holds or verdict.problems or verdict.row.frames is None:
                continue
            pose, link = found.pose(verdict.row.frames), found.matrix(verdict)
            pairs = zip(pose.rows, link.rows, strict=True)
            differences = [
                x - y for one, other in pairs for x, y in zip(one, other, strict=True) if not (x - y).is_zero()
            ]
            values = {joint.symbol: round(0.7 - 0.15 * (joint.index - 1), 2) for joint in arm.joints}
            q = np.array([list(values.values())])
            at = SampledAlgebra(self.checker.exact, q)
            if not any(abs(float(at.from_exact(cell)[0])) > 1e-6 for cell in differences):
                continue
            involved = {
                name for cell in (*differences,) for powers, _ in cell.ring.terms(cell.numerator) for _, name in powers
            }
            everything = {**values, **arm.lengths, **arm.angles}
            return {name: float(value) for name, value in everything.items() if name in involved}
        return {}


def replace_convention(found: TableReading) -> TableReading:
    """Return the reading in the other convention."""
    other = "classic" if found.reading.convention == "modified" else "modified"
    reading: Reading = replace(found.reading, convention=other)
    return TableReading(found.names, found.arm, found.algebra, found.columns, found.rows, reading)


def _with_index(header: str, convention: str) -> str:
    """Return a header with the index of the convention: a_{i-1} for a_i and back."""
    if convention == "classic":
        return re.sub(r"_\s*\{?\s*([ijkn])\s*[-−]\s*1\s*\}?", r"_\1", header)
    return re.sub(r"_\s*\{?\s*([ijkn])\s*\}?", r"_{\1-1}", header)


def _equal(one: Matrix, other: Matrix) -> bool:
    return all((x - y).is_zero() for a, b in zip(one.rows, other.rows, strict=True) for x, y in zip(a, b, strict=True))


def _largest_error(sampled: SampledAlgebra, true: Matrix, printed: Matrix) -> float:
    """The largest error of an entry over the samples, scaled by its size."""

    def stack(matrix: Matrix) -> Matrix:
        return matrix.map(lambda cell: np.broadcast_to(cell, (sampled.samples,)))

    errors = entry_errors(Pair(stack(true), stack(printed)))
    sizes = np.abs(np.array([list(row) for row in stack(true).rows]))
    return float((errors / (1.0 + sizes)).max())
