"""What an adversary would try: each false equation is refuted, and its true neighbour still passes."""

from __future__ import annotations

import time
from collections.abc import Callable

import pytest

from armproof.verification.check import SECONDS_TO_DECIDE, SECONDS_TO_EXPLAIN
from armproof.verification.verdict import DocumentResult, Record, Verdict

Check = Callable[..., DocumentResult]
Judge = Callable[..., Record]
GOOD = ("proved", "confirmed")
PLANE = {"P_x": {"origin": 2, "component": "x"}, "P_y": {"origin": 2, "component": "y"}}

CLASSIC = r"""\begin{bmatrix} c\theta_i & -s\theta_i c\alpha_i & s\theta_i s\alpha_i & a_i c\theta_i \\ s\theta_i & c\theta_i c\alpha_i &
-c\theta_i s\alpha_i & a_i s\theta_i \\ 0 & s\alpha_i & c\alpha_i & d_i \\ 0 & 0 & 0 & 1 \end{bmatrix}"""
CLASSIC_INVERSE = r"""\begin{bmatrix} c\theta_i & s\theta_i & 0 & -a_i \\ -s\theta_i c\alpha_i & c\theta_i c\alpha_i & s\alpha_i &
-d_i s\alpha_i \\ s\theta_i s\alpha_i & -c\theta_i s\alpha_i & c\alpha_i & -d_i c\alpha_i \\ 0 & 0 & 0 & 1 \end{bmatrix}"""
MODIFIED = r"""\begin{bmatrix} c\theta_i & -s\theta_i & 0 & a_{i-1} \\ s\theta_i c\alpha_{i-1} & c\theta_i c\alpha_{i-1} & -s\alpha_{i-1} &
-d_i s\alpha_{i-1} \\ s\theta_i s\alpha_{i-1} & c\theta_i s\alpha_{i-1} & c\alpha_{i-1} & d_i c\alpha_{i-1} \\ 0 & 0 & 0 & 1 \end{bmatrix}"""


def told(result: DocumentResult) -> list[str]:
    return [record.verdict.value for record in result.equations]


def tell_apart(check: Check, pairs: list[tuple[str, str]], before: tuple[str, ...] = (), **front: object) -> None:
    """Check every true equation and its false neighbour in one document."""
    displays = [*before, *(latex for pair in pairs for latex in pair)]
    verdicts = told(check(*displays, **front))[len(before) :]
    wrong = [
        f"{latex}: {verdict}"
        for k, (latex, verdict) in enumerate(zip(displays[len(before) :], verdicts, strict=True))
        if (verdict not in GOOD if k % 2 == 0 else verdict != "refuted")
    ]
    assert not wrong, "\n".join(wrong)


# -- whole turns, branches, roots ----------------------------------------------------------------------------------------


def test_a_whole_turn_is_granted_to_arc_functions_only(check: Check) -> None:
    before = (r"x = \sqrt{l_1^2 + l_2^2}", r"\beta = \operatorname{atan2}(l_2 s_2, l_1 + l_2 c_2)")
    pairs = [
        (r"\operatorname{atan2}(s_1, c_1) = \theta_1 + 2\pi", r"\theta_1 = \theta_1 + 2\pi"),
        (r"\operatorname{atan2}(-s_1, -c_1) = \theta_1 - \pi", r"\operatorname{atan2}(-s_1, -c_1) = \theta_1"),
        (r"2\pi - \pi = \pi", r"2\pi = 0"),
        (r"l_1 c_1 = c_1 l_1", r"l_1 c_1 = l_1 c_1 + 2\pi"),
    ]
    tell_apart(check, pairs, before, arm="planar_2r")


