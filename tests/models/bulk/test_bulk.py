"""The laws of the kinematics in bulk, on every arm: it is that of the double plant, at any number of configurations."""

from concurrent.futures import ThreadPoolExecutor
from itertools import product

import numpy as np
import pytest

from armproof.models.arm import Arm
from armproof.models.bulk.bulk import BulkKinematics, bulk_of
from armproof.models.bulk.program import BLOCK
from armproof.models.catalogue import load_arm
from armproof.models.errors import ModelError
from armproof.models.exact.trace import trace_of
from armproof.models.numeric.configurations import sample
from armproof.models.numeric.joint_values import outside_limits
from armproof.models.numeric.plant import NumericKinematics

TOLERANCE = 1e-12


def last_frame(arm: Arm) -> str:
    return arm.frames[-1]


def configurations(arm: Arm, count: int = 300) -> tuple[np.ndarray, np.ndarray]:
    """Return configurations of the six families, and a tolerance for each, scaled by the largest coordinate."""
    q, _ = sample(arm, count, np.random.default_rng(30))
    return q, TOLERANCE * np.maximum(1.0, np.abs(q).max(axis=1))[:, None, None]


def assert_agrees(bulk: np.ndarray, double: np.ndarray, tolerance: np.ndarray) -> None:
    worst = np.max(np.abs(bulk - double) / tolerance)
    assert worst <= 1, f"{worst} times the tolerance"


def test_poses_between_any_two_frames_are_those_of_the_double_plant(arm: Arm) -> None:
    q, tolerance = configurations(arm)
    numeric = NumericKinematics(arm, q)
    for frame, reference in product(arm.frames, repeat=2):
        assert_agrees(bulk_of(arm).pose(q, frame, reference), numeric.pose(frame, reference), tolerance)


