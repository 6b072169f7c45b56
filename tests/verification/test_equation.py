"""Chains of equations: which side is believed, what gets a meaning, and which readings of a size are allowed."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from armproof.verification.verdict import DocumentResult, Record, Verdict

Judge = Callable[..., Record]
Check = Callable[..., DocumentResult]

P1 = r"\begin{bmatrix} a_1 c_1 \\ a_1 s_1 \\ 0 \end{bmatrix}"
P1_WRONG = r"\begin{bmatrix} a_1 c_1 \\ a_1 c_1 \\ 0 \end{bmatrix}"
UNKNOWN = r"\begin{bmatrix} n_x & o_x & m_x & b_x \\ n_y & o_y & m_y & b_y \\ n_z & o_z & m_z & b_z \\ 0 & 0 & 0 & 1 \end{bmatrix}"


def verdicts(result: DocumentResult) -> list[str]:
    return [record.verdict.value for record in result.equations]


# -- which member of a chain is true -------------------------------------------------------------------------------------


@pytest.mark.parametrize("chain", [f"p_1 = {P1_WRONG}", f"{P1_WRONG} = p_1", f"{P1} = {P1_WRONG} = p_1"])
def test_the_arm_is_right_wherever_it_stands(judge: Judge, chain: str) -> None:
    record = judge(chain)
    assert record.verdict is Verdict.REFUTED
    (entry,) = record.entries
    assert (entry.row, entry.column, entry.correct) == (2, 1, "a_1 s_1")


def test_each_equation_of_a_chain_is_counted(judge: Judge) -> None:
    record = judge(f"p_1 = {P1} = {P1_WRONG}")
    assert [entry.equation for entry in record.entries] == [2]
    record = judge(r"c_1 = \cos\theta_1, \quad s_1 = \sin\theta_1, \quad s_2 = \cos\theta_2")
    assert [entry.equation for entry in record.entries] == [3]


def test_a_step_with_a_wrong_factor_is_wrong_though_its_end_is_right(judge: Judge) -> None:
    right = judge(r"T^0_2 = A^0_1 A^1_2 = \begin{bmatrix} c_{12} & s_{12} & 0 & a_1 c_1 + a_2 c_{12} \\ s_{12} & -c_{12} & 0 & a_1 s_1 + a_2 s_{12} \\ 0 & 0 & -1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}")  # fmt: skip
    wrong = judge(r"T^0_2 = A^1_2 A^0_1")
    assert right.verdict is Verdict.PROVED and wrong.verdict is Verdict.REFUTED


def test_a_joint_variable_is_not_defined_anew(judge: Judge) -> None:
    assert judge(r"\theta_1 = \theta_2").verdict is Verdict.UNCHECKED  # a condition
    assert not judge(r"\theta_1 = \frac{\pi}{2}").is_decided  # a configuration
    assert judge(r"\theta_1 = \frac{\pi}{2}", r"c_1 = 0").verdict is Verdict.CONFIRMED  # there
    assert judge(r"\theta_1 = \frac{\pi}{2}", r"c_1 = 1").verdict is Verdict.REFUTED
    assert judge(r"\theta_1 = \frac{\pi}{2}", r"c_1 = c_2").verdict is Verdict.REFUTED  # what moves does not rest on it


# -- definitions ---------------------------------------------------------------------------------------------------------


def test_a_name_is_defined_once_and_then_checked(check: Check) -> None:
    result = check(r"u = a_1 c_1", r"u + 1 = 1 + a_1\cos\theta_1", r"u = 2 a_1 c_1", r"\dot u = -a_1 s_1 \dot\theta_1")
    assert verdicts(result) == ["defined", "proved", "refuted", "proved"]


def test_a_definition_may_rest_on_another(check: Check) -> None:
    result = check(r"u = a_1 c_1", "k = 2 u", r"k = 2 a_1 c_1", r"k = a_1 c_1")
    assert verdicts(result) == ["defined", "defined", "proved", "refuted"]


def test_a_name_may_stand_on_the_right(check: Check) -> None:
    assert verdicts(check(r"a_1 c_1 = u", r"u = a_1 \cos\theta_1")) == ["defined", "proved"]


def test_an_erratum_defines_nothing(check: Check) -> None:
    result = check(errata=(r"h = a_1 c_1", r"h = a_1 c_1"))
    assert verdicts(result) == ["unchecked", "unchecked"]
    assert not result.passed
    assert check("h = a_1 c_1", errata=("h = a_1 s_1",)).passed


def test_bare_entries_of_a_matrix_are_defined_by_their_places(check: Check) -> None:
    result = check(
        rf"T^0_1 = {UNKNOWN}", r"n_x = c_1", r"o_x = -s_1", r"b_y = a_1 s_1", r"o_x = s_1", r"n_x o_y - n_y o_x = 1"
    )
    assert verdicts(result) == ["defined", "proved", "proved", "proved", "refuted", "proved"]
    assert "n_x, o_x, m_x, b_x" in result.equations[0].message


def test_known_entries_beside_bare_ones_are_checked(judge: Judge) -> None:
    record = judge(rf"T^0_1 = {UNKNOWN}".replace("0 & 0 & 0 & 1", "0 & 1 & 0 & 1"))
    assert record.verdict is Verdict.REFUTED
    assert [(entry.row, entry.column, entry.printed) for entry in record.entries] == [(4, 2, "1")]


def test_one_name_in_two_places_must_have_one_value(judge: Judge) -> None:
    assert judge(r"R^0_1 = \begin{bmatrix} x & -y & 0 \\ y & x & 0 \\ 0 & 0 & 1 \end{bmatrix}").passes
    record = judge(r"R^0_1 = \begin{bmatrix} x & y & 0 \\ y & x & 0 \\ 0 & 0 & 1 \end{bmatrix}")
    assert record.verdict is Verdict.REFUTED
    assert [(entry.row, entry.column) for entry in record.entries] == [(2, 1)]


def test_a_brace_defines_its_label_or_is_held_to_it(check: Check) -> None:
    result = check(
        r"\cos(\overbrace{\theta_1 + \theta_2}^{\psi}) = c_{12}",
        r"\psi = \theta_1 + \theta_2",
        r"\underbrace{c_{12}}_{\psi} = c_{12}",
    )
    assert verdicts(result) == ["proved", "proved", "refuted"]


def test_what_is_not_bound_is_named(judge: Judge) -> None:
    record = judge(r"u + c_1 = 3")
    assert (record.verdict, record.message) == (Verdict.UNCHECKED, "'u' is not bound")
    assert not judge(r"u = v + w").is_decided
    assert judge(r"u + 1 = v + w").verdict is Verdict.UNCHECKED


# -- sizes ---------------------------------------------------------------------------------------------------------------

LINEAR = r"-a_1 s_1 - a_2 s_{12} & -a_2 s_{12} & 0 & 0 \\ a_1 c_1 + a_2 c_{12} & a_2 c_{12} & 0 & 0"


@pytest.mark.parametrize(
    ("latex", "note"),
    [
        (rf"J = \begin{{bmatrix}} {LINEAR} \\ 0 & 0 & -1 & 0 \\ 1 & 1 & 0 & -1 \end{{bmatrix}}", "rows 1, 2, 3, 6 of the geometric Jacobian"),
        (rf"J = \begin{{bmatrix}} {LINEAR} \\ 0 & 0 & -1 & 0 \end{{bmatrix}}", "rows 1, 2, 3 of the geometric Jacobian"),
        (r"p_1 = \begin{bmatrix} a_1 c_1 \\ a_1 s_1 \end{bmatrix}", "the plane's two components"),
        (r"p_1 = \begin{bmatrix} a_1 c_1 \\ a_1 s_1 \\ 0 \\ 1 \end{bmatrix}", ""),
        (r"T^0_1 = \begin{bmatrix} c_1 & -s_1 & 0 & a_1 c_1 \\ s_1 & c_1 & 0 & a_1 s_1 \\ 0 & 0 & 1 & 0 \end{bmatrix}", "the rows above 0 0 0 1"),
        (r"T^0_1 = \begin{bmatrix} c_1 & -s_1 & a_1 c_1 \\ s_1 & c_1 & a_1 s_1 \\ 0 & 0 & 1 \end{bmatrix}", "the planar transform"),
        (r"R^0_1 = Rot(z, \theta_1)", "the rotation"),
        (r"z_1 \times z_2 = 0", ""),
        (r"\det(R^0_4) = 1", ""),
    ],
)  # fmt: skip
def test_a_quantity_of_the_arm_may_be_met_in_a_smaller_shape(judge: Judge, latex: str, note: str) -> None:
    record = judge(latex)
    assert record.verdict is Verdict.PROVED and note in record.message
    assert record.max_error is None or record.max_error < 1e-12


@pytest.mark.parametrize(
    ("latex", "message"),
    [
        (
            r"p_4 = \begin{bmatrix} a_1 c_1 + a_2 c_{12} \\ a_1 s_1 + a_2 s_{12} \end{bmatrix}",
            "the printed matrix is 2×1, it should be 3×1",
        ),
        (r"T^0_1 = a_1", "the printed value is a scalar, it should be 4×4"),
        (r"a_1 = \begin{bmatrix} a_1 \\ a_1 \end{bmatrix}", "the printed value is 2×1, it should be a scalar"),
        (r"z_1 + z_2 = T^0_1", "the printed matrix is 3×1, it should be 4×4"),
        (r"p_4 = (J_v)^{-1}", "a 3×4 matrix has no inverse"),
        (r"J_v J_v^{+} = I_4", "the printed matrix is 4×4, it should be 3×3"),
    ],
)
def test_sizes_that_differ_are_wrong_and_named(judge: Judge, latex: str, message: str) -> None:
    bound = {"p_4": {"origin": 4}, "T^0_1": {"pose": 1}, "J_v": {"jacobian": 4, "rows": [1, 2, 3]}}
    record = judge(latex, quantities=bound)
    assert record.verdict is Verdict.REFUTED and message in record.message


def test_sizes_of_a_name_by_convention_refute_nothing(judge: Judge) -> None:
    for latex in (r"T^0_1 = a_1", r"p_4 = a_1 + a_2", r"p_4 = (J_v)^{-1}"):
        assert judge(latex).verdict is Verdict.UNCHECKED


# -- beyond polynomials ----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("latex", "verdict"),
    [
        (r"s_1 = \pm\sqrt{1 - c_1^2}", Verdict.PROVED),
        (r"s_1 = \pm\sqrt{1 + c_1^2}", Verdict.REFUTED),
        (r"\theta_2 = \pm\arccos c_2", Verdict.PROVED),
        (r"\theta_2 = \pm\arcsin c_2", Verdict.REFUTED),
        (r"\theta_1 = \operatorname{atan2}(s_1, c_1)", Verdict.PROVED),
        (r"\theta_1 = \operatorname{atan2}(-s_1, c_1)", Verdict.REFUTED),
        (r"\theta_1 = \operatorname{atan2}(-s_1, -c_1)", Verdict.REFUTED),
        (r"\sqrt{a_1^2 + 2 a_1 a_2 + a_2^2} = a_1 + a_2", Verdict.PROVED),
        (r"|c_1| = \sqrt{c_1^2}", Verdict.CONFIRMED),
        (r"|c_1| = |s_1|", Verdict.REFUTED),
        (r"|c_1| = c_1", Verdict.REFUTED),
        (r"\tan\frac{\theta_1}{2} = \frac{s_1}{1 + c_1}", Verdict.PROVED),
        (r"\tan\frac{\theta_1}{2} = \frac{s_1}{1 - c_1}", Verdict.REFUTED),
        (r"\cos\frac{2\pi}{5} = 2\cos^2\frac{\pi}{5} - 1", Verdict.CONFIRMED),
    ],
)
def test_branches_roots_and_arc_functions_are_decided(judge: Judge, latex: str, verdict: Verdict) -> None:
    assert judge(latex).verdict is verdict


@pytest.mark.parametrize("false", [r"c_1^2 + s_1^2 = 1.0000001", r"d_3 = d_3 + 2\pi", r"a_1 c_1 = a_1 c_1 + 0.0000001"])
def test_a_root_elsewhere_in_the_document_excuses_nothing(check: Check, false: str) -> None:
    assert verdicts(check(false)) == ["refuted"]
    assert verdicts(check(r"x = \sqrt{a_1^2 + a_2^2}", r"y = \operatorname{atan2}(s_1, a_1)", false))[-1] == "refuted"


@pytest.mark.parametrize(
    "angle", [r"\operatorname{atan2}(-s_1, c_1)", r"\operatorname{atan2}(-s_1, -c_1)", r"\arccos s_1"]
)
def test_a_wrong_angle_is_refuted_without_the_double_plant_too(judge: Judge, angle: str) -> None:
    assert judge(rf"\theta_1 = {angle}", confirm=False).verdict is Verdict.REFUTED


@pytest.mark.parametrize("false", [r"\sqrt{1 - \sin^2\theta_1} = \cos\theta_1", r"\arctan(\tan\theta_1) = \theta_1"])
def test_a_sign_or_a_branch_is_decided_by_samples_whether_or_not_proofs_are_confirmed(judge: Judge, false: str) -> None:
    assert judge(false).verdict is judge(false, confirm=False).verdict is Verdict.REFUTED


def test_a_proof_is_evaluated_on_the_double_plant_as_well(judge: Judge) -> None:
    record = judge(f"p_1 = {P1}")
    assert record.samples == 1000 and record.max_error is not None and record.max_error < 1e-14
    unconfirmed = judge(f"p_1 = {P1}", confirm=False)
    assert unconfirmed.verdict is Verdict.PROVED and (unconfirmed.samples, unconfirmed.max_error) == (0, None)


@pytest.mark.parametrize(("word", "verdict"), [("or", "unchecked"), ("ou", "unchecked"), ("and", "refuted")])
def test_beside_or_nothing_is_refuted(check: Check, word: str, verdict: str) -> None:
    assert verdicts(check(rf"c_1^2 + s_1^2 = 1 \quad\text{{{word}}}\quad c_1^2 + s_1^2 = 2")) == [verdict]


def test_what_has_no_value_with_equal_lengths_is_refuted_all_the_same(check: Check) -> None:
    printed = r"\frac{1}{1 - \frac{a_1}{a_2}}"
    assert verdicts(check(rf"a_1 c_1 {printed} = a_1 s_1 {printed}")) == ["refuted"]
