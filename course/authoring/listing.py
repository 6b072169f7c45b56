"""One line a lesson: number, name, title, how many tasks, which arms."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

from armproof.course.authoring.checking.tasks import load_tasks
from armproof.course.sources.lesson_source import read_lesson_source
from armproof.course.sources.places import Place

if TYPE_CHECKING:
    from armproof.course.feedback import Lesson


def described(place: Place, source: Path) -> tuple[str, str, str, str, str]:
    """Return what the list says of a lesson; raises SourceError where its source or its tasks are malformed."""
    lesson = load_tasks(place, read_lesson_source(source))
    arms = ", ".join(dict.fromkeys(_arms(lesson))) or "none"
    return str(lesson.number), lesson.name, lesson.title, str(len(lesson.tasks)), arms


def _arms(lesson: Lesson) -> Iterator[str]:
    """Yield the arms that the tasks ask about."""
    for task in lesson.tasks:
        arm: Any = getattr(task.asks, "arm", None)
        if arm is not None:
            yield arm if isinstance(arm, str) else "a DH table"
