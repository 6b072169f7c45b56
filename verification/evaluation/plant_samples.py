"""The samples at which a document's proofs are evaluated again: the double plant at six families of configurations."""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from armproof.models.arm import Arm
from armproof.models.numeric.configurations import FAMILIES, sample
from armproof.verification.evaluation.exact import ExactAlgebra
from armproof.verification.evaluation.sampled import SampledAlgebra

SAMPLES = 1000
SEED = 2019


def plant_samples(exact: ExactAlgebra) -> SampledAlgebra:
    """Return the algebra of arrays over the configurations of an exact algebra's arm; without one, over letters alone."""
    if exact.arm is None:
        return SampledAlgebra(exact, np.zeros((SAMPLES, 0)), SEED)
    q, at_random = _configurations(exact.arm)
    return SampledAlgebra(exact, q, SEED, random=at_random)


@lru_cache(maxsize=32)
def _configurations(arm: Arm) -> tuple[np.ndarray, np.ndarray]:
    """The configurations, and which of them are drawn at random."""
    q, family = sample(arm, SAMPLES, np.random.default_rng(SEED))
    return q, np.isin(family, [FAMILIES.index("generic"), FAMILIES.index("wide")])