def test_a_root_has_one_sign(check: Check) -> None:
    pairs = [
        (r"\sqrt{s_1^2} = |s_1|", r"\sqrt{s_1^2} = s_1"),
        (r"|c_1|^2 = c_1^2", r"|c_1| = c_1"),
        (r"\sqrt{(2 - c_1)^2} = 2 - c_1", r"\sqrt{(2 - c_1)^2} = c_1 - 2"),
        (r"\frac{1}{\sqrt{(3 - s_1)^2}} = \frac{1}{3 - s_1}", r"\frac{1}{\sqrt{(3 - s_1)^2}} = \frac{1}{s_1 - 3}"),
        (r"\sqrt{1 + c_1}\sqrt{1 - c_1} = |s_1|", r"\sqrt{1 + c_1}\sqrt{1 - c_1} = s_1"),
        (r"\sqrt{3 - 2\sqrt{2}} = \sqrt{2} - 1", r"\sqrt{3 - 2\sqrt{2}} = 1 - \sqrt{2}"),
        (r"\sqrt{l_1 l_2} = \sqrt{l_1}\sqrt{l_2}", r"\sqrt{l_1 + l_2} = \sqrt{l_1} + \sqrt{l_2}"),
        (r"\sin(\arccos c_1) = |s_1|", r"\sin(\arccos c_1) = s_1"),
        (r"\sqrt{(l_1 - l_2)^2} = |l_1 - l_2|", r"\sqrt{(l_1 - l_2)^2} = l_1 - l_2"),  # whatever this arm's lengths
        (r"\sqrt{(l_2 - l_1)^2} = |l_1 - l_2|", r"\sqrt{(l_2 - l_1)^2} = l_2 - l_1"),
    ]
    tell_apart(check, pairs, arm="planar_2r")


@pytest.mark.parametrize("false", [r"s_1", r"-c_1", r"c_1 - 2"])
def test_the_correction_of_a_root_holds(judge: Judge, false: str) -> None:
    (entry,) = judge(rf"\sqrt{{({false})^2}} = {false}", arm="planar_2r").entries
    assert judge(rf"\sqrt{{({false})^2}} = {entry.correct}", arm="planar_2r").verdict.value in GOOD


def test_roots_of_large_numbers_are_those_of_their_primes(check: Check) -> None:
    pairs = [
        (r"\sqrt{100160063} = \sqrt{10007}\sqrt{10009}", r"\sqrt{100160063} = \sqrt{10007}\sqrt{10037}"),
        (r"\sqrt{2 \cdot 10007^2} = 10007\sqrt{2}", r"\sqrt{2 \cdot 10007^2} = 10009\sqrt{2}"),
    ]
    assert told(check(*(latex for pair in pairs for latex in pair))) == ["proved", "refuted"] * 2


def test_a_number_too_large_to_factor_costs_no_time_and_refutes_nothing_true(check: Check) -> None:
    p, q = 10**30 + 57, 10**33 + 61  # primes; the factors of their product are not sought
    started = time.process_time()
    true, squared, next_display = told(
        check(rf"\sqrt{{{p} \cdot {q}}} = \sqrt{{{p}}}\sqrt{{{q}}}", rf"\sqrt{{5 \cdot {q}^2}} = {q}\sqrt{{5}}",
              r"2 = 3")
    )  # fmt: skip
    assert (true, squared, next_display) == ("unchecked", "proved", "refuted")
    assert time.process_time() - started < 3.0


def test_many_fractions_of_an_angle_cost_one_display_and_not_the_document(check: Check) -> None:
    half, third = r"\frac{\theta_1}{2}", r"\frac{\theta_1}{3}"
    displays = {
        r"P_x = l_1 c_1 + l_2 c_{12}": "proved",
        rf"\cos\theta_1 = 2\cos^2{half} - 1": "proved",
        rf"\cos\theta_1 = 2\cos^2{half} + 1": "refuted",
        rf"\cos\theta_1 = 4\cos^3{third} - 3\cos{third}": "proved",
        r"\cos\frac{2\theta_1}{5} = 2\cos^2\frac{\theta_1}{5} - 1": "unchecked",
        r"\cos\frac{2\theta_2}{5} = 2\cos^2\frac{\theta_2}{5} - 1": "proved",
        r"P_y = l_1 s_1 + l_2 s_{12}": "proved",
        r"P_y = l_1 s_1 - l_2 s_{12}": "refuted",
        rf"\sqrt{{\frac{{1 + c_1}}{{2}}}} = \left|\cos{half}\right|": "confirmed",
        rf"\sin\theta_1 = 2\sin{half}\cos{half}": "proved",
    }
    assert told(check(*displays, arm="planar_2r", quantities=PLANE)) == list(displays.values())


