"""Inverse velocity kinematics: joint rates for a twist, by the pseudo-inverse of a Jacobian or by damped least squares."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from armproof.models.errors import Fault, ModelError, Sentence
from armproof.models.language import noted

Form = Literal["inverse", "right inverse", "left inverse", "damped"]


@dataclass(frozen=True)
class JointRates:
    """Joint rates for a twist.

    Attributes:
        rates: q̇, (n,) or (N, n), rad/s and m/s.
        residual: v − J q̇, what the rates miss of the twist, (m,) or (N, m).
        form: which inverse gave the rates.
    """

    rates: np.ndarray
    residual: np.ndarray
    form: Form


def applicable_form(J: np.ndarray) -> Literal["inverse", "right inverse", "left inverse"]:
    """Return which form of the pseudo-inverse a Jacobian of full rank has: right if m < n, left if m > n, both if m = n."""
    rows, columns = np.shape(J)[-2:]
    if rows == columns:
        return "inverse"
    return "right inverse" if rows < columns else "left inverse"


def pseudo_inverse(J: np.ndarray) -> np.ndarray:
    """Return the pseudo-inverse of Jacobians of full rank, in the form that applies; see applicable_form.

    With at least as many joints as rows of the task it is the right inverse J⁺ = Jᵀ (J Jᵀ)⁻¹: J J⁺ = I, and ‖J⁺ v‖ is least;
    with at most as many the left inverse J⁺ = (Jᵀ J)⁻¹ Jᵀ: J⁺ J = I, and ‖v − J J⁺ v‖ is least. All inverses of this module
    are computed from the singular values of J, because J Jᵀ has the square of its condition number.

    Args:
        J: (m, n) or (N, m, n).

    Returns:
        (n, m) or (N, n, m), read-only.

    Raises:
        ModelError: J is no matrix of finite numbers, or its rank is below both m and n: the arm is singular.
    """
    U, singular_values, Vt = _decompose(J)
    form = (
        (noted("left inverse"), noted("column"))
        if U.shape[-2] > Vt.shape[-1]
        else (noted("right inverse"), noted("row"))
    )
    _require_full_rank(singular_values, *form)
    return _compose(U, 1 / singular_values, Vt)


def damped_inverse(J: np.ndarray, damping: float | np.ndarray) -> np.ndarray:
    """Return the damped least squares inverse Jᵀ (J Jᵀ + λ² I)⁻¹ of Jacobians of any rank.

    q̇ = Jᵀ (J Jᵀ + λ² I)⁻¹ v minimises ‖v − J q̇‖² + λ² ‖q̇‖². Its rates are bounded, ‖q̇‖ ≤ ‖v‖ / (2λ), at every
    configuration, singular or not, and tend to those of the pseudo-inverse with λ.

    Source: Y. Nakamura and H. Hanafusa, 1986; C. W. Wampler, 1986.

    Args:
        J: (m, n) or (N, m, n).
        damping: λ > 0, in the unit of J; one number, or one for each of the N.

    Returns:
        (n, m) or (N, n, m), read-only.

    Raises:
        ModelError: J is no matrix of finite numbers, or a λ is not positive and finite.
    """
    U, singular_values, Vt = _decompose(J)
    factors = np.asarray(damping, dtype=float)
    if factors.shape not in ((), U.shape[:-2]):
        raise ModelError(Fault.DAMPING_SHAPE, shape=str(factors.shape))
    if not (np.isfinite(factors) & (factors > 0)).all():
        raise ModelError(Fault.DAMPING, damping=str(damping))
    return _compose(U, singular_values / (singular_values**2 + factors[..., np.newaxis] ** 2), Vt)


def joint_rates(J: np.ndarray, twist: np.ndarray, *, damping: float | None = None) -> JointRates:
    """Return the joint rates q̇ = J⁺ v for a twist, or with damping q̇ = Jᵀ (J Jᵀ + λ² I)⁻¹ v.

    Args:
        J: (m, n) or (N, m, n), rows [v; ω] or some of them.
        twist: (m,) or (N, m), in the order of the rows of J (m/s, rad/s).
        damping: λ > 0; without it, the pseudo-inverse of a Jacobian of full rank.

    Raises:
        ModelError: shapes that do not fit, numbers that are not finite, λ ≤ 0, or J singular and no damping given.
    """
    J = _matrices(J)
    v = np.asarray(twist, dtype=float)
    if v.shape != J.shape[:-1]:
        raise ModelError(Fault.TWIST_SHAPE, jacobians=str(J.shape), expected=str(J.shape[:-1]), shape=str(v.shape))
    if not np.isfinite(v).all():
        raise ModelError(Fault.TWIST_NOT_FINITE)
    form: Form = applicable_form(J) if damping is None else "damped"
    inverse = pseudo_inverse(J) if damping is None else damped_inverse(J, damping)
    rates = np.asarray((inverse @ v[..., np.newaxis])[..., 0])
    residual = np.asarray(v - (J @ rates[..., np.newaxis])[..., 0])
    rates.flags.writeable = residual.flags.writeable = False
    return JointRates(rates, residual, form)


def _matrices(J: np.ndarray) -> np.ndarray:
    try:
        matrices = np.asarray(J, dtype=float)
    except (TypeError, ValueError) as error:
        raise ModelError(Fault.JACOBIAN_NO_NUMBERS, reason=str(error)) from None
    if matrices.ndim not in (2, 3) or 0 in matrices.shape[-2:]:
        raise ModelError(Fault.JACOBIAN_SHAPE, shape=str(matrices.shape))
    if not np.isfinite(matrices).all():
        raise ModelError(Fault.JACOBIAN_NOT_FINITE)
    return matrices


def _decompose(J: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return the thin singular value decomposition J = U Σ Vᵀ, of each of a batch."""
    U, singular_values, Vt = np.linalg.svd(_matrices(J), full_matrices=False)
    return U, singular_values, Vt


def _compose(U: np.ndarray, inverted: np.ndarray, Vt: np.ndarray) -> np.ndarray:
    """Return V diag(inverted) Uᵀ."""
    inverse = np.asarray((np.swapaxes(Vt, -1, -2) * inverted[..., np.newaxis, :]) @ np.swapaxes(U, -1, -2))
    inverse.flags.writeable = False
    return inverse


def _require_full_rank(singular_values: np.ndarray, form: str, kind: str) -> None:
    rank = singular_values.shape[-1]
    zero = rank * np.finfo(float).eps * singular_values[..., :1]  # the rule of numpy.linalg.matrix_rank
    ranks = np.sum(singular_values > zero, axis=-1)
    if (ranks < rank).any():
        fault, number = Fault.SINGULAR_IN_BATCH if ranks.ndim else Fault.SINGULAR_JACOBIAN, int(np.argmax(ranks < rank))
        raise ModelError(
            fault, form=Sentence(form), of=Sentence(kind), rank=rank, least=int(ranks.min()), number=number
        )
