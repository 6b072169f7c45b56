"""Solutions that hold on a branch each, and never together: θ_5 = atan2(√(1 − r²), r) beside θ_4 = atan2(…) where sin θ_5 < 0."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from armproof.verification.conditions.circumstances import ON_A_BRANCH
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.equations.outcome import Outcome
from armproof.verification.equations.second_route import TOLERANCE
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare, bare_key
from armproof.verification.naming.state import OnABranch

SECOND = "'"  # behind a joint's symbol: its second solution


def never_with_others(outcome: Outcome, checker: ChainChecker, line: int) -> Outcome:
    """Leave open what solves for a joint, and holds at no configuration at which the solution of another one holds that its section gives.

    A second formula for a joint is another solution, and is of the others of that.
    """
    names = checker.names
    joint = next(filter(None, (_solved_for(node, checker) for node in outcome.nodes)), None)
    if joint is None or not any(finding.kind in ON_A_BRANCH for finding in outcome.findings):
        return outcome
    before = names.state.branches
    known = before[joint] if joint in before and before[joint].section == names.state.section else None
    if known is not None and joint in names.joints:
        return outcome
    if (own := _where(outcome, checker, line)) is None:
        return outcome
    if known is not None:  # of a sine both signs are given
        before[joint] = replace(known, where=known.where | own.where)
        return outcome
    for name, other in before.items():
        if not name.endswith(SECOND) and other.section == own.section and own.where.isdisjoint(other.where):
            return outcome.left_open(say(Kind.RESTS_ON_DOUBT, name=name, line=other.line))
    before[joint] = own
    return outcome


def _solved_for(node: n.Node, checker: ChainChecker) -> str | None:
    """Return what a side is, a joint or its sine, which has a sign as well; None of another."""
    node, names = bare(node), checker.names
    of_sine = bare(node.arguments[0]) if isinstance(node, n.Call) and node.function == "sin" else None
    if isinstance(of_sine, n.JointAngles) and [sign for sign, _ in of_sine.terms] == [1]:  # s_2
        symbols = dict(enumerate(names.joints, start=1))
        return f"sin {symbols[of_sine.terms[0][1]]}" if of_sine.terms[0][1] in symbols else None
    key = bare_key(of_sine or node)
    symbol = names.known_symbol(key) if key is not None else None
    return (f"sin {symbol}" if of_sine is not None else symbol) if symbol in names.joints else None


def is_of_second(joints: Sequence[str], outcomes: Sequence[Outcome], checker: ChainChecker, line: int) -> bool:
    """Whether what holds of joints holds of their second solutions θ_2', which it then gives, and not of the first ones.

    The formula for one holds where that of the first, in the same section, does not; what has such a one in it is of the same
    solution, whatever else it solves for.
    """
    names = checker.names
    before = names.state.branches
    known = [before[f"{joint}{SECOND}"] for joint in joints if f"{joint}{SECOND}" in before]
    if known and len(outcomes) == 1:
        before.update({f"{joint}{SECOND}": known[0] for joint in joints})
        return True
    first = before.get(joints[0]) if len(joints) == 1 == len(outcomes) else None
    is_on_branch = any(finding.kind in ON_A_BRANCH for finding in outcomes[0].findings)
    own = _where(outcomes[0], checker, line) if first is not None and is_on_branch else None
    if (
        own is None
        or first is None
        or first.section != own.section
        or not own.where
        or not own.where.isdisjoint(first.where)
    ):
        return False
    before[f"{joints[0]}{SECOND}"] = own
    return True


def _where(outcome: Outcome, checker: ChainChecker, line: int) -> OnABranch | None:
    """Return at which samples a formula holds, None where it has no value."""
    errors = checker.route.sampled_errors(outcome, branches=True)
    if errors is None:
        return None
    where = frozenset(map(int, errors.holding(TOLERANCE).nonzero()[0]))
    return OnABranch(line, checker.names.state.section, where)
