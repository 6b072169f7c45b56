"""A task that asks for the Denavit–Hartenberg table of an arm, row by row."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np

from armproof.course.errors import AnswerError
from armproof.course.feedback.answer import as_latex, is_function, is_missing
from armproof.course.feedback.misplaced import in_other_rows, misplaced
from armproof.course.feedback.notebook import Portrait, Shown, as_picture
from armproof.course.feedback.outcome import Feedback, Outcome, nothing
from armproof.models.arm import Arm
from armproof.models.catalogue import load_arm
from armproof.models.dh.entry import LinearForm, read_entry
from armproof.models.dh.table import read_table
from armproof.models.errors import ArmproofError, counted, written
from armproof.models.language import look_up, spoken
from armproof.models.loading.dh_plant import build_arm
from armproof.models.numeric.plant import NumericKinematics
from armproof.verification.check import check_document
from armproof.verification.document import Document
from armproof.verification.document import Table as Printed
from armproof.verification.errors import ReadError
from armproof.verification.findings import Finding, Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.reader import Reader
from armproof.verification.naming.names import Names
from armproof.verification.naming.reading import read_names
from armproof.verification.verdict import Record, Verdict

COLUMNS = {
    "classic": (r"\theta_i", "d_i", "a_i", r"\alpha_i"),
    "modified": (r"\alpha_{i-1}", "a_{i-1}", "d_i", r"\theta_i"),
}
TURN = 6.3  # rad: no constant angle of a table is larger
_FRACTION = re.compile(r"\\[dt]?frac\{([^{}]*)\}\{([^{}]*)\}")
_LETTERS = re.compile(r"(?<![\\A-Za-z_])[A-Za-z](?:_\w+)?(?![A-Za-z])")
_PLAIN = re.compile(r"\s*[-+]?\d+(?:\.\d+)?\s*")
_POSES = 6  # at which two arms are compared
_NEAR = 1e-9
ORDER = {"classic": ("theta", "d", "a", "alpha"), "modified": ("alpha", "a", "d", "theta")}


@dataclass(frozen=True, eq=False)
class Table:
    """The Denavit–Hartenberg table of an arm.

    Attributes:
        arm: the name of the arm.
        convention: "classic" (θ, d, a, α) or "modified" (α_{i-1}, a_{i-1}, d, θ), the order of a row that is a list.
        symbols: letters that an answer may use for the arm's.
        measured: the arm whose lengths the letters have; by default `arm` itself.
    """

    arm: Any
    convention: str
    symbols: Mapping[str, str] = field(default_factory=dict)
    measured: str = ""

    @cached_property
    def loaded(self) -> Arm:
        """The arm."""
        arm = load_arm(self.arm)
        if not self.measured:
            return arm
        return replace(arm, dh=None, lengths=load_arm(self.measured).lengths)  # no table whose letters have any lengths

    def judge(self, answer: Any) -> Feedback:
        """Return what becomes of a table: a list of rows, each {"a": …, "alpha": …, "d": …, "theta": …} or a list in order."""
        rows = self._rows(answer)
        if not rows:
            return nothing()
        if len(rows) != len(self.loaded.joints):
            wanted = len(self.loaded.joints)
            return Feedback(Outcome.WRONG, written("a table has one row a joint: {wanted} rows, not {given}", wanted=wanted, given=len(rows)))  # fmt: skip
        if problem := self._in_degrees(answer) or self._of_other_kind(rows):
            return Feedback(Outcome.WRONG, problem)
        record = self._record(rows)
        if record.verdict is Verdict.PROVED and record.says(Kind.LENGTHS_IN_NUMBERS):
            return Feedback(Outcome.LETTERS, look_up("the numbers are right, in metres: which length is which letter?"))
        if record.verdict is Verdict.PROVED:
            return Feedback(Outcome.PROVED, look_up("every row leads from one frame of the arm to the next"))
        if rows_in_numbers := [f.terms["number"] for f in record.findings if _wants_letter(f)]:
            return Feedback(Outcome.WRONG, written("row {row}: a letter is wanted for the length, not a number", row=rows_in_numbers[0]))  # fmt: skip
        if record.entries and all(entry.finding and entry.finding.kind is Kind.ROUNDED for entry in record.entries):
            return Feedback(Outcome.LETTERS, look_up("right, but rounded: write an angle as pi/2 or np.pi / 2"))
        if record.verdict is Verdict.REFUTED:
            told = self._in_other_order(rows) or self._misplaced(rows, record) or self._sentence(rows, record)
            return Feedback(Outcome.WRONG, told)
        return Feedback(Outcome.ERROR, record.message or look_up("the table cannot be read"))

    def show(self, task: str, answer: Any, at: Mapping[str, float]) -> Shown | Portrait:
        """Return the arm that the answer's table describes, with the table, beside the true one, whose table shows when the answer is right."""
        from armproof.course.figures.kinds.sketch import sketch  # and with it matplotlib

        rows = self._rows(answer)
        spec = {"dh": self.convention, "rows": [dict(zip(ORDER[self.convention], row, strict=True)) for row in rows]}
        try:
            yours = build_arm(read_table(spec), self.loaded.lengths)
            drawn = sketch(yours, spoken())
        except ArmproofError as problem:
            return Shown(written("`{task}`: the answer cannot be drawn: {reason}", task=task, reason=str(problem)))
        right = self.judge(answer).is_right
        true = sketch(self.loaded, spoken(), table=right)
        return Portrait(
            (as_picture(drawn, look_up("The arm of your table")), as_picture(true, look_up("The arm as it is")))
        )

    def signature(self, answer: Any) -> str:
        """Return a table as one text, by which two answers are told apart."""
        return r" \\ ".join(" & ".join(row) for row in self._rows(answer)).replace(" ", "")

    def _record(self, rows: Sequence[Sequence[str]]) -> Record:
        header = ("i", *COLUMNS[self.convention])
        cells = tuple((str(k + 1), *row) for k, row in enumerate(rows))
        front = {"arm": self.arm, "symbols": dict(self.symbols)}
        document = Document(Path("answer"), front, (), (Printed(1, header, cells),))
        result = check_document(document, confirm=False, arm=self.loaded)
        if not result.tables:
            return Record(1, "", Verdict.UNREADABLE, findings=(say(Kind.NO_TABLE),))
        return result.tables[0]

    def _in_other_order(self, rows: Sequence[Sequence[str]]) -> str:
        """Say if the rows are right with their columns in the order of the other convention."""
        (other,) = (order for convention, order in ORDER.items() if convention != self.convention)
        ordered = [[row[other.index(name)] for name in ORDER[self.convention]] for row in rows]
        if self._record(ordered).verdict is not Verdict.PROVED:
            return ""
        return written("your columns are in the order {other}; a row here is {order}",
            other=", ".join(other), order=", ".join(ORDER[self.convention]))  # fmt: skip

    def _in_degrees(self, answer: Any) -> str:
        """Say which number in a column of angles is one of degrees."""
        for number, row in enumerate(answer if isinstance(answer, list | tuple) else ()):
            cells = row if isinstance(row, Mapping) else dict(zip(ORDER[self.convention], row, strict=False))
            for name in ("alpha", "theta"):
                value = cells.get(name)
                if isinstance(value, str) and _PLAIN.fullmatch(value):  # with a degree sign it is what it says
                    value = float(value)
                if isinstance(value, int | float) and abs(value) > TURN:
                    return written("row {row}: {name} = {value:g} is in degrees; angles are in radians, such as pi/2 or np.pi/2", row=number + 1, name=name, value=value)  # fmt: skip
        return ""

    def _of_other_kind(self, rows: Sequence[Sequence[str]]) -> str:
        """Say which length stands in a column of angles, or which angle in one of lengths, or that the columns are in another order."""
        found = next(self._letters_of_other_kind(rows), "")
        return found and (self._in_other_order(rows) or self._of_other_convention(rows) or found)

    def _letters_of_other_kind(self, rows: Sequence[Sequence[str]]) -> Iterator[str]:
        turning = {joint.symbol for joint in self.loaded.joints if joint.kind == "revolute"} | set(self.loaded.angles)
        for number, row in enumerate(rows, 1):
            for name, cell in zip(ORDER[self.convention], row, strict=True):
                keys = [node.key for node in n.walk(Reader().read_expression(cell)) if isinstance(node, n.Name)]
                variables = {joint.symbol for joint in self.loaded.joints}
                for letter in (self._names.known_symbol(key) or key for key in keys if key != "pi"):
                    if name == "alpha" and letter in variables & turning:
                        yield written("row {row}: {letter} is the variable of a joint, and stands in the column of alpha", row=number, letter=letter)  # fmt: skip
                    if name in ("alpha", "theta") and letter not in turning:
                        yield written("row {row}: {letter} is a length, and stands in the column of {name}", row=number, letter=letter, name=name)  # fmt: skip
                    if name in ("a", "d") and letter in turning:
                        yield written("row {row}: {letter} is an angle, and stands in the column of {name}", row=number, letter=letter, name=name)  # fmt: skip

    def _of_other_convention(self, rows: Sequence[Sequence[str]]) -> str:
        """Say if the rows are a table of the arm in the other convention, in its order."""
        (other,) = (convention for convention in ORDER if convention != self.convention)
        joints = [joint.symbol for joint in self.loaded.joints]
        spec = {"dh": other, "rows": [dict(zip(ORDER[other], row, strict=True)) for row in rows], "joints": joints}
        try:
            arm = build_arm(read_table(spec), self.loaded.lengths)
        except ArmproofError:
            return ""
        if [(joint.symbol, joint.kind) for joint in arm.joints] != [(j.symbol, j.kind) for j in self.loaded.joints]:
            return ""
        q = np.random.default_rng(0).uniform(0.2, 1.2, (_POSES, len(joints)))
        poses = [NumericKinematics(each, q).pose(each.frames[len(joints)]) for each in (arm, self.loaded)]
        tool = np.linalg.inv(poses[0]) @ poses[1]
        if np.ptp(tool, axis=0).max() > _NEAR:
            return ""
        return look_up("this is a table of the classic convention, in its order; here the modified one is asked") if other == "classic" else look_up("this is a table of the modified convention, in its order; here the classic one is asked")  # fmt: skip

    def _misplaced(self, rows: Sequence[Sequence[str]], record: Record) -> str:
        """Say which rows, columns or entries are exchanged, or which column stands a row too early or too late."""
        wrong = {(entry.row - 1, entry.column - 2) for entry in record.entries if entry.row and entry.column}
        order = ORDER[self.convention]
        told = misplaced(rows, wrong, order, "0", _negated, lambda other: self._record(other).verdict is Verdict.PROVED)
        if told or len({column for _, column in wrong}) != 1:
            return told
        given, right = ([_form(getattr(entry, side)) for entry in record.entries] for side in ("printed", "correct"))
        return in_other_rows(given, right, order[min(wrong)[1]])

    def _sentence(self, rows: Sequence[Sequence[str]], record: Record) -> str:
        """Name the rows and the parameter that are wrong, not their values; the same mistake of several rows once."""
        if not all(entry.row for entry in record.entries):  # taken for a table of the other convention
            return self._sign_first(rows) or look_up("these rows do not lead from one frame of the arm to the next")
        names = [*("i",), *ORDER[self.convention]]
        where: dict[str, list[int]] = {}
        for entry in record.entries[:4]:
            words = written("{name} is wrong", name=names[(entry.column or 1) - 1])
            why = entry.change or _angle_off(entry.printed, entry.correct) or _too_many(entry.printed, entry.correct)
            change = f"{words} ({why})" if why else words
            where.setdefault(change, []).append(entry.row or 0)
        told = [
            counted("row {rows}: {words}", "rows {rows}: {words}", len(each), rows=each, words=words)
            for words, each in where.items()
        ]
        return look_up("; ").join(told) or record.message

    def _sign_first(self, rows: Sequence[Sequence[str]]) -> str:
        """Name a wrong sign for which rows look like those of the other convention, and what is wrong besides; "" where there is none."""
        for k, row in enumerate(rows):
            for j, name in enumerate(ORDER[self.convention]):
                if name == "theta" or (other := _negated(row[j])) is None:
                    continue
                changed = [[*each] for each in rows]
                changed[k][j] = other
                record = self._record(changed)
                if any(not entry.row or (entry.row, entry.column) == (k + 1, j + 2) for entry in record.entries):
                    continue
                words = written("{name} is wrong", name=name) + f" ({look_up('the sign')})"
                first = counted("row {rows}: {words}", "rows {rows}: {words}", 1, rows=[k + 1], words=words)
                rest = self._sentence(changed, record) if record.verdict is Verdict.REFUTED else ""
                return look_up("; ").join(filter(None, [first, rest]))
        return ""

    def _rows(self, answer: Any) -> list[tuple[str, ...]]:
        if isinstance(answer, str):
            answer = _rows_of(answer)
        if hasattr(answer, "tolist"):
            answer = answer.tolist()
        if is_function(answer):
            answer = answer()
            if is_missing(answer):
                return []
        if isinstance(answer, Mapping) and set(ORDER[self.convention]) <= set(answer):
            answer = list(zip(*(answer[name] for name in ORDER[self.convention]), strict=True))
        if not isinstance(answer, list | tuple):
            raise AnswerError("a table is a list of rows, not a {type}", type=type(answer).__name__)
        return [self._row(row, number + 1) for number, row in enumerate(answer)]

    def _row(self, row: Any, number: int) -> tuple[str, ...]:
        order = ORDER[self.convention]
        if isinstance(row, Mapping):
            missing = [name for name in order if name not in row]
            if missing:
                raise AnswerError("row {number} has no '{column}'; a row has {order}", number=number, column=missing[0], order=list(order))  # fmt: skip
            row = [row[name] for name in order]
        if not isinstance(row, list | tuple) or len(row) != len(order):
            raise AnswerError("row {number} is to hold {count} entries: {order}", number=number, count=len(order), order=list(order))  # fmt: skip
        return tuple(
            self._cell(cell, written("row {row}: {name}", row=number, name=name))
            for name, cell in zip(order, row, strict=True)
        )

    def _cell(self, cell: Any, place: str) -> str:
        """Return a cell as LaTeX; refuse one that is empty, or holds a letter that is none of the arm's."""
        if is_missing(cell):
            raise AnswerError("{place} is empty", place=place)
        latex = as_latex(cell)
        try:
            node = Reader().read_expression(latex)
        except ReadError as error:
            raise AnswerError("{place}: {cell} cannot be read: {reason}", place=place, cell=f"{cell!r:.40}", reason=str(error)) from None  # fmt: skip
        for name in n.walk(node):
            if isinstance(name, n.Name) and self._names.known_symbol(name.key) is None and name.key != "pi":
                raise no_such_letter(place, name.key, self._letters, self.loaded)
        return latex

    @cached_property
    def _names(self) -> Names:
        return read_names(self.loaded, {"symbols": dict(self.symbols)})

    @cached_property
    def _letters(self) -> tuple[str, ...]:
        arm = self.loaded
        return (*(joint.symbol for joint in arm.joints), *arm.lengths, *arm.angles, *self.symbols)


