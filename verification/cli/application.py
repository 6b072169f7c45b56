"""The application that the commands belong to: its exit codes, what it says on standard error, and the commands that other rooms add.

The package verification/ imports nothing of course/: the entry points of the group "armproof.commands" are found by name, each
a function or a typer.Typer of several, and loaded only when the command is called for.
"""

from __future__ import annotations

import gc
import gettext
import os
import re
import sys
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from enum import StrEnum
from functools import partial
from importlib.metadata import EntryPoint, entry_points
from typing import TYPE_CHECKING, Annotated, Any, NoReturn

import typer
from typer.core import TyperGroup
from typer.main import get_command

from armproof.models.errors import ArmproofError, LanguageError, existing_language, written
from armproof.models.language import asked, known_language, look_up, speak
from armproof.verification.report.text import write_lines

if TYPE_CHECKING:
    from armproof.models.arm import Arm


GROUP = "armproof.commands"
UsageError: Any = typer.BadParameter.__base__  # of the click that this typer brings
COLLECTED = (100_000, 50, 100)  # after so many new objects: of a document's trees few are garbage before its end
PASSES, FAILS, CANNOT_RUN, INTERRUPTED = 0, 1, 2, 130


class Format(StrEnum):
    """The formats of a report."""

    text = "text"
    json = "json"


def commands() -> dict[str, EntryPoint]:
    """Return the commands that are installed beside this package, by name."""
    return {found.name: found for found in sorted(entry_points(group=GROUP), key=lambda found: found.name)}


@contextmanager
def telling_wrong_use() -> Iterator[None]:
    """Let a wrong use that is found within be told in the language that is spoken."""
    try:
        yield
    except UsageError as error:
        from armproof.verification.cli.usage import show_translated

        error.show = partial(show_translated, error.show)
        raise


class Group(TyperGroup):
    """The commands of the application, and those of the entry points, which are loaded when they are asked for."""

    def list_commands(self, ctx: Any) -> list[str]:
        """Return the names of all commands, the application's own first."""
        own = super().list_commands(ctx)
        return [*own, *(name for name in commands() if name not in own)]

    def get_command(self, ctx: Any, name: str) -> Any:
        """Return a command by its name; None if there is none."""
        own = super().get_command(ctx, name)
        if own is not None or (found := commands().get(name)) is None:
            return _translated(own, ctx)
        return _translated(as_command(name, found.load()), ctx)

    def get_help(self, ctx: Any) -> str:
        """Return the help of the application."""
        return super().get_help(_translated(self, ctx) and ctx)

    def make_context(self, *arguments: Any, **named: Any) -> Any:
        """Return the context of the application; a wrong use is told in the language that is spoken."""
        with telling_wrong_use():
            return super().make_context(*arguments, **named)

    def invoke(self, ctx: Any) -> Any:
        """Run the command that is called for; a wrong use is told in the language that is spoken."""
        with telling_wrong_use():
            return super().invoke(ctx)


def _translated(command: Any, ctx: Any) -> Any:
    """Return a command whose helps are in the language that is spoken."""
    for each in [command, *command.get_params(ctx)] if command is not None else ():
        each.help = look_up(each.help or "")
    for inner in getattr(command, "commands", {}).values() if command is not None else ():
        _translated(inner, ctx)
    return command


def as_command(name: str, found: Callable[..., Any] | typer.Typer) -> Any:
    """Return a function with typer's annotations, or a group of them, as a command (of the click that this typer brings)."""
    if isinstance(found, typer.Typer):
        group = get_command(found)
        group.name = name
        return group
    alone = typer.Typer(add_completion=False, rich_markup_mode=None, pretty_exceptions_enable=False)
    alone.command(name)(found)
    return get_command(alone)


app = typer.Typer(
    cls=Group,
    add_completion=False,
    no_args_is_help=True,
    pretty_exceptions_enable=False,
    rich_markup_mode=None,
    help="Every equation of a robot-arm course, proved or refuted against Drake.",
)


def heed(lang: str) -> str:
    """Speak the language that a command is asked for."""
    try:
        known = lang and existing_language(lang)
    except LanguageError as error:
        raise typer.BadParameter(str(error)) from None
    speak(known or asked())
    return known


