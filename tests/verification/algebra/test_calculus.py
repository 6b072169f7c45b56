"""Which symbols a value holds, by what it can be differentiated, and what a normal form leaves open."""

from __future__ import annotations

from fractions import Fraction

import pytest

from armproof.verification.algebra.angles import cos_sin, has_arcs
from armproof.verification.algebra.calculus import derivative, leaves_open, symbols_in
from armproof.verification.algebra.ring import Ring, Scalar
from armproof.verification.algebra.roots import atan2, sqrt
from armproof.verification.errors import EvaluationError

RING = Ring()
A, B, X = (RING.symbol(name) for name in ("a", "b", "x"))
PI = RING.generator(("pi", ""))
ROOT, ARC = sqrt(A * A + B * B), atan2(A, sqrt(B))
HALF = RING.rational(Fraction(1, 2))


@pytest.mark.parametrize(
    ("value", "names"),
    [
        (A + B * 2, "a b"),
        (A / B, "a b"),
        (cos_sin(X)[0] + cos_sin(X * HALF)[1], "x"),
        (cos_sin(PI * RING.rational(Fraction(1, 5)))[0], ""),
        (cos_sin(RING.rational(Fraction(3, 10)))[0] + A, "a"),
        (PI + 2, ""),
        (ROOT, "a b"),
        (ARC, "a b"),
    ],
)
def test_symbols_are_found_wherever_they_stand(value: Scalar, names: str) -> None:
    assert symbols_in([value]) == set(names.split())
    assert symbols_in([RING.one, value, X]) == {*names.split(), "x"}


@pytest.mark.parametrize("variable", [A * 2, A * A, A + B, A / B, RING.one, PI, ROOT])
def test_nothing_but_a_free_symbol_is_a_variable(variable: Scalar) -> None:
    with pytest.raises(EvaluationError):
        derivative(A * A, variable)
    assert (derivative(A * A * B, A) - A * B * 2).is_zero() and derivative(A, B).is_zero()


def test_roots_and_arc_functions_are_differentiated_by_the_chain_rule() -> None:
    assert (derivative(ROOT, A) - A / ROOT).is_zero()
    angle = atan2(A, B)
    assert (derivative(angle, A) - B / (A * A + B * B)).is_zero()
    assert (derivative(angle, B) + A / (A * A + B * B)).is_zero()


@pytest.mark.parametrize(
    ("value", "is_open"),
    [
        (A + cos_sin(X)[0], False),
        (PI + RING.rational(Fraction(1, 3)), False),
        (ROOT - A, True),
        (ARC - A, True),
        (cos_sin(PI * RING.rational(Fraction(1, 5)))[0], True),
        (cos_sin(RING.rational(Fraction(3, 10)))[1], True),
    ],
)
def test_roots_arcs_and_cosines_of_constants_leave_a_difference_open(value: Scalar, is_open: bool) -> None:
    assert leaves_open(value) is is_open


def test_an_angle_is_known_up_to_whole_turns_where_it_holds_an_arc_function() -> None:
    assert has_arcs(ARC) and has_arcs(A - ARC * 2) and not has_arcs(ROOT) and not has_arcs(cos_sin(X)[0] + PI)
