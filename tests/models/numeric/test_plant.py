"""The plant of doubles at many configurations, and the six families of them."""

import numpy as np
import pytest

from armproof.models.arm import Arm
from armproof.models.catalogue import load_arm
from armproof.models.errors import ModelError
from armproof.models.numeric.configurations import FAMILIES, sample
from armproof.models.numeric.plant import NumericKinematics


def test_poses_are_rigid(arm: Arm) -> None:
    q, _ = sample(arm, 60, np.random.default_rng(1))
    X = NumericKinematics(arm, q).pose(arm.frames[-1], arm.frames[1])
    np.testing.assert_allclose(
        X[:, :3, :3] @ X[:, :3, :3].transpose(0, 2, 1), np.tile(np.eye(3), (60, 1, 1)), atol=1e-13
    )
    np.testing.assert_array_equal(X[:, 3], np.tile([0.0, 0.0, 0.0, 1.0], (60, 1)))


def test_poses_chain(arm: Arm) -> None:
    q, _ = sample(arm, 60, np.random.default_rng(2))
    numeric = NumericKinematics(arm, q)
    middle, last = arm.frames[1], arm.frames[-1]
    np.testing.assert_allclose(numeric.pose(middle) @ numeric.pose(last, middle), numeric.pose(last), atol=1e-10)


def test_jacobian_is_the_finite_difference_of_the_position(arm: Arm) -> None:
    q = sample(arm, 6, np.random.default_rng(3))[0][:1]
    step, frame = 1e-6, arm.frames[-1]
    J = NumericKinematics(arm, q).jacobian(frame)[0, :3]
    for j in range(len(arm.joints)):
        ends = np.repeat(q, 2, axis=0)
        ends[:, j] += (-step, step)
        before, after = NumericKinematics(arm, ends).pose(frame)[:, :3, 3]
        np.testing.assert_allclose((after - before) / (2 * step), J[:, j], atol=1e-8)


def test_an_expressed_jacobian_is_the_rotated_one(arm: Arm) -> None:
    q, _ = sample(arm, 30, np.random.default_rng(4))
    numeric, last = NumericKinematics(arm, q), arm.frames[-1]
    R = numeric.pose(arm.frames[0], last)[:, :3, :3]
    base, own = numeric.jacobian(last), numeric.jacobian(last, expressed_in=last)
    np.testing.assert_allclose(R @ base[:, :3], own[:, :3], atol=1e-10)
    np.testing.assert_allclose(R @ base[:, 3:], own[:, 3:], atol=1e-12)


def test_rows_are_velocity_then_angular_velocity() -> None:
    J = NumericKinematics(load_arm("planar_2r"), np.zeros((1, 2))).jacobian("2")[0]
    l_1, l_2 = load_arm("planar_2r").lengths.values()
    np.testing.assert_allclose(J, [[0, 0], [l_1 + l_2, l_2], [0, 0], [0, 0], [0, 0], [1, 1]], atol=1e-15)


def test_arrays_are_computed_once_and_read_only() -> None:
    numeric = NumericKinematics(load_arm("scara"), np.zeros((2, 4)))
    assert numeric.jacobian("4") is numeric.jacobian("4", "0")
    for array in (numeric.pose("4"), numeric.jacobian("4"), numeric.q):
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 1


def test_the_caller_keeps_its_own_configurations() -> None:
    q = np.zeros((2, 4))
    numeric = NumericKinematics(load_arm("scara"), q)
    q[:] = 1
    assert not numeric.q.any() and q.flags.writeable


@pytest.mark.parametrize("shape", [(4,), (3, 3), (1, 4, 1)])
def test_configurations_of_another_shape_are_refused(shape: tuple[int, ...]) -> None:
    with pytest.raises(ModelError, match=r"configurations of arm 'scara' have the shape \(N, 4\), not \("):
        NumericKinematics(load_arm("scara"), np.zeros(shape))


def test_unknown_frames_are_refused() -> None:
    numeric = NumericKinematics(load_arm("scara"), np.zeros((1, 4)))
    with pytest.raises(ModelError, match="no frame '7' on arm 'scara'; its frames are 0, 1, 2, 3, 4"):
        numeric.pose("7")
    with pytest.raises(ModelError, match="no frame '7' on arm 'scara'"):
        numeric.jacobian("4", expressed_in="7")


def test_families_have_equal_shares_and_their_ranges(arm: Arm) -> None:
    q, family = sample(arm, 1000, np.random.default_rng(6))
    assert q.shape == (1000, len(arm.joints))
    counts = np.bincount(family, minlength=len(FAMILIES))
    assert counts.sum() == 1000 and counts.max() - counts.min() <= 1
    generic, zero, tiny, quarter, wide = (q[family == i] for i in range(5))
    for joint in arm.joints:
        column = joint.index - 1
        assert joint.lower <= generic[:, column].min() and generic[:, column].max() <= joint.upper
        assert np.ptp(generic[:, column]) > 0
        spread = 50 if joint.kind == "revolute" else 5
        assert 0.9 * spread < np.abs(wide[:, column]).max() <= spread
        if joint.kind == "revolute":
            turns = quarter[:, column] / (np.pi / 2)
            assert np.abs(turns - np.round(turns)).max() <= 1e-6
    assert not zero.any()
    assert 0 < np.abs(tiny).max() <= 1e-7


def test_near_singular_is_nearer_to_a_singularity_than_generic() -> None:
    arm = load_arm("planar_2r")
    q, family = sample(arm, 600, np.random.default_rng(7))
    area = np.abs(np.sin(q[:, 1]))
    assert np.median(area[family == FAMILIES.index("near-singular")]) < 0.1 * np.median(area[family == 0])


def test_samples_repeat_with_the_seed() -> None:
    arm = load_arm("scara")
    first, second = (sample(arm, 60, np.random.default_rng(8))[0] for _ in range(2))
    np.testing.assert_array_equal(first, second)
    assert (first != sample(arm, 60, np.random.default_rng(9))[0]).any()
    fewer, family = sample(arm, 60, np.random.default_rng(8), near_singular=False)
    np.testing.assert_array_equal(fewer, first[:50])
    assert len(family) == 50 and family.max() == FAMILIES.index("near-singular") - 1
    np.testing.assert_array_equal(sample(arm)[0], sample(arm, 1000)[0])


@pytest.mark.parametrize("count", [0, 1, 5, 7])
def test_small_samples_have_as_many_rows_as_asked_for(count: int) -> None:
    q, family = sample(load_arm("scara"), count, np.random.default_rng(0))
    assert q.shape == (count, 4) and family.shape == (count,)
