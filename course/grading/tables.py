"""The results as tables: of tasks, mistakes and submissions, for Moodle, for nbgrader, and the times that runs took."""

from __future__ import annotations

import csv
import io
from collections.abc import Callable, Iterable, Iterator, Sequence
from itertools import groupby

from armproof.course.grading.glance import at_a_glance
from armproof.course.grading.grades import Grades
from armproof.course.grading.handed_in import lateness
from armproof.course.grading.submissions import Submission
from armproof.course.grading.text import as_cell
from armproof.models.errors import written
from armproof.models.language import look_up, noted

Row = Sequence[object]
_OF_MOODLE = (
    noted("Identifier"), noted("Full name"), noted("Grade"), noted("Maximum grade"), noted("Last modified (grade)"),
    noted("Feedback comments"),
)  # fmt: skip


def tables(grades: Grades) -> dict[str, bytes]:
    """Return the tables of a class by the names of their files, in UTF-8, with the mark by which spreadsheets know it."""
    return {name: _table(rows(grades)) for name, rows in TABLES.items()}


def _table(rows: Iterable[Row]) -> bytes:
    text = io.StringIO(newline="")
    csv.writer(text).writerows([as_cell(str(value)) for value in row] for row in rows)
    return text.getvalue().encode("utf-8-sig")


def _of_tasks(grades: Grades) -> Iterator[Row]:
    yield "student", "file", "lesson", "task", "outcome", "attempts", "weight", "message", "answer"
    for each in grades.graded:
        for result in each.results:
            weight = grades.weights.of((result.lesson, result.task))
            yield (each.submission.student, each.submission.file, result.lesson, result.task, result.outcome, result.attempts,
                   f"{weight:g}", result.message, result.answer)  # fmt: skip


def _of_mistakes(grades: Grades) -> Iterator[Row]:
    yield "lesson", "task", "mistake", "number", "of", "students"
    for lesson in at_a_glance(grades.graded):
        for each in lesson.mistakes:
            yield (each.task.lesson, each.task.task, each.message, len(each.students), each.of, "; ".join(each.students))  # fmt: skip


def _of_submissions(grades: Grades) -> Iterator[Row]:
    yield "student", "file", "lessons", "status", "reason", "right", "tasks", "handed_in", "hours_late", "remarks"
    for each in grades.graded:
        handed_in = each.submission.handed_in
        yield (each.submission.student, each.submission.file, "; ".join(each.lessons), each.status.value, each.reason, each.right,
               len(each.results), handed_in.isoformat() if handed_in else "", _hours_late(grades, each.submission),
               "; ".join(each.remarks))  # fmt: skip


def _hours_late(grades: Grades, submission: Submission) -> str:
    return f"{lateness(submission.handed_in, grades.due).total_seconds() / 3600:.2f}"


def _of_times(grades: Grades) -> Iterator[Row]:
    yield "student", "file", "seconds"
    yield from ((each.submission.student, each.submission.file, f"{each.seconds:.2f}") for each in grades.graded)


def _for_moodle(grades: Grades) -> Iterator[Row]:
    """Yield the rows of a grading worksheet, of a hundred, with the columns that Moodle looks for in the language spoken."""
    yield tuple(map(look_up, _OF_MOODLE))
    for student, own in groupby(grades.graded, key=lambda each: each.submission.student):
        numbers = [each.submission.participant for each in own if each.submission.participant]
        identifier = written("Participant {number}", number=numbers[0]) if numbers else student
        points = grades.points(student)
        words = written("{right:g} of {count:g} points", right=points.reached, count=points.most)
        yield identifier, student, f"{points.percent:.2f}", 100, "", words


def _for_nbgrader(grades: Grades) -> Iterator[Row]:
    """Yield the rows that `nbgrader export` writes, a lesson as an assignment."""
    yield ("assignment", "duedate", "timestamp", "student_id", "last_name", "first_name", "email", "raw_score",
           "late_submission_penalty", "score", "max_score")  # fmt: skip
    for lesson in dict.fromkeys(lesson for lesson, _ in grades.tasks):
        for student in grades.best:
            points = grades.points(student, lesson)
            yield (lesson, grades.due or "", grades.handed_in(student, lesson) or "", student, "", "", "",
                   f"{points.reached:g}", 0, f"{points.reached:g}", f"{points.most:g}")  # fmt: skip


TABLES: dict[str, Callable[[Grades], Iterator[Row]]] = {
    "results.csv": _of_tasks,
    "mistakes.csv": _of_mistakes,
    "submissions.csv": _of_submissions,
    "moodle.csv": _for_moodle,
    "nbgrader.csv": _for_nbgrader,
    "times.csv": _of_times,
}
