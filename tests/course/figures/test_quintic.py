"""The quintic's figure: its curves are the trajectory, its marks the extremes of the curves, its limits respected."""

import numpy as np
import pytest

from armproof.course.figures.drawing.labels import joint_scales
from armproof.course.figures.facts.motions import make_motion, motion_of, round_duration
from armproof.course.figures.kinds.quintic import caption, peak_times, peak_values, quintic_figure
from armproof.models.arm import Arm
from armproof.models.catalogue import load_arm
from armproof.models.errors import ModelError
from armproof.models.motion.limits import extremes, read_rate_limits
from tests.course.figures.test_sketch import drawn, figure_of


def test_the_curves_are_the_trajectory_and_the_marks_its_extremes(arm: Arm) -> None:
    motion = motion_of(arm)
    lines, scales = drawn(figure_of(quintic_figure, arm)), joint_scales(arm)
    for order, name in enumerate("qvw"):
        derivative = motion.trajectory.derivative(order) if order else motion.trajectory
        lowest, highest = extremes(motion.trajectory, order)
        for k, joint in enumerate(arm.joints):
            points = lines[f"{name} {joint.symbol}"]
            values = np.array([derivative.value(time)[k, 0] for time in points[:, 0]])
            assert np.abs(points[:, 1] / scales[k] - values).max() <= 1e-9 * max(1, np.abs(values).max())
            if order:
                marks = lines[f"peak {name} {joint.symbol}"]
                assert np.abs(marks[:, 1] / scales[k]).max() == pytest.approx(
                    max(-lowest[k], highest[k]), rel=1e-9, abs=1e-12
                )


def test_a_wrong_peak_would_be_seen() -> None:
    """The negative control: a cubic's peaks 3/2 Δq/t_f and 6 Δq/t_f² are not the extremes of the quintic."""
    motion = motion_of(load_arm("planar_2r"))
    move = np.abs(motion.q_f - motion.q_0)
    _, highest = extremes(motion.trajectory, 1)
    assert not np.allclose(
        1.5 * move / motion.duration, np.maximum(highest, 0) + np.maximum(-extremes(motion.trajectory, 1)[0], 0)
    )
    assert not np.allclose(np.abs(peak_values(motion)[1]), 6 * move / motion.duration**2)


def test_peaks_are_where_the_handout_has_them() -> None:
    first, half, second = peak_times(2.0)
    assert (first, half, second) == pytest.approx((1 - 1 / 3**0.5, 1.0, 1 + 1 / 3**0.5))


def test_no_joint_passes_its_highest_speed(arm: Arm) -> None:
    assert (np.abs(peak_values(motion_of(arm))[0]) <= read_rate_limits(arm).velocity).all()


def test_a_motion_of_ones_own_is_drawn() -> None:
    arm = load_arm("planar_2r")
    motion = make_motion(arm, np.array([0.0, 0.5]), np.array([1.0, 0.5]))
    lines = drawn(quintic_figure(arm, motion=motion))
    assert lines["q theta_1"][-1] == pytest.approx([motion.duration, 180 / np.pi])
    assert "θ" not in caption(arm, motion=motion)
    with pytest.raises(ModelError, match=r"limits are"):
        make_motion(arm, np.array([0.0, 0.5]), np.array([9.0, 0.5]))


def test_durations_are_round_and_a_free_joint_takes_two_seconds() -> None:
    arm = load_arm("planar_2r")
    duration = round_duration(arm, np.zeros(2), np.array([1.0, 1.0]))
    assert 10 * duration == pytest.approx(round(10 * duration))
    free = load_arm({"dh": "classic", "rows": [{"a": "l_1", "alpha": 0, "d": 0, "theta": "theta_1"}]})
    assert round_duration(free, np.zeros(1), np.ones(1)) == 2.0


def test_the_caption_has_the_numbers_in_the_language_asked_for() -> None:
    english, french = caption(load_arm("planar_2r")), caption(load_arm("planar_2r"), "fr")
    assert "°/s" in english and "Peak speeds" in english
    assert "Vitesses maximales" in french and "," in french
