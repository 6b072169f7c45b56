"""`armproof figures`: the figures of the arms, as files."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from armproof.models.errors import existing_language
from armproof.models.language import noted
from armproof.verification.cli.application import CANNOT_RUN, FAILS, PASSES, complain, ending
from armproof.verification.cli.documents import Progress

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from armproof.course.figures.output.production import Delivery, Order

Names = Annotated[list[str] | None, typer.Argument(metavar="[NAME]...", help="Kinds of figures; by default all.")]
Arms = Annotated[
    list[str] | None,
    typer.Option(
        "--arm",
        metavar="ARM",
        help="An arm, a path to a model file, or a document whose front matter has one; may be repeated. By default all arms.",
    ),
]
Formats = Annotated[
    str,
    typer.Option(
        "--format",
        metavar="LIST",
        help="Of pdf, svg, png, pgf, and gif, mp4, html for a film of the motion; separated by commas.",
    ),
]
Language = Annotated[str, typer.Option("--lang", metavar="en|fr", help="The language of the labels.")]
Out = Annotated[Path, typer.Option("--out", metavar="DIR", help="The folder to write into.")]


def figures(
    names: Names = None,
    arms: Arms = None,
    formats: Formats = "pdf,svg,png",
    lang: Language = "en",
    out: Out = Path("build/figures"),
) -> None:
    """Draw the figures of the arms, right by construction: each from the arm that the equations are checked against.

    A figure is written as ARM-NAME.pdf and so on, with its caption in ARM-NAME.txt, a film as ARM-motion.gif. Exit code 0: all are written; 1: some
    could not be drawn; 2: an unknown figure, arm, format or language, or a folder that cannot be written.
    """
    from armproof.course.figures.output.production import produce

    with ending():
        wanted = _formats(formats)
        orders = _orders(tuple(names or ()), arms, lang)
        done = _report(produce(orders, wanted, lang, out), len(orders))
    if problems := [problem for delivery in done for problem in delivery.problems]:
        complain(problems)
    if any(delivery.fatal for delivery in done):
        raise typer.Exit(CANNOT_RUN)
    raise typer.Exit(FAILS if problems else PASSES)


def _formats(text: str) -> tuple[str, ...]:
    from armproof.course.errors import FigureError
    from armproof.course.figures.output.films import FILMS
    from armproof.course.figures.output.save import FORMATS

    found = tuple(dict.fromkeys(part.strip() for part in text.split(",") if part.strip()))
    for suffix in found:
        if suffix not in (*FORMATS, *FILMS):
            known = f"figures are written as {', '.join(FORMATS)}, the motion of an arm as {', '.join(FILMS)}"
            raise FigureError("no format '{suffix}'; {known}", suffix=suffix, known=known)
    if not found:
        raise FigureError("--format is empty; figures are written as {formats}", formats=list(FORMATS))
    return found


def _orders(names: tuple[str, ...], arms: Sequence[str] | None, lang: str) -> list[Order]:
    """Return what is to be drawn; raises ArmproofError for an unknown figure, arm or language."""
    from armproof.course.figures.output.production import Order
    from armproof.course.figures.registry import find_kind
    from armproof.models.catalogue import arm_names

    existing_language(lang)
    for name in names:
        find_kind(name)
    known = arm_names()
    return [Order(arm, arm, names) if arm in known else _own_arm(arm, names) for arm in dict.fromkeys(arms or known)]


def _own_arm(arm: str, names: tuple[str, ...]) -> Order:
    """Return the order for a model file, or for the arm of a document."""
    from armproof.course.errors import FigureError
    from armproof.course.figures.output.production import Order
    from armproof.verification.document import read_document

    path = Path(arm)
    if path.suffix not in (".md", ".ipynb", ".py"):
        return Order(arm, path.name.split(".")[0] or path.name, names)
    spec = read_document(path).front.get("arm")
    if spec is None:
        raise FigureError("{path}: the front matter names no arm to draw", path=path)
    return Order(spec, path.stem, names, str(path.parent))


def _report(deliveries: Iterator[Delivery], count: int) -> list[Delivery]:
    """Print the files as they come, and on a terminal how far the work is."""
    done: list[Delivery] = []
    with Progress(count, noted("arms")) as progress:
        for delivery in deliveries:
            done.append(delivery)
            progress.clear()
            sys.stdout.write("".join(f"{file}\n" for file in delivery.files))
            sys.stdout.flush()
            progress.advance()
    return done
