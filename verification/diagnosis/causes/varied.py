"""A quantity at other joint values and lengths than the arm's: what a slip in a variable makes of it."""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache
from typing import Any

import numpy as np

from armproof.models.arm import Arm
from armproof.models.exact.numbers import angle_value
from armproof.models.exact.polynomial import Entry, Rows, add, root_value, scale
from armproof.models.exact.trace import trace_of
from armproof.verification.algebra.quantity import COMPONENTS, Quantity
from armproof.verification.diagnosis.causes.case import Case

Values = Mapping[str, np.ndarray]  # joint variables and lengths with other values: (N,) each


@lru_cache(maxsize=256)
def entries_of(arm: Arm, quantity: Quantity) -> Rows:
    """Return the exact entries of a quantity."""
    if quantity.kind == "jacobian":
        rows = trace_of(arm).jacobian(quantity.frame, quantity.reference, arm.frames[0])
    else:
        rows = trace_of(arm).pose(quantity.frame, quantity.reference)
        height = 4 if quantity.homogeneous else 3
        if quantity.kind == "rotation":
            rows = tuple(row[:3] for row in rows[:3])
        elif quantity.kind == "origin":
            rows = tuple(row[3:] for row in rows[:height])
        elif quantity.kind == "axis":
            column = COMPONENTS[quantity.along]
            rows = tuple(row[column : column + 1] for row in rows[:height])
        elif quantity.kind == "difference":
            start = trace_of(arm).pose(quantity.start, quantity.reference)
            rows = tuple((add(row[3], scale(other[3], -1)),) for row, other in zip(rows[:3], start[:3], strict=True))
    chosen = [rows[r - 1] for r in quantity.rows] if quantity.rows else rows
    columns = quantity.columns or range(1, len(rows[0]) + 1)
    return tuple(tuple(row[c - 1] for c in columns) for row in chosen)


def evaluate_varied(case: Case, variations: list[Values]) -> np.ndarray:
    """Return the quantity under each of M variations: (M, N, rows, columns), all of them in one pass."""
    arm, count = case.arm, len(case.q)
    values = _columns(case, variations)
    powers: dict[Any, np.ndarray] = {}

    def power(item: tuple[tuple[str, str], int]) -> np.ndarray:
        if item not in powers:
            (kind, name), exponent = item
            powers[item] = _generator(arm, values, kind, name) ** exponent
        return powers[item]

    rows = entries_of(arm, case.quantity)
    result = np.empty((len(variations), count, len(rows), len(rows[0])))
    for r, row in enumerate(rows):
        for c, entry in enumerate(row):
            result[:, :, r, c] = _sum(entry, power)
    return result


def _sum(entry: Entry, power: Any) -> Any:
    total: Any = 0.0
    for monomial, coefficient in entry.items():
        term: Any = float(coefficient)
        for item in monomial:
            term = term * power(item)
        total = total + term
    return total


def _columns(case: Case, variations: list[Values]) -> dict[str, np.ndarray]:
    """Return each symbol's values: (M, N) where a variation changes it, else (1, N)."""
    count = len(case.q)
    plain = {joint.symbol: case.q[:, joint.index - 1] for joint in case.arm.joints}
    plain |= {symbol: np.full(count, value) for symbol, value in case.arm.lengths.items()}
    plain |= {symbol: np.full(count, value) for symbol, value in case.arm.angles.items()}
    changed = {symbol for variation in variations for symbol in variation}
    return {
        symbol: np.array([variation.get(symbol, usual) for variation in variations])
        if symbol in changed
        else usual[None]
        for symbol, usual in plain.items()
    }


def _generator(arm: Arm, values: Mapping[str, np.ndarray], kind: str, name: str) -> np.ndarray:
    if kind == "sqrt":
        return np.array([[root_value(name)]])
    if kind == "symbol":
        return values[name]
    angle = values[name] if name in values else np.array([[angle_value(name)]])
    return np.cos(angle) if kind == "cos" else np.sin(angle)
