"""What expressions mean: each spelling has the value of a plainer one, in the exact algebra and on samples alike."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any

import numpy as np
import pytest

from armproof.verification.algebra.matrix import Identity, Matrix, is_zero
from armproof.verification.errors import EvaluationError, NoValue, ShapeError, UnboundName
from armproof.verification.evaluation.evaluator import Evaluator
from armproof.verification.latex import nodes as n

SAME = [
    (r"I_3 - R^0_1", r"I - R^0_1"),
    (r"R^0_1 - 2I_3", r"R^0_1 - 2I"),
    (r"-R^0_1 a_1", r"(I - 2I) (a_1 R^0_1)"),
    (r"(R^0_1 + a_1^2 I_3)^{-1}", r"(R^0_1 + (a_1 I)^2)^{-1}"),
    (r"\frac{1}{a_1} R^0_1", r"(a_1 I)^{-1} R^0_1"),
    (r"\frac{1}{a_1} R^0_1", r"R^0_1 \frac{I}{a_1}"),
    (r"I_{3\times 3}", r"(R^0_1)^0"),
    (r"T^0_2 I", r"T^0_2"),
    (r"z_1 \cdot z_2", r"z_1^T z_2"),
    (r"p_4 \cdot p_4", r"\left(p_4\right)^2"),
    (r"z_1 \times p_4", r"-p_4 \times z_1"),
    (r"2 p_4", r"p_4 + p_4"),
    (r"\frac{p_4}{a_1}", r"a_1^{-1} p_4"),
    (r"a_1^{-2}", r"\frac{1}{a_1^2}"),
    (r"(a_1^2 + 1)^{1/2}", r"\sqrt{a_1^2 + 1}"),
    (r"90^\circ", r"\frac{\pi}{2}"),
    (r"\cos 60^\circ", r"\frac12"),
    (r"(R^0_4)^{-1}", r"(R^0_4)^T"),
    (r"(R^0_4)^{-T}", r"R^0_4"),
    (r"(R^0_1)^{-2}", r"\left(R^0_1 R^0_1\right)^T"),
    (r"(T^0_4)^{-1}", r"T^4_0"),
    (r"J^{+} J", r"I_4"),
    (r"\begin{bmatrix} 1 & c_1 \end{bmatrix}^{+}", r"\frac{1}{1 + c_1^2} \begin{bmatrix} 1 \\ c_1 \end{bmatrix}"),
    (r"\operatorname{com}(R^0_1)", r"\det(R^0_1) (R^0_1)^{-T}"),
    (r"\operatorname{adj}(R^0_1)", r"\operatorname{com}(R^0_1)^T"),
    (r"\operatorname{tr}(R^0_1)", r"1 + 2 c_1"),
    (r"\begin{vmatrix} c_1 & -s_1 \\ s_1 & c_1 \end{vmatrix}", r"1"),
    (r"\operatorname{diag}(a_1, 2)", r"\begin{bmatrix} a_1 & 0 \\ 0 & 2 \end{bmatrix}"),
    (r"\begin{bmatrix} R^0_1 & p_1 \\ 0 & 1 \end{bmatrix}", r"T^0_1"),
    (r"\begin{bmatrix} I & 0 \\ 0 & R^0_1 \end{bmatrix}", r"\begin{bmatrix} 1 & 0 & 0 & 0 \\ 0 & c_1 & -s_1 & 0 \\ 0 & s_1 & c_1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}"),
    (r"[1, a_1, 3]^T", r"\begin{pmatrix} 1 \\ a_1 \\ 3 \end{pmatrix}"),
    (r"R_z(\theta_1) R_x(\pi)", r"R_z(\theta_1) \operatorname{diag}(1, -1, -1)"),
    (r"Rot(z, \theta_1) Trans(x, a_1)", r"T^0_1"),
    (r"Trans(a_1, a_2, 3)", r"Trans(z, 3) Trans(x, a_1) Trans(y, a_2)"),
    (r"\tan\theta_1 \cot\theta_1", r"1"),
    (r"\sec^2\theta_1", r"1 + \tan^2\theta_1"),
    (r"\csc\theta_1 \sin\theta_1", r"1"),
    (r"c_{1-2}", r"\cos(\theta_1 - \theta_2)"),
    (r"S_{12}", r"\sin\theta_1\cos\theta_2 + C\theta_1\,S\theta_2"),
    (r"\theta_1^*", r"q_1"),
    (r"\frac{\partial p_4}{\partial q}", r"J_v"),
    (r"\frac{\partial c_{12}}{\partial\theta_2}", r"-s_{12}"),
    (r"\frac{\partial^2 c_1}{\partial\theta_1^2}", r"-c_1"),
    (r"\frac{d}{dt} p_4", r"J_v \dot q"),
    (r"\frac{d^2c_1}{d\theta_1^2}", r"-c_1"),
    (r"\frac{d^2p_1}{dt^2}", r"\ddot{p}_1"),
    (r"\dot p_4", r"J_v \dot q"),
    (r"\ddot{p}_1", r"\frac{d}{dt}\dot p_1"),
    (r"\left. c_{12} \right|_{\theta_2 = \pi}", r"-c_1"),
    (r"\left. J_v \right|_{\theta_2 = 0, a_2 = a_1}", r"a_1 \begin{bmatrix} -2 s_1 & -s_1 & 0 & 0 \\ 2 c_1 & c_1 & 0 & 0 \\ 0 & 0 & -1/a_1 & 0 \end{bmatrix}"),
    (r"\sin(\arctan a_1)", r"\frac{a_1}{\sqrt{1 + a_1^2}}"),
    (r"|-3|", r"3"),
    # lists of values are columns, in square brackets rows
    (r"(1, a_1) + (2, 3)", r"[3, a_1 + 3]^T"),
    (r"3 (1, a_1)", r"[3, 3 a_1]^T"),
    (r"-(1, a_1) \cdot 2", r"[-2, -2 a_1]^T"),
    (r"\frac{(1, a_1)}{2}", r"[\frac12, \frac{a_1}{2}]^T"),
    (r"(1, a_1)^T", r"[1, a_1]^T"),
    (r"(1, a_1)^2", r"1 + a_1^2"),
    (r"(1, a_1) \cdot (2, 3)", r"2 + 3 a_1"),
    (r"\begin{bmatrix} (1, a_1) & 3 \end{bmatrix}", r"[1, a_1, 3]"),
    (r"\begin{bmatrix} a_1 \end{bmatrix} + 1", r"a_1 + 1"),
    # identities that take their size, and 0, from what stands beside them
    (r"(2I + 3I) R^0_1", r"5 R^0_1"),
    (r"(2I - 3I) R^0_1", r"-R^0_1"),
    (r"2I \cdot 3I R^0_1", r"6 R^0_1"),
    (r"(3I) a_1 R^0_1", r"3 a_1 R^0_1"),
    (r"R^0_1 (3I)", r"3 R^0_1"),
    (r"a_1 (3I) R^0_1", r"3 a_1 R^0_1"),
    (r"(2I)^{-2} R^0_1", r"\frac14 R^0_1"),
    (r"(2I)^3 R^0_1", r"8 R^0_1"),
    (r"(2I)^0 R^0_1", r"R^0_1"),
    (r"(2I)^T R^0_1", r"2 R^0_1"),
    (r"(2I)^{-1} R^0_1", r"\frac12 R^0_1"),
    (r"2I + R^0_1", r"R^0_1 + 2 I_3"),
    (r"R^0_1 + 0", r"R^0_1"),
    (r"0 + R^0_1", r"R^0_1"),
    (r"\operatorname{Id} R^0_1", r"R^0_1"),
    (r"E_3 R^0_1", r"R^0_1"),
    # powers
    (r"(R^0_1)^3", r"R^0_1 R^0_1 R^0_1"),
    (r"(R^0_1)^{+1}", r"R^0_1"),
    (r"a_1^{+2}", r"a_1 a_1"),
    (r"(a_1)^0", r"1"),
    (r"a_1^{-1} a_1^{-2}", r"\frac{1}{a_1^3}"),
    (r"(a_1^2 + 1)^{0.5}", r"\sqrt{a_1^2 + 1}"),
    (r"a_1^T", r"a_1"),
    (r"(R^0_1)^{+}", r"(R^0_1)^T"),
    (r"\begin{bmatrix} 1 \\ c_1 \end{bmatrix}^{+}", r"\frac{1}{1 + c_1^2} \begin{bmatrix} 1 & c_1 \end{bmatrix}"),
    (r"200\,\text{cm}", r"2"),
    (r"200\,\text{mm}", r"\frac15"),
    # blocks
    (r"\begin{bmatrix} R^0_1 & p_1 \\ 0 & 0 & 0 & 1 \end{bmatrix}", r"T^0_1"),
    (r"\begin{bmatrix} R^0_1 & p_1 \end{bmatrix}", r"\begin{bmatrix} I & 0 \end{bmatrix} T^0_1".replace("I & 0", r"1 & 0 & 0 & 0 \\ 0 & 1 & 0 & 0 \\ 0 & 0 & 1 & 0")),
    (r"\begin{bmatrix} R^0_1 \\ 2I \end{bmatrix}", r"\begin{bmatrix} R^0_1 \\ 2I_3 \end{bmatrix}"),
    (r"\begin{bmatrix} R^0_1 & 2I \end{bmatrix}", r"\begin{bmatrix} R^0_1 & 2I_3 \end{bmatrix}"),
    (r"\begin{bmatrix} R^0_1 & I \\ I & 0 \end{bmatrix}", r"\begin{bmatrix} R^0_1 & I_3 \\ I_3 & 0 I_3 \end{bmatrix}"),
    (r"\begin{bmatrix} R^0_1 & 0 \\ 0 & I \end{bmatrix}", r"\begin{bmatrix} R^0_1 & 0 z_1 \\ 0 & 1 \end{bmatrix}"),
    (r"\begin{bmatrix} I & 0 \\ 0 & 2I \end{bmatrix}", r"\operatorname{diag}(1, 2)"),
    (r"\begin{bmatrix} z_1 & p_1 \\ 0 & 1 \end{bmatrix}", r"\begin{bmatrix} 0 & a_1 c_1 \\ 0 & a_1 s_1 \\ 1 & 0 \\ 0 & 1 \end{bmatrix}"),
    (r"\begin{vmatrix} R^0_1 & p_1 \\ 0 & 2 \end{vmatrix}", r"2"),
    (r"\begin{Vmatrix} a_1 & 1 \\ 1 & 2 \end{Vmatrix}", r"2 a_1 - 1"),
    # products of vectors
    (r"z_1^T \times p_4^T", r"z_1 \times p_4"),
    (r"z_1^T \cdot p_4", r"p_4 \cdot z_1"),
    (r"R^0_1 \times R^0_1", r"R^0_1 R^0_1"),
    (r"z_1 \cdot a_1", r"a_1 z_1"),
    (r"a_1 \times z_1", r"a_1 z_1"),
    (r"|p_4|", r"\sqrt{p_4 \cdot p_4}"),
    (r"|2 R^0_1|", r"8"),
    (r"\operatorname{tr}(a_1) + \det(a_1)", r"2 a_1"),
    (r"\operatorname{tr} \begin{bmatrix} 1 & 7 \\ 7 & a_1 \end{bmatrix}", r"1 + a_1"),
    # names with arguments
    (r"J(q)", r"J"),
    (r"J(\theta_1, \theta_2, d_3, \theta_4)", r"J"),
    (r"T^0_4(0, \pi, 2, 0)", r"\left. T^0_4 \right|_{\theta_1 = 0, \theta_2 = \pi, d_3 = 2, \theta_4 = 0}"),
    (r"p_4(\theta_2, \theta_1, d_3, \theta_4)", r"\begin{bmatrix} a_1 c_2 + a_2 c_{12} \\ a_1 s_2 + a_2 s_{12} \\ -d_3 - d_4 \end{bmatrix}"),
    (r"Trans(x, a_1) Rot(x, \pi)", r"Rot(x, \pi) Trans(x, a_1)"),
    (r"c_{-1} + s_{-1}", r"c_1 - s_1"),
    # derivatives
    (r"\frac{\partial c_1}{\partial q}", r"[-s_1, 0, 0, 0]"),
    (r"\frac{\partial p_1}{\partial (\theta_1, \theta_2)}", r"\begin{bmatrix} -a_1 s_1 & 0 \\ a_1 c_1 & 0 \\ 0 & 0 \end{bmatrix}"),
    (r"\frac{\partial R^0_1}{\partial\theta_1}", r"R_z(\frac{\pi}{2}) R^0_1 - \operatorname{diag}(0, 0, 1)"),
    (r"\frac{\partial^2 a_1^3}{\partial a_1^2}", r"6 a_1"),
    (r"\ddot\theta_1", r"\frac{d}{dt} \dot\theta_1"),
    (r"\frac{d^2 c_1}{dt^2}", r"-c_1 \dot\theta_1^2 - s_1 \ddot\theta_1"),
    (r"\dddot p_1", r"\frac{d}{dt} \ddot p_1"),
    (r"\frac{d^3 c_1}{dt^3}", r"s_1 \dot\theta_1^3 - 3 c_1 \dot\theta_1 \ddot\theta_1 - s_1 \dddot\theta_1"),
]  # fmt: skip


@pytest.mark.parametrize(("latex", "plainer"), SAME)
def test_two_spellings_have_one_value(workbench: Callable[..., Any], latex: str, plainer: str) -> None:
    bench = workbench("scara", count=30)
    a, b = bench.value(latex), bench.value(plainer)
    if isinstance(a, Matrix):
        assert a.shape == b.shape and all(
            is_zero(x - y) for r, s in zip(a.rows, b.rows, strict=True) for x, y in zip(r, s, strict=True)
        )
    else:
        assert is_zero(a - b)
    with np.errstate(all="ignore"):
        sampled, other = bench.samples(latex), bench.samples(plainer)
    good = bench.sampled.regular & np.isfinite(sampled).all(axis=tuple(range(sampled.ndim - 1)))
    assert good.sum() >= 5
    np.testing.assert_allclose(sampled[..., good], other[..., good], rtol=1e-6, atol=1e-6)


@pytest.mark.parametrize(
    ("latex", "neighbour"),
    [
        (r"z_1 \times p_4", r"p_4 \times z_1"),
        (r"(R^0_1)^{-T}", r"(R^0_1)^T"),
        (r"\begin{bmatrix} R^0_1 & p_1 \\ 0 & 1 \end{bmatrix}", r"T^0_2"),
        (r"\frac{\partial p_4}{\partial q}", r"J_\omega"),
        (r"\frac{d}{dt} \ddot\theta_1", r"0"),  # a rate of every order goes on changing
        (r"\left. c_{12} \right|_{\theta_2 = \pi}", r"c_1"),
        (r"R_z(\theta_1) R_x(\theta_2)", r"R_x(\theta_2) R_z(\theta_1)"),
    ],
)
def test_a_neighbour_has_another_value(workbench: Callable[..., Any], latex: str, neighbour: str) -> None:
    bench = workbench("scara", count=30)
    a, b = bench.value(latex), bench.value(neighbour)
    pairs = zip(a.vector(), b.vector(), strict=True) if 1 in getattr(a, "shape", ()) else [(a, b)]
    if isinstance(a, Matrix) and 1 not in a.shape:
        pairs = [(x, y) for r, s in zip(a.rows, b.rows, strict=True) for x, y in zip(r, s, strict=True)]
    assert not all(is_zero(x - y) for x, y in pairs)
    assert np.abs(bench.samples(latex) - bench.samples(neighbour)).max() > 1e-3


def test_plus_or_minus_takes_the_sign_of_its_branch(workbench: Callable[..., Any]) -> None:
    bench = workbench("scara")
    upper, lower = (bench.value(r"\mp a_1 \pm 2", branch=branch) for branch in (1, -1))
    assert is_zero(upper + lower) and is_zero(upper - bench.value("2 - a_1"))


def test_a_length_has_no_rate(workbench: Callable[..., Any]) -> None:
    with pytest.raises(EvaluationError, match="a rate of a_1, which is a length of the arm"):
        workbench("scara").value(r"\dot a_1")


def test_an_identity_without_surroundings_keeps_its_size_open(workbench: Callable[..., Any]) -> None:
    scaled = workbench("scara").value(r"-a_1^2 I")
    assert isinstance(scaled, Identity) and is_zero(scaled.scale + workbench("scara").value("a_1^2"))
    with pytest.raises(EvaluationError, match="an identity matrix whose size cannot be told"):
        workbench("scara").value("I + 1")


@pytest.mark.parametrize(
    ("latex", "error", "message"),
    [
        (r"I_3 + 1", ShapeError, "a sum of a scalar and a 3×3 matrix"),
        (r"z_1 + T^0_1", ShapeError, "a sum of a 3×1 and a 4×4 matrix"),
        (r"z_1 z_2", ShapeError, "a product of a 3×1 and a 3×1 matrix"),
        (r"J^{-1}", ShapeError, "a 6×4 matrix has no inverse"),
        (
            r"\begin{bmatrix} c_1 & s_1 \\ 2 c_1 & 2 s_1 \end{bmatrix}^{-1}",
            ShapeError,
            "its determinant is 0 for every configuration",
        ),
        (r"\det(z_1)", ShapeError, "a 3×1 matrix has no determinant"),
        (
            r"\begin{bmatrix} R^0_1 & a_1 \\ 0 & 1 \end{bmatrix}",
            ShapeError,
            "a scalar stands where a 3×1 block is expected",
        ),
        (r"\begin{bmatrix} R^0_1 & T^0_1 \\ 0 & 1 \end{bmatrix}", ShapeError, "blocks of 3×3, 4×4 stand in one row"),
        (r"\underbrace{z_1}_{2\times 1}", ShapeError, "the matrix is 3×1, the label says 2×1"),
        (r"\begin{bmatrix} 1 & 2 \\ 3 \end{bmatrix}", EvaluationError, "the rows of a matrix have 1, 2 cells"),
        (r"\operatorname{rank}(3)", EvaluationError, "rank of a scalar"),
        (r"\operatorname{atan2}(1)", EvaluationError, "atan2 takes 2 arguments, 1 are given"),
        (r"Rot(\theta_1)", EvaluationError, r"Rot takes an axis \(x, y or z\) and an amount"),
        (r"\sqrt{z_1}", EvaluationError, "a scalar is expected where a matrix stands"),
        (r"\frac{1}{c_1 - c_1}", EvaluationError, "a division by zero"),
        (r"\frac{\partial p_4}{\partial c_1}", EvaluationError, "with respect to something that is not a variable"),
        (r"\left. J \right|_{x = 0}", EvaluationError, "must give joint variables or lengths values"),
        (r"x + 1", UnboundName, "'x' is not bound"),
        (r"f(q)", UnboundName, "'f' is not bound"),
        (r"c_7", NoValue, "the arm has no joint angle 7"),
        (r"(z_1, z_2) + (z_2, z_1)", EvaluationError, "a list of matrices stands where"),
        (r"(I, I) + (I, I)", EvaluationError, "a list of matrices stands where"),
        (r"I + a_1", EvaluationError, "an identity matrix whose size cannot be told"),
        (r"2^{I}", EvaluationError, "exponent"),
        (r"2^{1.5}", EvaluationError, "exponent"),
        (r"I^{0.5}", EvaluationError, "exponent"),
        (r"(R^0_1)^{1/2}", EvaluationError, "exponent"),
        (r"a_1^{-T}", EvaluationError, "scalar"),
        (r"a_1^{+}", EvaluationError, "scalar"),
        (r"Trans(a_1, a_2)", EvaluationError, r"Trans takes an axis \(x, y or z\) and an amount"),
        (r"Rot(z, \theta_1, \theta_2)", EvaluationError, "Rot takes an axis"),
        (r"Trans(x, 2, 3)", UnboundName, "'x' is not bound"),
        (r"\cos(\theta_1, \theta_2)", EvaluationError, "cos takes 1 argument, 2 are given"),
        (r"\operatorname{diag}(z_1)", EvaluationError, "a scalar is expected where a matrix stands"),
        (r"\operatorname{adj}(a_1)", EvaluationError, "adj of a scalar"),
        (r"J(0, 0)", EvaluationError, "J"),
        (r"a_1(q)", UnboundName, r"'a_1\(q\)' is not bound"),
        (r"\theta_1(0)", UnboundName, r"'theta_1\(0\)' is not bound"),
        (r"J(x)", UnboundName, r"'J\(x\)' is not bound"),
        (r"{}^0T_5", EvaluationError, "no frame '5' on arm 'scara'"),
        (r"{}^4T_5", UnboundName, "is not bound"),
        (r"I_{2\times 3}", UnboundName, "is not bound"),
        (r"E", UnboundName, "'E' is not bound"),
        (r"\frac{d}{dt} x", UnboundName, "'x' is not bound"),
        (r"\begin{bmatrix} R^0_1 & z_1^T \\ 0 & 1 \end{bmatrix}", ShapeError, "blocks of 3×3, 1×3 stand in one row"),
        (r"\begin{bmatrix} R^0_1 & p_1 \\ z_1^T \end{bmatrix}", ShapeError, "4"),
        (r"\begin{bmatrix} 1 & 2 & 3 \\ 4 & 5 & 6 \end{bmatrix}^{-1}", ShapeError, "a 2×3 matrix has no inverse"),
        (r"1 + \cdots + a_1", UnboundName, "an ellipsis leaves terms to the reader"),
    ],
)
def test_what_has_no_value_says_why(
    workbench: Callable[..., Any], latex: str, error: type[Exception], message: str
) -> None:
    with pytest.raises(error, match=message):
        workbench("scara").value(latex)


def test_expressions_nested_too_deeply_are_refused(workbench: Callable[..., Any]) -> None:
    bench = workbench("scara")
    node: n.Node = n.Number(Fraction(1))
    for _ in range(200):
        node = n.Group(node)
    with pytest.raises(EvaluationError, match="nested too deeply"):
        Evaluator(bench.names, bench.exact).evaluate(node)


def test_a_rank_is_exact_for_the_family_and_sampled_at_each_configuration(workbench: Callable[..., Any]) -> None:
    bench = workbench("spherical_wrist")
    assert bench.value(r"\operatorname{rank}(J)").as_fraction() == 3
    singular = np.abs(np.sin(bench.sampled.q[:, 1])) < 1e-10
    ranks = bench.samples(r"\operatorname{rank}(J)")
    assert singular.any() and (ranks[singular] == 2).all() and ranks.max() == 3


def test_a_letter_is_free_only_where_no_arm_is_named(workbench: Callable[..., Any]) -> None:
    bench = workbench(None)
    assert is_zero(bench.value(r"\cos^2\beta + \sin^2\beta - 1"))
    assert "beta" in bench.names.used
    with pytest.raises(UnboundName, match="'beta' is not bound"):
        workbench("scara").value(r"\beta")


def test_a_rate_is_a_symbol_of_its_own(workbench: Callable[..., Any]) -> None:
    bench = workbench(None)
    assert not is_zero(bench.value(r"\dot\beta - \beta")) and not is_zero(bench.value(r"\ddot\beta - \dot\beta"))
    assert is_zero(bench.value(r"\dot\beta - \dot{\beta}"))


def test_a_free_letter_takes_the_value_at_which_an_expression_is_asked(workbench: Callable[..., Any]) -> None:
    assert is_zero(workbench(None).value(r"\left. x^2 + y \right|_{x = 3} - 9 - y"))


def test_the_rotation_to_a_frame_that_a_document_adds_is_that_of_its_pose(judge: Callable[..., Any]) -> None:
    added = (
        r"T^2_3 = \begin{bmatrix} 0 & -1 & 0 & 2 l_1 \\ 1 & 0 & 0 & 0 \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}"
    )
    right = r"R^0_3 = R^0_2 R_z(\frac{\pi}{2})"
    assert judge(added, right, arm="planar_2r").verdict == "proved"
    assert judge(added, right, r"R^0_3 = R^0_2", arm="planar_2r").verdict == "refuted"
