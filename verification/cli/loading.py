"""Load the arm that a command was given, or end the command."""

from __future__ import annotations

from typing import TYPE_CHECKING, NoReturn

import typer

from armproof.models.errors import ArmproofError
from armproof.verification.cli.app import CANNOT_RUN
from armproof.verification.cli.messages import complain

if TYPE_CHECKING:
    from armproof.models.arm import Arm


def load(name: str) -> Arm:
    """Load an arm, and say what is doubtful about its model; ends the command where there is no such arm."""
    from armproof.models.catalogue import load_arm

    try:
        arm = load_arm(name)
    except ArmproofError as error:
        give_up(error)
    complain(f"warning: {warning}" for warning in arm.warnings)
    return arm


def give_up(error: ArmproofError) -> NoReturn:
    """Say what is wrong, and end the command."""
    complain([str(error)])
    raise typer.Exit(CANNOT_RUN)
