"""A lesson: its tasks by name, and where each of them stands."""

from __future__ import annotations

import importlib
import importlib.util
import pkgutil
import re
import sys
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, replace
from functools import lru_cache, partial
from pathlib import Path

from armproof.course.errors import LessonError
from armproof.course.feedback.notebook import bar, render, show_figures
from armproof.course.feedback.outcome import Feedback, Outcome
from armproof.course.feedback.progress import keep_progress, reached, read_progress
from armproof.course.feedback.slope import REVIEW, Stage, stages
from armproof.course.feedback.task import Task
from armproof.course.feedback.translation import changed_task
from armproof.models.errors import counted, existing_language, written
from armproof.models.language import ENGLISH, asked, known_language, language_of_environment, speak, spoken, use
from armproof.verification.document.catalogue import translated_sentence, translation_of

PACKAGE = "armproof.course.tasks"
COURSE = Path(__file__).resolve().parents[1]


@dataclass(eq=False)
class Lesson:
    """A lesson of the course; each of its tasks is an attribute: `lesson.jacobian.check(answer)`.

    Attributes:
        number: its place in the course.
        name: a Python identifier.
        title: as students read it.
        objectives: three lines.
        tasks: in their order.
        source: what it was taken from.
        stage: its place on the slope of the course; none for a teacher's own.
        lang: the language it is in; empty: that which is spoken.
    """

    number: int
    name: str
    title: str
    objectives: tuple[str, ...]
    tasks: tuple[Task, ...]
    source: str = ""
    lang: str = ""
    stage: Stage | None = None
    _results: dict[str, Feedback] = field(default_factory=dict, repr=False)
    _reached: dict[str, Outcome] = field(default_factory=dict, repr=False)

    def __post_init__(self) -> None:
        names = [task.name for task in self.tasks]
        for name in [self.name, *names]:
            if not name.isidentifier():
                raise LessonError("'{name}' is no Python identifier, and so no name of a lesson or task", name=name)
        for name in names:
            if names.count(name) > 1 or hasattr(type(self), name) or name in self.__dataclass_fields__:
                raise LessonError("lesson '{lesson}': the task name '{name}' is taken", lesson=self.name, name=name)
        for task in self.tasks:
            task.lesson, task.lang, task.on_feedback = self.name, self.lang, self._keep
            task.was_tried = partial(self._was_tried, task.name)

    def __getattr__(self, name: str) -> Task:
        for task in self.__dict__.get("tasks", ()):
            if task.name == name:
                return task  # type: ignore[no-any-return]
        known = ", ".join(task.name for task in self.__dict__.get("tasks", ()))
        raise AttributeError(f"lesson '{self.__dict__.get('name')}' has no task '{name}'; its tasks are {known}")

    def __dir__(self) -> list[str]:
        return sorted([*super().__dir__(), *(task.name for task in self.tasks)])

    def results(self) -> dict[str, Feedback]:
        """Return the last feedback on each task that was checked in this process."""
        return dict(self._results)

    def progress(self) -> dict[str, Outcome]:
        """Return where each task stands, in the order of the lesson, checks before this process included."""
        kept = read_progress(self.name)
        known = {**kept, **self._reached}
        return {task.name: known.get(task.name, Outcome.NOT_ATTEMPTED) for task in self.tasks}

    @property
    def points(self) -> int:
        """The points that are reached: one a task that is solved."""
        return sum(state.is_right for state in self.progress().values())

    def _was_tried(self, task: str) -> bool:
        return self.progress()[task] is not Outcome.NOT_ATTEMPTED

    def _keep(self, feedback: Feedback) -> None:
        before = self.progress()[feedback.task]
        self._results[feedback.task] = feedback
        self._reached[feedback.task] = reached(before, feedback.outcome)
        keep_progress(feedback)

    def __repr__(self) -> str:
        states = self.progress()
        lines = [
            f"{self.number} · {self.title}",
            *(f"  – {line}" for line in self.objectives),
            "",
            *filter(None, [self.effort]),
            self._solved(),
        ]
        width = max(map(len, states), default=0)
        lines += [f"  {states[task.name].mark} {task.name.ljust(width)}  {task.title}" for task in self.tasks]
        return "\n".join(lines)

    def _repr_html_(self) -> str:
        states = self.progress()
        with use(self.lang):
            return render("lesson.html", "open", lesson=self, states=states, solved=self._solved())

    @property
    def effort(self) -> str:
        """How long the lesson takes, and the lessons that come before it."""
        if self.stage is None:
            return ""
        with use(self.lang):
            minutes = written("About {minutes} minutes", minutes=self.stage.minutes)
            if not (before := [str(stages()[name].number) for name in self.stage.before]):
                return minutes
            after = counted("after lesson {lessons}", "after lessons {lessons}", len(before), lessons=", ".join(before))
            return f"{minutes} · {after}"

    def _solved(self) -> str:
        solved, count = self.points, len(self.tasks)
        with use(self.lang):
            words = counted("{number} of {count} tasks solved", "{number} of {count} tasks solved", solved, count=count)
        return f"{words}  {bar(solved, count)}"


