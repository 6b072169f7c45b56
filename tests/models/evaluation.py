"""The numbers that exact entries have at configurations of an arm."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cache
from math import prod
from typing import Any

import numpy as np

from armproof.models.arm import Arm
from armproof.models.exact.numbers import constant_value
from armproof.models.exact.polynomial import Entry, Generator
from armproof.models.numeric.joint_values import read_joint_values


def evaluate(entry: Entry, value: Callable[[Generator], Any]) -> Any:
    """Return the number an entry has when `value` gives that of each generator (a float, or an array of samples)."""
    return sum(float(c) * prod(value(gen) ** power for gen, power in m) for m, c in entry.items())


def evaluate_entries(arm: Arm, entries: Sequence[Sequence[Entry]], q: Any) -> np.ndarray:
    """Evaluate a matrix of entries at N configurations, with the lengths and angles that the arm has.

    Args:
        entries: rows of entries, as `pose` and `jacobian` of a trace return them.
        q: (N, n) array of joint variables, base to tool.

    Returns:
        (N, rows, columns) array.

    Raises:
        ModelError: q cannot be read (see `read_joint_values`).
    """
    q = read_joint_values(arm, q)
    column = {joint.symbol: q[:, joint.index - 1] for joint in arm.joints}
    constants = {**arm.lengths, **arm.angles}

    @cache
    def value(generator: Generator) -> Any:
        kind, name = generator
        if name not in column:
            return constant_value(generator, constants)
        if kind == "symbol":
            return column[name]
        return np.cos(column[name]) if kind == "cos" else np.sin(column[name])

    values = np.empty((len(q), len(entries), len(entries[0])))
    for i, row in enumerate(entries):
        for j, entry in enumerate(row):
            values[:, i, j] = evaluate(entry, value)
    return values
