"""Implications, singular configurations, inequalities and sizes: decided where they can be, never waved through."""

from __future__ import annotations

from collections.abc import Callable
from math import pi
from typing import Any

import numpy as np
import pytest

from armproof.models.catalogue import load_arm
from armproof.models.numeric.plant import NumericKinematics
from armproof.verification.findings import Kind
from armproof.verification.verdict import Record, Verdict

Judge = Callable[..., Record]
DET = r"\det(J_v J_v^T)"
PLANAR = {
    "arm": "planar_2r",
    "quantities": {"J": {"jacobian": 2, "rows": [1, 2]}, "P_x": {"origin": 2, "component": "x"}},
}


@pytest.mark.parametrize(
    ("latex", "verdict"),
    [
        (r"\det J = 0 \iff \sin\theta_2 = 0", Verdict.PROVED),
        (r"\det J = 0 \iff \theta_2 = 0 \text{ or } \theta_2 = \pi", Verdict.PROVED),
        (r"\det J = 0 \iff \theta_2 = k\pi", Verdict.PROVED),
        (r"\det J = 0 \iff \theta_2 \in \{0, \pi\}", Verdict.PROVED),
        (r"\det J = 0 \iff l_1 l_2 s_2 = 0", Verdict.PROVED),  # lengths are not zero
        (r"\det J = 0 \Leftarrow \theta_2 = 0", Verdict.PROVED),
        (r"\det J = 0 \text{ if } \theta_2 = \pi", Verdict.PROVED),
        (r"\theta_2 = 0 \Rightarrow \det J = 0", Verdict.PROVED),
        (r"\theta_2 = 0 \Rightarrow s_{12} = s_1", Verdict.PROVED),
        (r"P_x = 2 \Rightarrow P_x^2 = 4", Verdict.PROVED),
        (r"P_x = 2 \Rightarrow \sin\theta_2 = 0", Verdict.REFUTED),  # this arm is too short for it, others are not
        (r"\det J = 0 \iff \theta_2 = 0", Verdict.REFUTED),  # π is forgotten
        (r"\det J = 0 \Rightarrow \theta_2 = 0", Verdict.REFUTED),
        (r"\det J = 0 \iff \cos\theta_2 = 0", Verdict.REFUTED),
        (r"\det J = 0 \iff \theta_1 = 0", Verdict.REFUTED),
        (r"\det J = 0 \iff \sin\theta_2 \cos\theta_1 = 0", Verdict.REFUTED),  # the right side holds more often
        (r"\det J = 0 \Rightarrow \sin\theta_2 \cos\theta_1 = 0", Verdict.PROVED),
        (r"\det J = 0 \Leftarrow \theta_2 = \frac{\pi}{2}", Verdict.REFUTED),
        (r"\theta_2 = \pi \Rightarrow s_{12} = s_1", Verdict.REFUTED),
    ],
)
def test_a_singular_set_is_decided(judge: Judge, latex: str, verdict: Verdict) -> None:
    assert judge(latex, **PLANAR).verdict is verdict


def test_a_refuted_condition_comes_with_the_configuration_that_shows_it(judge: Judge) -> None:
    record = judge(r"\det J = 0 \iff \theta_2 = 0", **PLANAR)
    assert record.counterexample == {"theta_2": pytest.approx(pi)}
    assert record.message.startswith("the left side holds and the right does not at the configuration given")
    record = judge(r"\det J = 0 \Leftarrow \theta_2 = \frac{\pi}{2}", **PLANAR)
    assert record.counterexample == {"theta_2": pytest.approx(pi / 2)}
    assert record.message.startswith("the right side holds and the left does not")


def test_families_that_are_missing_and_those_that_do_not_belong_are_named(judge: Judge) -> None:
    both = judge(r"\det J = 0 \iff \theta_2 = 0 \text{ or } \theta_1 = \frac{\pi}{2}", **PLANAR)
    told = [
        (finding.terms["side"], finding.terms["families"])
        for finding in both.findings
        if finding.kind is Kind.NOT_COVERED
    ]
    assert told == [("right", r"\theta_2 = \pi"), ("left", r"\theta_1 = \frac{\pi}{2}")]