_opened: dict[tuple[str, str, str, str], Lesson] = {}


def open_lesson(name: str, folder: str | Path | None = None, lang: str = "", seed: str | int = "") -> Lesson:
    """Return a lesson by its name; opened again it is the same one.

    Args:
        folder: where a teacher's own lessons are: `<folder>/tasks/<name>.py` has its tasks.
        lang: the language of its tasks and of what they answer; by default that of the environment.
        seed: a name or a number that gives tasks numbers of their own; the same seed, the same numbers.

    Raises:
        LessonError: there is no such lesson, or its tasks are declared wrongly.
        LanguageError: another language.
    """
    if "IPython" in sys.modules:
        show_figures()
        speak(asked(), known_language(lang) or spoken())  # from here on: figures too
    wanted = existing_language(lang) if lang else _usual_language()
    key = (str(Path(folder).resolve()) if folder is not None else "", name, wanted, str(seed).strip())
    if key not in _opened:
        lesson = _read(name) if folder is None else _read_own(name, Path(folder))
        _opened[key] = _in_language(lesson, folder, wanted, key[3])
    return _opened[key]


def _usual_language() -> str:
    """Return the language that a command was asked for, else that which it speaks; elsewhere that of the environment."""
    return asked() or (language_of_environment() if spoken() == ENGLISH else spoken())


def _read(name: str) -> Lesson:
    if name not in lesson_names():
        raise LessonError("no lesson '{name}'; the lessons are {lessons}", name=name, lessons=list(lesson_names()))
    lesson: Lesson = importlib.import_module(f"{PACKAGE}.{name}").LESSON
    return lesson


def _in_language(lesson: Lesson, folder: str | Path | None, lang: str, seed: str) -> Lesson:
    """Return a lesson whose tasks speak a language, with its words from the catalogue of its source, and the numbers of a seed."""
    change = _words_of(lesson, Path(folder) if folder is not None else COURSE, lang)
    stage = stages().get(lesson.name) if folder is None else None
    tasks = [changed_task(task.own(seed) if seed and task.own else task, change) for task in lesson.tasks]
    return Lesson(
        lesson.number,
        lesson.name,
        change(lesson.title),
        tuple(map(change, lesson.objectives)),
        (*tasks, *_returning(stage, lang)),
        change(lesson.source),
        lang,
        stage,
    )


def _words_of(lesson: Lesson, folder: Path, lang: str) -> Callable[[str], str]:
    """Return what puts the words of a lesson into a language, by the catalogue of its source."""
    source = folder / "lessons" / f"{lesson.number:02}_{lesson.name}.py"
    return partial(translated_sentence, translate=translation_of(source, lang))


def _returning(stage: Stage | None, lang: str) -> Iterator[Task]:
    """Yield the task of an earlier lesson that returns, for a point of its own."""
    if stage is not None and stage.review:
        name, _, task = stage.review.partition(".")
        lesson = _read(name)
        yield replace(changed_task(getattr(lesson, task), _words_of(lesson, COURSE, lang)), name=REVIEW)


def lessons() -> tuple[Lesson, ...]:
    """Return the lessons of the course in their order."""
    return tuple(sorted((open_lesson(name) for name in lesson_names()), key=lambda lesson: lesson.number))


def results() -> dict[str, dict[str, Feedback]]:
    """Return the last feedback on each task that was checked in this process, by lesson and task."""
    return {lesson.name: lesson.results() for lesson in _opened.values()}


@lru_cache(maxsize=1)
def lesson_names() -> tuple[str, ...]:
    """Return the names of the course's lessons."""
    package = importlib.import_module(PACKAGE)
    return tuple(sorted(module.name for module in pkgutil.iter_modules(package.__path__)))


def _read_own(name: str, folder: Path) -> Lesson:
    file = folder / "tasks" / f"{name}.py"
    if not re.fullmatch(r"[A-Za-z_]\w*", name) or not file.is_file():
        own = ", ".join(sorted(path.stem for path in (folder / "tasks").glob("*.py"))) or "none"
        raise LessonError("no lesson '{name}' in {folder}: there is no file {file}; the lessons there: {own}",
            name=name, folder=folder, file=file, own=own)  # fmt: skip
    spec = importlib.util.spec_from_file_location(f"armproof_own_lessons.{name}", file)
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    lesson = getattr(module, "LESSON", None)
    if not isinstance(lesson, Lesson):
        raise LessonError("{file}: it is to declare LESSON = Lesson(…)", file=file)
    return lesson
