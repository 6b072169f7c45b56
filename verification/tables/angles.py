"""Angles of a table: in radians or degrees, and from a cosine and sine back to an expression."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable
from fractions import Fraction

from armproof.verification.algebra.angles import cos_sin
from armproof.verification.algebra.matrix import Matrix
from armproof.verification.algebra.ring import Ring, Scalar
from armproof.verification.findings import Finding, Kind, say
from armproof.verification.latex.reader import key_as_latex

ROUNDED = 5e-3  # rad: 1.57 for π/2
TWELFTHS = sorted((Fraction(k, 12) for k in range(-11, 13)), key=abs)
Angle = tuple[Scalar, Scalar]  # the cosine and the sine


def rational_part(value: Scalar) -> Fraction:
    """Return the constant term of a value: 90 in θ_2 − 90."""
    if not value.denominator.is_one():
        return Fraction(0)
    return next((coefficient for powers, coefficient in value.ring.terms(value.numerator) if not powers), Fraction(0))


def in_radians(value: Scalar) -> Scalar:
    """Return a value whose constant term is in degrees with that term in radians."""
    degrees, ring = rational_part(value), value.ring
    return value - degrees + ring.rational(degrees / 180) * ring.generator(("pi", ""))


def to_radians(value: Scalar, unit: str) -> tuple[Scalar, Finding | None]:
    """Return an angle in radians, and a note where its constant is taken to be in degrees without the header saying so."""
    constant = rational_part(value)
    if unit == "deg":
        return in_radians(value), None
    if not constant or unit == "rad" or constant % 15 or abs(constant) > 360:
        return value, None
    return in_radians(value), say(Kind.READ_IN_DEGREES, angle=str(constant))


def with_parts_of_pi(angle: Scalar) -> Scalar:
    """Return an angle in radians with k π/12 for a number of four decimals or more that is that, 1.5708: no equation means another."""
    constant = rational_part(angle)
    decimals = next((n for n in range(10) if (constant * 10**n).denominator == 1), 0)
    turns = Fraction(round(float(constant) * 12 / math.pi), 12)
    if decimals < 4 or abs(float(constant) - float(turns) * math.pi) > 0.5 * 10.0**-decimals + 1e-12:
        return angle
    ring = angle.ring
    return angle - ring.rational(constant) + ring.generator(("pi", "")) * ring.rational(turns)


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


def angle_as_scalar(ring: Ring, angle: Angle, bases: Iterable[Scalar]) -> Scalar | None:
    """Return an angle of known cosine and sine as ±base + k·π/12, or None."""
    pi = ring.generator(("pi", ""))
    for base in (ring.zero, *(sign * base for base in bases for sign in (1, -1))):
        cosine, sine = cos_sin(base)
        # what is left of the angle must be a constant: cos(angle − base), sin(angle − base)
        left = (angle[0] * cosine + angle[1] * sine, angle[1] * cosine - angle[0] * sine)
        if any(kind != "sqrt" for kind, _ in left[0].generators):
            continue
        for turn in TWELFTHS:
            made = cos_sin(pi * ring.rational(turn))
            if (left[0] - made[0]).is_zero() and (left[1] - made[1]).is_zero():
                return base + pi * ring.rational(turn)
    return None


def roll_pitch_yaw(roll: Angle, pitch: Angle, yaw: Angle) -> Matrix:
    """Return Rz(yaw) Ry(pitch) Rx(roll), 3×3, of angles about fixed axes, as a URDF has them."""
    (cr, sr), (cp, sp), (cy, sy) = roll, pitch, yaw
    zero, one = cr.ring.zero, cr.ring.one
    Rz = Matrix(((cy, -sy, zero), (sy, cy, zero), (zero, zero, one)))
    Ry = Matrix(((cp, zero, sp), (zero, one, zero), (-sp, zero, cp)))
    return Rz @ Ry @ Matrix(((one, zero, zero), (zero, cr, -sr), (zero, sr, cr)))


def change_of_length(printed: Scalar, right: Scalar) -> Finding | None:
    """Return what is wrong with a printed length; None where it is nothing short."""
    return say(Kind.THE_SIGN) if (printed + right).is_zero() else _change_of_terms(printed, right)


def change_of_angle(printed: Scalar, right: Scalar) -> Finding | None:
    """Return what is wrong with a printed angle; `right` as a sum of symbols and a multiple of π."""
    if _same_angle(printed, -right):
        return say(Kind.THE_SIGN)
    if rational_part(printed) and _same_angle(in_radians(printed), right):
        return say(Kind.DEGREES_FOR_RADIANS)
    if _is_rounded(printed - right):
        return say(Kind.ROUNDED)
    if symbols_of(printed) and _signs(printed) == _signs(right):
        return say(Kind.THE_OFFSET)
    if printed.is_zero() or right.is_zero():
        return _change_of_terms(printed, right)
    for kind, scaled in ((Kind.HALF_OF_IT, right / 2), (Kind.TWICE_IT, right * 2)):
        if (printed - scaled).is_zero():
            return say(kind)
    return _change_of_terms(printed, right)


def _same_angle(one: Scalar, other: Scalar) -> bool:
    cosine, sine = cos_sin(one - other)
    return (cosine - 1).is_zero() and sine.is_zero()


def _is_rounded(difference: Scalar) -> bool:
    """Whether a difference is a decimal and a multiple of π that nearly cancel."""
    terms = {tuple(powers): float(c) for powers, c in difference.ring.terms(difference.normal().numerator)}
    if terms.keys() != {(), (("pi", ""),)}:
        return False
    return abs(terms[()] + math.pi * terms[("pi", ""),]) < ROUNDED


def _change_of_terms(printed: Scalar, right: Scalar) -> Finding | None:
    if printed.is_zero():
        return say(Kind.IS_MISSING)
    if right.is_zero():
        return say(Kind.SHOULD_VANISH)
    one, other = symbols_of(printed), symbols_of(right)
    gone, more = sorted(other - one), sorted(one - other)
    if len(gone) == len(more) == 1:
        is_index = letter_of(gone[0]) == letter_of(more[0])
        return (
            say(Kind.THE_INDEX)
            if is_index
            else say(Kind.LETTER_FOR_LETTER, printed=key_as_latex(more[0]), correct=key_as_latex(gone[0]))
        )
    if len(gone) == 1 and not more:
        return say(Kind.LETTER_MISSING, letter=key_as_latex(gone[0]))
    if len(more) == 1 and not gone:
        return say(Kind.LETTER_EXTRA, letter=key_as_latex(more[0]))
    if one and _signs(printed).keys() == _signs(right).keys():  # √2 l_1 and l_1 have no term in common
        return say(Kind.A_SIGN if _signs(printed) != _signs(right) else Kind.A_FACTOR)
    return None


def letter_of(symbol: str) -> str:
    """Return a symbol without its index."""
    return symbol.partition("_")[0]


def symbols_of(value: Scalar) -> set[str]:
    """Return the symbols of a sum."""
    return {name for kind, name in value.generators if kind == "symbol"}


def _signs(value: Scalar) -> dict[str, bool]:
    """Which terms with a symbol are negative."""
    return {
        " ".join(sorted(name for _, name in powers)): c < 0
        for powers, c in value.ring.terms(value.numerator)
        if any(kind == "symbol" for kind, _ in powers)
    }
