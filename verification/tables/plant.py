"""A DH table on the double plant: the second route to a proved table, and a configuration that refutes a wrong one."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from functools import reduce

import numpy as np

from armproof.verification.algebra.calculus import symbols_in
from armproof.verification.algebra.matrix import Matrix
from armproof.verification.algebra.quantity import Quantity
from armproof.verification.algebra.ring import Scalar
from armproof.verification.equations.alignment import Pair
from armproof.verification.equations.sampled_errors import entry_errors
from armproof.verification.equations.second_route import TOLERANCE
from armproof.verification.evaluation.sampled import SampledAlgebra
from armproof.verification.findings import Kind, say
from armproof.verification.tables.claim import RowVerdict
from armproof.verification.tables.reading import TableReading
from armproof.verification.tables.row import PARAMETERS, row_matrix
from armproof.verification.tables.tool import Tool
from armproof.verification.verdict import Record, Verdict

# rad or m: generic joint variables for a counterexample, the first value and the step; two, lest one equal a length
_GENERIC = ((0.7, -0.15), (0.73, -0.11))


def sampled_link(found: TableReading, values: Mapping[str, Scalar], sampled: SampledAlgebra) -> Matrix:
    """Return the link matrix of a row's values at the samples."""
    return row_matrix(sampled, found.convention, *(sampled.from_exact(values[parameter]) for parameter in PARAMETERS))


def confirm_rows(found: TableReading, proved: Record, sampled: SampledAlgebra) -> Record:
    """Return the record of a proved table with the largest error of its link matrices on the double plant."""
    pairs = [
        (sampled.quantity(Quantity("pose", frames.frame, frames.reference)), sampled_link(found, v.values, sampled))
        for v in found.verdicts
        if (frames := v.row.frames) is not None
    ]
    return _confirmed(proved, sampled, pairs)


def confirm_tool(found: TableReading, tool: Tool, proved: Record, sampled: SampledAlgebra) -> Record:
    """Return the record of a table whose product, followed by a constant rotation, is a pose of the arm."""
    total = reduce(Matrix.__matmul__, (sampled_link(found, v.values, sampled) for v in found.verdicts))
    rotation = total.block(range(3), range(3)) @ sampled.from_exact(tool.turn)
    base = found.arm.frames[0]
    pairs = [
        (sampled.quantity(Quantity("rotation", tool.frame, base)), rotation),
        (sampled.quantity(Quantity("origin", tool.origin, base)), total.block(range(3), [3])),
    ]
    return _confirmed(proved, sampled, pairs)


def counterexample(found: TableReading) -> dict[str, float]:
    """Return joint variables and lengths at which the first wrong row's link matrix is not the arm's pose."""
    arm = found.arm
    for first, step in _GENERIC:
        values = {joint.symbol: round(first + step * (joint.index - 1), 2) for joint in arm.joints}
        at = SampledAlgebra(found.claim.algebra, np.array([list(values.values())]))
        for verdict in found.verdicts:
            differences = _differences(found, verdict)
            if any(abs(float(at.from_exact(cell)[0])) > TOLERANCE for cell in differences):
                involved = symbols_in(differences)
                everything = {**values, **arm.lengths, **arm.angles}
                return {name: float(value) for name, value in everything.items() if name in involved} or values
    return {}


def _differences(found: TableReading, verdict: RowVerdict) -> list[Scalar]:
    """The entries of the row's link matrix less the right ones, where it is wrong."""
    if verdict.holds or verdict.problems or verdict.row.frames is None:
        return []
    difference = found.pose(verdict.row.frames) + -found.matrix(verdict)
    return [cell for cell in difference.cells if not cell.is_zero()]


def _confirmed(proved: Record, sampled: SampledAlgebra, pairs: list[tuple[Matrix, Matrix]]) -> Record:
    worst = max((_largest_error(sampled, true, printed) for true, printed in pairs), default=0.0)
    if worst > TOLERANCE:
        return replace(proved, verdict=Verdict.REFUTED, findings=(say(Kind.PROOFS_DISAGREE),), max_error=worst)
    return replace(proved, samples=sampled.samples, max_error=worst)


def _largest_error(sampled: SampledAlgebra, true: Matrix, printed: Matrix) -> float:
    """The largest error of an entry over the samples, scaled by its size."""
    true, printed = (m.map(lambda cell: np.broadcast_to(cell, (sampled.samples,))) for m in (true, printed))
    sizes = np.abs(np.array([list(row) for row in true.rows]))
    return float((entry_errors(Pair(true, printed)) / (1.0 + sizes)).max())
