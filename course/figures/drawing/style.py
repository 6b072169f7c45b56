"""The one style of all figures: sizes on paper, fonts, colours and strokes.

A figure is drawn at the size at which it is printed, so that a letter of 8 pt is one of 8 pt on the sheet. Colours are
those of Okabe and Ito, which the colour-blind tell apart; each comes with a line style, a marker and a hatch of its own,
so that it is told apart in grey as well.
"""

from __future__ import annotations

from contextlib import AbstractContextManager, ContextDecorator
from dataclasses import dataclass
from types import TracebackType
from typing import Any, Literal

import matplotlib
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from armproof.course.figures.errors import FigureError

Size = Literal["column", "page"]
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
    hatch: str


STROKES = (
    Stroke("#0072b2", "-", "o", ""),  # blue
    Stroke("#d55e00", (0, (5, 1.6)), "s", "////"),  # vermilion
    Stroke("#009e73", (0, (5, 1.4, 1, 1.4)), "^", "\\\\\\\\"),  # green
    Stroke("#cc79a7", (0, (1.2, 1.2)), "D", "...."),  # purple
    Stroke("#e69f00", (0, (8, 1.6)), "v", "xxxx"),  # orange
    Stroke("#56b4e9", (0, (3, 1, 1, 1, 1, 1)), "P", "++++"),  # sky
    Stroke("#5d5d5d", (0, (2.5, 2.5)), "X", "----"),  # grey
    Stroke("#000000", (0, (7, 2, 1, 2)), "*", "||||"),  # black
)

_RC: dict[str, Any] = {
    "font.family": "STIXGeneral",  # comes with matplotlib: the same on every machine
    "mathtext.fontset": "stix",
    "font.size": TEXT,
    "axes.titlesize": TEXT,
    "axes.labelsize": TEXT,
    "xtick.labelsize": SMALL,
    "ytick.labelsize": SMALL,
    "legend.fontsize": SMALL,
    "figure.titlesize": TEXT,
    "figure.dpi": 100,
    "figure.facecolor": PAPER,
    "savefig.facecolor": PAPER,
    "savefig.dpi": 300,
    "text.color": INK,
    "axes.edgecolor": INK,
    "axes.labelcolor": INK,
    "axes.facecolor": "none",
    "axes.linewidth": 0.6,
    "axes.unicode_minus": True,
    "axes.axisbelow": True,
    "axes.formatter.use_mathtext": True,
    "xtick.color": INK,
    "ytick.color": INK,
    "xtick.major.width": 0.6,
    "ytick.major.width": 0.6,
    "xtick.major.size": 2.5,
    "ytick.major.size": 2.5,
    "xtick.direction": "out",
    "grid.color": PALE,
    "grid.linewidth": 0.5,
    "lines.linewidth": 1.2,
    "lines.markersize": 4,
    "lines.solid_capstyle": "round",
    "lines.solid_joinstyle": "round",
    "lines.dash_capstyle": "butt",
    "patch.linewidth": 0.8,
    "hatch.linewidth": 0.5,
    "legend.frameon": False,
    "legend.handlelength": 2.4,
    "legend.borderpad": 0.2,
    "image.cmap": MAP,
    "path.simplify": False,
    "pdf.fonttype": 42,  # whole TrueType outlines: text stays text
    "ps.fonttype": 42,
    "pdf.compression": 6,
    "svg.fonttype": "path",
    "svg.hashsalt": "armproof",
    "pgf.rcfonts": False,
    "pgf.texsystem": "pdflatex",
    "pgf.preamble": r"\usepackage{amsmath}",
}


class styled(ContextDecorator):
    """The style, for a block or a function; what was set before is restored at its end."""

    def __init__(self) -> None:
        self._contexts: list[AbstractContextManager[None]] = []

    def __enter__(self) -> styled:
        context = matplotlib.rc_context({**matplotlib.rcParamsDefault, "backend": "agg", **_RC})
        context.__enter__()
        self._contexts.append(context)
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._contexts.pop().__exit__(kind, error, trace)


def new_figure(size: Size = "column", height: float = 60.0, layout: Literal["constrained"] | None = None) -> Figure:
    """Return an empty figure, without pyplot.

    Args:
        size: column (84 mm wide) or page (174 mm).
        height: mm, up to 235.
        layout: "constrained" where matplotlib is to arrange axes and their labels; None where `mm_axes` does.

    Raises:
        FigureError: another size, or a height that no page has.
    """
    if size not in WIDTHS:
        raise FigureError("a figure has the size {widths}, not {size}", widths=" or ".join(WIDTHS), size=repr(size))
    if not 10 <= height <= HIGHEST:
        raise FigureError("a figure is from 10 to {highest:g} mm high, not {height:g}", highest=HIGHEST, height=height)
    figure = Figure(figsize=(WIDTHS[size] * MM, height * MM), layout=layout)
    FigureCanvasAgg(figure)
    return figure


def mm_axes(figure: Figure, left: float, bottom: float, width: float, height: float, **options: Any) -> Axes:
    """Return axes whose box is given in millimetres from the lower left corner of the paper."""
    wide, high = figure.get_size_inches() / MM
    return figure.add_axes((left / wide, bottom / high, width / wide, height / high), **options)
