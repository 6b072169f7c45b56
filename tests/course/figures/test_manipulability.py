"""The manipulability map: its colours are √det(J Jᵀ) of the double plant, its curves are where the Jacobian has lost rank."""

import time

import numpy as np
import pytest

from armproof.course.figures.drawing.labels import joint_scales
from armproof.course.figures.drawing.maps import levels_up_to, plain_condition, smooth
from armproof.course.figures.facts.joint_map import (
    SIDE,
    family_lines,
    highest_near,
    joint_map,
    relevant_joints,
    shown_families,
)
from armproof.course.figures.facts.task import task_of, volume_unit
from armproof.course.figures.kinds.manipulability import caption, manipulability_figure
from armproof.models.arm import Arm
from armproof.models.catalogue import load_arm
from armproof.models.numeric.plant import NumericKinematics
from tests.course.figures.test_sketch import drawn, figure_of


def volume(found, q: np.ndarray) -> np.ndarray:
    J = NumericKinematics(found.task.arm, q).jacobian(found.task.frame)[:, [row - 1 for row in found.task.rows]]
    return np.linalg.svd(J, compute_uv=False).prod(axis=1)


def test_the_map_is_that_of_the_double_plant(arm: Arm) -> None:
    found = joint_map(arm)
    figure = figure_of(manipulability_figure, arm)
    rng = np.random.default_rng(1)
    if len(found.joints) == 2:
        assert found.w.shape == (SIDE, SIDE)
        image = next(image for axes in figure.axes for image in axes.images if image.get_gid() == "w")
        assert np.array_equal(image.get_array(), found.w[::2, ::2])
        rows, columns = rng.integers(0, SIDE, (2, 300))
        q, w = found.configurations(found.axes[0][columns], found.axes[1][rows]), found.w[rows, columns]
    else:
        points = drawn(figure)["w"]
        q, w = found.configurations(points[:, 0] / joint_scales(arm)[found.joints[0]]), points[:, 1]
    assert np.abs(volume(found, q) - w).max() <= 1e-9 * max(1, w.max())
    if w.max() - w.min() > 1e-3:
        assert np.abs(volume(found, np.roll(q, 7, axis=0)) - w).max() > 1e-4  # the negative control


def test_the_curves_are_singular_and_nothing_beside_them(arm: Arm) -> None:
    found = joint_map(arm)
    lines = drawn(figure_of(manipulability_figure, arm))
    scales = joint_scales(arm)[list(found.joints)]
    for family in shown_families(found):
        points = lines.get(f"singular {family.latex}")
        if points is None:
            continue
        points = points[~np.isnan(points[:, 0])]
        q = (
            found.configurations(*(points.T / scales[:, None]))
            if len(found.joints) == 2
            else found.configurations(points[:, 0] / scales[0])
        )
        assert volume(found, q).max() <= 1e-8 * max(1, found.w.max())
        assert volume(found, q + 0.05).max() > 1e-4


def test_the_rx90_has_its_elbow_and_shoulder_curves_and_a_million_configurations_in_time() -> None:
    arm = load_arm("rx90")
    found = joint_map(arm)
    assert [arm.joints[k].symbol for k in found.joints] == ["theta_2", "theta_3"]
    curves = {family.latex for family in shown_families(found) if family_lines(found, family)}
    assert curves == {r"a_3 C_2 - d_3 S_{23} = 0", r"\theta_3 = -\frac{\pi}{2}"}
    manipulability_figure(arm)
    joint_map.cache_clear()
    start = time.process_time()
    manipulability_figure(arm)
    assert time.process_time() - start <= 2.0


def test_the_highest_value_is_found_between_the_configurations_of_the_map() -> None:
    for name, value in (("planar_2r", 0.45 * 0.35), ("spherical_wrist", 1.0)):
        found = joint_map(load_arm(name))
        lengths = list(found.task.arm.lengths.values())
        expected = value if name == "spherical_wrist" else lengths[0] * lengths[1]
        q, w = highest_near(found, (int(np.argmax(found.w)),))
        assert w == pytest.approx(expected, rel=1e-9)
        assert abs(q[found.joints[0]]) == pytest.approx(np.pi / 2, abs=1e-4)


def test_only_the_joints_that_matter_are_relevant() -> None:
    for name, symbols in (("rx90", {"theta_2", "theta_3", "theta_5"}), ("scara", {"theta_2"}), ("polar_rp", {"r"})):
        task = task_of(load_arm(name))
        assert {task.arm.joints[k].symbol for k in relevant_joints(task)} == symbols


def test_units_levels_and_conditions() -> None:
    assert volume_unit(load_arm("rx90"), range(1, 7), range(1, 7)) == "m³"
    assert volume_unit(load_arm("scara"), (1, 2, 3, 6), (1, 2, 3, 4)) == "m²"
    assert volume_unit(load_arm("polar_rp"), (1,), (1, 2)) == ""
    levels = levels_up_to(0.127)
    assert (np.diff(levels) > 0).all() and levels[0] > 0 and levels[-1] < 0.127
    assert plain_condition(r"\theta_3 = -\frac{\pi}{2} \text{ and } r = 0") == r"\theta_3 = -\pi/2 ,\; r = 0"
    assert np.array_equal(smooth(np.full((6, 6), 3.0)), np.full((6, 6), 3.0))
    assert "10^6" in caption(load_arm("rx90")) and "1000" in caption(load_arm("scara"))
