"""The class at a glance: what became of each task, and which mistakes how many students made."""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

from armproof.course.grading.reports import NOT_ATTEMPTED, OUTCOMES
from armproof.course.grading.results import Graded, TaskResult
from armproof.models.language import look_up

Key = tuple[str, str]  # a lesson and a task
_RANK = {outcome: rank for rank, outcome in enumerate((*OUTCOMES[:4], "error", NOT_ATTEMPTED))}


@dataclass(frozen=True)
class Mistake:
    """What was said of wrong answers to a task, and whose they were; each student counts once.

    Attributes:
        task: one of the results, for the names of the task.
        message: what was said.
        results: of the students who made it.
        of: how many handed the lesson in.
    """

    task: TaskResult
    message: str
    results: dict[str, TaskResult]
    of: int

    @property
    def students(self) -> tuple[str, ...]:
        """Who made it."""
        return tuple(self.results)

    @property
    def is_shared(self) -> bool:
        """Whether several students made it."""
        return len(self.results) > 1


@dataclass(frozen=True)
class TaskOfClass:
    """A task with the best result of each student who handed its lesson in."""

    number: int
    results: dict[str, TaskResult]

    @cached_property
    def any(self) -> TaskResult:
        """One of the results, for the names of the task."""
        return next(iter(self.results.values()))

    @cached_property
    def counts(self) -> dict[str, int]:
        """How many students there are of each outcome, in the order of the outcomes."""
        found = Counter(result.outcome for result in self.results.values())
        return {outcome: found[outcome] for outcome in _RANK if found[outcome]}

    @property
    def right(self) -> int:
        """How many students have it right."""
        return sum(result.is_right for result in self.results.values())

    @property
    def attempts(self) -> float:
        """The mean number of answers of those who tried."""
        tried = [result.attempts for result in self.results.values() if result.attempts]
        return sum(tried) / len(tried) if tried else 0.0

    @cached_property
    def mistakes(self) -> tuple[Mistake, ...]:
        """The mistakes that its students made."""
        made: dict[str, dict[str, TaskResult]] = defaultdict(dict)
        for student, result in self.results.items():
            for message in result.mistakes:
                made[message or look_up("wrong, and no mistake is recognised")][student] = result
        return tuple(Mistake(self.any, message, each, len(self.results)) for message, each in made.items())


@dataclass(frozen=True)
class LessonOfClass:
    """A lesson with its tasks, and the students who handed it in."""

    title: str
    tasks: tuple[TaskOfClass, ...]
    students: tuple[str, ...]

    @cached_property
    def mistakes(self) -> tuple[Mistake, ...]:
        """The mistakes in all tasks, those that most students made first."""
        return tuple(
            sorted((each for task in self.tasks for each in task.mistakes), key=lambda each: -len(each.results))
        )

    @property
    def outcomes(self) -> list[str]:
        """The outcomes that there are."""
        return [outcome for outcome in _RANK if any(outcome in task.counts for task in self.tasks)]


def best_results(graded: Sequence[Graded]) -> dict[str, dict[Key, TaskResult]]:
    """Return the best result of each student in each task, and of equals the last; those who have none stand there too."""
    best: dict[str, dict[Key, TaskResult]] = {}
    for each in graded:
        own = best.setdefault(each.submission.student, {})
        for result in each.results:
            key = result.lesson, result.task
            if key not in own or _RANK[result.outcome] <= _RANK[own[key].outcome]:
                own[key] = result
    return best


def at_a_glance(graded: Sequence[Graded]) -> tuple[LessonOfClass, ...]:
    """Return the lessons that were handed in, in the order of their numbers."""
    tasks: dict[str, dict[str, dict[str, TaskResult]]] = defaultdict(lambda: defaultdict(dict))
    for student, own in best_results(graded).items():
        for (lesson, task), result in own.items():
            tasks[lesson][task][student] = result
    found = []
    for of_lesson in tasks.values():
        each = tuple(TaskOfClass(number, results) for number, results in enumerate(of_lesson.values(), 1))
        found.append(LessonOfClass(each[0].any.lesson_title, each, tuple(each[0].results)))
    return tuple(sorted(found, key=lambda lesson: int(lesson.title.split(" ")[0])))
