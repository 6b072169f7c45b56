"""Numeric matrices: what is printed of a pose at one configuration, to so many decimals."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from decimal import Decimal

from armproof.verification.algebra.matrix import Matrix
from armproof.verification.latex import nodes as n

FEW = 3  # entries: more wrong ones than that, and another configuration is meant


def is_numeric(node: n.Node) -> bool:
    """Whether a tree is a square matrix of numbers, or one with decimals: a pose or a point at a configuration."""
    node = n.ungrouped(node)
    if not isinstance(node, n.Matrix):
        return False
    square = len(node.rows) >= 3 and all(len(row) == len(node.rows) for row in node.rows)
    if not square and not any(isinstance(below, n.Number) and "." in below.text for below in n.walk(node)):
        return False
    return not any(isinstance(below, n.Name | n.Call | n.JointAngles | n.Dots) for below in n.walk(node))


def depends_on(value: Matrix, symbols: set[str]) -> bool:
    """Whether one of these symbols stands in an exact matrix."""
    return any(
        name in symbols
        for row in value.rows
        for cell in row
        for part in (cell.numerator, cell.denominator)
        for powers, _ in cell.ring.terms(part)
        for _, name in powers
    )


def coarsest_decimals(nodes: Iterable[n.Node], rounded: Mapping[str, int]) -> int | None:
    """Return the fewest decimals, from three on, of the numbers in these trees and of the names made of such; None without."""
    places = []
    for below in (below for node in nodes for below in n.walk(node)):
        if isinstance(below, n.Number) and "." in below.text:
            places.append(_places(below))
        elif isinstance(below, n.Name) and below.key in rounded:
            places.append(rounded[below.key])
    return min((count for count in places if count >= 3), default=None)


def finest_decimals(nodes: Iterable[n.Node]) -> int:
    """Return the most decimals of the numbers in these trees, 0 without."""
    return max(
        (_places(b) for node in nodes for b in n.walk(node) if isinstance(b, n.Number) and "." in b.text), default=0
    )


def fewest_decimals(nodes: Iterable[n.Node]) -> int:
    """Return to how many decimals numbers are printed: the fewest of the sides that are one number, else of all; 6 without."""
    nodes = [n.ungrouped(node) for node in nodes]
    alone = [node for node in nodes if isinstance(node, n.Number)]
    inside = [
        b for node in nodes for b in n.walk(node) if isinstance(b, n.Number) and "." in b.text.replace("{,}", ".")
    ]
    return min(map(_places, alone or inside), default=6)


def is_number(node: n.Node) -> bool:
    """Whether a tree is made of numbers, π and functions of them."""
    return not any(
        isinstance(below, n.JointAngles | n.Matrix | n.Sequence) or (isinstance(below, n.Name) and below.key != "pi")
        for below in n.walk(node)
    )


def _places(number: n.Number) -> int:
    return -int(Decimal(number.text.replace("{,}", ".")).as_tuple().exponent)


def printed_decimals(node: n.Node) -> int:
    """Return the decimals to which a matrix is printed; whole numbers and fractions are exact."""
    places = [_places(below) for below in n.walk(node) if isinstance(below, n.Number) and below.value.denominator != 1]
    return max(places, default=9)