def test_a_factor_that_may_vanish_is_no_length(judge: Judge) -> None:
    front = {"arm": "polar_rp", "quantities": {"J": {"jacobian": 2, "rows": [1, 2]}}}
    assert judge(r"\det J = 0 \iff r = 0", **front).verdict is Verdict.PROVED
    assert judge(r"r \sin\theta = 0 \iff \sin\theta = 0", **front).verdict is not Verdict.PROVED
    for factor, verdict in (
        ("(1 + r^2)", Verdict.PROVED),
        ("(2 + 3r^2 + r^4)", Verdict.PROVED),
        ("(r^2 + r^4)", None),
        ("(1 - r^2)", None),
        ("(1 + r)", None),
    ):
        found = judge(rf"{factor} \sin\theta = 0 \iff \sin\theta = 0", **front).verdict
        assert found is verdict if verdict else found is not Verdict.PROVED


@pytest.mark.parametrize(
    ("latex", "verdict"),
    [
        (r"\det J = 0 \iff \theta_2 = 0 \text{ or } \pi", Verdict.PROVED),
        (r"\det J = 0 \iff \theta_2 = 2k\pi", Verdict.REFUTED),
        (r"\det J = 0 \iff \theta_2 = 2k\pi \text{ or } \theta_2 = (2k+1)\pi", Verdict.PROVED),
        (r"\det J = 0 \iff \theta_2 = \frac{\pi}{2} + k\pi", Verdict.REFUTED),
        (r"\cos\theta_2 = 0 \iff \theta_2 = (2k+1)\frac{\pi}{2}", Verdict.PROVED),
        (r"\sin(2\theta_2) = 0 \iff \theta_2 = k\frac{\pi}{2}", Verdict.PROVED),
        (r"\det J \neq 0 \iff \sin\theta_2 \neq 0", Verdict.PROVED),
        (r"\det J \neq 0 \iff \theta_2 \neq 0", Verdict.REFUTED),
        (r"\operatorname{rank} J = 1 \iff \sin\theta_2 = 0", Verdict.PROVED),
        (r"\operatorname{rank} J = 1 \iff \theta_2 = 0", Verdict.REFUTED),
        (r"\operatorname{rank} J < 2 \iff \sin\theta_2 = 0", Verdict.PROVED),
        (r"\operatorname{rank} J < 1 \iff \sin\theta_2 = 0", Verdict.REFUTED),
        (r"\operatorname{rank} J = 1 \text{ if } \theta_2 = 0", Verdict.PROVED),
        (r"\operatorname{rank} J = 2 \text{ if } \theta_2 = 0", Verdict.REFUTED),
        (r"\operatorname{rank} J = 2 \iff \sin\theta_2 \neq 0", Verdict.PROVED),
        (r"\operatorname{rank} J = 1.5 \iff \sin\theta_2 = 0", Verdict.UNCHECKED),
        (r"\theta_1 + \theta_2 = 0 \Rightarrow s_{12} = 0", Verdict.PROVED),
        (r"s_{12} = 0 \Rightarrow \theta_1 + \theta_2 = 0", Verdict.REFUTED),
        (r"\sin^7\theta_2 = 0 \iff \det J = 0", Verdict.PROVED),  # a power above any bound
        (r"\det J = 0 \Rightarrow \theta_2 = 0 \text{ and } \theta_1 = 0", Verdict.REFUTED),
        (r"\theta_2 = 0 \text{ and } \theta_1 = 0 \Rightarrow \det J = 0", Verdict.PROVED),
        (r"l_1 = l_2 \text{ and } \theta_2 = \pi \Rightarrow P_x = 0", Verdict.PROVED),
        (r"P_x = 0 \Leftarrow \theta_2 = \pi", Verdict.REFUTED),
    ],
)
def test_conditions_are_read_in_many_forms(judge: Judge, latex: str, verdict: Verdict) -> None:
    assert judge(latex, **PLANAR).verdict is verdict


REDUNDANT = {"arm": "planar_3r", "quantities": {"J": {"jacobian": 3, "rows": [1, 2]}}}


