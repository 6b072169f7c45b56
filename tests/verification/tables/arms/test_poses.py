"""An arm that a document shows by the pose of its tool alone."""

from __future__ import annotations

import pytest

from armproof.verification.check import verify_text
from armproof.verification.verdict import DocumentResult

POLAR = (
    r"T_3^0 = \begin{bmatrix} c_1 c_2 & -s_1 & c_1 s_2 & c_1 s_2 d_3 - s_1 d_2 \\ s_1 c_2 & c_1 & s_1 s_2 & s_1 s_2 d_3 + c_1 d_2 \\"
    r" -s_2 & 0 & c_2 & c_2 d_3 + h \\ 0 & 0 & 0 & 1 \end{bmatrix}"
)
ROLL = (
    r"{}^0T_3 = \begin{bmatrix} c_1 s_3 & c_1 c_3 & s_1 & d_2 s_1 \\ s_1 s_3 & s_1 c_3 & -c_1 & -d_2 c_1 \\"
    r" -c_3 & s_3 & 0 & l_1 \\ 0 & 0 & 0 & 1 \end{bmatrix}"
)


def check(*displays: str) -> DocumentResult:
    return verify_text("\n\n".join(f"$$ {each} $$" for each in displays))


def verdicts(*displays: str) -> list[str]:
    return [record.verdict.value for record in check(*displays).equations]


@pytest.mark.parametrize(
    ("pose", "joints", "right", "wrong"),
    [
        (POLAR, "theta_1, theta_2, d_3", "-p_x s_1 + p_y c_1 = d_2", "p_x s_1 + p_y c_1 = d_2"),
        (POLAR, "theta_1, theta_2, d_3", "p_x^2 + p_y^2 + (p_z - h)^2 = d_2^2 + d_3^2", "p_x^2 + p_y^2 + p_z^2 = d_2^2 + d_3^2"),
        (ROLL, "theta_1, d_2, theta_3", "p_x^2 + p_y^2 = d_2^2", "p_x^2 - p_y^2 = d_2^2"),
    ],
)  # fmt: skip
def test_a_pose_shows_its_arm(pose: str, joints: str, right: str, wrong: str) -> None:
    result = check(pose, right)
    assert [f"joints: [{joints}]" in arm.front_matter for arm in result.arms] == [True]
    assert [record.verdict.value for record in result.equations] == ["defined", "proved"]
    assert verdicts(pose, right, wrong)[2] == "refuted"


@pytest.mark.parametrize(
    ("right", "slip"), [("c_1 c_2 &", "c_1 s_2 &"), ("- s_1 d_2", "+ s_1 d_2"), ("c_2 d_3 + h", "s_2 d_3 + h"), ("d_3 - s_1", "d_4 - s_1")]
)  # fmt: skip
def test_a_matrix_that_no_arm_has_shows_none(right: str, slip: str) -> None:
    assert POLAR.count(right) == 1 and not check(POLAR.replace(right, slip), "-p_x s_1 + p_y c_1 = d_2").arms


def test_frames_between_are_not_told() -> None:
    """Where frame 1 stands and how it is turned, the pose of frame 3 does not say."""
    link = r"T_1^0 = \begin{bmatrix} c_1 & 0 & -s_1 & 0 \\ s_1 & 0 & c_1 & 0 \\ 0 & -1 & 0 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}"
    assert verdicts(POLAR, "-p_x s_1 + p_y c_1 = d_2", "p_1^0 = [0, 0, h]^T")[2] == "unchecked"
    assert "refuted" not in verdicts(POLAR, "-p_x s_1 + p_y c_1 = d_2", link)


def test_a_table_is_no_worse_witness_than_a_pose() -> None:
    table = "| a | alpha | d | theta |\n|---|---|---|---|\n| 0 | $90°$ | $h$ | $\\theta_1$ |\n| 0 | 0 | $l$ | 0 |\n\n"
    assert not verify_text(f"{table}$$ {POLAR} $$\n\n$$ -p_x s_1 + p_y c_1 = d_2 $$").arms


def test_a_section_with_a_pose_of_no_known_arm_is_about_none() -> None:
    planar = "# Planar\n$$ x = l_1 c_1 + l_2 c_{12} $$\n\n$$ y = l_1 s_1 + l_2 s_{12} $$\n\n$$ x^2 + y^2 = l_1^2 + l_2^2 + 2 l_1 l_2 c_2 $$\n\n"
    other = f"# Another\n$$ {POLAR.replace('c_2 d_3', 'c_2^2 d_3')} $$\n\n$$ x^2 + y^2 = d_2^2 $$\n"
    assert [record.verdict.value for record in verify_text(planar + other).equations][-2:] == ["unchecked", "unchecked"]
