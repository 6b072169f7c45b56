"""The fastest motion along a path: it keeps every limit, reaches one at nearly every time, and is known for one joint."""

import numpy as np
import pytest
from pydrake.trajectories import DiscreteTimeTrajectory, PiecewisePolynomial

from armproof.models.arm import Arm
from armproof.models.catalogue import arm_names, load_arm
from armproof.models.errors import ModelError
from armproof.models.motion.joint_space import joint_path, point_to_point
from armproof.models.motion.limits import read_rate_limits
from armproof.models.motion.quintic import quintic, shortest_duration
from armproof.models.motion.samples import sample_motion
from armproof.models.motion.straight_line import straight_line
from armproof.models.motion.time_optimal import TimeOptimalMotion
from armproof.models.motion.time_optimal import time_optimal as solve
from armproof.models.numeric.plant import NumericKinematics
from tests.models.motion.test_joint_space import configurations
from tests.models.motion.test_straight_line import target

INF = np.inf


def time_optimal(arm: Arm, path, grid_points: int = 50, **limits) -> TimeOptimalMotion:
    """Solve on a coarser grid than usual, in less time."""
    return solve(arm, path, grid_points=grid_points, **limits)


def use(motion: TimeOptimalMotion) -> np.ndarray:
    return np.stack([motion.velocity_use, motion.acceleration_use, motion.effort_use])


@pytest.mark.parametrize(("velocity", "acceleration"), [(1.0, 4.0), (10.0, 4.0), (0.3, 9.0)])
def test_on_a_straight_path_it_is_the_trapezoid_or_the_triangle(velocity: float, acceleration: float):
    q_0, q_f = np.array([0.1, 0.2]), np.array([1.3, 0.5])
    path = joint_path(load_arm("planar_2r"), [q_0, q_f])
    motion = time_optimal(load_arm("planar_2r"), path, velocity=velocity, acceleration=acceleration, effort=INF)
    move = 1.2  # of the joint that moves farthest
    trapezoid = velocity**2 < acceleration * move
    expected = move / velocity + velocity / acceleration if trapezoid else 2 * np.sqrt(move / acceleration)
    assert expected * (1 - 1e-9) <= motion.duration < 1.05 * expected
    assert motion.duration < shortest_duration(q_0, q_f, velocity, acceleration)


@pytest.mark.parametrize("name", arm_names())
def test_the_limits_of_the_model_file_hold_and_one_is_reached(name: str):
    arm = load_arm(name)
    points = configurations(arm, 3, margin=0.4)
    motion = time_optimal(arm, joint_path(arm, points))
    assert use(motion).max() <= 1 + 1e-9
    assert use(motion).max() > 0.97, "it could be faster"
    ends = sample_motion(motion.trajectory, [0.0, motion.duration])
    np.testing.assert_allclose(ends.q, points[[0, 2]], atol=1e-9)
    np.testing.assert_allclose(ends.v, 0, atol=1e-4)
    assert not np.isinf(motion.limits.velocity).any() and not np.isinf(motion.limits.effort).any()


def test_a_quintic_in_the_same_time_passes_the_limits():
    arm = load_arm("scara")
    q_0, q_f = configurations(arm, 2)
    fastest = time_optimal(arm, joint_path(arm, [q_0, q_f]), acceleration=20.0, effort=INF)
    motion = sample_motion(point_to_point(arm, q_0, q_f, fastest.duration), np.linspace(0, fastest.duration, 500))
    limits = read_rate_limits(arm, acceleration=20.0)
    assert max((np.abs(motion.v) / limits.velocity).max(), (np.abs(motion.w) / limits.acceleration).max()) > 1.2


def test_damping_and_gravity_count_in_the_effort():
    arm = load_arm("rx90")
    path = joint_path(arm, configurations(arm, 3, margin=0.35))
    motion = time_optimal(arm, path)
    free = time_optimal(arm, path, effort=10 * motion.limits.effort)
    assert use(motion).max() <= 1 + 1e-9 and free.duration < motion.duration


