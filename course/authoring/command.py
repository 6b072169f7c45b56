"""`armproof lesson`: begin lessons, as a student or an author; list, build and check them; the site of the course."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import typer

from armproof.course.authoring import options as o
from armproof.course.site.command import site
from armproof.models.errors import written
from armproof.models.language import ENGLISH, look_up, spoken
from armproof.verification.cli.application import (
    CANNOT_RUN,
    FAILS,
    PASSES,
    Format,
    Language,
    ReportFormat,
    complain,
    ending,
    tell,
)
from armproof.verification.running.processes import MOST_WORKERS, cores

if TYPE_CHECKING:
    from armproof.course.authoring.checking.building import Files
    from armproof.course.sources.places import Place


lesson = typer.Typer(
    add_completion=False,
    no_args_is_help=True,
    pretty_exceptions_enable=False,
    rich_markup_mode=None,
    help="Lessons: list, build, check and begin them; the site of the course.",
)


@lesson.command("list")
def list_lessons(folder: o.Folder = None, lang: Language = "") -> None:
    """List the lessons: number, name, title, tasks, arms."""
    from armproof.course.authoring.checking.report import rows
    from armproof.course.authoring.checking.tasks import described
    from armproof.verification.report.text import write_lines

    with ending():
        place = _place(folder)
        found = [described(place, source) for source in place.named(())]
    write_lines(rows([("", look_up("name"), look_up("title"), look_up("tasks"), look_up("arms")), *found]))


@lesson.command("begin")
def begin_lessons(
    names: o.Names = None, into: o.Into = Path("my-lessons"), seed: o.Seed = "", lang: Language = ""
) -> None:
    """Begin lessons: copy their notebooks into a folder of your own, to work in.

    A notebook that is there already stays as it is. Exit code 0: all are there; 2: one cannot be written.
    """
    from armproof.course.authoring.beginning.copies import begin

    with ending():
        new, kept = begin(names or [], into, lang or spoken(), seed)
    for path in new:
        typer.echo(str(path))
    for path in kept:
        tell("{path}: is here already and stays as it is", path=str(path))


@lesson.command("progress")
def show_progress(lang: Language = "") -> None:
    """Show what you have solved: a bar a lesson, and the points of the course."""
    from armproof.course.feedback import course

    typer.echo(repr(course()))


@lesson.command()
def build(
    names: o.Names = None,
    check: o.Only = False,
    instructor: o.Instructor = False,
    nbgrader: o.Nbgrader = False,
    out: o.Out = None,
    force: o.Force = False,
    folder: o.Folder = None,
    lang: Language = "",
) -> None:
    """Write the students' notebooks from the solved sources, or another edition into a folder.

    Only what changed is written, and over no notebook that somebody has worked in. Exit code 0: all is up to date; 1: with --check, something is not; 2: a source is malformed.
    """
    from armproof.course.authoring.checking.building import orphans, refuse_worked_in, stale, write_stale
    from armproof.course.authoring.checking.report import relative

    with ending(relative):
        place = _place(folder)
        files = _files(place, names or [], instructor, nbgrader, out, lang or ENGLISH)
        if not (check or force):
            refuse_worked_in(files)
        old = stale(files) if check else write_stale(files)
        lost = [] if names or out else orphans(place, lang or ENGLISH)
    for path in old:
        typer.echo(relative(written("{path}: out of date" if check else "{path}", path=path)))
    complain(relative(written("{path}: no source gives this notebook; remove it", path=path)) for path in lost)
    if not old:
        tell("1 notebook up to date" if len(files) == 1 else "{count} notebooks up to date", count=len(files))
    raise typer.Exit(FAILS if check and (old or lost) else PASSES)


@lesson.command("check")
def check_command(
    names: o.Names = None,
    jobs: o.Jobs = None,
    report_format: ReportFormat = Format.text,
    folder: o.Folder = None,
    lang: Language = "",
) -> None:
    """Check lessons: every task proved in the solved source and not attempted in the student's notebook, every equation, every answer.

    Both notebooks are run in English, or in the language of --lang. Exit code 0: all pass; 1: one does not; 2: one cannot be checked.
    """
    from armproof.course.sources.kernel import require_jupyter

    with ending():
        require_jupyter()
        place = _place(folder)
        sources = place.named(names or [])
        code = _check(place, sources, jobs or min(cores(), MOST_WORKERS), report_format, lang or ENGLISH)
    raise typer.Exit(code)


@lesson.command()
def new(
    name: o.Name,
    arm: o.OfArm = None,
    document: o.OfDocument = None,
    title: o.Title = "",
    folder: o.Folder = None,
    lang: Language = "",
) -> None:
    """Begin a lesson: a source, its tasks and its notebook, for an arm and perhaps a document.

    It passes `armproof lesson check` as it is written. Exit code 0: it is written; 2: it cannot be.
    """
    from armproof.course.authoring.beginning.new import new_lesson
    from armproof.course.authoring.checking.report import relative

    with ending(relative):
        place = _place_for_writing(folder)
        paths = new_lesson(place, name, arm, document, title)
    for path in paths:
        typer.echo(relative(str(path)))
    more = f" --folder {folder}" if folder is not None else ""
    tell("check it with: armproof lesson check {name}{more}", name=name, more=more)


@lesson.command()
def coverage(lang: Language = "") -> None:
    """List what of the source documents the course asks: each exercise with its sheets and its tasks.

    Exit code 0: every exercise is asked; 1: one is open, or the table cites what is not there.
    """
    from armproof.course.authoring.checking.report import rows
    from armproof.course.coverage.table import Status, count, faults, read_exercises
    from armproof.course.feedback.lesson import lessons
    from armproof.course.inverse import HANDOUTS
    from armproof.verification.report.text import write_lines

    with ending():
        exercises = read_exercises()
        tasks = {f"{each.name}.{task.name}" for each in lessons() for task in each.tasks}
        wrong = list(faults(exercises, {path.stem for path in HANDOUTS.glob("*.md")}, tasks))
    write_lines(
        rows(
            [
                ("", "", look_up("exercise"), look_up("sheets"), look_up("tasks")),
                *(exercise.row() for exercise in exercises),
            ]
        )
    )
    complain(wrong)
    counted = count(exercises)
    tell("{asked} lines asked, {open} open; {none} are no exercise",
        asked=counted[Status.ASKED], open=counted[Status.OPEN], none=counted[Status.NONE])  # fmt: skip
    raise typer.Exit(FAILS if wrong or counted[Status.OPEN] else PASSES)


lesson.command()(site)


def _place(folder: Path | None) -> Place:
    from armproof.course.sources.places import place_of

    return place_of(folder)


def _place_for_writing(folder: Path | None) -> Place:
    """Return where a new lesson goes: the folder named, which need not be there, else the course of the working folder."""
    from armproof.course.errors import AuthoringError
    from armproof.course.sources.places import COURSE, Place

    if folder is not None and not folder.exists():
        return Place(folder)
    if folder is None and Path("course").resolve() != COURSE.root:
        raise AuthoringError(
            "where are your lessons to be? Say --folder DIR; the course itself is not in the working folder"
        )
    return _place(folder)


def _files(place: Place, names: list[str], instructor: bool, nbgrader: bool, out: Path | None, lang: str) -> Files:
    from armproof.course.authoring.checking.building import instructor_files, nbgrader_files, student_files
    from armproof.course.errors import AuthoringError

    if instructor and nbgrader:
        raise AuthoringError("--instructor and --nbgrader are two editions; build one at a time")
    if not (instructor or nbgrader):
        if out is not None:
            raise AuthoringError(
                "--out is for --instructor or --nbgrader; students' notebooks stand beside the sources"
            )
        return student_files(place, place.named(names), lang)
    if out is None:
        raise AuthoringError("an edition with solutions is written into a folder of its own: --out DIR")
    if out.resolve() == place.notebooks.resolve():
        raise AuthoringError("{out}: the students' notebooks are here; solutions are written elsewhere", out=out)
    return (nbgrader_files if nbgrader else instructor_files)(out, place.named(names), lang)


def _check(place: Place, sources: list[Path], processes: int, report_format: Format, lang: str) -> int:
    """Write the reports as they come; return the exit code."""
    from armproof.course.authoring.checking.lessons import check_lessons
    from armproof.course.authoring.checking.report import write_json, write_text

    write = write_json if report_format is Format.json else write_text
    reports = write(check_lessons(place, sources, processes, lang), sources)
    if any(report.cannot_run for report in reports):
        return CANNOT_RUN
    return PASSES if all(report.passes for report in reports) else FAILS
