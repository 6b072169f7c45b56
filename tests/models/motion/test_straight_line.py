"""Straight-line motion of the tool, on every arm; and what cannot be a straight line says where it ends."""

import numpy as np
import pytest
from pydrake.common.eigen_geometry import AngleAxis
from pydrake.math import RigidTransform, RotationMatrix

from armproof.models.arm import Arm
from armproof.models.catalogue import load_arm
from armproof.models.errors import ModelError
from armproof.models.motion.differential_solver import differential_solver
from armproof.models.motion.joint_space import follow_path
from armproof.models.motion.pose_error import pose_error
from armproof.models.motion.samples import sample_motion
from armproof.models.motion.straight_line import pose_line, straight_line
from armproof.models.numeric.plant import NumericKinematics
from tests.models.motion.test_joint_space import configurations


def independent_rows(J: np.ndarray) -> tuple[int, ...]:
    """Return as many rows of a Jacobian, from 1, as it has rank, each with a part of its own."""
    rows: list[int] = []
    for row in range(6):
        more = [*rows, row]
        if len(more) <= J.shape[1] and np.linalg.svd(J[more], compute_uv=False)[-1] > 0.05:
            rows.append(row)
    return tuple(row + 1 for row in rows)


def pose(arm: Arm, frame: str, q) -> np.ndarray:
    return NumericKinematics(arm, np.array([q], dtype=float)).pose(frame)[0]


def elbow_solver(sign: float):
    """Return the closed form of the planar 2R, with the elbow on one side."""
    l_1, l_2 = load_arm("planar_2r").lengths.values()

    def solve(X: np.ndarray, q_near: np.ndarray) -> np.ndarray:
        x, y = X[:2, 3]
        cosine = (x**2 + y**2 - l_1**2 - l_2**2) / (2 * l_1 * l_2)
        if abs(cosine) > 1:
            return np.full(2, np.nan)
        theta_2 = sign * np.arccos(cosine)
        return np.array([np.arctan2(y, x) - np.arctan2(l_2 * np.sin(theta_2), l_1 + l_2 * np.cos(theta_2)), theta_2])

    return solve


def target(x: float, y: float) -> np.ndarray:
    X = np.eye(4)
    X[:2, 3] = x, y
    return X


@pytest.mark.parametrize("angle", [0.0, 1e-9, 1e-3, 1.0, 3.1, np.pi - 1e-9, np.pi])
def test_pose_error_is_the_step_and_the_turn(angle: float):
    rng = np.random.default_rng(0)
    for _ in range(20):
        axis = rng.normal(size=3)
        axis /= np.linalg.norm(axis)
        base = np.array(RigidTransform(RotationMatrix(AngleAxis(0.7, axis[::-1])), rng.normal(size=3)).GetAsMatrix4())
        moved = base.copy()
        moved[:3, :3] = RotationMatrix(AngleAxis(angle, axis)).matrix() @ base[:3, :3]
        moved[:3, 3] += [0.1, -0.2, 0.3]
        error = pose_error(moved, base)
        np.testing.assert_allclose(error[:3], [0.1, -0.2, 0.3], atol=1e-14)
        turns = [np.abs(error[3:] - sign * angle * axis).max() for sign in ((1, -1) if angle > 3.14 else (1,))]
        assert min(turns) < 1e-14
        np.testing.assert_array_equal(pose_error(np.stack([base, moved]), np.stack([base, base]))[1], error)


def test_pose_error_is_j_dq_to_first_order(arm: Arm):
    q = configurations(arm, 2)[0]
    dq, frame = 1e-6 * np.linspace(0.5, 1.0, len(q)), arm.frames[-1]
    J = NumericKinematics(arm, q[np.newaxis]).jacobian(frame)[0]
    np.testing.assert_allclose(pose_error(pose(arm, frame, q + dq), pose(arm, frame, q)), J @ dq, atol=1e-11)


