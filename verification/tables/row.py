"""One row of a DH table as exact values: its link matrix, and the row that two frames of an arm call for.

classic:  {}^{i-1}T_i = Rot_z(θ_i) Trans_z(d_i) Trans_x(a_i) Rot_x(α_i) (Denavit & Hartenberg 1955)
modified: {}^{i-1}T_i = Rot_x(α_{i-1}) Trans_x(a_{i-1}) Rot_z(θ_i) Trans_z(d_i) (Khalil & Kleinfinger 1986; Craig)
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from armproof.verification.algebra.angles import cos_sin
from armproof.verification.algebra.calculus import symbols_in
from armproof.verification.algebra.matrix import Matrix, is_zero
from armproof.verification.algebra.protocol import Algebra
from armproof.verification.algebra.ring import Scalar
from armproof.verification.errors import EvaluationError
from armproof.verification.tables.angles import Angle

PARAMETERS = ("a", "alpha", "d", "theta")
ANGLES = ("alpha", "theta")
SCALES = {"mm": Fraction(1, 1000), "cm": Fraction(1, 100)}  # metres, by the unit of a header


@dataclass(frozen=True)
class RightRow:
    """The parameters that take one frame to the next: lengths as scalars, angles as (cos, sin)."""

    a: Scalar
    alpha: Angle
    d: Scalar
    theta: Angle

    def agrees(self, parameter: str, value: Scalar) -> bool:
        """Decide whether a printed value is this one; angles are compared modulo whole turns."""
        right = getattr(self, parameter)
        if parameter not in ANGLES:
            return (value - right).is_zero()
        try:
            cosine, sine = cos_sin(value)
        except EvaluationError:
            return False
        return (cosine - right[0]).is_zero() and (sine - right[1]).is_zero()


def row_matrix(algebra: Algebra, convention: str, a: Any, alpha: Any, d: Any, theta: Any) -> Matrix:
    """Return the link matrix {}^{i-1}T_i of a row, 4×4, in either algebra."""
    zero, one = algebra.rational(Fraction(0)), algebra.rational(Fraction(1))
    return _matrix_of(convention, a, algebra.cos_sin(alpha), d, algebra.cos_sin(theta), zero, one)


def right_row(pose: Matrix, convention: str, variables: Iterable[str]) -> RightRow | None:
    """Return the row of the convention whose link matrix is `pose`, or None where the frames are not such DH frames.

    A row is unique, angles modulo whole turns. `variables`: the joint variables, on which the twist must not depend.
    """
    t = pose.rows
    if convention == "modified":
        theta, alpha = (t[0][0], -t[0][1]), (t[2][2], -t[1][2])
        a, d = t[0][3], alpha[0] * t[2][3] - alpha[1] * t[1][3]
    else:
        theta, alpha = (t[0][0], t[1][0]), (t[2][2], t[2][1])
        a, d = theta[0] * t[0][3] + theta[1] * t[1][3], t[2][3]
    if not symbols_in(alpha).isdisjoint(variables):
        return None
    made = _matrix_of(convention, a, alpha, d, theta, a.ring.zero, a.ring.one)
    return RightRow(a, alpha, d, theta) if equal(made, pose) else None


def equal(one: Matrix, other: Matrix) -> bool:
    """Decide whether two matrices of one shape are equal."""
    return is_zero(one + -other)


def _matrix_of(
    convention: str, a: Any, alpha: tuple[Any, Any], d: Any, theta: tuple[Any, Any], zero: Any, one: Any
) -> Matrix:
    """Return the link matrix from the cosines and sines of the angles."""
    (ct, st), (ca, sa) = theta, alpha
    if convention == "modified":
        rows = ((ct, -st, zero, a), (st * ca, ct * ca, -sa, -d * sa), (st * sa, ct * sa, ca, d * ca))
    else:
        rows = ((ct, -st * ca, st * sa, a * ct), (st, ct * ca, -ct * sa, a * st), (zero, sa, ca, d))
    return Matrix((*rows, (zero, zero, zero, one)))
