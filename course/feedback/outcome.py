"""What became of an answer: the outcome, one sentence, and the numbers where it is wrong; as text, HTML and JSON."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, field, replace
from enum import StrEnum
from typing import Any

from markupsafe import Markup, escape

from armproof.course.feedback.notebook import render
from armproof.models.errors import counted, written
from armproof.models.language import look_up, number_text, separator, use
from armproof.verification.findings import Finding, Kind, say
from armproof.verification.findings.finding import Audience, distinct, write
from armproof.verification.functions.function_check import FunctionVerdict
from armproof.verification.functions.guarded_call import CallError
from armproof.verification.latex.greek import GREEK, one_of
from armproof.verification.report.html.figures import Figure
from armproof.verification.verdict import WrongEntry

ASKED = r"\Xi"  # the name that what is asked has in a claim; no course uses it
MOST_PLACES = 4
GENERAL = (
    Kind.UNEQUAL,
    Kind.NOT_FINITE,
    Kind.WRONG_VALUE,
    Kind.ONE_WRONG_ENTRY,
    Kind.ONLY_WRONG_ENTRY,
    Kind.FEW_WRONG_ENTRIES,
    Kind.WRONG_ENTRIES,
    Kind.WRONG_ENTRIES_AT,
    Kind.LINK_ENTRIES,
    Kind.LINK_MOST_ENTRIES,
)  # where no mistake is recognised
_VAGUE = (Kind.OTHER_BASE, Kind.OTHER_TOOL)  # so is a transform whose rows have changed places
MOST_ROWS = 8
_NOTHING = 1e-12
_SYMBOL = re.compile(rf"(?<![A-Za-z\\])\\?({one_of(GREEK)}|[A-Za-zΑ-ωϑ])_(?:(\d+)|\{{(\d+)\}})(?:(?!\w)|(?=[A-Za-z]_))")
_LETTER = re.compile(rf"\\({one_of(GREEK)})(?![A-Za-z])")
_FUNCTION = re.compile(r"\\(sin|cos|tan|arcsin|arccos|arctan)(?![A-Za-z])")
_POWER = re.compile(r"(?<=[\w)₀-₉])\^(\d)(?![\w.])")
_ABOVE = str.maketrans("0123456789", "⁰¹²³⁴⁵⁶⁷⁸⁹")
_BEGINS_WITH_WORD = re.compile(  # theta_1, θ and z × p stay as they are
    r"(?:[a-zà-ÿ]{2,}|a(?= [a-z]{2}))(?!\w)|(?:qu|[cdjlmnst])['’](?=[a-zà-ÿ])"
)
_CODE = re.compile(r"`([^`]*)`")
_BELOW = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")


class Outcome(StrEnum):
    """What became of an answer, from best to worst."""

    PROVED = "correct (proved)"
    CONFIRMED = "correct (confirmed)"
    NOT_ATTEMPTED = "not attempted"
    LETTERS = "in letters, please"
    WRONG = "wrong"
    ERROR = "error"

    @property
    def is_right(self) -> bool:
        """Whether the answer is correct, proved or confirmed."""
        return self in (Outcome.PROVED, Outcome.CONFIRMED)

    @property
    def words(self) -> str:
        """The outcome in the language that is spoken."""
        return look_up(self.value)

    @property
    def mark(self) -> str:
        """The sign before it: colour alone tells nothing to many."""
        return {"not attempted": "○", "in letters, please": "≈", "wrong": "✗", "error": "!"}.get(self.value, "✓")

    @property
    def kind(self) -> str:
        """The kind of the block that shows it in HTML."""
        return {
            "not attempted": "open", "in letters, please": "error", "wrong": "wrong", "error": "error"
        }.get(self.value, "right")  # fmt: skip


OF_FUNCTION = {
    FunctionVerdict.PROVED: Outcome.PROVED,
    FunctionVerdict.CONFIRMED: Outcome.CONFIRMED,
    FunctionVerdict.NOT_ATTEMPTED: Outcome.NOT_ATTEMPTED,
    FunctionVerdict.REFUTED: Outcome.WRONG,
    FunctionVerdict.ERROR: Outcome.ERROR,
}


@dataclass(frozen=True)
class Row:
    """One wrong entry in numbers, at the configuration of the feedback; `obtained` may be a text where it is no number."""

    entry: str
    expected: float | str
    obtained: float | str
    unit: str = "–"

    @property
    def cells(self) -> tuple[str, str, str, str]:
        """The row as it is shown."""
        return self.entry, _number(self.expected), _number(self.obtained), self.unit


@dataclass(frozen=True)
class Feedback:
    """What a student is told of an answer.

    Attributes:
        outcome: what became of it.
        message: one sentence: for which values it is proved, or the likely mistake.
        rows: the wrong entries at the most telling configuration.
        at: that configuration (rad, m), and the values of other letters.
        picture: the student's answer beside the arm's at that configuration.
        notes: what is no mistake, but worth knowing.
        error: what a function raised, and in which line of the student's.
        printed: what the function printed.
        task, lesson: to what it is the answer.
        lang: the language it is written in; empty: that which is spoken.
        seconds: how long the check took.
        findings: what the message says of a wrong formula or function.
        is_first: whether it is of the first wrong answer to the task: the values expected are held back.
        advice: what helps on, Markdown.
    """

    outcome: Outcome
    message: str = ""
    rows: tuple[Row, ...] = ()
    at: Mapping[str, float] = field(default_factory=dict)
    picture: Figure | None = None
    notes: tuple[str, ...] = ()
    error: CallError | None = None
    printed: str = ""
    task: str = ""
    lesson: str = ""
    lang: str = ""
    seconds: float = 0.0
    findings: tuple[Finding, ...] = ()
    is_first: bool = False
    advice: str = ""

    @property
    def is_right(self) -> bool:
        """Whether the answer is correct, proved or confirmed."""
        return self.outcome.is_right

    @property
    def is_piecemeal(self) -> bool:
        """Whether no one mistake explains a wrong answer: none is recognised, one an entry, or one of some entries alone."""
        of_some = len(self.rows) > len(self.findings) and any(map(_has_place, self.findings))
        vague = (self.is_general, len(self.findings) > 1, of_some, any(found.kind in _VAGUE for found in self.findings))
        return self.outcome is Outcome.WRONG and any(vague)

    @property
    def is_general(self) -> bool:
        """Whether the answer is wrong, and no mistake is recognised in it."""
        return self.outcome is Outcome.WRONG and any(_is_general(finding) for finding in self.findings)

    def as_json(self) -> dict[str, Any]:
        """Return the feedback as JSON writes it, without its picture."""
        return {
            "lesson": self.lesson,
            "task": self.task,
            "outcome": self.outcome.value,
            "message": self.message,
            "rows": [asdict(row) for row in self.rows],
            "at": dict(self.at),
            "notes": list(self.notes),
            "error": None if self.error is None else {"type": self.error.type, "line": self.error.line},
            "seconds": self.seconds,
        }

    def __str__(self) -> str:
        """Return the feedback as lines for a terminal: outcome and sentence, the configuration, the table."""
        with use(self.lang):
            return self._written()

    def _written(self) -> str:
        task = written("{task}: ", task=self.task) if self.task else ""
        words = f" – {pretty(self.message)}" if self.message else ""
        lines = [f"{self.outcome.mark} {task}{self.outcome.words}{words}"]
        if self.rows:
            at = written("at {configuration}", configuration=self._configuration) if self.at else ""
            lines += ["", f"    {at}".rstrip(), *_aligned([self._columns, *self._shown])]
            lines += [f"    {self._rest}"] if self._rest else []
        lines += [f"    {written('note: {note}', note=pretty(note))}" for note in self.notes]
        if self.error is not None and self.error.source:
            lines.append(f"    {written('line {line}: {source}', line=self.error.line, source=self.error.source)}")
        lines += ["", f"    {self.advice}"] if self.advice else []
        return "\n".join(lines)

    __repr__ = __str__

    def _repr_html_(self) -> str:
        with use(self.lang):
            return render(
                "feedback.html", self.outcome.kind, outcome=self.outcome, task=self.task,
                message=_sentence(self.message), columns=self._columns, rows=self._shown, rest=self._rest,
                at=self._configuration, picture=self.picture, notes=[_sentence(note) for note in self.notes],
                error=self.error, advice=_with_code(self.advice),
            )  # fmt: skip

    @property
    def _shown(self) -> list[tuple[str, ...]]:
        return [self._without_expected(row.cells) for row in self.rows[:MOST_ROWS]]

    @property
    def _columns(self) -> tuple[str, ...]:
        return self._without_expected((look_up("entry"), look_up("expected"), look_up("obtained"), look_up("unit")))

    def _without_expected(self, cells: tuple[str, ...]) -> tuple[str, ...]:
        return (cells[0], *cells[2:]) if self.is_first else cells

    @property
    def _rest(self) -> str:
        left = len(self.rows) - MOST_ROWS
        return written("and {number} more", number=left) if left > 0 else ""

    @property
    def _configuration(self) -> str:
        values = [f"{GREEK.get(name, name)} = {number_text(value, '.4g')}" for name, value in self.at.items()]
        return pretty(separator(values).join(values))


def _is_general(finding: Finding) -> bool:
    """Whether a finding, or the one within it, says where a mistake is and not which it is."""
    inner = [term for term in finding.terms.values() if isinstance(term, Finding)]
    if finding.kind is Kind.SEVERAL_LENGTHS:  # lengths in numbers that make it right by chance
        return any(each.kind in (Kind.OTHER_NUMBER, Kind.SEVERAL_LENGTHS) for each in inner)
    return finding.kind in GENERAL or any(each.kind in GENERAL for each in inner)


def nothing() -> Feedback:
    """Return the feedback on no answer."""
    return Feedback(Outcome.NOT_ATTEMPTED, look_up("no answer yet"))


def pretty(text: str) -> str:
    """Return a text with its symbols as they are printed: theta_1 as θ₁, S_{12} as S₁₂, a_1^2 as a₁², \\psi as ψ."""
    text = _SYMBOL.sub(lambda found: GREEK.get(found[1], found[1]) + (found[2] or found[3]).translate(_BELOW), text)
    text = _POWER.sub(lambda found: found[1].translate(_ABOVE), text)
    return _LETTER.sub(lambda found: GREEK[found[1]], _FUNCTION.sub(r"\1", text))


def _sentence(text: str) -> str:
    return pretty(text[:1].upper() + text[1:] if _BEGINS_WITH_WORD.match(text) else text)


def _number(value: float | str) -> str:
    """Return a number as it is shown: four digits, what rounding left of a zero as 0, or the text as it is."""
    return value if isinstance(value, str) else number_text(value if abs(value) > _NOTHING else 0, ".4g")


def _with_code(text: str) -> Markup:
    """Return a sentence as HTML, what stands between backticks as code."""
    return Markup(_CODE.sub(r"<code>\1</code>", str(escape(text))))


def _aligned(cells: list[tuple[str, ...]]) -> list[str]:
    """Return the lines of a table in columns of one width."""
    widths = [max(len(line[k]) for line in cells) for k in range(len(cells[0]))]
    lines = ["    " + "  ".join(cell.ljust(width) for cell, width in zip(line, widths, strict=True)) for line in cells]
    return [line.rstrip() for line in lines]


def told(findings: Sequence[Finding], entries: Sequence[WrongEntry]) -> tuple[Finding, ...]:
    """Return what is wrong, without the right term and without our proof's own concerns; else where it is wrong."""
    places = [(entry.row, entry.column) for entry in entries]
    if said := [finding for finding in findings if finding.is_told and not _is_copy(finding, places)]:
        return without_asked(said)
    if not places or places == [(None, None)]:
        return (say(Kind.UNEQUAL),)
    if len(places) == 1:
        return (say(Kind.ONLY_WRONG_ENTRY).at(row=places[0][0], column=places[0][1]),)
    if len(places) <= MOST_PLACES:
        return (say(Kind.FEW_WRONG_ENTRIES, places=[place(row, column) for row, column in places]),)
    return (say(Kind.WRONG_ENTRIES, count=len(places)),)


