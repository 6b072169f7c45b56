"""`armproof grade`: a class's notebooks, each run in a process of its own."""

from __future__ import annotations

import os
from collections import Counter
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from armproof.course.errors import GradingError
from armproof.models.errors import counted, written
from armproof.models.language import look_up
from armproof.verification.cli.application import (
    CANNOT_RUN,
    FAILS,
    PASSES,
    Language,
    Scheduler,
    complain,
    ending,
    give_up,
    refuse_jobs,
    tell,
)
from armproof.verification.cli.documents import Progress

if TYPE_CHECKING:
    from armproof.course.grading.grades import Grades

Folder = Annotated[
    Path, typer.Argument(metavar="FOLDER", help="Notebooks, one a student, or a folder of them for each.")
]
Out = Annotated[Path, typer.Option("--out", metavar="DIR", help="The folder that the results are written into.")]
Jobs = Annotated[
    int | None,
    typer.Option("--jobs", "-j", min=1, max=256, metavar="N", help="Submissions at once; by default one a core."),
]  # fmt: skip
Seconds = Annotated[float, typer.Option("--seconds", min=1, max=3600, metavar="S", help="Seconds for each submission.")]
Memory = Annotated[int, typer.Option("--memory", min=64, max=65536, metavar="MB", help="Memory for each, in MB.")]

Own = Annotated[Path | None, typer.Option("--folder", metavar="DIR", help="Lessons of your own, beside the course's.")]
WeightsFile = Annotated[
    Path | None, typer.Option("--weights", metavar="FILE", help="What tasks count, as CSV: lesson, task, weight; else 1 each.")
]  # fmt: skip
Due = Annotated[str, typer.Option("--due", metavar="DATE", help="Mark what was handed in later, as 2026-11-20T18:00.")]
Unprotected = Annotated[
    bool, typer.Option("--unprotected", help="Run without bubblewrap: limits of time and memory, and no protection.")
]


def grade(
    folder: Folder,
    out: Out = Path("build/grades"),
    jobs: Jobs = None,
    scheduler: Scheduler = "",
    seconds: Seconds = 60,
    memory: Memory = 1024,
    own: Own = None,
    weights: WeightsFile = None,
    due: Due = "",
    unprotected: Unprotected = False,
    lang: Language = "",
) -> None:
    """Grade a class's notebooks: results as tables, and a page a student.

    Exit code 0: all are graded; 1: some need a look; 2: nothing can be graded.
    """
    refuse_jobs(jobs, scheduler)
    if os.name != "posix":
        give_up(GradingError("armproof grade needs Linux or macOS: no other system can run a student's code apart"))
    from armproof.course.grading.grading import grade as grade_all
    from armproof.course.grading.handed_in import read_due
    from armproof.course.grading.pages import GRADES, write_grades
    from armproof.course.grading.sandbox.limits import MEGABYTE, Limits
    from armproof.course.grading.submissions import find_submissions
    from armproof.verification.report.html.folder import new_report

    try:
        with ending():
            until = read_due(due) if due else None
            submissions = find_submissions(folder)
            with new_report(out, GRADES) as part, Progress(len(submissions), "submissions") as progress:
                limits = Limits(seconds, memory * MEGABYTE)
                grades = grade_all(submissions, limits, jobs, progress.advance, own, unprotected=unprotected,
                                   weights=weights, due=until, scheduler=scheduler)  # fmt: skip
                write_grades(part, grades)
    except OSError as error:
        tell("grading cannot go on: {reason}", reason=error.strerror)
        raise typer.Exit(CANNOT_RUN) from None
    raise typer.Exit(_summarise(grades, out))


def _summarise(grades: Grades, out: Path) -> int:
    """Say what became of a class, and which protections were not in force; returns the exit code."""
    from armproof.course.grading.results import Status
    from armproof.course.grading.running.protections import describe
    from armproof.verification.report.html.site import INDEX
    from armproof.verification.report.text import write_lines

    troubled = [each for each in grades.graded if each.needs_a_look]
    lines = []
    for each in troubled:
        what = "; ".join(part for part in (each.reason, *each.remarks) if part)
        colour = "" if each.status is Status.GRADED else "red"
        lines.append(((look_up(each.status.value), colour), (f"  {each.submission.file}: {what}", "")))
    counts = Counter(each.status for each in grades.graded)
    total = ", ".join(f"{counts[status]} {look_up(status.value)}" for status in Status if counts[status])
    number = len(grades.graded)
    write_lines(lines)
    head = counted("{number} submission: {total}", "{number} submissions: {total}", number, total=total)
    write_lines([((head, "bold"),), ((written("results: {path}", path=str(out / INDEX)), ""),)])
    complain(
        written("warning: not so on this system: a submission {text}", text=each.text)
        for each in describe(grades.held)
        if not each.held
    )
    return FAILS if troubled else PASSES
