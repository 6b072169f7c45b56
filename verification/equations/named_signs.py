"""Named signs, σ = ±1: what holds for one value of the sign alone chooses it, and claims nothing of the arm."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

from armproof.verification.equations.outcome import Outcome
from armproof.verification.findings import Kind, say
from armproof.verification.naming.names import Names
from armproof.verification.verdict import Verdict

Again = Callable[[], list[Outcome]]


def unless_of_a_sign(names: Names, outcomes: list[Outcome], again: Again) -> list[Outcome]:
    """Leave open what is proved as σ s_2 = s_2 is; s_2 = σ √(1 − c_2²) holds for neither value alone, but on each branch."""
    met = sorted(names.state.signs.read) if _proved(outcomes) else []
    for key in met:
        if _proved_with(names, key, 1, again) != _proved_with(names, key, -1, again):
            doubt = say(Kind.OF_A_SIGN, name=key)
            outcomes = [each.left_open(doubt) if each.verdict is Verdict.PROVED else each for each in outcomes]
    return outcomes


def _proved_with(names: Names, key: str, value: int, again: Again) -> list[int]:
    """Return which equations are proved where a sign is a number."""
    with names.state.unchanged():
        del names.state.signs.values[key]
        names.define(key, lambda algebra: algebra.rational(Fraction(value)))
        return _proved(again())


def _proved(outcomes: list[Outcome]) -> list[int]:
    return [each.equation for each in outcomes if each.verdict is Verdict.PROVED]
