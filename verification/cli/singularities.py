"""`armproof singularities`: where an arm's Jacobian loses rank, and what is lost there."""

from __future__ import annotations

import sys
from contextlib import nullcontext
from typing import Annotated

import typer

from armproof.models.errors import ArmproofError
from armproof.models.language import of_programs
from armproof.verification.cli.application import FAILS, Format, Language, Lock, ReportFormat, Tip, ending, load
from armproof.verification.report.text import write_lines

OneArm = Annotated[str, typer.Argument(metavar="ARM", help="An arm, or a path to a model file.", show_default=False)]
Frame = Annotated[str | None, typer.Option(metavar="FRAME", help="Whose velocity J gives; by default the tool's.")]
Axes = Annotated[str | None, typer.Option("--in", metavar="FRAME", help="In whose axes; by default the base's.")]
Rows = Annotated[str | None, typer.Option(metavar="1,2,…", help="Rows of [v; ω]; by default those of the arm's task.")]
Columns = Annotated[str | None, typer.Option(metavar="1,2,…", help="Columns, base to tool; by default all.")]


def singularities(
    arm: OneArm,
    frame: Frame = None,
    axes: Axes = None,
    rows: Rows = None,
    columns: Columns = None,
    tip: Tip = None,
    lock: Lock = None,
    report_format: ReportFormat = Format.text,
    lang: Language = "",
) -> None:
    """Say where an arm is singular: conditions, rank, what is lost, boundary or inside.

    Exit code 0: all families were found; 1: the analysis is beyond exact reach; 2: it cannot run.
    """
    from armproof.verification.report.singularities import singularity_json, singularity_lines
    from armproof.verification.singularities.analysis import analyse_singularities

    model = load(arm, tip, lock)
    with ending(), of_programs() if report_format is Format.json else nullcontext():
        numbers = (read_numbers("--rows", rows), read_numbers("--columns", columns))
        analysis = analyse_singularities(model, frame, *numbers, axes)
    if report_format is Format.json:
        sys.stdout.write(singularity_json(analysis))
    else:
        write_lines(singularity_lines(analysis))
    if not analysis.complete:
        raise typer.Exit(FAILS)


def read_numbers(option: str, text: str | None) -> list[int] | None:
    """Return the numbers of a list such as 1,2,6.

    Raises:
        ArmproofError: it is no such list.
    """
    if text is None:
        return None
    parts = [part.strip() for part in text.split(",")]
    if not all(part.isascii() and part.isdigit() for part in parts):
        raise ArmproofError("{option} is a list of numbers such as 1,2,6, not '{text}'", option=option, text=text)
    return [int(part) for part in parts]
