"""What grading asks of the course: which lessons and tasks there are, and what the checks of a run have found.

Only what `Task.check` itself returns counts, of the tasks that were declared before the run: a Feedback made by hand, or a lesson
made by the student, does not. See `integrity` for what was changed during the run.
"""

from __future__ import annotations

import contextlib
import functools
import importlib
import inspect
import textwrap
from collections.abc import Callable, Collection, Sequence
from pathlib import Path
from typing import Any
from urllib.parse import unquote

from armproof.course.errors import GradingError
from armproof.course.grading.reports import LONGEST_ANSWER, MISTAKEN, MOST_MISTAKES, NOT_ATTEMPTED
from armproof.models.language import languages

_PRELOADED = (
    "numpy", "matplotlib.pyplot", "pydrake.math", "pydrake.multibody.plant", "pydrake.symbolic", "armproof.models.catalogue",
    "armproof.course.feedback",
)  # fmt: skip
_OF_STUDENTS = ("sympy",)  # where it is installed
Result = dict[str, Any]


def recording(
    check: Callable[..., Any], tasks: dict[int, tuple[str, Any]]
) -> tuple[Callable[..., Any], dict[tuple[str, str], Result]]:
    """Return `Task.check` as it is, but for the record that it keeps of the last check of each of the tasks given; and that record."""
    found: dict[tuple[str, str], Result] = {}

    @functools.wraps(check)
    def recorded(task: Any, *arguments: Any, **named: Any) -> Any:
        feedback = check(task, *arguments, **named)
        lesson, asks = tasks.get(id(task), ("", None))
        if lesson and task.asks is asks and not {"check", "_judge"} & set(vars(task)):
            before = found.get((lesson, task.name), {"attempts": 0, "mistakes": []})
            found[lesson, task.name] = {"lesson": lesson, "task": task.name, **_told(feedback, before)} | {
                "answer": _written(*arguments, *named.values())
            }
        return feedback

    return recorded, found


def _told(feedback: Any, before: Result) -> Result:
    """Return what a check says, with the attempts so far and the mistakes made in any of them."""
    from armproof.course.feedback.outcome import pretty

    outcome, message = str(feedback.outcome), pretty(str(feedback.message))
    mistakes = [*before["mistakes"], *([message] if outcome in MISTAKEN else [])]
    picture = feedback.picture and {"svg": str(feedback.picture.svg), "caption": str(feedback.picture.caption)}
    return {
        "outcome": outcome,
        "message": message,
        "attempts": before["attempts"] + (outcome != NOT_ATTEMPTED),
        "mistakes": list(dict.fromkeys(mistakes))[:MOST_MISTAKES],
        "picture": picture,
    }


def _written(answer: Any = ..., *others: Any) -> str:
    """Return an answer as the student wrote it: the source of a function, a formula, else what Python calls it."""
    if answer is ...:
        return ""
    with contextlib.suppress(Exception):  # a student's own object may say anything, or raise
        text = inspect.getsource(answer) if inspect.isroutine(answer) else answer
        return textwrap.dedent(text if isinstance(text, str) else repr(answer)).strip()[:LONGEST_ANSWER]
    return ""


def preload() -> None:
    """Import what lessons and students use, so that no submission waits for it; backend and threads are the environment's."""
    for name in _PRELOADED:
        importlib.import_module(name)
    for name in _OF_STUDENTS:
        with contextlib.suppress(ImportError):
            importlib.import_module(name)


def load_course(used: Collection[str], own: str, base: str) -> tuple[list[dict[str, Any]], Callable[[], list[Result]]]:
    """Return the catalogue of lessons and tasks, and what returns the results of the checks from now on.

    Args:
        used: names of lessons of which the first right answer of each task is judged beforehand: what that computes once,
            no submission computes again; `name=seed` is one with numbers of its own.
        own: the folder of a teacher's own lessons, or nothing.
        base: the folder of the runs' folders, in which a notebook finds them as `open_lesson(name, folder="..")`.

    Raises:
        ArmproofError: a lesson is declared wrongly, or there is none in the folder.
    """
    from armproof.course.feedback import Task
    from armproof.course.feedback.lesson import lesson_names, open_lesson

    named = {name: [open_lesson(name, lang=lang) for lang in languages()] for name in lesson_names()}
    named |= _own_lessons(Path(own), base) if own else {}
    course = sorted((lesson for lesson, *_ in named.values()), key=lambda lesson: lesson.number)
    for lesson in course:
        for task in lesson.tasks if lesson.name in used else ():
            with contextlib.suppress(Exception):
                task.asks.judge(task.right[0])
    pairs = [each.partition("=") for each in used if "=" in each]
    seeded = [
        open_lesson(name, lang=lang, seed=unquote(seed))
        for name, _, seed in pairs
        if name in lesson_names()
        for lang in languages()
    ]
    opened = [lesson for each in named.values() for lesson in each] + seeded
    tasks = {id(task): (lesson.name, task.asks) for lesson in opened for task in lesson.tasks}
    Task.check, found = recording(Task.check, tasks)  # type: ignore[method-assign]
    return [_described(named[lesson.name]) for lesson in course], lambda: list(found.values())


def _described(each: Sequence[Any]) -> dict[str, Any]:
    """Return a lesson, of all its languages, with the titles that it has in them."""
    tasks = [
        {"name": same[0].name, "title": _titles(same)} for same in zip(*(lesson.tasks for lesson in each), strict=True)
    ]
    return {"name": each[0].name, "number": each[0].number, "title": _titles(each), "tasks": tasks}


def _titles(each: Sequence[Any]) -> dict[str, str]:
    return {one.lang: one.title for one in each}


def _own_lessons(folder: Path, base: str) -> dict[str, Any]:
    """Return a teacher's own lessons by name, each in every language, opened from where the notebooks will look for them."""
    from armproof.course.feedback import lesson as opened
    from armproof.course.feedback import open_lesson

    stems = (path.stem for path in (folder / "tasks").glob("*.py"))
    names = sorted(stem for stem in stems if stem.isidentifier() and stem != "__init__")
    if not names:
        raise GradingError("{folder}: no lessons of your own: there is no tasks/<name>.py in it", folder=folder)
    found = {name: [open_lesson(name, folder, lang) for lang in languages()] for name in names}
    for name, each in found.items():
        for lesson in each:
            opened._opened[str(Path(base).resolve()), name, lesson.lang, ""] = lesson
    return found
