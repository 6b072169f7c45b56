"""The laws of matrices: over the exact ring on random entries, and on the poses and Jacobians of every arm."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from armproof.models.arm import Arm
from armproof.models.numeric.plant import NumericKinematics
from armproof.verification.algebra.angles import cos_sin
from armproof.verification.algebra.matrix import (
    Identity,
    Matrix,
    as_matrix,
    as_scalar,
    column,
    exact_rank,
    is_zero,
    sized,
    stacked,
)
from armproof.verification.algebra.protocol import identity
from armproof.verification.algebra.quantity import Quantity
from armproof.verification.algebra.ring import Ring, Scalar
from armproof.verification.errors import EvaluationError, ShapeError
from armproof.verification.evaluation.exact import ExactAlgebra

RING = Ring()
C1, S1 = cos_sin(RING.symbol("theta_1"))
C2, S2 = cos_sin(RING.symbol("theta_2"))
A = RING.symbol("a")
BLOCKS = [
    RING.zero,
    RING.one,
    C1,
    S1,
    -S1,
    C2,
    A * S2,
    C1 * C2 - S1 * S2,
    A,
    RING.rational(Fraction(-2, 3)),
    A / 2 + S1,
]

entries = st.sampled_from(BLOCKS)
integers = st.integers(-3, 3).map(RING.rational)


def matrices(rows: int, columns: int, cells: st.SearchStrategy[Scalar] = entries) -> st.SearchStrategy[Matrix]:
    """Return matrices of that size."""
    row = st.tuples(*[cells] * columns)
    return st.tuples(*[row] * rows).map(Matrix)


sizes = st.integers(1, 3)
squares = sizes.flatmap(lambda n: st.tuples(matrices(n, n), matrices(n, n)))
vectors = matrices(3, 1)


def vanishes(value: Any) -> bool:
    """Whether a scalar, or every entry of a matrix, is zero."""
    return all(cell.is_zero() for row in value.rows for cell in row) if isinstance(value, Matrix) else value.is_zero()


def scaled(matrix: Matrix, factor: Scalar) -> Matrix:
    return matrix.map(lambda cell: cell * factor)


def eye(size: int, ring: Ring = RING) -> Matrix:
    return identity(ExactAlgebra(ring, None), size)


def floats(matrix: Matrix) -> np.ndarray:
    """Return a matrix of rational constants as an array."""
    return np.array([[float(cell.as_fraction()) for cell in row] for row in matrix.rows])


# -- products, transposes, determinants ----------------------------------------------------------------------------------


@given(squares)
def test_the_determinant_of_a_product_is_the_product_of_determinants(pair: tuple[Matrix, Matrix]) -> None:
    a, b = pair
    assert vanishes((a @ b).determinant() - a.determinant() * b.determinant())
    assert vanishes(a.transpose.determinant() - a.determinant())


@given(squares)
def test_a_matrix_times_its_adjugate_is_its_determinant(pair: tuple[Matrix, Matrix]) -> None:
    a, _ = pair
    whole = scaled(eye(a.shape[0]), a.determinant())
    assert vanishes(a @ a.adjugate() + -whole) and vanishes(a.adjugate() @ a + -whole)
    assert vanishes(a.cofactors() + -a.adjugate().transpose)


@given(matrices(2, 3), matrices(3, 2), matrices(3, 2))
def test_products_distribute_and_transpose_in_reverse(a: Matrix, b: Matrix, c: Matrix) -> None:
    assert vanishes(a @ (b + c) + -(a @ b + a @ c))
    assert vanishes((a @ b).transpose + -(b.transpose @ a.transpose))
    assert vanishes((a @ b) @ a + -(a @ (b @ a)))


@given(matrices(4, 4, integers))
def test_determinants_and_ranks_are_those_of_numpy(a: Matrix) -> None:
    assert float(a.determinant().as_fraction()) == pytest.approx(np.linalg.det(floats(a)), abs=1e-9)
    assert exact_rank(a) == np.linalg.matrix_rank(floats(a))


@given(matrices(3, 3))
def test_exchanging_two_rows_turns_the_sign_of_the_determinant(a: Matrix) -> None:
    assert vanishes(a.determinant() + a.block([1, 0, 2], range(3)).determinant())
    assert a.block([0, 0, 2], range(3)).determinant().is_zero()


@given(matrices(3, 2), matrices(2, 3))
def test_a_product_has_no_more_rank_than_its_factors(a: Matrix, b: Matrix) -> None:
    assert exact_rank(a @ b) <= min(exact_rank(a), exact_rank(b))
    assert exact_rank(a) == exact_rank(a.transpose) == exact_rank(a.transpose @ a)


@given(vectors, vectors, vectors)
def test_the_cross_product_is_that_of_space(a: Matrix, b: Matrix, c: Matrix) -> None:
    assert vanishes(a.cross(b) + b.cross(a)) and vanishes(a.transpose @ a.cross(b))
    assert vanishes(a.cross(b.cross(c)) + b.cross(c.cross(a)) + c.cross(a.cross(b)))
    triple = Matrix(tuple(zip(*(v.vector() for v in (a, b, c)), strict=True))).determinant()
    assert vanishes((a.transpose @ b.cross(c)).rows[0][0] - triple)


def test_a_wrong_sign_in_a_cross_product_is_caught() -> None:
    a, b = column([C1, S1, A]), column([S2, RING.one, C2])
    wrong = column([a.cross(b).vector()[0], -a.cross(b).vector()[1], a.cross(b).vector()[2]])
    assert not vanishes(a.transpose @ wrong)


# -- the poses and Jacobians of every arm --------------------------------------------------------------------------------


def pose_of(arm: Arm) -> tuple[ExactAlgebra, Matrix]:
    exact = ExactAlgebra(Ring(), arm)
    return exact, exact.quantity(Quantity("pose", arm.frames[-1], arm.frames[0]))


def test_the_inverse_of_a_pose_is_the_pose_seen_from_the_tool(arm: Arm) -> None:
    exact, pose = pose_of(arm)
    inverse = exact.quantity(Quantity("pose", arm.frames[0], arm.frames[-1]))
    assert vanishes(pose @ inverse + -eye(4, exact.ring))
    assert vanishes(pose.adjugate() + -inverse)  # the determinant is 1
    assert not vanishes(pose @ pose + -eye(4, exact.ring))


def test_rotations_are_orthonormal_and_right_handed(arm: Arm) -> None:
    exact, pose = pose_of(arm)
    rotation = pose.block(range(3), range(3))
    assert vanishes(rotation.transpose @ rotation + -eye(3, exact.ring)) and rotation.determinant().is_one()
    x, y, z = (rotation.block(range(3), [k]) for k in range(3))
    assert vanishes(x.cross(y) + -z)


def test_the_rank_of_a_jacobian_is_that_of_the_plant_at_a_generic_configuration(arm: Arm) -> None:
    exact = ExactAlgebra(Ring(), arm)
    jacobian = exact.quantity(Quantity("jacobian", arm.frames[-1], arm.frames[0]))
    q = np.random.default_rng(4).uniform(0.3, 1.2, (1, len(arm.joints)))
    assert exact_rank(jacobian) == np.linalg.matrix_rank(NumericKinematics(arm, q).jacobian(arm.frames[-1])[0])


@pytest.mark.parametrize(
    ("name", "which", "joint", "generic"),
    [("spherical_wrist", "J", "theta_5", 3), ("planar_2r", "J_v", "theta_2", 2), ("scara", "J", "theta_2", 4)],
)
def test_a_jacobian_loses_rank_where_the_arm_is_singular(
    workbench: Callable[..., Any], name: str, which: str, joint: str, generic: int
) -> None:
    bench = workbench(name)
    jacobian = bench.value(which)
    assert exact_rank(jacobian) == generic
    assert exact_rank(bench.exact.substitute(jacobian, {joint: bench.exact.ring.zero})) == generic - 1
    turned = bench.exact.pi() / 3
    assert exact_rank(bench.exact.substitute(jacobian, {joint: turned})) == generic


# -- sizes -------------------------------------------------------------------------------------------------------------


def test_sizes_that_do_not_fit_are_named() -> None:
    wide, tall = eye(3).block(range(2), range(3)), eye(3).block(range(3), range(2))
    with pytest.raises(ShapeError, match="a sum of a 2×3 and a 3×2 matrix"):
        wide + tall
    with pytest.raises(ShapeError, match="a product of a 2×3 and a 2×3 matrix"):
        wide @ wide
    with pytest.raises(ShapeError, match="a 2×3 matrix has no determinant"):
        wide.determinant()
    with pytest.raises(ShapeError, match="a 3×2 matrix has no inverse and no cofactors"):
        tall.adjugate()
    with pytest.raises(EvaluationError, match="a 3-vector is expected, a 2×3 matrix is given"):
        wide.cross(column([RING.one] * 3))


def test_a_scalar_a_list_and_a_matrix_stand_for_one_another() -> None:
    pair, single = column([C1, A]), Matrix(((C1,),))
    assert as_scalar(single) is C1 and as_scalar(C1) is C1 and as_scalar(pair) is pair
    assert as_matrix(C1) == single and as_matrix(pair) is pair
    assert stacked([C1, A]) == sized([C1, A]) == pair and stacked(C1) is C1 and sized(pair) is pair
    for several in ([pair, pair], [C1, Identity(C1)], [[C1], [A]]):
        with pytest.raises(EvaluationError, match="a list of matrices stands where one value is expected"):
            stacked(several)
    with pytest.raises(EvaluationError, match="an identity matrix whose size cannot be told"):
        sized(Identity(C1))


def test_zero_is_zero_in_both_algebras_and_in_every_entry() -> None:
    nought = np.zeros(3)
    assert all(map(is_zero, (RING.zero, nought, column([RING.zero, C1 - C1]), column([nought, nought]))))
    assert not any(map(is_zero, (C1, np.eye(3)[0], column([RING.zero, C1]), column([nought, np.eye(3)[0]]))))


def test_a_row_or_a_column_is_a_vector_of_its_length() -> None:
    row = Matrix(((C1, A),))
    assert row.vector() == row.transpose.vector(2) == (C1, A) == row.cells
    assert [*eye(2).block([0], range(2)).places] == [(0, 0), (0, 1)] and row.size == "1×2"
    with pytest.raises(EvaluationError, match="a 3-vector is expected, a 1×2 matrix is given"):
        row.vector(3)
    with pytest.raises(EvaluationError, match="a vector is expected"):
        eye(2).vector()


def test_a_pose_times_a_plain_vector_says_what_is_missing() -> None:
    with pytest.raises(EvaluationError, match="write the vector in homogeneous coordinates") as caught:
        eye(4) @ column([RING.one] * 3)
    assert not isinstance(caught.value, ShapeError)


def test_what_is_too_large_to_expand_is_refused() -> None:
    with pytest.raises(EvaluationError, match="the determinant of a 9×9 matrix is more than is computed"):
        eye(9).determinant()
    assert eye(8).determinant().is_one() and vanishes(eye(7).cofactors() + -eye(7))
    with pytest.raises(EvaluationError, match="the cofactors of a 8×8 matrix are more than is computed"):
        eye(8).adjugate()


@given(squares)
def test_an_inverse_undoes_a_matrix(pair: tuple[Matrix, Matrix]) -> None:
    a, b = pair
    assume(not a.determinant().is_zero())
    inverse = scaled(a.adjugate(), RING.one / a.determinant())
    assert vanishes(inverse @ (a @ b) + -b)
