"""Velocities at rates that stand in a column: ṗ = J [0.1; 0.2] says which q̇ it is of."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise

from armproof.verification.algebra.calculus import symbol_of
from armproof.verification.algebra.ring import Scalar
from armproof.verification.equations.decimals import is_number
from armproof.verification.evaluation.blocks import cells_of
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare


def is_rate(symbol: str) -> bool:
    """Whether a symbol is the rate of a joint, or a higher derivative."""
    return symbol.startswith("dot")


def are_rates(cells: Sequence[Scalar]) -> bool:
    """Whether every cell is a rate by itself, as in q̇."""
    symbols = [symbol_of(cell) for cell in cells]
    return bool(symbols) and all(symbol is not None and is_rate(symbol) for symbol in symbols)


def columns_of_numbers(node: n.Node) -> Iterator[tuple[n.Node, ...]]:
    """Yield the columns of numbers, not all of them 0, that are multiplied by what stands before them in a tree."""
    for below in n.walk(node):
        factors = [bare(factor) for factor in below.factors] if isinstance(below, n.Product) else []
        for before, factor in pairwise(factors):
            cells = tuple(cells_of(factor))
            vanishes = all(isinstance(cell, n.Number) and cell.value == 0 for cell in cells)
            if len(cells) > 1 and all(map(is_number, cells)) and not vanishes and not is_number(before):
                yield cells
