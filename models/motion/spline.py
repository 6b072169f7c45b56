"""The cubic spline through points, by Drake: continuous in value, velocity and acceleration."""

from __future__ import annotations

from typing import Any

import numpy as np


def cubic_spline(breaks: np.ndarray, points: np.ndarray, *, at_rest: bool) -> Any:
    """Return the cubic spline through points at increasing breaks.

    Args:
        breaks: (K,), of time or of the parameter of a path.
        points: (K, n), K of at least 2 at rest, otherwise of at least 3.
        at_rest: with derivatives of 0 at both ends; otherwise the third derivative is continuous at the second break
            and the last but one.

    Returns:
        A pydrake PiecewisePolynomial with values of the shape (n, 1).
    """
    from pydrake.trajectories import PiecewisePolynomial

    make: Any = PiecewisePolynomial.CubicWithContinuousSecondDerivatives
    rest = np.zeros((points.shape[1], 1))
    return make(breaks, points.T, rest, rest) if at_rest else make(breaks, points.T, False)
