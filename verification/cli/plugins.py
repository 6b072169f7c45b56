"""Commands that other rooms add: the entry points of the group "armproof.commands", each a function or a typer.Typer of several.

The package verification/ imports nothing of course/; what is installed beside it is found here by name, and loaded only
when the command is called for.
"""

from __future__ import annotations

from collections.abc import Callable
from importlib.metadata import EntryPoint, entry_points
from typing import Any

import typer
from typer.core import TyperGroup
from typer.main import get_command

GROUP = "armproof.commands"


def commands() -> dict[str, EntryPoint]:
    """Return the commands that are installed beside this package, by name."""
    return {found.name: found for found in sorted(entry_points(group=GROUP), key=lambda found: found.name)}


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
            return own
        return as_command(name, found.load())


def as_command(name: str, found: Callable[..., Any] | typer.Typer) -> Any:
    """Return a function with typer's annotations, or a group of them, as a command (of the click that this typer brings)."""
    if isinstance(found, typer.Typer):
        group = get_command(found)
        group.name = name
        return group
    alone = typer.Typer(add_completion=False, rich_markup_mode=None, pretty_exceptions_enable=False)
    alone.command(name)(found)
    return get_command(alone)
