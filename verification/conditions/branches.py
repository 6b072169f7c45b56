"""Solutions that hold on a branch each, and never together: θ_5 = atan2(√(1 − r²), r) beside θ_4 = atan2(…) where sin θ_5 < 0."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from armproof.verification.conditions.told_branches import ON_A_BRANCH
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.equations.outcome import Outcome
from armproof.verification.equations.second_route import TOLERANCE
from armproof.verification.findings import Finding, Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare, bare_key
from armproof.verification.naming.state import OnABranch

SECOND = "'"  # behind a joint's symbol: its second solution
AT_LINE = " at line "  # behind one: what a single display gives for it


def never_with_others(outcome: Outcome, checker: ChainChecker, line: int) -> Outcome:
    """Leave open what solves for a joint, and holds at no configuration at which the solution of another one holds that its section gives.

    A second formula for a joint is another solution, and is of the others of that: with those of its own display it holds somewhere, too.
    """
    names = checker.names
    joint = next(filter(None, (_solved_for(node, checker) for node in outcome.nodes)), None)
    if joint is None or not any(finding.kind in ON_A_BRANCH for finding in outcome.findings):
        return outcome
    before = names.state.branches
    known = before[joint] if joint in before and before[joint].section == names.state.section else None
    if (own := _where(outcome, checker, line)) is None:
        return outcome
    apart = _apart_in_display(joint, own, before)
    if known is not None:
        if joint not in names.joints:  # of a sine both signs are given
            before[joint] = replace(known, where=known.where | own.where)
        return outcome if apart is None else outcome.left_open(apart)
    for name, other in before.items():
        of_section = not name.endswith(SECOND) and AT_LINE not in name and other.section == own.section
        if of_section and own.where.isdisjoint(other.where):
            return outcome.left_open(say(Kind.RESTS_ON_DOUBT, name=name, line=other.line))
    before[joint] = own
    return outcome


def _apart_in_display(joint: str, own: OnABranch, before: dict[str, OnABranch]) -> Finding | None:
    """Return the doubt about the first formula for a joint in a display that gives another joint another solution; and note it.

    A second one there lists both solutions.
    """
    place = f"{AT_LINE}{own.line}"
    beside = {name.removesuffix(place): each for name, each in before.items() if name.endswith(place)}
    beside = {name: each for name, each in beside.items() if each.section == own.section}
    again = beside.get(joint)
    before[f"{joint}{place}"] = own if again is None else replace(own, where=own.where | again.where)
    apart = (name for name, each in beside.items() if again is None and own.where.isdisjoint(each.where))
    found = next(apart, None)
    return None if found is None else say(Kind.RESTS_ON_DOUBT, name=found, line=own.line)


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
