"""What is wrong with a DH table: its headers, its columns, its frames, or single entries, each with the correct one."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import combinations

from verification.tables.row import ANGLES, PARAMETERS
from verification.errors import EvaluationError
from verification.latex import nodes as n
from verification.quantities import numbered_frames
from verification.tables.cells import Cell
from verification.tables.columns import plain
from verification.tables.reading import Row, RowVerdict, TableReading
from verification.tables.tool import same_tool
from verification.tables.words import (
    LETTERS,
    Notation,
    change_of_angle,
    change_of_length,
    latex_name,
    letter_of,
    symbols_of,
)
from verification.trig import Scalar
from verification.verdict import WrongEntry

_REVOLUTE = re.compile(r"0|r|rev\w*|rot\w*|pivot|hinge|dreh\w*", re.IGNORECASE)
_PRISMATIC = re.compile(r"1|p|t|pris\w*|trans\w*|gliss\w*|slid\w*|schub\w*", re.IGNORECASE)
_DEGREE_SIGN = re.compile(r"\^\s*\{?\s*\\circ\s*\}?|°|\\degree")
_PLAIN_DEGREES = re.compile(r"(?<![\d.{_])(?:15|30|45|60|75|90|120|135|150|180|270)(?![\d.}])")


@dataclass(frozen=True)
class Fault:
    """One thing that is wrong: words, and the wrong entries (a wrong header has no row and column)."""

    words: str
    entries: tuple[WrongEntry, ...] = ()


class Faults:
    """Finds the faults of a table under the reading that fits it best."""

    def __init__(self, found: TableReading, texts: tuple[tuple[str, ...], ...]) -> None:
        self.found = found
        self.columns = found.claim.columns
        self.texts = texts
        self.notation = Notation(found.claim.names, (cell for row in found.rows for cell in row.cells.values()))

    def of_table(self) -> Fault | None:
        """Return what is wrong with the table as a whole, if one thing is."""
        return self._other_frames() or self._convention() or self._swapped_headers() or self._shifted()

    def of_rows(self) -> Iterator[Fault]:
        """Yield what is wrong row by row."""
        for verdict in self.found.verdicts:
            frames = verdict.row.frames
            if frames is not None and verdict.right is None:
                yield Fault(
                    f"row {verdict.row.number}: frames {frames.reference} and {frames.frame} of the arm "
                    f"are not {self.found.convention} DH frames"
                )
            for parameter in verdict.wrong:
                yield self.wrong_entry(verdict, parameter, self.found.right_value(verdict, parameter))

    def of_kinds(self) -> Iterator[Fault]:
        """Yield wrong kinds of joints (σ_i, R or P) and variables, where the table has columns for them."""
        for row in self.found.rows:
            yield from self._wrong_kind(row)

    def letter(self, parameter: str) -> str:
        """Return the letter of a parameter's column."""
        column = self.found.reading.columns[parameter]
        role = self.columns.headers[column].role if column is not None else parameter
        return LETTERS.get(role, role)

    # -- the table as a whole ----------------------------------------------------------------------------------------

    def _other_frames(self) -> Fault | None:
        """The table gives the pose of the last frame rightly, by other frames than the arm's."""
        stated = self.columns.stated
        for reading in [self.found] if self.found.convention == stated else [self.found, self.found.otherwise]:
            first = next((v.row for v in reading.verdicts if v.row.frames is not None and not v.holds), None)
            if first is None or (frame := same_tool(reading)) is None:
                continue
            return Fault(
                f"the table gives {{}}^{numbered_frames(reading.arm)[0]}T_{frame} of the arm, but by other frames "
                f"from row {first.number} on: a {reading.convention} DH table whose frames between are not the arm's"
            )
        return None

    def _convention(self) -> Fault | None:
        """The headers state the other convention."""
        stated, convention = self.columns.stated, self.found.convention
        if not stated or stated == convention:
            return None
        headers = [
            self.columns.headers[k].text for k in (self.found.reading.a, self.found.reading.alpha) if k is not None
        ]
        entries = tuple(_wrong_header(text, _with_index(text, convention)) for text in headers)
        if self.found.is_right:
            return Fault(f"the rows hold in the {convention} convention, the headers say {stated}", entries)
        return Fault(f"the arm's frames are {convention} DH frames, the headers say {stated}", entries)

    def _swapped_headers(self) -> Fault | None:
        if len(self.found.wrong) < 2:
            return None
        columns = self.found.reading.columns
        for one, other in combinations(PARAMETERS, 2):
            first, second = columns[one], columns[other]
            if first is None or second is None or not self.found.but(**{one: second, other: first}).is_right:
                continue
            texts = self.columns.headers[first].text, self.columns.headers[second].text
            entries = (_wrong_header(*texts), _wrong_header(*reversed(texts)))
            return Fault(f"columns {self.letter(one)} and {self.letter(other)} swapped: the headers", entries)
        return None

    @property
    def is_only_headers(self) -> bool:
        """Whether mending two headers mends the table."""
        return self._convention() is None and self._swapped_headers() is not None

    def _shifted(self) -> Fault | None:
        """Rows of a and α that stand one row too low or too high, as in the other convention."""
        verdicts = self.found.verdicts
        if len(self.found.wrong) < 2 or any(v.right is None or v.problems for v in verdicts):
            return None
        if {parameter for v in verdicts for parameter in v.wrong} - {"a", "alpha"}:
            return None
        for printed, right, words in ((verdicts[1:], verdicts[:-1], "low"), (verdicts[:-1], verdicts[1:], "high")):
            if all(
                r.right is not None and r.right.agrees(parameter, v.values[parameter])
                for v, r in zip(printed, right, strict=True)
                for parameter in ("a", "alpha")
            ):
                return Fault(
                    f"a and α stand one row too {words}, as in a table of the {self.found.otherwise.convention} convention"
                )
        return None

    # -- single entries ----------------------------------------------------------------------------------------------

    def wrong_entry(self, verdict: RowVerdict, parameter: str, right: Scalar | None) -> Fault:
        """Return a wrong entry with its correct value and what is wrong with it."""
        column = self.found.reading.columns[parameter]
        correct = self._correct(right, parameter, column)
        said = f"row {verdict.row.number}: {self.letter(parameter)}"
        if column is None:
            change = f"the table has no column {self.letter(parameter)}"
            return Fault(
                f"{said} should be {correct}: {change}", (WrongEntry(1, verdict.row.number, None, "", correct, change),)
            )
        cell = verdict.row.cells[column]
        change = self._change(verdict, parameter, right)
        entry = WrongEntry(1, verdict.row.number, column + 1, cell.text, correct, change)
        return Fault(
            f"{said} is {cell.text or 'empty'}, should be {correct}" + (f": {change}" if change else ""), (entry,)
        )

    def _correct(self, right: Scalar | None, parameter: str, column: int | None) -> str:
        if right is None:
            return "another angle"
        if parameter in ANGLES:
            return self.notation.value(right, self._degree_sign(column))
        unit = self.columns.headers[column].unit if column is not None else ""
        scale = {"mm": 1000, "cm": 100}.get(unit, 1)
        return self.notation.value(right * scale if right.as_fraction() is not None else right)

    def _change(self, verdict: RowVerdict, parameter: str, right: Scalar | None) -> str:
        if swapped := self._swapped_entries(verdict, parameter):
            return swapped
        printed = verdict.values.get(parameter)
        if printed is None:
            return self._change_of_name(verdict, parameter, right)
        if right is None:
            return ""
        change = change_of_angle if parameter in ANGLES else change_of_length
        try:
            return change(printed, right)
        except EvaluationError:
            return ""

    def _change_of_name(self, verdict: RowVerdict, parameter: str, right: Scalar | None) -> str:
        name = verdict.unbound.get(parameter, "")
        same = right is not None and any(letter_of(symbol) == letter_of(name) for symbol in symbols_of(right))
        return f"the index: the arm has no {latex_name(name)}" if same else verdict.problems[parameter]

    def _swapped_entries(self, verdict: RowVerdict, parameter: str) -> str:
        """Two entries of one row that stand in each other's place."""
        right, values = verdict.right, verdict.values
        for other in verdict.wrong:
            if right is None or other == parameter or not {other, parameter} <= values.keys():
                continue
            if right.agrees(other, values[parameter]) and right.agrees(parameter, values[other]):
                return f"{self.letter(parameter)} and {self.letter(other)} are swapped"
        return ""

    def _degree_sign(self, column: int | None) -> str | None:
        """The sign after a number of degrees in a column of angles; None where its angles are in radians."""
        if column is None:
            return None
        cells: list[Cell] = [row.cells[column] for row in self.found.rows]
        texts = " ".join(cell.text for cell in cells)
        if sign := _DEGREE_SIGN.search(texts):
            return sign.group().strip()
        unit = self.columns.headers[column].unit
        if "\\pi" in texts or "π" in texts or unit == "rad":
            return None
        return "" if unit == "deg" or _PLAIN_DEGREES.search(texts) else None

    def _wrong_kind(self, row: Row) -> Iterator[Fault]:
        arm, texts = self.found.arm, self.texts[row.number - 1]
        joint = next((j for j in arm.joints if row.frames is not None and j.index == row.frames.joint), None)
        if joint is None:
            return
        kind, variable = self.columns.first("sigma"), self.columns.first("q")
        if kind is not None and kind < len(texts):
            printed = plain(texts[kind])
            said = "revolute" if _REVOLUTE.fullmatch(printed) else "prismatic" if _PRISMATIC.fullmatch(printed) else ""
            if said and said != joint.kind:
                number, letter = str(int(joint.kind == "prismatic")), joint.kind[0].upper()
                correct = number if printed in "01" else letter if len(printed) == 1 else joint.kind
                entry = WrongEntry(1, row.number, kind + 1, texts[kind], correct, f"the joint is {joint.kind}")
                yield Fault(f"row {row.number}: the joint is {joint.kind}, not {said}", (entry,))
        if variable is not None and variable != self.found.reading.theta and (cell := row.cells[variable]).trees:
            node = cell.trees[0]
            symbol = self.found.claim.names.known_symbol(node.key) if isinstance(node, n.Name) else None
            if symbol != joint.symbol and symbol in {other.symbol for other in arm.joints}:
                correct = self.notation.symbol(joint.symbol)
                entry = WrongEntry(1, row.number, variable + 1, cell.text, correct, "the variable of another joint")
                yield Fault(f"row {row.number}: the variable is {cell.text}, should be {correct}", (entry,))


def _wrong_header(printed: str, correct: str) -> WrongEntry:
    return WrongEntry(1, None, None, printed, correct, "the header")


def _with_index(header: str, convention: str) -> str:
    """Return a header with the index of the convention: a_{i-1} for a_i and back."""
    if convention == "classic":
        return re.sub(r"_\s*\{?\s*([ijkn])\s*[-−]\s*1\s*\}?", r"_\1", header)
    return re.sub(r"_\s*\{?\s*([ijkn])\s*\}?", r"_{\1-1}", header)
