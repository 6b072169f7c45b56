"""The same program with a bound of its rounding errors: what counts as zero, at the few targets where it matters.

Every value carries a first-order bound of its error, from that of the target on (Higham, Accuracy and Stability of
Numerical Algorithms, 2002, section 3.3: running error analysis). A quantity counts as zero where it is not larger than twice
its bound: so the scale of what was subtracted decides, and not a number chosen beforehand. Then

    a radicand that counts as zero is zero: the two signs of the root coincide, an edge; one below is out of reach;
    atan2(y, x) with both arguments zero, and a quotient whose denominator is zero, have no value: the solution degenerates.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np

from armproof.models.bulk.graph import Node, Term
from armproof.models.bulk.operations import TWO_PI
from armproof.verification.inverse.branch_graph import BranchGraph

UNIT = float(np.finfo(float).eps)
SAFETY = 2.0
TARGET_ERROR = 8.0  # units in the last place of the largest number of its kind: as a chain of six poses has

Array = np.ndarray


@dataclass
class CarefulValues:
    """Values and error bounds of all nodes, and the targets at which a guarded node is out of reach or degenerate.

    `unreachable` and `degenerate` hold one (N,) array of booleans for each guarded node, by its place.
    """

    value: dict[int, Array] = field(default_factory=dict)
    error: dict[int, Array] = field(default_factory=dict)
    unreachable: dict[int, Array] = field(default_factory=dict)
    degenerate: dict[int, Array] = field(default_factory=dict)

    def of(self, term: Term, count: int) -> Array:
        """Return the value of a term, (N,)."""
        if not (term.factor and term.node):
            return np.full(count, term.factor)
        return self.value[term.node] * term.factor


def evaluate_carefully(graph: BranchGraph, outputs: Sequence[Term], inputs: Array, sizes: Array) -> CarefulValues:
    """Evaluate the nodes of some terms with error bounds.

    Args:
        inputs: (N, number of inputs).
        sizes: (number of inputs,), the size of each input's kind: that of the workspace for a coordinate, 1 for a cosine.
    """
    found = CarefulValues()
    with np.errstate(all="ignore"):
        for place in graph.needed(outputs):
            node = graph.nodes[place]
            if node.operation == "input":
                column = int(node.generator[1])
                found.value[place] = inputs[:, column]
                found.error[place] = TARGET_ERROR * UNIT * np.maximum(np.abs(inputs[:, column]), sizes[column])
            elif node.operation == "one":
                found.value[place], found.error[place] = np.ones(len(inputs)), np.zeros(len(inputs))
            else:
                found.value[place], found.error[place] = _RULES[node.operation](found, place, node)
    return found


def _counts_as_zero(found: CarefulValues, place: int) -> Array:
    return np.abs(found.value[place]) <= SAFETY * found.error[place]


def _sum(found: CarefulValues, _place: int, node: Node) -> tuple[Array, Array]:
    a, b = found.value[node.left], found.value[node.right]
    value = a + b if node.operation == "add" else a - b
    return value, found.error[node.left] + found.error[node.right] + UNIT * np.abs(value)


def _product(found: CarefulValues, _place: int, node: Node) -> tuple[Array, Array]:
    a, b = np.abs(found.value[node.left]), np.abs(found.value[node.right])
    e, f = found.error[node.left], found.error[node.right]
    return found.value[node.left] * found.value[node.right], a * f + b * e + e * f + UNIT * a * b


def _scaled(found: CarefulValues, _place: int, node: Node) -> tuple[Array, Array]:
    if node.operation == "offset":
        value = found.value[node.left] + node.value
        return value, found.error[node.left] + UNIT * np.maximum(np.abs(value), abs(node.value))
    value = found.value[node.left] * node.value
    return value, found.error[node.left] * abs(node.value) + UNIT * np.abs(value)


def _quotient(found: CarefulValues, place: int, node: Node) -> tuple[Array, Array]:
    a, b = found.value[node.left], found.value[node.right]
    value = a / b
    found.degenerate[place] = _counts_as_zero(found, node.right)
    error = (found.error[node.left] + np.abs(value) * found.error[node.right]) / np.abs(b) + UNIT * np.abs(value)
    return value, error


def _root(found: CarefulValues, place: int, node: Node) -> tuple[Array, Array]:
    square, error = found.value[node.left], found.error[node.left]
    zero = _counts_as_zero(found, node.left)
    found.unreachable[place] = ~zero & ~(square > 0)
    value = np.sqrt(np.where(zero, 0.0, square))
    # where it counts as zero the target is taken to stand on the edge, which is there within its own error: the root is exact
    return value, np.where(zero, 0.0, error / (2.0 * value) + UNIT * value)


def _hypotenuse(found: CarefulValues, place: int, node: Node) -> tuple[Array, Array]:
    a, b = found.value[node.left], found.value[node.right]
    found.degenerate[place] = _counts_as_zero(found, node.left) & _counts_as_zero(found, node.right)
    value = np.where(found.degenerate[place], 0.0, np.hypot(a, b))
    return value, found.error[node.left] + found.error[node.right] + 2.0 * UNIT * value


def _direction(found: CarefulValues, _place: int, node: Node) -> tuple[Array, Array]:
    """Cosine or sine of atan2: a side over the hypotenuse; where both sides vanish the angle is taken as 0."""
    side, radius = found.value[node.left], found.value[node.right]
    flat = found.degenerate[node.right]
    value = np.where(flat, 1.0 if node.operation == "cosine" else 0.0, side / radius)
    return value, np.where(flat, 0.0, 2.0 * found.error[node.right] / radius + 2.0 * UNIT)


def _arc(found: CarefulValues, place: int, node: Node) -> tuple[Array, Array]:
    y, x = found.value[node.left], found.value[node.right]
    e, f = found.error[node.left], found.error[node.right]
    found.degenerate[place] = _counts_as_zero(found, node.left) & _counts_as_zero(found, node.right)
    value = np.where(found.degenerate[place], 0.0, np.arctan2(y, x))
    radius = np.hypot(y, x)
    return value, np.where(found.degenerate[place], 0.0, (e + f) / radius + UNIT * np.abs(value))


def _turning(found: CarefulValues, _place: int, node: Node) -> tuple[Array, Array]:
    angle = found.value[node.left]
    value = np.cos(angle) if node.operation == "cos" else np.sin(angle)
    return value, found.error[node.left] + UNIT


def _size(found: CarefulValues, _place: int, node: Node) -> tuple[Array, Array]:
    return np.abs(found.value[node.left]), found.error[node.left]


def _unwound(found: CarefulValues, _place: int, node: Node) -> tuple[Array, Array]:
    angle = found.value[node.left]
    return angle - TWO_PI * np.rint(angle / TWO_PI), found.error[node.left] + UNIT * np.abs(angle)


def _reflected(found: CarefulValues, _place: int, node: Node) -> tuple[Array, Array]:
    angle = found.value[node.left]
    turned = angle - np.copysign(np.pi, angle)
    return turned if node.operation == "opposite" else -turned, found.error[node.left] + UNIT * np.pi


_RULES = {
    "add": _sum,
    "subtract": _sum,
    "multiply": _product,
    "scale": _scaled,
    "offset": _scaled,
    "divide": _quotient,
    "sqrt": _root,
    "hypot": _hypotenuse,
    "cosine": _direction,
    "sine": _direction,
    "atan2": _arc,
    "cos": _turning,
    "sin": _turning,
    "absolute": _size,
    "wrap": _unwound,
    "opposite": _reflected,
    "mirrored": _reflected,
}
