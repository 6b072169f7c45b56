"""What became of an answer: the outcome, one sentence, and the numbers where it is wrong."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum
from typing import Any

from armproof.verification.functions.function_check import FunctionVerdict
from armproof.verification.functions.guarded_call import CallError
from armproof.verification.report.html.figures import Figure


class Outcome(StrEnum):
    """What became of an answer, from best to worst."""

    PROVED = "correct (proved)"
    CONFIRMED = "correct (confirmed)"
    NOT_ATTEMPTED = "not attempted"
    WRONG = "wrong"
    ERROR = "error"


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
        seconds: how long the check took.
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
    seconds: float = 0.0

    @property
    def is_right(self) -> bool:
        """Whether the answer is correct, proved or confirmed."""
        return self.outcome in (Outcome.PROVED, Outcome.CONFIRMED)

    def as_json(self) -> dict[str, Any]:
        """Return the feedback as JSON writes it, without its picture."""
        return {
            "lesson": self.lesson,
            "task": self.task,
            "outcome": self.outcome.value,
            "message": self.message,
            "rows": [
                {"entry": row.entry, "expected": row.expected, "obtained": row.obtained, "unit": row.unit}
                for row in self.rows
            ],
            "at": dict(self.at),
            "notes": list(self.notes),
            "error": None if self.error is None else {"type": self.error.type, "line": self.error.line},
            "seconds": self.seconds,
        }

    def __str__(self) -> str:
        from armproof.course.feedback.text import write_text

        return write_text(self)

    __repr__ = __str__

    def _repr_html_(self) -> str:
        from armproof.course.feedback.html import write_html

        return write_html(self)


NOTHING = Feedback(Outcome.NOT_ATTEMPTED, "no answer yet")
