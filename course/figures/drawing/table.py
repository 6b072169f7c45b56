"""A small table on a page, ruled as in print: lines above and below, and under the head."""

from __future__ import annotations

from collections.abc import Sequence

from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from armproof.course.figures.drawing.labels import form_tex
from armproof.course.figures.drawing.style import INK, MM, TEXT, text_width
from armproof.course.figures.facts.dh_rows import LinkRows

_GAP = 3.0  # mm between columns
LINE = 4.6  # mm a row


def draw_table(figure: Figure, rows: Sequence[Sequence[str]], *, left: float, top: float, width: float) -> float:
    """Draw a table, its first row the head; returns its width in mm.

    Args:
        left, top: mm from the left and the lower edge of the page; the table is put in the middle of `width`.
    """
    widths = [max(text_width(figure, text) for text in column) for column in zip(*rows, strict=True)]
    total = sum(widths) + _GAP * (len(widths) - 1)
    start = left + (width - total) / 2
    wide, high = figure.get_size_inches() / MM
    for r, row in enumerate(rows):
        x = start
        for text, column in zip(row, widths, strict=True):
            y = top - (r + 0.5) * LINE - (0.8 if r else 0.0)
            figure.text((x + column / 2) / wide, y / high, text, ha="center", va="center", fontsize=TEXT)
            x += column + _GAP
    for y, thick in ((top, 0.8), (top - LINE - 0.4, 0.5), (top - len(rows) * LINE - 1.0, 0.8)):
        ends = [(start - 1.0) / wide, (start + total + 1.0) / wide]
        figure.add_artist(Line2D(ends, [y / high] * 2, color=INK, linewidth=thick, transform=figure.transFigure))
    return total


def table_height(rows: int) -> float:
    """Return the height of a table with so many rows, its head included, in mm."""
    return rows * LINE + 1.0


def dh_texts(rows: LinkRows, lang: str) -> list[list[str]]:
    """Return the DH table as texts, its head first; the order is that of the convention's authors."""
    modified = rows.convention == "modified"
    index = "{i-1}" if modified else "i"
    texts = [["$i$", rf"$a_{index}$", rf"$\alpha_{index}$", "$d_i$", r"$\theta_i$"]]
    for number, row in enumerate(rows.rows, start=1):
        forms = (row.a, row.alpha, row.d, row.theta)
        frame = row.frame if row.frame.isdigit() else str(number)
        texts.append([f"${frame}$", *(f"${form_tex(form, lang)}$" for form in forms)])
    return [[line[0], line[2], line[1], *line[3:]] for line in texts] if modified else texts
