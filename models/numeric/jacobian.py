"""The geometric Jacobian of a Drake plant, with the rows in the order of the documents."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np


def calc_jacobian(plant: Any, context: Any, frame: Any, reference: Any, expressed_in: Any) -> np.ndarray:
    """Return the geometric Jacobian J(q) of the origin of a frame, stacked as [v; ω].

    [v; ω] = J(q) q̇, with v the velocity of the origin of `frame` (m/s) and ω the angular velocity of `frame` (rad/s),
    both relative to the frame `reference` and expressed in the frame `expressed_in`. Drake stacks [ω; v], the documents
    [v; ω]: this is the one place where the order is converted.

    Args:
        plant: a finalized MultibodyPlant of doubles, AutoDiffXd or Expression, with frames of the same plant.

    Returns:
        (6, num_velocities) array; columns in the plant's order of velocities.
    """
    omega_v = plant.CalcJacobianSpatialVelocity(context, _velocities(), frame, np.zeros(3), reference, expressed_in)
    return np.concatenate([omega_v[3:], omega_v[:3]])


@cache  # pydrake looks a name up anew at every import of it, which at each configuration would cost a third of the call
def _velocities() -> Any:
    from pydrake.multibody.tree import JacobianWrtVariable

    return JacobianWrtVariable.kV
