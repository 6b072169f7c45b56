"""Try the answers that tasks declare: the right ones are to be accepted, the wrong ones to get their words."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager
from importlib.util import find_spec
from typing import TYPE_CHECKING, Any

from armproof.course.authoring.checking.tasks import task_lines, tasks_file
from armproof.course.sources.lesson_source import LessonSource
from armproof.course.sources.places import Place

if TYPE_CHECKING:
    from armproof.course.feedback import Feedback, Lesson, Task


def check_answers(place: Place, source: LessonSource, lesson: Lesson) -> Iterator[str]:
    """Yield what is wrong with the answers of a lesson's tasks, as "file:line: message"."""
    file = tasks_file(place, source.name)
    lines = task_lines(file)
    with progress_left_alone():
        for task in lesson.tasks:
            for problem in _of_task(task):
                yield f"{file}:{lines.get(task.name, 1)}: task '{task.name}': {problem}"


def count_answers(lesson: Lesson) -> tuple[int, int]:
    """Return how many right and wrong answers the tasks declare."""
    return sum(len(task.right) for task in lesson.tasks), sum(len(task.wrong) for task in lesson.tasks)


@contextmanager
def progress_left_alone() -> Iterator[None]:
    """Keep no progress for a while: whoever tries answers is no student."""
    from armproof.course.feedback.progress import VARIABLE

    before = os.environ.get(VARIABLE)
    os.environ[VARIABLE] = ""
    try:
        yield
    finally:
        if before is None:
            del os.environ[VARIABLE]
        else:
            os.environ[VARIABLE] = before


def _of_task(task: Task) -> Iterator[str]:
    from armproof.course.feedback import Outcome, WithSympy

    for number, answer in enumerate(task.right, 1):
        if isinstance(answer, WithSympy) and find_spec("sympy") is None:
            continue
        feedback = task.check(answer)
        if not feedback.is_right:
            yield f"right answer {number}, {_shown(answer)}: {_told(feedback)}"
    for number, wrong in enumerate(task.wrong, 1):
        feedback = task.check(wrong.answer)
        what = f"wrong answer {number}, {_shown(wrong.answer)}"
        if feedback.is_right or feedback.outcome is Outcome.NOT_ATTEMPTED:
            yield f"{what}: {_told(feedback)}"
        elif wrong.words not in feedback.message:
            yield f"{what}: expected the words '{wrong.words}', got {_told(feedback)}"


def _told(feedback: Feedback) -> str:
    return f"{feedback.outcome.value}: {feedback.message}" if feedback.message else feedback.outcome.value


def _shown(answer: Any) -> str:
    """Return an answer in a few characters."""
    if callable(answer):
        return f"the function {getattr(answer, '__name__', '')}".strip()
    text = " ".join(str(answer).split())
    return text if len(text) <= 50 else text[:49] + "…"
