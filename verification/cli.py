"""The command `armproof`: verify documents, list the arms, view an arm.

Exit codes: 0 everything passes, 1 something does not, 2 the command cannot run (or not on one of the documents).
Nothing heavy is imported before it is needed: `armproof --help` loads neither Drake nor NumPy.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Iterable, Sequence
from enum import StrEnum
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, NoReturn

import typer

from models.errors import ArmproofError
from verification.batch import Failure, check_all
from verification.report.lines import write_lines
from verification.report.text import passes, text_report
from verification.verdict import DocumentResult

if TYPE_CHECKING:
    from models.arm import Arm

PASSES, FAILS, CANNOT_RUN, INTERRUPTED = 0, 1, 2, 130

app = typer.Typer(
    add_completion=False,
    no_args_is_help=True,
    pretty_exceptions_enable=False,
    rich_markup_mode=None,
    help="Every equation of a robot-arm course, proved or refuted against Drake.",
)


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
Strict = Annotated[bool, typer.Option("--strict", help="Unchecked equations fail too.")]
ArmName = Annotated[str, typer.Argument(metavar="ARM", help="An arm, or a path to a model file.", show_default=False)]
AnyArm = Annotated[
    str | None, typer.Argument(metavar="[ARM]", help="An arm, or a path to a model file.", show_default=False)
]
Browser = Annotated[bool, typer.Option(help="Open a browser window.")]
Version = Annotated[bool, typer.Option("--version", help="Show the version.")]


def main() -> None:
    """Run the command line."""
    for name in ("stdout", "stderr"):
        if getattr(sys, name) is None:  # closed by the caller
            setattr(sys, name, open(os.devnull, "w", encoding="utf-8"))  # noqa: SIM115 - open to the end
    try:
        app(prog_name="armproof")
    except OSError as error:  # standard output takes no more: Python would try once again as it ends
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        _complain([f"cannot write the report: {error.strerror}"])
        sys.exit(CANNOT_RUN)


@app.callback(invoke_without_command=True)
def show_version(version: Version = False) -> None:  # noqa: D103 - the docstring would become the help
    if version:
        from importlib.metadata import version as installed_version

        typer.echo(f"armproof {installed_version('armproof')}")
        raise typer.Exit


@app.command()
def verify(paths: Paths = None, report_format: ReportFormat = Format.text, strict: Strict = False) -> None:
    """Give the verdict of every equation in the documents named.

    Exit code 0: everything passes; 1: something does not; 2: a document cannot be checked.
    """
    try:
        results = check_paths(paths or [_find_course()])
    except KeyboardInterrupt:
        raise typer.Exit(INTERRUPTED) from None
    _report(results, report_format, strict)
    _complain(result.message for result in results if isinstance(result, Failure))
    raise typer.Exit(exit_code(results, strict))


@app.command()
def arms(arm: AnyArm = None) -> None:
    """List the arms, or the joints, lengths and frames of one."""
    from verification.report.arms import describe_arm, list_arms

    if arm is None:
        from models.catalogue import arm_names

        write_lines(list_arms([_load(name) for name in arm_names()]))
    else:
        write_lines(describe_arm(_load(arm)))


@app.command()
def view(arm: ArmName, browser: Browser = True) -> None:
    """Show an arm in Drake's visualizer, with its frames and joint sliders."""
    from models.viewer import view_arm

    loaded = _load(arm)
    try:
        view_arm(loaded, browser=browser)
    except ArmproofError as error:
        _give_up(error)


# -- what the commands do ----------------------------------------------------------------------------------------------


def check_paths(paths: Sequence[Path]) -> list[DocumentResult | Failure]:
    """Return the result of each document that the paths name, in their order; a path that names none is a Failure."""
    from verification.document import find_documents

    found: dict[Path | Failure, None] = {}
    for path in paths:
        try:
            if path.exists() and not (path.is_dir() or path.is_file()):  # a pipe or a device, which may never end
                found[Failure(str(path), f"{path}: not a file")] = None
            else:
                found.update(dict.fromkeys(find_documents([path])))
        except ArmproofError as error:
            found[Failure(str(path), str(error))] = None
        except OSError as error:
            found[Failure(str(path), f"{path}: cannot be read: {error.strerror}")] = None
    documents = [each for each in found if isinstance(each, Path)]
    checked = dict(zip(documents, check_all(documents), strict=True))
    return [checked[each] if isinstance(each, Path) else each for each in found]


def exit_code(results: Sequence[DocumentResult | Failure], strict: bool) -> int:
    """Return the exit code: 2 if a document could not be checked, else 1 if one does not pass, else 0."""
    documents = [result for result in results if isinstance(result, DocumentResult)]
    if len(documents) < len(results):
        return CANNOT_RUN
    return PASSES if all(passes(document, strict) for document in documents) else FAILS


def _find_course() -> Path:
    """Return course/ of the working folder, else the folder of the installed course."""
    here = Path("course")
    spec = None if here.is_dir() else find_spec("course")
    return Path(next(iter(spec.submodule_search_locations))) if spec and spec.submodule_search_locations else here


def _report(results: Sequence[DocumentResult | Failure], report_format: Format, strict: bool) -> None:
    if report_format is Format.json:
        from verification.report.json_ import json_report

        sys.stdout.write(json_report(results, strict=strict))
    elif report_format is Format.github:
        from verification.report.github import github_report

        write_lines(((line, ""),) for line in github_report(results, strict=strict))
    else:
        write_lines(text_report(results, strict=strict))
    sys.stdout.flush()


def _load(name: str) -> Arm:
    """Load an arm, or end the command."""
    from models.catalogue import load_arm

    try:
        arm = load_arm(name)
    except ArmproofError as error:
        _give_up(error)
    _complain(f"warning: {warning}" for warning in arm.warnings)
    return arm


def _give_up(error: ArmproofError) -> NoReturn:
    _complain([str(error)])
    raise typer.Exit(CANNOT_RUN)


def _complain(messages: Iterable[str]) -> None:
    """Write each message on standard error, on one line."""
    write_lines((((f"armproof: {message}", ""),) for message in messages), sys.stderr)
