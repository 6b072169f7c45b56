"""Ranks under stated values: away from them, the rank of a matrix is that of a generic configuration, and theirs is another."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction

from armproof.verification.conditions.implication import Implication, is_rank_condition
from armproof.verification.conditions.judgement import check_implication
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.equations.outcome import Outcome
from armproof.verification.findings import Finding, Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.verdict import DECIDED, Verdict

LARGEST = 6  # rank of a Jacobian


def rank_there(checker: ChainChecker, chain: n.Chain, outcome: Outcome, given: Sequence[n.Chain]) -> Outcome:
    """Return what becomes of rank A = k where values are given: proved there, refuted where another rank is, else open."""
    as_told = outcome.tells(Kind.HOLDS_AS_TOLD)
    if outcome.verdict not in DECIDED and not as_told:
        return outcome
    if _follows(checker, given, chain):
        return replace(outcome, verdict=Verdict.PROVED, findings=(), pair=None, wrong=[])
    if any(_follows(checker, given, other) for other in _other_ranks(chain)):
        at_values = say(Kind.DOES_NOT_FOLLOW, holds="left", fails="right")
        return replace(outcome, verdict=Verdict.REFUTED, findings=(at_values,), pair=None, wrong=[])
    return outcome.left_open(say(Kind.OTHER_AS_TOLD))


def rank_everywhere(checker: ChainChecker, chain: n.Chain, outcome: Outcome, doubt: Finding) -> Outcome:
    """Leave open a rank in a posture that is not told in numbers, unless it is the same at every configuration."""
    if outcome.verdict not in DECIDED or (outcome.verdict is Verdict.PROVED and _follows(checker, (), chain)):
        return outcome
    return outcome.left_open(doubt)


def _other_ranks(chain: n.Chain) -> list[n.Chain]:
    """Return the same equation with each other number, or nothing where it is no rank A = k."""
    last = chain.members[-1]
    if not is_rank_condition(chain) or len(chain.members) != 2 or not isinstance(last, n.Number):
        return []
    others = [Fraction(k) for k in range(LARGEST + 1) if k != last.value]
    return [replace(chain, members=(chain.members[0], replace(last, value=k, text=str(k)))) for k in others]


def _follows(checker: ChainChecker, given: Sequence[n.Chain], chain: n.Chain) -> bool:
    implication = Implication("⇒", [[*given]], [[chain]])
    return check_implication(checker, implication, 1)[0].verdict is Verdict.PROVED
