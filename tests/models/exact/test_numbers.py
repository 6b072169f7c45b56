"""Exact numbers and polynomials: radicals, named angles, normal forms."""

from fractions import Fraction
from math import cos, pi, sin, sqrt

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from pydrake.math import RollPitchYaw

from armproof.models.errors import ModelError
from armproof.models.exact.numbers import (
    IDENTITY,
    add_angles,
    angle_value,
    constant_value,
    cos_sin_of_pi,
    exact_cos_sin,
    exact_number,
    exact_rotation,
    is_number,
    pi_multiple,
    rotation,
    square_of_root,
)
from armproof.models.exact.polynomial import (
    ONE,
    ZERO,
    Entry,
    add,
    generator,
    matrix_product,
    multiply,
    normal_form,
    number,
    root,
    root_value,
    scale,
    transpose,
)
from tests.laws import examples
from tests.models.evaluation import evaluate

SAMPLE = {"theta_1": 0.7, "alpha_1": -1.3, "l_1": 0.45}


def value(gen: tuple[str, str]) -> float:
    kind, name = gen
    if kind == "sqrt":
        return root_value(name)
    number = SAMPLE[name] if name in SAMPLE else angle_value(name)
    return {"cos": cos, "sin": sin, "symbol": float}[kind](number)


ATOMS = [generator(kind, name) for kind in ("cos", "sin") for name in ("theta_1", "alpha_1")]
ATOMS += [generator("symbol", "l_1"), root(2), root(6), ONE, scale(ONE, Fraction(-2, 3))]


@st.composite
def entries(draw: st.DrawFn) -> Entry:
    terms = draw(st.lists(st.lists(st.sampled_from(ATOMS), min_size=1, max_size=4), max_size=4))
    return add(*(multiply(*factors) for factors in terms))


@examples(80)
@given(entries(), entries(), entries())
def test_entries_form_a_ring(a: Entry, b: Entry, c: Entry) -> None:
    assert multiply(a, b) == multiply(b, a)
    assert multiply(a, multiply(b, c)) == multiply(multiply(a, b), c)
    assert multiply(a, add(b, c)) == add(multiply(a, b), multiply(a, c))
    assert add(a, scale(a, -1)) == ZERO
    assert evaluate(multiply(a, b), value) == pytest.approx(evaluate(a, value) * evaluate(b, value), abs=1e-9)
    assert normal_form(multiply(a, b)) == multiply(a, b)


def test_pythagoras_holds_and_a_slip_in_it_does_not() -> None:
    c, s = generator("cos", "theta_1"), generator("sin", "theta_1")
    assert add(multiply(c, c), multiply(s, s)) == ONE
    assert add(multiply(c, c), scale(multiply(s, s), -1)) != ONE


@pytest.mark.parametrize("number", [0, 1, 2, 3, 4, 6, 12, 45, Fraction(1, 3), Fraction(8, 9), Fraction(50, 7)])
def test_roots_square_to_their_number_and_are_positive(number: Fraction) -> None:
    r = root(number)
    assert multiply(r, r) == scale(ONE, Fraction(number))
    assert evaluate(r, value) == pytest.approx(sqrt(number))


@pytest.mark.parametrize("denominator", [1, 2, 3, 4, 5, 6, 7, 12, 24, 360])
def test_multiples_of_pi_have_their_values(denominator: int) -> None:
    for numerator in range(-3 * denominator, 3 * denominator + 1):
        multiple = Fraction(numerator, denominator)
        cosine, sine = cos_sin_of_pi(multiple)
        assert evaluate(cosine, value) == pytest.approx(cos(float(multiple) * pi), abs=1e-13)
        assert evaluate(sine, value) == pytest.approx(sin(float(multiple) * pi), abs=1e-13)
        assert add(multiply(cosine, cosine), multiply(sine, sine)) == ONE


