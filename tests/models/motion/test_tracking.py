"""Tracking in simulation: every arm follows its motion; with a wrong model, without gains or with weak drives it does not."""

import numpy as np
import pytest
from pydrake.trajectories import DiscreteTimeTrajectory, PiecewisePolynomial

from armproof.models.arm import Arm
from armproof.models.catalogue import arm_names, load_arm
from armproof.models.errors import ModelError
from armproof.models.motion.computed_torque import InverseDynamics
from armproof.models.motion.joint_space import joint_path, point_to_point
from armproof.models.motion.quintic import quintic
from armproof.models.motion.samples import sample_motion
from armproof.models.motion.time_optimal import time_optimal
from armproof.models.motion.tracking import PERIOD, TrackingLog, track
from armproof.models.numeric.drake_arm import plant_of
from tests.models.motion.test_joint_space import configurations

TARGET = 1e-3  # rad and m


def joint_error(log: TrackingLog) -> float:
    """Return the largest |q − q_desired| of all joints (rad, m)."""
    return float(np.abs(log.q - log.q_desired).max())


def motion(arm: Arm, duration: float = 0.2, part: float = 0.05):
    """Return a quintic over part of the joints' ranges."""
    q_0 = configurations(arm, 2)[0]
    ranges = np.array([min(joint.upper, 3.0) - max(joint.lower, -3.0) for joint in arm.joints])
    return point_to_point(arm, q_0, q_0 + part * ranges, duration)


def errors(log: TrackingLog) -> float:
    return max(joint_error(log), log.position_error.max(), log.rotation_error.max())


@pytest.mark.parametrize("name", ["scara", "rx90"])
def test_the_quintic_is_tracked_within_a_milliradian_and_a_millimetre(name: str):
    arm = load_arm(name)
    log = track(arm, motion(arm, part=0.02))
    assert errors(log) < TARGET and not log.saturated.any()
    assert np.ptp(log.q, axis=0).min() > 0.003, "nothing moves"
    assert len(log.times) == round(0.2 / PERIOD) + 1


@pytest.mark.parametrize("name", arm_names())
def test_every_arm_tracks(name: str):
    arm = load_arm(name)
    log = track(arm, motion(arm, part=0.01), period=1e-3)
    assert errors(log) < TARGET
    n = len(arm.joints)
    assert log.q.shape == log.v.shape == log.q_desired.shape == log.v_desired.shape == log.torques.shape == (201, n)
    assert log.position_error.shape == log.rotation_error.shape == log.times.shape == (201,)
    with pytest.raises(ValueError, match="read-only"):
        log.q[0] = 1


@pytest.mark.parametrize("name", ["planar_3r", "scara"])
def test_a_controller_with_wrong_masses_misses(name: str):
    arm = load_arm(name)
    options = {"period": 1e-3, "effort": np.inf}
    right, wrong = (track(arm, motion(arm), mass_factor=factor, **options) for factor in (1.0, 1.3))
    assert errors(wrong) > 10 * errors(right) and errors(wrong) > TARGET


def test_without_gains_a_wrong_start_is_never_made_good():
    arm = load_arm("scara")
    trajectory = motion(arm, 0.4)
    q_start = sample_motion(trajectory, [0.0]).q[0] + [0.01, -0.01, 0.002, 0.02]
    corrected = track(arm, trajectory, period=1e-3, q_start=q_start)
    left = track(arm, trajectory, period=1e-3, q_start=q_start, kp=0, kd=0)
    last = [np.abs(log.q[-1] - log.q_desired[-1]).max() for log in (corrected, left)]
    assert last[0] < 2e-3 < 0.01 < last[1]


def test_a_wrong_start_decays_as_the_gains_say():
    arm = load_arm("planar_2r")
    offset = np.array([0.01, -0.02])
    q = np.array([0.3, 0.4])
    log = track(arm, quintic(q, q, 0.2), period=5e-4, q_start=q + offset, kp=225, kd=30)
    expected = (1 + 15 * log.times[:, np.newaxis]) * np.exp(-15 * log.times[:, np.newaxis]) * offset
    np.testing.assert_allclose(log.q - log.q_desired, expected, atol=4e-5)


def test_the_error_is_of_second_order_in_the_period():
    arm = load_arm("scara")
    found = [joint_error(track(arm, motion(arm), period=period)) for period in (4e-3, 2e-3, 1e-3)]
    assert found[0] > 3 * found[1] > 9 * found[2] > 0


def test_holding_still_takes_the_torques_of_gravity():
    arm = load_arm("rx90")
    q = configurations(arm, 2)[0]
    log = track(arm, quintic(q, q, 0.05))
    np.testing.assert_allclose(log.q, np.tile(q, (len(log.q), 1)), atol=1e-9)
    context = plant_of(arm).CreateDefaultContext()
    plant_of(arm).SetPositions(context, q)
    gravity = -plant_of(arm).CalcGravityGeneralizedForces(context)
    np.testing.assert_allclose(log.torques, np.tile(gravity, (len(log.q), 1)), atol=1e-6)
    assert np.abs(gravity).max() > 1


