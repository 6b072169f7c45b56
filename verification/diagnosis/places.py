"""The place of an entry: its tree in a matrix written out, and the entry that stands in another's place."""

from __future__ import annotations

from armproof.verification.algebra.matrix import Matrix
from armproof.verification.algebra.protocol import Value
from armproof.verification.algebra.ring import Scalar
from armproof.verification.equations.alignment import Pair, exactly_equal
from armproof.verification.findings import Finding, Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.naming.trees import bare


def find_cell(node: n.Node, row: int, column: int, value: Value = None) -> n.Node | None:
    """Return the tree of a printed entry, where the printed member is a matrix written out.

    `value` is the member's: a matrix of blocks that are names or products has fewer cells than its value has entries.
    """
    node = bare(node)
    if isinstance(node, n.Postfix) and node.operator == "T":
        return find_cell(node.base, column, row, value.transpose if isinstance(value, Matrix) else None)
    if isinstance(node, n.Sequence):
        index = max(row, column)
        return node.items[index] if index < len(node.items) else None
    if not isinstance(node, n.Matrix):
        return None
    if any(isinstance(below, n.Matrix) for cells in node.rows for below in cells):
        return _cell_of_blocks(node, row, column)
    if isinstance(value, Matrix) and (len(node.rows), *{len(cells) for cells in node.rows}) != value.shape:
        return None
    try:
        return node.rows[row][column]
    except IndexError:
        return None


def _cell_of_blocks(node: n.Matrix, row: int, column: int) -> n.Node | None:
    """Follow a place into a matrix of written-out blocks; None where a block's size is not written out."""
    top = 0
    for cells in node.rows:
        sizes = [(len(c.rows), len(c.rows[0])) if isinstance(c, n.Matrix) else (1, 1) for c in cells]
        height = max(size[0] for size in sizes)
        if row < top + height:
            left = 0
            for cell, size in zip(cells, sizes, strict=True):
                if column < left + size[1]:
                    return (
                        find_cell(cell, row - top, column - left)
                        if isinstance(cell, n.Matrix)
                        else cell
                        if height == 1
                        else None
                    )
                left += size[1]
            return None
        top += height
    return None


def moved_cell(pair: Pair, row: int, column: int) -> Finding | None:
    """Return that the printed entry is the true one of another place: swapped cells or a transposed matrix."""
    printed = pair.printed.rows[row][column]
    if not isinstance(printed, Scalar) or printed.as_fraction() is not None:
        return None
    for r, cells in enumerate(pair.true.rows):
        for c, true in enumerate(cells):
            if (r, c) != (row, column) and exactly_equal(true, printed):
                return say(Kind.OF_ANOTHER_ENTRY, other_row=r + 1, other_column=c + 1)
    return None
