"""What became of a submission: how its run ended, and the results of the tasks, from what was reported."""

from __future__ import annotations

import signal
from collections.abc import Sequence
from typing import Any

from armproof.course.grading.notebook import Notebook
from armproof.course.grading.reports import NOT_ATTEMPTED, Report, Reported, read_report
from armproof.course.grading.results import Graded, Status, TaskResult
from armproof.course.grading.running.keeper import Ended
from armproof.course.grading.sandbox.limits import MEGABYTE, Limits
from armproof.course.grading.submissions import Submission
from armproof.course.grading.text import clean, clean_lines
from armproof.models.errors import written
from armproof.models.language import look_up, spoken

_STARVED = 0.5  # of its time
_SHOWN = 4000  # characters of the output on a page


def judge(
    submission: Submission, notebook: Notebook, ended: Ended, catalogue: Sequence[dict[str, Any]], limits: Limits
) -> Graded:
    """Return a submission's results."""
    report = read_report(ended.lines, catalogue)
    status, reason = _status(ended, report, limits)
    lessons = _lessons(notebook, report, catalogue)
    return Graded(
        submission,
        status,
        reason,
        tuple(map(_title, lessons)),
        tuple(_result(lesson, task, report) for lesson in lessons for task in lesson["tasks"]),
        tuple(report.errors),
        tuple(report.notes),
        tuple(_remarks(notebook, ended, report, lessons)),
        clean_lines(ended.output, _SHOWN),
        ended.seconds,
        status is Status.TIMED_OUT and ended.busy < _STARVED * limits.seconds,
    )


def _status(ended: Ended, report: Report, limits: Limits) -> tuple[Status, str]:
    """Return the status, and one sentence where the submission is not simply graded."""
    where = written(" in code cell {cell}", cell=report.cell) if report.cell else ""
    memory = written("more than {number} MB of memory", number=limits.memory // MEGABYTE)
    if ended.why == "time":
        return Status.TIMED_OUT, written(
            "ended after {seconds:g} s{where}; the cells after it were not run", seconds=limits.seconds, where=where
        )
    if ended.why == "memory":
        return Status.OUT_OF_MEMORY, written(
            "ended{where}, which took {memory}; the cells after it were not run", where=where, memory=memory
        )
    if ended.why == "disk":
        return Status.TOO_MUCH_OUTPUT, written(
            "ended{where}, which wrote more than {number} MB of files, or {files:,} of them",
            where=where, number=limits.disk // MEGABYTE, files=10_000,
        )  # fmt: skip
    if ended.why == "output":
        return Status.TOO_MUCH_OUTPUT, written(
            "ended{where}, which printed more than {number} MB", where=where, number=limits.flood // 1_000_000
        )
    if ended.why:
        return Status.CRASHED, written("it was not run: {reason}", reason=clean(ended.output))
    if not report.done or ended.code:
        return Status.CRASHED, written(
            "its process ended{where} by {how}; the cells after it were not run", where=where, how=_how(ended.code)
        )
    if report.memory:
        return Status.OUT_OF_MEMORY, written("a cell needed {memory}; the others were run", memory=memory)
    if ended.printed > limits.output:
        return Status.TOO_MUCH_OUTPUT, written(
            "it printed {printed:,} kB; {read} kB are read", printed=ended.printed // 1000, read=limits.output // 1000
        )
    return Status.GRADED, ""


def _how(code: int) -> str:
    if code >= 0:
        return written("exit code {code}", code=code)
    try:
        return written("the signal {name}", name=signal.Signals(-code).name)
    except ValueError:
        return written("the signal {name}", name=-code)


def _lessons(notebook: Notebook, report: Report, catalogue: Sequence[dict[str, Any]]) -> list[dict[str, Any]]:
    """Return the lessons that were checked or opened, else that of the front matter's title."""
    named = {lesson for lesson, _ in report.results} | set(notebook.lessons)
    found = [lesson for lesson in catalogue if lesson["name"] in named]
    return found or [lesson for lesson in catalogue if notebook.title in lesson["title"].values()]


def _title(lesson: dict[str, Any]) -> str:
    return f"{lesson['number']} · {lesson['title'][spoken()]}"


def _result(lesson: dict[str, Any], task: dict[str, Any], report: Report) -> TaskResult:
    found = report.results.get((lesson["name"], task["name"]), Reported())
    if report.changed and found.outcome != NOT_ATTEMPTED:
        message = written("not counted: what checks it was changed during the run ({what})", what=report.changed[0])
        found = Reported("error", message, found.answer, found.attempts)
    return TaskResult(lesson["name"], task["name"], task["title"][spoken()], _title(lesson), **vars(found))


def _remarks(notebook: Notebook, ended: Ended, report: Report, lessons: Sequence[dict[str, Any]]) -> list[str]:
    remarks = []
    if not lessons and not ended.why:
        remarks.append(look_up("it opens no lesson of the course"))
    if notebook.asks_solutions:
        remarks.append(look_up("it asks for solutions (.solution() or .right)"))
    if report.changed:
        remarks.append(written("it changed what checks the answers: {what}", what=list(report.changed[:5])))
    if ended.foreign or report.refused:
        remarks.append(look_up("it wrote where the results are reported; what it wrote there was refused"))
    return remarks
