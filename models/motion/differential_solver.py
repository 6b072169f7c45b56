"""Joint values for a pose by damped Newton steps with the Jacobian, from joint values nearby."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from operator import index

import numpy as np

from armproof.models.arm import Arm
from armproof.models.errors import Fault, ModelError
from armproof.models.motion.inverse_velocity import damped_inverse
from armproof.models.motion.pose_error import pose_error
from armproof.models.numeric.plant import NumericKinematics

# From the pose (4, 4) of the tool in frame 0 and joint values (n,) nearby to the joint values (n,); NaN or a ModelError
# where there are none.
Solver = Callable[[np.ndarray, np.ndarray], np.ndarray]

ALL_ROWS = (1, 2, 3, 4, 5, 6)
_SMALLEST_DAMPING = 1e-9
_LARGEST_STEP = 0.5  # rad, m


def differential_solver(
    arm: Arm, frame: str, rows: Sequence[int] = ALL_ROWS, *, tolerance: float = 1e-10, most_steps: int = 60
) -> Solver:
    """Return a solver that goes from joint values nearby to those of a pose by steps q += Jᵀ (J Jᵀ + λ² I)⁻¹ e.

    e is the pose error [Δp; φ] and λ² = ‖e‖² / 2 plus a little, so that steps are bounded far from the pose and those of
    Newton near to it.

    Source: T. Sugihara, 2011.

    Args:
        frame: the document frame that marks the tool.
        rows: the rows of [v; ω], from 1, that the arm is to follow.
        tolerance: the largest ‖e‖ of the result.
        most_steps: after so many steps the pose counts as unreachable.

    Raises:
        ModelError: an unknown frame or row. The solver itself raises it where it finds no joint values.
    """
    name = arm.frame_names(frame)[0]
    chosen = read_rows(rows)

    def solve(X_desired: np.ndarray, q_near: np.ndarray) -> np.ndarray:
        q = np.array(q_near, dtype=float)
        for _ in range(most_steps):
            kinematics = NumericKinematics(arm, q[np.newaxis])
            error = pose_error(X_desired, kinematics.pose(name)[0])[chosen]
            distance = float(np.linalg.norm(error))
            if distance <= tolerance:
                return q
            damping = np.sqrt(distance**2 / 2 + _SMALLEST_DAMPING**2)
            step = damped_inverse(kinematics.jacobian(name)[0][chosen], damping) @ error
            q += step * min(1.0, _LARGEST_STEP / max(float(np.abs(step).max()), 1e-300))
        raise ModelError(Fault.SOLVER_ENDS_AWAY, steps=most_steps, distance=distance)

    return solve


def read_rows(rows: Sequence[int]) -> list[int]:
    """Return the rows of [v; ω] that a task follows, counted from 0.

    Raises:
        ModelError: no row, a row twice, or one that is not 1 … 6.
    """
    try:
        chosen = [index(row) for row in rows]
    except (TypeError, ValueError):
        chosen = []
    if not chosen or len(set(chosen)) < len(chosen) or not set(chosen) <= set(ALL_ROWS):
        raise ModelError(Fault.TASK_ROWS, given=str(rows))
    return [row - 1 for row in chosen]
