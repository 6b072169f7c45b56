"""Grade a class: each submission read, run and judged; several at once."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor, as_completed
from contextvars import copy_context
from dataclasses import replace
from datetime import datetime
from pathlib import Path

from armproof.course.errors import GradingError
from armproof.course.grading.grades import Grades
from armproof.course.grading.judging import judge
from armproof.course.grading.notebook import Notebook, UnreadableError, read_notebook
from armproof.course.grading.results import Graded, Status
from armproof.course.grading.running.client import Client
from armproof.course.grading.running.on_workers import OnWorkers
from armproof.course.grading.sandbox.bubblewrap import lies_in_readable
from armproof.course.grading.sandbox.limits import Limits
from armproof.course.grading.submissions import Submission
from armproof.course.grading.text import clean
from armproof.course.grading.weights import Weights, read_weights
from armproof.models.language import look_up
from armproof.verification.running.processes import cores

Runs = Client | OnWorkers


def grade(
    submissions: Sequence[Submission],
    limits: Limits,
    jobs: int | None = None,
    advance: Callable[[], None] = lambda: None,
    own: Path | None = None,
    *,
    unprotected: bool = False,
    weights: Path | None = None,
    due: datetime | None = None,
    scheduler: str = "",
) -> Grades:
    """Grade submissions.

    Args:
        submissions: the class's notebooks.
        limits: for each of them.
        jobs: how many at once; by default one a core.
        advance: called after each.
        own: the folder of a teacher's own lessons.
        unprotected: run them without a sandbox.
        weights: the table of what each task counts.
        due: until when submissions are in time.
        scheduler: the address of a Dask cluster that runs them, encrypted or on this machine; by default this machine does.

    Raises:
        ClusterError: the cluster cannot be used.
        GradingError: there is no sandbox, the course or the weights cannot be loaded, or the submissions lie where every
            submission may read.
    """
    for submission in submissions[:1]:
        if (place := lies_in_readable(submission.path)) is not None:
            raise GradingError("{path}: every submission may read {place}, where Python and the course are; put the class's folder somewhere else",
                path=clean(str(submission.path)), place=place)  # fmt: skip
    read = {each: _read(each) for each in submissions}
    notebooks = [notebook for notebook in read.values() if isinstance(notebook, Notebook)]
    used = {lesson for notebook in notebooks for lesson in (*notebook.lessons, *notebook.seeded)}
    count = min(jobs or cores(), max(len(submissions), 1))
    with (
        OnWorkers(scheduler, limits, used, own, unprotected=unprotected)
        if scheduler
        else Client(count, limits, used, own, unprotected=unprotected)
    ) as client:
        counted = Weights() if weights is None else read_weights(weights, client.catalogue)
        pool = ThreadPoolExecutor(client.jobs)
        try:
            waiting = {
                pool.submit(copy_context().run, _grade, each, read[each], client, limits): each for each in submissions
            }
            done = {}
            for future in as_completed(waiting):
                done[waiting[future]] = future.result()
                advance()
            for each in [each for each, found in done.items() if found.starved]:
                done[each] = _grade(each, read[each], client, limits)
        finally:
            pool.shutdown(wait=False, cancel_futures=True)
        return Grades(mark_repeated([done[each] for each in submissions]), client.held, limits, counted, due)


def mark_repeated(graded: Sequence[Graded]) -> tuple[Graded, ...]:
    """Add a remark to each submission of a student who handed in a lesson more than once."""
    counts = Counter((each.submission.student, lesson) for each in graded for lesson in each.lessons)
    return tuple(
        replace(each, remarks=(*each.remarks, look_up("another notebook of this student is on the same lesson")))
        if any(counts[each.submission.student, lesson] > 1 for lesson in each.lessons)
        else each
        for each in graded
    )


def _read(submission: Submission) -> Notebook | str:
    """Return a submission's notebook, or why there is none."""
    try:
        return read_notebook(submission.path)
    except UnreadableError as problem:
        return clean(str(problem))


def _grade(submission: Submission, notebook: Notebook | str, client: Runs, limits: Limits) -> Graded:
    if isinstance(notebook, str):
        return Graded(submission, Status.UNREADABLE, notebook)
    return judge(submission, notebook, client.run(notebook.cells), client.catalogue, limits)
