"""Whether a matrix that is to be a rotation or a pose is one: a name with two frames, {}^A_BR, gets no other meaning."""

from __future__ import annotations

from collections.abc import Iterator

from armproof.verification.algebra.matrix import Matrix, is_zero
from armproof.verification.algebra.ring import Scalar
from armproof.verification.latex import nodes as n

TRIGONOMETRIC = ("cos", "sin", "pi", "sqrt")


def is_rotation(matrix: Matrix) -> bool:
    """Whether RᵀR = I and det R = 1."""
    square = (matrix.transpose @ matrix).rows
    orthonormal = all(is_zero(cell - int(r == c)) for r, row in enumerate(square) for c, cell in enumerate(row))
    return orthonormal and is_zero(matrix.determinant() - 1)


def is_pose(matrix: Matrix) -> bool:
    """Whether a square matrix is a rotation and a translation above a row of 0 … 0 1."""
    size, last = matrix.shape[0] - 1, matrix.rows[-1]
    ends = all(is_zero(cell) for cell in last[:-1]) and is_zero(last[-1] - 1)
    return ends and is_rotation(matrix.block(range(size), range(size)))


def misses_group(name: n.Node, value: object) -> str:
    """Return the group that a name with two frames belongs to and its matrix does not; "" where it does, or nobody can tell.

    Letters in the rotation, and numbers that are rounded, leave it open; in the plane a pose has three rows.
    """
    if not isinstance(name, n.Name) or name.base not in ("R", "T", "A", "H") or not _has_two_frames(name):
        return ""
    if not isinstance(value, Matrix) or value.shape not in ((3, 3), (4, 4)):
        return ""
    turns = value.block(range(3), range(3)) if value.shape == (4, 4) else value
    if not of_angles(turns):
        return ""
    if is_pose(value) or (value.shape == (3, 3) and is_rotation(value)):
        return ""
    return "SE(3)" if value.shape == (4, 4) else "SO(3)"


def of_angles(turns: Matrix) -> bool:
    """Whether a matrix holds numbers and sines and cosines alone."""
    return all(
        isinstance(cell, Scalar) and all(kind in TRIGONOMETRIC for kind, _ in cell.generators) for cell in turns.cells
    )


def mends_of(value: Matrix) -> Iterator[tuple[Matrix, tuple[int, int]]]:
    """Yield the rotations and poses with another entry in one place, and that place.

    Each entry of a rotation is its own cofactor. What is orthonormal and turns right into left is a reflection, and has no slip; nor has
    a number, which may be a scale, but for a 0, 1 or -1 of a pose.
    """
    turns = value.block(range(3), range(3))
    if is_zero(turns.determinant() + 1):
        return
    cofactors = turns.cofactors()
    for r, c in turns.places:
        printed, correct = turns.rows[r][c], cofactors.rows[r][c]
        may_slip = _has_angle(printed) and _has_angle(correct)
        may_slip = may_slip or (value.shape == (4, 4) and _is_of_axes(printed) and _is_of_axes(correct))
        if not may_slip or is_zero(printed - correct):
            continue
        row = (*value.rows[r][:c], correct, *value.rows[r][c + 1 :])
        mended = Matrix((*value.rows[:r], row, *value.rows[r + 1 :]))
        if is_pose(mended) if value.shape == (4, 4) else is_rotation(mended):
            yield mended, (r, c)


def _has_angle(cell: object) -> bool:
    return isinstance(cell, Scalar) and any(kind in ("cos", "sin") for kind, _ in cell.generators)


def _is_of_axes(cell: object) -> bool:
    """Whether an entry is one of a rotation by right angles: 0, 1 or -1."""
    return isinstance(cell, Scalar) and cell.normal().as_fraction() in (0, 1, -1)


def _has_two_frames(name: n.Name) -> bool:
    return bool(name.pre_sup and (name.pre_sub or name.sub)) or bool(name.sup and name.sub and not name.pre_sub)


def is_none_by_a_slip(true: Matrix, printed: Matrix) -> bool:
    """Whether what is printed for a rotation, a pose or an axis is none, and one entry away from one: then no arm has it.

    Letters other than angles, and numbers that may be rounded, leave it open.
    """
    turns = [each.block(range(3), range(3)) if each.shape == (4, 4) else each for each in (true, printed)]
    if true.shape != printed.shape or not all(map(of_angles, turns)) or any(map(_may_be_rounded, turns[1].cells)):
        return False
    is_one = {(3, 3): is_rotation, (4, 4): is_pose, (3, 1): _is_unit}.get(true.shape)
    if is_one is None or not is_one(true) or is_one(printed):
        return False
    wrong = sum(not is_zero(a - b) for a, b in zip(turns[0].cells, turns[1].cells, strict=True))
    return wrong == 1 or (true.shape != (3, 1) and any(mends_of(printed)))


def _is_unit(axis: Matrix) -> bool:
    return is_zero((axis.transpose @ axis).rows[0][0] - 1)


def _may_be_rounded(cell: object) -> bool:
    number = cell.as_fraction() if isinstance(cell, Scalar) else None
    return number is not None and number.denominator > 1