def _is_copy(finding: Finding, wrong: Sequence[tuple[int | None, int | None]]) -> bool:
    """Whether a finding says that an entry belongs where it stands already: a student wonders at that."""
    if finding.kind is not Kind.OF_ANOTHER_ENTRY:
        return False
    return (finding.terms["other_row"], finding.terms["other_column"]) not in wrong


def said_of(findings: Sequence[Finding]) -> str:
    """Return findings in words for a student, the same of several entries once."""
    places: dict[str, list[str]] = {}
    whole: dict[str, str] = {}
    for finding in distinct(findings, Audience.STUDENT):
        words = write(replace(finding, row=None, column=None), Audience.STUDENT) if _has_place(finding) else ""
        key = words or write(finding, Audience.STUDENT)
        places.setdefault(key, []).extend([place(finding.row, finding.column)] if words else [])
        whole.setdefault(key, write(finding, Audience.STUDENT))
    return look_up("; ").join(
        counted("entry {places}: {words}", "entries {places}: {words}", len(where), places=", ".join(where), words=words)
        if len(where) > 1 else whole[words]
        for words, where in places.items()
    )  # fmt: skip


def _has_place(finding: Finding) -> bool:
    """Whether a finding is of an entry, whose place is put before its words."""
    return finding.row is not None and finding.column is not None and "{row}" not in finding.kind.template


def place(row: int | None, column: int | None) -> str:
    """Return an entry's place (from 1) as the student reads it."""
    return look_up("value") if row is None or column is None else f"({row}, {column})"


def without_asked(findings: Sequence[Finding]) -> tuple[Finding, ...]:
    """Return findings without the name that a claim gives to what is asked."""
    asked = look_up("what is asked")
    return tuple(finding.renamed(ASKED, asked).renamed("Xi", asked) for finding in findings)
