"""The whole course at a glance: a bar and the points of each lesson, a point a task that is solved."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from armproof.course.feedback.lesson import Lesson, lessons
from armproof.course.feedback.notebook import bar, render
from armproof.models.errors import written


@dataclass(frozen=True)
class Overview:
    """What of a course is solved."""

    lessons: Sequence[Lesson]

    @property
    def points(self) -> tuple[int, int]:
        """The points that are reached, and those of all tasks."""
        return sum(lesson.points for lesson in self.lessons), sum(len(lesson.tasks) for lesson in self.lessons)

    def __repr__(self) -> str:
        rows = [
            f"{bar(each.points, len(each.tasks))}  {each.number:2} · {each.title} ({each.effort})"
            for each in self.lessons
        ]
        points = self.points
        return "\n".join([*rows, "", f"{bar(*points)}  {_total(*points)}"])

    def _repr_html_(self) -> str:
        points = self.points
        return render("overview.html", "open", lessons=self.lessons, points=points, total=_total(*points), bar=bar)


def _total(reached: int, count: int) -> str:
    return written("{reached} of {count} points", reached=reached, count=count)


def course() -> Overview:
    """Return what of the course is solved."""
    return Overview(lessons())