def test_the_tool_moves_on_the_line_and_turns_evenly(arm: Arm):
    q_0 = configurations(arm, 3)[0]
    frame = arm.frames[-1]
    rows = independent_rows(NumericKinematics(arm, q_0[np.newaxis]).jacobian(frame)[0])
    X_0, X_f = pose(arm, frame, q_0), pose(arm, frame, q_0 + 0.03)
    line = straight_line(arm, frame, q_0, X_f, rows=rows, samples=21)
    assert line.position_error < 1e-6 and line.rotation_error < 1e-6 and line.least_singular_value > 0
    chosen, s = [row - 1 for row in rows], np.linspace(0, 1, 11)
    q = sample_motion(line.path, s).q
    np.testing.assert_allclose(q[0], q_0, atol=1e-12)
    X = NumericKinematics(arm, q).pose(frame)
    p = X_0[:3, 3] + s[:, np.newaxis] * (X_f[:3, 3] - X_0[:3, 3])
    turn = pose_error(X_f, X_0)[3:]
    for k, part in enumerate(s):
        wanted = np.eye(4)
        angle = np.linalg.norm(turn)
        R = RotationMatrix(AngleAxis(part * angle, turn / angle)).matrix() if angle > 1e-9 else np.eye(3)
        wanted[:3, :3], wanted[:3, 3] = R @ X_0[:3, :3], p[k]
        np.testing.assert_allclose(pose_error(wanted, X[k])[chosen], 0, atol=2e-6)


def test_the_rates_of_the_joints_give_the_tool_a_constant_twist():
    arm = load_arm("rx90")
    q_0 = np.array([0.2, 0.5, -0.6, 0.4, 0.8, 0.3])
    X_f = pose(arm, "6", q_0 + 0.2)
    line = straight_line(arm, "6", q_0, X_f, samples=41)
    motion = sample_motion(line.path, np.linspace(0, 1, 9))
    twists = np.einsum("kij,kj->ki", NumericKinematics(arm, motion.q).jacobian("6"), motion.v)
    np.testing.assert_allclose(twists, np.tile(pose_error(X_f, pose(arm, "6", q_0)), (9, 1)), atol=1e-4)


def test_more_samples_are_nearer_to_the_line():
    arm = load_arm("planar_2r")
    errors = [
        straight_line(arm, "2", [0.2, 1.9], target(0.5, -0.1), rows=(1, 2), samples=samples).position_error
        for samples in (9, 17, 33)
    ]
    assert errors[0] > 8 * errors[1] > 64 * errors[2] > 0, "a cubic spline is of fourth order"


@pytest.mark.parametrize("sign", [1, -1])
def test_a_closed_form_may_solve_it(sign: float):
    arm = load_arm("planar_2r")
    q_0 = np.array([0.3, sign * 1.2])
    by_steps = straight_line(arm, "2", q_0, target(0.2, 0.25), rows=(1, 2), samples=41)
    closed = straight_line(arm, "2", q_0, target(0.2, 0.25), rows=(1, 2), samples=41, solver=elbow_solver(sign))
    s = np.linspace(0, 1, 50)
    np.testing.assert_allclose(sample_motion(closed.path, s).q, sample_motion(by_steps.path, s).q, atol=1e-9)


def test_a_whole_turn_of_the_solver_does_not_matter():
    solve = elbow_solver(1)
    turning = straight_line(
        load_arm("planar_2r"),
        "2",
        [0.3, 1.2],
        target(0.2, 0.25),
        rows=(1, 2),
        solver=lambda X, near: solve(X, near) + 2 * np.pi * np.round(100 * X[0, 3]),
    )
    assert turning.position_error < 1e-4


def test_a_followed_line_is_one_in_time():
    arm = load_arm("planar_2r")
    line = straight_line(arm, "2", [0.3, 1.2], target(0.2, 0.25), rows=(1, 2), samples=51)
    motion = sample_motion(follow_path(line.path, 2.0), np.linspace(0, 2, 101))
    p = NumericKinematics(arm, motion.q).pose("2")[:, :2, 3]
    along = p[-1] - p[0]
    offset = np.cross(np.append(along, 0) / np.linalg.norm(along), np.pad(p - p[0], ((0, 0), (0, 1))))
    assert np.abs(offset).max() < 1e-5
    straight = p[0] + np.linspace(0, 1, 101)[:, np.newaxis] * along
    assert np.abs(p - straight).max() > 0.01, "the time law is a quintic, not uniform"


def test_unreachable_poses_say_where():
    arm = load_arm("planar_2r")
    for solver in (None, elbow_solver(1)):
        with pytest.raises(ModelError, match=r"no joint values at s = 0\.\d+, p = \(.*\) m on the straight line"):
            straight_line(arm, "2", [0.3, 1.2], target(1.5, 0.0), rows=(1, 2), solver=solver)