def test_half_the_limits_take_longer():
    arm = load_arm("planar_3r")
    path = joint_path(arm, configurations(arm, 3, margin=0.4))
    whole = time_optimal(arm, path, velocity=2.0, acceleration=8.0, effort=INF)
    half = time_optimal(arm, path, velocity=1.0, acceleration=2.0, effort=INF)
    assert half.duration == pytest.approx(2 * whole.duration, rel=0.01), "time scales by two"


def test_the_tool_stays_on_its_line():
    arm = load_arm("planar_2r")
    line = straight_line(arm, "2", [0.3, 1.2], target(0.2, 0.25), rows=(1, 2), samples=51)
    motion = time_optimal(arm, line.path)
    q = sample_motion(motion.trajectory, np.linspace(0, motion.duration, 101)).q
    p = NumericKinematics(arm, q).pose("2")[:, :2, 3]
    along = (p[-1] - p[0]) / np.linalg.norm(p[-1] - p[0])
    assert np.abs((p - p[0]) @ [-along[1], along[0]]).max() < 1e-5


def test_missing_limits_are_asked_for(arm: Arm):
    limits = read_rate_limits(arm)
    path = joint_path(arm, configurations(arm, 2, margin=0.45))
    if (np.isinf(limits.effort) & np.isinf(limits.acceleration)).any():
        with pytest.raises(ModelError, match=r"neither an acceleration nor an effort limit .*; give acceleration= or"):
            time_optimal(arm, path)
    motion = time_optimal(arm, path, velocity=1.0, acceleration=3.0, effort=INF)
    assert 0.97 < use(motion).max() <= 1 + 1e-9


def test_some_joints_may_be_limited_by_acceleration_and_others_by_effort():
    arm = load_arm("planar_2r")
    path = joint_path(arm, configurations(arm, 3, margin=0.4))
    motion = time_optimal(arm, path, velocity=[INF, 2.0], acceleration=[3.0, INF], effort=[INF, 18.0])
    assert 0.97 < use(motion).max() <= 1 + 1e-9


def test_an_arm_too_weak_to_hold_itself_has_no_motion():
    arm = load_arm("rx90")
    with pytest.raises(ModelError, match="no motion of arm 'rx90' along this path respects the limits"):
        time_optimal(arm, joint_path(arm, configurations(arm, 2)), effort=1.0)


@pytest.mark.parametrize(
    ("path", "options", "message"),
    [
        (quintic([0, 0], [1, 1], 1.0), {}, "the path stands still at s = 0"),
        (quintic([0, 0], [0, 0], 1.0), {}, "the path stands still"),
        (quintic([0], [1], 1.0), {}, r"values of the shape \(2, 1\), not \(1, 1\)"),
        (quintic([0, 0], [1, 9], 1.0, v_0=1, v_f=1), {}, "theta_2 of arm 'planar_2r' is .* its limits are"),
        ("path", {}, "not a str"),
        (PiecewisePolynomial(np.zeros((2, 1))), {}, r"a start and a later end, not \[-inf, inf\]"),
        (DiscreteTimeTrajectory([0, 1], np.zeros((2, 2))), {}, "no velocity or acceleration"),
        (None, {"velocity": 0}, "velocity: one positive limit"),
        (None, {"acceleration": [1, 2, 3]}, "acceleration: one positive limit, or one for each of the 2 joints"),
        (None, {"effort": np.nan}, "effort: one positive limit"),
        (None, {"effort": "strong"}, "effort: 'strong' is no vector of limits"),
        (None, {"effort": INF}, "theta_1 of arm 'planar_2r' has neither an acceleration nor an effort limit"),
        (None, {"grid_points": 2}, "grid_points: from 10 to 100000"),
    ],
)
def test_what_has_no_fastest_motion_is_refused(path, options, message):
    arm = load_arm("planar_2r")
    with pytest.raises(ModelError, match=message):
        time_optimal(arm, joint_path(arm, [[0, 0], [1, 1]]) if path is None else path, **options)
