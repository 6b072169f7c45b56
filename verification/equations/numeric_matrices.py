"""Numeric matrices: what is printed of a pose at one configuration, to so many decimals."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from decimal import Decimal

import numpy as np

from armproof.verification.algebra.matrix import Matrix
from armproof.verification.evaluation.sampled import SampledAlgebra
from armproof.verification.latex import nodes as n

FEW = 3  # entries: more wrong ones than that, and another configuration is meant


@dataclass(frozen=True)
class NumericComparison:
    """Which entries of a numeric matrix differ, and which hang on a joint or a length that has no value."""

    wrong: list[tuple[int, int]]
    open: list[tuple[int, int]]
    largest: float


def is_numeric(node: n.Node) -> bool:
    """Whether a tree is a square matrix of numbers, or one with decimals: a pose or a point at a configuration."""
    node = n.ungrouped(node)
    if not isinstance(node, n.Matrix):
        return False
    square = len(node.rows) >= 3 and all(len(row) == len(node.rows) for row in node.rows)
    if not square and not any(isinstance(below, n.Number) and "." in below.text for below in n.walk(node)):
        return False
    return not any(isinstance(below, n.Name | n.Call | n.JointAngles | n.Dots) for below in n.walk(node))


def depends_on_joints(value: Matrix, joints: set[str]) -> bool:
    """Whether an exact matrix changes with the arm's configuration."""
    return any(
        name in joints
        for row in value.rows
        for cell in row
        for part in (cell.numerator, cell.denominator)
        for powers, _ in cell.ring.terms(part)
        for _, name in powers
    )


def compare_numbers(
    true: Matrix, printed: Matrix, node: n.Node, sampled: SampledAlgebra, configuration: Mapping[str, float]
) -> NumericComparison:
    """Compare entry by entry, within one unit of the last decimal printed, at the values that the document gave before."""
    assert sampled.arm is not None
    symbols = [joint.symbol for joint in sampled.arm.joints] + [*sampled.arm.lengths]
    values = {symbol: np.array([configuration.get(symbol, np.nan)]) for symbol in symbols}
    there = SampledAlgebra(sampled.exact, sampled.q[:1], sampled.seed, values)
    tolerance = 10.0 ** -_decimals(node)
    wrong, left_open, largest = [], [], 0.0
    for r, (true_row, printed_row) in enumerate(zip(true.rows, printed.rows, strict=True)):
        for c, (a, b) in enumerate(zip(true_row, printed_row, strict=True)):
            error = float(np.abs(there.from_exact(a) - there.from_exact(b))[0])
            if np.isnan(error):
                left_open.append((r, c))
            elif error > tolerance:
                wrong.append((r, c))
            else:
                largest = max(largest, error)
    return NumericComparison(wrong, left_open, largest)


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


def _places(number: n.Number) -> int:
    return -int(Decimal(number.text.replace("{,}", ".")).as_tuple().exponent)


def _decimals(node: n.Node) -> int:
    """The decimals to which the matrix is printed; whole numbers and fractions are exact."""
    places = [_places(below) for below in n.walk(node) if isinstance(below, n.Number) and below.value.denominator != 1]
    return max(places, default=9)
