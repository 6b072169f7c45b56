"""Velocities at rates that stand in a column: ṗ = J [0.1; 0.2] says which q̇ it is of."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from armproof.verification.evaluation.blocks import cells_of
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare, is_number


def columns_of_numbers(node: n.Node) -> Iterator[tuple[n.Node, ...]]:
    """Yield the columns of numbers, not all of them 0, that are multiplied by what stands before them in a tree."""
    for below in n.walk(node):
        factors = [bare(factor) for factor in below.factors] if isinstance(below, n.Product) else []
        for before, factor in pairwise(factors):
            cells = tuple(cells_of(factor))
            vanishes = all(isinstance(cell, n.Number) and cell.value == 0 for cell in cells)
            if len(cells) > 1 and all(map(is_number, cells)) and not vanishes and not is_number(before):
                yield cells
