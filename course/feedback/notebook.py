"""What a lesson shows in a notebook: texts as Markdown, pictures of an arm, and figures as the vectors that the handouts print."""

from __future__ import annotations

import re
import sys
import tempfile
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cache
from importlib import resources
from pathlib import Path
from typing import TYPE_CHECKING, Any

from markupsafe import Markup

from armproof.verification.report.html.figures import Figure as Picture
from armproof.verification.report.html.sketch import sketch_style

if TYPE_CHECKING:
    from matplotlib.figure import Figure

ENLARGED = 1.3  # on a screen, beside the size at which it is printed
_SIZE = re.compile(r'\b(width|height)="([\d.]+)pt"')


def block(kind: str, *parts: Markup) -> Markup:
    """Return a block of the given kind (right, wrong, open, error, hint) with its style."""
    return Markup('<style>{}</style><div class="armproof ap-{}">{}</div>').format(
        Markup(_style()), kind, Markup("").join(parts)
    )


def small_print(text: str) -> Markup:
    """Return a sentence in small print."""
    return Markup('<p class="ap-note">{}</p>').format(text)


def table(head: Sequence[str], rows: Iterable[Sequence[str]]) -> Markup:
    """Return a table; the first cell of each row is its head."""
    cells = Markup("").join(Markup('<th scope="col">{}</th>').format(name) for name in head)
    lines = Markup("").join(
        Markup('<tr><th scope="row">{}</th>{}</tr>').format(
            first, Markup("").join(Markup("<td>{}</td>").format(cell) for cell in rest)
        )
        for first, *rest in rows
    )
    return Markup("<table><thead><tr>{}</tr></thead><tbody>{}</tbody></table>").format(cells, lines)


def captioned(figure: Picture) -> Markup:
    """Return a picture with its caption."""
    return Markup("<figure>{}<figcaption>{}</figcaption></figure>").format(figure.svg, figure.caption)


@cache
def _style() -> str:
    own = resources.files("armproof.course.feedback").joinpath("feedback.css").read_text(encoding="utf-8")
    return own + sketch_style()


@dataclass(frozen=True)
class Shown:
    """Markdown, with mathematics between dollars; on a terminal as it is."""

    markdown: str

    def __str__(self) -> str:
        return self.markdown

    __repr__ = __str__

    def _repr_markdown_(self) -> str:
        return self.markdown


class Portrait:
    """A picture of an arm with its caption."""

    def __init__(self, figure: Picture) -> None:
        self.figure = figure
        self.caption = figure.caption

    def __repr__(self) -> str:
        return f"[{self.caption}]"

    def _repr_html_(self) -> str:
        return str(block("open", captioned(self.figure)))


def show_figures() -> None:
    """Have the notebook at hand, if any, show matplotlib's figures that pyplot does not know; elsewhere nothing is changed."""
    ipython = sys.modules.get("IPython")
    shell: Any = ipython.get_ipython() if ipython is not None else None
    if shell is None:
        return
    formatter = shell.display_formatter.formatters["image/svg+xml"]
    formatter.for_type_by_name("matplotlib.figure", "Figure", as_svg)


def as_svg(figure: Figure) -> str:
    """Return a figure as SVG, in the style of the course."""
    from armproof.course.figures.output.save import save_figure

    with tempfile.TemporaryDirectory() as folder:
        svg = save_figure(figure, Path(folder) / "figure.svg", trimmed=True).read_text(encoding="utf-8")
    return _SIZE.sub(lambda found: f'{found[1]}="{ENLARGED * float(found[2]):g}pt"', svg, count=2)
