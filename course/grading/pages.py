"""The results as pages: an index of the class, and one a student. Everything of a student's is escaped."""

from __future__ import annotations

import csv
import io
from collections import Counter
from collections.abc import Iterable, Sequence
from itertools import groupby
from pathlib import Path

from armproof.course.grading.grading import Grades
from armproof.course.grading.results import Graded, Status
from armproof.course.grading.running.protections import describe
from armproof.course.grading.sandbox.limits import MEGABYTE
from armproof.course.grading.text import as_cell
from armproof.models.errors import written
from armproof.verification.report.html.folder import Kind, is_page
from armproof.verification.report.html.site import INDEX, page_names
from armproof.verification.report.html.states import State
from armproof.verification.report.html.templating import Shell, versions

RESULTS, SUBMISSIONS = "results.csv", "submissions.csv"
_OF_TASKS = ("student", "file", "lesson", "task", "outcome", "message")
_OF_SUBMISSIONS = ("student", "file", "lessons", "status", "reason", "right", "tasks", "seconds", "remarks")
PAGES = Shell("armproof.course.grading")
OUTCOMES = {
    "correct (proved)": State("proved", "✓", "correct (proved)"),
    "correct (confirmed)": State("confirmed", "≈", "correct (confirmed)"),
    "in letters, please": State("unchecked", "≈", "in letters, please"),
    "wrong": State("refuted", "✗", "wrong"),
    "not attempted": State("defined", "–", "not attempted"),
    "error": State("unchecked", "!", "error"),
}
STATUSES = {status: State("refuted", "✗", status.value) for status in Status} | {
    Status.GRADED: State("proved", "✓", Status.GRADED.value)
}


def results_table(graded: Sequence[Graded]) -> bytes:
    """Return the outcome of each task of each submission."""
    rows = (
        (each.submission.student, each.submission.file, result.lesson, result.task, result.outcome, result.message)
        for each in graded
        for result in each.results
    )
    return _table(_OF_TASKS, rows)


def submissions_table(graded: Sequence[Graded]) -> bytes:
    """Return the status of each submission, and how many of its tasks are right."""
    rows = (
        (each.submission.student, each.submission.file, "; ".join(each.lessons), each.status.value, each.reason, each.right,
         len(each.results), f"{each.seconds:.2f}", "; ".join(each.remarks))
        for each in graded
    )  # fmt: skip
    return _table(_OF_SUBMISSIONS, rows)


def _table(head: Sequence[str], rows: Iterable[Sequence[object]]) -> bytes:
    """Return a table in UTF-8, with the mark by which spreadsheets know it."""
    text = io.StringIO(newline="")
    writer = csv.writer(text)
    writer.writerow(head)
    writer.writerows([as_cell(str(value)) for value in row] for row in rows)
    return text.getvalue().encode("utf-8-sig")


def _is_ours(entry: Path) -> bool:
    return entry.is_file() if entry.name in (RESULTS, SUBMISSIONS) else is_page(entry)


GRADES = Kind("set of results", "--out", _is_ours)


def write_grades(folder: Path, grades: Grades) -> None:
    """Write the tables and the pages of a class into an empty folder."""
    (folder / RESULTS).write_bytes(results_table(grades.graded))
    (folder / SUBMISSIONS).write_bytes(submissions_table(grades.graded))
    names = page_names([Path(f"{student}.html") for student in _students(grades.graded)])
    pages = {name.removesuffix(".html"): page for name, page in names.items()}
    (folder / INDEX).write_text(render_index(grades, pages), encoding="utf-8")
    for student, own in groupby(grades.graded, key=lambda each: each.submission.student):
        (folder / pages[student]).write_text(render_student(student, list(own)), encoding="utf-8")


def _students(graded: Sequence[Graded]) -> list[str]:
    return list(dict.fromkeys(each.submission.student for each in graded))


def render_index(grades: Grades, pages: dict[str, str]) -> str:
    """Return the page that lists all submissions, and says what protected them from each other."""
    counts = Counter(each.status for each in grades.graded)
    limits = grades.limits
    return PAGES.render(
        "class.html",
        good=not any(each.needs_a_look for each in grades.graded),
        counts={status: counts[status] for status in Status if counts[status]},
        students=len(pages),
        graded=grades.graded,
        pages=pages,
        statuses=STATUSES,
        tables=(RESULTS, SUBMISSIONS),
        protections=describe(grades.held),
        limits=written(
            "{seconds:g} s, {memory} MB of memory, {output} kB of output and {disk} MB of files for each submission",
            seconds=limits.seconds,
            memory=limits.memory // MEGABYTE,
            output=limits.output // 1000,
            disk=limits.disk // MEGABYTE,
        ),
        versions=versions(),
    )


def render_student(student: str, own: Sequence[Graded]) -> str:
    """Return the page of one student, with all of their submissions."""
    return PAGES.render(
        "student.html",
        student=student,
        own=own,
        good=not any(each.needs_a_look for each in own),
        right=sum(each.right for each in own),
        tasks=sum(len(each.results) for each in own),
        statuses=STATUSES,
        outcomes=OUTCOMES,
        index=INDEX,
    )
