"""`armproof verify`: the verdict of every equation in the documents named."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable, Iterator, Sequence
from enum import StrEnum
from pathlib import Path
from typing import Annotated, NoReturn

import typer

from armproof.models.language import of_programs
from armproof.verification.cli.application import (
    CANNOT_RUN,
    FAILS,
    PASSES,
    Language,
    Scheduler,
    complain,
    ending,
    refuse_jobs,
    tell,
)
from armproof.verification.cli.documents import check_and_report, check_each_path, find_course, named_documents
from armproof.verification.report.text import text_report, write_lines
from armproof.verification.report.totals import Totals
from armproof.verification.verdict import DocumentResult, Failure

Result = DocumentResult | Failure


class Format(StrEnum):
    """The formats of the report."""

    text = "text"
    json = "json"
    github = "github"


Paths = Annotated[
    list[Path] | None,
    typer.Argument(metavar="PATH", help="Documents, notebooks or folders; by default course/.", show_default=False),
]
ReportFormat = Annotated[
    Format,
    typer.Option("--format", help="text for people, json for programs, github for annotations of a pull request."),
]
Strict = Annotated[bool, typer.Option("--strict", help="Unchecked equations fail too, and documents without a claim.")]
Verbose = Annotated[bool, typer.Option("--verbose", help="Tell of every equation what it was read as.")]
Report = Annotated[
    Path | None, typer.Option("--report", metavar="DIR", help="Write web pages as well, into a folder of their own.")
]
Errata = Annotated[
    Path | None,
    typer.Option("--errata", metavar="FILE", help="Write one sheet of all mistakes as well: .md, .tex or .pdf."),
]
Jobs = Annotated[
    int | None,
    typer.Option(
        "--jobs", "-j", min=1, max=256, metavar="N", help="Processes; by default one a core.", show_default=False
    ),
]
Watching = Annotated[bool, typer.Option("--watch", help="Verify again whatever is saved, until Ctrl-C.")]


def verify(
    paths: Paths = None,
    report_format: ReportFormat = Format.text,
    strict: Strict = False,
    verbose: Verbose = False,
    report: Report = None,
    errata: Errata = None,
    watch: Watching = False,
    jobs: Jobs = None,
    scheduler: Scheduler = "",
    lang: Language = "",
) -> None:
    """Give the verdict of every equation in the documents named.

    Exit code 0: everything passes; 1: something does not; 2: a document cannot be checked.
    """
    documents = paths or [find_course()]
    refuse_jobs(jobs, scheduler)
    if watch:
        _watch(documents, report_format, report or errata or scheduler, strict)
    totals = Totals(strict)
    takers = [totals.add]
    with ending():  # what is wrong with a document is in its result: an error is of what is written
        if errata is not None:
            from armproof.verification.cli.errata import ErrataSheet

            sheet = ErrataSheet(errata, _files(documents))
            takers.append(sheet.add)
        if report is None:
            results: Iterable[Result] = check_each_path(
                documents, jobs=jobs, correct=errata is not None, scheduler=scheduler
            )
        else:
            results = check_and_report(documents, report, strict=strict, jobs=jobs, scheduler=scheduler)
        write_report(_taken(results, takers), report_format, strict, verbose)
        if errata is not None:
            sheet.write()
    complain(totals.messages)
    raise typer.Exit(exit_code(totals))


def _files(paths: Sequence[Path]) -> list[Path]:
    return [each for each in named_documents(paths) if isinstance(each, Path)]


def _taken(results: Iterable[Result], takers: Sequence[Callable[[Result], None]]) -> Iterator[Result]:
    """Yield the results, each given to those that count it: none is kept."""
    for result in results:
        for take in takers:
            take(result)
        yield result


def _watch(paths: Sequence[Path], report_format: Format, other: Path | str | None, strict: bool) -> NoReturn:
    """Watch the documents until the user ends it; the exit code is that of their last verdicts."""
    if report_format is not Format.text or other:
        tell("--watch writes text for people: give it none of --format, --report, --errata and --scheduler")
        raise typer.Exit(CANNOT_RUN)
    from armproof.verification.cli.watching import watch_documents

    with ending():
        failures = [each for each in named_documents(paths) if isinstance(each, Failure)]
        results = watch_documents(lambda: _files(paths), failures, strict=strict)
    totals = Totals(strict)
    for result in results:
        totals.add(result)
    raise typer.Exit(exit_code(totals))


def exit_code(totals: Totals) -> int:
    """Return the exit code: 2 if a document could not be checked, else 1 if one does not pass, else 0."""
    if totals.unable:
        return CANNOT_RUN
    return FAILS if totals.failing else PASSES


def write_report(
    results: Iterable[DocumentResult | Failure], report_format: Format, strict: bool, verbose: bool = False
) -> None:
    """Write the report of the results on standard output, document by document."""
    if report_format is Format.json:
        from armproof.verification.report.json_ import json_parts

        with of_programs():
            for part in json_parts(results, strict=strict):
                sys.stdout.write(part)
    elif report_format is Format.github:
        from armproof.verification.report.github import github_report

        write_lines(((line, ""),) for line in github_report(results, strict=strict))
    else:
        write_lines(text_report(results, strict=strict, verbose=verbose))
    sys.stdout.flush()