def _negated(cell: str) -> str | None:
    """Return a cell with the other sign; None of zero and of a sum."""
    bare = cell.strip().removeprefix("-").strip()
    if bare == "0" or "+" in bare or "-" in bare:
        return None
    return bare if cell.strip().startswith("-") else f"-{bare}"


def _too_many(printed: str, correct: str) -> str:
    """Return which letters of a cell do not belong in it."""
    given, right = ([*dict.fromkeys(_LETTERS.findall(text))] for text in (printed, correct))
    extra = [letter for letter in given if letter not in right]
    if not extra:
        return ""
    return counted("{letters} does not belong", "{letters} do not belong", len(extra), letters=", ".join(extra))


def _rows_of(text: str) -> list[list[str]]:
    """Return the rows of a LaTeX array or a Markdown table without its header."""
    body = text.strip().strip("$")
    if "\\begin" in body:
        body = body.split("}", 2)[-1] if "\\begin{array}" in body else body.split("}", 1)[-1]
        body = body.rsplit("\\end", 1)[0].replace("\\hline", "")
        rows = [line.split("&") for line in body.split("\\\\") if line.strip()]
    else:
        rows = [line.strip().strip("|").split("|") for line in body.splitlines() if line.strip()]
        rows = [row for row in rows if not set("".join(row)) <= set("-: ")]
    cells = [[cell.strip().strip("$").strip() for cell in row] for row in rows]
    return [row[-4:] for row in cells if not any("_i" in cell or "_{i" in cell for cell in row)]