def test_a_line_through_the_hole_of_the_workspace_is_refused():
    arm = load_arm("planar_2r")
    q_0 = np.array([0.3, 2.4])
    x, y = pose(arm, "2", q_0)[:2, 3]
    with pytest.raises(ModelError, match=r"no joint values at s = 0\.\d.*least singular value"):
        straight_line(arm, "2", q_0, target(-x, -y), rows=(1, 2))


def test_a_line_that_needs_a_jump_is_refused_with_the_place():
    arm = load_arm("planar_2r")

    def flips(X: np.ndarray, near: np.ndarray) -> np.ndarray:
        return elbow_solver(1 if X[0, 3] > 0.3 else -1)(X, near)

    with pytest.raises(ModelError, match=r"leaves the straight line by .* at s = 0\.\d+.*the solver changes branch"):
        straight_line(arm, "2", [-0.4, 1.2], target(0.1, 0.3), rows=(1, 2), solver=flips)


def test_a_line_past_a_wrist_singularity_is_refused_or_reported():
    arm = load_arm("rx90")
    X_f = pose(arm, "6", [0.0, 0.5, -0.6, 0.0, 0.5, 0.0])
    q_0 = np.array([0.02, 0.45, -0.55, 0.0, -0.5, 0.1])
    try:
        line = straight_line(arm, "6", q_0, X_f, samples=21)
    except ModelError as error:
        assert "s = " in str(error) and "least singular value" in str(error)
    else:
        assert line.least_singular_value < 0.05


def test_joint_limits_on_the_line_say_where():
    arm = load_arm("planar_2r")
    X_f = pose(arm, "2", [0.3, 2.9])
    with pytest.raises(ModelError, match=r"theta_2 is outside its limits .* on the straight line, first at s = 0\.\d"):
        straight_line(arm, "2", [0.3, 2.3], X_f, rows=(1, 2), samples=41)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"q_0": [0.3]}, r"a configuration of arm 'planar_2r' has the shape \(2,\)"),
        ({"X_f": np.eye(3)}, r"X_f: a pose is a \(4, 4\) array of finite numbers; the shape is \(3, 3\)"),
        ({"X_f": np.diag([1, 1, -1, 1])}, "X_f: a pose has a rotation above left"),
        ({"X_f": np.full((4, 4), np.nan)}, "finite numbers"),
        ({"X_f": "there"}, "no array of numbers"),
        ({"frame": "9"}, "no frame '9'"),
        ({"rows": (0, 1)}, "the rows of a task are some of 1 … 6"),
        ({"rows": (1, 1)}, "each once"),
        ({"rows": (1.5, 2)}, "the rows of a task"),
        ({"rows": ()}, "the rows of a task"),
        ({"rows": 1}, "the rows of a task"),
        ({"samples": 3}, "samples: from 4 to 100000"),
        ({"solver": lambda X, near: np.zeros(3)}, r"joint values of the shape \(3,\), not \(2,\)"),
        ({"X_f": pose(load_arm("planar_2r"), "2", [0.3, 1.2])}, "ends where it starts"),
    ],
)
def test_what_is_no_straight_line_is_refused(change, message):
    arguments = {"frame": "2", "q_0": [0.3, 1.2], "X_f": target(0.2, 0.25), "rows": (1, 2), **change}
    with pytest.raises(ModelError, match=message):
        straight_line(load_arm("planar_2r"), **arguments)


def test_the_solver_finds_the_pose_from_a_distance_and_names_what_it_cannot():
    arm = load_arm("rx90")
    q = np.array([0.2, 0.5, -0.6, 0.4, 0.8, 0.3])
    solve = differential_solver(arm, "6")
    found = solve(pose(arm, "6", q), q + 0.3)
    np.testing.assert_allclose(pose(arm, "6", found), pose(arm, "6", q), atol=1e-9)
    far = pose(arm, "6", q).copy()
    far[:3, 3] *= 5
    with pytest.raises(ModelError, match=r"60 steps end .* from the pose"):
        solve(far, q)


def test_the_pose_line_ends_at_its_ends():
    X_0, X_f = pose(load_arm("rx90"), "6", np.full(6, 0.2)), pose(load_arm("rx90"), "6", np.full(6, 0.7))
    poses = pose_line(X_0, X_f)
    for s, X in ((0.0, X_0), (1.0, X_f)):
        np.testing.assert_allclose(poses.GetPose(s).GetAsMatrix4(), X, atol=1e-12)