def test_constant_angles_that_depend_on_each_other_are_no_false_alarm(check: Check) -> None:
    pairs = [
        (r"\cos\frac{\pi}{5} = \frac{1 + \sqrt{5}}{4}", r"\cos\frac{\pi}{5} = \frac{1 - \sqrt{5}}{4}"),
        (r"\cos\frac{2\pi}{5} = 2\cos^2\frac{\pi}{5} - 1", r"\cos\frac{2\pi}{5} = 2\cos^2\frac{\pi}{5} - 2"),
        (r"\cos 0.6 = 2\cos^2 0.3 - 1", r"\cos 0.6 = 1 - 2\cos^2 0.3"),
        (r"\cos 36^\circ = \cos\frac{\pi}{5}", r"\cos 36^\circ = \sin\frac{\pi}{5}"),
    ]
    tell_apart(check, pairs, arm="planar_2r")


def test_the_cosine_of_what_is_no_angle_is_sampled(check: Check) -> None:
    tell_apart(
        check,
        [(r"\cos(\theta_1\theta_2) = \cos(\theta_2\theta_1)", r"\cos(\theta_1\theta_2) = c_1 c_2")],
        arm="planar_2r",
    )


def test_rounding_excuses_no_wrong_digit(check: Check) -> None:
    arm = {"dh": "classic", "rows": [{"a": 0.0825, "alpha": "pi/2", "d": 0.333, "theta": "theta_1"}]}
    point = r"p_1 = \begin{bmatrix} %s c_1 \\ 0.0825 s_1 \\ %s \end{bmatrix}"
    pairs = [
        (point % ("0.0825", "0.333"), point % ("0.0825", "0.334")),
        (point % (".08250", "0.3330"), point % ("0.0826", "0.333")),
        (r"\sqrt{2} = 1.4142", r"\sqrt{2} = 1.4242"),
        (r"\frac{1}{3} = 0.3333", r"\frac{1}{3} = 0.3433"),
        (r"\cos 0.3 = 0.9553", r"\cos 0.3 = 0.9653"),
        (r"c_1 = 1.000 c_1", r"c_1 = 1.001 c_1"),
        (r"c_1 + 0.001 = 0.001 + c_1", r"c_1 + 0.001 = c_1"),
    ]
    tell_apart(check, pairs, arm=arm)


# -- sizes ---------------------------------------------------------------------------------------------------------------


def test_the_fourth_coordinate_tells_a_point_from_a_direction(check: Check) -> None:
    point = r"\begin{bmatrix} l_1 c_1 + l_2 c_{12} \\ l_1 s_1 + l_2 s_{12} \\ 0 \\ %d \end{bmatrix}"
    axis = r"\begin{bmatrix} 0 \\ 0 \\ 1 \\ %d \end{bmatrix}"
    tell_apart(
        check,
        [(f"p_2 = {point % 1}", f"p_2 = {point % 0}"), (f"z_2 = {axis % 0}", f"z_2 = {axis % 1}")],
        arm="planar_2r",
    )


def test_the_rotation_of_the_plane_may_stand_without_its_third_row(check: Check) -> None:
    rotation = r"{}^0R_2 = \begin{bmatrix} c_{12} & %ss_{12} \\ s_{12} & c_{12} \end{bmatrix}"
    tell_apart(check, [(rotation % "-", rotation % "")], arm="planar_2r")


def test_a_row_of_zeros_is_not_the_plane_of_motion(check: Check) -> None:
    upper = r"-l_1 s_1 - l_2 s_{12} & -l_2 s_{12}"
    pairs = [
        (
            rf"J = \begin{{bmatrix}} {upper} \\ l_1 c_1 + l_2 c_{{12}} & l_2 c_{{12}} \end{{bmatrix}}",
            rf"J = \begin{{bmatrix}} {upper} \\ 0 & 0 \end{{bmatrix}}",
        )
    ]
    tell_apart(check, pairs, arm="planar_2r")


