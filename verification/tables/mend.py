"""The one entry of a DH table that is wrong where the arm's own frames are no DH frames: found by trying changes.

Each change is tried on a few configurations of the double plant; one that brings the table's last frame to the arm's is
proved exactly afterwards.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from functools import reduce

import numpy as np

from armproof.verification.algebra.quantity import Quantity
from armproof.verification.algebra.ring import Scalar
from armproof.verification.evaluation.sampled import SampledAlgebra
from armproof.verification.tables.angles import within_a_turn
from armproof.verification.tables.claim import RowVerdict
from armproof.verification.tables.frames import last_frames
from armproof.verification.tables.plant import sampled_link
from armproof.verification.tables.reading import TableReading
from armproof.verification.tables.row import ANGLES, PARAMETERS

CONFIGURATIONS = 4
NEAR = 1e-9


def single_mends(found: TableReading) -> Iterator[tuple[RowVerdict, str, Scalar]]:
    """Yield the changes of one entry (row, parameter, value) that bring the table's last frame to the arm's.

    Its origin is then that of the arm's last frame or of one beyond it, and it stands still in that frame.
    """
    if any(verdict.problems for verdict in found.verdicts):
        return
    q = np.random.default_rng(2019).uniform(-2.0, 2.0, (CONFIGURATIONS, len(found.arm.joints)))
    sampled = SampledAlgebra(found.claim.algebra, q)
    base = found.arm.frames[0]
    goals = [sampled.stacked(sampled.quantity(Quantity("pose", frame, base))) for frame in last_frames(found.arm)]
    links = [sampled.stacked(sampled_link(found, verdict.values, sampled)) for verdict in found.verdicts]
    for k, verdict in enumerate(found.verdicts):
        before, after = (reduce(np.matmul, some, np.eye(4)) for some in (links[:k], links[k + 1 :]))
        for parameter in PARAMETERS:
            for value in _changes(found, verdict, parameter):
                changed = sampled.stacked(sampled_link(found, {**verdict.values, parameter: value}, sampled))
                if any(_is_at(before @ changed @ after, goal) for goal in goals):
                    yield verdict, parameter, value


def _changes(found: TableReading, verdict: RowVerdict, parameter: str) -> Iterator[Scalar]:
    """Yield other values of an entry: its negative, 0, a length more, less or instead, a quarter turn or half a turn more."""
    ring = found.claim.algebra.ring
    printed = verdict.values[parameter]
    if parameter in ANGLES:
        own = found.claim.joint_symbol(verdict.row)
        others = [within_a_turn(printed, turns) for turns in (Fraction(1, 2), Fraction(-1, 2), Fraction(1))]
        others += [-printed, ring.zero, *([ring.symbol(own)] if own is not None and parameter == "theta" else [])]
    else:
        lengths = [found.claim.lengths.get(symbol, ring.symbol(symbol)) for symbol in found.arm.lengths]
        signed = [sign * length for length in lengths for sign in (1, -1)]
        others = [ring.zero, -printed, *signed, *(printed + length for length in signed)]
        others += [one + other for k, one in enumerate(lengths) for other in lengths[k + 1 :]]
    yield from (other for other in others if not (other - printed).is_zero())


def _is_at(product: np.ndarray, goal: np.ndarray) -> bool:
    """Whether the origins agree and the rotation between is the same at all configurations."""
    if np.abs(product[:, :3, 3] - goal[:, :3, 3]).max() > NEAR:
        return False
    turn = product[:, :3, :3].transpose(0, 2, 1) @ goal[:, :3, :3]
    return bool(np.abs(turn - turn[0]).max() < NEAR)
