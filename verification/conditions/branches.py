"""Solutions that hold on a branch each, and never together: θ_5 = atan2(√(1 − r²), r) beside θ_4 = atan2(…) where sin θ_5 < 0."""

from __future__ import annotations

from armproof.verification.conditions.circumstances import ON_A_BRANCH
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.equations.outcome import Outcome
from armproof.verification.equations.second_route import TOLERANCE
from armproof.verification.findings import Kind, say
from armproof.verification.latex.nodes import bare_key
from armproof.verification.naming.state import OnABranch


def never_with_others(outcome: Outcome, checker: ChainChecker, line: int) -> Outcome:
    """Leave open what solves for a joint, and holds at no configuration at which the solution of another one holds that its section gives.

    A second formula for a joint is another solution, and is of the others of that.
    """
    names = checker.names
    keys = [names.known_symbol(key) for node in outcome.nodes if (key := bare_key(node)) is not None]
    joint = next((key for key in keys if key in names.joints), None)
    if joint is None or not any(finding.kind in ON_A_BRANCH for finding in outcome.findings):
        return outcome
    before = names.state.branches
    if joint in before and before[joint].section == names.state.section:
        return outcome
    errors = checker.route.sampled_errors(outcome, branches=True)
    if errors is None:
        return outcome
    own = OnABranch(line, names.state.section, frozenset(map(int, errors.holding(TOLERANCE).nonzero()[0])))
    for name, other in before.items():
        if other.section == own.section and own.where.isdisjoint(other.where):
            return outcome.left_open(say(Kind.RESTS_ON_DOUBT, name=name, line=other.line))
    before[joint] = own
    return outcome
