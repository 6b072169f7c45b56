"""What grading finds out of one submission."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum

from armproof.course.grading.submissions import Submission


class Status(StrEnum):
    """What became of the run of a submission."""

    GRADED = "graded"
    TIMED_OUT = "timed out"
    OUT_OF_MEMORY = "out of memory"
    CRASHED = "crashed"
    TOO_MUCH_OUTPUT = "too much output"
    UNREADABLE = "unreadable"


@dataclass(frozen=True)
class Picture:
    """An answer drawn over the arm, as SVG, and the words below it."""

    svg: str
    caption: str


@dataclass(frozen=True)
class TaskResult:
    """What became of one task.

    Attributes:
        lesson, task, title: which it is.
        lesson_title: with the lesson's number.
        outcome, message, answer, picture: of the last check.
        attempts: how many answers the notebook checks.
        mistakes: what was said of the wrong ones among them, each once.
    """

    lesson: str
    task: str
    title: str
    lesson_title: str
    outcome: str
    message: str = ""
    answer: str = ""
    attempts: int = 0
    mistakes: tuple[str, ...] = ()
    picture: Picture | None = None

    @property
    def is_right(self) -> bool:
        """Whether the answer is correct, proved or confirmed."""
        return self.outcome in ("correct (proved)", "correct (confirmed)")


@dataclass(frozen=True)
class CellError:
    """What a cell raised; line 0 where none of the cell's own is known."""

    cell: int
    line: int
    type: str
    message: str


@dataclass(frozen=True)
class Graded:
    """One submission with its results.

    Attributes:
        submission: whose it is.
        status: what became of its run.
        reason: one sentence where it is not simply graded.
        lessons: the titles of the lessons that it works on.
        results: one for each task of these lessons.
        errors: what cells raised.
        notes: what was skipped.
        remarks: what a teacher should look at.
        output: the beginning of what it printed.
        seconds: of wall clock.
        starved: whether it timed out with little time of a processor: others that ran beside it may have taken it.
    """

    submission: Submission
    status: Status
    reason: str = ""
    lessons: tuple[str, ...] = ()
    results: tuple[TaskResult, ...] = ()
    errors: tuple[CellError, ...] = ()
    notes: tuple[str, ...] = ()
    remarks: tuple[str, ...] = ()
    output: str = ""
    seconds: float = 0.0
    starved: bool = False

    @property
    def needs_a_look(self) -> bool:
        """Whether a teacher should look at it: it was not simply graded, or there is a remark."""
        return self.status is not Status.GRADED or bool(self.remarks)

    @property
    def right(self) -> int:
        """How many tasks are right."""
        return sum(result.is_right for result in self.results)
