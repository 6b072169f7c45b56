"""Square roots and arc functions have branches: an equation printed with one of them holds on that branch only."""

from __future__ import annotations

import numpy as np

LEAST_SHARE = 0.05  # of the configurations drawn at random
LEAST = 8


def holds_on(scaled: np.ndarray, usable: np.ndarray, tolerance: float) -> tuple[int, int] | None:
    """Return at how many of how many configurations every entry agrees, or None where it is no branch.

    θ = arctan(y/x), θ = arccos D and sin θ = √(1 − D²) leave half a turn or a sign open that the configuration decides:
    each agrees with the arm in an open set of configurations. A wrong formula, being piecewise analytic, agrees nowhere
    but by chance, so that `usable` must leave out the families that are not drawn at random (zero, quarter turns).

    Args:
        scaled: errors, (rows, columns, samples).
        usable: the configurations to count, (samples,).
    """
    holding = (scaled <= tolerance).all(axis=(0, 1)) & usable
    count, total = int(holding.sum()), int(usable.sum())
    return (count, total) if count >= max(LEAST, LEAST_SHARE * total) else None
