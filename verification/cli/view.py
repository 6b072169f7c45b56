"""`armproof view`: an arm in Drake's visualizer."""

from __future__ import annotations

from typing import Annotated

import typer

from armproof.models.errors import ArmproofError
from armproof.verification.cli.loading import give_up, load

ArmName = Annotated[str, typer.Argument(metavar="ARM", help="An arm, or a path to a model file.", show_default=False)]
Browser = Annotated[bool, typer.Option(help="Open a browser window.")]


def view(arm: ArmName, browser: Browser = True) -> None:
    """Show an arm in Drake's visualizer, with its frames and joint sliders."""
    from armproof.models.showing.viewer import view_arm

    loaded = load(arm)
    try:
        view_arm(loaded, browser=browser)
    except ArmproofError as error:
        give_up(error)