def test_multiples_of_a_twelfth_of_pi_are_radicals_and_others_are_named() -> None:
    names = {gen for k in range(24) for entry in cos_sin_of_pi(Fraction(k, 12)) for m in entry for gen, _ in m}
    assert names == {("sqrt", "2"), ("sqrt", "3")}
    assert exact_cos_sin(0.2 * pi)[0] == generator("cos", "pi/5")
    assert exact_cos_sin(0.4 * pi)[1] == generator("sin", "2*pi/5")
    assert exact_cos_sin(-0.2 * pi)[1] == scale(generator("sin", "pi/5"), -1)
    assert exact_cos_sin(0.8 * pi)[0] == scale(generator("cos", "pi/5"), -1)
    assert exact_cos_sin(0.3)[0] == generator("cos", "0.3")
    assert exact_cos_sin(-0.3) == (generator("cos", "0.3"), scale(generator("sin", "0.3"), -1))
    assert exact_cos_sin(0.0) == (ONE, ZERO)


@pytest.mark.parametrize(
    ("value", "exact"),
    [
        (0.33, Fraction(33, 100)), (-0.054, Fraction(-27, 500)), (0.1 + 0.2, Fraction(3, 10)), (1 / 3, Fraction(1, 3)),
        (2 / 999, Fraction(2, 999)), (3 / 1001, Fraction("0.002997002997")), (123.4567891234, Fraction("123.4567891234")),
        (0.0, Fraction(0)), (1e-17, Fraction(0)), (2.0, Fraction(2)), (1.2345678912, Fraction("1.2345678912")),
    ],
)  # fmt: skip
def test_coordinates_become_the_rationals_that_were_written(value: float, exact: Fraction) -> None:
    assert exact_number(value) == exact


@pytest.mark.parametrize("value", [float("nan"), float("inf")])
def test_coordinates_that_are_not_finite_are_refused(value: float) -> None:
    with pytest.raises(ModelError, match="coordinates are finite numbers of metres"):
        exact_number(value)


@examples(60)
@given(
    st.lists(
        st.sampled_from([0, pi / 2, pi, -pi / 2, pi / 4, -pi / 6, pi / 12, pi / 5, 0.3, -1.1]), min_size=3, max_size=3
    )
)
def test_rotations_of_urdf_files_become_exact(rpy: list[float]) -> None:
    matrix = RollPitchYaw(np.array(rpy)).ToRotationMatrix().matrix()
    R = exact_rotation(matrix)
    np.testing.assert_allclose([[evaluate(e, value) for e in row] for row in R], matrix, atol=1e-12)
    columns = list(zip(*R, strict=True))
    for i in range(3):
        for j in range(3):
            dot = add(*(multiply(a, b) for a, b in zip(columns[i], columns[j], strict=True)))
            assert dot == (ONE if i == j else ZERO)


def test_right_angles_leave_no_float_behind() -> None:
    R = exact_rotation(RollPitchYaw(np.array([pi / 2, -pi / 2, pi])).ToRotationMatrix().matrix())
    assert {abs(c) for row in R for entry in row for c in entry.values()} == {Fraction(1)}
    assert exact_rotation(np.eye(3)) == IDENTITY


def test_a_slanted_axis_has_rational_or_root_entries() -> None:
    matrix = np.array([[0.8, 0.0, 0.6], [0.0, 1.0, 0.0], [-0.6, 0.0, 0.8]])
    assert exact_rotation(matrix)[0] == (scale(ONE, Fraction(4, 5)), ZERO, scale(ONE, Fraction(3, 5)))


MERSENNE, LONG = 2**61 - 1, 2**89 - 1  # two primes


@pytest.mark.parametrize(
    "number", [10**9 + 7, (10**9 + 7) * (10**9 + 9), 7 * (10**9 + 7) ** 2, MERSENNE**2, (MERSENNE * 2003) ** 2 * 3]
)
def test_roots_of_numbers_with_large_factors_are_found(number: int) -> None:
    r = root(number)
    assert multiply(r, r) == scale(ONE, number)
    assert all(power == 1 for monomial in r for _, power in monomial)


