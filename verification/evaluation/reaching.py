"""The configuration near another in which entries of an arm's matrices have given values, and the algebra at it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import cos, hypot, pi, prod, sin, sqrt

import numpy as np

from armproof.models.errors import ModelError
from armproof.models.exact.numbers import angle_value
from armproof.verification.algebra.ring import Scalar
from armproof.verification.evaluation.exact import ExactAlgebra
from armproof.verification.evaluation.sampled import SampledAlgebra

STEPS = 40  # of Newton's method
CLOSE = 1e-10  # of what is reached to what is asked for, lengths of one


Asked = tuple[Scalar, float]  # an entry of a quantity of the arm, and the value that it is to have


def algebra_at(exact: ExactAlgebra, q: Mapping[str, float], lengths: Mapping[str, float]) -> SampledAlgebra:
    """Return the algebra of the numbers in one configuration."""
    given = {key: np.array([value]) for key, value in lengths.items()}
    return SampledAlgebra(exact, np.array([[*q.values()]]), overrides=given)


def reaching(
    asked: Sequence[Asked], joints: Sequence[str], lengths: Mapping[str, float], start: Mapping[str, float]
) -> dict[str, float] | None:
    """Return the configuration near another in which all entries have the values that they are to have: Newton's method, damped.

    q ← q − (JᵀJ + λ 1)⁻¹ Jᵀ (f(q) − p) (Levenberg 1944); None where it does not end.
    """
    q = np.array([start[joint] for joint in joints])

    def off(at: np.ndarray) -> np.ndarray:
        values = {**lengths, **dict(zip(joints, map(float, at), strict=True))}
        return np.array([value_at(entry, values) - value for entry, value in asked])

    try:
        error, damping = off(q), 1e-3
        for _ in range(STEPS):
            if hypot(*error) < CLOSE:
                return dict(zip(joints, map(float, q), strict=True))
            step = 1e-7
            jacobian = np.column_stack([(off(q + step * unit) - error) / step for unit in np.eye(len(joints))])
            change = np.linalg.solve(
                jacobian.T @ jacobian + damping * damping * np.eye(len(joints)), jacobian.T @ error
            )
            trial = off(q - change)
            better = hypot(*trial) < hypot(*error)
            q, error, damping = (q - change, trial, damping / 10) if better else (q, error, damping * 10)
    except (KeyError, ZeroDivisionError, ModelError, np.linalg.LinAlgError):
        return None
    return None


def value_at(scalar: Scalar, values: Mapping[str, float]) -> float:
    """Return the number that a scalar of cosines, sines and letters is at some values; raises KeyError where it holds anything else."""

    def of(generator: tuple[str, str]) -> float:
        kind, name = generator
        if kind in ("cos", "sin"):
            angle = values[name] if name in values else float(angle_value(name))
            return cos(angle) if kind == "cos" else sin(angle)
        return {"pi": lambda: pi, "sqrt": lambda: sqrt(int(name)), "symbol": lambda: values[name]}[kind]()

    def total(polynomial: object) -> float:
        terms = scalar.ring.terms(polynomial)  # type: ignore[arg-type]
        return sum(float(k) * prod(of(g) ** power for g, power in powers.items()) for powers, k in terms)

    return total(scalar.numerator) / total(scalar.denominator)
