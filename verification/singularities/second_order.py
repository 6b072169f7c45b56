"""A family seen from the tool: the dimension of its image, and to which side the tool leaves it.

Where J loses one direction w (wᵀJ = 0), the tool moves along w to second order only: along a motion n with J n = 0,
wᵀẍ = Σ wᵀ(∂J/∂q_k) n n_k. If this form on the null motions is definite, the tool stays on one side: in this posture it cannot
cross. If it takes both signs the map is open there, and the point is inside (Agrachev and Sachkov, Control Theory from the
Geometric Viewpoint, 2004, section 20). With a single null motion the form is zero exactly where the null motion keeps to the
family, and then the image of the family has two dimensions fewer than the task.
"""

from __future__ import annotations

from operator import mul

import numpy as np

from armproof.verification.singularities.half_angles import Polynomial
from armproof.verification.singularities.linear import Rows, eliminate
from armproof.verification.singularities.points import Sampler
from armproof.verification.singularities.variety import Variety

CLEAR = 1e-6  # an eigenvalue counts as not zero above this share of the largest


def image_rows(variety: Variety, rows: Rows, sampler: Sampler) -> Rows:
    """Return J t, one row a motion t of a basis of those that keep to the family."""
    tangents = tangent_vectors(variety, sampler, len(rows[0]))
    return tuple(tuple(sum(map(mul, row, tangent), variety.half.zero) for row in rows) for tangent in tangents)


def image_dimension(variety: Variety, rows: Rows, sampler: Sampler) -> int:
    """Return the dimension of the image of a family: the rank of J on motions that keep to it."""
    moved = image_rows(variety, rows, sampler)
    return eliminate(variety, moved).rank if moved else 0


def tangent_vectors(variety: Variety, sampler: Sampler, width: int) -> tuple[tuple[Polynomial, ...], ...]:
    """Return a basis of the joint motions that keep to the family: the null vectors of the gradients of its conditions."""
    half = variety.half
    gradients: list[tuple[Polynomial, ...]] = []
    for factor in variety.conditions:
        found = sampler.derivatives(factor.polynomial)
        gradients.append(tuple(found.get(k, half.zero) for k in range(width)))
    unbound = all(entry.is_zero() for row in gradients for entry in row)
    if unbound:
        return tuple(tuple(half.one if k == j else half.zero for k in range(width)) for j in range(width))
    return eliminate(variety, tuple(gradients)).null_vectors


def jacobian_derivatives(J: np.ndarray) -> np.ndarray:
    """Return ∂J/∂q_k of geometric Jacobians, from their columns alone: (N, 6, n) → (N, 6, n, n), the last index k.

    For k ≤ j the axis k turns column j: ∂v_j = ω_k × v_j, ∂ω_j = ω_k × ω_j; for k > j the arm of column j grows: ∂v_j = ω_j × v_k.
    """
    v, w = np.moveaxis(J[:, :3], 1, 2), np.moveaxis(J[:, 3:], 1, 2)  # (N, n, 3)
    n = J.shape[2]
    earlier = np.tril(np.ones((n, n), dtype=bool))[:, :, None]  # [j, k]: k ≤ j
    turned_v = np.cross(w[:, None, :, :], v[:, :, None, :])
    grown_v = np.cross(w[:, :, None, :], v[:, None, :, :])
    turned_w = np.cross(w[:, None, :, :], w[:, :, None, :])
    dv = np.where(earlier, turned_v, grown_v)
    dw = np.where(earlier, turned_w, 0.0)
    return np.moveaxis(np.concatenate([dv, dw], axis=3), 3, 1)


def lost_and_signs(
    J: np.ndarray, rows: tuple[int, ...], columns: tuple[int, ...], rank: int
) -> tuple[np.ndarray, np.ndarray]:
    """Return the lost direction of each J and to which side of it the tool leaves.

    Args:
        J: (N, 6, n) Jacobians in one frame, at configurations that lose one direction.
        rows, columns: those of the task, from 1. rank: the rank that is left, one less than the rows.

    Returns:
        w, (N, rows) of unit length; and +1 or −1 where the form is definite, 0 where it takes both signs, NaN where it is
        not clear, (N,).
    """
    taken_rows, taken = [r - 1 for r in rows], [c - 1 for c in columns]
    left, _, right = np.linalg.svd(J[:, taken_rows][:, :, taken])
    w, motions = left[:, :, rank], right[:, rank:, :]
    second = jacobian_derivatives(J)[:, taken_rows][:, :, taken][:, :, :, taken]
    form = np.einsum("ni,nijk,naj,nbk->nab", w, second, motions, motions)
    eigenvalues = np.linalg.eigvalsh((form + form.transpose(0, 2, 1)) / 2)
    size = np.abs(second).max(axis=(1, 2, 3))
    low, high = eigenvalues[:, 0] / size, eigenvalues[:, -1] / size
    signs = np.full(len(J), np.nan)
    signs[(low < -CLEAR) & (high > CLEAR)] = 0.0
    signs[low > CLEAR] = 1.0
    signs[high < -CLEAR] = -1.0
    return w, signs
