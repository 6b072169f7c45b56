"""Panels side by side on a page, each with a title of a few lines."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from matplotlib.figure import Figure

from armproof.course.figures.drawing.style import GREY, MM, SMALL, TEXT, WIDTHS, Box, new_figure, text_width

_LINE = 3.9  # mm
_PAD = 2.0  # mm


@dataclass(frozen=True)
class Panel:
    """A panel: its box (left, bottom, width, height in mm), and the height of the title above it."""

    box: Box
    head: float


_BREAK = re.compile(r"(?<=[^{(\s]) (?=[+-] )")


@dataclass(frozen=True)
class PanelTitle:
    """The title of a panel, after its letter, and facts below it; mathematics if `is_math`, broken where it is too long."""

    text: str
    facts: Sequence[str]
    is_math: bool = False
    letter: str = ""


def columns_of(count: int) -> int:
    """Return how many panels stand in a row: three, or two where four are."""
    return {1: 1, 2: 2, 4: 2}.get(count, 3)


def make_panels(titles: Sequence[PanelTitle], height: float) -> tuple[Figure, list[Panel]]:
    """Return a page with a panel for each title, and the titles written above them.

    Args:
        height: mm of a panel without its title.
    """
    columns = columns_of(len(titles))
    width = WIDTHS["page"] / columns
    probe = new_figure("page", 20.0)
    lines = [title_lines(probe, title, width - _PAD) for title in titles]
    rows = [lines[first : first + columns] for first in range(0, len(lines), columns)]
    heads = [max(len(each) for each in row) * _LINE for row in rows]
    figure = new_figure("page", sum(heads) + len(rows) * height + 2 * _PAD)
    panels, top = [], sum(heads) + len(rows) * height + _PAD
    for row, head in zip(rows, heads, strict=True):
        top -= head + height
        start = (columns - len(row)) * width / 2  # the last row stands in the middle
        for column, each in enumerate(row):
            panels.append(Panel((start + column * width, top, width, height), head))
            _write(figure, panels[-1], each)
    return figure, panels


def _write(figure: Figure, panel: Panel, lines: Sequence[tuple[str, bool]]) -> None:
    """Write the lines of a title from the top."""
    left, bottom, width, height = panel.box
    wide, high = figure.get_size_inches() / MM
    for k, (text, is_fact) in enumerate(lines):
        y = bottom + height + panel.head - (k + 0.5) * _LINE
        style: dict[str, Any] = {"fontsize": SMALL, "color": GREY} if is_fact else {"fontsize": TEXT}
        figure.text((left + width / 2) / wide, y / high, text, ha="center", va="center", **style)


def title_lines(figure: Figure, title: PanelTitle, width: float) -> list[tuple[str, bool]]:
    """Return the lines of a title that fit a width in mm, each with whether it is one of the facts."""
    heads = _wrap(figure, _BREAK.split(title.text), " ", width - 5, "$") if title.is_math else [title.text]
    heads[0] = f"{title.letter}) {heads[0]}" if title.letter else heads[0]
    facts = _wrap(figure, list(title.facts), " · ", width, "")
    return [(line, False) for line in heads] + [(line, True) for line in facts]


def _wrap(figure: Figure, parts: list[str], between: str, width: float, dollar: str) -> list[str]:
    """Return lines of parts, as many in each as fit."""
    lines = parts[:1]
    for part in parts[1:]:
        longer = f"{lines[-1]}{between}{part}"
        if text_width(figure, f"{dollar}{longer}{dollar}") <= width:
            lines[-1] = longer
        else:
            lines.append(part)
    return [f"{dollar}{line}{dollar}" for line in lines]
