"""Singular configurations: each pose has lost rank, exactly and on the double plant; what is lost is lost there only."""

import numpy as np
import pytest

from armproof.course.figures.facts.families import singularities_of
from armproof.course.figures.facts.lost import velocity_and_rotation
from armproof.course.figures.facts.poses import showing_pose
from armproof.course.figures.kinds.singular import _projection, caption, rates_at, reason, singular, singular_poses
from armproof.course.figures.registry import draw_kind, find_kind
from armproof.models.arm import Arm
from armproof.models.catalogue import load_arm
from armproof.models.numeric.plant import NumericKinematics
from tests.course.figures.test_sketch import TOLERANCE, drawn

ALWAYS_REGULAR = {"dh": "classic", "rows": [
    {"a": 0, "alpha": "pi/2", "d": "d_1", "theta": 0},
    {"a": 0, "alpha": "-pi/2", "d": "d_2", "theta": 0},
]}  # fmt: skip


@pytest.fixture
def singular_arm(arm: Arm) -> Arm:
    if reason(arm, "en") is not None:
        pytest.skip(str(reason(arm, "en")))
    return arm


def jacobian(arm: Arm, q: np.ndarray) -> np.ndarray:
    analysis = singularities_of(arm)
    return np.asarray(NumericKinematics(arm, q[None]).jacobian(analysis.frame)[0][[row - 1 for row in analysis.rows]])


def rank(J: np.ndarray) -> int:
    sizes = np.linalg.svd(J, compute_uv=False)
    return int(np.sum(sizes > 1e-7 * sizes[0]))


def test_each_pose_has_lost_rank(singular_arm: Arm) -> None:
    analysis = singularities_of(singular_arm)
    assert (
        rank(jacobian(singular_arm, showing_pose(singular_arm))) == analysis.generic_rank
    )  # else the test could not fail
    poses = singular_poses(singular_arm)
    assert len(poses) == sum(family.exists for family in analysis.families)
    for pose in poses:
        assert pose.family.contains(pose.q[None]).all()
        assert pose.family.rank < analysis.generic_rank  # exactly
        assert rank(jacobian(singular_arm, pose.q)) == pose.family.rank


def test_what_is_lost_cannot_be_done_there_and_can_elsewhere(singular_arm: Arm) -> None:
    for pose in singular_poses(singular_arm):
        lost = pose.lost
        assert np.linalg.norm(lost.direction) == pytest.approx(1)
        assert np.abs(lost.direction @ rates_at(singular_arm, lost, pose.q)).max() < 1e-7
        near = 0.9 * pose.q + 0.1 * showing_pose(singular_arm)
        assert np.abs(lost.direction @ rates_at(singular_arm, lost, near)).max() > 1e-4


def test_a_point_of_the_last_link_moves_as_finite_differences_have_it() -> None:
    arm, q, step = load_arm("rx90"), np.array([0.3, 0.5, -0.7, 0.2, 0.9, -0.4]), 1e-6
    point = np.array([0.3, -0.2, 0.5])
    J_v, _ = velocity_and_rotation(arm, "6", point, q)
    in_link = np.linalg.inv(NumericKinematics(arm, q[None]).pose("6")[0]) @ [*point, 1.0]
    for k in range(6):
        moved = (NumericKinematics(arm, (q + step * np.eye(6)[k])[None]).pose("6")[0] @ in_link)[:3]
        assert (moved - point) / step == pytest.approx(J_v[:, k], abs=1e-5)


def test_the_arrows_and_ellipsoids_are_drawn_where_the_plant_has_the_point(singular_arm: Arm) -> None:
    arm = singular_arm
    figure, poses = singular(arm), singular_poses(arm)
    projection = _projection(arm, poses)
    for axes, pose in zip(figure.axes[1:], poses, strict=True):
        lines = {line.get_gid(): np.column_stack(line.get_data()) for line in axes.lines if line.get_gid()}
        lost = pose.lost
        if lost.frame is not None:
            point = projection.points(NumericKinematics(arm, pose.q[None]).pose(lost.frame)[0, :3, 3])
            assert np.abs(lines["lost"][0] - point).max() <= TOLERANCE
            outline = lines[f"ellipsoid {lost.kind}"]
            assert np.abs((outline.max(axis=0) + outline.min(axis=0)) / 2 - point).max() <= 1e-9
        way = projection.points(lost.direction)
        drawn_way = lines["lost"][1] - lines["lost"][0]
        assert abs(drawn_way[0] * way[1] - drawn_way[1] * way[0]) <= TOLERANCE
        for joint, placed in zip(arm.joints, lines, strict=False):
            assert f"joint {joint.symbol}" in lines, placed


def test_planar_ellipses_collapse_to_a_line_across_what_is_lost() -> None:
    arm = load_arm("planar_2r")
    figure = singular(arm)
    generic, *collapsed = [
        next(np.column_stack(line.get_data()) for line in axes.lines if line.get_gid() == "ellipsoid velocity")
        for axes in figure.axes
    ]
    for outline, pose in zip(collapsed, singular_poses(arm), strict=True):
        middle = outline - (outline.max(axis=0) + outline.min(axis=0)) / 2
        assert np.abs(middle @ pose.lost.direction[:2]).max() <= TOLERANCE
    assert np.linalg.svd(generic - generic.mean(axis=0), compute_uv=False)[1] > 0.01


@pytest.mark.parametrize("name", ["scara", "scara_column", "scara_modified"])
def test_scara_is_shown_stretched_and_folded(name: str) -> None:
    angles = sorted(pose.q[1] for pose in singular_poses(load_arm(name)))
    assert angles == pytest.approx([0, np.pi])
    assert r"\theta_2 = 0" in caption(load_arm(name))
    assert r"\theta_2 = \pi" in caption(load_arm(name), "fr")


def test_the_wrist_of_the_rx90_loses_a_rotation_across_its_axes() -> None:
    arm = load_arm("rx90")
    pose = next(pose for pose in singular_poses(arm) if pose.family.latex == r"\theta_5 = 0")
    assert (pose.lost.kind, pose.family.rank) == ("rotation", 5)
    X = NumericKinematics(arm, pose.q[None])
    for frame in ("4", "5", "6"):
        assert abs(pose.lost.direction @ X.pose(frame)[0, :3, 2]) < 1e-9


def test_an_arm_without_singular_configurations_says_so() -> None:
    arm = load_arm(ALWAYS_REGULAR)
    assert singularities_of(arm).always_regular
    texts = " ".join(text.get_text() for text in draw_kind(find_kind("singular"), arm, "en").texts).replace("\n", " ")
    assert "there is nothing singular" in texts
    texts = " ".join(text.get_text() for text in draw_kind(find_kind("singular"), arm, "fr").texts)
    assert "rien de singulier" in texts


def test_sketch_lines_can_be_read_back() -> None:
    assert "lost" in drawn(singular(load_arm("planar_2r")))
