"""Equations that may be read in two ways: a/2b, A = […] B = […]; and numbers in one that are to be equal."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from armproof.verification.equations.outcome import Outcome, hold
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.verdict import Verdict

Decide = Callable[
    [n.Chain, int, int, bool], list[Outcome]
]  # a chain, the number of its first equation, its line, whether it defines


def either_reading(
    decide: Decide, chain: n.Chain, unclear: list[n.Ambiguous], equation: int, line: int, define: bool
) -> list[Outcome]:
    """Take the reading of a/2b under which the equation holds; the message names the choice."""
    chains = []
    for k in (0, 1):
        read = chain
        for below in unclear:
            read = n.substitute(read, below, below.readings[k])  # type: ignore[assignment]
        chains.append(read)
    tried = [decide(read, equation, line, False) for read in chains]
    good = [all(o.verdict not in (Verdict.REFUTED, Verdict.UNCHECKED) for o in outcomes) for outcomes in tried]
    chosen = 1 if good[1] and not good[0] else 0
    outcomes = decide(chains[chosen], equation, line, define)
    whole = isinstance(unclear[0].readings[chosen], n.Quotient)
    choice = Kind.SLASH_OVER_ALL if whole else Kind.SLASH_OVER_NEXT
    for outcome in outcomes:
        outcome.also(say(choice if any(good) else Kind.SLASH_UNCLEAR, text=unclear[0].text))
    return outcomes


def one_or_apart(
    decide: Decide, chain: n.Chain, parts: Sequence[n.Chain], equation: int, line: int, define: bool
) -> list[Outcome]:
    """A = […] B = […] is two equations, unless it holds as one: what is wrong in one reading alone is left open."""
    as_one = decide(chain, equation, line, False)
    if hold(as_one):
        return decide(chain, equation, line, define)
    apart = [o for k, part in enumerate(parts) for o in decide(part, equation + k, line, define)]
    if any(outcome.verdict is Verdict.REFUTED for outcome in as_one):
        return apart
    doubt = say(Kind.SIDE_BY_SIDE, name=parts[1].members[0].text)  # type: ignore[attr-defined]
    return [outcome.unless_refuted(doubt) for outcome in apart]
