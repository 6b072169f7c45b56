"""The roots of squares: a square that has lost its form in the ring is found, and its root has the sign it must have."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

import pytest

from armproof.verification.algebra.angles import cos_sin
from armproof.verification.algebra.ring import Ring
from armproof.verification.algebra.roots import atan2, is_negative, sqrt
from armproof.verification.verdict import Record, Verdict

Judge = Callable[..., Record]
REACH = r"\rho = a_3 C_2 - d_3 S_{23}"
RX90 = {
    "arm": "rx90",
    "quantities": {"P_x": {"origin": 6, "component": "x"}, "P_y": {"origin": 6, "component": "y"}},
}


@pytest.mark.parametrize(
    ("latex", "verdict"),
    [
        (r"\sqrt{S_5^4} = S_5^2", Verdict.PROVED),
        (r"\sqrt{S_5^4} = -S_5^2", Verdict.REFUTED),
        (r"\sqrt{S_5^2} = S_5", Verdict.REFUTED),
        (r"\sqrt{(2 - C_5)^2} = 2 - C_5", Verdict.PROVED),
        (r"\sqrt{(C_5 - 2)^2} = C_5 - 2", Verdict.REFUTED),
        (r"\sqrt{a_3^2 d_3^2} = a_3 d_3", Verdict.PROVED),
    ],
)
def test_the_root_of_a_square_is_not_negative(judge: Judge, latex: str, verdict: Verdict) -> None:
    assert judge(latex, arm="rx90").verdict is verdict


@pytest.mark.parametrize(
    ("latex", "verdict"),
    [
        (r"\theta_1 = \operatorname{atan2}(\rho P_y, \rho P_x)", Verdict.PROVED),
        (r"\theta_1 = \operatorname{atan2}(\rho^3 P_y, \rho^3 P_x)", Verdict.PROVED),
        (r"\theta_1 + \pi = \operatorname{atan2}(-\rho P_y, -\rho P_x)", Verdict.PROVED),
        (r"\theta_1 = \operatorname{atan2}(P_y, P_x)", Verdict.CONFIRMED),  # on one branch: ρ > 0
        (r"\theta_1 = \operatorname{atan2}(-\rho P_y, -\rho P_x)", Verdict.REFUTED),
        (r"\theta_1 = \operatorname{atan2}(\rho P_x, \rho P_y)", Verdict.REFUTED),
        (r"\theta_1 = \operatorname{atan2}(\rho P_y, P_x)", Verdict.REFUTED),
    ],
)
def test_a_square_common_to_sine_and_cosine_leaves_the_angle(judge: Judge, latex: str, verdict: Verdict) -> None:
    shown = r"\rho + d_3 S_{23} = a_3 C_2", r"\theta_1 = \operatorname{atan2}(\rho P_y, \rho P_x)"
    record = judge(REACH, *shown, latex, **RX90)
    assert record.verdict is verdict, record.message
    if verdict is Verdict.CONFIRMED:
        assert "one branch" in record.message


def test_nothing_is_not_negative() -> None:
    ring = Ring()
    assert is_negative(ring, (ring.zero - 1).numerator)
    assert not is_negative(ring, ring.zero.numerator)


RING = Ring()
A, B, PI = RING.symbol("a"), RING.symbol("b"), RING.generator(("pi", ""))
C, S = cos_sin(RING.symbol("theta_1"))
HALF, TWO, FIFTH = (cos_sin(angle)[0] for angle in (RING.rational(Fraction(1, 2)), RING.rational(2), PI / 5))


@pytest.mark.parametrize(
    "positive",
    [
        PI - 3, 4 - PI, HALF - Fraction(3, 5), Fraction(9, 10) - HALF, FIFTH - Fraction(4, 5), 1 - FIFTH, -TWO, TWO + 1,
        2 - C, A + B,
    ],
)  # fmt: skip
def test_of_two_roots_the_positive_one_is_taken_where_the_sign_is_known(positive) -> None:
    assert (sqrt(positive * positive) - positive).is_zero()
    assert (atan2(positive * S, positive * C) - atan2(S, C)).is_zero()
    assert (atan2(-positive * S, -positive * C) - atan2(-S, -C)).is_zero()


@pytest.mark.parametrize(
    ("value", "chosen"),
    [(A * A, False), (A**3, False), (A * A * C, False), (C + 2, False), (C * C, True), ((A - B) ** 2, True), (4 * A * A * B**4, False), (sqrt(A + 1) ** 2, False)],
)  # fmt: skip
def test_a_ring_remembers_that_the_sign_of_a_root_was_chosen(value, chosen: bool) -> None:
    RING.forget_signs()
    sqrt(value)
    assert RING.signs_chosen is chosen
    RING.forget_signs()
    assert not RING.signs_chosen and not Ring().signs_chosen


@pytest.mark.parametrize(("common", "chosen"), [(A, False), (A * B, False), (C, True), (C + 2, True)])
def test_a_common_factor_of_an_angle_is_taken_as_positive(common, chosen: bool) -> None:
    RING.forget_signs()
    assert (atan2(common * S, common * (C + 3)) - atan2(S, C + 3)).is_zero()
    assert RING.signs_chosen is chosen


def test_what_holds_a_root_has_no_sign_that_is_known() -> None:
    assert not is_negative(RING, (sqrt(A + 1) - 100).numerator)
    assert not is_negative(RING, (atan2(A, B) - 100).numerator)


def test_an_angle_is_known_by_its_cosine_and_its_sine() -> None:
    for turns, y, x in (
        (0, 0, 1),
        (1, 1, 1),
        (2, 1, 0),
        (3, 1, -1),
        (4, 0, -1),
        (-1, -1, 1),
        (-2, -1, 0),
        (-3, -1, -1),
    ):
        assert (atan2(A * y, A * x) - PI * turns / 4).is_zero()
    found = [atan2(y, x) for y in (A, -A) for x in (B, -B)]
    assert all((one - other).is_zero() == (one is other) for one in found for other in found)
    assert (atan2(A * 2, B * 2) - found[0]).is_zero()
