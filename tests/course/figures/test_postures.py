"""Postures: each reaches the target on the double plant, all are different, and they are drawn where it has them."""

import numpy as np
import pytest

from armproof.course.figures.facts.solutions import is_square, postures_of
from armproof.course.figures.facts.task import task_of
from armproof.course.figures.kinds.postures import _fit, caption, postures, reason
from armproof.models.arm import Arm
from armproof.models.catalogue import load_arm
from armproof.models.numeric.plant import NumericKinematics
from armproof.models.showing.skeleton import place_skeleton
from tests.course.figures.test_sketch import TOLERANCE, drawn

COUNT = {"planar_2r": 2, "planar_3r": 2, "polar_rp": 2, "scara": 2, "scara_column": 2, "scara_modified": 2, "spatial_rrr": 4,
         "spherical_wrist": 2, "rx90": 8, "kr210": 8}  # fmt: skip
REDUNDANT = {"dh": "classic", "rows": [{"a": f"l_{k}", "alpha": 0, "d": 0, "theta": f"theta_{k}"} for k in range(1, 5)]}


def misses(arm: Arm, q: np.ndarray) -> np.ndarray:
    """How far the tool is from the target at configurations (N, n), positions and axes as far as the task has them."""
    task, found = task_of(arm), postures_of(arm)
    X, goal = NumericKinematics(arm, q).pose(task.frame), NumericKinematics(arm, found.target[None]).pose(task.frame)[0]
    off = np.abs(X - goal)[:, :3]
    if task.turns_only:
        off = off[:, :, :3]
    elif max(task.rows) <= 3:
        off = off[:, :, 3:]
    return np.asarray(off.reshape(len(q), -1).max(axis=1))


def test_every_posture_reaches_the_target(arm: Arm) -> None:
    found = postures_of(arm)
    assert misses(arm, found.q).max() <= TOLERANCE
    assert misses(arm, found.q + 1e-3).max() > 1e-5


def test_there_are_as_many_as_the_course_says(arm: Arm) -> None:
    if arm.name in COUNT:
        assert len(postures_of(arm).q) == COUNT[arm.name]


def test_they_differ_by_more_than_whole_turns(arm: Arm) -> None:
    q = postures_of(arm).q
    for i in range(len(q)):
        for j in range(i):
            assert np.abs(np.exp(1j * q[i]) - np.exp(1j * q[j])).max() > 1e-4


def test_iteration_finds_what_the_formula_gives() -> None:
    from armproof.course.figures.facts.poses import showing_pose
    from armproof.course.figures.facts.solutions import _by_formula, _by_iteration

    arm = load_arm("rx90")
    target = showing_pose(arm)
    formula, iteration = _by_formula(arm, target), _by_iteration(task_of(arm), target)
    assert formula is not None
    gaps = np.abs(np.exp(1j * formula[:, None]) - np.exp(1j * iteration[None])).max(axis=2)
    assert gaps.min(axis=1).max() < 1e-7
    assert len(formula) == len(iteration) == 8


def test_they_are_drawn_where_the_plant_has_them(arm: Arm) -> None:
    if reason(arm, "en") is not None:
        pytest.skip(str(reason(arm, "en")))
    found, figure = postures_of(arm), postures(arm)
    projection = _fit(arm, found.q, 1.0).view(84.0, 60.0).projection
    few = len(found.q) <= 2
    lines = (
        drawn(figure) if few else {line.get_gid(): np.column_stack(line.get_data()) for line in figure.axes[0].lines}
    )
    for k, q in enumerate(found.q[:8], start=1):
        for joint, placed in zip(arm.joints, place_skeleton(arm, q).joints, strict=True):
            spot = lines[f"posture {k} joint {joint.symbol}"][0] - projection.points(np.array(placed.start))
            way = projection.points(np.array(placed.axis))
            assert abs(spot[0] * way[1] - spot[1] * way[0]) <= TOLERANCE
    target = projection.points(NumericKinematics(arm, found.target[None]).pose(task_of(arm).frame)[0, :3, 3])
    assert np.abs(lines["target"].mean(axis=0) - target).max() <= TOLERANCE


def test_a_redundant_arm_has_infinitely_many() -> None:
    arm = load_arm(REDUNDANT)
    assert not is_square(arm)
    assert "infinitely many" in str(reason(arm, "en"))
    assert "une infinité" in str(reason(arm, "fr"))


def test_captions_hold_the_joint_values() -> None:
    text = caption(load_arm("planar_2r"))
    for value in np.degrees(postures_of(load_arm("planar_2r")).q).ravel():
        assert f"{value:.3g}°".replace("-", "−") in text
