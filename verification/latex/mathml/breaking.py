"""Break what is too wide for a page: the long sums in a matrix's cells, and the members of a chain."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from armproof.verification.latex import nodes as n
from armproof.verification.latex.mathml import box
from armproof.verification.latex.mathml.box import Box

_NARROWEST = 9.0  # em: no sum is broken into shorter lines


def narrowed(
    nodes: Sequence[Sequence[n.Node]],
    boxes: Sequence[Sequence[Box]],
    terms: Callable[[n.Node], list[Box]],
    widest: float,
) -> list[list[Box]]:
    """Return the cells of a matrix, the long sums among them broken into lines so that the matrix fits if it can."""
    cells = [list(row) for row in boxes]
    columns = max(map(len, cells))
    for limit in _limits(cells, columns, widest):
        for r, row in enumerate(cells):
            for c, cell in enumerate(row):
                if cell.width > limit and len(parts := terms(nodes[r][c])) > 1:
                    cells[r][c] = _broken(parts, limit)
        if _width(cells, columns) <= widest:
            break
    return cells


def _limits(cells: Sequence[Sequence[Box]], columns: int, widest: float) -> list[float]:
    """Return the widths to try for a cell, from wide to narrow; none where the matrix fits as it is."""
    if _width(cells, columns) <= widest:
        return []
    return [width for width in (30.0, 24.0, 18.0, 14.0, 11.0, _NARROWEST) if width < widest]


def _width(cells: Sequence[Sequence[Box]], columns: int) -> float:
    return sum(1 + max((row[c].width for row in cells if c < len(row)), default=0.0) for c in range(columns))


def _broken(parts: Sequence[Box], limit: float) -> Box:
    lines = packed(parts, limit)
    return box.table([[(line, "")] for line in lines], "left") if len(lines) > 1 else lines[0]


def packed(parts: Sequence[Box], limit: float) -> list[Box]:
    """Return the parts of a sum or a product on as few lines as their widths allow."""
    lines: list[list[Box]] = [[]]
    for part in parts:
        if lines[-1] and sum(each.width for each in lines[-1]) + part.width > limit:
            lines.append([])
        lines[-1].append(part)
    return [Box(f"<mrow>{inner.markup}</mrow>", inner.width) for inner in map(box.joined, lines)]
