"""Inverse velocity: the laws of the pseudo-inverse and of damped least squares, near and at singular configurations."""

import numpy as np
import pytest

from armproof.models.arm import Arm
from armproof.models.catalogue import load_arm
from armproof.models.errors import ModelError
from armproof.models.motion.inverse_velocity import (
    applicable_form,
    damped_inverse,
    joint_rates,
    pseudo_inverse,
)
from armproof.models.numeric.configurations import sample
from armproof.models.numeric.plant import NumericKinematics

SHAPES = [(2, 2), (3, 3), (6, 6), (2, 3), (3, 6), (6, 3), (6, 4), (1, 5), (5, 1)]


def random_jacobians(shape: tuple[int, int], count: int = 20) -> np.ndarray:
    """Return Jacobians far from singular: random directions, singular values from 0.3 to 2."""
    rng = np.random.default_rng(sum(shape))
    U, _, Vt = np.linalg.svd(rng.normal(size=(count, *shape)), full_matrices=False)
    return U * rng.uniform(0.3, 2.0, (count, 1, min(shape))) @ Vt


def penrose_defect(J: np.ndarray, P: np.ndarray) -> float:
    """Return by how much P fails the four conditions of Moore and Penrose."""
    JP, PJ = J @ P, P @ J
    pairs = ((JP @ J, J), (PJ @ P, P), (np.swapaxes(JP, -1, -2), JP), (np.swapaxes(PJ, -1, -2), PJ))
    return max(float(np.abs(a - b).max()) for a, b in pairs)


@pytest.mark.parametrize("shape", SHAPES)
def test_the_four_conditions_of_moore_and_penrose_hold(shape):
    J = random_jacobians(shape)
    assert penrose_defect(J, pseudo_inverse(J)) < 1e-10
    assert penrose_defect(J, damped_inverse(J, 0.1)) > 1e-4, "the conditions cannot fail"


def test_the_conditions_hold_on_every_arm_at_every_kind_of_configuration(arm: Arm):
    q, _ = sample(arm, 60, np.random.default_rng(0))
    J = NumericKinematics(arm, q).jacobian(arm.frames[-1])
    J = J[:, np.abs(J).max(axis=(0, 2)) > 1e-9]
    J = J[np.linalg.svd(J, compute_uv=False)[:, -1] > 1e-3]  # of what is nearly singular no inverse is accurate
    assert not len(J) or penrose_defect(J, pseudo_inverse(J)) < 1e-8


@pytest.mark.parametrize("shape", SHAPES)
def test_the_forms_are_the_printed_ones(shape):
    J = random_jacobians(shape)
    Jt = np.swapaxes(J, -1, -2)
    form = applicable_form(J)
    if form != "left inverse":
        np.testing.assert_allclose(pseudo_inverse(J), Jt @ np.linalg.inv(J @ Jt), atol=1e-9)
        np.testing.assert_allclose(J @ pseudo_inverse(J), np.tile(np.eye(shape[0]), (20, 1, 1)), atol=1e-11)
    if form != "right inverse":
        np.testing.assert_allclose(pseudo_inverse(J), np.linalg.inv(Jt @ J) @ Jt, atol=1e-9)
        np.testing.assert_allclose(pseudo_inverse(J) @ J, np.tile(np.eye(shape[1]), (20, 1, 1)), atol=1e-11)
    assert form == {-1: "right inverse", 0: "inverse", 1: "left inverse"}[np.sign(shape[0] - shape[1])]
    np.testing.assert_allclose(pseudo_inverse(J), np.linalg.pinv(J), atol=1e-9)
    expected = Jt @ np.linalg.inv(J @ Jt + 0.3**2 * np.eye(shape[0]))
    np.testing.assert_allclose(damped_inverse(J, 0.3), expected, atol=1e-12)


def test_one_jacobian_and_a_batch_of_one_agree():
    J = random_jacobians((3, 6), 1)
    for inverse in (pseudo_inverse, lambda J: damped_inverse(J, 0.2)):
        np.testing.assert_array_equal(inverse(J)[0], inverse(J[0]))
        assert inverse(J).shape == (1, 6, 3) and inverse(np.empty((0, 3, 6))).shape == (0, 6, 3)


def test_a_singular_arm_is_refused_with_its_rank():
    arm = load_arm("planar_2r")
    J = NumericKinematics(arm, np.array([[0.3, 1.0], [0.3, 0.0]])).jacobian("2")[:, :2]
    with pytest.raises(ModelError, match=r"number 1 of the batch has rank 1: the arm is singular"):
        pseudo_inverse(J)
    with pytest.raises(ModelError, match=r"full row rank 2; the Jacobian has rank 1"):
        joint_rates(J[1], [0.1, 0.0])


@pytest.mark.parametrize("damping", [1e-3, 0.05, 2.0])
def test_damped_rates_are_bounded_everywhere(arm: Arm, damping: float):
    rng = np.random.default_rng(1)
    q, _ = sample(arm, 60, rng)
    J = NumericKinematics(arm, q).jacobian(arm.frames[-1])
    twist = rng.normal(size=(60, 6))
    bound = np.linalg.norm(twist, axis=1) / (2 * damping)
    assert (np.linalg.norm(joint_rates(J, twist, damping=damping).rates, axis=1) <= bound * (1 + 1e-9)).all()