def test_jacobians_among_any_three_frames_are_those_of_the_double_plant(arm: Arm) -> None:
    q, tolerance = configurations(arm, 60)
    numeric = NumericKinematics(arm, q)
    some = (arm.frames[0], arm.frames[1], arm.frames[len(arm.frames) // 2], arm.frames[-1])
    for frames in product(some, repeat=3):
        assert_agrees(bulk_of(arm).jacobian(q, *frames), numeric.jacobian(*frames), tolerance)


def test_pose_and_jacobian_together_are_those_of_the_double_plant_on_all_families(arm: Arm) -> None:
    q, tolerance = configurations(arm, 1200)
    X, J = bulk_of(arm).pose_and_jacobian(q, last_frame(arm))
    assert_agrees(X, NumericKinematics(arm, q).pose(last_frame(arm)), tolerance)
    assert_agrees(J, NumericKinematics(arm, q).jacobian(last_frame(arm)), tolerance)


def test_jacobian_is_the_derivative_of_the_forward_kinematics(arm: Arm) -> None:
    q, _ = sample(arm, 60, np.random.default_rng(31))
    q, step, frame = q[np.abs(q).max(axis=1) < 10], 1e-5, last_frame(arm)
    J, R = bulk_of(arm).jacobian(q, frame), bulk_of(arm).pose(q, frame)[:, :3, :3]
    for j in range(len(arm.joints)):
        ahead, behind = (bulk_of(arm).pose(q + sign * step * np.eye(len(arm.joints))[j], frame) for sign in (1, -1))
        derivative = (ahead - behind) / (2 * step)
        turning = derivative[:, :3, :3] @ R.transpose(0, 2, 1)  # dR/dq Rᵀ, the cross-product matrix of ω
        omega = np.stack([turning[:, 2, 1], turning[:, 0, 2], turning[:, 1, 0]], axis=1)
        np.testing.assert_allclose(J[:, :3, j], derivative[:, :3, 3], atol=1e-8)
        np.testing.assert_allclose(J[:, 3:, j], omega, atol=1e-8)


def test_poses_are_rigid(arm: Arm) -> None:
    q, _ = configurations(arm)
    X = bulk_of(arm).pose(q, last_frame(arm))
    R = X[:, :3, :3]
    np.testing.assert_allclose(R @ R.transpose(0, 2, 1), np.tile(np.eye(3), (len(q), 1, 1)), atol=1e-14)
    np.testing.assert_array_equal(X[:, 3], np.tile([0.0, 0.0, 0.0, 1.0], (len(q), 1)))


@pytest.mark.parametrize("count", [0, 1, BLOCK - 1, BLOCK, BLOCK + 1, 2 * BLOCK + 1])
def test_a_configuration_has_one_answer_wherever_it_stands_in_the_batch(count: int) -> None:
    arm = load_arm("rx90")
    q = np.random.default_rng(count).uniform(-3, 3, (count, 6))
    X, J = bulk_of(arm).pose_and_jacobian(q, "6")
    w, kappa = bulk_of(arm).manipulability(q, "6"), bulk_of(arm).condition_number(q, "6")
    assert X.shape == (count, 4, 4) and J.shape == (count, 6, 6) and w.shape == kappa.shape == (count,)
    for k in {0, count // 2, count - 1} & set(range(count)):
        one = q[k : k + 1]
        np.testing.assert_allclose(bulk_of(arm).pose(one, "6")[0], X[k], atol=1e-15)
        np.testing.assert_allclose(bulk_of(arm).jacobian(one, "6")[0], J[k], atol=1e-15)
        np.testing.assert_allclose(bulk_of(arm).manipulability(one, "6")[0], w[k], atol=1e-15)


def test_arrays_are_contiguous_read_only_and_the_callers_own_is_left_alone() -> None:
    bulk, q = bulk_of(load_arm("scara")), np.ones((5, 4))
    results = (*bulk.pose_and_jacobian(q, "4"), bulk.manipulability(q, "4"), bulk.condition_number(q, "4"))
    for array in (*results, bulk.pose(q, "4"), bulk.jacobian(q, "4")):
        assert array.flags.c_contiguous
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 1
    assert (q == 1).all() and q.flags.writeable
    assert bulk.pose(q, "4") is not bulk.pose(q, "4")


def test_strided_and_reversed_configurations_are_read_in_their_order() -> None:
    bulk = bulk_of(load_arm("scara"))
    q = np.random.default_rng(3).uniform(-2, 2, (2 * BLOCK, 8))
    for view in (q[:, ::2], q[::-1, 4:], np.asfortranarray(q[:, :4]), q[::3, 7:3:-1]):
        np.testing.assert_array_equal(bulk.pose(view, "4"), bulk.pose(np.ascontiguousarray(view), "4"))


def test_an_arm_too_large_for_the_expanded_trace_is_multiplied_link_by_link() -> None:
    rows = [{"a": f"a_{i}", "alpha": f"alpha_{i}", "d": f"d_{i}", "theta": f"theta_{i}"} for i in range(1, 9)]
    arm = load_arm({"dh": "classic", "rows": rows})
    with pytest.raises(ModelError, match="too many symbolic angles"):
        trace_of(arm).pose("8")
    q, tolerance = configurations(arm)
    X, J = bulk_of(arm).pose_and_jacobian(q, "8")
    assert_agrees(X, NumericKinematics(arm, q).pose("8"), 3 * tolerance)
    assert_agrees(J, NumericKinematics(arm, q).jacobian("8"), 3 * tolerance)


def test_other_lengths_and_angles_are_those_of_an_arm_built_with_them() -> None:
    def table(a: object, alpha: object, d: object) -> Arm:
        first = {"a": a, "alpha": alpha, "d": 0.2, "theta": "theta_1"}
        second = {"a": 0.3, "alpha": "pi/2", "d": "d_2", "theta": 0.3}
        third = {"a": a, "alpha": "pi/3", "d": d, "theta": "theta_3"}
        return load_arm({"dh": "modified", "rows": [first, second, third], "joints": ["theta_1", "d_2", "theta_3"]})

    numbers, symbols = table(0.37, 0.9, -0.11), table("a_1", "alpha_1", "-l_3")
    q, tolerance = configurations(numbers)
    moved = bulk_of(symbols).with_values({"a_1": 0.37}).with_values({"alpha_1": 0.9, "l_3": 0.11})
    for bulk in (moved, bulk_of(numbers)):
        X, J = bulk.pose_and_jacobian(q, "3")
        assert_agrees(X, NumericKinematics(numbers, q).pose("3"), tolerance)
        assert_agrees(J, NumericKinematics(numbers, q).jacobian("3"), tolerance)
    assert np.abs(bulk_of(symbols).pose(q, "3") - moved.pose(q, "3")).max() > 0.01


def test_a_length_may_be_zero() -> None:
    flat = bulk_of(load_arm("scara")).with_values({"a_2": 0})
    q = np.random.default_rng(4).uniform(-2, 2, (50, 4))
    np.testing.assert_array_equal(flat.manipulability(q, "4", [1, 2], [1, 2]), np.zeros(50))
    np.testing.assert_array_equal(flat.condition_number(q, "4", [1, 2], [2]), np.full(50, np.inf))


def test_values_that_are_none_of_the_arms_are_refused() -> None:
    arm = load_arm("scara")
    with pytest.raises(ModelError, match=r"no length or angle 'a_7' on arm 'scara'; it has a_1, a_2"):
        BulkKinematics(arm, {"a_7": 1.0})
    for value in (np.nan, np.inf, "1", None, 1j, True):
        with pytest.raises(ModelError, match="'a_1' of arm 'scara' is a finite number, not"):
            bulk_of(arm).with_values({"a_1": value})


@pytest.mark.parametrize("ask", ["pose", "jacobian", "pose_and_jacobian", "manipulability", "condition_number"])
def test_unknown_frames_and_wrong_configurations_are_refused(ask: str) -> None:
    method = getattr(bulk_of(load_arm("scara")), ask)
    with pytest.raises(ModelError, match="no frame '7' on arm 'scara'; its frames are 0, 1, 2, 3, 4"):
        method(np.zeros((1, 4)), "7")
    with pytest.raises(ModelError, match=r"configurations of arm 'scara' have the shape \(N, 4\), not \(2, 6\)"):
        method(np.zeros((2, 6)), "4")


def test_values_beyond_the_limits_have_a_pose_all_the_same() -> None:
    arm = load_arm("rx90")
    q = np.full((2, 6), 49.0)
    assert outside_limits(arm, q).any()
    np.testing.assert_allclose(bulk_of(arm).pose(q, "6"), NumericKinematics(arm, q).pose("6"), atol=1e-12)


def test_a_slip_in_one_instruction_is_caught() -> None:
    arm = load_arm("rx90")
    q, tolerance = configurations(arm, 60)
    caught = 0
    bulk = BulkKinematics(arm)
    bulk.pose_and_jacobian(q, "6")
    ((program, _),) = bulk._programs.values()
    swap = {np.add: np.subtract, np.subtract: np.add, np.multiply: np.add}
    for place, instruction in enumerate(list(program.instructions)):
        program.instructions[place] = instruction._replace(operation=swap[instruction.operation])
        X, J = bulk.pose_and_jacobian(q, "6")
        with pytest.raises(AssertionError, match="times the tolerance"):
            assert_agrees(X, NumericKinematics(arm, q).pose("6"), tolerance)
            assert_agrees(J, NumericKinematics(arm, q).jacobian("6"), tolerance)
        program.instructions[place] = instruction
        caught += 1
    assert caught == len(program.instructions) > 50


def test_threads_may_share_a_bulk() -> None:
    q = np.random.default_rng(6).uniform(-3, 3, (4 * BLOCK, 6))
    arm = load_arm("kr210")
    expected = bulk_of(arm).pose_and_jacobian(q, "6")
    shared = BulkKinematics(arm)
    with ThreadPoolExecutor(8) as pool:
        for X, J in pool.map(lambda _: shared.pose_and_jacobian(q, "6"), range(16)):
            np.testing.assert_array_equal(X, expected[0])
            np.testing.assert_array_equal(J, expected[1])


def test_a_bulk_and_its_programs_are_made_once() -> None:
    arm = load_arm("planar_2r")
    assert bulk_of(arm) is bulk_of(arm)
    bulk, q = BulkKinematics(arm), np.zeros((1, 2))
    for _ in range(3):
        bulk.jacobian(q, "2"), bulk.jacobian(q, "2", "0"), bulk.pose(q, "2")
    assert len(bulk._programs) == 2
