"""Angles of a table: an angle is found again from its cosine and sine, whatever is added to a letter."""

from __future__ import annotations

from fractions import Fraction

import pytest

from armproof.verification.algebra.angles import cos_sin
from armproof.verification.algebra.ring import Ring, Scalar
from armproof.verification.findings import Kind
from armproof.verification.tables.angles import (
    angle_as_scalar,
    change_of_angle,
    change_of_length,
    constant_angle,
    to_radians,
    within_a_turn,
)

RING = Ring()
PI, THETA, BETA = RING.generator(("pi", "")), RING.symbol("theta_1"), RING.symbol("beta")
A1, A2 = RING.symbol("a_1"), RING.symbol("a_2")


def turned(turns: Fraction) -> Scalar:
    return PI * RING.rational(turns)


@pytest.mark.parametrize("base", [RING.zero, THETA, -THETA, BETA], ids=["0", "+", "-", "other"])
def test_a_letter_and_a_multiple_of_a_twelfth_of_pi_is_found(base: Scalar) -> None:
    for twelfths in range(-11, 13):
        angle = base + turned(Fraction(twelfths, 12))
        found = angle_as_scalar(RING, cos_sin(angle), [THETA, BETA])
        assert found is not None and (found - angle).is_zero()


@pytest.mark.parametrize("angle", [THETA * 2, THETA + BETA, THETA + turned(Fraction(1, 5)), turned(Fraction(1, 7))])
def test_any_other_angle_is_not(angle: Scalar) -> None:
    assert angle_as_scalar(RING, cos_sin(angle), [THETA, BETA]) is None
    assert angle_as_scalar(RING, cos_sin(THETA), [BETA]) is None


@pytest.mark.parametrize(
    ("printed", "more", "within"),
    [(1, 0, 1), (-1, 0, 1), (3, 0, 1), (Fraction(-3, 2), 0, Fraction(1, 2)), (Fraction(1, 2), 1, Fraction(-1, 2))],
)
def test_a_multiple_of_pi_is_brought_within_a_turn(printed: Fraction, more: Fraction, within: Fraction) -> None:
    assert (
        within_a_turn(THETA + turned(Fraction(printed)), Fraction(more)) - THETA - turned(Fraction(within))
    ).is_zero()


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("pi/2", turned(Fraction(1, 2))),
        ("2*pi/5", turned(Fraction(2, 5))),
        ("pi", PI),
        ("0.3", RING.rational(Fraction("0.3"))),
    ],
)
def test_a_constant_angle_has_its_value(name: str, value: Scalar) -> None:
    assert (constant_angle(RING, name) - value).is_zero()


@pytest.mark.parametrize(
    ("value", "unit", "turns", "is_said"),
    [
        (90, "", Fraction(1, 2), True),
        (-360, "", -2, True),
        (90, "deg", Fraction(1, 2), False),
        (7, "deg", Fraction(7, 180), False),
        (7, "", None, False),
        (375, "", None, False),
        (90, "rad", None, False),
        (0, "", 0, False),
    ],
)
def test_degrees_are_what_a_header_says_or_a_multiple_of_15(
    value: int, unit: str, turns: int | None, is_said: bool
) -> None:
    angle, said = to_radians(THETA + value, unit)
    assert (angle - THETA - (value if turns is None else turned(Fraction(turns)))).is_zero()
    assert (said is not None and said.kind is Kind.READ_IN_DEGREES) == is_said


@pytest.mark.parametrize(
    ("printed", "right", "kind"),
    [
        (-THETA, THETA, Kind.THE_SIGN),
        (THETA + 90, THETA + turned(Fraction(1, 2)), Kind.DEGREES_FOR_RADIANS),
        (RING.rational(Fraction("1.57")), turned(Fraction(1, 2)), Kind.ROUNDED),
        (RING.rational(Fraction("1.5")), turned(Fraction(1, 2)), None),
        (THETA, THETA + turned(Fraction(1, 2)), Kind.THE_OFFSET),
        (THETA - BETA, THETA + BETA, Kind.A_SIGN),
        (RING.symbol("theta_2"), THETA, Kind.THE_INDEX),
        (RING.symbol("q_1"), THETA, Kind.LETTER_FOR_LETTER),
        (THETA + BETA, THETA, Kind.LETTER_EXTRA),
        (THETA, THETA + BETA, Kind.LETTER_MISSING),
    ],
)  # fmt: skip
def test_what_is_wrong_with_an_angle_is_named(printed: Scalar, right: Scalar, kind: Kind | None) -> None:
    found = change_of_angle(printed, right)
    assert (found and found.kind) == kind


@pytest.mark.parametrize(
    ("printed", "right", "kind"),
    [
        (-A1, A1, Kind.THE_SIGN),
        (RING.zero, A1, Kind.IS_MISSING),
        (A1, RING.zero, Kind.SHOULD_VANISH),
        (A2, A1, Kind.THE_INDEX),
        (A1 * 2, A1, Kind.A_FACTOR),
        (A1 - A2, A1 + A2, Kind.A_SIGN),
        (A1 * RING.generator(("sqrt", "2")), A1, None),
        (RING.one / A1, A1, None),
        (RING.one, RING.one * 2, None),
    ],
)
def test_what_is_wrong_with_a_length_is_named(printed: Scalar, right: Scalar, kind: Kind | None) -> None:
    found = change_of_length(printed, right)
    assert (found and found.kind) == kind