def test_the_bound_is_reached_and_the_pseudo_inverse_passes_it():
    J, twist, damping = np.diag([1.0, 0.01]), np.array([0.0, 1.0]), 0.01
    assert np.linalg.norm(joint_rates(J, twist, damping=damping).rates) == pytest.approx(1 / (2 * damping))
    assert np.linalg.norm(joint_rates(J, twist).rates) > 1 / (2 * damping)


@pytest.mark.parametrize("shape", SHAPES)
def test_damped_least_squares_tends_to_the_pseudo_inverse(shape):
    J = random_jacobians(shape)
    gaps = [np.abs(damped_inverse(J, damping) - pseudo_inverse(J)).max() for damping in (1e-2, 1e-3, 1e-4)]
    assert gaps[2] < 1e-5
    assert gaps[0] / gaps[1] == pytest.approx(100, rel=0.2), "the gap is of second order in the damping"


def test_near_a_singularity_the_pseudo_inverse_grows_and_the_damped_one_does_not():
    arm, twist = load_arm("planar_2r"), np.array([1.0, 0.0])
    J = NumericKinematics(arm, np.array([[0.0, angle] for angle in (1e-1, 1e-3, 1e-5)])).jacobian("2")[:, :2]
    free = np.linalg.norm(joint_rates(J, np.tile(twist, (3, 1))).rates, axis=1)
    damped = np.linalg.norm(joint_rates(J, np.tile(twist, (3, 1)), damping=0.05).rates, axis=1)
    np.testing.assert_allclose(free[1:] / free[:-1], 100, rtol=0.05)
    assert (damped <= 1 / (2 * 0.05)).all() and damped[2] < damped[0]


def test_the_residual_is_what_the_rates_miss_and_no_other_rates_miss_less():
    rng = np.random.default_rng(2)
    J, twist = random_jacobians((6, 3)), rng.normal(size=(20, 6))
    found = joint_rates(J, twist)
    assert found.form == "left inverse"
    np.testing.assert_allclose(found.residual, twist - np.einsum("kij,kj->ki", J, found.rates), atol=1e-12)
    for _ in range(10):
        other = found.rates + 0.1 * rng.normal(size=(20, 3))
        missed = twist - np.einsum("kij,kj->ki", J, other)
        assert (np.linalg.norm(missed, axis=1) > np.linalg.norm(found.residual, axis=1)).all()
    assert np.abs(joint_rates(random_jacobians((3, 6)), rng.normal(size=(20, 3))).residual).max() < 1e-12


def test_rates_move_the_tool_with_the_twist(arm: Arm):
    q = sample(arm, 6, np.random.default_rng(3))[0][:1]
    J = NumericKinematics(arm, q).jacobian(arm.frames[-1])[0]
    rates = np.linspace(0.3, 1.0, len(arm.joints))
    if np.linalg.matrix_rank(J) == len(arm.joints):
        found = joint_rates(J, J @ rates).rates
        np.testing.assert_allclose(J @ found, J @ rates, atol=1e-9)
        np.testing.assert_allclose(found, rates, atol=1e-6)


@pytest.mark.parametrize(
    ("J", "message"),
    [
        (np.zeros(3), r"shape \(m, n\), a batch of them \(N, m, n\), not \(3,\)"),
        (np.zeros((1, 1, 2, 2)), r"not \(1, 1, 2, 2\)"),
        (np.zeros((0, 2)), r"not \(0, 2\)"),
        ([[1.0, np.nan]], "one is NaN or infinite"),
        ([[1.0], [1.0, 2.0]], "array of numbers"),
        ("J", "array of numbers"),
        (np.zeros((3, 3)), "rank 0"),
    ],
)
def test_what_is_no_jacobian_is_refused(J, message):
    with pytest.raises(ModelError, match=message):
        pseudo_inverse(J)


@pytest.mark.parametrize("damping", [0, -0.1, np.nan, np.inf])
def test_a_damping_factor_is_positive(damping):
    with pytest.raises(ModelError, match="a damping factor is positive and finite"):
        damped_inverse(np.eye(2), damping)


def test_other_bad_input_is_refused():
    with pytest.raises(ModelError, match=r"the shape \(3,\) is neither"):
        damped_inverse(np.zeros((2, 2, 2)), np.ones(3))
    with pytest.raises(ModelError, match=r"twists have the shape \(2,\), not \(3,\)"):
        joint_rates(np.eye(2), np.ones(3))
    with pytest.raises(ModelError, match="a twist has finite numbers only"):
        joint_rates(np.eye(2), [1.0, np.nan])


def test_inverses_are_read_only():
    for array in (pseudo_inverse(np.eye(2)), joint_rates(np.eye(2), np.ones(2)).rates):
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 1
