"""`armproof lesson site`: the course as static pages."""

from __future__ import annotations

import sys
import time
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from armproof.models.errors import written
from armproof.verification.cli.application import FAILS, Language, complain, ending, tell
from armproof.verification.cli.documents import Progress

if TYPE_CHECKING:
    from armproof.course.site.order import Built

Names = Annotated[
    list[str] | None, typer.Argument(metavar="[NAME]...", help="Lessons, such as scara_jacobian or 12; by default all.")
]
Folder = Annotated[
    Path | None, typer.Option("--folder", metavar="DIR", help="Lessons of your own: DIR/lessons and DIR/tasks.")
]
Out = Annotated[
    Path | None,
    typer.Option("--out", metavar="DIR", help="The folder to write; by default build/site, or build/site-solutions."),
]
Solutions = Annotated[bool, typer.Option("--solutions", help="The edition with solutions, folded below each task.")]


def site(
    names: Names = None, folder: Folder = None, out: Out = None, solutions: Solutions = False, lang: Language = ""
) -> None:
    """Build the course as static pages: each lesson executed, with figures, 3D views and mathematics, to be read offline.

    Without --lang they are in every language that the lessons have, each page with a link to the other. The pages show the tasks,
    their hints and no solution; --solutions makes the edition that has them. Exit code 0: the site is there; 1: a lesson does not run or does not pass; 2: an unknown lesson, or a folder that cannot be written. What is there stays
    unless all of the new site is there.
    """
    from armproof.course.errors import SiteError
    from armproof.course.site.build import build_site
    from armproof.course.site.order import Order
    from armproof.course.sources.kernel import require_jupyter
    from armproof.course.sources.places import place_of

    started = time.perf_counter()
    target = out or Path("build/site-solutions" if solutions else "build/site")
    with ending():
        require_jupyter()
        place = place_of(folder)
        sources = place.named(names or ())
        langs = (lang,) if lang else place.languages
        with Progress(len(sources) * len(langs), "lessons") as progress:

            def done(built: Built) -> None:
                progress.clear()
                complain(written("warning: {text}", text=warning) for warning in built.warnings)
                progress.advance()

            try:
                index = build_site(Order(tuple(sources), place, solutions, langs), target, done=done)
            except SiteError as error:
                complain(str(error).splitlines())
                raise typer.Exit(FAILS) from None
    seconds, count = time.perf_counter() - started, len(sources)
    template = "1 lesson in {seconds:.0f} s" if count == 1 else "{count} lessons in {seconds:.0f} s"
    tell(template, count=count, seconds=seconds)
    sys.stdout.write(f"{index}\n")
