"""Track a motion in a Drake simulation of the arm: inverse dynamics control, gravity, limited drives; the log as arrays."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from armproof.models.arm import Arm
from armproof.models.errors import Fault, ModelError
from armproof.models.motion.computed_torque import InverseDynamics, make_controller
from armproof.models.motion.inputs import read_duration, read_vector
from armproof.models.motion.limits import read_rate_limits
from armproof.models.motion.pose_error import pose_error
from armproof.models.motion.samples import MotionSamples, interval, sample_motion
from armproof.models.numeric.drake_arm import drake_of, plant_of
from armproof.models.numeric.joint_values import read_configuration
from armproof.models.numeric.plant import NumericKinematics

BANDWIDTH = 20.0  # rad/s: an error of the closed loop decays like (1 + 20 t) exp(−20 t)
PERIOD = 0.25e-3  # s, of the controller
_ACCURACY = 1e-6  # of the integrator; sampling the controller costs more
_MOST_STEPS = 1_000_000


@dataclass(frozen=True)
class TrackingLog:
    """A simulated motion of n joints at N control instants; the arrays are read-only.

    Attributes:
        times: (N,), s, from the start of the trajectory to its end.
        q, v: simulated positions and velocities, (N, n), base to tool (rad, m; rad/s, m/s).
        q_desired, v_desired: those of the trajectory.
        torques: (N, n), what the drives give from each instant to the next (N m, N).
        position_error: (N,), distance of the tool from where the trajectory has it (m).
        rotation_error: (N,), angle between the tool and what the trajectory has it be (rad).
        saturated: (N,) whether a drive was at its effort limit.
    """

    times: np.ndarray
    q: np.ndarray
    v: np.ndarray
    q_desired: np.ndarray
    v_desired: np.ndarray
    torques: np.ndarray
    position_error: np.ndarray
    rotation_error: np.ndarray
    saturated: np.ndarray


def track(
    arm: Arm,
    trajectory: Any,
    *,
    frame: str | None = None,
    kp: Any = BANDWIDTH**2,
    kd: Any = 2 * BANDWIDTH,
    period: float = PERIOD,
    effort: Any = None,
    mass_factor: float = 1.0,
    q_start: Any = None,
) -> TrackingLog:
    """Simulate an arm that tracks a trajectory.

    A copy of the arm's plant, with gravity and the damping of its joints, is integrated by Drake's Simulator. Every
    `period` the controller takes the torques τ = ID(q, q̇, w_d + K_d (q̇_d − q̇) + K_p (q_d − q)) of its model, cut
    off at the efforts of the drives, and holds them until the next; see make_controller. Joint limits do not stop the joints.

    Args:
        trajectory: a pydrake Trajectory with values of the shape (n, 1), base to tool; it may start at any time.
        frame: the document frame whose pose error is logged; the last frame of the arm if not given.
        kp, kd: gains, one number or (n,), 1/s² and 1/s.
        period: of the controller (s); rounded so that a whole number of them makes the duration.
        effort: highest torques and forces, one number or (n,), infinite for none; those of the model file if not given.
        mass_factor: the mass of every link in the controller's model, as a multiple of the real one.
        q_start: (n,), where the arm stands at the start; at the start of the trajectory, with its velocity, if not given.

    Raises:
        ModelError: a trajectory of another shape or without two derivatives, gains that are negative, a number that is
            not positive or not finite, an unknown frame, an arm whose mass matrix is singular, or a simulation that does
            not end.
    """
    name = arm.frame_names(arm.frames[-1] if frame is None else frame)[0]
    desired = _control_instants(arm, trajectory, period)
    limits = read_rate_limits(arm, effort=effort).effort
    model = InverseDynamics(arm, read_duration(mass_factor, "mass_factor"))
    start = desired.q[0] if q_start is None else read_configuration(arm, q_start)
    rates = desired.v[0] if q_start is None else np.zeros_like(start)
    model.require_masses(arm, start)
    controller = make_controller(arm, model, desired, _gains(kp, "kp", arm), _gains(kd, "kd", arm), limits)
    q, v, torques = _simulate(arm, controller, start, rates, desired.times)
    error = pose_error(NumericKinematics(arm, desired.q).pose(name), NumericKinematics(arm, q).pose(name))
    arrays = {
        "times": desired.times + interval(trajectory)[0],
        "q": q,
        "v": v,
        "q_desired": desired.q,
        "v_desired": desired.v,
        "torques": torques,
        "position_error": np.linalg.norm(error[:, :3], axis=1),
        "rotation_error": np.linalg.norm(error[:, 3:], axis=1),
        "saturated": (np.abs(torques) >= limits).any(axis=1),
    }
    for array in arrays.values():
        array.flags.writeable = False
    return TrackingLog(**arrays)


def _control_instants(arm: Arm, trajectory: Any, period: float) -> MotionSamples:
    """Return the motion at the control instants, counted from 0."""
    start, end = interval(trajectory, len(arm.joints))
    steps = max(round((end - start) / read_duration(period, "period")), 1)
    if steps > _MOST_STEPS:
        raise ModelError(Fault.TOO_MANY_PERIODS, seconds=end - start, steps=steps, period=period, most=_MOST_STEPS)
    motion = sample_motion(trajectory, np.linspace(start, end, steps + 1))
    if not all(np.isfinite(values).all() for values in (motion.q, motion.v, motion.w)):
        raise ModelError(Fault.TRAJECTORY_NOT_FINITE)
    return MotionSamples(np.linspace(0.0, end - start, steps + 1), motion.q, motion.v, motion.w)


def _gains(value: Any, name: str, arm: Arm) -> np.ndarray:
    size = len(arm.joints)
    gains = read_vector(np.broadcast_to(value, size) if np.ndim(value) == 0 else value, name, size)
    if (gains < 0).any():
        raise ModelError(Fault.NEGATIVE_GAINS, name=name, least=gains.min())
    return gains


def _simulate(
    arm: Arm, controller: Any, q_0: np.ndarray, v_0: np.ndarray, times: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return positions, velocities and torques at the control instants, (N, n) each, base to tool."""
    from pydrake.systems.analysis import Simulator
    from pydrake.systems.framework import DiagramBuilder

    order, n = list(drake_of(arm).position_indices), len(q_0)
    builder = DiagramBuilder()
    plant: Any = builder.AddSystem(plant_of(arm).Clone())
    builder.AddSystem(controller)
    builder.Connect(plant.get_state_output_port(), controller.get_input_port())
    builder.Connect(controller.get_output_port(), plant.get_applied_generalized_force_input_port())
    simulator = Simulator(builder.Build())
    simulator.get_mutable_integrator().set_target_accuracy(_ACCURACY)
    root = simulator.get_mutable_context()
    state = np.zeros((2, n))
    state[:, order] = q_0, v_0
    plant.SetPositionsAndVelocities(plant.GetMyMutableContextFromRoot(root), state.ravel())
    states, torques = np.empty((len(times), 2, n)), np.empty((len(times), n))
    plant_context, controller_context = plant.GetMyContextFromRoot(root), controller.GetMyContextFromRoot(root)
    try:
        simulator.Initialize()
        for k, time in enumerate(times):
            simulator.AdvanceTo(time)
            states[k] = plant.GetPositionsAndVelocities(plant_context).reshape(2, n)
            simulator.AdvancePendingEvents()
            torques[k] = controller.get_output_port().Eval(controller_context)
    except RuntimeError as error:
        raise ModelError(Fault.SIMULATION_ENDED, arm=arm.name, at=root.get_time(), reason=str(error)) from None
    return states[:, 0, order], states[:, 1, order], torques[:, order]
