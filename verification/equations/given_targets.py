"""Where the tool is to be, x = 0.6 and y = 0.2, and formulas that hold of it at every configuration."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from armproof.verification.algebra.calculus import symbols_in
from armproof.verification.equations.outcome import Outcome
from armproof.verification.findings import Kind, say
from armproof.verification.naming.names import Names
from armproof.verification.verdict import HOLDS, Verdict


def asked_of_the_tool(names: Names, outcomes: list[Outcome], again: Callable[[], list[Outcome]]) -> list[Outcome]:
    """Return the outcomes; what moves with the joints and is refuted by the numbers of a target may hold of the tool itself.

    cos θ_2 = (x² + y² − l_1² − l_2²) / (2 l_1 l_2) behind x = 0.6 is to be solved, or says so of any target.
    """
    given = names.state.given()
    if not given or not any(_moves(names, outcome) for outcome in outcomes):
        return outcomes
    with names.state.unchanged():
        names.forget(key for key, _ in given)
        tried = again()
    of_both = zip(outcomes, tried, strict=True) if len(tried) == len(outcomes) else ((each, each) for each in outcomes)
    judged = [_judged(each, other, given[0]) if _moves(names, each) else each for each, other in of_both]
    if all(outcome.verdict in HOLDS for outcome in judged):
        names.state.consulted -= {*given}  # nothing rests on them
    return judged


def _moves(names: Names, outcome: Outcome) -> bool:
    """Whether an equation is refuted, one side of which moves with the joints."""
    cells = (*outcome.pair.true.cells, *outcome.pair.printed.cells) if outcome.pair is not None else ()
    return outcome.verdict is Verdict.REFUTED and (
        outcome.pair is None or bool(names.joints.keys() & symbols_in(cells))
    )


def _judged(outcome: Outcome, of_tool: Outcome, given: tuple[str, int]) -> Outcome:
    if of_tool.verdict in HOLDS:
        return replace(of_tool, read_as=of_tool.read_as or outcome.read_as)
    name, line = given
    return (
        outcome
        if of_tool.verdict is Verdict.REFUTED
        else outcome.left_open(say(Kind.RESTS_ON_DOUBT, name=name, line=line))
    )
