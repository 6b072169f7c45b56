"""The kinds of figures by name, and which of them an arm has."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from importlib import import_module
from textwrap import fill

from matplotlib.figure import Figure

from armproof.course.errors import FigureError
from armproof.course.figures.drawing.labels import arm_title, say
from armproof.course.figures.drawing.style import GREY, TEXT, new_figure, styled
from armproof.models.arm import Arm

# In the order in which a course meets them; each is the KIND of the module of its name in course/figures/kinds/.
KINDS = tuple(
    "sketch link axes gripper columns singular postures elbow workspace manipulability quintic path crossing tracking rendering".split()
)

_LINE = 62  # characters on a line of a column


@dataclass(frozen=True)
class Kind:
    """A kind of figure.

    Attributes:
        name: what the command calls it; also the key of its title in the catalogue of words.
        applies: the reason, in a language, why an arm has no such figure; None if it has one.
        draw: the figure of an arm in a language.
        caption: its caption behind the title, with the numbers that the figure shows; mathematics between dollars.
        empty: whether an arm without it gets a figure that says so, rather than none.
        general: whether it explains a word and shows no arm in particular; a document without an arm may have it.
    """

    name: str
    applies: Callable[[Arm, str], str | None]
    draw: Callable[[Arm, str], Figure]
    caption: Callable[[Arm, str], str]
    empty: bool = False
    general: bool = False

    def title(self, lang: str) -> str:
        """Return what the kind is called."""
        return say(self.name, lang)


def find_kind(name: str) -> Kind:
    """Return a kind by its name; the others are not loaded.

    Raises:
        FigureError: there is no such kind.
    """
    if name not in KINDS:
        raise FigureError("no figure '{name}'; the figures are {kinds}", name=name, kinds=list(KINDS))
    kind: Kind = import_module(f"armproof.course.figures.kinds.{name}").KIND
    return kind


def figures_for(arm: Arm) -> tuple[Kind, ...]:
    """Return the kinds of which an arm has a figure, one that says that there is nothing to show included."""
    kinds = (find_kind(name) for name in KINDS)
    return tuple(kind for kind in kinds if not kind.general and (kind.empty or kind.applies(arm, "en") is None))


def draw_kind(kind: Kind, arm: Arm, lang: str = "") -> Figure:
    """Return the figure of an arm, or one that says why there is nothing to draw."""
    reason = kind.applies(arm, lang)
    return kind.draw(arm, lang) if reason is None else empty_figure(kind, arm, reason, lang)


def caption_kind(kind: Kind, arm: Arm, lang: str = "") -> str:
    """Return the caption of an arm's figure, or the reason why there is nothing to draw."""
    return f"{_title(kind, arm, lang)} {kind.applies(arm, lang) or kind.caption(arm, lang)}"


@styled()
def empty_figure(kind: Kind, arm: Arm, reason: str, lang: str = "") -> Figure:
    """Return a figure that says why there is nothing to draw."""
    figure = new_figure("column", 30)
    title = fill(_title(kind, arm, lang).removesuffix("."), _LINE)
    figure.text(0.5, 0.75, title, ha="center", va="center", fontsize=TEXT)
    figure.text(0.5, 0.33, fill(reason, _LINE), ha="center", va="center", fontsize=TEXT, color=GREY)
    return figure


def _title(kind: Kind, arm: Arm, lang: str) -> str:
    return (
        f"{kind.title(lang)}."
        if kind.general
        else say("figure_of", lang, title=kind.title(lang), arm=arm_title(arm, lang))
    )
