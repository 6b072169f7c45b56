"""Links whose matrices are none of DH: a joint that turns about an axis of the frame before it, beside a point anywhere.

    {}^{i-1}T_i = Trans(p) Rot(k, θ_i),  k = x, y, z,  p constant

as URDF files and many reports have them. Rows of the classic convention make each of them, with steps between in which nothing
moves: Rot(y, θ) = Rot(x, -π/2) Rot(z, θ) Rot(x, π/2), Rot(x, θ) = B Rot(z, θ) B^{-1} with B = Rot(z, π/2) Rot(x, π/2).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from armproof.verification.algebra.calculus import symbols_in
from armproof.verification.algebra.matrix import Matrix
from armproof.verification.algebra.ring import Scalar
from armproof.verification.tables.arms.candidate import entry_text
from armproof.verification.tables.row import RightRow, right_row

Row = dict[str, str]
_THETA = "theta"


def turned_about(pose: Matrix, joints: Sequence[str]) -> tuple[str, RightRow] | None:
    """Return the axis, x, y or z, about which a link turns, and its angle; None where it is no such link, or moves its point."""
    if not symbols_in(row[3] for row in pose.rows).isdisjoint(joints):
        return None
    for axis, (first, second, along) in (("z", (0, 1, 2)), ("y", (2, 0, 1)), ("x", (1, 2, 0))):
        found = right_row(_seen_along(pose, (first, second, along)), "classic", joints)
        is_plain = found is not None and found.a.is_zero() and found.d.is_zero() and (found.alpha[0] - 1).is_zero()
        if found is not None and is_plain and not symbols_in(found.theta).isdisjoint(joints):
            return axis, found
    return None


def _seen_along(pose: Matrix, axes: tuple[int, int, int]) -> Matrix:
    """Return the rotation of a pose with its axes in another order, the last of them as z, and no point."""
    zero, one = pose.rows[3][0], pose.rows[3][3]
    turned = (tuple(pose.rows[i][k] for k in axes) for i in axes)
    return Matrix((*((*row, zero) for row in turned), (zero, zero, zero, one)))


def rows_about(axis: str, theta: Scalar, point: Sequence[Scalar]) -> list[Row]:
    """Return the rows of Trans(p) Rot(k, θ), the joint's among them; raises EvaluationError where a coordinate is no entry."""
    x, y, z = map(entry_text, point)
    turn = entry_text(theta)
    if axis == "y":
        return [_row(x, "-pi/2", z, "0"), _row("0", "pi/2", y, turn)]
    if axis == "x":
        return [_row(y, "pi/2", z, "pi/2"), _row("0", "-pi/2", x, turn), _row("0", "0", "0", "-pi/2")]
    if y == "0":
        return [_row(x, "0", z, "0"), _row("0", "0", "0", turn)]
    return [_row(y, "0", z, "pi/2"), _row(x, "0", "0", "-pi/2"), _row("0", "0", "0", turn)]


def _row(a: str, alpha: str, d: str, theta: str) -> Row:
    return {"a": a, "alpha": alpha, "d": d, _THETA: theta}


def frames_of(links: Sequence[tuple[int, Sequence[Mapping[str, str]]]]) -> tuple[str, ...]:
    """Return the names of all frames: the last of each link's has its number, those between have letters, 2a."""
    first = links[0][0] - 1
    behind = (
        f"{index}{chr(ord('a') + step)}" if step < len(rows) - 1 else str(index)
        for index, rows in links
        for step in range(len(rows))
    )
    return (str(first), *behind)
