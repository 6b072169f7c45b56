"""The tasks of a lesson, as its module declares them, and the line of each."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

from armproof.course.errors import SourceError
from armproof.course.sources.lesson_source import LessonSource, read_lesson_source
from armproof.course.sources.places import Place
from armproof.models.language import look_up, spoken, use

if TYPE_CHECKING:
    from armproof.course.feedback import Lesson


def tasks_file(place: Place, name: str) -> Path:
    """Return the module of a lesson's tasks."""
    return place.tasks / f"{name}.py"


def load_tasks(place: Place, source: LessonSource, lang: str = "") -> Lesson:
    """Return the lesson that the tasks' module declares, in a language or that which is spoken; raises SourceError where that cannot be done."""
    from armproof.course.feedback import LessonError, open_lesson

    file = tasks_file(place, source.name)
    if not file.is_file():
        raise SourceError(source.path, 1, "the lesson has no tasks; expected the file {file}", file=file)
    try:
        with use(spoken()):  # an open lesson speaks its language from there on
            lesson = open_lesson(source.name, folder=None if place.is_course else place.root, lang=lang)
    except LessonError as error:
        raise SourceError(file, 1, str(error)) from None
    except Exception as error:
        raise SourceError(file, _line_of(error, file), "{type}: {reason}", type=type(error).__name__, reason=str(error)) from None  # fmt: skip
    for what, declared, named in (("name", lesson.name, source.name), ("number", lesson.number, source.number)):
        if declared != named:
            raise SourceError(file, 1, "declares the {what} {declared}; expected {named}, as the file {path} says",
                what=what, declared=declared, named=named, path=source.path.name)  # fmt: skip
    return lesson


def task_lines(file: Path) -> dict[str, int]:
    """Return the line on which each task is declared: `Task(name="…"` with the name written out."""
    tree = ast.parse(file.read_text(encoding="utf-8"))
    return {
        keyword.value.value: node.lineno
        for node in ast.walk(tree)
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "Task"
        for keyword in node.keywords
        if keyword.arg == "name" and isinstance(keyword.value, ast.Constant) and isinstance(keyword.value.value, str)
    }


def _line_of(error: Exception, file: Path) -> int:
    """Return the line of a file in which an exception was raised, 1 where it was not there."""
    if isinstance(error, SyntaxError):
        return error.lineno or 1
    line, trace = 1, error.__traceback__
    while trace is not None:
        if trace.tb_frame.f_code.co_filename == str(file):
            line = trace.tb_lineno
        trace = trace.tb_next
    return line


if TYPE_CHECKING:
    from armproof.course.feedback import Lesson


def described(place: Place, source: Path) -> tuple[str, str, str, str, str]:
    """Return what the list says of a lesson; raises SourceError where its source or its tasks are malformed."""
    lesson = load_tasks(place, read_lesson_source(source))
    arms = ", ".join(dict.fromkeys(_arms(lesson))) or look_up("none")
    return str(lesson.number), lesson.name, lesson.title, str(len(lesson.tasks)), arms


def _arms(lesson: Lesson) -> Iterator[str]:
    """Yield the arms that the tasks ask about."""
    for task in lesson.tasks:
        arm: Any = getattr(task.asks, "arm", None)
        if arm is not None:
            yield arm if isinstance(arm, str) else look_up("a DH table")
