"""Read the table *source line → sheet → task*, and say what in it does not stand."""

from __future__ import annotations

import csv
from collections import Counter
from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass
from enum import StrEnum
from pathlib import Path

from armproof.models.errors import written
from armproof.models.language import look_up, noted, spoken

EXERCISES = Path(__file__).resolve().parent / "exercises.csv"


class Status(StrEnum):
    """Whether a line is an exercise, and whether the course asks it."""

    ASKED = "asked"
    OPEN = "open"  # an exercise that no task asks yet
    NONE = "none"  # titles, history, headings: nothing to ask


_SAID = {Status.ASKED: noted("asked"), Status.OPEN: noted("open"), Status.NONE: noted("nothing to ask")}


@dataclass(frozen=True)
class Exercise:
    """A line of a source document and what the course makes of it.

    Attributes:
        document: its number, such as 001.
        lines: those of its text, such as 214-217.
        status: whether there is something to ask, and whether it is asked.
        sheets: the names of handouts.
        tasks: each as lesson.task.
        words: what is to be done there, in our words, by language.
    """

    document: str
    lines: str
    status: Status
    sheets: tuple[str, ...]
    tasks: tuple[str, ...]
    words: dict[str, str]

    @property
    def citation(self) -> str:
        """Where it stands: 001:214-217."""
        return f"{self.document}:{self.lines}"

    def row(self) -> tuple[str, ...]:
        """Return its cells in the language that is spoken."""
        words = self.words.get(spoken()) or self.words["en"]
        return self.citation, look_up(_SAID[self.status]), words, ", ".join(self.sheets), ", ".join(self.tasks)


def read_exercises() -> tuple[Exercise, ...]:
    """Return the rows of the table in their order."""
    with EXERCISES.open(encoding="utf-8", newline="") as file:
        return tuple(map(_read, csv.DictReader(file)))


def _read(row: dict[str, str]) -> Exercise:
    words = {"en": row["en"], "fr": row["fr"]}
    sheets, tasks = tuple(row["sheets"].split()), tuple(row["tasks"].split())
    return Exercise(row["document"], row["lines"], Status(row["status"]), sheets, tasks, words)


def faults(exercises: Sequence[Exercise], sheets: Collection[str], tasks: Collection[str]) -> Iterator[str]:
    """Yield what does not stand: a sheet or a task that does not exist, a line that is called asked and has no task.

    Args:
        sheets: the names of the handouts that there are.
        tasks: the tasks that there are, each as lesson.task.
    """
    for exercise in exercises:
        at = exercise.citation
        yield from (written("{at}: there is no sheet {sheet}", at=at, sheet=sheet)
                    for sheet in exercise.sheets if sheet not in sheets)  # fmt: skip
        yield from (written("{at}: there is no task {task}", at=at, task=task)
                    for task in exercise.tasks if task not in tasks)  # fmt: skip
        if (exercise.status is Status.ASKED) != bool(exercise.tasks):
            yield written("{at}: a line is asked if a task asks it, and only then", at=at)


def count(exercises: Sequence[Exercise]) -> Counter[Status]:
    """Return how many lines are asked, are open, are no exercise."""
    return Counter(exercise.status for exercise in exercises)
