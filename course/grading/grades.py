"""The results of a class, with what tasks count and until when they were due."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from datetime import datetime
from functools import cached_property

from armproof.course.grading.glance import Key, best_results
from armproof.course.grading.results import Graded, TaskResult
from armproof.course.grading.sandbox.limits import Limits
from armproof.course.grading.weights import Points, Weights


@dataclass(frozen=True)
class Grades:
    """The results of a class.

    Attributes:
        graded: in the order of its submissions.
        held: which protections were in force.
        limits: of each submission.
        weights: what each task counts.
        due: until when submissions were in time.
    """

    graded: tuple[Graded, ...]
    held: dict[str, bool]
    limits: Limits
    weights: Weights = field(default_factory=Weights)
    due: datetime | None = None

    @cached_property
    def best(self) -> Mapping[str, Mapping[Key, TaskResult]]:
        """The best result of each student in each task."""
        return best_results(self.graded)

    @cached_property
    def tasks(self) -> tuple[Key, ...]:
        """All that counts: each task of each lesson that someone handed in, and of the file of weights."""
        handed_in = (key for own in self.best.values() for key in own)
        return tuple(dict.fromkeys([*handed_in, *(self.weights.by_task or ())]))

    def points(self, student: str, lesson: str = "") -> Points:
        """Return the points of a student in one lesson, or in all."""
        return self.weights.points(self.best[student], [key for key in self.tasks if lesson in ("", key[0])])

    def handed_in(self, student: str, lesson: str) -> datetime | None:
        """Return when a student handed a lesson in, at last."""
        times = [
            each.submission.handed_in
            for each in self.graded
            if each.submission.student == student and any(result.lesson == lesson for result in each.results)
        ]
        return max((time for time in times if time is not None), default=None)
