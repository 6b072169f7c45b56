"""Names that get their meaning from the display they stand in: by what they equal, by their place, by a brace."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest

from armproof.verification.check import check_document, verify_text
from armproof.verification.document import Display, Document
from armproof.verification.verdict import DocumentResult, Record, Verdict

FRONT = {"arm": "planar_2r", "quantities": {"p": {"origin": 2}, "T": {"pose": 2}}}
ROW = r"\begin{bmatrix} K & M & 0 \end{bmatrix}"
X, Y, ON_X = "K = l_1 c_1 + l_2 c_{12}", "M = l_1 s_1 + l_2 s_{12}", "M = l_1 s_1"
SQUARE = "l_1^2 + l_2^2 + 2 l_1 l_2 c_2"


@pytest.mark.parametrize(
    ("displays", "verdicts"),
    [
        # by its place in a matrix: what is known there is checked, and a name stands for one value
        ([f"{ROW}^T = p", X, Y, ON_X], "defined proved proved refuted"),
        ([f"p = {ROW}^T", f"K^2 + M^2 = {SQUARE}"], "defined proved"),
        ([f"p = {ROW}^{{-1}}", ON_X], "unchecked unchecked"),
        (["p = (K, M, 0)", X, ON_X], "defined proved refuted"),
        (["p = (K, M, 0)^T", X, ON_X], "defined proved refuted"),
        (["p = (K, M, 1)^T", X, ON_X], "refuted proved refuted"),
        (["p = (K, K, 0)^T"], "refuted"),
        (["p - p = (K, K, 0)^T", "K = 0"], "defined proved"),
        (["p = (K, M + u, 0)^T", ON_X], "unchecked unchecked"),
        (["p = (K, M, N)^T", "N = 0", "N = 1"], "defined proved refuted"),
        (["p = (K, M)^T"], "unchecked"),
        # by its block
        ([r"T = \begin{bmatrix} Q & D \\ 0 & 1 \end{bmatrix}", "D = p", "Q^T Q = I", "Q^T Q = 2 I"], "defined proved proved refuted"),
        ([r"T = \begin{bmatrix} Q & D \\ 1 & 1 \end{bmatrix}"], "refuted"),
        # by its square
        ([f"k^2 = {SQUARE}", "p^T p = k^2", "k^2 = l_1^2"], "defined proved refuted"),
        # by the label of a brace
        ([r"p^T p = \underbrace{l_1^2 + l_2^2}_{m} + 2 l_1 l_2 c_2", "p^T p = m + 2 l_1 l_2 c_2", "m = l_1^2 - l_2^2", "m = l_1^2"], "proved proved refuted unchecked"),
        ([r"p^T p = \underbrace{l_1^2 + l_2^2}_{l_1^2} + 2 l_1 l_2 c_2"], "refuted"),
        ([r"p^T p = \underbrace{l_1^2 + l_2^2}_{l_2^2 + l_1^2} + 2 l_1 l_2 c_2"], "proved"),
        ([r"x = \underbrace{l_1 c_1}_{= x_1} + l_2 c_{12}"], "proved"),
        ([r"x = \underbrace{l_1 c_1}_{= y_1} + l_2 c_{12}"], "unchecked"),
        ([r"x = \underbrace{l_1 c_1}_{K} + l_2 c_{12}", "x - K = l_2 c_{12}"], "proved proved"),
        ([r"p^T p = \underbrace{l_1^2 + l_2^2}_{u + w} + 2 l_1 l_2 c_2"], "unchecked"),
        # by nothing that is known
        (["u = v + w", "a = b", "u + v = w + x", "u = l_1"], "unchecked unchecked unchecked unchecked"),
    ],
    ids=lambda part: part[0] if isinstance(part, list) else "",
)  # fmt: skip
def test_a_name_means_what_its_display_gives_it(
    check: Callable[..., DocumentResult], displays: list[str], verdicts: str
) -> None:
    assert " ".join(record.verdict.value for record in check(*displays, **FRONT).equations) == verdicts


def test_a_name_of_another_exercise_refutes_nothing(check: Callable[..., DocumentResult]) -> None:
    front = Document(Path("page.md"), {"arm": "planar_2r"}, (), ())
    lines = ["w = l_1 s_1", r"p_1 = \begin{bmatrix} l_1 c_1 \\ w \\ 0 \end{bmatrix}"]
    wrong = r"p_2 = \begin{bmatrix} w \\ l_1 s_1 + l_2 s_{12} \\ 0 \end{bmatrix}"

    def verdict_of_last(section: str) -> Record:
        displays = [Display(4, lines[0], section="Exercise 1"), Display(6, lines[1], section="Exercise 1")]
        document = replace(front, displays=(*displays, Display(9, wrong, section=section)))
        return check_document(document).equations[-1]

    assert verdict_of_last("Exercise 1").verdict is Verdict.REFUTED
    elsewhere = verdict_of_last("Exercise 2")
    assert elsewhere.verdict is Verdict.UNCHECKED
    assert "the w of line 4, which another exercise defines" in elsewhere.message


def test_a_wrong_entry_is_marked_and_a_wrong_block_is_said(check: Callable[..., DocumentResult]) -> None:
    entry, twice, block = check(
        "p = (K, M, 1)^T", "p = (G, G, 0)^T", r"T = \begin{bmatrix} Q & D \\ 1 & 1 \end{bmatrix}", **FRONT
    ).equations
    assert [(e.row, e.column, e.correct) for e in entry.entries] == [(3, 1, "0")]
    assert [(e.row, e.column, e.printed) for e in twice.entries] == [(2, 1, "G")]
    assert block.message == "a block differs" and not block.entries


PHI, TWICE, FIRST = (rf"\varphi = {angle}" for angle in (r"\theta_1 + \theta_2", r"2\theta_1 + \theta_2", r"\theta_1"))


@pytest.mark.parametrize(
    ("displays", "verdicts"),
    [
        ([PHI, TWICE, PHI], "proved refuted proved"),
        ([PHI, FIRST, PHI], "proved unchecked proved"),
        ([PHI, r"\varphi = l_1 \theta_1", PHI, TWICE], "proved unchecked proved refuted"),
        ([TWICE, PHI], "unchecked unchecked"),  # nobody can tell which is meant
        ([f"x = {X[4:]}", f"x = {Y[4:]}", f"x = {X[4:]}"], "proved unchecked proved"),
    ],
    ids=" ; ".join,
)
def test_a_usual_name_keeps_under_its_heading_what_an_equation_showed_it_to_be(
    check: Callable[..., DocumentResult], displays: list[str], verdicts: str
) -> None:
    assert " ".join(record.verdict.value for record in check(*displays, **FRONT).equations) == verdicts


def test_a_usual_name_beside_another_of_the_same_quantity_means_something_else(
    check: Callable[..., DocumentResult],
) -> None:
    """x = p_x - l_1 c_1: the author has both, so x is no p_x; then it is held to that."""
    whole, wrist = f"= {X[4:]}", r"x = p_x - l_1 \cos\theta_1"
    right, wrong = (rf"x = {sign}l_2 \cos(\theta_1 + \theta_2)" for sign in ("", "-"))
    told = check(f"p_x {whole}", wrist, right, wrong, arm="planar_2r").equations
    assert [each.verdict.value for each in told] == ["proved", "defined", "proved", "refuted"]
    shown = check(f"p_x {whole}", f"x {whole}", wrist, arm="planar_2r").equations  # x is shown to be p_x here
    assert shown[-1].verdict == "refuted"


@pytest.mark.parametrize(
    ("entry", "verdict"), [("0", "defined"), ("1", "refuted"), ("-1", "refuted"), ("2", "unchecked")]
)
def test_a_pose_that_a_stray_unit_makes_none_is_refuted(entry: str, verdict: str) -> None:
    lift = rf"{{}}^0T_1 = \begin{{bmatrix}} 1 & {entry} & 0 & 0 \\ 0 & 1 & 0 & 0 \\ 0 & 0 & 1 & q_1 \\ 0 & 0 & 0 & 1 \end{{bmatrix}}"
    shifted = (
        r"{}^0T_1 \begin{bmatrix} 0 \\ 0 \\ 0 \\ 1 \end{bmatrix} = \begin{bmatrix} 0 \\ 0 \\ q_1 \\ 1 \end{bmatrix}"
    )
    assert verify_text(f"$$ {lift} $$\n\n$$ {shifted} $$\n").equations[0].verdict.value == verdict


TURNED = r"\begin{bmatrix} c_1 & s_1 & 0 \\ 0 & 0 & -1 \\ -s_1 & c_1 & 0 \end{bmatrix}"
BACK = r"\begin{bmatrix} c_1 & 0 & -s_1 \\ s_1 & 0 & c_1 \\ 0 & -1 & 0 \end{bmatrix}"
OF_BLOCKS = r"""## A

$$ M = \begin{bmatrix} c_1 & s_1 & 0 & -a_1 \\ 0 & 0 & -1 & d_1 \\ -s_1 & c_1 & 0 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix} = \begin{bmatrix} U & u \\ 0 & 1 \end{bmatrix} $$

"""


def test_blocks_of_a_matrix_have_letters_without_an_arm_and_are_names_of_their_own_once_printed() -> None:
    printed, transposed = f"$$ U = {TURNED} $$\n\n", f"## B\n\n$$ U^T = {BACK} $$\n"
    verdicts = [[each.verdict.value for each in verify_text(OF_BLOCKS + more).equations] for more in (
        printed, printed.replace("-s_1", "s_1"), printed + transposed, printed + transposed.replace("0 & -1", "0 & 1"), transposed
    )]  # fmt: skip
    assert verdicts == [
        ["defined", "proved"],
        ["defined", "refuted"],
        ["defined", "proved", "proved"],
        ["defined", "proved", "refuted"],
        ["unchecked", "unchecked"],  # what is told in a section alone
    ]
