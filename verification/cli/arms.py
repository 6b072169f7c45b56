"""`armproof arms`: the arms, or one of them."""

from __future__ import annotations

from typing import Annotated

import typer

from armproof.verification.cli.loading import load
from armproof.verification.report.lines import write_lines

AnyArm = Annotated[
    str | None, typer.Argument(metavar="[ARM]", help="An arm, or a path to a model file.", show_default=False)
]


def arms(arm: AnyArm = None) -> None:
    """List the arms, or the joints, lengths and frames of one."""
    from armproof.verification.report.arms import describe_arm, list_arms

    if arm is None:
        from armproof.models.catalogue import arm_names

        write_lines(list_arms([load(name) for name in arm_names()]))
    else:
        write_lines(describe_arm(load(arm)))
