"""The results as CSV: a line a task in results.csv, a line a submission in submissions.csv."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterable, Sequence

from armproof.course.grading.results import Graded
from armproof.course.grading.text import as_cell

RESULTS, SUBMISSIONS = "results.csv", "submissions.csv"
_OF_TASKS = ("student", "file", "lesson", "task", "outcome", "message")
_OF_SUBMISSIONS = ("student", "file", "lessons", "status", "reason", "right", "tasks", "seconds", "remarks")


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
