"""The options of `armproof lesson`."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

Names = Annotated[
    list[str] | None, typer.Argument(metavar="[NAME]...", help="Lessons, such as scara_jacobian or 12; by default all.")
]
Folder = Annotated[
    Path | None,
    typer.Option("--folder", metavar="DIR", help="Lessons of your own: DIR/lessons, DIR/tasks, DIR/notebooks."),
]
Out = Annotated[Path | None, typer.Option("--out", metavar="DIR", help="Where the other editions are written.")]
Into = Annotated[
    Path, typer.Option("--into", metavar="DIR", help="Your folder: what is there already is never written over.")
]
Seed = Annotated[
    str, typer.Option("--seed", metavar="NAME", help="Numbers of your own in the tasks: a name or a number.")
]
Only = Annotated[
    bool, typer.Option("--check", help="Write nothing: name the notebooks that are out of date, exit 1 if any is.")
]
Force = Annotated[bool, typer.Option("--force", help="Write over notebooks that somebody has worked in.")]
Instructor = Annotated[bool, typer.Option("--instructor", help="The edition with solutions, into --out DIR.")]
Nbgrader = Annotated[
    bool, typer.Option("--nbgrader", help="Assignments for nbgrader, into --out DIR, its folder 'source'.")
]
Jobs = Annotated[
    int | None,
    typer.Option("--jobs", "-j", min=1, max=64, metavar="N", help="Processes; by default one a core, at most 4."),
]
Name = Annotated[str, typer.Argument(metavar="NAME", help="The lesson's name, such as my_arm_jacobian.")]
OfArm = Annotated[str | None, typer.Option("--arm", metavar="ARM", help="An arm of `armproof arms`.")]
OfDocument = Annotated[
    Path | None, typer.Option("--document", metavar="FILE", help="A document whose proved displays become tasks.")
]
Title = Annotated[str, typer.Option("--title", metavar="TEXT", help="By default the document's, or the name in words.")]
