"""The results as pages: the class at a glance, and one a student. Everything of a student's is escaped, or an image."""

from __future__ import annotations

import base64
from collections import Counter
from collections.abc import Callable, Sequence
from datetime import datetime
from functools import cache
from importlib.resources import files
from itertools import groupby
from pathlib import Path

from armproof.course.grading.glance import at_a_glance
from armproof.course.grading.grades import Grades
from armproof.course.grading.handed_in import in_words, lateness
from armproof.course.grading.results import Graded, Picture, Status, TaskResult
from armproof.course.grading.running.protections import describe
from armproof.course.grading.sandbox.limits import MEGABYTE
from armproof.course.grading.submissions import Submission
from armproof.course.grading.tables import TABLES, tables
from armproof.models.errors import written
from armproof.verification.report.html.folder import Kind, is_page
from armproof.verification.report.html.site import INDEX, page_names
from armproof.verification.report.html.sketch import sketch_style
from armproof.verification.report.html.states import State
from armproof.verification.report.html.templating import Shell, versions

PAGES = Shell(
    "armproof.course.grading", styles=("shell.css", "style.css", "grades.css"), allowed="img-src data:; ", drawn=False
)
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


def _is_ours(entry: Path) -> bool:
    return entry.is_file() if entry.name in TABLES else is_page(entry)


GRADES = Kind("set of results", "--out", _is_ours)


def write_grades(folder: Path, grades: Grades) -> None:
    """Write the tables and the pages of a class into an empty folder."""
    for name, table in tables(grades).items():
        (folder / name).write_bytes(table)
    names = page_names([Path(f"{student}.html") for student in grades.best])
    pages = {name.removesuffix(".html"): page for name, page in names.items()}
    anchors = _anchors(grades.graded)
    (folder / INDEX).write_text(render_index(grades, pages, anchors), encoding="utf-8")
    for student, own in groupby(grades.graded, key=lambda each: each.submission.student):
        (folder / pages[student]).write_text(render_student(student, list(own), grades, anchors), encoding="utf-8")


def _anchors(graded: Sequence[Graded]) -> Callable[[TaskResult], str]:
    """Return what gives each result the name of its place on the page of its student."""
    found = {
        id(result): f"{result.lesson}-{result.task}-{number}"
        for number, each in enumerate(graded)
        for result in each.results
    }
    return lambda result: found[id(result)]


def render_index(grades: Grades, pages: dict[str, str], anchors: Callable[[TaskResult], str]) -> str:
    """Return the page of the class: its lessons, all submissions, and what protected them from each other."""
    counts = Counter(each.status for each in grades.graded)
    limits = grades.limits
    return PAGES.render(
        "class.html",
        good=not any(each.needs_a_look for each in grades.graded),
        counts={status: counts[status] for status in Status if counts[status]},
        students=len(pages),
        graded=grades.graded,
        lessons=at_a_glance(grades.graded),
        points=grades.points,
        late=_late(grades.due),
        place_of=lambda student, result: f"{pages[student]}#{anchors(result)}",
        pages=pages,
        statuses=STATUSES,
        outcomes=OUTCOMES,
        tables=tuple(TABLES),
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


def render_student(student: str, own: Sequence[Graded], grades: Grades, anchors: Callable[[TaskResult], str]) -> str:
    """Return the page of one student, with all of their submissions."""
    return PAGES.render(
        "student.html",
        student=student,
        own=own,
        good=not any(each.needs_a_look for each in own),
        right=sum(each.right for each in own),
        tasks=sum(len(each.results) for each in own),
        points=grades.points(student),
        late=_late(grades.due),
        anchors=anchors,
        image_of=image_of,
        statuses=STATUSES,
        outcomes=OUTCOMES,
        index=INDEX,
    )


def _late(due: datetime | None) -> Callable[[Submission], str]:
    return lambda submission: in_words(lateness(submission.handed_in, due))


def image_of(picture: Picture) -> str:
    """Return a picture that a run drew as the source of an image, in which a browser runs and asks for nothing."""
    head, _, rest = picture.svg.partition(">")
    named = head if "xmlns=" in head else head.replace("<svg", '<svg xmlns="http://www.w3.org/2000/svg"', 1)
    return f"data:image/svg+xml;base64,{base64.b64encode(f'{named}>{_style()}{rest}'.encode()).decode()}"


@cache
def _style() -> str:
    """Return the style of a drawing that stands alone: the colours of the pages, and those of a sketch."""
    colours = files("armproof.verification.report.html") / "templates" / "shell.css"
    return f"<style>{colours.read_text(encoding='utf-8').partition('* {')[0]}{sketch_style()}</style>"
