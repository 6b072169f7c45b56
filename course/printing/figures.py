"""The figures of a document: those that its front matter names, or the sketch of its arm."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from armproof.course.errors import PrintError
from armproof.course.figures.drawing.style import MM
from armproof.course.figures.output.save import save_figure
from armproof.course.figures.registry import caption_kind, draw_kind, find_kind
from armproof.course.sheet.model import Inline, Picture
from armproof.models.arm import Arm
from armproof.verification.document import Document

DEFAULT = "sketch"


def figure_names(document: Document, arm: Arm | None, solutions: bool = False) -> tuple[str, ...]:
    """Return the names of a document's figures: `figures: [sketch, {solutions: singular}]`; without the key, the arm's sketch.

    What `solutions` names belongs to the edition with solutions.

    Raises:
        PrintError: the key holds something else than names, or there is no arm to draw.
    """
    named = document.front.get("figures")
    if named is None and "figures" not in document.front:
        return (DEFAULT,) if arm is not None and find_kind(DEFAULT).applies(arm, "en") is None else ()
    entries = [] if named is None else named if isinstance(named, list) else [named]
    answers = [entry["solutions"] if _is_answer(entry) else None for entry in entries]
    names = [entry if answer is None else answer for entry, answer in zip(entries, answers, strict=True)]
    if not all(isinstance(name, str) for name in names):
        raise PrintError("{place}: 'figures' is a list of names such as [sketch, {{solutions: singular}}], not {named}",
            place=document.at("figures"), named=repr(named))  # fmt: skip
    for name in names:
        find_kind(name)
    if names and arm is None:
        raise PrintError("{place}: figures are drawn of an arm, and this document names none", place=document.at("figures"))  # fmt: skip
    shown = (name for name, answer in zip(names, answers, strict=True) if answer is None or solutions)
    return tuple(dict.fromkeys(shown))


def _is_answer(entry: object) -> bool:
    return isinstance(entry, dict) and list(entry) == ["solutions"]


def draw_figures(
    document: Document,
    arm: Arm | None,
    lang: str,
    words: Callable[[str], tuple[Inline, ...]],
    folder: Path,
    solutions: bool = False,
) -> list[Picture]:
    """Draw the figures of a document into a folder, and return them with their captions, in the order named.

    They lose the empty paper above and below the drawing.

    Raises:
        PrintError: see `figure_names`.
        FigureError: an unknown figure.
    """
    pictures = []
    for name in figure_names(document, arm, solutions):
        if arm is None:
            continue
        kind = find_kind(name)
        figure = draw_kind(kind, arm, lang)
        path = save_figure(figure, folder / f"{kind.name}.svg", trimmed=True)
        pictures.append(Picture(path, figure.get_size_inches()[0] / MM, words(caption_kind(kind, arm, lang))))
    return pictures