Language = Annotated[
    str,
    typer.Option(
        "--lang",
        metavar="LANG",
        callback=heed,
        is_eager=True,
        show_default=False,
        help="The language, en or fr; by default the document's, else that of LANG.",
    ),
]
Scheduler = Annotated[
    str,
    typer.Option(
        "--scheduler",
        metavar="ADDRESS",
        show_default=False,
        help="Work on a Dask cluster, as tls://host:8786; by default in processes of this machine.",
    ),
]
ReportFormat = Annotated[Format, typer.Option("--format", help="text for people, json for programs.")]
Version = Annotated[bool, typer.Option("--version", help="Show the version.")]


def complain(messages: Iterable[str]) -> None:
    """Write each message on standard error, on one line."""
    write_lines((((f"armproof: {message}", ""),) for message in messages), sys.stderr)


def tell(template: str, /, **terms: object) -> None:
    """Write one message on standard error: a sentence of the look-up, with its terms."""
    complain([written(template, **terms)])


def main() -> None:
    """Run the command line, in the language that it is asked for: the help is in it as well, and what typer says."""
    gc.set_threshold(*COLLECTED)
    given = re.search(r"^--lang[=\n](.+)$", "\n".join(sys.argv), re.MULTILINE)
    speak(known_language(given and given[1]))
    gettext.dgettext = lambda domain, message: look_up(message)
    for name in ("stdout", "stderr"):
        if getattr(sys, name) is None:  # closed by the caller
            setattr(sys, name, open(os.devnull, "w", encoding="utf-8"))  # noqa: SIM115 - open to the end
    try:
        app(prog_name="armproof")
    except OSError as error:  # standard output takes no more: Python would try once again as it ends
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        tell("cannot write the report: {reason}", reason=error.strerror)
        sys.exit(CANNOT_RUN)


@app.callback(invoke_without_command=True)
def show_version(version: Version = False) -> None:  # noqa: D103 - the docstring would become the help
    if version:
        from importlib.metadata import version as installed_version

        typer.echo(f"armproof {installed_version('armproof')}")
        raise typer.Exit


Tip = Annotated[str | None, typer.Option("--tip", metavar="LINK", help="Of a .urdf: the link that the arm ends in.")]
Lock = Annotated[
    list[str] | None,
    typer.Option(
        "--lock",
        metavar="JOINT[=VALUE]",
        help="Of a .urdf: a joint that is fixed, at 0 or at a value; may be repeated.",
    ),
]


def load(name: str, tip: str | None = None, lock: Sequence[str] | None = None) -> Arm:
    """Load an arm, and say what is doubtful about its model; ends the command where there is no such arm."""
    from armproof.models.catalogue import load_arm

    try:
        arm = load_arm(name, tip=tip, lock=_locked(lock or ()))
    except ArmproofError as error:
        give_up(error)
    complain(written("warning: {text}", text=warning) for warning in arm.warnings)
    return arm


def _locked(texts: Iterable[str]) -> dict[str, float]:
    """Return the joints that are fixed and their values: of "finger" and "finger=0.02"."""
    try:
        return {joint: float(value or 0) for joint, _, value in (text.partition("=") for text in texts)}
    except ValueError:
        raise ArmproofError(
            "--lock is a joint, or joint=value in rad or m, not '{given}'", given=", ".join(texts)
        ) from None


@contextmanager
def ending(shown: Callable[[str], str] = str) -> Iterator[None]:
    """End the command where an error of ours is raised within, with its message as it is to be shown; quietly where it is interrupted."""
    try:
        yield
    except KeyboardInterrupt:
        raise typer.Exit(INTERRUPTED) from None
    except ArmproofError as error:
        complain([shown(str(error))])
        raise typer.Exit(CANNOT_RUN) from None


def refuse_jobs(jobs: int | None, scheduler: str) -> None:
    """End the command where it is given both."""
    if jobs is not None and scheduler:
        tell(
            "--jobs is of this machine, and a Dask cluster has as many as its workers have threads: give --jobs or --scheduler"
        )
        raise typer.Exit(CANNOT_RUN)


def give_up(error: ArmproofError) -> NoReturn:
    """Say what is wrong, and end the command."""
    complain([str(error)])
    raise typer.Exit(CANNOT_RUN)
