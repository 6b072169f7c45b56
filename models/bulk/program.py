"""Straight-line programs: the nodes of a graph as NumPy instructions, run over many configurations block by block.

A block is small enough for its intermediate arrays to stay in the cache, and each instruction writes into a row that is
used again as soon as its value is no longer needed. The instructions are data; no source code is generated.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from armproof.models.bulk.graph import Graph, Node, Term
from armproof.models.bulk.inputs import Inputs
from armproof.models.bulk.operations import OPERATIONS
from armproof.models.exact.polynomial import Generator

BLOCK = 1024  # configurations; an intermediate array is 8 KiB, all of them fit into the second-level cache
_SCRATCH, _NEAR, _DOUBTFUL = -3, -2, -1  # the last rows: of numbers, of booleans, of booleans


class Instruction(NamedTuple):
    """operation(*operands): each operand is the index of a row, or a number as an array of no axes."""

    operation: Callable[..., Any]
    operands: tuple[int | np.ndarray, ...]


class Program:
    """Terms of a graph, compiled once, evaluated at as many configurations as one likes.

    A program holds no working memory: threads may share it.
    """

    def __init__(
        self,
        graph: Graph,
        inputs: Callable[[set[Generator]], Inputs],
        groups: Sequence[Sequence[Term]],
        thresholds: Mapping[int, float] | None = None,
    ) -> None:
        """Compile groups of terms; each group becomes one array, (N, number of its terms).

        Args:
            inputs: what computes those inputs of the graph that occur.
            thresholds: for each guarded node (by its place) the size below which a configuration is doubtful.
        """
        self._sizes = [len(group) for group in groups]
        outputs = [term if term.factor else Term(0, 0.0) for group in groups for term in group]
        self._constants = {row: term.factor for row, term in enumerate(outputs) if not term.node}
        needed = graph.needed(outputs)
        occurring = {graph.nodes[place].generator for place in needed if graph.nodes[place].operation == "input"}
        self._inputs = inputs(occurring)
        rows = _Rows(graph, outputs, needed, self._inputs.generators)
        if 0 in needed:
            self._constants[rows.home[0]] = 1.0
        self.instructions = _compile(graph, outputs, needed, rows, thresholds or {})
        self._height = rows.height

    def __call__(self, values: np.ndarray) -> list[np.ndarray]:
        """Return one (N, size) array for each group of terms.

        Args:
            values: (N, columns) array of doubles, as the inputs take them: joint variables (rad, m), or targets.
        """
        return self.run(values)[0]

    def run(self, values: np.ndarray) -> tuple[list[np.ndarray], np.ndarray]:
        """Return the arrays, and at which configurations a guarded node is below its threshold, (N,) booleans."""
        results = [np.empty((len(values), size)) for size in self._sizes]
        doubtful = np.zeros(len(values), dtype=bool)
        whole = len(values) - len(values) % BLOCK
        for part in (slice(0, whole), slice(whole, len(values))):
            if len(values[part]):
                self._run(values[part], [result[part] for result in results], doubtful[part])
        return results, doubtful

    def _run(self, values: np.ndarray, results: Sequence[np.ndarray], doubtful: np.ndarray) -> None:
        """Evaluate whole blocks, or less than one."""
        workspace = np.empty((self._height + 1, min(len(values), BLOCK)))
        near, found = np.zeros((2, workspace.shape[1]), dtype=bool)
        for row, value in self._constants.items():
            workspace[row] = value
        rows = [*workspace, near, found]
        bound = [
            (operation, tuple(rows[operand] if isinstance(operand, int) else operand for operand in operands))
            for operation, operands in self.instructions
        ]
        first = sum(self._sizes)
        inputs = workspace[first : first + len(self._inputs.generators)]
        with np.errstate(under="ignore"):
            for start in range(0, len(values), BLOCK):
                block = slice(start, start + BLOCK)
                found[:] = False
                self._inputs.write(inputs, values[block])
                for operation, operands in bound:
                    operation(*operands)
                self._hand_out(workspace, [result[block] for result in results])
                doubtful[block] = found

    def _hand_out(self, workspace: np.ndarray, results: Sequence[np.ndarray]) -> None:
        first = 0
        for result in results:
            size = result.shape[1]
            result[:] = workspace[first : first + size].T
            first += size


class _Rows:
    """The row of the working memory that holds each node: first the outputs, then the inputs, then whichever is free."""

    def __init__(
        self, graph: Graph, outputs: Sequence[Term], needed: Sequence[int], inputs: Sequence[Generator]
    ) -> None:
        nodes = self._nodes = graph.nodes
        places = {generator: row for row, generator in enumerate(inputs, start=len(outputs))}
        self.home = {
            term.node: row for row, term in reversed(list(enumerate(outputs))) if term.node and term.factor == 1
        }
        self.home |= {place: places[nodes[place].generator] for place in needed if nodes[place].operation == "input"}
        self.height = len(outputs) + len(inputs)
        if 0 in needed:
            self.home[0] = self.height
            self.height += 1
        self._kept = {*self.home, *(term.node for term in outputs)}
        self._last_use = {operand: place for place in needed for operand in nodes[place].operands}
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


def _compile(
    graph: Graph, outputs: Sequence[Term], needed: Sequence[int], rows: _Rows, thresholds: Mapping[int, float]
) -> list[Instruction]:
    """Return the instructions: those of the nodes, then those that finish the outputs."""
    instructions: list[Instruction] = []
    for place in needed:
        node = graph.nodes[place]
        if node.operation in ("one", "input"):
            continue
        own = _instruction(node, rows, place)
        if place in thresholds:
            guarded = OPERATIONS[node.operation].guarded
            guard = _guard(rows.home[place if guarded == "result" else getattr(node, guarded)], thresholds[place])
            # What guards an operand comes first: its row may be that of the result.
            instructions += [own, *guard] if guarded == "result" else [*guard, own]
        else:
            instructions.append(own)
    for row, term in enumerate(outputs):
        if term.node and rows.home[term.node] != row:
            instructions.append(Instruction(np.multiply, (rows.home[term.node], np.array(term.factor), row)))
    return instructions


def _instruction(node: Node, rows: _Rows, place: int) -> Instruction:
    operation = OPERATIONS[node.operation]
    operands: list[int | np.ndarray] = [rows.home[operand] for operand in node.operands]
    if operation.has_number:
        operands.append(np.array(node.value))
    operands.append(rows.target(place))
    if operation.has_scratch:
        operands.append(_SCRATCH)
    return Instruction(operation.run, tuple(operands))


def _guard(row: int, threshold: float) -> list[Instruction]:
    """Return what adds to the doubtful those configurations at which a row is not larger than a threshold."""
    return [
        Instruction(np.absolute, (row, _SCRATCH)),
        Instruction(np.less_equal, (_SCRATCH, np.array(threshold), _NEAR)),
        Instruction(np.logical_or, (_DOUBTFUL, _NEAR, _DOUBTFUL)),
    ]
