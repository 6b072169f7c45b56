"""What each task counts, and the points of a student."""

from __future__ import annotations

import csv
import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from armproof.course.errors import GradingError
from armproof.course.grading.glance import Key
from armproof.course.grading.results import TaskResult

COLUMNS = ("lesson", "task", "weight")


@dataclass(frozen=True)
class Points:
    """What a student reached of what can be reached."""

    reached: float
    most: float

    @property
    def percent(self) -> float:
        """The same of a hundred."""
        return 100 * self.reached / self.most if self.most else 0.0


@dataclass(frozen=True)
class Weights:
    """What each task counts: 1 unless a file says otherwise; then nothing counts that it does not name.

    Attributes:
        by_task: of a lesson and a task; None without a file.
    """

    by_task: Mapping[Key, float] | None = None

    def of(self, key: Key) -> float:
        """Return what a task counts."""
        return 1.0 if self.by_task is None else self.by_task.get(key, 0.0)

    def points(self, own: Mapping[Key, TaskResult], tasks: Iterable[Key]) -> Points:
        """Return the points of a student in some tasks; what was not handed in has none."""
        count = {key: self.of(key) for key in tasks}
        return Points(sum(count[key] for key in count if key in own and own[key].is_right), sum(count.values()))


def read_weights(path: Path, catalogue: Sequence[Mapping[str, Any]]) -> Weights:
    """Read a table with a line a task: lesson, task, weight; a line without a task is for all tasks of the lesson.

    Raises:
        GradingError: it cannot be read, names a lesson or task that there is not, or a weight is none.
    """
    try:
        with path.open(encoding="utf-8-sig", newline="") as file:
            lines = list(csv.DictReader(file))
    except (OSError, UnicodeDecodeError, csv.Error) as error:
        raise GradingError("{path}: the weights cannot be read: {reason}", path=path, reason=getattr(error, "strerror", None) or str(error)) from None  # fmt: skip
    tasks = {lesson["name"]: [task["name"] for task in lesson["tasks"]] for lesson in catalogue}
    found: dict[Key, float] = {}
    for number, line in enumerate(lines, 2):
        where = f"{path}:{number}"
        lesson, task, weight = ((line.get(column) or "").strip() for column in COLUMNS)
        if lesson not in tasks:
            raise GradingError("{where}: there is no lesson '{name}'; the columns are {columns}, and the lessons {names}",
                where=where, name=lesson, columns=list(COLUMNS), names=list(tasks))  # fmt: skip
        if task and task not in tasks[lesson]:
            raise GradingError("{where}: lesson '{lesson}' has no task '{name}'; its tasks are {names}",
                where=where, lesson=lesson, name=task, names=tasks[lesson])  # fmt: skip
        named = {(lesson, each): _number(weight, where) for each in ([task] if task else tasks[lesson])}
        found = found | named if task else named | found  # a line of one task wins over that of its lesson
    return Weights(found)


def _number(text: str, where: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not 0 <= value < 1e6:
        raise GradingError("{where}: '{text}' is no weight; a weight is a number from 0 on, such as 1 or 2.5", where=where, text=text)  # fmt: skip
    return value
