"""One row of a DH table as exact values: its link matrix, and the row that two frames of an arm call for.

classic:  {}^{i-1}T_i = Rot_z(θ_i) Trans_z(d_i) Trans_x(a_i) Rot_x(α_i) (Denavit & Hartenberg 1955)
modified: {}^{i-1}T_i = Rot_x(α_{i-1}) Trans_x(a_{i-1}) Rot_z(θ_i) Trans_z(d_i) (Khalil & Kleinfinger 1986; Craig)
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from verification.algebras import Algebra
from verification.errors import EvaluationError
from verification.matrix import Matrix
from verification.trig import Ring, Scalar

PARAMETERS = ("a", "alpha", "d", "theta")
ANGLES = ("alpha", "theta")
SCALES = {"mm": Fraction(1, 1000), "cm": Fraction(1, 100)}  # metres, by the unit of a header
Angle = tuple[Scalar, Scalar]  # the cosine and the sine


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
            cosine, sine = value.ring.cos_sin(value)
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
    names = set(variables)
    if any(name in names for part in alpha for name in _names(part)):
        return None
    made = _matrix_of(convention, a, alpha, d, theta, a.ring.zero, a.ring.one)
    same = all(
        (x - y).is_zero() for row, other in zip(made.rows, t, strict=True) for x, y in zip(row, other, strict=True)
    )
    return RightRow(a, alpha, d, theta) if same else None


def _matrix_of(
    convention: str, a: Any, alpha: tuple[Any, Any], d: Any, theta: tuple[Any, Any], zero: Any, one: Any
) -> Matrix:
    """The link matrix from the cosines and sines of the angles."""
    (ct, st), (ca, sa) = theta, alpha
    if convention == "modified":
        rows = ((ct, -st, zero, a), (st * ca, ct * ca, -sa, -d * sa), (st * sa, ct * sa, ca, d * ca))
    else:
        rows = ((ct, -st * ca, st * sa, a * ct), (st, ct * ca, -ct * sa, a * st), (zero, sa, ca, d))
    return Matrix((*rows, (zero, zero, zero, one)))


def _names(value: Scalar) -> Iterator[str]:
    for polynomial in (value.numerator, value.denominator):
        for powers, _ in value.ring.terms(polynomial):
            yield from (name for _, name in powers)


def is_free_of(value: Scalar, names: Iterable[str]) -> bool:
    """Whether none of these symbols occurs in a value, nor the cosine or sine of one."""
    return not set(names) & set(_names(value))


def rational_part(value: Scalar) -> Fraction:
    """Return the constant term of a value: 90 in θ_2 − 90."""
    if not value.denominator.is_one():
        return Fraction(0)
    return next((coefficient for powers, coefficient in value.ring.terms(value.numerator) if not powers), Fraction(0))


def to_radians(value: Scalar, unit: str) -> tuple[Scalar, str]:
    """Return an angle in radians, and a note where its constant is taken to be in degrees without the header saying so."""
    constant = rational_part(value)
    if not constant or unit == "rad":
        return value, ""
    if unit == "deg":
        return in_radians(value), ""
    if constant.denominator != 1 or constant % 15 or abs(constant) > 360:
        return value, ""
    return in_radians(value), f"the angle {constant} is read in degrees"


def in_radians(value: Scalar) -> Scalar:
    """Return a value whose constant term is in degrees with that term in radians."""
    degrees = rational_part(value)
    ring = value.ring
    return value - ring.rational(degrees) + ring.rational(degrees / 180) * ring.generator(("pi", ""))


def within_a_turn(angle: Scalar, more: Fraction) -> Scalar:
    """Return an angle and `more` half turns, its multiple of π brought into (−1, 1]."""
    terms = angle.ring.terms(angle.numerator) if angle.denominator.is_one() else ()
    printed = next((coefficient for powers, coefficient in terms if powers == {("pi", ""): 1}), Fraction(0))
    wanted = 1 - (1 - printed - more) % 2
    return angle + angle.ring.generator(("pi", "")) * angle.ring.rational(wanted - printed)


def constant_angle(ring: Ring, name: str) -> Scalar:
    """Return a constant angle of the trace, "2*pi/5" or "0.3" (rad)."""
    times, is_pi, parts = re.fullmatch(r"([\d.e+-]*)\*?(pi)?/?(\d*)", name).groups()  # type: ignore[union-attr]
    size = ring.rational(Fraction(times or 1) / int(parts or 1))
    return size * ring.generator(("pi", "")) if is_pi else size


def angle_as_scalar(
    ring: Ring, angle: Angle, symbols: Iterable[str], constants: Iterable[Scalar] = ()
) -> Scalar | None:
    """Return an angle of known cosine and sine as ±symbol + k·π/12 (k·π/2 where that will do), or None."""
    zero, pi = ring.zero, ring.generator(("pi", ""))
    bases = [zero, *(ring.symbol(symbol) for symbol in symbols), *constants]
    for step in (Fraction(1, 2), Fraction(1, 12)):
        for base in bases:
            for signed in (base, -base) if base is not zero else (base,):
                cosine, sine = ring.cos_sin(signed)
                # what is left of the angle must be a constant: cos(angle − base), sin(angle − base)
                left = (angle[0] * cosine + angle[1] * sine, angle[1] * cosine - angle[0] * sine)
                if step == Fraction(1, 2) and left[0].as_fraction() is None:
                    continue
                for k in sorted(range(int(-1 / step) + 1, int(1 / step) + 1), key=abs):
                    turn = ring.cos_sin(pi * ring.rational(step * k))
                    if (left[0] - turn[0]).is_zero() and (left[1] - turn[1]).is_zero():
                        return signed + pi * ring.rational(step * k)
    return None
