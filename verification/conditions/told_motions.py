"""What holds of accelerations where the joints move evenly, or begin to move: joint accelerations, or rates, are zero there."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from armproof.verification.algebra.calculus import is_rate, substitute, symbols_in
from armproof.verification.algebra.matrix import Matrix
from armproof.verification.algebra.ring import Scalar
from armproof.verification.document.told_motions import AT_REST, EVEN, SINCE
from armproof.verification.equations.outcome import Outcome
from armproof.verification.errors import WhereDefined
from armproof.verification.findings import Kind, say
from armproof.verification.verdict import Verdict

_HIGHER = "dot dot "  # of the symbols of accelerations and jerks


def at_told_motion(outcome: Outcome, meant: Sequence[str]) -> Outcome:
    """Return what becomes of a refuted acceleration, or jerk, as the joints move by what the text says; what the section says leaves it open."""
    pair = outcome.pair
    if outcome.verdict is not Verdict.REFUTED or pair is None or pair.true.shape != pair.printed.shape:
        return outcome
    for motion in sorted((EVEN, AT_REST), key=lambda each: each not in meant):
        leads, zeros = motion in meant, _zeros(pair.true, motion)
        if not zeros or not (leads or SINCE + motion in meant):
            continue
        with WhereDefined():
            true, printed = _moved(pair.true, zeros), _moved(pair.printed, zeros)
            moved = replace(pair, true=true, printed=printed)
            wrong = [place for place, a, b in moved.entries() if not (a - b).normal().is_zero()]
            if wrong and leads:
                return replace(outcome, pair=replace(pair, true=true), wrong=wrong)
            if wrong:
                continue
            if not leads:
                return outcome.left_open(say(Kind.HOLDS_AS_TOLD))
            return replace(outcome, verdict=Verdict.PROVED, findings=(say(Kind.UNDER_RATES),), wrong=[])
    return outcome


def _moved(side: Matrix, zeros: Mapping[str, Scalar]) -> Matrix:
    return side.map(lambda cell: substitute(cell, zeros))


def _zeros(value: Matrix, motion: str) -> Mapping[str, Scalar]:
    """Return the symbols of a value with accelerations that are zero in a motion; none of one without accelerations."""
    cells = [cell for cell in value.cells if isinstance(cell, Scalar)]
    rates = [each for each in symbols_in(cells) if is_rate(each)]
    if not any(each.startswith(_HIGHER) for each in rates):
        return {}
    zero = cells[0].ring.rational(0)
    return {each: zero for each in rates if each.startswith(_HIGHER) is (motion == EVEN)}
