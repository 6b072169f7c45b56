"""What an equation that is left open would be, where what stands beside it, or the coordinate of which it gives the rate, tells what its name is."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import pairwise

from armproof.models.arm import Arm
from armproof.verification.algebra.calculus import derivative, is_rate, substitute, symbols_in
from armproof.verification.algebra.matrix import Matrix
from armproof.verification.algebra.quantity import Quantity
from armproof.verification.algebra.ring import Scalar
from armproof.verification.equations.alignment import exactly_equal
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.equations.outcome import AsUsual, Outcome
from armproof.verification.errors import WhereDefined
from armproof.verification.latex import nodes as n
from armproof.verification.naming.shown import point_of


def as_shown_beside(outcome: Outcome, held: Iterable[str], checker: ChainChecker) -> AsUsual | None:
    """Return what a coordinate would be if its name means what it usually does, where the two others of its point are among the names that `held`.

    Along an axis that stands still its origin may be another one: what is left open differs by what moves.
    """
    usual, state = outcome.as_usual, checker.names.state
    pair = usual.outcome.pair if usual is not None else None
    if usual is None or pair is None or len(usual.meanings) != 1:
        return None
    point = point_of(next(iter(usual.meanings.values())))
    keys = {*held} & state.conventional & state.inferred.keys()
    beside = {state.inferred[key] for key in keys if point_of(state.inferred[key]) == point}
    moves = symbols_in(pair.differences()) & checker.names.joints.keys()
    return usual if point is not None and len(beside) > 1 and moves else None


def rate_as_shown(outcome: Outcome, checker: ChainChecker) -> AsUsual | None:
    """Return what the rate of a coordinate would be if its name means what it usually does: a coordinate has no other rate than its own.

    None where it may be that of another point, the part of some joints, or one by angles that are counted from the base.
    """
    usual, arm = outcome.as_usual, checker.names.arm
    pair = usual.outcome.pair if usual is not None else None
    if usual is None or pair is None or arm is None or not pair.is_scalar or len(usual.meanings) != 1:
        return None
    ((key, quantity),) = usual.meanings.items()
    names = [each for node in outcome.nodes if isinstance(each := n.bare(node), n.Name)]
    if point_of(quantity) is None or not any(each.dots == 1 and each.undotted.key == key for each in names):
        return None
    ((_, true, printed),) = pair.entries()
    rates = [{each for each in symbols_in([side]) if is_rate(each)} for side in (true, printed)]
    if rates[0] != rates[1] or any(exactly_equal(each, printed) for each in _of_others(checker, arm, quantity)):
        return None
    return None if any(exactly_equal(each, printed) for each in _by_absolute(true, arm)) else usual


def _of_others(checker: ChainChecker, arm: Arm, quantity: Quantity) -> Iterator[Scalar]:
    """Yield the rates of all coordinates of the other frames."""
    ring = checker.exact.ring
    for frame in arm.frames[1:]:
        point = checker.exact.quantity(Quantity("origin", frame, arm.frames[0]))
        for cell in point.cells if isinstance(point, Matrix) and frame != quantity.frame else ():
            rate = ring.rational(0)
            for joint in arm.joints:
                rate += derivative(cell, ring.symbol(joint.symbol)) * ring.symbol(f"dot {joint.symbol}")
            yield rate


def _by_absolute(value: Scalar, arm: Arm) -> Iterator[Scalar]:
    """Yield a rate as it is by angles that are counted from the base, of all joints that turn or from one of them on."""
    ring, turning = value.ring, [joint.symbol for joint in arm.joints if joint.kind == "revolute"]
    steps = [*pairwise(turning)]
    for start in range(len(steps)):
        relative = {
            f"{dot}{own}": ring.symbol(f"{dot}{own}") - ring.symbol(f"{dot}{before}")
            for before, own in steps[start:]
            for dot in ("", "dot ")
        }
        with WhereDefined():
            yield substitute(value, relative).normal()
