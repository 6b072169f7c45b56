"""Slips in the lengths: swapped, forgotten, doubled, of the wrong sign, another number."""

from __future__ import annotations

from functools import reduce
from itertools import combinations

import numpy as np

from armproof.verification.diagnosis.causes.case import Case
from armproof.verification.diagnosis.causes.varied import evaluate_varied
from armproof.verification.findings import Finding, Kind, say

_SMALL = 1e-9
_MOST_CHANGED = 3


def length_cause(case: Case) -> Finding | None:
    """Return which one length, or which two swapped ones, explain the result; None where none does.

    Poses and Jacobians are affine in the lengths, so that obtained − true = Σ δ_k ∂true/∂a_k has its δ_k by least squares.
    """
    lengths, effects, off = _equations(case)
    single = {
        symbol: lengths[symbol] + change
        for symbol, effect in effects.items()
        if (change := _solve(effect, off)) is not None
    }
    named = sorted((_slip(symbol, value, lengths) for symbol, value in single.items()), key=lambda slip: slip[0])
    if plain := [finding for rank, finding in named if rank == 0]:
        return _joined(Kind.EITHER_LENGTH, plain)
    for a, b in combinations(effects, 2):
        if np.abs((lengths[b] - lengths[a]) * (effects[a] - effects[b]) - off).max() < _SMALL:
            return say(Kind.LENGTHS_SWAPPED, one=a, other=b)
    return _joined(Kind.EITHER_LENGTH, [finding for _, finding in named])


def lengths_cause(case: Case) -> Finding | None:
    """Return which several lengths explain the result together; None if none do."""
    lengths, effects, off = _equations(case)
    if len(effects) < 2:
        return None
    matrix = np.array(list(effects.values())).T
    change, *_ = np.linalg.lstsq(matrix, off, rcond=None)
    if np.abs(matrix @ change - off).max() > _SMALL:
        return None
    values = {s: lengths[s] + float(d) for s, d in zip(effects, change, strict=True) if abs(d) > _SMALL}
    if np.allclose(sorted(values.values()), sorted(lengths[symbol] for symbol in values), atol=_SMALL, rtol=0):
        return say(Kind.LENGTHS_INTERCHANGED, lengths=list(values))
    if len(values) > _MOST_CHANGED:
        return None
    return _joined(Kind.SEVERAL_LENGTHS, [_slip(symbol, value, lengths)[1] for symbol, value in values.items()])


def _joined(kind: Kind, findings: list[Finding]) -> Finding | None:
    """Return several slips as one finding, or None where there is none."""
    return reduce(lambda one, other: say(kind, one=one, other=other), findings) if findings else None


def _equations(case: Case) -> tuple[dict[str, float], dict[str, np.ndarray], np.ndarray]:
    """Return the lengths, the effect of one metre more of each that has any, and obtained − true."""
    lengths = dict(case.arm.lengths)
    if not case.fits or not lengths or case.quantity.kind in ("joint", "vector", "axis", "rotation"):
        return lengths, {}, np.zeros(0)
    count = len(case.q)
    varied = evaluate_varied(case, [{symbol: np.full(count, value + 1)} for symbol, value in lengths.items()])
    effects = {s: (values - case.true).ravel() for s, values in zip(lengths, varied, strict=True)}
    off = (case.obtained - case.true).ravel()
    return lengths, {s: effect for s, effect in effects.items() if np.abs(effect).max() > _SMALL}, off


def _solve(effect: np.ndarray, off: np.ndarray) -> float | None:
    change = float(effect @ off / (effect @ effect))
    return change if np.abs(effect * change - off).max() < _SMALL else None


def _slip(symbol: str, value: float, lengths: dict[str, float]) -> tuple[int, Finding]:
    """Return what is wrong with a length, and how far-fetched that is."""
    true = lengths[symbol]
    if abs(value) < _SMALL:
        return 0, say(Kind.LENGTH_MISSING, length=symbol)
    if abs(value + true) < _SMALL:
        return 0, say(Kind.SIGN_OF_LENGTH, length=symbol)
    for other, number in lengths.items():
        if other != symbol and abs(abs(value) - number) < _SMALL:
            printed = f"{'-' if value < 0 else ''}{other}"
            return 1, say(Kind.LENGTH_FOR_LENGTH, printed=printed, correct=symbol)
    if abs(value - 2 * true) < _SMALL:
        return 1, say(Kind.LENGTH_TWICE, length=symbol)
    return 2, say(Kind.OTHER_NUMBER, length=symbol, printed=value, correct=true)
