"""Distances that a document names with their sign: r = √(x² + y²) = l_2 c_2 + l_3 c_{23}."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import replace

from armproof.verification.equations.outcome import Outcome
from armproof.verification.equations.sides import Members
from armproof.verification.findings import Finding, Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare_key
from armproof.verification.naming.names import Names
from armproof.verification.verdict import Verdict


def named_with_sign(
    names: Names, members: Members, chain: n.Chain, outcomes: Iterable[Outcome], is_distance: Callable[[n.Node], bool]
) -> list[Outcome]:
    """Let a name that is both a root and a formula be the formula, which is the root where the arm reaches forwards.

    As with cos θ = √(1 − sin² θ), the sign is left to whoever solves for the joints.
    """
    outcomes = list(outcomes)
    key = next((found for each in chain.members if (found := bare_key(each)) in names.state.definitions), None)
    if key is None or all(_found(each) is None for each in outcomes):
        return outcomes
    before = names.state.definitions[key]
    formula = next((each for each in chain.members if bare_key(each) is None and not is_distance(each)), None)
    if formula is not None and before.node is not None and is_distance(before.node):
        names.state.definitions[key] = replace(before, evaluate=members.meaning(formula), node=formula)
    return [_on_a_branch(each) for each in outcomes]


def _found(outcome: Outcome) -> Finding | None:
    return next((finding for finding in outcome.findings if finding.kind is Kind.SIGNED_DISTANCE), None)


def _on_a_branch(outcome: Outcome) -> Outcome:
    found = _found(outcome)
    if found is None:
        return outcome
    said = say(Kind.ON_A_BRANCH, **found.terms)
    return replace(outcome, verdict=Verdict.CONFIRMED, findings=(said,), samples=found.terms["holding"])
