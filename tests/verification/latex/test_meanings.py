"""What names mean by where they stand: blocks of unknowns, columns of a Jacobian, frames a document adds, numbers."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from armproof.verification.check import check_document
from armproof.verification.document import Display, Document
from armproof.verification.verdict import Record, Verdict

Judge = Callable[..., Record]

ARM: dict[str, Any] = {
    "dh": "classic",
    "rows": [
        {"a": 0, "alpha": "pi/2", "d": "d_1", "theta": "theta_1"},
        {"a": "a_2", "alpha": 0, "d": 0, "theta": "theta_2"},
        {"a": "a_3", "alpha": 0, "d": 0, "theta": "theta_3"},
    ],
}
PLANAR: dict[str, Any] = {
    "dh": "classic",
    "rows": [
        {"a": "a_1", "alpha": 0, "d": 0, "theta": "theta_1"},
        {"a": "a_2", "alpha": 0, "d": 0, "theta": "theta_2"},
    ],
}
POINT = r"\begin{bmatrix} c_1(a_2c_2+a_3c_{23}) \\ s_1(a_2c_2+a_3c_{23}) \\ d_1%sa_2s_2+a_3s_{23} \end{bmatrix}"


# -- matrices of unknowns ----------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("whole", "part", "alone"),
    [
        (r"\begin{bmatrix} R & p \\ 0 & 1 \end{bmatrix}", "p", Verdict.PROVED),
        (r"\begin{bmatrix} R_{3\times3} & P_{3\times1} \\ 0_{1\times3} & 1 \end{bmatrix}", "P", Verdict.PROVED),
        (r"\left[\begin{array}{c|c} \mathbf{R} & \mathbf{t} \\ \hline 0\;0\;0 & 1 \end{array}\right]", "t", Verdict.PROVED),
        (r"\begin{bmatrix} n & o & a & p \\ 0 & 0 & 0 & 1 \end{bmatrix}", "p", Verdict.UNCHECKED),
        (r"\begin{bmatrix} {}^0R_3 & p \\ \mathbf{0}^T & 1 \end{bmatrix}", "p", Verdict.PROVED),
    ],
)  # fmt: skip
def test_a_block_of_a_pose_gives_its_name_a_meaning(judge: Judge, whole: str, part: str, alone: Verdict) -> None:
    display = rf"{{}}^0T_3 = {whole}"
    assert judge(display, arm=ARM).verdict is alone
    assert judge(display, f"{part} = {POINT % '+'}", arm=ARM).verdict is Verdict.PROVED
    assert judge(display, f"{part} = {POINT % '-'}", arm=ARM).verdict is Verdict.REFUTED


def test_known_entries_among_unknown_ones_are_checked(judge: Judge) -> None:
    cells = r"{}^0T_3 = \begin{bmatrix} r_{11} & r_{12} & %s & p_x \\ r_{21} & r_{22} & -c_1 & p_y \\ s_{23} & c_{23} & 0 & p_z \\ 0&0&0&1 \end{bmatrix}"
    assert not judge(cells % "s_1", arm=ARM).is_decided
    record = judge(cells % "c_1", arm=ARM)
    assert record.verdict is Verdict.REFUTED
    assert [(entry.row, entry.column) for entry in record.entries] == [(1, 3)]
    assert judge(cells % "s_1", r"r_{11} = c_1c_{23}", arm=ARM).verdict is Verdict.PROVED
    assert judge(cells % "s_1", r"r_{11} = c_1s_{23}", arm=ARM).verdict is Verdict.REFUTED


def test_a_wrong_entry_is_refuted_beside_one_that_is_not_bound(judge: Judge) -> None:
    cells = r"{}^0T_1 = \begin{bmatrix} c_1 & 0 & s_1 & 0 \\ s_1 & 0 & %sc_1 & 0 \\ 0 & 1 & 0 & d_1 + 2h \\ 0&0&0&1 \end{bmatrix}"
    assert judge(cells % "-", arm=ARM).verdict is Verdict.UNCHECKED
    assert judge(cells % "+", arm=ARM).verdict is Verdict.REFUTED


# -- slips that leave the arm ------------------------------------------------------------------------------------------


def test_an_angle_that_the_arm_does_not_have_is_a_slip(judge: Judge) -> None:
    record = judge(
        r"{}^1T_2 = \begin{bmatrix} c_2 & -s_2 & 0 & a_2c_2 \\ s_2 & c_5 & 0 & a_2s_2 \\ 0&0&1&0 \\ 0&0&0&1 \end{bmatrix}",
        arm=ARM,
    )
    assert record.verdict is Verdict.REFUTED
    assert [(entry.row, entry.column) for entry in record.entries] == [(2, 2)]


def test_a_length_that_the_arm_does_not_have_is_a_slip_where_another_fits(judge: Judge) -> None:
    cells = r"{}^1T_2 = \begin{bmatrix} c_2 & -s_2 & 0 & %sc_2 \\ s_2 & c_2 & 0 & a_2s_2 \\ 0&0&1&0 \\ 0&0&0&1 \end{bmatrix}"
    record = judge(cells % "a_4", arm=ARM)
    assert record.verdict is Verdict.REFUTED
    assert "the arm has no a_4; with a_2 the equation holds" in record.message
    assert judge(cells % "b_4", arm=ARM).verdict is Verdict.UNCHECKED


# -- the Jacobian and its parts ----------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("display", "slip"),
    [
        (r"J_1 = \begin{bmatrix} z_0 \times (o_3 - o_0) \\ z_0 \end{bmatrix}", ("o_3", "o_2")),
        (r"J_2 = \begin{bmatrix} z_1 \times (p_3 - p_1) \\ z_1 \end{bmatrix}", ("p_1", "p_2")),
        (r"J = \begin{bmatrix} z_0 \times (o_3 - o_0) & z_1 \times (o_3 - o_1) & z_2 \times (o_3 - o_2) \\ z_0 & z_1 & z_2 \end{bmatrix}", ("- o_1", "+ o_1")),
        (r"J_{11} = -s_1(a_2c_2+a_3c_{23})", ("-s_1", "s_1")),
        (r"J_{32} = a_2c_2+a_3c_{23}", ("c_2+", "s_2+")),
        (r"J_{v1} = \begin{bmatrix} -s_1(a_2c_2+a_3c_{23}) \\ c_1(a_2c_2+a_3c_{23}) \\ 0 \end{bmatrix}", ("c_1(", "s_1(")),
        (r"J_{\omega_2} = \begin{bmatrix} s_1 \\ -c_1 \\ 0 \end{bmatrix}", ("-c_1", "c_1")),
        (r"\dot{p}_3 = J_v\,\dot{q}", ("J_v", r"J_\omega")),
        (r"\begin{bmatrix} \dot p_x \\ \dot p_y \\ \dot p_z \end{bmatrix} = J \begin{bmatrix} \dot\theta_1 \\ \dot\theta_2 \\ \dot\theta_3 \end{bmatrix}", (r"\dot\theta_2 \\ \dot\theta_3", r"\dot\theta_3 \\ \dot\theta_2")),
        (r"\det J = -a_2a_3s_3(a_2c_2+a_3c_{23})", ("s_3", "c_3")),
        (r"|J| = -a_2a_3\sin\theta_3\,(a_2c_2+a_3c_{23})", ("-a_2", "a_2")),
    ],
)  # fmt: skip
def test_parts_of_the_jacobian_are_told_by_their_place(judge: Judge, display: str, slip: tuple[str, str]) -> None:
    bound = {f"p_{axis}": {"origin": 3, "component": axis} for axis in "xyz"}
    assert judge(display, arm=ARM, quantities=bound).verdict is Verdict.PROVED
    assert judge(display.replace(*slip), arm=ARM, quantities=bound).verdict is Verdict.REFUTED


def test_the_determinant_is_of_the_rows_that_are_printed(judge: Judge) -> None:
    printed = r"J = \begin{bmatrix} -a_1s_1-a_2s_{12} & -a_2s_{12} \\ a_1c_1+a_2c_{12} & a_2c_{12} \end{bmatrix}"
    assert judge(printed, r"\det(J) = a_1a_2s_2", arm=PLANAR).verdict is Verdict.PROVED
    assert judge(printed, r"\det(J) = a_1a_2c_2", arm=PLANAR).verdict is Verdict.REFUTED
    inverse = r"J^{-1} = \frac{1}{a_1a_2s_2}\begin{bmatrix} a_2c_{12} & a_2s_{12} \\ -a_1c_1-a_2c_{12} & %sa_1s_1-a_2s_{12} \end{bmatrix}"
    assert judge(printed, inverse % "-", arm=PLANAR).verdict is Verdict.PROVED
    assert judge(printed, inverse % "", arm=PLANAR).verdict is Verdict.REFUTED


def test_a_jacobian_of_the_front_matter_keeps_its_rows(judge: Judge) -> None:
    record = judge(r"\det(J) = a_1a_2s_2", arm=PLANAR, quantities={"J": {"jacobian": 2}})
    assert record.verdict is Verdict.REFUTED
    assert "6×2" in record.message


# -- frames and angles that a document adds ----------------------------------------------------------------------------


def test_a_tool_frame_of_the_document_is_composed_with_the_arms(judge: Judge) -> None:
    tool = r"{}^3_4T = \begin{bmatrix} 1&0&0&L_4 \\ 0&1&0&0 \\ 0&0&1&0 \\ 0&0&0&1 \end{bmatrix}"
    whole = r"{}^0_4T = \begin{bmatrix} c_1c_{23} & -c_1s_{23} & s_1 & c_1(a_2c_2+(a_3+L_4)c_{23}) \\ s_1c_{23} & -s_1s_{23} & -c_1 & s_1(a_2c_2+(a_3%sL_4)c_{23}) \\ s_{23} & c_{23} & 0 & d_1+a_2s_2+(a_3+L_4)s_{23} \\ 0&0&0&1 \end{bmatrix}"
    assert not judge(tool, arm=ARM).is_decided
    assert judge(tool, whole % "+", arm=ARM).verdict is Verdict.PROVED
    record = judge(tool, whole % "-", arm=ARM)
    assert record.verdict is Verdict.REFUTED
    assert [(entry.row, entry.column) for entry in record.entries] == [(2, 4)]


def test_an_angle_with_two_digits_is_their_sum_or_the_documents_own(judge: Judge) -> None:
    assert judge(r"\theta_{23} = \theta_2 + \theta_3", arm=ARM).verdict is Verdict.PROVED
    assert judge(r"\theta_2 = \theta_{23} - \theta_3", arm=ARM).verdict is Verdict.PROVED
    assert judge(r"\theta_2 = \theta_{23} + \theta_3", arm=ARM).verdict is Verdict.REFUTED
    assert not judge(r"\theta_{12} = \pi - \theta_1", arm=ARM).is_decided  # the second solution for θ_1


# -- numbers -----------------------------------------------------------------------------------------------------------

NUMERIC = r"{}^0T_3 = \begin{bmatrix} 0.5 & -0.866 & 0 & %s \\ 0 & 0 & -1 & 0 \\ 0.866 & 0.5 & 0 & 1.573 \\ 0&0&0&1 \end{bmatrix}"
GIVEN = (r"\theta_1 = 0, \theta_2 = 30^\circ, \theta_3 = 30^\circ", r"d_1 = 0.64, a_2 = 1, a_3 = 0.5")


def test_a_numeric_pose_is_checked_at_the_configuration_given_before(judge: Judge) -> None:
    assert judge(*GIVEN, NUMERIC % "1.116", arm=ARM).verdict is Verdict.CONFIRMED
    record = judge(*GIVEN, NUMERIC % "1.161", arm=ARM)
    assert record.verdict is Verdict.REFUTED
    assert [(entry.row, entry.column) for entry in record.entries] == [(1, 4)]


def test_a_numeric_pose_at_no_known_configuration_is_left_open(judge: Judge) -> None:
    record = judge(NUMERIC % "1.116", arm=ARM)
    assert record.verdict is Verdict.UNCHECKED
    assert "which configuration" in record.message


@pytest.mark.parametrize(
    "name",
    [
        r"{}^0T_3(0, 90^\circ, 0)",
        r"{}^0T_3|_{\theta_1=0,\,\theta_2=90^\circ,\,\theta_3=0}",
        r"\left. {}^0T_3 \right|_{\theta_1 = 0, \theta_2 = \pi/2, \theta_3 = 0}",
    ],
)
def test_a_pose_may_be_taken_at_a_configuration(judge: Judge, name: str) -> None:
    cells = r"%s = \begin{bmatrix} 0&-1&0&0 \\ 0&0&-1&0 \\ 1&0&0& d_1 + a_2 %s a_3 \\ 0&0&0&1 \end{bmatrix}"
    assert judge(cells % (name, "+"), arm=ARM).verdict is Verdict.PROVED
    assert judge(cells % (name, "-"), arm=ARM).verdict is Verdict.REFUTED


def test_numbers_where_the_arm_moves_belong_to_a_configuration(judge: Judge) -> None:
    numbers = r"z_1 = \begin{bmatrix} 0 \\ -1 \\ %s \end{bmatrix}"
    assert judge(numbers % 0, arm=ARM).verdict is Verdict.UNCHECKED
    assert judge(numbers % 1, arm=ARM).verdict is Verdict.REFUTED  # it is 0 everywhere
    assert judge(r"\theta_1 = 0", numbers % 0, arm=ARM).verdict is Verdict.CONFIRMED
    assert judge(r"\theta_1 = \pi", numbers % 0, arm=ARM).verdict is Verdict.REFUTED
    assert judge(r"z_1 = \begin{bmatrix} s_1 \\ -c_1 \\ 0 \end{bmatrix}", arm=ARM).verdict is Verdict.PROVED


# -- elementary matrices -----------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "name", [r"R_z(\theta)", r"R_{z,\theta}", r"\mathbf{R}_z(\theta)", r"\text{Rot}(z,\theta)", r"\operatorname{Rot}_z(\theta)", r"Rot_{z,\theta}", r"Rot(z, \theta)"]
)  # fmt: skip
def test_elementary_rotations_are_claims_on_any_arm(judge: Judge, name: str) -> None:
    cells = r"%s = \begin{bmatrix} \cos\theta & %s\sin\theta & 0 \\ \sin\theta & \cos\theta & 0 \\ 0&0&1 \end{bmatrix}"
    assert judge(cells % (name, "-"), arm=ARM).verdict is Verdict.PROVED
    assert judge(cells % (name, ""), arm=ARM).verdict is Verdict.REFUTED


@pytest.mark.parametrize(
    "product",
    [
        r"Rot_{z,\theta_i}\,Trans_{z,d_i}\,Trans_{x,a_i}\,Rot_{x,\alpha_i}", r"R_z(\theta_i)\,T_z(d_i)\,T_x(a_i)\,R_x(\alpha_i)",
        r"\mathrm{Rot}(z,\theta_i)\,\mathrm{Trans}(z,d_i)\,\mathrm{Trans}(x,a_i)\,\mathrm{Rot}(x,\alpha_i)",
        r"\text{Rot}_{z_{i-1},\theta_i} \cdot \text{Trans}_{z_{i-1},d_i} \cdot \text{Trans}_{x_i,a_i} \cdot \text{Rot}_{x_i,\alpha_i}",
        r"\operatorname{Rot}(z, \theta_i) \operatorname{Trans}(0,0,d_i) \operatorname{Trans}(a_i,0,0) \operatorname{Rot}(x,\alpha_i)",
    ],
)  # fmt: skip
def test_the_general_link_matrix_is_a_product_of_elementary_ones(judge: Judge, product: str) -> None:
    cells = r"\begin{bmatrix} c\theta_i & -s\theta_ic\alpha_i & s\theta_is\alpha_i & a_ic\theta_i \\ s\theta_i & c\theta_ic\alpha_i & %sc\theta_is\alpha_i & a_is\theta_i \\ 0 & s\alpha_i & c\alpha_i & d_i \\ 0&0&0&1 \end{bmatrix}"
    assert judge(rf"A_i = {product} = {cells % '-'}", arm=ARM).verdict is Verdict.PROVED
    assert judge(rf"A_i = {product} = {cells % ''}", arm=ARM).verdict is Verdict.REFUTED


# -- letters that are defined anew -------------------------------------------------------------------------------------


def write_sections(*displays: str) -> Document:
    """Return a document in which each display stands under a heading of its own."""
    found = [Display(line, latex, section=f"section {line}") for line, latex in enumerate(displays, 1)]
    return Document(Path("page.md"), {"arm": ARM}, tuple(found), ())


def test_any_name_may_mean_something_else_in_another_section() -> None:
    matrices = (
        r"Q_3 = \begin{bmatrix} a_2 & 0 \\ 0 & a_3 \end{bmatrix}",
        r"Q_3 = \begin{bmatrix} a_3 & 0 \\ 0 & a_2 \end{bmatrix}",
    )
    anew = check_document(
        write_sections(*matrices, r"Q_3 \begin{bmatrix} 1 \\ 0 \end{bmatrix} = \begin{bmatrix} a_3 \\ 0 \end{bmatrix}")
    )
    assert [record.verdict for record in anew.equations] == [Verdict.UNCHECKED, Verdict.DEFINED, Verdict.PROVED]


def test_a_letter_may_mean_something_else_in_another_section() -> None:
    anew = check_document(write_sections(r"K = a_2c_2", r"K = a_3c_3", r"2K = 2a_3c_3"))
    assert [record.verdict for record in anew.equations] == [Verdict.UNCHECKED, Verdict.DEFINED, Verdict.PROVED]


def test_a_second_meaning_within_a_section_is_not_decided(judge: Judge) -> None:
    second = judge(r"K = a_2c_2", r"2K = 2a_2c_2", r"K = a_3c_3", arm=ARM)
    assert second.verdict is Verdict.UNCHECKED and "something else since line 1" in second.message
    for claim in (r"2K = 2a_2c_2", r"2K = 2a_3c_3", r"K = a_1c_1"):  # which of them is meant is not known
        assert judge(r"K = a_2c_2", r"K = a_3c_3", claim, arm=ARM).verdict is Verdict.UNCHECKED
    assert judge(r"K = a_2c_2", r"K = \begin{bmatrix} a_2 \\ a_3 \end{bmatrix}", arm=ARM).verdict is Verdict.UNCHECKED


def test_what_stands_behind_a_second_meaning_is_decided_as_the_next_equation(judge: Judge) -> None:
    for rest, verdict in ((r"c_3a_3", Verdict.PROVED), (r"a_3s_3", Verdict.REFUTED)):
        record = judge(
            r"K = a_2c_2",
            rf"K = \begin{{bmatrix}} a_3c_3 \\ 0 \end{{bmatrix}} = \begin{{bmatrix}} {rest} \\ 0 \end{{bmatrix}}",
            arm=ARM,
        )
        assert [(each.index, each.verdict) for each in record.outcomes] == [(1, Verdict.UNCHECKED), (2, verdict)]


def test_a_slip_of_a_letters_meaning_is_refuted_where_something_else_holds_with_it(judge: Judge) -> None:
    line, slip = r"K = a_2c_2 + a_3c_3", r"K = a_2c_2 + a_3s_3"
    assert judge(line, r"K - a_3c_3 = a_2c_2", slip, arm=ARM).verdict is Verdict.REFUTED
    assert judge(r"K = 2a_2c_2", r"K^2 = 4a_2^2c_2^2", r"K = a_2c_2", arm=ARM).verdict is Verdict.REFUTED
    assert judge(line, slip, arm=ARM).verdict is Verdict.UNCHECKED  # one of the two is wrong
    assert judge(r"K = a_2c_2", r"K = a_3c_3 = a_3s_3", arm=ARM).verdict is Verdict.REFUTED


def test_a_definition_that_is_said_again_is_no_claim() -> None:
    first, again = check_document(write_sections(r"K = a_2c_2", r"K = a_2c_2")).equations
    assert first.verdict is again.verdict is Verdict.UNCHECKED
    used = check_document(write_sections(r"K = a_2c_2", r"K = a_2c_2", r"K^2 = a_2^2c_2^2")).equations
    assert [record.verdict for record in used] == [Verdict.DEFINED, Verdict.DEFINED, Verdict.PROVED]


def write_exercises(*parts: tuple[str, str]) -> Document:
    """Return a document of (heading, display)."""
    found = [Display(line, latex, section=heading) for line, (heading, latex) in enumerate(parts, 1)]
    return Document(Path("page.md"), {"arm": ARM}, tuple(found), ())


def test_what_another_exercise_defines_refutes_nothing() -> None:
    claim = r"3K = 2a_3c_3"
    other = check_document(write_exercises(("Exercise 1", "K = a_2c_2"), ("Exercise 2", claim))).equations[-1]
    assert other.verdict is Verdict.UNCHECKED and "another exercise" in other.message
    for first, second in (("Notation", "Exercise 2"), ("Exercise 1", "Exercise 1"), ("Exercise 1", "The elbow")):
        said = (first, "K = a_2c_2"), (first, "K^2 = a_2^2c_2^2"), (second, claim)
        assert check_document(write_exercises(*said)).equations[-1].verdict is Verdict.REFUTED


def test_an_entry_of_a_pose_keeps_its_meaning_in_every_section() -> None:
    result = check_document(
        write_sections(r"{}^0T_3 = \begin{bmatrix} R & p \\ 0 & 1 \end{bmatrix}", rf"p = {POINT % '-'}")
    )
    assert result.equations[-1].verdict is Verdict.REFUTED


# -- letters that look like the arm's ----------------------------------------------------------------------------------


def test_a_height_named_like_an_axis_is_the_frames_or_the_documents_own(judge: Judge) -> None:
    assert judge(r"z_2 = d_1 + a_2\sin\theta_2", arm=ARM).verdict is Verdict.PROVED
    assert judge(r"z_2 = d_1 + a_2\sin\theta_2", r"2z_2 = 2d_1 + 2a_2s_2", arm=ARM).verdict is Verdict.PROVED
    assert not judge(r"z_2 = d_1 + a_3\sin\theta_2", arm=ARM).is_decided
    assert judge(r"z_2 = d_1 + a_3\sin\theta_2", r"2z_2 = 2d_1 + 2a_3s_2", arm=ARM).verdict is Verdict.PROVED
    assert judge(r"z_2 = d_1 + a_2\sin\theta_2", arm=ARM, quantities={"z_2": {"axis": 2}}).verdict is Verdict.REFUTED


@pytest.mark.parametrize(
    ("values", "verdict"), [(r"\theta_3 = 0", Verdict.PROVED), (r"\theta_3 = \pi/2", Verdict.REFUTED)]
)
def test_a_determinant_at_a_configuration_is_a_claim(judge: Judge, values: str, verdict: Verdict) -> None:
    assert judge(rf"\det J_v|_{{{values}}} = 0", arm=ARM).verdict is verdict
    assert judge(rf"\left. \det J_v \right|_{{{values}}} = 0", arm=ARM).verdict is verdict


@pytest.mark.parametrize("comma", [".", "{,}"])
def test_a_decimal_comma_rounds_as_a_point_does(judge: Judge, comma: str) -> None:
    assert judge(rf"\cos\frac{{\pi}}{{6}} = 0{comma}866").verdict is Verdict.CONFIRMED
    assert judge(rf"\cos\frac{{\pi}}{{6}} = 0{comma}867").verdict is Verdict.REFUTED


def test_rounded_numbers_hold_to_the_decimals_printed(judge: Judge) -> None:
    arm = {"dh": "classic", "rows": [{"a": 1.5, "alpha": 0, "d": 0.054, "theta": "theta_1"}]}
    bound = {"p": {"origin": 1}}
    assert judge(r"A = 1.501", r"A = |p|", arm=arm, quantities=bound).verdict is Verdict.CONFIRMED
    assert judge(r"A = 1.511", r"A = |p|", arm=arm, quantities=bound).verdict is Verdict.REFUTED


BOUND: dict[str, Any] = {
    "arm": "planar_2r",
    "quantities": {"P_x": {"origin": 2, "component": "x"}, "p": {"origin": 2}, "J": {"jacobian": 2, "rows": [1, 2]}},
}


@pytest.mark.parametrize(
    ("display", "verdict", "says"),
    [
        # what stands above a name
        (r"\overset{\cdot}{p} = J \dot q", Verdict.PROVED, ""),
        (r"\overset{\cdot}{p} = p", Verdict.REFUTED, ""),
        (r"\stackrel{.}{\theta}_1 = \dot\theta_1", Verdict.PROVED, ""),
        (r"\stackrel{.}{\theta_1} = \theta_1", Verdict.UNCHECKED, ""),
        (r"\overset{\cdot\cdot}{\theta}_1 = \ddot\theta_1", Verdict.PROVED, ""),
        (r"\overset{..}{\theta_1} = \dot\theta_1", Verdict.REFUTED, ""),
        (r"\overset{\rightarrow}{p} = 1 p", Verdict.PROVED, ""),
        (r"\overset{\rightarrow}{p} = 2 p", Verdict.REFUTED, ""),
        (r"\underset{n}{P_x} = l_1 c_1 + l_2 c_{12}", Verdict.PROVED, ""),
        (r"\overset{0}{p} = 2 p", Verdict.UNREADABLE, "what does '0' above a name mean?"),
        (r"\ddot{P_x} = \frac{d}{dt} \dot{P_x}", Verdict.PROVED, ""),
        # sizes
        (r"p_1 = 0_{0\times 1}", Verdict.UNCHECKED, "0"),
        (r"\begin{bmatrix} I_3 & 0_{3\times 0} \end{bmatrix} p_1 = p_1", Verdict.UNCHECKED, "0"),
        # at which values
        (r"\left. 2 c_1 \right|_{\theta_1 = 0} = 2", Verdict.PROVED, ""),
        (r"\left. 2 c_1 \right|_{\theta_1 = 0} = 3", Verdict.REFUTED, ""),
        (r"\left. c_1 \right|_{0} = 1", Verdict.UNREADABLE, "'0' does not say at which values"),
        (r"\left. c_1 \right|_{\theta_1 = 0, \theta_2} = 1", Verdict.UNREADABLE, "does not say at which values"),
        (r"\left. 2 c_1 \right|_{\theta_1 = 0}^2 = 4", Verdict.UNREADABLE, "does not say at which values"),
        (r"\left. c_1 \right|_{,} = 1", Verdict.UNREADABLE, "does not say at which values"),
        (r"\left. c_1 \right|_0^1 = 1", Verdict.UNREADABLE, "does not say at which values"),
        (r"\left. c_1 \right| = |c_1|", Verdict.UNREADABLE, "does not say at which values"),
        (r"\left| c_1 \right| = |c_1|", Verdict.CONFIRMED, ""),
        # cosines
        (r"c\theta_1 = c_1", Verdict.PROVED, ""),
        (r"c\dot{\theta_1} = c \dot{\theta_2}", Verdict.UNCHECKED, "'c' is not bound"),  # damping, no cosine of a rate
        (r"c\dot\theta_1 = 2 c \dot\theta_1", Verdict.UNCHECKED, "'c' is not bound"),
        (r"\cos_1 = \cos\theta_1", Verdict.PROVED, ""),
        (r"\cos_{q_1} = s_1", Verdict.REFUTED, "sine for cosine"),
        (r"\sin_i = s_i", Verdict.PROVED, ""),
        (r"\cos_x = 1", Verdict.UNREADABLE, "has no angle"),
        (r"\cos^*\theta_1 = c_1", Verdict.PROVED, ""),
        (r"\cos^*\theta_1 = c_2", Verdict.REFUTED, ""),
        (r"a \tan 2(s_1, c_1) = \operatorname{atan2}(s_1, c_1)", Verdict.PROVED, ""),
        (r"\theta_1 = \operatorname{atan2}(\frac{s_1}{c_1})", Verdict.CONFIRMED, ""),  # of a quotient alone
        (r"\theta_1 = \operatorname{atan2}(\frac{c_1}{s_1})", Verdict.REFUTED, ""),
        (r"\theta_1 = \operatorname{atan2}(s_1)", Verdict.UNCHECKED, "takes 2 arguments"),
        (r"l_1 \tan 2(\theta_1 + \theta_2) = l_1 \tan(2\theta_1 + 2\theta_2)", Verdict.PROVED, ""),
        # one value
        (r"\frac{p = p}{2} = p", Verdict.UNCHECKED, "several equations stand where one value is expected"),
        (r"P_x = \begin{aligned} l_1 c_1 + l_2 c_{12} \end{aligned}", Verdict.PROVED, ""),
        (r"P_x = \begin{aligned} l_1 c_1 + l_2 s_{12} \end{aligned}", Verdict.REFUTED, ""),
        (r"P_x = \begin{bmatrix} \text{if so} c_1 \end{bmatrix}", Verdict.UNCHECKED, "words stand for a value"),
        (r"\theta_1 = [\begin{cases} c_1 & a \\ s_1 & b \end{cases}]", Verdict.UNCHECKED, ""),
        (r"{^0p}_2 = p", Verdict.PROVED, ""),
        (r"{^0p}_2 = 2 p", Verdict.REFUTED, ""),
        # words and units
        (r"P_x = l_1 c_1 + l_2 c_{12} \quad \eqref{eq:x}", Verdict.PROVED, ""),
        (r"P_x = l_1 c_1 - l_2 c_{12} \quad \eqref{eq:x}", Verdict.REFUTED, ""),
        (r"\mathrm{theta}_1 = 2 \theta_1", Verdict.REFUTED, ""),
        (r"\text{l1} = 2 l_1", Verdict.REFUTED, ""),
        (r"2^2 \mathrm{m} = 4", Verdict.UNCHECKED, "'m' is not bound"),
    ],
)
def test_no_mark_is_passed_over(judge: Judge, display: str, verdict: Verdict, says: str) -> None:
    record = judge(display, **BOUND)
    assert (record.verdict, says in record.message) == (verdict, True), record.message


# -- what the document says itself -------------------------------------------------------------------------------------

TURNED: dict[str, Any] = {
    "dh": "classic",
    "rows": [
        {"a": "l_1", "alpha": 0, "d": 0, "theta": "theta_1"},
        {"a": "l_2", "alpha": "pi", "d": 0, "theta": "theta_2"},
        {"a": 0, "alpha": 0, "d": "d_3", "theta": 0},
        {"a": 0, "alpha": 0, "d": 0, "theta": "theta_4"},
    ],
}
TURN = r"{}^0R_4 = \begin{bmatrix} c_{124} & s_{124} & 0 \\ s_{124} & %sc_{124} & 0 \\ 0 & 0 & -1 \end{bmatrix}"


@pytest.mark.parametrize(
    "told", [r"\theta_{124} = \theta_1 + \theta_2 - \theta_4", r"C_{124} = \cos(\theta_1 + \theta_2 - \theta_4)"]
)
def test_a_sum_of_angles_is_what_the_document_says(judge: Judge, told: str) -> None:
    assert judge(told, TURN % "-", arm=TURNED).verdict is Verdict.PROVED
    assert judge(told, TURN % "", arm=TURNED).verdict is Verdict.UNCHECKED  # nobody knows who is wrong
    assert judge(told, arm=TURNED).verdict is Verdict.UNCHECKED
    assert judge(TURN % "-", arm=TURNED).verdict is Verdict.REFUTED  # as everybody means it


@pytest.mark.parametrize(
    ("latex", "verdict"),
    [
        (r"c_{ij} = \cos(\theta_i + \theta_j)", Verdict.PROVED),
        (r"S_{ijk} = \sin(\theta_i + \theta_j + \theta_k)", Verdict.PROVED),
        (r"c_{ij} = \cos(\theta_i - \theta_j)", Verdict.UNCHECKED),
        (r"c_{ij} = \sin(\theta_i + \theta_j)", Verdict.UNCHECKED),
        (r"s_{ijk} = \sin(\theta_i + \theta_j)", Verdict.UNCHECKED),
    ],
)
def test_what_indices_of_any_joint_abbreviate_is_a_law(judge: Judge, latex: str, verdict: Verdict) -> None:
    assert judge(latex, arm=None).verdict is verdict and judge(latex, arm="scara").verdict is verdict


def test_what_stands_under_a_name_is_its_index(judge: Judge) -> None:
    point = r"\begin{bmatrix} a_1c_1 + a_2c_{12} \\ a_1s_1 + a_2s_{12} \\ 0 \end{bmatrix}"
    assert judge(rf"\underset{{2}}{{p}} = {point}", arm=PLANAR).verdict is Verdict.PROVED
    assert judge(rf"\underset{{1}}{{p}} = {point}", arm=PLANAR).verdict is Verdict.REFUTED
    assert not judge(rf"\underset{{\text{{wrist}}}}{{p}} = {point}", arm=PLANAR).is_decided


def test_a_pose_printed_as_its_rotation_is_that_where_it_is_right(judge: Judge) -> None:
    turn = r"T_{03} = \begin{bmatrix} c_1c_{23} & -c_1s_{23} & s_1 \\ s_1c_{23} & -s_1s_{23} & %sc_1 \\ s_{23} & c_{23} & 0 \end{bmatrix}"
    assert judge(turn % "-", arm=ARM).verdict is Verdict.PROVED
    assert judge(turn % "", arm=ARM).verdict is Verdict.UNCHECKED


@pytest.mark.parametrize(
    ("product", "verdict"),
    [
        (r"A_1 A_2 \cdots A_n", Verdict.PROVED),
        (r"A_1(q_1) \dots A_n(q_n)", Verdict.PROVED),
        (r"{}^0T_1 \, {}^1T_2 \cdots {}^{n-1}T_n", Verdict.PROVED),
        (r"{}_1^0T \cdots\: _n^{n-1}T", Verdict.PROVED),  # the scripts behind dots are those of the letter behind
        (r"{}_1^0T \cdots\: _{n-1}^nT", Verdict.UNCHECKED),
        (r"A_1 \cdots A_{n-1}", Verdict.UNCHECKED),  # what the dots stand for is not said
        (r"A_1 A_3 \cdots A_n", Verdict.UNCHECKED),
        (r"A_2 \cdots A_n", Verdict.UNCHECKED),
        (r"A_1 \cdots {}^{1}T_n", Verdict.UNCHECKED),
    ],
)
def test_the_links_that_dots_leave_out_are_those_between(judge: Judge, product: str, verdict: Verdict) -> None:
    assert judge(rf"{{}}^0T_n = {product}", arm=ARM).verdict is verdict


def test_coordinates_in_another_frame_are_not_those_of_the_tool_in_the_base(judge: Judge) -> None:
    column = r"\begin{bmatrix} %sP_x \\ %sP_y \\ %sP_z \end{bmatrix}"
    values = r"\begin{bmatrix} L + a_2 \\ W \\ d_1 - a_2s_2 \end{bmatrix}"
    for frame, verdict in (("{}^B", Verdict.UNCHECKED), ("", Verdict.REFUTED)):
        assert judge(f"P = {column % (frame, frame, frame)} = {values}", arm=ARM).verdict is verdict