def test_the_simulation_obeys_the_equations_of_motion():
    arm = load_arm("planar_3r")
    log = track(arm, motion(arm, part=0.1), period=1e-3)
    dynamics, middle = InverseDynamics(arm), 0.5 * (log.q[1:] + log.q[:-1])
    rates, accelerations = 0.5 * (log.v[1:] + log.v[:-1]), np.diff(log.v, axis=0) / 1e-3
    needed = np.array([dynamics.torques(*row) for row in zip(middle, rates, accelerations, strict=True)])
    np.testing.assert_allclose(needed, log.torques[:-1], atol=2e-3 * np.abs(log.torques).max())


def test_drives_that_are_too_weak_are_told_of_and_the_arm_falls_behind():
    arm = load_arm("planar_2r")
    q = sample_motion(motion(arm), [0.0]).q[0]
    fast = point_to_point(arm, q, q + 0.6, 0.3)
    weak = track(arm, fast, period=1e-3, effort=[3.0, 1.0])
    assert weak.saturated.any() and errors(weak) > 0.01
    assert (np.abs(weak.torques) <= [3.0, 1.0]).all()
    strong = track(arm, fast, period=1e-3, effort=np.inf)
    assert not strong.saturated.any() and errors(strong) < TARGET


def test_the_fastest_motion_can_be_tracked():
    arm = load_arm("planar_2r")
    fastest = time_optimal(arm, joint_path(arm, configurations(arm, 3, margin=0.4)), grid_points=60)
    assert joint_error(track(arm, fastest.trajectory, period=1e-3)) < 0.01


def test_a_motion_may_start_at_any_time_and_with_velocity():
    arm = load_arm("polar_rp")
    log = track(arm, quintic([0.1, 0.4], [0.4, 0.45], 0.3, v_0=0.2, start_time=7.0), period=1e-3)
    assert (log.times[0], log.times[-1]) == (7.0, pytest.approx(7.3)) and errors(log) < TARGET
    np.testing.assert_allclose(log.v[0], 0.2)


def test_the_pose_error_is_that_of_the_frame_named():
    arm = load_arm("planar_2r")
    q_start = np.array([0.3, 0.41])
    still = quintic([0.3, 0.4], [0.3, 0.4], 0.01)
    tool, elbow = (track(arm, still, frame=frame, q_start=q_start) for frame in ("2", "1"))
    assert tool.position_error[0] == pytest.approx(2 * arm.lengths["l_2"] * np.sin(0.005))
    assert tool.rotation_error[0] == pytest.approx(0.01)
    assert elbow.position_error[0] < 1e-12


def test_arms_given_by_a_table_can_be_simulated_and_links_without_mass_cannot(arm: Arm):
    if arm.name in arm_names():
        return
    still = quintic(np.full(len(arm.joints), 0.1), np.full(len(arm.joints), 0.1), 0.01)
    if arm.dh is None:
        with pytest.raises(ModelError, match=r"cannot be simulated: its mass matrix is singular"):
            track(arm, still)
    else:
        assert errors(track(arm, still)) < TARGET


def test_the_model_scales_with_its_masses_and_forgets_the_last_call():
    arm = load_arm("scara")
    q, zero = np.array([0.2, 0.4, 0.1, 0.3]), np.zeros(4)
    right, wrong = InverseDynamics(arm), InverseDynamics(arm, 1.5)
    w = np.array([1.0, 2.0, 3.0, 4.0])
    first = right.torques(q, zero, w)
    np.testing.assert_allclose(wrong.torques(q, zero, w), 1.5 * first, rtol=1e-12)
    np.testing.assert_array_equal(right.torques(q, zero, w), first)
    assert right.torques(q, zero, zero)[2] == pytest.approx(-9.81 * (0.8 + 0.7 + 0.001)), "the quill's axis points down"


@pytest.mark.parametrize(
    ("trajectory", "options", "message"),
    [
        (quintic([0] * 3, [1] * 3, 1), {}, r"values of the shape \(2, 1\), not \(3, 1\)"),
        ("motion", {}, "not a str"),
        (PiecewisePolynomial(np.zeros((2, 1))), {}, "a start and a later end"),
        (DiscreteTimeTrajectory([0, 1], np.zeros((2, 2))), {}, "no velocity or acceleration"),
        (None, {"kp": -1}, "kp: gains are not negative; the least is -1"),
        (None, {"kd": [1, 2, 3]}, r"kd: a vector of the shape \(2,\)"),
        (None, {"kd": np.nan}, "kd: every number is finite"),
        (None, {"period": 0}, "period: a motion takes a positive time"),
        (None, {"period": 1e-8}, "at most 1000000 are simulated"),
        (None, {"mass_factor": 0}, "mass_factor"),
        (None, {"effort": -1}, "effort: one positive limit"),
        (None, {"frame": "7"}, "no frame '7'"),
        (None, {"q_start": [0]}, r"a configuration of arm 'planar_2r' has the shape \(2,\)"),
    ],
)
def test_what_cannot_be_tracked_is_refused(trajectory, options, message):
    with pytest.raises(ModelError, match=message):
        track(load_arm("planar_2r"), quintic([0, 0], [1, 1], 1) if trajectory is None else trajectory, **options)
