"""An index that stands for any joint: what is said holds where it does for each joint of the arm; it is never refuted."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from armproof.verification.verdict import Record

Judge = Callable[..., Record]
COLUMN = r"J_i = \begin{bmatrix} %s \times (p_n - %s) \\ %s \end{bmatrix}"


@pytest.mark.parametrize(
    ("latex", "arm", "verdict"),
    [
        (COLUMN % ("z_{i-1}", "p_{i-1}", "z_{i-1}"), "rx90", "unchecked"),  # of the modified convention
        (COLUMN % ("z_i", "p_i", "z_i"), "rx90", "proved"),
        (COLUMN % ("z_i", "p_{i-1}", "z_i"), "rx90", "unchecked"),
        (COLUMN % ("z_i", "p_i", "-z_i"), "rx90", "unchecked"),
        (
            COLUMN % ("z_i", "p_i", "z_i"),
            "scara_modified",
            "unchecked",
        ),  # of the joints that turn alone, and it says of all
        (r"J_i = \begin{bmatrix} z_{i-1} \\ 0 \end{bmatrix}", "scara", "unchecked"),  # of the one that slides
        (r"J_i = \begin{bmatrix} 0 \\ z_{i-1} \end{bmatrix}", "scara", "unchecked"),
        (r"z_j = R_j^0 \begin{bmatrix} 0 \\ 0 \\ 1 \end{bmatrix}", "rx90", "proved"),
        (r"z_j = R_{j-1}^0 \begin{bmatrix} 0 \\ 0 \\ 1 \end{bmatrix}", "rx90", "unchecked"),
        (r"v_i = J_1 \dot q_i", "planar_2r", "unchecked"),
        (r"z_i = z_j", "planar_2r", "unchecked"),  # two indices
    ],
)
def test_a_statement_about_any_joint_is_proved_joint_by_joint(judge: Judge, latex: str, arm: str, verdict: str) -> None:
    record = judge(latex, arm=arm)
    assert record.verdict.value == verdict
    assert (record.message == "joint by joint, on this arm") == (verdict == "proved")


def test_what_holds_of_one_joint_alone_is_no_law(judge: Judge) -> None:
    """Where only one slides, d_i z_i may be right by chance; a column of J has its own law there."""
    assert judge(r"p_i = p_{i-1} + d_i z_i", arm="scara").verdict.value == "unchecked"
    assert judge(COLUMN.replace(" - %s", "") % ("z_{i-1}", "z_{i-1}"), arm="polar_rp").verdict.value == "unchecked"
