"""Inverse dynamics control of an arm in a Drake simulation, with a sampled controller and drives of limited effort."""

from __future__ import annotations

from typing import Any

import numpy as np

from armproof.models.arm import Arm
from armproof.models.errors import Fault, ModelError
from armproof.models.motion.samples import MotionSamples
from armproof.models.numeric.drake_arm import drake_of, plant_of


class InverseDynamics:
    """The torques that a model of the arm needs for given accelerations: τ = M(q) w + C(q, q̇) q̇ + D q̇ − τ_g(q).

    The model is Drake's plant of the arm, with gravity and the damping of the joints.
    """

    def __init__(self, arm: Arm, mass_factor: float = 1.0) -> None:
        """Take the arm, and the factor by which the model has the mass and inertia of every moving link wrong."""
        from pydrake.multibody.tree import MultibodyForces

        self._plant = plant_of(arm)
        self._forces = MultibodyForces(plant_of(arm))
        self._context = self._plant.CreateDefaultContext()
        self._order = list(drake_of(arm).position_indices)
        if mass_factor != 1.0:
            self._scale_masses(mass_factor)

    def torques(self, q: np.ndarray, v: np.ndarray, w: np.ndarray) -> np.ndarray:
        """Return the torques and forces (n,) at positions, velocities and accelerations (n,), base to tool (N m, N)."""
        positions, velocities, accelerations = np.zeros((3, len(self._order)))
        positions[self._order], velocities[self._order], accelerations[self._order] = q, v, w
        self._plant.SetPositions(self._context, positions)
        self._plant.SetVelocities(self._context, velocities)
        self._plant.CalcForceElementsContribution(self._context, self._forces)
        return np.asarray(self._plant.CalcInverseDynamics(self._context, accelerations, self._forces))[self._order]

    def require_masses(self, arm: Arm, q: np.ndarray) -> None:
        """Check that every joint has something to accelerate.

        Raises:
            ModelError: the mass matrix is singular; links without mass do not move by Newton's law.
        """
        self.torques(q, np.zeros_like(q), np.zeros_like(q))
        smallest = np.linalg.eigvalsh(self._plant.CalcMassMatrix(self._context))[0]
        if not smallest > 1e-12:
            raise ModelError(Fault.SINGULAR_MASS, arm=arm.name, smallest=smallest)

    def _scale_masses(self, factor: float) -> None:
        from pydrake.multibody.tree import BodyIndex, SpatialInertia

        for index in range(1, self._plant.num_bodies()):
            body = self._plant.get_body(BodyIndex(index))
            right = body.CalcSpatialInertiaInBodyFrame(self._context)
            mass, center, unit_inertia = factor * right.get_mass(), right.get_com(), right.get_unit_inertia()
            body.SetSpatialInertiaInBodyFrame(self._context, SpatialInertia(mass, center, unit_inertia))


def make_controller(
    arm: Arm, model: InverseDynamics, desired: MotionSamples, kp: np.ndarray, kd: np.ndarray, effort: np.ndarray
) -> Any:
    """Return a Drake system that tracks a sampled motion with computed torques.

    τ = ID(q, q̇, w) with w = w_d + K_d (q̇_d − q̇) + K_p (q_d − q), cut off at the effort limits, computed at each control
    instant and held until the next. Because it is held, it is taken for the middle of that time: w_d of the motion there, and
    q and q̇ as w carries them there. Without this a light, well damped joint, as the last of a wrist, lags behind.

    Args:
        desired: the motion at the control instants, equally spaced from time 0.
        kp, kd: (n,), 1/s² and 1/s.
        effort: (n,), highest torque or force.

    Returns:
        A LeafSystem: input port "state" [q; q̇], output port "torques", both in the order of the arm's plant.
    """
    from pydrake.systems.framework import LeafSystem

    order = list(drake_of(arm).position_indices)
    size, period = len(order), float(desired.times[1] - desired.times[0])
    middle, half = np.vstack([(desired.w[1:] + desired.w[:-1]) / 2, desired.w[-1:]]), period / 2

    class Controller(LeafSystem):  # type: ignore[misc]
        def __init__(self) -> None:
            super().__init__()
            self.DeclareVectorInputPort("state", 2 * size)
            held = self.DeclareDiscreteState(size)
            self.DeclarePeriodicDiscreteUpdateEvent(period, 0.0, self._update)
            self.DeclareStateOutputPort("torques", held)

        def _update(self, context: Any, values: Any) -> None:
            k = min(round(context.get_time() / period), len(middle) - 1)
            state: Any = self.get_input_port(0).Eval(context)
            q, v = state.reshape(2, size)[:, order]
            w = middle[k] + kd * (desired.v[k] - v) + kp * (desired.q[k] - q)
            torques = np.zeros(size)
            torques[order] = np.clip(model.torques(q + v * half, v + w * half, w), -effort, effort)
            values.get_mutable_vector(0).SetFromVector(torques)

    return Controller()
