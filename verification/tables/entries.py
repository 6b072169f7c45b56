"""The wrong entries of a DH table, each with the correct one and what is wrong with it in words."""

from __future__ import annotations

from collections.abc import Iterator

from armproof.verification.algebra.ring import Scalar
from armproof.verification.errors import EvaluationError
from armproof.verification.findings import Finding, Kind, say
from armproof.verification.latex.reader import key_as_latex
from armproof.verification.patterns import regex
from armproof.verification.tables.angles import change_of_angle, change_of_length, letter_of, symbols_of
from armproof.verification.tables.cells import Notation, read_kind
from armproof.verification.tables.claim import Row, RowVerdict
from armproof.verification.tables.columns import plain
from armproof.verification.tables.faults import Fault, letter
from armproof.verification.tables.reading import TableReading
from armproof.verification.tables.row import ANGLES, SCALES
from armproof.verification.verdict import WrongEntry

_DEGREE_SIGN = regex(r"\^\s*\{?\s*\\circ\s*\}?|[°º˚]|\\degree")
_PLAIN_DEGREES = regex(r"(?<![\d.{_])(?:15|30|45|60|75|90|120|135|150|180|270)(?![\d.}])")


class WrongEntries:
    """Finds the wrong entries of a table under the reading that fits it best."""

    def __init__(self, found: TableReading, texts: tuple[tuple[str, ...], ...]) -> None:
        self.found, self.texts = found, texts
        self.columns = found.claim.columns
        self.notation = Notation(found.claim.names, (cell for row in found.rows for cell in row.cells.values()))

    def of_rows(self) -> Iterator[Fault]:
        """Yield what is wrong row by row."""
        for verdict in self.found.verdicts:
            number, frames = verdict.row.number, verdict.row.frames
            if frames is not None and verdict.right is None:
                pair = {"reference": frames.reference, "frame": frames.frame}
                yield Fault(say(Kind.ROW_WITHOUT_DH_FRAMES, number=number, **pair, convention=self.found.convention))
            for parameter in verdict.wrong:
                yield self.wrong_entry(verdict, parameter, self.found.right_value(verdict, parameter))

    def of_kinds(self) -> Iterator[Fault]:
        """Yield wrong kinds of joints (σ_i, R or P) and variables, where the table has columns for them."""
        kind, variable = self.columns.first("sigma"), self.columns.first("q")
        for row in self.found.rows:
            if row.frames is not None and row.frames.joint is not None:
                if kind is not None:
                    yield from self._wrong_kind(row, row.frames.joint, kind)
                if variable is not None and variable != self.found.reading.theta:
                    yield from self._wrong_variable(row, row.frames.joint, variable)

    def wrong_entry(self, verdict: RowVerdict, parameter: str, right: Scalar | None) -> Fault:
        """Return a wrong entry with its correct value and what is wrong with it."""
        column = self.found.reading.columns[parameter]
        cell, number = verdict.row.cells[column], verdict.row.number
        correct = self._correct(right, parameter, column)
        change = self._change(verdict, parameter, right)
        terms = {
            "parameter": letter(self.found, parameter),
            "printed": cell.text or say(Kind.EMPTY),
            "correct": correct,
        }
        if change is None:
            said = say(Kind.TABLE_ENTRY, **terms)
        else:
            said = say(Kind.TABLE_ENTRY_BECAUSE, **terms, change=change)
        entry = WrongEntry(1, number, column + 1, cell.text, correct, change)
        return Fault(said.at(row=number, column=column + 1), (entry,))

    def _correct(self, right: Scalar | None, parameter: str, column: int) -> str:
        if right is None:
            return "another angle"
        if parameter in ANGLES:
            return self.notation.value(right, self._degree_sign(column))
        scale = SCALES.get(self.columns.headers[column].unit, 1)
        return self.notation.value(right / scale if right.as_fraction() is not None else right)

    def _degree_sign(self, column: int) -> str | None:
        """The sign after a number of degrees in a column of angles; None where its angles are in radians."""
        texts = " ".join(row.cells[column].text for row in self.found.rows)
        if sign := _DEGREE_SIGN.search(texts):
            return sign.group().strip()
        unit = self.columns.headers[column].unit
        if "\\pi" in texts or "π" in texts or unit == "rad":
            return None
        return "" if unit == "deg" or _PLAIN_DEGREES.search(texts) else None

    # -- in words ----------------------------------------------------------------------------------------------------

    def _change(self, verdict: RowVerdict, parameter: str, right: Scalar | None) -> Finding | None:
        printed = verdict.values.get(parameter)
        if printed is None:
            return self._change_of_name(verdict, parameter, right)
        if swapped := self._swapped_with(verdict, parameter, printed):
            return say(Kind.PARAMETERS_SWAPPED, one=letter(self.found, parameter), other=letter(self.found, swapped))
        try:
            change = change_of_angle if parameter in ANGLES else change_of_length
            return change(printed, right) if right is not None else None
        except EvaluationError:
            return None

    def _change_of_name(self, verdict: RowVerdict, parameter: str, right: Scalar | None) -> Finding:
        name = verdict.unbound[parameter]
        same = right is not None and any(letter_of(symbol) == letter_of(name) for symbol in symbols_of(right))
        return say(Kind.INDEX_NOT_ON_ARM, name=key_as_latex(name)) if same else verdict.problems[parameter]

    def _swapped_with(self, verdict: RowVerdict, parameter: str, printed: Scalar) -> str | None:
        """The other entry of the row, where two stand in each other's place."""
        right, values = verdict.right, verdict.values
        for other in verdict.wrong:
            if right is None or other == parameter or other not in values:
                continue
            if right.agrees(other, printed) and right.agrees(parameter, values[other]):
                return other
        return None

    # -- other columns -----------------------------------------------------------------------------------------------

    def _wrong_kind(self, row: Row, joint: int, column: int) -> Iterator[Fault]:
        text, kind = self.texts[row.number - 1][column], self.found.arm.joints[joint - 1].kind
        printed, said = plain(text), read_kind(text)
        if said and said != kind:
            number, initial = str(int(kind == "prismatic")), kind[0].upper()
            correct = number if printed in "01" else initial if len(printed) == 1 else kind
            entry = WrongEntry(1, row.number, column + 1, text, correct, say(Kind.JOINT_IS, joint_kind=kind))
            wrong = say(Kind.JOINT_IS_NOT, joint_kind=kind, printed=said)
            yield Fault(wrong.at(row=row.number, column=column + 1), (entry,))

    def _wrong_variable(self, row: Row, joint: int, column: int) -> Iterator[Fault]:
        cell, arm = row.cells.get(column), self.found.arm
        if cell is None or cell.name is None:
            return
        symbol, own = self.found.claim.names.known_symbol(cell.name.key), arm.joints[joint - 1].symbol
        if symbol != own and symbol in {other.symbol for other in arm.joints}:
            correct = self.notation.symbol(own)
            entry = WrongEntry(1, row.number, column + 1, cell.text, correct, say(Kind.OTHER_VARIABLE))
            wrong = say(Kind.WRONG_VARIABLE, printed=cell.text, correct=correct)
            yield Fault(wrong.at(row=row.number, column=column + 1), (entry,))
