"""Tracking: what is drawn is the simulation's log, its error that of the tool on the double plant, worse with wrong masses."""

import numpy as np
import pytest

from armproof.course.figures.facts.motions import motion_of
from armproof.course.figures.facts.task import task_of
from armproof.course.figures.kinds.tracking import PERIOD, caption, tool_error, tracked, tracking_figure
from armproof.course.figures.registry import draw_kind, find_kind
from armproof.models.catalogue import load_arm
from armproof.models.motion.pose_error import pose_error
from armproof.models.numeric.plant import NumericKinematics
from tests.course.figures.test_sketch import drawn, figure_of

ARMS = ("planar_2r", "polar_rp", "scara", "rx90", "spherical_wrist")


@pytest.mark.parametrize("name", ARMS)
def test_the_error_drawn_is_that_of_the_tool_on_the_plant(name: str) -> None:
    arm = load_arm(name)
    found, lines = tracked(arm), drawn(figure_of(tracking_figure, arm))
    frame, part = task_of(arm).frame, slice(3, 6) if task_of(arm).turns_only else slice(0, 3)
    scale = 180 / np.pi if task_of(arm).turns_only else 1000
    for key, log in (("right", found.right), ("wrong", found.wrong)):
        desired = np.array([motion_of(arm).trajectory.value(time)[:, 0] for time in log.times])
        error = pose_error(NumericKinematics(arm, desired).pose(frame), NumericKinematics(arm, log.q).pose(frame))[
            :, part
        ]
        assert np.abs(lines[f"tool {key}"][:, 1] / scale - np.linalg.norm(error, axis=1)).max() <= 1e-9
    assert not np.allclose(lines["tool right"], lines["tool wrong"])  # the negative control


@pytest.mark.parametrize("name", ARMS)
def test_wrong_masses_are_worse_and_joint_errors_are_drawn(name: str) -> None:
    arm = load_arm(name)
    found, lines = tracked(arm), drawn(figure_of(tracking_figure, arm))
    assert tool_error(arm, found.wrong).max() > 20 * tool_error(arm, found.right).max()
    for k, joint in enumerate(arm.joints):
        desired = np.array([motion_of(arm).trajectory.value(time)[k, 0] for time in found.wrong.times])
        assert lines[f"error {joint.symbol}"][:, 1] == pytest.approx(1000 * (desired - found.wrong.q[:, k]), abs=1e-9)
        assert len(lines[f"effort {joint.symbol}"]) == round(motion_of(arm).duration / PERIOD) + 1


def test_an_arm_without_masses_says_so(tmp_path) -> None:
    path = tmp_path / "light.urdf"
    path.write_text(
        '<robot name="r"><link name="a"/><link name="b"/><joint name="j" type="revolute"><parent link="a"/><child link="b"/>'
        '<origin xyz="0 0 1"/><axis xyz="0 0 1"/><limit lower="-1" upper="1" effort="1" velocity="1"/></joint></robot>'
    )
    kind, arm = find_kind("tracking"), load_arm(path)
    assert kind.applies(arm, "en") == "The links have no mass: the arm cannot be simulated."
    assert "masse" in str(kind.applies(arm, "fr"))
    assert draw_kind(kind, arm).texts


def test_the_caption_names_the_errors() -> None:
    assert "80%" in caption(load_arm("planar_2r")) and "mm" in caption(load_arm("planar_2r"))
    assert "80\N{NO-BREAK SPACE}%" in caption(load_arm("planar_2r"), "fr")