@pytest.mark.parametrize(
    ("latex", "verdict"),
    [
        (r"\det(J J^T) = 0 \iff S_2 = 0 \text{ and } S_3 = 0", Verdict.PROVED),
        (r"\det(J J^T) = 0 \iff \theta_2 \in \{0, \pi\} \text{ and } \theta_3 \in \{0, \pi\}", Verdict.PROVED),
        (r"\operatorname{rank} J = 1 \iff S_2 = 0 \text{ and } S_3 = 0", Verdict.PROVED),
        (r"\det(J J^T) = 0 \iff S_2 = 0", Verdict.REFUTED),
        (r"\det(J J^T) = 0 \iff S_2 = 0 \text{ or } S_3 = 0", Verdict.REFUTED),
        (r"\det(J J^T) = 0 \iff \theta_2 = 0 \text{ and } \theta_3 = 0", Verdict.REFUTED),
        (r"\det(J J^T) = 0 \iff S_2 = 0 \text{ and } C_3 = 0", Verdict.REFUTED),
    ],
)
def test_a_matrix_that_is_not_square_loses_rank_where_all_minors_vanish(
    judge: Judge, latex: str, verdict: Verdict
) -> None:
    assert judge(latex, **REDUNDANT).verdict is verdict


RX90 = {"arm": "rx90", "quantities": {"J": {"jacobian": 6}}}
KR210 = {"arm": "kr210", "quantities": {"J": {"jacobian": "G"}}}
WRIST, SHOULDER = "S_5 = 0", "a_1 + a_2 S_2 + (d_4 + d_5) C_{23} - a_3 S_{23} = 0"


@pytest.mark.parametrize(
    ("front", "latex", "verdict"),
    [
        (RX90, r"S_5 = 0 \text{ or } C_3 = 0 \text{ or } C_2 a_3 = S_{23} d_3", Verdict.PROVED),
        (RX90, r"S_5 = 0 \text{ or } C_3 = 0", Verdict.REFUTED),  # the shoulder is forgotten
        (RX90, r"S_5 = 0 \text{ or } C_3 = 0 \text{ or } C_2 d_3 = S_{23} a_3", Verdict.REFUTED),  # swapped lengths
        (RX90, r"S_5 = 0 \text{ or } S_3 = 0 \text{ or } C_2 a_3 = S_{23} d_3", Verdict.REFUTED),
        (RX90, r"S_5 = 0 \text{ or } C_3 = 0 \text{ or } C_2 a_3 = S_{23} d_3 \text{ or } C_4 = 0", Verdict.REFUTED),
        (KR210, rf"{WRIST} \text{{ or }} (d_4 + d_5) C_3 = a_3 S_3 \text{{ or }} {SHOULDER}", Verdict.PROVED),
        (KR210, rf"{WRIST} \text{{ or }} \tan\theta_3 = \frac{{d_4 + d_5}}{{a_3}} \text{{ or }} {SHOULDER}", Verdict.PROVED),
        (KR210, rf"{WRIST} \text{{ or }} d_4 C_3 = a_3 S_3 \text{{ or }} {SHOULDER}", Verdict.REFUTED),
        (KR210, rf"{WRIST} \text{{ or }} (d_4 + d_5) C_3 = a_3 S_3", Verdict.REFUTED),
    ],
)  # fmt: skip
def test_the_singular_set_of_a_six_axis_arm(judge: Judge, front: Any, latex: str, verdict: Verdict) -> None:
    record = judge(rf"\det J = 0 \iff {latex}", **front)
    assert record.verdict is verdict, record.message
    assert bool(record.counterexample) == (verdict is Verdict.REFUTED)


def test_a_counterexample_off_quarter_turns_is_a_singular_configuration(judge: Judge) -> None:
    record = judge(r"\det J = 0 \iff S_5 = 0 \text{ or } C_3 = 0", **RX90)
    arm = load_arm("rx90")
    q = np.array([[record.counterexample.get(joint.symbol, 0.3) for joint in arm.joints]])
    assert abs(np.linalg.det(NumericKinematics(arm, q).jacobian("6")[0])) < 1e-12
    assert abs(np.sin(q[0, 4])) > 1e-3 and abs(np.cos(q[0, 2])) > 1e-3


