"""The two algebras agree: what the exact one says at a configuration, the double plant measures there."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any

import numpy as np
import pytest

from armproof.models.arm import Arm
from armproof.verification.algebra.calculus import substitute
from armproof.verification.algebra.protocol import OutsideAlgebra, elementary, identity, link_matrix
from armproof.verification.algebra.quantity import Quantity
from armproof.verification.errors import EvaluationError
from armproof.verification.evaluation.sampled import SampledAlgebra


def quantities(arm: Arm) -> list[Quantity]:
    """Return one of each kind, between frames of the arm."""
    base, middle, tool = arm.frames[0], arm.frames[len(arm.frames) // 2], arm.frames[-1]
    return [
        Quantity("pose", tool, base),
        Quantity("pose", base, middle),
        Quantity("rotation", tool, middle),
        Quantity("origin", tool, base),
        Quantity("origin", tool, middle, homogeneous=True),
        Quantity("axis", tool, base, along="y"),
        Quantity("axis", middle, tool, homogeneous=True),
        Quantity("difference", tool, base, start=middle),
        Quantity("jacobian", tool, base),
        Quantity("jacobian", tool, tool, rows=(4, 6), columns=(1,)),
        Quantity("joint", arm.joints[-1].symbol, scalar=True),
        Quantity("vector", "q"),
    ]


def test_every_quantity_of_every_arm_is_the_same_in_both_algebras(arm: Arm, workbench: Callable[..., Any]) -> None:
    bench = workbench(arm.name)
    scale = 1 + np.abs(bench.sampled.q).max(axis=1)
    for quantity in quantities(arm):
        exact = bench.stack(bench.sampled.from_exact(bench.exact.quantity(quantity)))
        measured = bench.stack(bench.sampled.quantity(quantity))
        assert exact.shape == measured.shape
        assert (np.abs(exact - measured) / scale).max() < 1e-13, quantity


def test_at_other_lengths_the_trace_is_sampled_and_not_the_urdf(workbench: Callable[..., Any]) -> None:
    bench = workbench("scara")
    tool = Quantity("origin", "4")
    longer = bench.sampled.at({"a_2": np.full(bench.sampled.samples, 7.0)})
    c1, c12 = np.cos(longer.q[:, 0]), np.cos(longer.q[:, 0] + longer.q[:, 1])
    np.testing.assert_allclose(longer.quantity(tool).rows[0][0], bench.arm.lengths["a_1"] * c1 + 7 * c12, atol=1e-12)
    assert np.abs(longer.quantity(tool).rows[0][0] - bench.sampled.quantity(tool).rows[0][0]).max() > 1


def test_at_other_joint_values_the_plant_is_moved(workbench: Callable[..., Any]) -> None:
    bench = workbench("planar_2r")
    straight = bench.sampled.at({"theta_2": np.zeros(bench.sampled.samples)})
    x, y, _ = straight.quantity(Quantity("origin", "2")).vector()
    np.testing.assert_allclose(np.hypot(x, y), sum(bench.arm.lengths.values()), atol=1e-12)


def test_a_sample_whose_joint_value_is_no_number_is_left_out(workbench: Callable[..., Any]) -> None:
    sampled = workbench("planar_2r").sampled
    theta_2 = np.zeros(sampled.samples)
    theta_2[3] = np.nan
    moved = sampled.at({"theta_2": theta_2})
    assert np.flatnonzero(~moved.regular).tolist() == [3]
    assert np.isfinite(moved.quantity(Quantity("origin", "2")).vector()[0]).all()


def test_a_free_symbol_has_one_value_a_sample(workbench: Callable[..., Any]) -> None:
    first, second = (workbench(None).sampled for _ in range(2))
    np.testing.assert_array_equal(first.symbol("x"), second.symbol("x"))
    assert not np.array_equal(first.symbol("x"), first.symbol("y"))
    assert first.symbol("x") is first.symbol("x") and len(set(first.symbol("x"))) == first.samples
    other = SampledAlgebra(first.exact, first.q, seed=6)
    assert not np.array_equal(first.symbol("x"), other.symbol("x"))


@pytest.mark.parametrize(
    "latex",
    [
        r"\operatorname{atan2}(a_2 \sin\theta_2, a_1 + a_2\cos\theta_2)",
        r"\arctan(\sin\theta_1)",
        r"\arcsin\frac{\sin\theta_1}{2}",
        r"\arccos(\cos\theta_1 \cos\theta_2)",
        r"\sqrt{a_1^2 + a_2^2 + 2 a_1 a_2 \cos\theta_2}",
        r"\frac{\sqrt{3}}{2 + \cos\theta_1} + \pi",
        r"\cos(\theta_1 + \frac{\pi}{5}) - \sin(0.3)",
        r"\tan(\frac{\theta_1}{2})",
    ],
)
def test_roots_arc_functions_and_constants_are_the_same_in_both_algebras(
    workbench: Callable[..., Any], latex: str
) -> None:
    bench = workbench("scara")
    exact = bench.stack(bench.sampled.from_exact(bench.value(latex)))
    np.testing.assert_allclose(exact, bench.samples(latex), rtol=1e-9, atol=1e-7)


def test_an_absolute_value_is_exact_for_numbers_only(workbench: Callable[..., Any]) -> None:
    exact = workbench("scara").exact
    assert exact.absolute(exact.rational(Fraction(-3, 2))).as_fraction() == Fraction(3, 2)
    with pytest.raises(OutsideAlgebra, match="an absolute value"):
        exact.absolute(exact.symbol("a_1"))


def test_samples_near_a_pole_are_left_out(workbench: Callable[..., Any]) -> None:
    sampled = workbench("scara", count=60).sampled
    sampled.divide_by(np.r_[np.ones(58), 1e-7, 0.0])
    assert sampled.regular.sum() == 58 and not sampled.regular[-2:].any()


def test_rows_that_a_quantity_does_not_have_are_refused(workbench: Callable[..., Any]) -> None:
    bench = workbench("planar_2r")
    for algebra in (bench.exact, bench.sampled):
        with pytest.raises(EvaluationError, match="row 7 or column 3 of a 6×2 matrix"):
            algebra.quantity(Quantity("jacobian", "2", rows=(1, 7), columns=(3,)))


# -- elementary transforms and link matrices ------------------------------------------------------------------------------


@pytest.mark.parametrize("axis", "xyz")
def test_an_elementary_rotation_leaves_its_axis_and_turns_the_others(workbench: Callable[..., Any], axis: str) -> None:
    exact = workbench(None).exact
    turn = elementary(exact, "Rot", axis, exact.pi() / 2)
    i, j, k = ("xyz".index(axis) + step for step in (0, 1, 2))
    rows = [[cell.as_fraction() for cell in row] for row in turn.rows]
    assert [rows[r][i % 3] for r in range(3)] == [r == i % 3 for r in range(3)]
    assert [rows[r][j % 3] for r in range(3)] == [r == k % 3 for r in range(3)]  # the next axis onto the one after
    assert rows[3] == [0, 0, 0, 1]


@pytest.mark.parametrize("axis", "xyz")
def test_elementary_transforms_about_one_axis_commute_and_add(workbench: Callable[..., Any], axis: str) -> None:
    exact = workbench(None).exact
    alpha, beta, d = (exact.symbol(name) for name in ("alpha", "beta", "d"))

    def same(a: Any, b: Any) -> bool:
        return all((x - y).is_zero() for r, s in zip(a.rows, b.rows, strict=True) for x, y in zip(r, s, strict=True))

    rotate, move = (elementary(exact, kind, axis, amount) for kind, amount in (("Rot", alpha), ("Trans", d)))
    assert same(rotate @ move, move @ rotate)
    assert same(rotate @ elementary(exact, "Rot", axis, beta), elementary(exact, "Rot", axis, alpha + beta))
    assert same(rotate @ elementary(exact, "Rot", axis, -alpha), identity(exact, 4))
    other = elementary(exact, "Trans", "y" if axis == "x" else "x", d)
    assert not same(rotate @ other, other @ rotate)


def test_the_two_conventions_are_the_same_steps_in_another_order(workbench: Callable[..., Any]) -> None:
    exact = workbench(None).exact
    one, zero = exact.ring.one, exact.ring.zero
    classic, modified = (link_matrix(exact, convention) for convention in ("classic", "modified"))
    assert (classic.rows[2][1] - exact.cos_sin(exact.symbol("alpha_i"))[1]).is_zero()
    assert (modified.rows[1][2] + exact.cos_sin(exact.symbol("alpha_i-1"))[1]).is_zero()
    straight = {"alpha_i": zero, "alpha_i-1": zero, "a_i": one, "a_i-1": one, "theta_i": zero}
    at_zero = [matrix.map(lambda cell: substitute(cell, straight)) for matrix in (classic, modified)]
    assert all(
        (x - y).is_zero() for r, s in zip(*(m.rows for m in at_zero), strict=True) for x, y in zip(r, s, strict=True)
    )
