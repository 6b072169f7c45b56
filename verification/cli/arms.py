"""`armproof arms`: the arms, or one of them; `armproof view`: one in Drake's visualizer."""

from __future__ import annotations

from typing import Annotated

import typer

from armproof.verification.cli.application import Language, Lock, Tip, ending, load
from armproof.verification.report.text import write_lines

ArmName = Annotated[str, typer.Argument(metavar="ARM", help="An arm, or a path to a model file.", show_default=False)]
Browser = Annotated[bool, typer.Option(help="Open a browser window.")]
AnyArm = Annotated[
    str | None, typer.Argument(metavar="[ARM]", help="An arm, or a path to a model file.", show_default=False)
]


def arms(arm: AnyArm = None, tip: Tip = None, lock: Lock = None, lang: Language = "") -> None:
    """List the arms, or the joints, lengths and frames of one."""
    from armproof.verification.report.arms import describe_arm, list_arms

    if arm is None:
        from armproof.models.catalogue import arm_names

        write_lines(list_arms([load(name) for name in arm_names()]))
    else:
        write_lines(describe_arm(load(arm, tip, lock)))


def view(arm: ArmName, browser: Browser = True, tip: Tip = None, lock: Lock = None, lang: Language = "") -> None:
    """Show an arm in Drake's visualizer, with its frames and joint sliders."""
    from armproof.models.showing.viewer import view_arm

    loaded = load(arm, tip, lock)
    with ending():
        view_arm(loaded, browser=browser)
