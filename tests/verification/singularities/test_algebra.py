"""The algebra of singular configurations: half-angle coordinates, factors, elimination, systems split into irreducible sets."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from armproof.models.bulk.bulk import bulk_of
from armproof.models.catalogue import load_arm
from armproof.verification.algebra.budget import Budget
from armproof.verification.algebra.matrix import Matrix
from armproof.verification.algebra.ring import Scalar
from armproof.verification.conditions.drawn_points import DrawnPoints
from armproof.verification.singularities.decomposition import Decomposer, Lengths
from armproof.verification.singularities.elimination import BeyondReach, Relation, pseudo_remainder
from armproof.verification.singularities.existence import existence
from armproof.verification.singularities.factors import Factor, Kind, never_zero
from armproof.verification.singularities.half_angles import HalfAngles
from armproof.verification.singularities.jacobians import choose_jacobian, lost_from_simple
from armproof.verification.singularities.linear import as_scalars, eliminate, polynomial_rows
from armproof.verification.singularities.points import Sampler, joint_unknowns
from armproof.verification.singularities.second_order import jacobian_derivatives
from armproof.verification.singularities.variety import Probe, Variety
from armproof.verification.singularities.writing import trigonometric_factors, write_condition, write_product

LENGTHS = frozenset({"a_3", "d_3"})


@pytest.fixture(scope="module")
def bench(workbench: Callable[..., Any]) -> Any:
    return workbench("rx90", count=20)


def half_of(*values: Scalar) -> HalfAngles:
    return HalfAngles(values[0].ring, values)


def factor_of(bench: Any, latex: str) -> Factor:
    """The one factor of an expression that can vanish."""
    value = bench.value(latex)
    half = half_of(value)
    found = [Factor(half, f, LENGTHS) for f, _ in half.factors(half.polynomial(value))]
    (factor,) = [f for f in found if f.kind is not Kind.NEVER]
    return factor


# -- half-angle coordinates --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "latex", ["C_2", "S_2", "C_{23}", "a_3 C_2 - d_3 S_{23}", "C_2^2 S_3 + S_2", "1 + S_2 C_3", "a_3^2 - d_3"]
)
def test_half_angles_lead_there_and_back(bench: Any, latex: str) -> None:
    value = bench.value(latex)
    half = half_of(value)
    assert (half.scalar(half.polynomial(value)) - value).is_zero()
    assert not (half.scalar(half.polynomial(value)) - value - 1).is_zero()


def test_an_odd_degree_is_no_function_of_the_angle(bench: Any) -> None:
    half = half_of(bench.value("S_2"))
    t, u = half.pair("theta_2")
    assert half.scalar(t) is None
    assert (half.squares_to_scalar(t) - (1 - bench.value("C_2")) / 2).is_zero()
    assert (half.scalar(t * u) - bench.value("S_2") / 2).is_zero()


@pytest.mark.parametrize(
    ("latex", "conditions"),
    [
        ("S_2", {r"\theta_2 = 0", r"\theta_2 = \pi"}),
        ("C_2", {r"\theta_2 = \frac{\pi}{2}", r"\theta_2 = -\frac{\pi}{2}"}),
        ("1 - C_2", {r"\theta_2 = 0"}),
        ("1 - C_2^2", {r"\theta_2 = 0", r"\theta_2 = \pi"}),
        ("S_{23}", {r"\theta_2 + \theta_3 = 0", r"\theta_2 + \theta_3 = \pi"}),
        (r"\cos(\theta_2 - \theta_3)", {r"\theta_2 - \theta_3 = \frac{\pi}{2}", r"\theta_2 - \theta_3 = -\frac{\pi}{2}"}),
        ("C_{123} - 1", {r"\theta_1 + \theta_2 + \theta_3 = 0"}),
        ("a_3 d_3 (a_3 + d_3)", set()),
        ("2 + C_2", set()),
        ("2 + S_2 C_3", set()),
        ("a_3 - d_3", {"a_3 = d_3"}),
        ("a_3 C_2 - d_3 S_{23}", {r"a_3 C_2 - d_3 S_{23} = 0"}),
    ],
)  # fmt: skip
def test_factors_are_conditions(bench: Any, latex: str, conditions: set[str]) -> None:
    value = bench.value(latex)
    half = half_of(value)
    found = [Factor(half, f, LENGTHS) for f, _ in half.factors(half.polynomial(value))]
    assert {write_condition(f) for f in found if f.kind is not Kind.NEVER} == conditions


@pytest.mark.parametrize("latex", ["1 + 2 C_2", "a_3 + d_3 C_2", "a_3 - d_3", "C_2 + C_3", "r"])
def test_what_can_vanish_is_never_called_nonzero(bench: Any, latex: str) -> None:
    value = bench.exact.ring.symbol("r") ** 2 if latex == "r" else bench.value(latex)
    half = half_of(value)
    assert not never_zero(half, half.polynomial(value), LENGTHS)
    assert not never_zero(half, half.polynomial(value - value), LENGTHS)


def test_a_product_is_written_only_where_it_is_one(bench: Any) -> None:
    value = bench.value("2 a_3 S_2 C_3 (a_3 C_2 - d_3 S_{23})")
    half = half_of(value)
    factors = trigonometric_factors(half, half.polynomial(value), LENGTHS)
    assert write_product(value, factors) == r"2 a_3 C_3 S_2 \left(a_3 C_2 - d_3 S_{23}\right)"
    assert write_product(value + 1, factors) is None


# -- elimination and probing -------------------------------------------------------------------------------------------------


def test_a_remainder_vanishes_on_multiples_alone(bench: Any) -> None:
    shoulder, other = bench.value("a_3 C_2 - d_3 S_{23}"), bench.value("S_2 + C_3")
    half = half_of(shoulder, other)
    relation = Relation(Factor(half, half.polynomial(shoulder), LENGTHS), half.slots("theta_2")[0])
    assert pseudo_remainder(half, half.polynomial(shoulder * other), relation).is_zero()
    assert not pseudo_remainder(half, half.polynomial(other), relation).is_zero()


def test_a_point_in_a_finite_field_shows_what_is_not_zero(bench: Any) -> None:
    shoulder, other = bench.value("a_3 C_2 - d_3 S_{23}"), bench.value("S_2 + C_3")
    half = half_of(shoulder, other)
    relation = Relation(Factor(half, half.polynomial(shoulder), LENGTHS), half.slots("theta_2")[0])
    probe = Probe(half, [relation])
    assert probe.shows_not_zero(half.polynomial(other))
    assert not probe.shows_not_zero(half.polynomial(shoulder * other))


def test_a_point_in_a_finite_field_has_the_roots_of_numbers(bench: Any) -> None:
    relation_holds, follows, other = (
        bench.value(latex) for latex in (r"S_2 - \sqrt{3} C_2", r"S_2^2 - 3 C_2^2", r"S_2^2 - 2 C_2^2")
    )
    half = half_of(relation_holds, follows, other)
    relation = Relation(Factor(half, half.polynomial(relation_holds), LENGTHS), half.slots("theta_2")[0])
    probe = Probe(half, [relation])
    assert not probe.shows_not_zero(half.polynomial(follows))
    assert probe.shows_not_zero(half.polynomial(other))


# -- systems -----------------------------------------------------------------------------------------------------------------


def split(bench: Any, *equations: str, lengths: Lengths = Lengths.LINEAR) -> list[set[str]]:
    values = [bench.value(latex) for latex in equations]
    half = half_of(*values)
    decomposer = Decomposer(half, LENGTHS, lengths=lengths)
    varieties = decomposer.decompose([half.polynomial(value) for value in values])
    return [{write_condition(f) for f in (*v.conditions, *v.lengths)} for v in varieties]


def test_a_system_is_split_into_its_sets(bench: Any) -> None:
    found = split(bench, "S_2 S_3", "S_2 C_4")
    quarters = (r"\theta_4 = -\frac{\pi}{2}", r"\theta_4 = \frac{\pi}{2}")
    both = [{angle, quarter} for angle in (r"\theta_3 = 0", r"\theta_3 = \pi") for quarter in quarters]
    expected = [{r"\theta_2 = 0"}, {r"\theta_2 = \pi"}, *both]
    assert len(found) == 6 and all(conditions in found for conditions in expected)


def test_no_common_zero_leaves_nothing(bench: Any) -> None:
    assert split(bench, "S_2", "C_2") == []
    assert split(bench, "a_3 C_2 + d_3 C_3", "C_2 - 1", "C_3 - 1") == []


def test_a_set_of_special_lengths_is_found_where_it_is_asked_for(bench: Any) -> None:
    equations = ("a_3 C_2 - d_3 S_{23}", "C_2 - 1", "S_3 - 1")
    assert split(bench, *equations) == [{r"\theta_2 = 0", r"\theta_3 = \frac{\pi}{2}", "a_3 = d_3"}]
    assert split(bench, *equations, lengths=Lengths.GENERIC) == []


def test_two_equations_in_the_same_two_angles_are_eliminated(bench: Any) -> None:
    found = split(bench, "a_3 C_2 - d_3 S_{23}", "a_3 S_2 + d_3 C_{23}")  # wrist in the shoulder: folded, equal lengths
    assert found == [{r"\theta_3 = \frac{\pi}{2}", "a_3 = d_3"}]


def test_a_relation_between_lengths_that_is_not_linear_is_not_passed_over(bench: Any) -> None:
    with pytest.raises(BeyondReach, match="not linear"):
        split(bench, "a_3^2 - 2 d_3^2", lengths=Lengths.ALL)


def test_a_deadline_ends_a_decomposition(bench: Any) -> None:
    value = bench.value("a_3 C_2 - d_3 S_{23}")
    half = half_of(value)
    with pytest.raises(BeyondReach, match="more time"):
        Decomposer(half, LENGTHS, budget=Budget(-1.0)).decompose([half.polynomial(value)])


# -- rank and null vectors ---------------------------------------------------------------------------------------------------


def test_rank_is_that_of_the_set(bench: Any) -> None:
    matrix = Matrix(((bench.value("C_2"), bench.value("S_2")), (bench.value("C_3"), bench.value("S_3"))))
    half = half_of(*(cell for row in matrix.rows for cell in row))
    rows = polynomial_rows(half, matrix)
    assert eliminate(Variety(half), rows).rank == 2
    (equal, opposite) = Decomposer(half, LENGTHS).decompose([half.polynomial(matrix.determinant())])
    for variety in (equal, opposite):
        echelon = eliminate(variety, rows)
        assert echelon.rank == 1
        vector = as_scalars(half, echelon.null_vectors[0])
        for row in matrix.rows:
            assert variety.vanishes(half.polynomial(row[0] * vector[0] + row[1] * vector[1]))


def test_a_wrench_follows_the_jacobian_to_other_axes(bench: Any) -> None:
    chosen = choose_jacobian(bench.exact, None, None, None, None)
    assert chosen.transform is not None
    whole = chosen.transform @ chosen.simple
    for a, b in zip(whole.rows, chosen.matrix.rows, strict=True):
        assert all((x - y).is_zero() for x, y in zip(a, b, strict=True))
    w = Matrix(tuple((bench.value(latex),) for latex in ("1", "C_2", "a_3", "S_5", "0", "d_3")))
    left = (lost_from_simple(chosen, w).transpose @ chosen.matrix).rows[0]
    right = (w.transpose @ chosen.simple).rows[0]
    assert all((x - y).is_zero() for x, y in zip(left, right, strict=True))


# -- points ------------------------------------------------------------------------------------------------------------------


def test_gradients_are_derivatives() -> None:
    arm = load_arm("rx90")
    from armproof.verification.algebra.ring import Ring
    from armproof.verification.evaluation.exact import ExactAlgebra

    chosen = choose_jacobian(ExactAlgebra(Ring(), arm), None, None, None, None)
    determinant = chosen.simple.determinant()
    half = half_of(determinant)
    sampler = Sampler(half, joint_unknowns(arm), dict(arm.lengths))
    polynomials = [half.polynomial(determinant)]
    q = sampler.draw(np.random.default_rng(3), 20)
    gradient = sampler.gradients(polynomials, q)[:, 0]
    for k in range(6):
        step = np.zeros(6)
        step[k] = 1e-6
        difference = (sampler.values(polynomials, q + step) - sampler.values(polynomials, q - step))[:, 0] / 2e-6
        np.testing.assert_allclose(gradient[:, k], difference, atol=1e-8)


@pytest.mark.parametrize("name", ["rx90", "scara", "kr210", "polar_rp"])
def test_the_derivative_of_the_jacobian_is_told_by_its_columns(name: str) -> None:
    arm = load_arm(name)
    q = np.random.default_rng(4).uniform(-2, 2, (10, len(arm.joints)))
    frame = arm.frames[-1]
    found = jacobian_derivatives(np.array(bulk_of(arm).jacobian(q, frame)))
    for k in range(len(arm.joints)):
        step = np.zeros(len(arm.joints))
        step[k] = 1e-6
        difference = (
            np.array(bulk_of(arm).jacobian(q + step, frame)) - np.array(bulk_of(arm).jacobian(q - step, frame))
        ) / 2e-6
        np.testing.assert_allclose(found[:, :, :, k], difference, atol=1e-8)


def test_a_condition_is_solved_for_a_joint(bench: Any) -> None:
    joints = bench.arm.joints
    found = existence(factor_of(bench, "a_3 C_2 - d_3 S_{23}"), joints)
    assert found.solved == r"\theta_2 = \operatorname{atan2}(d_3 S_3 - a_3, -d_3 C_3) + k\pi"
    assert found.condition == ""
    assert existence(factor_of(bench, "a_3 + d_3 C_2"), joints).condition == r"a_3 \le d_3"
    assert existence(factor_of(bench, "d_3 + a_3 C_2 + a_3 S_2"), joints).condition == r"d_3 \le \sqrt{2} a_3"


# -- points that are drawn -----------------------------------------------------------------------------------------------------


def test_a_point_that_is_drawn_is_none_that_is_left_out_and_none_at_which_the_conclusion_holds(bench: Any) -> None:
    where, other = bench.value("a_3 C_2 - d_3 S_{23}"), bench.value("S_2")
    half = half_of(where, other)
    drawn = DrawnPoints(half, load_arm("rx90"), LENGTHS, (set(half.angles), set(LENGTHS)))
    (variety,) = Decomposer(half, LENGTHS, lengths=Lengths.LINEAR).decompose([half.polynomial(where)])
    on, off = (half.polynomial(where),), (half.polynomial(other),)
    assert drawn.point(variety, (), [(off, ())], 1.0)
    assert drawn.point(variety, [off], [(off, ())], 1.0)
    assert drawn.point(variety, [on], [(off, ())], 1.0) is None
    assert drawn.point(variety, [off, on], [(off, ())], 1.0) is None
    assert drawn.point(variety, (), [(on, ())], 1.0) is None
    assert drawn.point(variety, (), [(on, [off])], 1.0) is None
    assert drawn.point(variety, (), [(on, [on])], 1.0)
    at_scale = {scale: drawn.point(variety, (), [(off, ())], scale) or {} for scale in (1.0, 4.0)}
    assert not LENGTHS & {*at_scale[1.0]} and {*at_scale[4.0]} >= LENGTHS  # lengths of the arm are not told