def test_a_matrix_that_vanishes_under_a_condition(judge: Judge) -> None:
    null = r"J \begin{bmatrix} l_2 \\ -l_1 - l_2 \end{bmatrix} = \begin{bmatrix} 0 \\ 0 \end{bmatrix} \text{ if } \theta_2 = "
    assert judge(null + "0", **PLANAR).verdict is Verdict.PROVED
    assert judge(null + r"\pi", **PLANAR).verdict is Verdict.REFUTED


@pytest.mark.parametrize(
    "latex",
    [
        r"T^0_1 = 0 \Rightarrow \theta_1 = 0",
        r"\det J = 0 \iff \theta_2 = \frac{k}{3}",
        r"\cos\theta_1 + 2 = 0 \Rightarrow \cos\theta_2 = 0",  # true of nothing, which is not shown
    ],
)
def test_what_is_not_decided_is_not_claimed(judge: Judge, latex: str) -> None:
    record = judge(latex, **PLANAR)
    assert record.verdict is Verdict.UNCHECKED and record.message


def test_an_arrow_between_true_steps_is_a_derivation(judge: Judge) -> None:
    assert judge(r"c_1 = \cos\theta_1 \Rightarrow c_1^2 = 1 - s_1^2", **PLANAR).verdict is Verdict.PROVED
    record = judge(r"c_1 = \cos\theta_1 \Rightarrow c_1^2 = 1 + s_1^2", **PLANAR)
    assert record.verdict is Verdict.REFUTED and [entry.equation for entry in record.entries] == [2]
    assert judge(r"c_1 = \sin\theta_1 \Rightarrow c_1^2 = 1 - s_1^2", **PLANAR).verdict is Verdict.REFUTED


@pytest.mark.parametrize("latex", [r"\theta_1 = 0", r"\theta_2 = \frac{\pi}{2}", r"\det J = 0", r"a_1 \neq a_2", r"-\pi \le \theta_1 \le \pi", r"l_1 > 0"])  # fmt: skip
def test_a_condition_alone_claims_nothing(judge: Judge, latex: str) -> None:
    assert judge(latex, **PLANAR).verdict in (Verdict.DEFINED, Verdict.UNCHECKED)


def test_a_determinant_that_vanishes_everywhere_is_a_claim(judge: Judge) -> None:
    assert judge(r"\det(J^T z_1) = 0", **PLANAR).verdict is not Verdict.PROVED
    assert judge(r"\det(\begin{bmatrix} c_1 & s_1 \\ c_1 & s_1 \end{bmatrix}) = 0", **PLANAR).verdict is Verdict.PROVED


@pytest.mark.parametrize(
    ("latex", "verdict"),
    [
        (r"\left. J \right|_{\theta_2 = 0} = \begin{bmatrix} -(l_1 + l_2) s_1 & -l_2 s_1 \\ (l_1 + l_2) c_1 & l_2 c_1 \end{bmatrix}", Verdict.PROVED),
        (r"\left. J \right|_{\theta_2 = \pi} = \begin{bmatrix} -(l_1 + l_2) s_1 & -l_2 s_1 \\ (l_1 + l_2) c_1 & l_2 c_1 \end{bmatrix}", Verdict.REFUTED),
        (r"\left. \det J \right|_{\theta_2 = 0} = 0", Verdict.PROVED),
        (r"\left. \det J \right|_{\theta_1 = 0} = 0", Verdict.REFUTED),
        (r"\left. P_x \right|_{\theta_2 = \pi,\ l_2 = l_1} = 0", Verdict.PROVED),
        (r"\left. P_x \right|_{\theta_2 = \pi} = 0", Verdict.REFUTED),
        (r"\operatorname{rank}\left(\left. J \right|_{\theta_2 = 0}\right) = 1", Verdict.PROVED),
        (r"\operatorname{rank}\left(\left. J \right|_{\theta_2 = 0}\right) = 2", Verdict.REFUTED),
    ],
)  # fmt: skip
def test_values_at_a_configuration_are_exact(judge: Judge, latex: str, verdict: Verdict) -> None:
    assert judge(latex, **PLANAR).verdict is verdict


