"""Matrices of blocks with names in them: which rows and columns of the value each printed cell stands for."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from armproof.verification.algebra.matrix import Matrix
from armproof.verification.algebra.protocol import Value
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare

_LINEAR, _ANGULAR, _AXES = ("v", "V"), ("omega", "w", "Omega"), ("x", "y", "z")


@dataclass(frozen=True)
class Block:
    """A printed cell and the rows and columns (from 0) of the whole that it stands for."""

    row: int
    column: int
    cell: n.Node
    rows: tuple[int, ...]
    columns: tuple[int, ...]

    @property
    def is_larger(self) -> bool:
        """Whether it is larger than one entry."""
        return len(self.rows) * len(self.columns) > 1

    def of(self, whole: Matrix) -> Value:
        """Return the block's value: a scalar where it is one entry."""
        block = whole.block(self.rows, self.columns)
        return block.rows[0][0] if block.shape == (1, 1) else block


def written_rows(node: n.Node) -> tuple[tuple[n.Node, ...], ...]:
    """Return the cells of a matrix or a list as they stand in its value, a transposed one the other way; () of another tree."""
    node = n.ungrouped(node)
    transposed = isinstance(node, n.Postfix) and node.operator == "T"
    node = n.ungrouped(node.base) if isinstance(node, n.Postfix) and transposed else node
    if isinstance(node, n.Sequence):
        return tuple((item,) for item in node.items)
    rows = node.rows if isinstance(node, n.Matrix) else ()
    return tuple(zip(*rows, strict=False)) if transposed else rows


def rows_of_letters(node: n.Node) -> tuple[tuple[n.Node, ...], ...]:
    """Return the rows of a matrix or a list of letters and numbers alone, with a letter; else ()."""
    rows = written_rows(node)
    cells = [bare(cell) for row in rows for cell in row]
    here = ("", "0")  # {}^BP_x stands in a frame of its own
    alone = all(isinstance(cell, n.Number) or (isinstance(cell, n.Name) and cell.pre_sup in here) for cell in cells)
    return rows if alone and any(isinstance(cell, n.Name) for cell in cells) else ()


def cells_of(node: n.Node) -> Sequence[n.Node]:
    """Return the entries of a list, of a row or of a column, transposed or not; none of another tree."""
    node = bare(node)
    if isinstance(node, n.Postfix) and node.operator == "T":
        node = bare(node.base)
    if isinstance(node, n.Sequence):
        return node.items
    column = isinstance(node, n.Matrix) and (len(node.rows) == 1 or all(len(row) == 1 for row in node.rows))
    return node.cells if isinstance(node, n.Matrix) and column else ()


def partition(printed: Sequence[Sequence[n.Node]], size: tuple[int, int]) -> list[Block] | None:
    """Return the blocks of a value of that size, or None where the printed rows cannot be laid over it.

    One cell an entry; R, p, 0, 1 over a 4×4 pose; n, o, a, p over its columns; J_v over J_ω; v over ω of the plane; columns of a Jacobian.
    """
    heights = _of_the_plane(printed, size) or _shares(len(printed), size[0])
    if heights is None:
        return None
    blocks: list[Block] = []
    top = 0
    for r, (row, height) in enumerate(zip(printed, heights, strict=True)):
        widths = _shares(len(row), size[1])
        if widths is None:
            return None
        left = 0
        for c, (cell, width) in enumerate(zip(row, widths, strict=True)):
            blocks.append(Block(r, c, cell, tuple(range(top, top + height)), tuple(range(left, left + width))))
            left += width
        top += height
    return blocks


def is_twist_of_plane(node: n.Node) -> bool:
    """Whether a tree is [v; ω] of a planar arm, of which v may have two components."""
    return _of_the_plane(written_rows(node), (3, 1)) is not None


def _of_the_plane(printed: Sequence[Sequence[n.Node]], size: tuple[int, int]) -> tuple[int, ...] | None:
    """How three rows fall to a velocity in the plane and to the rate of its one angle: [v; ω], or [ω; v]."""
    cells = [bare(cell) for row in printed for cell in row] if size == (3, 1) else []
    kinds = "".join(map(_velocity_of, cells))
    return {"vω": (2, 1), "ωv": (1, 2)}.get(kinds)


def _velocity_of(cell: n.Node) -> str:
    """Return whether a letter is a velocity, v, or an angular one, ω; its component is neither."""
    if not isinstance(cell, n.Name):
        return "?"
    is_whole = cell.base in _LINEAR and not cell.sub.startswith(_AXES)
    return "v" if is_whole else "ω" if cell.base in _ANGULAR else "?"


def _shares(parts: int, whole: int) -> tuple[int, ...] | None:
    """How a side of the matrix falls to the printed parts: singly, all in one, 3 and 1 of a pose, 3 and 3 of [v; ω]."""
    if parts == whole:
        return (1,) * whole
    if parts == 1:
        return (whole,)
    return {(2, 4): (3, 1), (2, 6): (3, 3)}.get((parts, whole))
