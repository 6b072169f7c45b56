"""Motion in joint space, on every arm: it is where it should be when it should be, at rest at its ends, within its limits."""

import numpy as np
import pytest

from armproof.models.arm import Arm
from armproof.models.catalogue import load_arm
from armproof.models.errors import ModelError
from armproof.models.motion.joint_space import follow_path, joint_path, point_to_point
from armproof.models.motion.limits import extremes, read_rate_limits
from armproof.models.motion.samples import sample_motion


def configurations(arm: Arm, count: int, margin: float = 0.3) -> np.ndarray:
    """Return configurations within the middle part of the joint limits."""
    ends = [(max(joint.lower, -3.0), min(joint.upper, 3.0)) for joint in arm.joints]
    lower, upper = np.array(ends).T
    part = np.random.default_rng(count).uniform(margin, 1 - margin, (count, len(ends)))
    return lower + part * (upper - lower)


def test_point_to_point_is_at_rest_at_both_ends(arm: Arm):
    q_0, q_f = configurations(arm, 2)
    ends = sample_motion(point_to_point(arm, q_0, q_f, 1.5), [0.0, 1.5])
    np.testing.assert_allclose(ends.q, [q_0, q_f], atol=1e-13)
    np.testing.assert_allclose(np.stack([ends.v, ends.w]), 0, atol=1e-11)


def test_the_shortest_motion_reaches_a_velocity_limit_of_the_model_file():
    for name in ("scara", "rx90", "polar_rp"):
        arm = load_arm(name)
        q_0, q_f = configurations(arm, 2)
        trajectory = point_to_point(arm, q_0, q_f)
        use = np.abs(extremes(trajectory, 1)).max(axis=0) / read_rate_limits(arm).velocity
        assert use.max() == pytest.approx(1, rel=1e-9)
        slower = point_to_point(arm, q_0, q_f, acceleration=2.0)
        assert np.abs(extremes(slower, 2)).max() == pytest.approx(2.0) and slower.end_time() > trajectory.end_time()


def test_a_path_goes_through_its_points_and_takes_any_time_law(arm: Arm):
    for count in (2, 3, 5):
        points = configurations(arm, count, margin=0.45)
        path = joint_path(arm, points)
        s = np.linspace(0, 1, 401)
        q = sample_motion(path, s).q
        assert all(np.linalg.norm(q - point, axis=1).min() < 2e-2 for point in points)
        np.testing.assert_allclose(q[[0, -1]], points[[0, -1]], atol=1e-12)
        motion = sample_motion(follow_path(path, 2.0), [0.0, 1.0, 2.0])
        np.testing.assert_allclose(motion.q, q[[0, 200, 400]], atol=1e-12)
        np.testing.assert_allclose(motion.v[[0, 2]], 0, atol=1e-12)
        np.testing.assert_allclose(motion.v[1], 15 / 8 / 2 * sample_motion(path, [0.5]).v[0], atol=1e-12)


def test_joint_limits_hold_at_the_ends_and_between_the_points():
    arm = load_arm("planar_2r")
    with pytest.raises(
        ModelError, match=r"theta_2 of arm 'planar_2r' goes to 2.9 rad .*limits are \[-2.7925, 2.7925\]"
    ):
        point_to_point(arm, [0, 0], [0, 2.9], 1)
    points = [[0, 0], [0, 2.75], [1, 2.79], [0, 0]]
    assert np.array(points).max() < arm.joints[1].upper
    with pytest.raises(ModelError, match="theta_2 of arm 'planar_2r' goes to"):
        joint_path(arm, points)
    joint_path(arm, points[:2])
    lower, upper = np.array([[joint.lower, joint.upper] for joint in arm.joints]).T
    point_to_point(arm, lower, upper)  # the limits themselves are within


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (
            lambda arm: point_to_point(arm, [0, 0, 0], [1, 1], 1),
            r"a configuration of arm 'planar_2r' has the shape \(2,\)",
        ),
        (lambda arm: point_to_point(arm, [0, 0], [1, np.nan], 1), "joint values are finite"),
        (lambda arm: point_to_point(arm, [0, 0], [1, 1], -1), "positive time"),
        (lambda arm: point_to_point(arm, [0, 1], [0, 1]), "the same configuration; to stay there, give a duration"),
        (lambda arm: point_to_point(arm, [0, 0], [1, 1], acceleration=-1), "acceleration: one positive limit"),
        (lambda arm: joint_path(arm, [[0, 0]]), "at least 2 configurations; 1 given"),
        (lambda arm: joint_path(arm, [[0, 0], [0, 0]]), "points 1 and 2 of the path are the same"),
        (lambda arm: joint_path(arm, [[0, 0], [1, 0], [1, 0]]), "points 2 and 3 of the path are the same"),
        (lambda arm: joint_path(arm, [0, 0]), r"shape \(N, 2\), not \(2,\)"),
        (lambda arm: follow_path(joint_path(arm, [[0, 0], [1, 1]]), 0), "positive time"),
        (lambda arm: follow_path(None, 1), "not a NoneType"),
    ],
)
def test_what_is_no_motion_is_refused(make, message):
    with pytest.raises(ModelError, match=message):
        make(load_arm("planar_2r"))


def test_an_arm_without_limits_needs_a_duration(arm: Arm):
    limits = read_rate_limits(arm)
    if np.isinf(limits.velocity).any():
        q_0, q_f = configurations(arm, 2)
        with pytest.raises(ModelError, match="neither a velocity nor an acceleration limit"):
            point_to_point(arm, q_0, q_f)
        assert point_to_point(arm, q_0, q_f, acceleration=3.0).end_time() > 0
