"""The Jacobian whose singularities are asked for, and an equivalent one with as few terms as possible."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from armproof.models.arm import Arm
from armproof.models.errors import ModelError
from armproof.verification.algebra.matrix import Matrix, exact_rank
from armproof.verification.evaluation.exact import ExactAlgebra
from armproof.verification.singularities.elimination import BeyondReach

MOST_JOINTS = 8


@dataclass(frozen=True)
class ChosenJacobian:
    """Rows and columns of the geometric Jacobian of a frame's origin, rows [v; ω].

    Attributes:
        arm, frame, expressed_in: the arm, the frame whose velocity it gives, the frame in whose axes.
        rows, columns: those chosen, counted from 1.
        matrix: as asked for.
        simple: transform @ simple = matrix; `transform` is invertible with determinant 1.
        transform: square, rows of `matrix` by rows of `simple`; None where they are the same.
        axes, point: the frame in whose axes `simple` is, and the frame of the point (of the last link) whose velocity it gives.
    """

    arm: Arm
    frame: str
    expressed_in: str
    rows: tuple[int, ...]
    columns: tuple[int, ...]
    matrix: Matrix
    simple: Matrix
    transform: Matrix | None
    axes: str
    point: str


def choose_jacobian(
    algebra: ExactAlgebra,
    frame: str | None,
    rows: Sequence[int] | None,
    columns: Sequence[int] | None,
    expressed_in: str | None,
) -> ChosenJacobian:
    """Return the Jacobian asked for; rows that are zero for every configuration are left out where no rows are named.

    Raises:
        ModelError: no such frame, row or column.
    """
    arm = algebra.arm
    assert arm is not None
    frame, expressed_in = arm.frame_names(arm.frames[-1] if frame is None else frame, expressed_in)
    count = len(arm.joints)
    if count > MOST_JOINTS:
        raise BeyondReach(
            "{count} joints; singularities are analysed for up to {most_joints}", count=count, most_joints=MOST_JOINTS
        )
    chosen_columns = _checked("columns", columns, count)
    taken = [c - 1 for c in chosen_columns]
    whole = algebra.jacobian(frame, expressed_in).block(range(6), taken)
    chosen_rows = (
        _task_rows(algebra.jacobian(frame, arm.frames[0]).block(range(6), taken))
        if rows is None
        else _checked("rows", rows, 6)
    )
    matrix = whole.block([r - 1 for r in chosen_rows], range(len(taken)))
    simple, transform, axes, point = _simplest(algebra, frame, expressed_in, chosen_rows, taken, matrix)
    return ChosenJacobian(arm, frame, expressed_in, chosen_rows, chosen_columns, matrix, simple, transform, axes, point)


def _task_rows(whole: Matrix) -> tuple[int, ...]:
    """Return the rows that are not always zero; of more rows than columns those of v, or of ω, if their rank is no lower."""
    width = whole.shape[1]
    used = tuple(r + 1 for r in range(6) if any(not cell.is_zero() for cell in whole.rows[r]))
    if len(used) <= width:
        return used
    for half in ((1, 2, 3), (4, 5, 6)):
        kept = tuple(r for r in used if r in half)
        if len(kept) >= width and exact_rank(whole.block([r - 1 for r in kept], range(width))) == width:
            return kept
    return used


def _checked(what: str, chosen: Sequence[int] | None, count: int) -> tuple[int, ...]:
    if chosen is None:
        return tuple(range(1, count + 1))
    values = tuple(chosen)
    if not values or len(set(values)) < len(values) or any(not 1 <= value <= count for value in values):
        raise ModelError("{what} of the Jacobian are different numbers from 1 to {count}, not {given}",
            what=what, count=count, given=str(list(values)))  # fmt: skip
    return values


def _simplest(
    algebra: ExactAlgebra, frame: str, expressed_in: str, rows: tuple[int, ...], columns: list[int], matrix: Matrix
) -> tuple[Matrix, Matrix | None, str, str]:
    """Return the Jacobian in the axes and at the point that give the fewest terms; the rank is the same in all.

    The axes may be changed where the rows are those of v, of ω or of both; the point where they are all six.
    """
    arm = algebra.arm
    assert arm is not None
    if rows not in ((1, 2, 3), (4, 5, 6), (1, 2, 3, 4, 5, 6)) or len(columns) < 3:
        return matrix, None, expressed_in, frame
    axes = min(arm.frames, key=lambda name: _terms(algebra.jacobian(frame, name).block([r - 1 for r in rows], columns)))
    turned = algebra.jacobian(frame, axes).block([r - 1 for r in rows], columns)
    points = arm.frames if len(rows) == 6 else (frame,)
    moved = {point: turned if point == frame else _moved(algebra, turned, frame, point, axes) for point in points}
    point = min(moved, key=lambda name: _terms(moved[name]))
    if _terms(moved[point]) >= _terms(matrix):
        return matrix, None, expressed_in, frame
    return moved[point], _transform(algebra, rows, frame, expressed_in, axes, point), axes, point


def _terms(matrix: Matrix) -> int:
    return sum(len(cell.numerator) for cell in matrix.cells)


def _moved(algebra: ExactAlgebra, jacobian: Matrix, frame: str, point: str, axes: str) -> Matrix:
    """Return the Jacobian of the point of the last link at the origin of `point`: v_k = v + ω × (p_k − p)."""
    offset = _offset(algebra, point, frame, axes)
    v, w = jacobian.block(range(3), range(jacobian.shape[1])), jacobian.block(range(3, 6), range(jacobian.shape[1]))
    return Matrix((*(v + -(_skew(offset) @ w)).rows, *w.rows))


def _offset(algebra: ExactAlgebra, to: str, start: str, axes: str) -> Matrix:
    """Return the way from the origin of one frame to that of another, in some axes."""
    ends = [algebra.pose(name, axes).block(range(3), [3]) for name in (to, start)]
    return ends[0] + -ends[1]


def _skew(vector: Matrix) -> Matrix:
    x, y, z = vector.vector(3)
    zero = x * 0
    return Matrix(((zero, -z, y), (z, zero, -x), (-y, x, zero)))


def _transform(
    algebra: ExactAlgebra, rows: tuple[int, ...], frame: str, expressed_in: str, axes: str, point: str
) -> Matrix:
    """Return X with J = X J_simple: v = R (v_k + ω × (p − p_k)), ω = R ω_simple."""
    rotation = algebra.pose(axes, expressed_in).block(range(3), range(3))
    if len(rows) == 3:
        return rotation
    corner = -(rotation @ _skew(_offset(algebra, frame, point, axes)))
    zero = rotation.map(lambda cell: cell * 0)
    return Matrix(
        (
            *(a + b for a, b in zip(rotation.rows, corner.rows, strict=True)),
            *(a + b for a, b in zip(zero.rows, rotation.rows, strict=True)),
        )
    )


def lost_from_simple(chosen: ChosenJacobian, vector: Matrix) -> Matrix:
    """Return the wrench w with wᵀJ = 0 from w_s with w_sᵀJ_s = 0: w = X⁻ᵀ w_s, X⁻ᵀ = [R, 0; −R[p]×…; R]."""
    if chosen.transform is None:
        return vector
    X = chosen.transform
    if len(chosen.rows) == 3:
        return X @ vector
    R = X.block(range(3), range(3))
    corner = X.block(range(3), range(3, 6))  # X⁻ᵀ = [R 0; −R cornerᵀ R, R]: from X = [R C; 0 R]
    below = -(R @ corner.transpose @ R)
    force, moment = vector.block(range(3), [0]), vector.block(range(3, 6), [0])
    return Matrix((*(R @ force).rows, *(below @ force + R @ moment).rows))
