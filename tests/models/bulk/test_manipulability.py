"""Manipulability and condition number in bulk, on every arm: they are what the singular values of the double plant say."""

import numpy as np
import pytest

from armproof.models.arm import Arm
from armproof.models.bulk.bulk import bulk_of
from armproof.models.catalogue import load_arm
from armproof.models.errors import ModelError
from armproof.models.numeric.configurations import sample
from armproof.models.numeric.plant import NumericKinematics

TOLERANCE = 1e-12


def last_frame(arm: Arm) -> str:
    return arm.frames[-1]


def configurations(arm: Arm, count: int = 300) -> tuple[np.ndarray, np.ndarray]:
    """Return configurations of the six families, and a tolerance for each, scaled by the largest coordinate."""
    q, _ = sample(arm, count, np.random.default_rng(30))
    return q, TOLERANCE * np.maximum(1.0, np.abs(q).max(axis=1))


def singular_values(arm: Arm, q: np.ndarray, rows: list[int], columns: list[int]) -> np.ndarray:
    """Return the singular values of a part of the double plant's Jacobian; rows and columns from 1."""
    J = NumericKinematics(arm, q).jacobian(last_frame(arm))
    return np.linalg.svd(J[:, [row - 1 for row in rows]][:, :, [column - 1 for column in columns]], compute_uv=False)


PARTS: dict[str, tuple[list[int], list[int]]] = {
    "all": ([1, 2, 3, 4, 5, 6], [1, 2, 3, 4, 5, 6]),
    "velocity": ([1, 2, 3], [1, 2, 3, 4, 5, 6]),
    "plane": ([1, 2], [1, 2, 3, 4, 5, 6]),
    "angular velocity": ([4, 5, 6], [1, 2, 3, 4, 5, 6]),
    "one column": ([1, 2, 3, 4, 5, 6], [1]),
    "square": ([6, 1, 2], [3, 1, 2]),
}


@pytest.fixture(params=PARTS)
def part(request: pytest.FixtureRequest, arm: Arm) -> tuple[list[int], list[int]]:
    rows, columns = PARTS[request.param]
    return rows, [column for column in columns if column <= len(arm.joints)]


def test_manipulability_is_the_product_of_the_singular_values(arm: Arm, part: tuple[list[int], list[int]]) -> None:
    q, tolerance = configurations(arm)
    values = singular_values(arm, q, *part)
    w = bulk_of(arm).manipulability(q, last_frame(arm), *part)
    assert (w >= 0).all()
    # Singular values are exact up to the rounding of the largest.
    size = np.maximum(1.0, values[:, 0]) ** values.shape[1]
    assert (np.abs(w - values.prod(axis=1)) <= tolerance * size).all()


def test_condition_number_is_the_ratio_of_the_singular_values_that_do_not_always_vanish(
    arm: Arm, part: tuple[list[int], list[int]]
) -> None:
    q, _ = sample(arm, 60, np.random.default_rng(32))
    values = singular_values(arm, q, *part)
    rank = max(int((values > 1e-9 * values[:, :1]).sum(axis=1).max()), 1)
    largest, smallest = values[:, 0], values[:, rank - 1]
    kappa = bulk_of(arm).condition_number(q, last_frame(arm), *part)
    assert not np.isnan(kappa).any() and (kappa >= 1).all()
    regular = smallest > 1e-4 * largest
    np.testing.assert_allclose(kappa[regular], largest[regular] / smallest[regular], rtol=1e-8)
    assert (kappa[smallest < 1e-16 * largest] == np.inf).all()


def test_without_rows_and_columns_the_whole_jacobian_is_meant(arm: Arm) -> None:
    q, _ = sample(arm, 12, np.random.default_rng(33))
    for ask in (bulk_of(arm).manipulability, bulk_of(arm).condition_number):
        every = ask(q, last_frame(arm), range(1, 7), range(1, len(arm.joints) + 1))
        np.testing.assert_array_equal(ask(q, last_frame(arm)), every)


def test_axes_do_not_change_the_volume_of_the_velocity(arm: Arm) -> None:
    q, tolerance = configurations(arm, 60)
    frame = last_frame(arm)
    base, own = (bulk_of(arm).manipulability(q, frame, [1, 2, 3], expressed_in=axes) for axes in (None, frame))
    assert (np.abs(base - own) <= 100 * tolerance).all()


SINGULAR = {
    "planar_2r": ([1, 2], [0.7, 0.0]),
    "scara": ([1, 2, 3, 6], [0.4, np.pi, -0.1, 0.3]),
    "rx90": (None, [0.3, 0.4, 0.5, 0.6, 0.0, 0.2]),  # wrist: the fourth and the sixth axis fall together
    "spherical_wrist": ([4, 5, 6], [0.3, 0.0, 0.2]),
}


@pytest.mark.parametrize("name", SINGULAR)
def test_manipulability_vanishes_where_the_arm_is_singular_and_only_there(name: str) -> None:
    arm = load_arm(name)
    rows, singular = SINGULAR[name]
    near = np.array(singular)[None] + np.outer([0.0, 1e-9, 1e-6, 0.3], np.ones(len(singular)))
    w = bulk_of(arm).manipulability(near, last_frame(arm), rows)
    kappa = bulk_of(arm).condition_number(near, last_frame(arm), rows)
    assert w[0] < 1e-16 and kappa[0] == np.inf
    assert w[1] == pytest.approx(w[2] * 1e-3, rel=1e-4)  # nine digits are left where det(J Jᵀ) has none
    assert w[3] > 1e-3 and np.isfinite(kappa[3])


def test_a_jacobian_that_is_zero_has_no_volume_and_an_infinite_condition_number() -> None:
    bulk, q = bulk_of(load_arm("planar_2r")), np.zeros((3, 2))
    for rows in ([3], [3, 4, 5]):
        np.testing.assert_array_equal(bulk.manipulability(q, "2", rows), np.zeros(3))
        np.testing.assert_array_equal(bulk.condition_number(q, "2", rows), np.full(3, np.inf))


def test_more_minors_than_are_worth_expanding_give_the_same_volume() -> None:
    rows = [{"a": 0.1 * i, "alpha": "pi/2", "d": 0.2, "theta": f"theta_{i}"} for i in range(1, 11)]
    arm = load_arm({"dh": "modified", "rows": rows})
    q, _ = sample(arm, 30, np.random.default_rng(5))
    for columns in (None, [1, 2, 3, 4, 5, 6, 7]):
        values = singular_values(arm, q, [1, 2, 3, 4, 5, 6], columns or list(range(1, 11)))
        np.testing.assert_allclose(
            bulk_of(arm).manipulability(q, "10", columns=columns), values.prod(axis=1), rtol=1e-10, atol=1e-11
        )


@pytest.mark.parametrize("rows", [[], [0], [7], [1, 1], [1.5], "123", 3, [None], [-1]])
def test_rows_and_columns_that_are_not_there_are_refused(rows) -> None:
    bulk, q = bulk_of(load_arm("rx90")), np.zeros((1, 6))
    with pytest.raises(ModelError, match="rows are different whole numbers from 1 to 6, not"):
        bulk.manipulability(q, "6", rows)
    with pytest.raises(ModelError, match="columns are different whole numbers from 1 to 6, not"):
        bulk.condition_number(q, "6", columns=rows)
