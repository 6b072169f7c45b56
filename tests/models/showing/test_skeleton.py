"""Where an arm's joints and frames are at one configuration: against the kinematics, for every arm."""

import numpy as np
import pytest

from armproof.models.catalogue import arm_names, load_arm
from armproof.models.errors import ModelError
from armproof.models.numeric.plant import NumericKinematics
from armproof.models.showing.skeleton import place_skeleton

STEP = 1e-6


@pytest.mark.parametrize("name", arm_names())
def test_the_frames_are_those_of_the_kinematics(name: str) -> None:
    arm = load_arm(name)
    q = np.random.default_rng(3).uniform(-1, 1, len(arm.joints))
    skeleton = place_skeleton(arm, q)
    for frame in arm.frames:
        np.testing.assert_allclose(skeleton.frames[frame], NumericKinematics(arm, q[None]).pose(frame)[0], atol=1e-12)
        assert not skeleton.frames[frame].flags.writeable


@pytest.mark.parametrize("name", arm_names())
def test_the_axes_move_the_last_frame_as_its_jacobian_says(name: str) -> None:
    arm = load_arm(name)
    last = arm.frames[-1]
    q = np.random.default_rng(4).uniform(-1, 1, len(arm.joints))
    skeleton = place_skeleton(arm, q)
    jacobian = NumericKinematics(arm, q[None]).jacobian(last)[0]
    p = skeleton.frames[last][:3, 3]
    for k, joint in enumerate(skeleton.joints):
        axis, start = np.array(joint.axis), np.array(joint.start)
        revolute = joint.kind == "revolute"
        linear = np.cross(axis, p - start) if revolute else axis
        np.testing.assert_allclose(jacobian[:, k], [*linear, *(axis if revolute else np.zeros(3))], atol=1e-9)


def test_a_slide_that_is_moved_ends_where_it_carries_the_next_link() -> None:
    arm = load_arm("scara")
    start, end = (place_skeleton(arm, [0.3, 0.4, d, 0.1]).joints[2] for d in (0.0, 0.2))
    np.testing.assert_allclose(start.start, start.end, atol=1e-12)
    np.testing.assert_allclose(np.subtract(end.end, end.start), 0.2 * np.array(end.axis), atol=1e-12)


def test_a_configuration_of_another_length_is_refused() -> None:
    with pytest.raises(ModelError, match="has 4 values"):
        place_skeleton(load_arm("scara"), [0.0, 0.0])
