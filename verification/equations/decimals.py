"""Equations between printed decimals: true to the digits shown, or at the configuration that a display gave."""

from __future__ import annotations

from armproof.verification.algebra.calculus import leaves_open
from armproof.verification.algebra.matrix import Matrix
from armproof.verification.equations.alignment import Pair
from armproof.verification.equations.numeric_matrices import (
    FEW,
    coarsest_decimals,
    depends_on,
    finest_decimals,
    is_numeric,
)
from armproof.verification.equations.outcome import Outcome
from armproof.verification.equations.second_route import FEWEST, SecondRoute
from armproof.verification.equations.sides import Member, Members
from armproof.verification.findings import Kind, say
from armproof.verification.verdict import Verdict


def holds_to_its_decimals(route: SecondRoute, outcome: Outcome, branches: bool) -> bool:
    """Confirm an equation whose numbers are rounded (1.501 for √(1.5² + 0.054²)) to the decimals they are printed with."""
    assert outcome.true is not None and outcome.printed is not None
    decimals = coarsest_decimals((outcome.true.node, outcome.printed.node), route.names.state.rounded)
    if decimals is None or not _leaves_rounding(outcome, decimals):
        return False
    errors = route.sampled_errors(outcome, branches)
    if errors is None:
        return False
    tolerance = 0.45 * 10.0**-decimals  # of errors scaled by 1 + size: less than one unit of the last
    holding = errors.where_equal(tolerance)
    left, right = sorted((outcome.true.node, outcome.printed.node), key=lambda node: node.span)
    counts = errors.on_a_branch(tolerance)
    everywhere = holding.samples == errors.samples >= FEWEST
    if not everywhere and not (route.is_solved_for(left, right) and counts):
        return False
    outcome.verdict, outcome.wrong = Verdict.CONFIRMED, []
    outcome.samples, outcome.max_error = holding.samples, holding.largest
    said = say(Kind.TO_DECIMALS, decimals=decimals)
    if not everywhere and counts is not None:
        of = {"holding": counts[0], "configurations": counts[1]}
        said = say(Kind.TO_DECIMALS_ON_A_BRANCH, decimals=decimals, **of)
    outcome.findings = (said,)
    return True


def _leaves_rounding(outcome: Outcome, decimals: int) -> bool:
    """Whether a wrong entry may be wrong by rounding: 0.334 for 0.333 is not, the decimals printed hold 0.333 exactly."""
    assert outcome.true is not None and outcome.printed is not None
    if outcome.pair is None:
        return True
    decimals = max(decimals, finest_decimals((outcome.true.node, outcome.printed.node)))
    true, printed = outcome.pair.true.rows, outcome.pair.printed.rows
    for difference in (true[r][c] - printed[r][c] for r, c in outcome.wrong):
        roots = any(kind == "sqrt" for powers, _ in difference.ring.terms(difference.numerator) for kind, _ in powers)
        if roots or not difference.denominator.is_one() or leaves_open(difference):
            continue
        if all((k * 10**decimals).denominator == 1 for _, k in difference.ring.terms(difference.numerator)):
            return False
    return True


def at_a_configuration(members: Members, true: Member, printed: Member, outcome: Outcome) -> Outcome | None:
    """A numeric matrix equated to a pose that moves is that pose at the configuration the document gave last."""
    arm = members.names.arm
    if arm is None or true.rank != 4 or not is_numeric(printed.node) or not isinstance(true.value, Matrix):
        return None
    if not isinstance(printed.value, Matrix) or true.value.shape != printed.value.shape:
        return None
    if not depends_on(true.value, {joint.symbol for joint in arm.joints}):
        return None
    sampled = members.sampled()
    with members.exact.budget.paused():
        from armproof.verification.equations.sampled_errors import compare_numbers

    found = compare_numbers(true.value, printed.value, printed.node, sampled, members.names.state.configuration)
    outcome.pair = Pair(true.value, printed.value)
    if found.wrong and len(found.wrong) <= FEW:
        outcome.wrong, outcome.findings, outcome.sampled_only = found.wrong, (say(Kind.WRONG_THERE),), True
    elif found.wrong or found.open:
        outcome.verdict = Verdict.UNCHECKED
        outcome.findings = (say(Kind.NUMBERS_OF_NOWHERE),)
    else:
        outcome.verdict, outcome.samples, outcome.max_error = Verdict.CONFIRMED, 1, found.largest
        outcome.findings = (say(Kind.TO_DECIMALS_THERE),)
    return outcome
