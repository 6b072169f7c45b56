"""Configurations of an arm at which a wrong result is looked at, and the arm's quantities there."""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache

import numpy as np

from armproof.models.arm import Arm
from armproof.models.numeric.configurations import FAMILIES, sample
from armproof.models.numeric.plant import NumericKinematics
from armproof.verification.algebra.quantity import Quantity
from armproof.verification.algebra.ring import Ring
from armproof.verification.evaluation.exact import ExactAlgebra
from armproof.verification.evaluation.sampled import SampledAlgebra

PROBES = 4
_PROBE_SEED = 7
_QUARTER = float(np.pi / 2)


class Configurations:
    """Some configurations of an arm, and its quantities there as the plant of doubles gives them."""

    def __init__(self, arm: Arm, q: np.ndarray) -> None:
        self.arm = arm
        self.q = q
        self.numeric = NumericKinematics(arm, q)
        self._algebra = SampledAlgebra(ExactAlgebra(Ring(), arm), q)
        self._true: dict[Quantity, np.ndarray] = {}

    def true_for(self, quantity: Quantity, lengths: Mapping[str, float]) -> np.ndarray:
        """Return a quantity at each configuration, for other lengths than the arm's."""
        algebra = self._algebra.at({name: np.full(len(self.q), value) for name, value in lengths.items()})
        return algebra.stacked(algebra.quantity(quantity))

    def true(self, quantity: Quantity) -> np.ndarray:
        """Return a quantity at each configuration: (N, rows, columns)."""
        if quantity not in self._true:
            self._true[quantity] = self._algebra.stacked(self._algebra.quantity(quantity))
        return self._true[quantity]


@lru_cache(maxsize=32)
def probes(arm: Arm) -> Configurations:
    """Return a few generic configurations, with values of one decimal."""
    return Configurations(arm, _generic(arm, PROBES))


@lru_cache(maxsize=32)
def partners(arm: Arm) -> Configurations:
    """Return n configurations; the k-th shares with the first probe the value of joint k, and no other.

    A result that is equal at the two depends on that joint alone.
    """
    q = _generic(arm, PROBES + len(arm.joints))[PROBES:]
    np.fill_diagonal(q, _generic(arm, PROBES)[0])
    return Configurations(arm, q)


def _generic(arm: Arm, count: int) -> np.ndarray:
    rng = np.random.default_rng(_PROBE_SEED)
    low = np.array([-2.6 if joint.kind == "revolute" else 0.1 for joint in arm.joints])
    high = np.array([2.6 if joint.kind == "revolute" else 0.9 for joint in arm.joints])
    q = np.round(rng.uniform(low, high, (count, len(arm.joints))), 1)
    return np.where(np.abs(q) < 0.25, 0.3, q)


@lru_cache(maxsize=32)
def simple(arm: Arm) -> Configurations:
    """Return the zero pose, and one joint at a time at a quarter turn, or out by half a metre."""
    n = len(arm.joints)
    steps = np.diag([_QUARTER if joint.kind == "revolute" else 0.5 for joint in arm.joints])
    return Configurations(arm, np.concatenate([np.zeros((1, n)), steps]))


@lru_cache(maxsize=32)
def samples(arm: Arm, count: int, seed: int) -> Configurations:
    """Return configurations of the six families, one of each family in turn."""
    q, family = sample(arm, count, np.random.default_rng(seed))
    turn = np.concatenate([np.arange(np.sum(family == k)) for k in range(len(FAMILIES))])
    return Configurations(arm, q[np.lexsort((family, turn))])
