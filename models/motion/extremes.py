"""The extremes of a piecewise polynomial: how far and how fast a joint goes between the points that it is given by."""

from __future__ import annotations

from typing import Any

import numpy as np


def extremes(trajectory: Any, order: int = 0) -> tuple[np.ndarray, np.ndarray]:
    """Return the smallest and the largest value of each row of a piecewise polynomial, or of a derivative of it.

    They are at the ends of a segment or where the derivative is zero: at the real roots of its polynomial.

    Args:
        trajectory: a pydrake PiecewisePolynomial with values of the shape (n, 1).
        order: 0 for positions, 1 for velocities, 2 for accelerations.

    Returns:
        (n,) and (n,).
    """
    polynomial = trajectory.derivative(order) if order else trajectory
    breaks = polynomial.get_segment_times()
    lower, upper = np.empty(polynomial.rows()), np.empty(polynomial.rows())
    for row in range(polynomial.rows()):
        values = [
            value
            for segment in range(polynomial.get_number_of_segments())
            for value in _candidates(
                polynomial.getPolynomial(segment, row, 0).GetCoefficients(), breaks[segment + 1] - breaks[segment]
            )
        ]
        lower[row], upper[row] = min(values), max(values)
    return lower, upper


def _candidates(coefficients: np.ndarray, duration: float) -> np.ndarray:
    """Return the values of a_0 + a_1 t + … at 0, at the duration and at the stationary points between."""
    scaled = coefficients * duration ** np.arange(len(coefficients))  # of t / duration, which keeps the roots near 1
    polynomial = np.polynomial.Polynomial(scaled)
    # The real part of a complex root does no harm: its value lies between the extremes.
    roots = np.clip(np.real(polynomial.deriv().roots()), 0.0, 1.0)
    return np.asarray(polynomial(np.concatenate([[0.0, 1.0], roots])))