# -- sizes, inequalities, approximations -----------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("latex", "verdict", "message"),
    [
        (r"J \in \mathbb{R}^{6 \times 4}", Verdict.PROVED, "the size"),
        (r"J \in \mathbb{R}^{4 \times 6}", Verdict.REFUTED, "the matrix is 6×4, not 4×6"),
        (r"p_4 \in \mathbb{R}^3", Verdict.PROVED, "the size"),
        (r"q \in \mathbb{R}^3", Verdict.REFUTED, "the matrix is 4×1, not 3×1"),
        (r"c_1^2 + s_1^2 \neq 1", Verdict.REFUTED, "the two sides are equal for every configuration"),
        (r"c_1 \neq s_1", Verdict.UNCHECKED, "a condition, not a claim"),
        (r"c_1^2 \le 1", Verdict.CONFIRMED, "an inequality holds at every sample"),
        (r"0 \le c_1^2 \le 1", Verdict.CONFIRMED, "an inequality holds at every sample"),
        (r"0 \le c_1^2 \le \frac12", Verdict.UNCHECKED, "a condition, not a claim"),
        (r"2 \le c_1^2", Verdict.REFUTED, "the inequality fails at some configurations"),
        (r"c_1^2 < 1", Verdict.UNCHECKED, "a condition, not a claim"),
        (r"c_1 < \frac12", Verdict.UNCHECKED, "a condition, not a claim"),
        (r"\frac{\pi}{5} \approx 0.628", Verdict.CONFIRMED, "an approximation, to the decimals printed"),
        (r"\frac{\pi}{5} \approx 0.5", Verdict.REFUTED, "an approximation, to the decimals printed"),
        (r"c_1 \approx 1", Verdict.UNCHECKED, "a condition, not a claim"),
        (r"{}^0R_4 \in SO(3)", Verdict.PROVED, "an element of SO(3)"),
        (r"\begin{bmatrix} c_1 & -s_1 \\ s_1 & c_1 \end{bmatrix} \in SO(2)", Verdict.PROVED, "an element of SO(2)"),
        (
            r"\begin{bmatrix} c_1 & s_1 \\ s_1 & -c_1 \end{bmatrix} \in SO(2)",
            Verdict.REFUTED,
            "no element of SO(2): its rotation is not orthonormal with determinant 1",
        ),
    ],
)
def test_relations_other_than_equality(judge: Judge, latex: str, verdict: Verdict, message: str) -> None:
    record = judge(latex)
    assert (record.verdict, record.message) == (verdict, message)


def test_what_rates_do_not_imply_is_left_open(judge: Judge) -> None:
    """At rest something may hold that does not hold everywhere; without a rate it is refuted."""
    at_rest = judge(r"\dot\theta_1 = 0 \Rightarrow c_1 = 0", arm="planar_2r")
    assert at_rest.verdict is Verdict.UNCHECKED and "where joints are at rest" in at_rest.message
    assert judge(r"\theta_1 = 0 \Rightarrow c_1 = 0", arm="planar_2r").verdict is Verdict.REFUTED


@pytest.mark.parametrize(("items", "verdict"), [("-1, 1", "proved"), ("-1, 2", "unchecked"), ("-1, x", "unchecked")])
def test_a_sign_is_one_of_two_numbers(judge: Judge, items: str, verdict: str) -> None:
    assert judge(rf"\sigma \in \{{{items}\}}", r"\sigma^2 = 1").verdict.value == verdict


def test_cases_are_checked_each_under_its_condition(judge: Judge) -> None:
    right = r"x(\sigma) = \begin{cases} a & \text{if } \sigma = 0 \\ b & \text{if } \sigma = 1 \end{cases}"
    general = {"arm": None}
    both = (r"y = (1 - \sigma) a + \sigma b", r"y = \begin{cases} a & \sigma = 0 \\ b & \sigma = 1 \end{cases}")
    assert judge(*both, **general).verdict is Verdict.PROVED
    assert judge(*both, both[1].replace("1 \\end", "2 \\end"), **general).verdict is Verdict.REFUTED
    assert judge(right, **general).verdict is not Verdict.PROVED