def test_listed_rows_are_the_rows_that_are_meant(check: Check) -> None:
    upper = r"-l_1 s_1 - l_2 s_{12} & -l_2 s_{12} \\ l_1 c_1 + l_2 c_{12} & l_2 c_{12}"
    linear, angular = (
        rf"\begin{{bmatrix}} {upper} \\ 0 & 0 \end{{bmatrix}}",
        r"\begin{bmatrix} 0 & 0 \\ 0 & 0 \\ 1 & 1 \end{bmatrix}",
    )
    planar = rf"\begin{{bmatrix}} {upper} \\ 1 & 1 \end{{bmatrix}}"
    quantities = {
        "J_P": {"jacobian": 2, "rows": [1, 2, 3]},
        "J_w": {"jacobian": 2, "rows": [4, 5, 6]},
        "J_3": {"jacobian": 2, "rows": [1, 2, 6]},
    }
    pairs = [
        (f"J_P = {linear}", f"J_P = {angular}"),
        (f"J_w = {angular}", f"J_w = {linear}"),
        (f"J_3 = {planar}", f"J_3 = {linear}"),
    ]
    tell_apart(check, pairs, arm="planar_2r", quantities=quantities)


def test_the_derivative_of_a_jacobian_has_the_rows_that_are_printed(check: Check) -> None:
    rate = r"(\dot\theta_1 + \dot\theta_2)"
    rows = rf"-l_1 c_1\dot\theta_1 - l_2 c_{{12}} {rate} & -l_2 c_{{12}} %s \\ -l_1 s_1\dot\theta_1 - l_2 s_{{12}} {rate} & -l_2 s_{{12}} {rate}"
    matrix = rf"\dot J = \begin{{bmatrix}} {rows} \end{{bmatrix}}"
    tell_apart(check, [(matrix % rate, matrix % r"\dot\theta_2")], arm="planar_2r")


def test_the_rank_is_that_of_a_generic_configuration(check: Check) -> None:
    at = r"\operatorname{rank}\left(\left. J \right|_{\theta_2 = 0}\right) = %d"
    tell_apart(check, [(r"\operatorname{rank} J = 4", r"\operatorname{rank} J = 3"), (at % 3, at % 4)], arm="scara")
    tell_apart(check, [(r"\operatorname{rank} J = 6", r"\operatorname{rank} J = 5")], arm="rx90")


# -- configurations ------------------------------------------------------------------------------------------------------


def test_lengths_and_constant_angles_may_be_given_values(check: Check) -> None:
    arm = {"dh": "classic", "rows": [{"a": "a_1", "alpha": "alpha_1", "d": "d_1 + h", "theta": "theta_1"}]}
    pairs = [
        (
            r"\left. z_1 \right|_{\alpha_1 = \frac{\pi}{2}} = \begin{bmatrix} s_1 \\ -c_1 \\ 0 \end{bmatrix}",
            r"\left. z_1 \right|_{\alpha_1 = 0} = z_1",
        ),
        (
            r"\left. p_1 \right|_{h = -d_1} = \begin{bmatrix} a_1 c_1 \\ a_1 s_1 \\ 0 \end{bmatrix}",
            r"\left. p_1 \right|_{h = d_1} = p_1",
        ),
    ]
    tell_apart(check, pairs, arm=arm)


# -- definitions ---------------------------------------------------------------------------------------------------------


def test_a_name_is_not_defined_by_itself(check: Check) -> None:
    assert told(check("x = a + 1", arm=None)) == ["unchecked"]
    assert told(check("x = x + 1", arm=None)) == ["unchecked"]  # what a program writes
    assert told(check("a_1 = a_1 + 1", arm="scara")) == ["refuted"]


def test_a_matrix_of_new_letters_is_defined_by_a_formula(check: Check) -> None:
    result = check(
        r"A = \begin{bmatrix} 1 & a \\ 0 & 1 \end{bmatrix}",
        r"\begin{bmatrix} u \\ v \end{bmatrix} = A \begin{bmatrix} 1 \\ 1 \end{bmatrix}",
        "u = 1 + a", "u = 1 - a", r"A = \begin{bmatrix} 1 & b \\ 0 & 1 \end{bmatrix}",
        arm=None,
    )  # fmt: skip
    assert told(result) == ["defined", "defined", "proved", "refuted", "unchecked"]