def no_such_letter(place: str, key: str, letters: Sequence[str], arm: Arm) -> AnswerError:
    """Return what is to be said of a letter that the arm has not; of a slide's angle, or a turn's offset, why."""
    for joint in arm.joints:
        index = joint.symbol.partition("_")[2]
        if index and key.replace("_", "") in (f"theta{index}", f"d{index}"):
            if joint.kind == "prismatic":
                return AnswerError("{place}: joint {index} slides: it has no angle {key}, its variable is {symbol}", place=place, index=index, key=key, symbol=joint.symbol)  # fmt: skip
            return AnswerError("{place}: joint {index} turns: it has no variable offset {key}, its variable is {symbol}", place=place, index=index, key=key, symbol=joint.symbol)  # fmt: skip
    return AnswerError("{place}: there is no letter {key}; the letters are {letters}", place=place, key=key, letters=list(letters))  # fmt: skip


def _wants_letter(finding: Finding) -> bool:
    """Whether a row was left open because a number stands where the arm has a letter."""
    problem = finding.terms.get("problem")
    return isinstance(problem, Finding) and problem.kind is Kind.LENGTH_WITHOUT_VALUE


def _form(cell: str) -> LinearForm | None:
    """Return an entry in LaTeX as a sum of letters, of π and of a number; None where it is none."""
    try:
        form = read_entry(_FRACTION.sub(r"(\1)/(\2)", cell).replace("\\pi", "pi").replace("\\cdot", "*"))
    except ArmproofError:
        return None
    return replace(form, symbols=tuple(sorted(form.symbols)))


def _angle_off(printed: str, correct: str) -> str:
    """Return by how many quarter turns an angle is off; empty of anything else."""
    given, right = _form(printed), _form(correct)
    if given is None or right is None:
        return ""
    if given.symbols != right.symbols or given.number != right.number:
        return ""
    turns = (given.pi - right.pi) * 2
    if turns.denominator != 1 or not turns:
        return ""
    return look_up("half a turn off") if turns % 4 == 2 else look_up("a quarter turn off") if turns % 2 else ""
