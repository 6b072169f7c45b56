"""Numbers in a chain that are to be equal, whatever they are of."""

from __future__ import annotations

from dataclasses import replace
from itertools import takewhile

from armproof.verification.display.two_readings import Decide
from armproof.verification.equations.outcome import Outcome
from armproof.verification.equations.worked_numbers import tells_values
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import is_number
from armproof.verification.verdict import Verdict


def unequal_numbers(decide: Decide, chain: n.Chain, first: int, equation: int, line: int) -> list[Outcome]:
    """Return what is refuted among the numbers from a member on."""
    rest = replace(chain, members=chain.members[first:], relations=chain.relations[first:])
    found = decide(rest, equation + first, line, False)
    return [each for each in found if each.verdict is Verdict.REFUTED]


def with_wrong_numbers(
    decide: Decide, chain: n.Chain, outcomes: list[Outcome], equation: int, line: int
) -> list[Outcome]:
    """φ = θ_1 + θ_2 = 30° + 45° = 85°: numbers at the end of a chain are to be equal, of whatever values they are."""
    is_open = {each.equation for each in outcomes if each.verdict is Verdict.UNCHECKED}
    if not is_open or set(chain.relations) != {"="}:
        return outcomes
    first = len(chain.members) - len(list(takewhile(is_number, reversed(chain.members))))
    if first < 1 or len(chain.members) - first < 2:
        return outcomes
    if not any(map(tells_values, chain.members[first:])):
        return outcomes
    wrong = {each.equation: each for each in unequal_numbers(decide, chain, first, equation, line)}
    return [wrong.get(each.equation, each) if each.equation in is_open else each for each in outcomes]
