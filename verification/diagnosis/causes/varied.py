"""A quantity at other joint values and lengths than the arm's: what a slip in a variable makes of it."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache, lru_cache
from math import prod

import numpy as np

from armproof.models.arm import Arm
from armproof.models.exact.numbers import angle_value
from armproof.models.exact.polynomial import Generator, Rows, add, root_value, scale
from armproof.models.exact.trace import trace_of
from armproof.verification.algebra.quantity import Quantity
from armproof.verification.algebra.quantity_kinds import kind_of
from armproof.verification.diagnosis.causes.case import Case

Values = Mapping[str, np.ndarray]  # joint variables and lengths with other values: (N,) each


@lru_cache(maxsize=256)
def entries_of(arm: Arm, quantity: Quantity) -> Rows:
    """Return the exact entries of a quantity."""
    if quantity.kind == "jacobian":
        whole = trace_of(arm).jacobian(quantity.frame, quantity.reference, arm.frames[0])
    else:
        whole = trace_of(arm).pose(quantity.frame, quantity.reference)
    if quantity.kind == "difference":
        start = trace_of(arm).pose(quantity.start, quantity.reference)
        whole = tuple((*row[:3], add(row[3], scale(other[3], -1))) for row, other in zip(whole, start, strict=True))
    rows, columns = kind_of(quantity).block(quantity, len(arm.joints))
    return tuple(tuple(whole[r][c] for c in columns) for r in rows)


def evaluate_varied(case: Case, variations: list[Values]) -> np.ndarray:
    """Return the quantity under each of M variations: (M, N, rows, columns), all of them in one pass."""
    values = _columns(case, variations)

    @cache
    def power(item: tuple[Generator, int]) -> np.ndarray:
        return np.asarray(_generator(values, *item[0]) ** item[1])

    rows = entries_of(case.arm, case.quantity)
    result = np.empty((len(variations), len(case.q), len(rows), len(rows[0])))
    for r, row in enumerate(rows):
        for c, entry in enumerate(row):
            terms = (prod(map(power, monomial), start=float(factor)) for monomial, factor in entry.items())
            result[:, :, r, c] = sum(terms)
    return result


def _columns(case: Case, variations: list[Values]) -> dict[str, np.ndarray]:
    """Return each symbol's values: (M, N) where a variation changes it, else (1, N)."""
    count = len(case.q)
    plain = {joint.symbol: case.q[:, joint.index - 1] for joint in case.arm.joints}
    plain |= {symbol: np.full(count, value) for symbol, value in {**case.arm.lengths, **case.arm.angles}.items()}
    changed = {symbol for variation in variations for symbol in variation}
    return {
        symbol: np.array([variation.get(symbol, usual) for variation in variations])
        if symbol in changed
        else usual[None]
        for symbol, usual in plain.items()
    }


def _generator(values: Mapping[str, np.ndarray], kind: str, name: str) -> np.ndarray:
    if kind == "sqrt":
        return np.array([[root_value(name)]])
    if kind == "symbol":
        return values[name]
    angle = values[name] if name in values else np.array([[angle_value(name)]])
    return np.cos(angle) if kind == "cos" else np.sin(angle)
