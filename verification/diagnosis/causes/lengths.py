"""Slips in the lengths: swapped, forgotten, doubled, of the wrong sign, another number."""

from __future__ import annotations

from itertools import combinations

import numpy as np

from armproof.verification.diagnosis.causes.case import Case
from armproof.verification.diagnosis.causes.varied import evaluate_varied

_SMALL = 1e-9
_MOST_CHANGED = 3


def length_cause(case: Case) -> str:
    """Return in words which one length, or which two swapped ones, explain the result; else an empty text.

    Poses and Jacobians are affine in the lengths, so that obtained − true = Σ δ_k ∂true/∂a_k has its δ_k by least squares.
    """
    lengths, effects, off = _equations(case)
    single = {
        symbol: lengths[symbol] + change
        for symbol, effect in effects.items()
        if (change := _solve(effect, off)) is not None
    }
    named = {symbol: _slip(symbol, value, lengths) for symbol, value in single.items()}
    plain = [words for rank, words in sorted(named.values()) if rank == 0]
    if plain:
        return "; or ".join(plain)
    for a, b in combinations(effects, 2):
        if np.abs((lengths[b] - lengths[a]) * (effects[a] - effects[b]) - off).max() < _SMALL:
            return f"the lengths {a} and {b} are swapped"
    return "; or ".join(words for _, words in sorted(named.values()))


def lengths_cause(case: Case) -> str:
    """Return in words which several lengths explain the result together; an empty text if none do."""
    lengths, effects, off = _equations(case)
    if len(effects) < 2:
        return ""
    matrix = np.array(list(effects.values())).T
    change, *_ = np.linalg.lstsq(matrix, off, rcond=None)
    if np.abs(matrix @ change - off).max() > _SMALL:
        return ""
    values = {s: lengths[s] + float(d) for s, d in zip(effects, change, strict=True) if abs(d) > _SMALL}
    if np.allclose(sorted(values.values()), sorted(lengths[symbol] for symbol in values), atol=_SMALL, rtol=0):
        return f"the lengths {', '.join(values)} are interchanged"
    if len(values) > _MOST_CHANGED:
        return ""
    return "; ".join(_slip(symbol, value, lengths)[1] for symbol, value in values.items())


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


def _slip(symbol: str, value: float, lengths: dict[str, float]) -> tuple[int, str]:
    """Return what is wrong with a length, and how far-fetched that is."""
    true = lengths[symbol]
    if abs(value) < _SMALL:
        return 0, f"the length {symbol} is missing"
    if abs(value + true) < _SMALL:
        return 0, f"the sign of the length {symbol} is wrong"
    for other, number in lengths.items():
        if other != symbol and abs(abs(value) - number) < _SMALL:
            return 1, f"the length {'-' if value < 0 else ''}{other} stands where {symbol} belongs"
    if abs(value - 2 * true) < _SMALL:
        return 1, f"the length {symbol} is counted twice"
    return 2, f"the length {symbol} is taken as {value:.6g}, the arm's is {true:g}"
