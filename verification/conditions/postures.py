"""Postures of quarter turns: the configurations at which what holds at one alone is sought first."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import product
from math import pi

from armproof.models.arm import Joint
from armproof.verification.algebra.calculus import substitute, symbols_in
from armproof.verification.algebra.ring import Scalar
from armproof.verification.errors import WhereDefined
from armproof.verification.evaluation.exact import ExactAlgebra

MOST_JOINTS = 4  # of which quarter turns are tried
_QUARTERS = [Fraction(k, 2) for k in (0, 2, 1, -1)]


def quarter_turns(exact: ExactAlgebra, joints: Sequence[Joint]) -> Iterator[tuple[dict[str, Scalar], dict[str, float]]]:
    """Yield values of joints, exactly and as numbers: angles of quarter turns, slides of as many halves; none of many joints."""
    units = [(exact.pi(), pi) if joint.kind == "revolute" else (exact.ring.one, 1.0) for joint in joints]
    symbols = [joint.symbol for joint in joints]
    for choice in product(_QUARTERS, repeat=len(joints)) if len(joints) <= MOST_JOINTS else ():
        values = [exact.ring.rational(turn) * unit for turn, (unit, _) in zip(choice, units, strict=True)]
        numbers = [float(turn) * unit for turn, (_, unit) in zip(choice, units, strict=True)]
        yield dict(zip(symbols, values, strict=True)), dict(zip(symbols, numbers, strict=True))


def vanish_at_quarter_turns(exact: ExactAlgebra, joints: Sequence[Joint], differences: Sequence[Scalar]) -> bool:
    """Whether scalars vanish together in one of these postures of the joints that they hold."""
    moving = [joint for joint in joints if joint.symbol in symbols_in(differences)]
    for values, _ in quarter_turns(exact, moving):
        with WhereDefined():
            if all(substitute(each, values).is_zero() for each in differences):
                return True
    return False
