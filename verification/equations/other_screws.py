"""Motions of other twists than a document gives: nothing tells whether the twists or what is printed of their product is wrong."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from armproof.verification.algebra.calculus import derivative, substitute, symbols_in
from armproof.verification.algebra.matrix import Matrix, inverse_pose, is_zero
from armproof.verification.equations.outcome import Outcome
from armproof.verification.evaluation.exact import ExactAlgebra
from armproof.verification.evaluation.screws import Twist, twist_in
from armproof.verification.findings import Finding, Kind, say
from armproof.verification.patterns import regex

_JOINT = regex(r"(?:theta|q|d)(?:_(\d+))?")


def of_other_screws(outcome: Outcome) -> Finding | None:
    """Say that a pose or a Jacobian is right of some twists, and of others than those that the document gives."""
    pair = outcome.pair
    if pair is None:
        return None
    printed, used = pair.printed, symbols_in([*pair.true.cells, *pair.printed.cells])
    variables = sorted(filter(_JOINT.fullmatch, used), key=_number)
    if printed.shape == (4, 4):
        is_of_some = _is_motion(printed, variables) if variables else _is_twist(printed)
    else:
        is_of_some = printed.shape[0] == 6 and _is_jacobian(printed, variables)
    return say(Kind.OTHER_SCREWS) if is_of_some else None


def _number(joint: str) -> int:
    match = _JOINT.fullmatch(joint)
    return int(match[1]) if match is not None and match[1] else 0


def _is_twist(printed: Matrix) -> bool:
    """Whether a matrix is that of a twist: skew above, zeros below."""
    return _equal(twist_in(printed).matrix(ExactAlgebra(printed.cells[0].ring, None)), printed)


def _is_motion(pose: Matrix, variables: Sequence[str]) -> bool:
    """Whether a pose is that of a chain of joints in this order, by its twists where all are zero."""
    home = _at_zero(pose, variables)
    twists = [twist_in(_at_zero(_by(pose, each), variables) @ inverse_pose(home)) for each in variables]
    chain = _product(twists, variables, pose)
    return chain is not None and _equal(chain @ home, pose)


def _is_jacobian(printed: Matrix, variables: Sequence[str]) -> bool:
    """Whether six rows are the Jacobian of a chain, in space or in the body, by their columns where all are zero."""
    home = _at_zero(printed, variables)
    count = printed.shape[1]
    numbers = {_number(each): each for each in variables}
    joints = [numbers.get(k, f"theta_{k}") for k in range(1, count + 1)]
    for direction_first in (True, False):
        columns = [tuple(row[k] for row in home.rows) for k in range(count)]
        parts = [(each[:3], each[3:]) if direction_first else (each[3:], each[:3]) for each in columns]
        chain = _product([Twist(*each) for each in parts], joints, printed)
        if chain is not None and any(_equal(each, printed) for each in _jacobians(chain, joints, direction_first)):
            return True
    return False


def _jacobians(chain: Matrix, joints: Sequence[str], direction_first: bool) -> Iterator[Matrix]:
    back = inverse_pose(chain)
    rates = [_by(chain, each) for each in joints]
    for found in ([rate @ back for rate in rates], [back @ rate for rate in rates]):
        yield Matrix(tuple(zip(*(twist_in(each).column(direction_first) for each in found), strict=True)))


def _product(twists: Sequence[Twist], joints: Sequence[str], like: Matrix) -> Matrix | None:
    """Return the product of the twists' exponentials, None where one of them is no axis."""
    ring = like.cells[0].ring
    algebra = ExactAlgebra(ring, None)
    whole: Matrix | None = None
    for twist, joint in zip(twists, joints, strict=True):
        motion = twist.motion(algebra, ring.symbol(joint))
        if motion is None:
            return None
        whole = motion if whole is None else whole @ motion
    return whole


def _by(value: Matrix, joint: str) -> Matrix:
    return value.map(lambda cell: derivative(cell, cell.ring.symbol(joint)))


def _at_zero(value: Matrix, variables: Sequence[str]) -> Matrix:
    return value.map(lambda cell: substitute(cell, dict.fromkeys(variables, cell.ring.zero)))


def _equal(one: Matrix, other: Matrix) -> bool:
    return one.shape == other.shape and is_zero(one + -other)
