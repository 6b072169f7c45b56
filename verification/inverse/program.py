"""All branches of a solution as one straight-line program of NumPy operations, run over targets block by block.

The instructions are data, shared subtrees are computed once, and each writes into a row of memory that is used again as
soon as its value is no longer needed (as models/bulk/program.py does). A target at which a root, a hypotenuse or a denominator
comes near zero is only noted here: rounding.py decides what it is.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np

from armproof.models.bulk.graph import Term
from armproof.models.bulk.program import BLOCK
from armproof.verification.inverse.branch_graph import BranchGraph, operands

TWO_PI = 2.0 * np.pi
Array = np.ndarray
Operation = Callable[[Array, Any, Array, Array], Any]  # left, right, target, scratch


def _hypot(left: Array, right: Array, target: Array, scratch: Array) -> None:
    np.multiply(right, right, scratch)
    np.multiply(left, left, target)
    np.add(target, scratch, target)
    np.sqrt(target, target)


def _wrap(left: Array, _right: Any, target: Array, scratch: Array) -> None:
    """Take whole turns away: the angle in [−π, π]."""
    np.multiply(left, 1.0 / TWO_PI, scratch)
    np.rint(scratch, scratch)
    np.multiply(scratch, TWO_PI, scratch)
    np.subtract(left, scratch, target)


def _opposite(left: Array, _right: Any, target: Array, scratch: Array) -> None:
    np.copysign(np.pi, left, scratch)
    np.subtract(left, scratch, target)


def _mirrored(left: Array, _right: Any, target: Array, scratch: Array) -> None:
    np.copysign(np.pi, left, scratch)
    np.subtract(scratch, left, target)


def _binary(function: np.ufunc) -> Operation:
    return lambda left, right, target, _scratch: function(left, right, target)


def _unary(function: np.ufunc) -> Operation:
    return lambda left, _right, target, _scratch: function(left, target)


OPERATIONS: dict[str, Operation] = {
    "add": _binary(np.add),
    "subtract": _binary(np.subtract),
    "multiply": _binary(np.multiply),
    "divide": _binary(np.divide),
    "cosine": _binary(np.divide),
    "sine": _binary(np.divide),
    "scale": _binary(np.multiply),
    "offset": _binary(np.add),
    "atan2": _binary(np.arctan2),
    "sqrt": _unary(np.sqrt),
    "cos": _unary(np.cos),
    "sin": _unary(np.sin),
    "absolute": _unary(np.absolute),
    "hypot": _hypot,
    "wrap": _wrap,
    "opposite": _opposite,
    "mirrored": _mirrored,
}
_GUARDED = {"sqrt": "left", "divide": "right", "hypot": ""}  # which operand, or the node itself, may not be near zero


class Program:
    """Terms of a graph, compiled once.

    Args:
        outputs: the terms wanted.
        thresholds: for each guarded node (by its place) the size below which a target is doubtful.
    """

    def __init__(self, graph: BranchGraph, outputs: Sequence[Term], thresholds: Mapping[int, float]) -> None:
        self._graph = graph
        self._outputs = outputs
        self._needed = needed_nodes(graph, [term.node for term in outputs if term.factor])
        self._thresholds = thresholds
        self._home: dict[int, int] = {}
        self._height = 0
        self._plan = self._allocate()

    def _allocate(self) -> list[tuple[str, int, int | float, int, int, float]]:
        """Return (operation, left row, right row or number, target row, guarded row, threshold) of each instruction."""
        nodes = self._graph.nodes
        last_use = {operand: place for place in self._needed for operand in operands(nodes[place])}
        loaded = [place for place in self._needed if nodes[place].operation in ("one", "input")]
        first = len(self._outputs)  # the rows of the outputs come first
        self._home = {place: first + row for row, place in enumerate(loaded)}
        self._height = first + len(loaded)
        kept = {term.node for term in self._outputs} | set(loaded)
        free: list[int] = []
        plan = []
        for place in self._needed:
            if place in self._home:
                continue
            node = nodes[place]
            dying = sorted({k for k in operands(node) if k not in kept and last_use[k] == place})
            if not free:
                free.append(self._height)
                self._height += 1
            target = self._home[place] = free.pop()
            free += [self._home[operand] for operand in dying]
            right: int | float = 0
            if node.operation in ("scale", "offset"):
                right = float(node.value)
            elif len(operands(node)) == 2:
                right = self._home[node.right]
            guard, threshold = -1, 0.0
            if place in self._thresholds:
                operand = _GUARDED[node.operation]
                guard = self._home[getattr(node, operand)] if operand else target
                threshold = self._thresholds[place]
            plan.append((node.operation, self._home[node.left], right, target, guard, threshold))
        return plan

    def __call__(self, inputs: Array) -> tuple[Array, Array]:
        """Return the outputs, (N, number of terms), and which targets are doubtful, (N,).

        Args:
            inputs: (N, number of inputs), by the number that each input has for a name.
        """
        values = np.empty((len(inputs), len(self._outputs)))
        doubtful = np.zeros(len(inputs), dtype=bool)
        with np.errstate(all="ignore"):
            for start in range(0, len(inputs), BLOCK):
                block = inputs[start : start + BLOCK]
                if start == 0 or len(block) < BLOCK:
                    memory, bound = self._bind(len(block))
                self._load(memory, block)
                self._run(bound, doubtful[start : start + BLOCK])
                self._store(memory, values[start : start + BLOCK])
        return values, doubtful

    def _bind(self, count: int) -> tuple[Array, list[tuple[Any, ...]]]:
        memory = np.empty((self._height + 1, count))  # the last row is scratch
        rows = list(memory)
        bound = []
        for operation, left, right, target, guard, threshold in self._plan:
            second = rows[right] if isinstance(right, int) else np.array(right)
            guarded = rows[guard] if guard >= 0 else None
            bound.append((OPERATIONS[operation], rows[left], second, rows[target], rows[-1], guarded, threshold))
        return memory, bound

    def _load(self, memory: Array, block: Array) -> None:
        for place in self._needed:
            node = self._graph.nodes[place]
            if node.operation == "input":
                memory[self._home[place]] = block[:, int(node.generator[1])]
            elif node.operation == "one":
                memory[self._home[place]] = 1.0

    def _run(self, bound: list[tuple[Any, ...]], doubtful: Array) -> None:
        near = np.empty(len(doubtful), dtype=bool)
        for operation, left, right, target, scratch, guarded, threshold in bound:
            operation(left, right, target, scratch)
            if guarded is not None:
                np.absolute(guarded, scratch)
                np.less_equal(scratch, threshold, near)
                np.logical_or(doubtful, near, doubtful)

    def _store(self, memory: Array, values: Array) -> None:
        for row, term in enumerate(self._outputs):
            if term.factor and term.node:
                np.multiply(memory[self._home[term.node]], term.factor, memory[row])
            else:
                memory[row] = term.factor
        values[:] = memory[: len(self._outputs)].T


def needed_nodes(graph: BranchGraph, places: Sequence[int]) -> list[int]:
    """Return the nodes that some nodes are made of, and these, each after what it is made of."""
    needed = set(places)
    for place in range(max(needed, default=0), -1, -1):
        if place in needed:
            needed.update(operands(graph.nodes[place]))
    return sorted(needed)
