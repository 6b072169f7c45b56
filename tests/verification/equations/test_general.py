"""General statements: the link matrix with index i, in both conventions, with α, a, d, θ as free symbols."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from armproof.verification.verdict import Record, Role, Verdict

Judge = Callable[..., Record]

CLASSIC = r"""\begin{bmatrix}
\cos\theta_i & -\sin\theta_i\cos\alpha_i & \sin\theta_i\sin\alpha_i & a_i\cos\theta_i \\
\sin\theta_i & \cos\theta_i\cos\alpha_i & -\cos\theta_i\sin\alpha_i & a_i\sin\theta_i \\
0 & \sin\alpha_i & \cos\alpha_i & d_i \\
0 & 0 & 0 & 1 \end{bmatrix}"""
MODIFIED = r"""\begin{bmatrix}
\cos\theta_i & -\sin\theta_i & 0 & a_{i-1} \\
\sin\theta_i\cos\alpha_{i-1} & \cos\theta_i\cos\alpha_{i-1} & -\sin\alpha_{i-1} & -d_i\sin\alpha_{i-1} \\
\sin\theta_i\sin\alpha_{i-1} & \cos\theta_i\sin\alpha_{i-1} & \cos\alpha_{i-1} & d_i\cos\alpha_{i-1} \\
0 & 0 & 0 & 1 \end{bmatrix}"""
INVERSE = r"""\begin{bmatrix}
\cos\theta_i & \sin\theta_i & 0 & -a_i \\
-\sin\theta_i\cos\alpha_i & \cos\theta_i\cos\alpha_i & \sin\alpha_i & -d_i\sin\alpha_i \\
\sin\theta_i\sin\alpha_i & -\cos\theta_i\sin\alpha_i & \cos\alpha_i & -d_i\cos\alpha_i \\
0 & 0 & 0 & 1 \end{bmatrix}"""


@pytest.mark.parametrize("arm", [None, "scara"])
@pytest.mark.parametrize(
    ("latex", "convention"),
    [
        (rf"A_i = {CLASSIC}", "classic"),
        (rf"{{}}^{{i-1}}T_i = {CLASSIC}", "classic"),
        (rf"T^{{i-1}}_i = {MODIFIED}", "modified"),
        (rf"{{}}^{{i-1}}_iT = {MODIFIED}", "modified"),
        (rf"{{}}^iT_{{i-1}} = {INVERSE}", "classic"),
        (r"A_i = Rot(z, \theta_i) Trans(z, d_i) Trans(x, a_i) Rot(x, \alpha_i)", "classic"),
        (r"A_i = Trans(z, d_i) Rot(z, \theta_i) Rot(x, \alpha_i) Trans(x, a_i)", "classic"),
        (r"T^{i-1}_i = Rot(x, \alpha_{i-1}) Trans(x, a_{i-1}) Rot(z, \theta_i) Trans(z, d_i)", "modified"),
        (rf"A_i = Rot(z, \theta_i) Trans(z, d_i) Trans(x, a_i) Rot(x, \alpha_i) = {CLASSIC}", "classic"),
    ],
)  # fmt: skip
def test_the_indices_tell_the_convention(judge: Judge, latex: str, convention: str, arm: str | None) -> None:
    record = judge(latex, arm=arm)
    assert (record.verdict, record.message) == (Verdict.PROVED, f"the {convention} link matrix")
    assert record.samples == 1000 and record.max_error is not None and record.max_error < 1e-14


@pytest.mark.parametrize("matrix", [CLASSIC, MODIFIED, INVERSE])
def test_every_single_sign_of_a_link_matrix_matters(judge: Judge, matrix: str) -> None:
    left = {CLASSIC: "A_i", MODIFIED: "A_i", INVERSE: r"{}^iT_{i-1}"}[matrix]
    rows = [
        row.split("&") for row in matrix.removeprefix(r"\begin{bmatrix}").removesuffix(r"\end{bmatrix}").split(r"\\")
    ]
    for r, row in enumerate(rows[:3]):
        for c, cell in enumerate(row):
            if cell.strip() == "0":
                continue
            flipped = cell.replace("-", "", 1) if cell.strip().startswith("-") else f"-{cell}"
            cells = [
                [flipped if (i, k) == (r, c) else other for k, other in enumerate(line)] for i, line in enumerate(rows)
            ]
            record = judge(
                f"{left} = " + r"\begin{bmatrix}" + r"\\".join("&".join(line) for line in cells) + r"\end{bmatrix}",
                arm=None,
            )
            assert record.verdict is Verdict.REFUTED
            assert [(entry.row, entry.column) for entry in record.entries] == [(r + 1, c + 1)]
            assert (
                set(record.counterexample) <= {"theta_i", "d_i", "a_i", "alpha_i", "a_i-1", "alpha_i-1"}
                and record.counterexample
            )


@pytest.mark.parametrize(
    "latex",
    [
        r"A_i = Trans(x, a_i) Rot(z, \theta_i) Trans(z, d_i) Rot(x, \alpha_i)",
        rf"{{}}^iT_{{i-1}} = {CLASSIC}",
        rf"{{}}^{{i-1}}T_i = {INVERSE}",
    ],
)
def test_steps_in_the_wrong_order_and_inverses_are_refuted(judge: Judge, latex: str) -> None:
    assert judge(latex, arm=None).verdict is Verdict.REFUTED


def test_the_front_matter_decides_where_indices_would_tell_another_convention(judge: Judge) -> None:
    link = "{}^{i-1}T_i"
    for convention, matrix, other in (("classic", CLASSIC, MODIFIED), ("modified", MODIFIED, CLASSIC)):
        bound = {link: {"link": convention}}
        assert judge(rf"{link} = {matrix}", arm=None, quantities=bound).verdict is Verdict.PROVED
        assert judge(rf"{link} = {other}", arm=None, quantities=bound).verdict is Verdict.REFUTED


def test_under_transforms_lower_the_other_index_is_the_reference(judge: Judge) -> None:
    assert judge(rf"T_{{i-1}}^i = {CLASSIC}", arm=None, transforms="lower").verdict is Verdict.PROVED
    assert judge(rf"T_{{i-1}}^i = {CLASSIC}", arm=None, transforms="upper").verdict is Verdict.REFUTED


def test_the_first_general_link_matrix_shows_which_index_is_the_reference(judge: Judge) -> None:
    lower, upper = rf"T_{{i-1}}^i = {CLASSIC}", rf"T_i^{{i-1}} = {CLASSIC}"
    assert judge(lower, arm=None).verdict is Verdict.PROVED
    slip = judge(lower.replace("& d_i", "& -d_i"), arm=None)
    assert slip.verdict is Verdict.REFUTED and [(each.row, each.column) for each in slip.entries] == [(3, 4)]
    for one, other in ((lower, upper), (upper, lower)):
        assert judge(one, one, arm=None).verdict is Verdict.PROVED
        assert judge(one, other, arm=None).verdict is Verdict.REFUTED


def test_another_letter_is_the_index_of_a_link_unless_i_is_beside_it(judge: Judge) -> None:
    assert judge(rf"T_k^{{k-1}} = {CLASSIC.replace('_i', '_k')}", arm=None).verdict is Verdict.PROVED
    assert judge(rf"T_k^{{k-1}} = {CLASSIC}", arm=None).verdict is not Verdict.PROVED
    assert judge(r"T_k^{k-1} = T_i^{i-1}", arm=None).verdict is Verdict.UNCHECKED


def test_a_link_of_the_arm_is_not_a_general_one(judge: Judge) -> None:
    assert "link matrix" not in judge(r"A_1 = Rot(z, \theta_1) Trans(x, a_1)").message


def test_somebodys_own_matrix_of_that_name_is_a_definition(judge: Judge) -> None:
    own = r"A_i = \begin{bmatrix} a_i & 1 \\ 0 & 1 \end{bmatrix}"
    assert judge(own, arm=None).outcomes[0].role is Role.DEFINITION
    assert judge(own, r"\det A_i = a_i", arm=None).verdict is Verdict.PROVED
    assert judge(own, r"\det A_i = a_i", r"\det A_i = -a_i", arm=None).verdict is Verdict.REFUTED
    assert judge(own, r"\det A_i = 1", arm=None).verdict is Verdict.UNCHECKED  # or what a_i is asked to be


@pytest.mark.parametrize(
    ("latex", "verdict"),
    [
        (r"R_z(\beta) R_z(\gamma) = R_z(\beta + \gamma)", Verdict.PROVED),
        (r"R_z(\beta) R_x(\gamma) = R_x(\gamma) R_z(\beta)", Verdict.REFUTED),
        (r"Rot(x, \alpha)^{-1} = Rot(x, -\alpha)", Verdict.PROVED),
        (r"Rot(x, \alpha)^{-1} = Rot(x, \alpha)", Verdict.REFUTED),
        (r"Rot(y, \beta) = \begin{bmatrix} c_\beta & 0 & s_\beta & 0 \\ 0 & 1 & 0 & 0 \\ -s_\beta & 0 & c_\beta & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}", Verdict.PROVED),
        (r"Rot(y, \beta) = \begin{bmatrix} c_\beta & 0 & -s_\beta & 0 \\ 0 & 1 & 0 & 0 \\ s_\beta & 0 & c_\beta & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}", Verdict.REFUTED),
        (r"Trans(x, a) Trans(y, b) = Trans(a, b, 0)", Verdict.PROVED),
        (r"(a + b)^2 = a^2 + 2ab + b^2", Verdict.PROVED),
        (r"(a + b)^2 = a^2 + b^2", Verdict.REFUTED),
    ],
)  # fmt: skip
def test_elementary_transforms_and_identities_hold_for_any_symbols(judge: Judge, latex: str, verdict: Verdict) -> None:
    assert judge(latex, arm=None).verdict is verdict


def test_a_document_may_mean_something_else_by_its_link_matrix(judge: Judge) -> None:
    """Then only what is exactly a link matrix is judged: a slip may belong to the other meaning."""
    own, slip = r"A_i = Rot(z, \theta_i) Trans(x, a_i)", f"A_i = {CLASSIC.replace('& d_i', '& -d_i')}"
    assert judge(slip, arm=None).verdict is Verdict.REFUTED
    assert judge(own, slip, arm=None).verdict is Verdict.UNCHECKED
    assert judge(own, f"A_i = {CLASSIC}", arm=None).verdict is Verdict.PROVED


@pytest.mark.parametrize("arm", [None, "scara"])
def test_what_is_printed_for_a_product_of_printed_matrices_is_a_claim_in_any_letters(
    judge: Judge, arm: str | None
) -> None:
    """K = […] […] = […]: whatever it is called, the product is calculated."""
    turn = r"\begin{bmatrix} \cos\theta & -\sin\theta & 0 \\ \sin\theta & \cos\theta & 0 \\ 0 & 0 & <> \end{bmatrix}"
    twist = r"\begin{bmatrix} 1 & 0 & 0 \\ 0 & \cos\alpha & -\sin\alpha \\ 0 & \sin\alpha & \cos\alpha \end{bmatrix}"
    both = CLASSIC.replace("_i", "").replace("& a\\cos\\theta", "").replace("& a\\sin\\theta", "")
    rows = [row.split("&")[:3] for row in both.removeprefix(r"\begin{bmatrix}").split(r"\\")[:3]]
    whole = r"\begin{bmatrix}" + r"\\".join("&".join(row) for row in rows) + r"\end{bmatrix}"
    equation = rf"K = {turn} {twist} = {whole}"
    assert judge(equation.replace("<>", "1"), arm=arm).verdict is Verdict.PROVED
    assert judge(equation.replace("<>", "0"), arm=arm).verdict is Verdict.REFUTED
    assert judge(equation.replace("<>", "-1"), arm=arm).verdict is Verdict.REFUTED


def test_a_link_may_be_made_of_two_steps_by_a_frame_between(judge: Judge) -> None:
    steps, turned = r"T_{i'}^{i-1} T_i^{i'}", r"T_i^{i'} T_{i'}^{i-1}"
    assert judge(f"T_i^{{i-1}} = {steps} = {CLASSIC}", arm=None).verdict is Verdict.PROVED
    assert judge(f"T_i^{{i-1}} = {steps} = {CLASSIC.replace('& d_i', '& -d_i')}", arm=None).verdict is Verdict.REFUTED
    assert judge(f"T_i^{{i-1}} = {turned} = {CLASSIC}", arm=None).verdict in (Verdict.REFUTED, Verdict.UNCHECKED)
