"""Whether a finished figure can be read: no text overlaps another or leaves the page, none is smaller than 7 pt."""

from __future__ import annotations

from itertools import combinations

from matplotlib.figure import Figure
from matplotlib.text import Text
from matplotlib.transforms import Bbox

from armproof.course.figures.drawing.ink import shown_texts
from armproof.course.figures.drawing.style import SMALL, styled

_TOLERANCE = 0.3  # px: texts may touch


@styled()
def illegible(figure: Figure) -> tuple[str, ...]:
    """Return what cannot be read in a figure, one sentence each; none if all can."""
    boxes = _boxes(figure)
    page = figure.bbox
    problems = [
        f"'{text.get_text()}' leaves the page"
        for text, box in boxes
        if box.x0 < page.x0 - _TOLERANCE
        or box.y0 < page.y0 - _TOLERANCE
        or box.x1 > page.x1 + _TOLERANCE
        or box.y1 > page.y1 + _TOLERANCE
    ]
    problems += [
        f"'{text.get_text()}' is {text.get_fontsize():g} pt" for text, _ in boxes if text.get_fontsize() < SMALL
    ]
    problems += [
        f"'{one.get_text()}' overlaps '{other.get_text()}'"
        for (one, a), (other, b) in combinations(boxes, 2)
        if min(a.x1, b.x1) - max(a.x0, b.x0) > _TOLERANCE and min(a.y1, b.y1) - max(a.y0, b.y0) > _TOLERANCE
    ]
    return tuple(problems)


def _boxes(figure: Figure) -> list[tuple[Text, Bbox]]:
    """Return the texts that show, each with its box in pixels."""
    figure.canvas.draw()
    renderer = figure.canvas.get_renderer()  # type: ignore[attr-defined]
    return [(text, text.get_window_extent(renderer)) for text in shown_texts(figure)]
