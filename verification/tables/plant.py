"""The rows of a DH table on the plant: the second route to a proved row, and a configuration that refutes a wrong one."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from verification.algebras import SampledAlgebra
from verification.compare import Pair, entry_errors
from verification.tables.row import PARAMETERS, row_matrix
from verification.equation import TOLERANCE
from verification.matrix import Matrix
from verification.quantities import Quantity
from verification.tables.reading import RowVerdict, TableReading
from verification.tables.tool import Tool
from verification.trig import Scalar
from verification.verdict import Record, Verdict

# rad or m: generic joint variables for a counterexample, the first value and the step; two, lest one equal a length
_GENERIC = ((0.7, -0.15), (0.73, -0.11))


def confirm_rows(found: TableReading, proved: Record, sampled: SampledAlgebra) -> Record:
    """Return the record of a proved table with the largest error of its link matrices on the double plant."""
    worst = 0.0
    for verdict in found.verdicts:
        frames = verdict.row.frames
        if frames is not None:
            pose = sampled.quantity(Quantity("pose", frames.frame, frames.reference))
            worst = max(worst, _largest_error(sampled, pose, _link(found, verdict, sampled)))
    return _confirmed(proved, sampled, worst)


def confirm_tool(found: TableReading, tool: Tool, reference: str, proved: Record, sampled: SampledAlgebra) -> Record:
    """Return the record of a table whose product, followed by a constant rotation, is a pose of the arm."""
    links = [_link(found, verdict, sampled) for verdict in found.verdicts]
    total = links[0]
    for link in links[1:]:
        total = total @ link
    pose = sampled.quantity(Quantity("pose", tool.frame, reference))
    origin = sampled.quantity(Quantity("pose", tool.origin, reference)).block(range(3), [3])
    rotation = total.block(range(3), range(3)) @ sampled.from_exact(tool.turn)
    errors = [(pose.block(range(3), range(3)), rotation), (origin, total.block(range(3), [3]))]
    return _confirmed(proved, sampled, max(_largest_error(sampled, true, printed) for true, printed in errors))


def counterexample(found: TableReading) -> dict[str, float]:
    """Return joint variables and lengths at which the first wrong row's link matrix is not the arm's pose."""
    arm = found.arm
    for first, step in _GENERIC:
        values = {joint.symbol: round(first + step * (joint.index - 1), 2) for joint in arm.joints}
        at = SampledAlgebra(found.claim.algebra, np.array([list(values.values())]))
        for verdict in found.verdicts:
            differences = _differences(found, verdict)
            if any(abs(float(at.from_exact(cell)[0])) > TOLERANCE for cell in differences):
                involved = {
                    name for cell in differences for powers, _ in cell.ring.terms(cell.numerator) for _, name in powers
                }
                everything = {**values, **arm.lengths, **arm.angles}
                return {name: float(value) for name, value in everything.items() if name in involved} or values
    return {}


def _differences(found: TableReading, verdict: RowVerdict) -> list[Scalar]:
    """The entries of the row's link matrix that are wrong, less the right ones."""
    if verdict.holds or verdict.problems or verdict.row.frames is None:
        return []
    pairs = zip(found.pose(verdict.row.frames).rows, found.matrix(verdict).rows, strict=True)
    return [x - y for one, other in pairs for x, y in zip(one, other, strict=True) if not (x - y).is_zero()]


def _link(found: TableReading, verdict: RowVerdict, sampled: SampledAlgebra) -> Matrix:
    values = [sampled.from_exact(verdict.values[parameter]) for parameter in PARAMETERS]
    return row_matrix(sampled, found.convention, *values)


def _confirmed(proved: Record, sampled: SampledAlgebra, worst: float) -> Record:
    if worst > TOLERANCE:
        return replace(
            proved, verdict=Verdict.REFUTED, message="the proof and the double plant disagree", max_error=worst
        )
    return replace(proved, samples=sampled.samples, max_error=worst)


def _largest_error(sampled: SampledAlgebra, true: Matrix, printed: Matrix) -> float:
    """The largest error of an entry over the samples, scaled by its size."""

    def whole(matrix: Matrix) -> Matrix:
        return matrix.map(lambda cell: np.broadcast_to(cell, (sampled.samples,)))

    errors = entry_errors(Pair(whole(true), whole(printed)))
    sizes = np.abs(np.array([list(row) for row in whole(true).rows]))
    return float((errors / (1.0 + sizes)).max())
