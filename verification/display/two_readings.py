"""Equations that may be read in two ways: a/2b, A = […] B = […]; and numbers in one that are to be equal."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import product

from armproof.verification.equations.outcome import Outcome, hold
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.verdict import Verdict

_KINDS: dict[str, tuple[Kind | None, Kind]] = {
    "scale": (Kind.SLASH_OVER_ALL, Kind.SLASH_OVER_NEXT),
    "bars": (None, Kind.READ_AS_SIZE),  # |J| is the determinant of most authors
    "label": (Kind.READ_AS_LABEL, Kind.READ_AS_FACTOR),
    "mixed": (Kind.READ_AS_MIXED, Kind.READ_AS_PRODUCT),  # alone: as a product it is left open
    "half": (None, Kind.READ_AS_HALF_ANGLE),
    "mixed factor": (Kind.READ_AS_MIXED, Kind.READ_AS_PRODUCT),
}
_LEFT_OPEN = ("mixed", "half")  # in their second reading
Decide = Callable[
    [n.Chain, int, int, bool], list[Outcome]
]  # a chain, the number of its first equation, its line, whether it defines


def either_reading(
    decide: Decide, chain: n.Chain, unclear: list[n.Ambiguous], equation: int, line: int, define: bool
) -> list[Outcome]:
    """Take the reading of a/2b under which the equation holds; the message names the choice.

    What is unclear in one way is read alike wherever it stands.
    """
    sorts = [*dict.fromkeys(below.sort for below in unclear)]
    choices = [dict(zip(sorts, choice, strict=True)) for choice in product((0, 1), repeat=len(sorts))]
    chains = [_as_chosen(chain, unclear, choice) for choice in choices]
    held = next((k for k, read in enumerate(chains) if _is_held(decide(read, equation, line, False))), None)
    chosen = held or 0
    outcomes = decide(chains[chosen], equation, line, define)
    if (left_open := next((each for each in _LEFT_OPEN if choices[chosen].get(each)), None)) is not None:
        text = next(below.text for below in unclear if below.sort == left_open)
        return [outcome.left_open(say(_KINDS[left_open][1], text=text)) for outcome in outcomes]
    for outcome in outcomes:
        for sort in sorts:
            below = next(each for each in unclear if each.sort == sort)
            kind = _kind(below, choices[chosen][sort])
            if kind is not None:
                outcome.also(say(Kind.SLASH_UNCLEAR if held is None else kind, text=below.text))
    return outcomes


def _as_chosen(chain: n.Chain, unclear: list[n.Ambiguous], choice: dict[str, int]) -> n.Chain:
    for below in unclear:
        chain = n.substitute(chain, below, below.readings[choice[below.sort]])  # type: ignore[assignment]
    return chain


def _is_held(outcomes: list[Outcome]) -> bool:
    return all(outcome.verdict not in (Verdict.REFUTED, Verdict.UNCHECKED) for outcome in outcomes)


def _kind(unclear: n.Ambiguous, choice: int) -> Kind | None:
    """Return what is said of a choice."""
    if unclear.sort in _KINDS:
        return _KINDS[unclear.sort][choice]
    return Kind.SLASH_OVER_ALL if isinstance(unclear.readings[choice], n.Quotient) else Kind.SLASH_OVER_NEXT


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