@pytest.mark.parametrize("number", [MERSENNE * LONG, MERSENNE**2 * LONG**2])
def test_a_number_that_cannot_be_factored_at_once_has_no_root(number: int) -> None:
    with pytest.raises(ModelError, match=r"the square root of a number of (46|92) digits"):
        root(number)


@pytest.mark.parametrize("power", range(2, 7))
@pytest.mark.parametrize("gen", [("sin", "theta_1"), ("sqrt", "6"), ("cos", "theta_1")])
def test_a_high_power_keeps_its_value_in_normal_form(gen: tuple[str, str], power: int) -> None:
    entry = {((("cos", "theta_1"), 1), (gen, power)) if gen[0] != "cos" else ((gen, power),): Fraction(3)}
    found = normal_form(entry)
    assert evaluate(found, value) == pytest.approx(evaluate(entry, value))
    assert all(k == 1 for monomial in found for (kind, _), k in monomial if kind != "cos")


@pytest.mark.parametrize(
    ("value", "multiple"),
    [(pi / 360, Fraction(1, 360)), (pi / 361, None), (pi / 7 + 5e-12, None), (-3 * pi / 7, Fraction(-3, 7)), (1000 * pi / 7, Fraction(1000, 7)), (0.3, None)],
)  # fmt: skip
def test_an_angle_is_a_multiple_of_pi_within_rounding(value: float, multiple: Fraction | None) -> None:
    assert pi_multiple(value) == multiple


@pytest.mark.parametrize(
    ("value", "square"),
    [(-sqrt(0.001), Fraction(1, 1000)), (sqrt(1 / 1001), None), (sqrt(2) / 2 + 5e-12, None), (-0.6, Fraction(9, 25)), (0, Fraction(0))],
)  # fmt: skip
def test_an_entry_is_the_root_of_a_small_fraction_within_rounding(value: float, square: Fraction | None) -> None:
    assert square_of_root(value) == square


@pytest.mark.parametrize(("first", "second"), [(1, 2), (5, -3), (11, 7), (-6, 12)])
def test_angles_add_by_their_cosines_and_sines(first: int, second: int) -> None:
    a, b, total = (cos_sin_of_pi(Fraction(k, 12)) for k in (first, second, first + second))
    assert add_angles(a, b) == total


@pytest.mark.parametrize(
    ("name", "number"), [("pi/5", pi / 5), ("2*pi/5", 0.4 * pi), ("0.3", 0.3), ("alpha_1", None), ("pitch", None), ("", None)]
)  # fmt: skip
def test_the_name_of_a_number_is_told_from_that_of_an_angle(name: str, number: float | None) -> None:
    assert is_number(name) is (number is not None)
    if number is not None:
        assert angle_value(name) == pytest.approx(number, rel=1e-15)


@pytest.mark.parametrize(
    ("generator", "number"),
    [(("sqrt", "2"), sqrt(2)), (("symbol", "l_1"), 0.45), (("cos", "alpha_1"), cos(-1.3)), (("sin", "alpha_1"), sin(-1.3)), (("cos", "pi/5"), cos(pi / 5)),
     (("sin", "0.3"), sin(0.3))],
)  # fmt: skip
def test_a_generator_that_no_joint_moves_has_a_number(generator: tuple[str, str], number: float) -> None:
    assert constant_value(generator, SAMPLE) == pytest.approx(number, rel=1e-15)


@pytest.mark.parametrize("axis", range(3))
def test_an_elementary_rotation_is_that_of_drake(axis: int) -> None:
    rpy = np.zeros(3)
    rpy[axis] = 0.3
    turned = rotation(axis, exact_cos_sin(0.3))
    np.testing.assert_allclose(
        [[evaluate(e, value) for e in row] for row in turned], RollPitchYaw(rpy).ToRotationMatrix().matrix(), atol=1e-15
    )
    assert matrix_product(turned, transpose(turned)) == IDENTITY


def test_numbers_are_entries_and_zero_has_no_term() -> None:
    assert number(0) == ZERO == scale(ONE, 0) == root(0) and number(Fraction(1, 2)) == {(): Fraction(1, 2)}
    assert add(number(2), number(-2), ONE) == ONE
