"""The application that the commands belong to, its exit codes, and what happens around each of them."""

from __future__ import annotations

import os
import sys
from typing import Annotated

import typer

from armproof.verification.cli.messages import complain
from armproof.verification.cli.plugins import Group

PASSES, FAILS, CANNOT_RUN, INTERRUPTED = 0, 1, 2, 130

app = typer.Typer(
    cls=Group,
    add_completion=False,
    no_args_is_help=True,
    pretty_exceptions_enable=False,
    rich_markup_mode=None,
    help="Every equation of a robot-arm course, proved or refuted against Drake.",
)

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
        complain([f"cannot write the report: {error.strerror}"])
        sys.exit(CANNOT_RUN)


@app.callback(invoke_without_command=True)
def show_version(version: Version = False) -> None:  # noqa: D103 - the docstring would become the help
    if version:
        from importlib.metadata import version as installed_version

        typer.echo(f"armproof {installed_version('armproof')}")
        raise typer.Exit