def test_without_an_arm_a_slip_is_refuted_where_another_line_shows_what_is_defined_and_nothing_else(
    check: Check,
) -> None:
    columns = r"M = \begin{bmatrix} \frac{\partial R}{\partial\alpha} & \frac{\partial R}{\partial\beta} \end{bmatrix}"
    own = r"K = \begin{bmatrix} b \cos q_1 & h \cos q_2 \\ b \sin q_1 & h \sin q_2 \end{bmatrix}"
    other = own.replace(r"h \sin q_2", r"h \cos q_2")
    assert told(check(columns, r"\det M = \cos\beta", r"\cos\theta_2 = 0", arm=None))[1:] == ["unchecked"] * 2
    right, wrong = (rf"\det K = b h \sin({angle})" for angle in ("q_2 - q_1", "q_1 - q_2"))
    assert told(check(own, other, wrong, arm=None)) == ["unchecked"] * 3
    assert told(check(own, right, other, wrong, arm=None))[1:] == ["proved", "refuted", "refuted"]


def test_a_letter_met_twice_has_one_value_in_an_erratum_too(check: Check) -> None:
    pattern = r"\begin{bmatrix} u & v \\ v & u \end{bmatrix} = \begin{bmatrix} c_1 & s_1 \\ %ss_1 & c_1 \end{bmatrix}"
    assert told(check(errata=(pattern % "", pattern % "-"), arm="planar_2r")) == ["unchecked", "refuted"]


# -- general statements --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("link", [CLASSIC, MODIFIED])
@pytest.mark.parametrize(
    ("name", "inverse"), [("{}^{i-1}T_i", False), ("A_i", False), ("({}^{i-1}T_i)^{-1}", True), ("A_i^{-1}", True)]
)
@pytest.mark.parametrize("arm", [None, "rx90"])
def test_a_link_matrix_is_not_its_inverse(judge: Judge, name: str, inverse: bool, link: str, arm: str | None) -> None:
    assert (judge(f"{name} = {link}", arm=arm).verdict is Verdict.PROVED) is not inverse
    if link is CLASSIC:
        assert (judge(f"{name} = {CLASSIC_INVERSE}", arm=arm).verdict is Verdict.PROVED) is inverse
    if inverse:
        assert judge(f"{name} = {link}", arm=arm).verdict is Verdict.REFUTED


@pytest.mark.parametrize(
    ("link", "right", "wrong"),
    [
        (CLASSIC, r"c\alpha_i", r"c\alpha_{i-1}"),
        (CLASSIC, r"& d_i", r"& d_{i-1}"),
        (MODIFIED, r"s\alpha_{i-1}", r"s\alpha_i"),
        (MODIFIED, r"a_{i-1} \\", r"a_i \\"),
        (MODIFIED, r"-d_i", r"-a_i"),
    ],
)
def test_an_index_of_the_other_convention_is_refuted(judge: Judge, link: str, right: str, wrong: str) -> None:
    assert right in link and judge(f"{{}}^{{i-1}}T_i = {link}", arm=None).verdict is Verdict.PROVED
    assert judge(f"{{}}^{{i-1}}T_i = {link.replace(right, wrong, 1)}", arm=None).verdict is Verdict.REFUTED
    assert judge(f"{{}}^{{i-1}}T_i = {link.replace(right, wrong)}", arm=None).verdict is Verdict.REFUTED


def test_the_documents_own_link_matrix_stays_its_own(check: Check) -> None:
    own = r"A_i = \begin{bmatrix} c\theta_i & -s\theta_i & 0 & a_i c\theta_i \\ s\theta_i & c\theta_i & 0 & a_i s\theta_i \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}"
    assert told(check(own, own, own.replace("-s", "s"), arm=None)) == ["defined", "defined", "refuted"]


# -- conditions ----------------------------------------------------------------------------------------------------------


