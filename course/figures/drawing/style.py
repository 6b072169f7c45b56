"""The one style of all figures: sizes on paper, fonts, colours and strokes.

A figure is drawn at the size at which it is printed, so that a letter of 8 pt is one of 8 pt on the sheet. Colours are
those of Okabe and Ito, which the colour-blind tell apart; each comes with a line style and a marker of its own,
so that it is told apart in grey as well.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Any, Literal

import matplotlib
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from armproof.course.errors import FigureError

Size = Literal["column", "page"]
Box = tuple[float, float, float, float]  # left, bottom, width, height (mm)
WIDTHS = {"column": 84.0, "page": 174.0}  # mm
HIGHEST = 235.0  # mm, what an A4 page leaves above a caption
MM = 1 / 25.4  # inches
POINT = 25.4 / 72  # mm
SMALL, TEXT = 7.0, 8.0  # pt; nothing is smaller than SMALL

INK = "#1a1a1a"
GREY = "#6e6e6e"
PALE = "#dedede"
PAPER = "#ffffff"
MAP = "cividis"  # rises in grey as well


@dataclass(frozen=True)
class Stroke:
    """How one of several things is drawn, told apart by colour and, in grey, by the rest."""

    colour: str
    linestyle: Any
    marker: str

    @property
    def line(self) -> dict[str, Any]:
        """The stroke as matplotlib's properties of a line."""
        return {"color": self.colour, "linestyle": self.linestyle}


STROKES = (
    Stroke("#0072b2", "-", "o"),  # blue
    Stroke("#d55e00", (0, (5, 1.6)), "s"),  # vermilion
    Stroke("#009e73", (0, (5, 1.4, 1, 1.4)), "^"),  # green
    Stroke("#cc79a7", (0, (1.2, 1.2)), "D"),  # purple
    Stroke("#e69f00", (0, (8, 1.6)), "v"),  # orange
    Stroke("#56b4e9", (0, (3, 1, 1, 1, 1, 1)), "P"),  # sky
    Stroke("#5d5d5d", (0, (2.5, 2.5)), "X"),  # grey
    Stroke("#000000", (0, (7, 2, 1, 2)), "*"),  # black
)


def stroke_of(k: int) -> Stroke:
    """Return the stroke of the k-th of several things."""
    return STROKES[k % len(STROKES)]


_SHEET = Path(__file__).with_name("armproof.mplstyle")  # sizes, strokes and formats; the colours are those above


@lru_cache(maxsize=1)
def _settings() -> dict[str, Any]:
    inked = ("text.color", "axes.edgecolor", "axes.labelcolor", "xtick.color", "ytick.color")
    colours = {**dict.fromkeys(inked, INK), "figure.facecolor": PAPER, "savefig.facecolor": PAPER, "grid.color": PALE}
    sheet = matplotlib.rc_params_from_file(_SHEET, use_default_template=False)
    return {**matplotlib.rcParamsDefault, "backend": "agg", **sheet, **colours, "image.cmap": MAP}


@contextmanager
def styled() -> Iterator[None]:
    """Hold the style for a block or a function; what was set before is restored at its end."""
    with matplotlib.rc_context(_settings()):
        yield


def new_figure(size: Size = "column", height: float = 60.0) -> Figure:
    """Return an empty figure, without pyplot.

    Args:
        size: column (84 mm wide) or page (174 mm).
        height: mm, up to 235.

    Raises:
        FigureError: another size, or a height that no page has.
    """
    if size not in WIDTHS:
        raise FigureError("a figure has the size {widths}, not {size}", widths=" or ".join(WIDTHS), size=repr(size))
    if not 10 <= height <= HIGHEST:
        raise FigureError("a figure is from 10 to {highest:g} mm high, not {height:g}", highest=HIGHEST, height=height)
    figure = Figure(figsize=(WIDTHS[size] * MM, height * MM))
    FigureCanvasAgg(figure)
    return figure


def mm_axes(figure: Figure, left: float, bottom: float, width: float, height: float) -> Axes:
    """Return axes whose box is given in millimetres from the lower left corner of the paper."""
    wide, high = figure.get_size_inches() / MM
    return figure.add_axes((left / wide, bottom / high, width / wide, height / high))


def text_width(figure: Figure, text: str) -> float:
    """Return the width of a text in mm."""
    probe = figure.text(0, 0, text, fontsize=TEXT)
    width = probe.get_window_extent(figure.canvas.get_renderer()).width / figure.dpi / MM
    probe.remove()
    return float(width)
