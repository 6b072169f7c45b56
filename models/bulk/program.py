"""Straight-line programs: the nodes of a graph as NumPy instructions, run over many configurations block by block.

A block is small enough for its intermediate arrays to stay in the cache, and each instruction writes into a row that is
used again as soon as its value is no longer needed. The instructions are data; no source code is generated.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from armproof.models.arm import Joint
from armproof.models.bulk.graph import Graph, Term
from armproof.models.exact.polynomial import Generator

BLOCK = 1024  # configurations; an intermediate array is 8 KiB, all of them fit into the second-level cache

_OPERATIONS = {
    "add": np.add,
    "subtract": np.subtract,
    "multiply": np.multiply,
    "scale": np.multiply,
    "offset": np.add,
}


class Instruction(NamedTuple):
    """rows[target] = operation(rows[left], right); `right` is the index of a row, or a number as an array of no axes."""

    operation: np.ufunc
    left: int
    right: int | np.ndarray
    target: int


class Program:
    """Terms of a graph, compiled once, evaluated at as many configurations as one likes.

    A program holds no working memory: threads may share it.
    """

    def __init__(self, graph: Graph, joints: Sequence[Joint], groups: Sequence[Sequence[Term]]) -> None:
        """Compile groups of terms; each group becomes one array, (N, number of its terms)."""
        self._sizes = [len(group) for group in groups]
        outputs = [term for group in groups for term in group]
        self._constants = {row: term.factor for row, term in enumerate(outputs) if not term.node}
        names = {graph.nodes[place].generator[1] for place in graph.needed(outputs)}
        self._angles, self._slides = (_inputs(joints, kind, names) for kind in ("revolute", "prismatic"))
        self.instructions, self._height = _compile(graph, outputs, self._input_rows(len(outputs)))

    def _input_rows(self, start: int) -> dict[Generator, int]:
        """Return the row of each input: the cosines, the sines, the variables of prismatic joints."""
        cosines, sines = ([(kind, name) for name, _ in self._angles] for kind in ("cos", "sin"))
        slides = [("symbol", name) for name, _ in self._slides]
        return {generator: start + place for place, generator in enumerate([*cosines, *sines, *slides])}

    def __call__(self, q: np.ndarray) -> list[np.ndarray]:
        """Return one (N, size) array for each group of terms.

        Args:
            q: (N, n) array of doubles, joint variables from base to tool (rad, m).
        """
        results = [np.empty((len(q), size)) for size in self._sizes]
        whole = len(q) - len(q) % BLOCK
        for part in (slice(0, whole), slice(whole, len(q))):
            if len(q[part]):
                self._run(q[part], [result[part] for result in results])
        return results

    def _run(self, q: np.ndarray, results: Sequence[np.ndarray]) -> None:
        """Evaluate whole blocks, or less than one."""
        workspace = np.empty((self._height, min(len(q), BLOCK)))
        for row, value in self._constants.items():
            workspace[row] = value
        rows = list(workspace)
        bound = [
            (operation, rows[left], rows[right] if isinstance(right, int) else right, rows[target])
            for operation, left, right, target in self.instructions
        ]
        with np.errstate(under="ignore"):
            for start in range(0, len(q), BLOCK):
                block = slice(start, start + BLOCK)
                self._set_inputs(workspace, q[block])
                for operation, left, right, target in bound:
                    operation(left, right, target)
                self._hand_out(workspace, [result[block] for result in results])

    def _set_inputs(self, workspace: np.ndarray, block: np.ndarray) -> None:
        """Write cosines, sines and prismatic variables, by t = tan θ/2: cos θ = 2/(1 + t²) − 1, sin θ = 2t/(1 + t²).

        One tangent and one division take less than half the time of a cosine and a sine, and both come out within 4e-16.
        """
        first, count = sum(self._sizes), len(self._angles)
        cosines = workspace[first : first + count]
        sines = workspace[first + count : first + 2 * count]
        for row, (_, column) in zip(sines, self._angles, strict=True):
            np.multiply(block[:, column], 0.5, row)
        np.tan(sines, sines)
        np.multiply(sines, sines, cosines)
        np.add(cosines, 1.0, cosines)
        np.divide(2.0, cosines, cosines)
        np.multiply(sines, cosines, sines)
        np.subtract(cosines, 1.0, cosines)
        for row, (_, column) in enumerate(self._slides, first + 2 * count):
            workspace[row] = block[:, column]

    def _hand_out(self, workspace: np.ndarray, results: Sequence[np.ndarray]) -> None:
        first = 0
        for result in results:
            size = result.shape[1]
            result[:] = workspace[first : first + size].T
            first += size


def _inputs(joints: Sequence[Joint], kind: str, names: set[str]) -> list[tuple[str, int]]:
    """Return the joint variables of a kind that occur, each with its column of q."""
    return [(joint.symbol, joint.index - 1) for joint in joints if joint.kind == kind and joint.symbol in names]


class _Rows:
    """The row of the working memory that holds each node: first the outputs, then the inputs, then whichever is free."""

    def __init__(self, graph: Graph, outputs: Sequence[Term], inputs: dict[Generator, int]) -> None:
        needed = graph.needed(outputs)
        self.home = {term.node: row for row, term in reversed(list(enumerate(outputs))) if term.factor == 1}
        self.home |= {i: inputs[graph.nodes[i].generator] for i in needed if graph.nodes[i].operation == "input"}
        self.height = len(outputs) + len(inputs)
        self._nodes = graph.nodes
        self._kept = {*self.home, *(term.node for term in outputs)}
        self._last_use = {operand: place for place in needed for operand in graph.nodes[place].operands}
        self._free: list[int] = []

    def target(self, place: int) -> int:
        """Return the row for the next node, which may be that of an operand that is not needed any more."""
        for operand in sorted(set(self._nodes[place].operands) - self._kept):
            if self._last_use[operand] == place:
                self._free.append(self.home[operand])
        if place not in self.home:
            if not self._free:
                self._free.append(self.height)
                self.height += 1
            self.home[place] = self._free.pop()
        return self.home[place]


def _compile(graph: Graph, outputs: Sequence[Term], inputs: dict[Generator, int]) -> tuple[list[Instruction], int]:
    """Return the instructions, and the number of rows that they work on."""
    rows = _Rows(graph, outputs, inputs)
    instructions = []
    for place in graph.needed(outputs):
        node = graph.nodes[place]
        if node.operation != "input":
            target = rows.target(place)
            right = rows.home[node.right] if len(node.operands) == 2 else np.array(node.value)
            instructions.append(Instruction(_OPERATIONS[node.operation], rows.home[node.left], right, target))
    for row, term in enumerate(outputs):
        if term.node and rows.home[term.node] != row:
            instructions.append(Instruction(np.multiply, rows.home[term.node], np.array(term.factor), row))
    return instructions, rows.height
