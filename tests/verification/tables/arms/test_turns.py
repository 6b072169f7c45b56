"""A row of a table is confirmed by what its lengths stand in and what its turn moves: a slip in it refutes no right line behind it."""

from __future__ import annotations

import pytest

from armproof.verification.check import verify_text

ARTICULATED = (
    "| $i$ | $\\theta_i$ | $d_i$ | $a_i$ | $\\alpha_i$ |\n|---|---|---|---|---|\n"
    "| 1 | $q_1$ | $d_1$ | 0 | $\\pi/2$ |\n| 2 | $q_2$ | 0 | $a_2$ | 0 |\n| 3 | $q_3$ | 0 | 0 | $\\pi/2$ |\n"
    "| 4 | $q_4$ | $d_4$ | 0 | $%s\\pi/2$ |\n| 5 | $q_5$ | 0 | 0 | $\\pi/2$ |\n| 6 | $q_6$ | $d_6$ | 0 | 0 |\n\n"
)
WRIST_CENTRE = r"$$ p_4 = \begin{bmatrix} c_1 (a_2 c_2 + d_4 s_{23}) \\ s_1 (a_2 c_2 + d_4 s_{23}) \\ d_1 + a_2 s_2 - d_4 c_{23} \end{bmatrix} $$"
ITS_JACOBIAN = r"$$ J_{11} = \begin{bmatrix} -s_1 (a_2 c_2 + d_4 s_{23}) & c_1 (-a_2 s_2 + d_4 c_{23}) & d_4 c_1 c_{23} \\ c_1 (a_2 c_2 + d_4 s_{23}) & s_1 (-a_2 s_2 + d_4 c_{23}) & d_4 s_1 c_{23} \\ 0 & a_2 c_2 + d_4 s_{23} & d_4 s_{23} \end{bmatrix} $$"
WRIST = r"$$ R_6^3 = \begin{bmatrix} c_4 c_5 c_6 - s_4 s_6 & -c_4 c_5 s_6 - s_4 c_6 & c_4 s_5 \\ s_4 c_5 c_6 + c_4 s_6 & -s_4 c_5 s_6 + c_4 c_6 & s_4 s_5 \\ -s_5 c_6 & s_5 s_6 & c_5 \end{bmatrix} $$"
DETERMINANT = r"$$ \det J_{11} = a_2 d_4 c_3 (a_2 c_2 + d_4 s_{23}) $$"


def test_where_the_wrist_is_tells_nothing_of_how_its_first_row_turns() -> None:
    behind = "\n\n".join((WRIST_CENTRE, WRIST, ITS_JACOBIAN, DETERMINANT))
    right, wrong = (verify_text(ARTICULATED % sign + behind) for sign in "-+")
    assert right.equations[1].verdict == "proved"
    assert wrong.equations[1].verdict == "unchecked"
    assert wrong.tables[0].verdict == "unchecked"
    slip = verify_text(ARTICULATED % "-" + behind.replace("& s_4 s_5", "& s_4 c_5"))
    assert slip.equations[1].verdict == "refuted"


HEAD = "The modified DH parameters are\n\n| $i$ | $a_{i-1}$ | $\\alpha_{i-1}$ | $d_i$ | $\\theta_i$ |\n|---|---|---|---|---|\n"
SLIDE = (
    HEAD
    + "| 1 | 0 | $\\pi/2$ | $%s$ | $\\theta_1$ |\n| 2 | 0 | $\\pi/2$ | 0 | $\\theta_2$ |\n| 3 | 0 | 0 | $d_3$ | 0 |\n\n"
)
SLIDES = r"""$$ A_2 = \begin{bmatrix} c_2 & -s_2 & 0 & 0 \\ 0 & 0 & -1 & 0 \\ s_2 & c_2 & 0 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix} $$

$$ p_2 = \begin{bmatrix} 0 \\ -d_1 \\ 0 \end{bmatrix} $$

$$ J_v = \begin{bmatrix} d_3 \cos\theta_1 & 0 & \sin\theta_1 \\ 0 & 0 & 0 \\ d_3 \sin\theta_1 & 0 & -\cos\theta_1 \end{bmatrix} $$"""
PLANAR = (
    HEAD
    + "| 1 | $a_1$ | 0 | 0 | $\\theta_1$ |\n| 2 | $%s$ | 0 | $%s$ | $\\theta_2$ |\n| 3 | $a_3$ | 0 | 0 | $\\theta_3$ |\n\n"
)
LINKS = r"""$$ A_1 = \begin{bmatrix} c_1 & -s_1 & 0 & a_1 \\ s_1 & c_1 & 0 & 0 \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix} $$

$$ A_3 = \begin{bmatrix} c_3 & -s_3 & 0 & a_3 \\ s_3 & c_3 & 0 & 0 \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix} $$

$$ J_v = \begin{bmatrix} -a_2 \sin\theta_1 - a_3 \sin(\theta_1 + \theta_2) & -a_3 \sin(\theta_1 + \theta_2) & 0 \\ a_2 \cos\theta_1 + a_3 \cos(\theta_1 + \theta_2) & a_3 \cos(\theta_1 + \theta_2) & 0 \\ 0 & 0 & 0 \end{bmatrix} $$"""


@pytest.mark.parametrize(
    ("right", "wrong"),
    [
        pytest.param(SLIDE % "d_1" + SLIDES, SLIDE % "-d_1" + SLIDES, id="a height that moves nothing"),
        pytest.param(PLANAR % ("a_2", "0") + LINKS, PLANAR % ("0", "a_2") + LINKS, id="columns exchanged in one row"),
    ],
)
def test_a_slip_in_the_table_refutes_no_right_line(right: str, wrong: str) -> None:
    assert {record.verdict.value for record in verify_text(right).equations} == {"proved"}
    assert "refuted" not in {record.verdict.value for record in verify_text(wrong).equations}


def test_one_wrong_entry_of_a_vector_is_no_fault_of_a_row_whose_axis_moves() -> None:
    """Another row would change more; that of the first link may turn one coordinate alone."""
    wrong = LINKS.replace("-a_3 \\sin(\\theta_1 + \\theta_2) & 0", "a_3 \\sin(\\theta_1 + \\theta_2) & 0")
    assert verify_text(PLANAR % ("a_2", "0") + wrong).equations[-1].verdict == "refuted"
