"""The results as pages: an index of the class, and one a student. Everything of a student's is escaped."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import groupby
from pathlib import Path

from armproof.course.grading.grading import Grades
from armproof.course.grading.results import Graded, Status
from armproof.course.grading.running.protections import describe
from armproof.course.grading.sandbox.limits import MEGABYTE
from armproof.course.grading.tables import RESULTS, SUBMISSIONS, results_table, submissions_table
from armproof.verification.report.html.folder import Kind, is_page
from armproof.verification.report.html.site import INDEX, page_names
from armproof.verification.report.html.states import State
from armproof.verification.report.html.templating import Shell, versions

PAGES = Shell("armproof.course.grading")
OUTCOMES = {
    "correct (proved)": State("proved", "✓", "correct (proved)"),
    "correct (confirmed)": State("confirmed", "≈", "correct (confirmed)"),
    "wrong": State("refuted", "✗", "wrong"),
    "not attempted": State("defined", "–", "not attempted"),
    "error": State("unchecked", "!", "error"),
}
STATUSES = {status: State("proved" if status is Status.GRADED else "refuted", "✓" if status is Status.GRADED else "✗",
                          status.value) for status in Status}  # fmt: skip


@dataclass(frozen=True)
class Row:
    """A submission in the index: what was graded, and the page of its student."""

    graded: Graded
    page: str


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
        rows=[Row(each, pages[each.submission.student]) for each in grades.graded],
        statuses=STATUSES,
        tables=(RESULTS, SUBMISSIONS),
        protections=describe(grades.held),
        limits=f"{limits.seconds:g} s, {limits.memory // MEGABYTE} MB of memory, {limits.output // 1000} kB of output and "
        f"{limits.disk // MEGABYTE} MB of files for each submission",
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
