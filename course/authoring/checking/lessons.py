"""Check lessons: source, equations, answers, and both editions in a kernel."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

from armproof.course.authoring.checking.answers import check_answers, count_answers
from armproof.course.authoring.checking.building import stale, student_files
from armproof.course.authoring.checking.report import Report
from armproof.course.authoring.checking.tasks import load_tasks
from armproof.course.errors import SourceError
from armproof.course.sources.editions import solved_cells, student_cells
from armproof.course.sources.kernel import Run, run_cells
from armproof.course.sources.lesson_source import LessonSource, read_lesson_source
from armproof.course.sources.places import Place
from armproof.models.errors import ArmproofError
from armproof.models.language import ENGLISH, languages
from armproof.verification.running.processes import share_out
from armproof.verification.verdict import DocumentResult, Record, Verdict

PROVED, NOT_ATTEMPTED = "correct (proved)", "not attempted"
REBUILD = "armproof lesson build"


def check_lessons(place: Place, sources: Sequence[Path], processes: int, lang: str = ENGLISH) -> Iterator[Report]:
    """Yield the report of each lesson, in their order, several at once; its editions are run in a language."""
    yield from share_out(partial(check_lesson, place, lang=lang), sources, processes, _ended, fresh=True)


def _ended(source: Path) -> Report:
    fault = f"{source}: the process that checked it ended; Drake may have aborted on its arm"
    return Report(source, (fault,), cannot_run=True)


def check_lesson(place: Place, source: Path, lang: str = ENGLISH) -> Report:
    """Return all that is wrong with a lesson; no exception but an interrupt leaves this function."""
    try:
        return _check(place, source, lang)
    except SourceError as error:
        return Report(source, (str(error),), cannot_run=True)
    except ArmproofError as error:
        message = str(error)
        where = "" if message.startswith(str(source)) else f"{source}: "
        return Report(source, (where + message,), cannot_run=True)
    except Exception as error:
        fault = f"{source}: internal error, please report it: {type(error).__name__}: {error}"
        return Report(source, (fault,), cannot_run=True)


def _check(place: Place, source: Path, lang: str) -> Report:
    from armproof.verification.check import verify

    lesson = read_lesson_source(source)
    edition, speaking = read_lesson_source(source, lang), {"LANGUAGE": lang}
    own_words = ENGLISH if place.is_course else ""  # the language of the words that wrong answers declare
    tasks, result = load_tasks(place, lesson, own_words), verify(source)
    solved = run_cells(lesson.name, list(solved_cells(edition)), place, speaking)
    blank = run_cells(lesson.name, list(student_cells(edition)), place, speaking)
    names = [task.name for task in tasks.tasks]
    problems = [
        *_of_build(place, source),
        *_of_tasks(place, lesson, names),
        *_of_equations(result),
        *check_answers(place, lesson, tasks),
        *_of_run(lesson, solved, names, PROVED, "solved"),
        *_of_run(lesson, blank, names, NOT_ATTEMPTED, "the student's notebook"),
    ]
    right, wrong = count_answers(tasks)
    report = Report(source, tuple(problems), tasks=len(names), right=right, wrong=wrong)
    return replace(
        report,
        verdicts=dict(Counter(record.verdict.value for record in result.records)),
        seconds=solved.seconds,
        student_seconds=blank.seconds,
        check_seconds=tuple(_seconds(solved.results))[1:],
    )


def _seconds(results: Mapping[str, Mapping[str, Any]]) -> Iterator[float]:
    """Yield the times of the checks, in the order in which they were made."""
    for feedback in results.values():
        if isinstance(seconds := feedback.get("seconds"), float):
            yield seconds


def _of_build(place: Place, source: Path) -> Iterator[str]:
    made = [lang for lang in languages() if lang == ENGLISH or place.notebook(source, lang).parent.is_dir()]
    for path in (each for lang in made for each in stale(student_files(place, [source], lang))):
        what = "is not what the source gives" if path.exists() else "is missing"
        yield f"{path}: {what}; write it with: {REBUILD}"


def _of_tasks(place: Place, lesson: LessonSource, names: Sequence[str]) -> Iterator[str]:
    """Yield the tasks that are never checked, and the checks of no task."""
    checked = {check.task for check in lesson.checks}
    for name in names:
        if name not in checked:
            yield f"{lesson.path}:1: the task '{name}' is never checked; expected a cell with lesson.{name}.check(…)"
    for check in lesson.checks:
        if check.task not in names:
            yield f"{lesson.path}:{check.line}: no task '{check.task}'; the tasks are {', '.join(names)}"


def _of_equations(result: DocumentResult) -> Iterator[str]:
    for record in result.records:
        if record.passes and record.verdict is not Verdict.UNCHECKED:
            continue
        what = "an erratum that is not refuted" if record.erratum else record.verdict.value
        yield f"{result.path}:{record.line}: {what}: {_words(record)}"


def _words(record: Record) -> str:
    text = " ".join(record.latex.split())
    return record.message or (text if len(text) <= 60 else text[:57] + "…")


def _of_run(lesson: LessonSource, run: Run, names: Sequence[str], expected: str, edition: str) -> Iterator[str]:
    """Yield where an edition stopped, else the tasks that did not come out as they should."""
    if run.fault is not None:
        is_source = edition == "solved"
        where = lesson.place(run.fault.cell, (run.fault.line or 1) if is_source else 1)
        inside = "" if is_source or run.fault.line is None else f", line {run.fault.line} of its cell"
        yield f"{where}: {edition}{inside}: {run.fault.message}"
        return
    lines = {check.task: check.line for check in lesson.checks}
    for name in names:
        if name not in lines or name not in run.results:
            if name in lines:
                yield f"{lesson.path}:{lines[name]}: {edition}: the task '{name}' has no result"
            continue
        outcome = run.results[name]
        if outcome["outcome"] != expected:
            told = f": {outcome['message']}" if outcome["message"] else ""
            hint = "; is its answer outside ### BEGIN SOLUTION?" if expected == NOT_ATTEMPTED else ""
            yield f"{lesson.path}:{lines[name]}: {edition}: the task '{name}' is {outcome['outcome']}, expected {expected}{told}{hint}"