def test_conditions_hold_on_either_branch(check: Check) -> None:
    pairs = [
        (r"c_2 = 0 \Rightarrow \theta_2 = \pm\frac{\pi}{2}", r"c_2 = 0 \Rightarrow \theta_2 = \frac{\pi}{2}"),
        (r"s_2 = 0 \Rightarrow c_2 = \pm 1", r"s_2 = 0 \Rightarrow c_2 = 1"),
        (
            r"c_2 = 0 \Leftrightarrow \theta_2 = \pm\frac{\pi}{2}",
            r"s_2 = 0 \Leftrightarrow \theta_2 = \pm\frac{\pi}{2}",
        ),
    ]
    tell_apart(check, pairs, arm="planar_2r")


def test_two_sides_that_are_no_identity_may_be_a_condition(check: Check) -> None:
    pairs = [
        (
            r"c_1 = s_1 \Rightarrow \theta_1 = \frac{\pi}{4} \text{ or } \theta_1 = \frac{5\pi}{4}",
            r"P_x = l_1 c_1 \Rightarrow P_x - l_1 c_1 = 0",
        ),
        (
            r"P_x = l_1 c_1 + l_2 c_{12} \Rightarrow P_x - l_1 c_1 = l_2 c_{12}",
            r"P_x = l_1 c_1 - l_2 c_{12} \Rightarrow P_x - l_1 c_1 = -l_2 c_{12}",
        ),
    ]
    tell_apart(check, pairs[1:], arm="planar_2r", quantities=PLANE)
    assert told(check(pairs[0][0], arm="planar_2r")) == ["proved"]


def test_a_matrix_may_follow_from_a_condition(check: Check) -> None:
    matrix = r"p_2 = \begin{bmatrix} (l_1 %s l_2) c_1 \\ (l_1 + l_2) s_1 \\ 0 \end{bmatrix}"
    pairs = [
        (rf"\theta_2 = 0 \Rightarrow {matrix % '+'}", rf"\theta_2 = 0 \Rightarrow {matrix % '-'}"),
        (rf"{matrix % '+'} \text{{ if }} \theta_2 = 0", rf"{matrix % '+'} \text{{ if }} \theta_2 = \pi"),
    ]
    tell_apart(check, pairs, arm="planar_2r")


def test_a_letter_may_vanish_where_a_length_does_not(check: Check) -> None:
    assert told(check(r"l_1 l_2 \sin\theta_2 = 0 \Leftrightarrow \sin\theta_2 = 0", arm=None)) == ["proved"]
    assert told(check(r"a b = 0 \Rightarrow b = 0", arm=None))[0] not in GOOD


# -- bounds --------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("latex", "arm"),
    [
        (r"J^4 = I_6", "rx90"),
        (r"({}^0T_6)^6 = I_4", "rx90"),
        (rf"\cos({' + '.join(rf'{chr(92)}theta_{{{k}}}' for k in range(1, 25))}) = 1", None),
        (r"\sqrt{(a_3 + d_3 + c_1 + c_2 + c_3 + s_4)^{10} + 1} = 0", "rx90"),
    ],
)
def test_no_display_takes_longer_than_its_bound(judge: Judge, latex: str, arm: str | None) -> None:
    started = time.process_time()
    assert judge(latex, arm=arm).verdict in (Verdict.REFUTED, Verdict.UNCHECKED)
    assert time.process_time() - started < 2 * (
        SECONDS_TO_DECIDE + SECONDS_TO_EXPLAIN
    )  # a slow machine is granted as much again


# -- records -------------------------------------------------------------------------------------------------------------


def test_a_counterexample_gives_a_value_to_every_symbol_behind_a_name(judge: Judge) -> None:
    record = judge(r"w = \begin{bmatrix} w_x \\ w_y \\ w_z \end{bmatrix}", r"n = w^T w", r"n = w_x^2 + w_y^2", arm=None)
    assert record.verdict is Verdict.REFUTED and {"w_x", "w_y", "w_z"} <= set(record.counterexample)
    assert all(value != 0 for value in record.counterexample.values())
