"""A derivation compiled to numbers: all branches in one graph, its program, and the thresholds of what is doubtful."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from armproof.models.arm import Arm
from armproof.models.bulk.graph import Term
from armproof.models.bulk.inputs import ColumnInputs
from armproof.models.bulk.operations import OPERATIONS
from armproof.models.bulk.program import Program
from armproof.models.numeric.configurations import sample
from armproof.verification.algebra.ring import Ring
from armproof.verification.inverse.branch_graph import BranchGraph
from armproof.verification.inverse.derivation import Derivation
from armproof.verification.inverse.formulas import Formula
from armproof.verification.inverse.numeric_algebra import NumericAlgebra, NumericScalar
from armproof.verification.inverse.resolution import Resolution, forward_values, solve_branch
from armproof.verification.inverse.rounding import CarefulValues, evaluate_carefully
from armproof.verification.inverse.symbolic_algebra import free_algebra, is_angle
from armproof.verification.inverse.target import Target
from armproof.verification.latex import nodes as n

SAMPLES = 384
SEED = 2014
ROOT, LENGTH = 1e-7, 1e-5  # doubtful below: of a radicand, of a hypotenuse or a denominator, relative to its usual size


@dataclass(frozen=True, eq=False)
class Compiled:
    """The numbers of a derivation for given lengths.

    Args:
        values: the number of each length and constant angle of the arm.
    """

    derivation: Derivation
    values: Mapping[str, float]

    @property
    def arm(self) -> Arm:
        """The arm."""
        return self.derivation.arm

    @cached_property
    def _forward(self) -> Program:
        graph = BranchGraph()
        algebra = NumericAlgebra(self.arm, Target((), (0,), ()), graph, self.values)
        for joint in self.arm.joints:
            algebra.solved[joint.symbol] = NumericScalar(graph, graph.input("joint", str(joint.index - 1)))
        return Program(graph, ColumnInputs, [[value.term for value in forward_values(self.derivation, algebra)]])

    def forward(self, q: np.ndarray) -> np.ndarray:
        """Return the target, (N, m), of configurations, (N, n)."""
        return _evaluate(self._forward, q)[0]

    @cached_property
    def angles(self) -> tuple[bool, ...]:
        """Which slots of the target count up to whole turns."""
        forward = forward_values(self.derivation, free_algebra(Ring(), self.arm))
        return tuple(is_angle(value, self.arm) for value in forward)

    @cached_property
    def graph(self) -> BranchGraph:
        """The graph of all branches."""
        return BranchGraph()

    @cached_property
    def outputs(self) -> tuple[tuple[Term, ...], ...]:
        """The joints, base to tool, of each branch."""
        return tuple(tuple(self._joints(signs)) for signs in self.derivation.branches)

    def _joints(self, signs: Mapping[str, int]) -> list[Term]:
        algebra = NumericAlgebra(self.arm, self.derivation.target, self.graph, self.values)
        solved = solve_branch(self.derivation, algebra, signs)
        return [
            self.graph.wrapped(solved[joint.symbol].term) if joint.kind == "revolute" else solved[joint.symbol].term
            for joint in self.arm.joints
        ]

    @cached_property
    def terms(self) -> list[Term]:
        """The joints of all branches, one after the other."""
        return [term for branch in self.outputs for term in branch]

    @cached_property
    def sizes(self) -> np.ndarray:
        """The size of each slot's kind: the farthest coordinate of the workspace, 1 for cosines, π for angles."""
        size = np.where(self.angles, np.pi, np.abs(self.seeds).max(axis=0, initial=0.0))
        for pair in self.derivation.target.pairs:
            cells = self.derivation.target.cells(pair)
            for columns in ({0, 1, 2}, {3}):
                kind = [index for (row, column), index in cells.items() if row < 3 and column in columns]
                size[kind] = size[kind].max(initial=0.0)
        return size

    @cached_property
    def seeds(self) -> np.ndarray:
        """Targets of configurations within the joint limits."""
        q, _ = sample(self.arm, 6 * SAMPLES, np.random.default_rng(SEED), near_singular=False)
        return self.forward(q[:SAMPLES])

    @cached_property
    def branch_nodes(self) -> tuple[list[int], ...]:
        """The nodes of each branch."""
        return tuple(self.graph.needed(branch) for branch in self.outputs)

    def careful(self, targets: np.ndarray) -> CarefulValues:
        """Evaluate targets with error bounds."""
        return evaluate_carefully(self.graph, self.terms, targets, self.sizes)

    def joints_without_rotation(self) -> tuple[str, ...]:
        """Return the joints that are solved first, without the rotations of the target; () where it has none."""
        target = self.derivation.target
        turning = {
            index for pair in target.rotations for (_, column), index in target.cells(pair).items() if column < 3
        }
        found: list[str] = []
        for step in self.derivation.steps if turning else ():
            term = self.outputs[0][self.arm.joint(step.joint).index - 1]
            nodes = [self.graph.nodes[place] for place in self.graph.needed([term])]
            if any(node.operation == "input" and int(node.generator[1]) in turning for node in nodes):
                break
            found.append(step.joint)
        return tuple(found)

    def varies(self, formula: Formula, nodes: Sequence[n.Node]) -> bool:
        """Whether the sum of the squares of some parts of a formula depends on the target, on the first branch."""
        signs = self.derivation.branches[0]
        algebra = NumericAlgebra(self.arm, self.derivation.target, self.graph, self.values)
        solve_branch(self.derivation, algebra, signs)
        resolution = Resolution(self.derivation, algebra, signs)
        program = Program(self.graph, ColumnInputs, [[resolution.part(formula, node).term for node in nodes]])
        values, _ = _evaluate(program, self.seeds)
        square = (values**2).sum(axis=1)
        return bool(np.nanmax(square) - np.nanmin(square) > 1e-9 * np.nanmax(square))

    def solve(self, targets: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return the joints of all branches, (N, number of terms), and which targets are doubtful, (N,).

        What is doubtful is decided by bounds of the rounding errors (rounding.py).
        """
        return _evaluate(self._program, targets)

    @cached_property
    def _program(self) -> Program:
        """The program of all branches; targets at which a guarded node is small for its usual size are doubtful."""
        found = self.careful(self.seeds)
        thresholds = {}
        for place in {*found.degenerate, *found.unreachable}:
            node = self.graph.nodes[place]
            if node.operation == "atan2":  # its hypotenuse is guarded
                continue
            guarded = OPERATIONS[node.operation].guarded
            value = np.abs(found.value[place if guarded == "result" else getattr(node, guarded)])
            size = float(np.max(value, initial=0.0, where=np.isfinite(value)))
            thresholds[place] = size * (ROOT if node.operation == "sqrt" else LENGTH)
        return Program(self.graph, ColumnInputs, [self.terms], thresholds)


def _evaluate(program: Program, values: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the one array of a program, and what is doubtful; what has no value is NaN or infinite without a warning."""
    with np.errstate(all="ignore"):
        (found,), doubtful = program.run(values)
    return found, doubtful
