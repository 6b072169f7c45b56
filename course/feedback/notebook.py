"""What a lesson shows in a notebook: texts as Markdown, pictures of an arm, and figures as the vectors that the handouts print."""

from __future__ import annotations

import base64
import re
import sys
import tempfile
from dataclasses import dataclass
from functools import cache
from importlib.resources import files
from pathlib import Path
from typing import TYPE_CHECKING, Any

from jinja2 import Environment, PackageLoader, StrictUndefined
from markupsafe import Markup

from armproof.models.errors import written
from armproof.verification.report.html.figures import Figure as Picture
from armproof.verification.report.html.sketch import sketch_style

if TYPE_CHECKING:
    from matplotlib.figure import Figure

HALF = 4.0  # inches: two figures that are no wider stand side by side
ENLARGED = 1.3  # on a screen, beside the size at which it is printed
_SIZE = re.compile(r'\b(width|height)="([\d.]+)pt"')


def render(template: str, kind: str, **values: Any) -> str:
    """Return a block of the given kind (right, wrong, open, error, hint) with its style.

    Args:
        template: its file; `block.html` shows `content`.
        values: what it shows; every value is escaped unless it is Markup.
    """
    return _environment().get_template(template).render(kind=kind, **values)


def bar(reached: int, count: int) -> str:
    """Return a bar of ten parts, full only where all is reached."""
    full = reached * 10 // count if count else 0
    return "▰" * full + "▱" * (10 - full)


@cache
def _environment() -> Environment:
    environment = Environment(
        loader=PackageLoader(__package__),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    own = (files(__package__) / "templates" / "feedback.css").read_text(encoding="utf-8")
    environment.globals |= {"style": Markup(own + sketch_style()), "_": written}
    return environment


@dataclass(frozen=True)
class Shown:
    """Markdown, with mathematics between dollars; on a terminal as it is."""

    markdown: str

    def __str__(self) -> str:
        return self.markdown

    __repr__ = __str__

    def _repr_markdown_(self) -> str:
        return self.markdown


@dataclass(frozen=True)
class Portrait:
    """Pictures of an arm side by side, each with its caption."""

    pictures: tuple[Picture, ...]

    def __repr__(self) -> str:
        return " ".join(f"[{picture.caption}]" for picture in self.pictures)

    def _repr_html_(self) -> str:
        return render("picture.html", "open", pictures=self.pictures)


def show_figures() -> None:
    """Have the notebook at hand, if any, show matplotlib's figures that pyplot does not know; elsewhere nothing is changed."""
    if (shell := sys.modules["IPython"].get_ipython()) is not None:
        formatter = shell.display_formatter.formatters["image/svg+xml"]
        formatter.for_type_by_name("matplotlib.figure", "Figure", as_svg)


def as_svg(figure: Figure) -> str:
    """Return a figure as SVG, in the style of the course."""
    from armproof.course.figures.output.save import save_figure

    with tempfile.TemporaryDirectory() as folder:
        svg = save_figure(figure, Path(folder) / "figure.svg", trimmed=True).read_text(encoding="utf-8")
    return _SIZE.sub(lambda found: f'{found[1]}="{ENLARGED * float(found[2]):g}pt"', svg, count=2)


def as_picture(figure: Figure, caption: str) -> Picture:
    """Return a figure with its caption, an image of its own: two on one page share no names."""
    data = base64.b64encode(as_svg(figure).encode()).decode()
    wide = "ap-wide" if figure.get_figwidth() > HALF else ""
    image = Markup('<img class="{}" alt="{}" src="data:image/svg+xml;base64,{}">')
    return Picture(image.format(wide, caption, data), caption)
