"""The tool's path: drawn where the double plant has the tool, straight where it is called straight, the arm on its way."""

import numpy as np
import pytest

from armproof.course.figures.facts.motions import make_motion, motion_of
from armproof.course.figures.facts.task import task_of, tool_points
from armproof.course.figures.kinds.path import caption, path_figure, path_length, tool_motions
from armproof.models.arm import Arm
from armproof.models.catalogue import load_arm
from armproof.models.motion.limits import read_rate_limits
from armproof.models.motion.samples import sample_motion
from armproof.models.showing.projection import choose_projection
from tests.course.figures.test_sketch import TOLERANCE, drawn, figure_of


def test_paths_and_snapshots_are_where_the_plant_has_them(arm: Arm) -> None:
    lines, projection = drawn(figure_of(path_figure, arm)), choose_projection(arm)
    for name, trajectory in tool_motions(motion_of(arm)).items():
        q = sample_motion(trajectory, np.linspace(0, trajectory.end_time(), 121)).q
        points = projection.points(tool_points(arm, q))
        assert np.abs(lines[f"path {name}"] - points).max() <= TOLERANCE
        assert np.abs(lines[f"path {name}"][::-1] - points).max() > 100 * TOLERANCE  # the negative control
        ends = [lines[f"{name} {k} link {len(arm.joints)}"][-1] for k in range(4)]
        assert np.abs(np.array(ends) - points[[0, 30, 60, 90]]).max() <= TOLERANCE


def test_the_straight_line_is_straight_and_joins_the_ends_of_the_other(arm: Arm) -> None:
    motion = motion_of(arm)
    if motion.line is None:
        pytest.skip("the arm follows no straight line")
    q = sample_motion(tool_motions(motion)["line"], np.linspace(0, motion.duration, 200)).q
    assert q[[0, -1]] == pytest.approx(np.array([motion.q_0, motion.q_f]), abs=1e-6)
    if task_of(arm).turns_only:
        return
    points = tool_points(arm, q)
    way = (points[-1] - points[0]) / np.linalg.norm(points[-1] - points[0])
    off = points - points[0] - np.outer((points - points[0]) @ way, way)
    rows = [row - 1 for row in task_of(arm).rows if row <= 3]
    assert np.abs(off[:, rows]).max() <= motion.line.position_error + 2e-3
    curved = tool_points(arm, sample_motion(motion.trajectory, np.linspace(0, motion.duration, 200)).q)
    assert path_length(arm, motion.trajectory) >= path_length(arm, tool_motions(motion)["line"]) - 2e-3
    assert np.isfinite(curved).all()


def test_rates_are_parts_of_the_limits() -> None:
    arm = load_arm("rx90")
    motion, limits = motion_of(arm), read_rate_limits(arm).velocity
    lines = drawn(figure_of(path_figure, arm))
    samples = sample_motion(motion.trajectory, np.linspace(0, motion.duration, 121))
    for k, joint in enumerate(arm.joints):
        assert lines[f"rate joint {joint.symbol}"][:, 1] == pytest.approx(100 * samples.v[:, k] / limits[k], abs=1e-9)


def test_motions_stay_within_the_joint_limits(arm: Arm) -> None:
    for trajectory in tool_motions(motion_of(arm)).values():
        q = sample_motion(trajectory, np.linspace(0, trajectory.end_time(), 100)).q
        for k, joint in enumerate(arm.joints):
            assert joint.lower - 1e-6 <= q[:, k].min() and q[:, k].max() <= joint.upper + 1e-6


def test_a_motion_without_a_straight_line_is_drawn_alone() -> None:
    arm = load_arm("planar_2r")
    motion = make_motion(arm, np.array([0.0, -1.0]), np.array([0.5, 1.0]))
    figure = path_figure(arm, motion=motion)
    assert "path line" not in drawn(figure)
    assert "cannot follow" in caption(arm, motion=motion)
    assert "ne peut pas" in caption(arm, "fr", motion)
