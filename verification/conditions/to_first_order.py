"""What is wrong, and right to first order in its variables: cos β = 1, R_x R_y = R_y R_x of small angles."""

from __future__ import annotations

from armproof.verification.algebra.calculus import derivative, substitute, symbols_in
from armproof.verification.algebra.ring import Scalar
from armproof.verification.equations.outcome import Outcome
from armproof.verification.errors import WhereDefined
from armproof.verification.naming.names import Names
from armproof.verification.verdict import Verdict


def holds_to_first_order(outcome: Outcome, names: Names) -> bool:
    """Whether the sides of a refuted equation differ by what is of second order in all of its variables that are no lengths."""
    pair = outcome.pair
    if outcome.verdict is not Verdict.REFUTED or pair is None or pair.true.shape != pair.printed.shape:
        return False
    apart = pair.differences()
    return len(apart) == len(pair.true.cells) and all(_is_of_second_order(each, names) for each in apart)


def _is_of_second_order(difference: Scalar, names: Names) -> bool:
    lengths = {*names.lengths} if names.arm is not None else set[str]()
    variables = symbols_in([difference]) - lengths
    nought = {name: difference.ring.rational(0) for name in variables}
    slopes = (derivative(difference, difference.ring.symbol(name)) for name in sorted(variables))
    with WhereDefined():
        return all(substitute(each, nought).normal().is_zero() for each in (difference, *slopes))
    return False