@pytest.mark.parametrize(
    ("latex", "verdict"),
    [
        (r"\theta_2 = 0 \Rightarrow l_1 + l_2 = \pm\sqrt{P_x^2 + P_y^2}", Verdict.PROVED),
        (r"\theta_2 = 0 \Rightarrow l_1 - l_2 = \pm\sqrt{P_x^2 + P_y^2}", Verdict.REFUTED),
        (r"s_2 = 0 \Rightarrow l_1 + l_2 = \pm\sqrt{P_x^2 + P_y^2}", Verdict.REFUTED),
    ],
)
def test_a_root_of_either_sign_is_a_conclusion(judge: Judge, latex: str, verdict: Verdict) -> None:
    front = {"P_x": {"origin": 2, "component": "x"}, "P_y": {"origin": 2, "component": "y"}}
    assert judge(latex, arm="planar_2r", quantities=front).verdict is verdict


def test_two_roots_whose_product_is_a_third_are_compared(judge: Judge) -> None:
    front = {"P_x": {"origin": 6, "component": "x"}, "P_y": {"origin": 6, "component": "y"}}
    record = judge(r"C_3 = 0 \iff S_5 = \pm\sqrt{P_x^2 + P_y^2}", arm="rx90", quantities=front)
    assert record.verdict is Verdict.REFUTED


@pytest.mark.parametrize(
    ("latex", "verdict"),
    [
        (r"\begin{matrix} c_2 = 1 & s_2 = 0 & \Rightarrow & \theta_2 = 0 \end{matrix}", Verdict.PROVED),
        (r"\begin{matrix} c_2 = 1 & s_2 = 0 & \Rightarrow & \theta_2 = \pi \end{matrix}", Verdict.REFUTED),
        (r"\begin{matrix} s_2 = 0 & \Rightarrow & \theta_2 = 0 \end{matrix}", Verdict.REFUTED),
        (  # the lines of one system: the first says what the second needs
            r"\begin{matrix} c_1 = 1 & s_1 = 0 & \Rightarrow & \theta_1 = 0 \\ s_{12} = 0 && \Rightarrow & s_2 = 0 \end{matrix}",
            Verdict.UNCHECKED,
        ),
    ],
)
def test_equations_in_the_cells_before_an_arrow_hold_together(judge: Judge, latex: str, verdict: Verdict) -> None:
    assert judge(latex, **PLANAR).verdict is verdict


def test_a_cosine_without_an_arm_is_of_the_letter_that_the_document_uses(judge: Judge) -> None:
    premises = r"c_1 = 1 \text{ and } s_1 = 0 \Rightarrow q_1 = 0"
    assert (
        judge(r"R = \begin{bmatrix} c_1 & -s_1 \\ s_1 & c_1 \end{bmatrix}", premises, arm=None).verdict
        is not Verdict.REFUTED
    )


@pytest.mark.parametrize(
    ("latex", "verdict"),
    [
        (r"s_2^2 + s_3^2 = 0 \iff s_2 = 0 \text{ and } s_3 = 0", Verdict.UNCHECKED),
        (r"(1 - c_2)^2 + (1 - c_3)^2 = 0 \Rightarrow s_2 = 0", Verdict.UNCHECKED),
        (r"s_2 + s_3 = 2 \Rightarrow c_2 = 0", Verdict.UNCHECKED),
        (r"-(-\det(J J^T)) = 0 \iff s_2 = 0 \text{ and } s_3 = 0", Verdict.UNCHECKED),
        (r"s_2^2 + s_3^2 = 1 \Rightarrow s_2 = 0", Verdict.REFUTED),
        (r"s_2^2 - s_3^2 = 0 \iff s_2 = 0 \text{ and } s_3 = 0", Verdict.REFUTED),
        (r"s_2 + s_3 = 1 \Rightarrow c_2 = c_3", Verdict.REFUTED),
        (r"\det(J J^T) = 0 \iff s_2 = 0", Verdict.REFUTED),
    ],
)
def test_what_is_zero_to_rounding_beside_its_zeros_refutes_nothing(judge: Judge, latex: str, verdict: Verdict) -> None:
    """A sum of squares is 0 to rounding also where what is squared is not: det(J Jᵀ) = 0 was said to leave out -7e-6."""
    arm = {"arm": "planar_3r", "quantities": {"J": {"jacobian": 3, "rows": [1, 2]}}}
    assert judge(latex, **arm).verdict is verdict
