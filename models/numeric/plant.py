"""The kinematics of an arm's plant of doubles at many configurations: the second route to every equation."""

from __future__ import annotations

from functools import cache, cached_property
from typing import Any

import numpy as np

from armproof.models.arm import Arm
from armproof.models.numeric.drake_arm import drake_of, frame_of, plant_of
from armproof.models.numeric.joint_values import read_joint_values


class NumericKinematics:
    """Poses and Jacobians at N configurations, computed once each and handed out read-only.

    A reference, or axes, that are not given are the base frame's, usually "0". A frame that the arm has not is a ModelError.
    """

    def __init__(self, arm: Arm, q: np.ndarray) -> None:
        """Take the configurations.

        Args:
            q: (N, n) array of joint variables, base to tool (rad, m).

        Raises:
            ModelError: q cannot be read (see `read_joint_values`).
        """
        q = read_joint_values(arm, q).copy()
        self._arm = arm
        self._positions = np.zeros((len(q), plant_of(arm).num_positions()))
        self._positions[:, drake_of(arm).position_indices] = q
        self.q = _read_only(q)
        self._poses: dict[str, np.ndarray] = {}
        self._jacobians: dict[tuple[str, ...], np.ndarray] = {}

    def pose(self, frame: str, reference: str | None = None) -> np.ndarray:
        """Return the pose of a frame in a reference frame at each configuration, {}^{reference}T_{frame}.

        Returns:
            (N, 4, 4) array, metres.
        """
        X_WF, X_WR = self._world_poses(*self._arm.frame_names(frame, reference))
        R_RW = X_WR[:, :3, :3].transpose(0, 2, 1)
        X_RF = np.zeros_like(X_WF)
        X_RF[:, :3, :3] = R_RW @ X_WF[:, :3, :3]
        X_RF[:, :3, 3:] = R_RW @ (X_WF[:, :3, 3:] - X_WR[:, :3, 3:])
        X_RF[:, 3, 3] = 1.0
        return _read_only(X_RF)

    def jacobian(self, frame: str, expressed_in: str | None = None, reference: str | None = None) -> np.ndarray:
        """Return the geometric Jacobian of the origin of a frame at each configuration: [v; ω] = J(q) q̇.

        v (m/s) and ω (rad/s) are those of `frame` relative to `reference`, expressed in the axes of `expressed_in`.

        Returns:
            (N, 6, n) array, rows [v; ω], columns base to tool.
        """
        key = self._arm.frame_names(frame, expressed_in, reference)
        if key not in self._jacobians:
            self._jacobians[key] = _read_only(self._calc_jacobians(*key))
        return self._jacobians[key]

    @cached_property
    def _context(self) -> Any:
        return plant_of(self._arm).CreateDefaultContext()

    def _world_poses(self, *names: str) -> list[np.ndarray]:
        """Return the world poses of frames; those that are new in one pass over the configurations."""
        new = [name for name in dict.fromkeys(names) if name not in self._poses]
        if new:
            plant, context = plant_of(self._arm), self._context
            frames = [frame_of(self._arm, name) for name in new]
            poses = np.empty((len(new), len(self._positions), 4, 4))
            moving = [(i, frame) for i, frame in enumerate(frames) if not plant.IsAnchored(frame.body())]
            for k, positions in enumerate(self._positions if moving else ()):
                plant.SetPositions(context, positions)
                for i, frame in moving:
                    poses[i, k] = frame.CalcPoseInWorld(context).GetAsMatrix4()
            for i in set(range(len(frames))).difference(i for i, _ in moving):
                poses[i] = frames[i].CalcPoseInWorld(context).GetAsMatrix4()
            self._poses.update(zip(new, poses, strict=True))
        return [self._poses[name] for name in names]

    def _calc_jacobians(self, frame: str, expressed_in: str, reference: str) -> np.ndarray:
        plant, context = plant_of(self._arm), self._context
        frames = [frame_of(self._arm, name) for name in (frame, reference, expressed_in)]
        jacobians = np.empty((len(self._positions), 6, plant.num_velocities()))
        for k, positions in enumerate(self._positions):
            plant.SetPositions(context, positions)
            jacobians[k] = calc_jacobian(plant, context, *frames)
        return jacobians[:, :, drake_of(self._arm).position_indices]


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


def _read_only(array: np.ndarray) -> np.ndarray:
    array.flags.writeable = False
    return array
