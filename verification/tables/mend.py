"""The one entry of a DH table that is wrong where the arm's own frames are no DH frames: found by trying changes.

Each change is tried on a few configurations of the double plant; one that brings the table's last frame to the arm's is
proved exactly afterwards.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction

import numpy as np

from verification.algebras import SampledAlgebra
from verification.tables.row import ANGLES, PARAMETERS, row_matrix, within_a_turn
from verification.quantities import Quantity, numbered_frames
from verification.tables.reading import RowVerdict, TableReading
from verification.trig import Scalar

CONFIGURATIONS = 4
NEAR = 1e-9


@dataclass(frozen=True)
class Mend:
    """A change of one entry that mends the table."""

    verdict: RowVerdict
    parameter: str
    value: Scalar


def single_mends(found: TableReading) -> Iterator[Mend]:
    """Yield the changes of one entry under which the table's last frame lies at the arm's and stands still in it."""
    if any(verdict.problems for verdict in found.verdicts):
        return
    joints = len(found.arm.joints)
    q = np.random.default_rng(2019).uniform(-2.0, 2.0, (CONFIGURATIONS, joints))
    sampled = SampledAlgebra(found.claim.algebra, q)
    frames = numbered_frames(found.arm)
    last = [frames[-1], *(frame for frame in found.arm.frames if frame not in frames)]
    goals = [_stack(sampled.quantity(Quantity("pose", frame, frames[0])), len(q)) for frame in last]
    links = [_link(found, verdict.values, sampled) for verdict in found.verdicts]
    for k, verdict in enumerate(found.verdicts):
        before, after = _product(links[:k], len(q)), _product(links[k + 1 :], len(q))
        for parameter in PARAMETERS:
            if found.reading.columns[parameter] is None:
                continue
            for value in _changes(found, verdict, parameter):
                product = before @ _link(found, {**verdict.values, parameter: value}, sampled) @ after
                if any(_is_at(product, goal) for goal in goals):
                    yield Mend(verdict, parameter, value)


def _changes(found: TableReading, verdict: RowVerdict, parameter: str) -> Iterator[Scalar]:
    """Yield other values of an entry: its negative, 0, a length more, less or instead, a quarter turn or half a turn more."""
    algebra = found.claim.algebra
    ring = algebra.ring
    printed = verdict.values[parameter]
    if parameter in ANGLES:
        for turns in (Fraction(1, 2), Fraction(-1, 2), Fraction(1)):
            yield within_a_turn(printed, turns)
        own = found.joint_symbol(verdict.row)
        others = [ring.symbol(own)] if own is not None and parameter == "theta" else []
        yield from (change for change in (-printed, ring.zero, *others) if not (change - printed).is_zero())
        return
    lengths = [found.claim.lengths.get(symbol, ring.symbol(symbol)) for symbol in found.arm.lengths]
    bases = [ring.zero, -printed, *(sign * length for length in lengths for sign in (1, -1))]
    bases += [printed + sign * length for length in lengths for sign in (1, -1)]
    bases += [one + other for k, one in enumerate(lengths) for other in lengths[k + 1 :]]
    yield from (change for change in bases if not (change - printed).is_zero())


def _link(found: TableReading, values: dict[str, Scalar], sampled: SampledAlgebra) -> np.ndarray:
    numbers = [sampled.from_exact(values[parameter]) for parameter in PARAMETERS]
    return _stack(row_matrix(sampled, found.convention, *numbers), sampled.samples)


def _stack(matrix: object, samples: int) -> np.ndarray:
    cells = [[np.broadcast_to(cell, (samples,)) for cell in row] for row in matrix.rows]  # type: ignore[attr-defined]
    return np.moveaxis(np.array(cells), -1, 0)


def _product(links: list[np.ndarray], samples: int) -> np.ndarray:
    total = np.broadcast_to(np.eye(4), (samples, 4, 4))
    for link in links:
        total = total @ link
    return total


def _is_at(product: np.ndarray, goal: np.ndarray) -> bool:
    """Whether the origins agree and the rotation between is the same at all configurations."""
    if np.abs(product[:, :3, 3] - goal[:, :3, 3]).max() > NEAR:
        return False
    turn = product[:, :3, :3].transpose(0, 2, 1) @ goal[:, :3, :3]
    return bool(np.abs(turn - turn[0]).max() < NEAR)
