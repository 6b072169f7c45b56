"""Exact numbers for the floats of a model file: rationals, square roots, and named constant angles.

A float left in a symbolic trace spoils the proof, so each one becomes exact before it enters: a coordinate the shortest
decimal within 1e-12, an entry of a rotation 0, ±1 or the square root of a rational, any other angle a pair
("cos", angle), ("sin", angle) with c² + s² = 1.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from math import cos, isfinite, pi, sin, sqrt

from armproof.models.errors import Fault, ModelError
from armproof.models.exact.polynomial import (
    ONE,
    ZERO,
    Entry,
    Generator,
    Rows,
    add,
    generator,
    matrix_product,
    multiply,
    number,
    root,
    root_value,
    scale,
    transpose,
)

TOLERANCE = 1e-12
IDENTITY: Rows = tuple(tuple(ONE if i == j else ZERO for j in range(3)) for i in range(3))
_HALF = Fraction(1, 2)
_TWELFTHS: dict[int, Entry] = {  # cos(k pi / 12)
    0: ONE,
    1: scale(add(root(6), root(2)), Fraction(1, 4)),
    2: scale(root(3), _HALF),
    3: scale(root(2), _HALF),
    4: number(_HALF),
    5: scale(add(root(6), scale(root(2), -1)), Fraction(1, 4)),
    6: ZERO,
}


def exact_number(value: float) -> Fraction:
    """Return the simplest rational within 1e-12: a short decimal, a small fraction, else a long decimal.

    Raises:
        ModelError: the value is not finite.
    """
    if not isfinite(value):
        raise ModelError(Fault.COORDINATE_NOT_FINITE, value=value)
    for digits in range(10):
        if abs(value - round(value, digits)) <= TOLERANCE:
            return Fraction(f"{value:.{digits}f}")
    simple = Fraction(value).limit_denominator(1000)
    if abs(value - simple) <= TOLERANCE:
        return simple
    return Fraction(f"{value:.12f}")


def cos_sin_of_pi(multiple: Fraction) -> tuple[Entry, Entry]:
    """Return the cosine and sine of `multiple` times pi.

    Multiples of pi/12 are radicals; any other angle is mirrored into the first quadrant and named: "2*pi/5".
    """
    turn = multiple % 2
    half_turn = min(turn, 2 - turn)
    rest = min(half_turn, 1 - half_turn)
    twelfth = rest * 12
    if twelfth.denominator == 1:
        cosine, sine = _TWELFTHS[int(twelfth)], _TWELFTHS[6 - int(twelfth)]
    else:
        name = ("pi" if rest.numerator == 1 else f"{rest.numerator}*pi") + f"/{rest.denominator}"
        cosine, sine = generator("cos", name), generator("sin", name)
    return scale(cosine, 1 if half_turn == rest else -1), scale(sine, 1 if turn == half_turn else -1)


def cos_sin_of_radians(angle: Fraction) -> tuple[Entry, Entry]:
    """Return the cosine and sine of a decimal number of radians, named by its absolute value: "0.3"."""
    if not angle:
        return ONE, ZERO
    name = _decimal(abs(angle))
    return generator("cos", name), scale(generator("sin", name), 1 if angle > 0 else -1)


def exact_cos_sin(angle: float) -> tuple[Entry, Entry]:
    """Return the cosine and sine of an angle in radians that was read as a float.

    Within 1e-12 of a rational multiple of pi (denominator up to 360) it is that multiple, else the decimal.
    """
    multiple = pi_multiple(angle)
    return cos_sin_of_radians(exact_number(angle)) if multiple is None else cos_sin_of_pi(multiple)


def pi_multiple(value: float) -> Fraction | None:
    """Return the rational multiple of pi, its denominator up to 360, that a value is within 1e-12; else None."""
    multiple = Fraction(value / pi).limit_denominator(360)
    return multiple if abs(value - float(multiple) * pi) <= TOLERANCE * max(1.0, abs(value)) else None


def square_of_root(value: float) -> Fraction | None:
    """Return the rational p/q, q up to 1000, of which ± the root is a value within 1e-12; else None."""
    square = Fraction(value * value).limit_denominator(1000)
    return square if abs(abs(value) - sqrt(square)) <= TOLERANCE else None


def add_angles(first: tuple[Entry, Entry], second: tuple[Entry, Entry]) -> tuple[Entry, Entry]:
    """Return the cosine and sine of the sum of two angles, each given by its cosine and sine."""
    (c1, s1), (c2, s2) = first, second
    cosine = add(multiply(c1, c2), scale(multiply(s1, s2), -1))
    return cosine, add(multiply(s1, c2), multiply(c1, s2))


def angle_value(name: str) -> float:
    """Return the radians of a numeric angle name: "2*pi/5", "pi/5" or "0.3"."""
    head, is_multiple, denominator = name.partition("pi/")
    if not is_multiple:
        return float(name)
    return int(head.rstrip("*") or 1) * pi / int(denominator)


def is_number(name: str) -> bool:
    """Whether the name of an angle is that of a number: "2*pi/5", "pi/5" or "0.3"."""
    return name[:1].isdigit() or name.startswith("pi/")


def constant_value(generator: Generator, values: Mapping[str, float]) -> float:
    """Return the number of a generator that no joint moves.

    Args:
        generator: a square root, a length, or the cosine or sine of a constant angle, named or numeric ("pi/5", "0.3").
        values: lengths (m) and angles (rad) by their symbols.
    """
    kind, name = generator
    if kind == "sqrt":
        return root_value(name)
    if kind == "symbol":
        return values[name]
    angle = values[name] if name in values else angle_value(name)
    return cos(angle) if kind == "cos" else sin(angle)


def rotation(axis: int, cos_sin: tuple[Entry, Entry]) -> Rows:
    """Return the elementary rotation about coordinate axis 0, 1 or 2 by an angle given by its cosine and sine."""
    cosine, sine = cos_sin
    rows = [list(row) for row in IDENTITY]
    i, j = (axis + 1) % 3, (axis + 2) % 3
    rows[i][i] = rows[j][j] = cosine
    rows[i][j], rows[j][i] = scale(sine, -1), sine
    return tuple(tuple(row) for row in rows)


def exact_rotation(matrix: Sequence[Sequence[float]]) -> Rows:
    """Return the exact rotation that a 3×3 float matrix stands for.

    Entries that are 0, ±1 or square roots of rationals are taken as such when the result is exactly orthonormal;
    otherwise R = Rz(yaw) Ry(pitch) Rx(roll), each angle made exact by `exact_cos_sin`.
    """
    rows = tuple(tuple(_radical(float(value)) for value in row) for row in matrix)
    if all(entry is not None for row in rows for entry in row):
        exact: Rows = tuple(tuple(entry for entry in row if entry is not None) for row in rows)
        if matrix_product(exact, transpose(exact)) == IDENTITY:
            return exact
    from pydrake.math import RollPitchYaw, RotationMatrix

    roll_pitch_yaw = RollPitchYaw(RotationMatrix(matrix)).vector()
    roll, pitch, yaw = (rotation(axis, exact_cos_sin(float(angle))) for axis, angle in enumerate(roll_pitch_yaw))
    return matrix_product(matrix_product(yaw, pitch), roll)


def _radical(value: float) -> Entry | None:
    """Return ±√(p/q) with q ≤ 1000 if the value is that within 1e-12, else None."""
    square = square_of_root(value)
    return None if square is None else scale(root(square), 1 if value > 0 else -1)


def _decimal(value: Fraction) -> str:
    """Return a rational as decimal text without trailing zeros: 3/10 as "0.3"."""
    return f"{float(value):.15f}".rstrip("0").rstrip(".")
