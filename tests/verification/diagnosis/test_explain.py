"""Which other usual matrix was printed: each explanation is reached by a display, and by that display only."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

from armproof.verification.verdict import Record, Verdict

Judge = Callable[..., Record]

LINEAR = r"-a_1 s_1 - a_2 s_{12} & -a_2 s_{12} & 0 & 0 \\ a_1 c_1 + a_2 c_{12} & a_2 c_{12} & 0 & 0 \\ 0 & 0 & -1 & 0"
ANGULAR = r"0 & 0 & 0 & 0 \\ 0 & 0 & 0 & 0 \\ 1 & 1 & 0 & -1"
SWAPPED_COLUMNS = (
    r"-a_2 s_{12} & -a_1 s_1 - a_2 s_{12} & 0 & 0 \\ a_2 c_{12} & a_1 c_1 + a_2 c_{12} & 0 & 0 \\ 0 & 0 & -1 & 0"
)
TURNED = r"-a_1 s_1 - a_2 s_{12} & a_2 s_{12} & 0 & 0 \\ a_1 c_1 + a_2 c_{12} & -a_2 c_{12} & 0 & 0 \\ 0 & 0 & -1 & 0 \\ 0 & 0 & 0 & 0 \\ 0 & 0 & 0 & 0 \\ 1 & -1 & 0 & -1"  # fmt: skip
POINT = r"-a_1 s_1 & 0 & 0 & 0 \\ a_1 c_1 & 0 & 0 & 0 \\ 0 & 0 & 0 & 0"


def matrix(rows: str) -> str:
    return rf"\begin{{bmatrix}} {rows} \end{{bmatrix}}"


def crossed(frames: list[int], tool: int, sliding: int | None = None) -> str:
    """Return the Jacobian built from the axes and origins of these frames, as a block matrix."""
    above = [f"z_{k}" if k == sliding else rf"z_{k} \times (p_{tool} - p_{k})" for k in frames]
    below = ["0" if k == sliding else f"z_{k}" for k in frames]
    return matrix(" & ".join(above) + r" \\ " + " & ".join(below))


# display, what is said, front matter
EXPLAINED: list[tuple[str, str, dict[str, Any]]] = [
    (r"A^0_1 = " + matrix(r"c_1 & s_1 & 0 & 0 \\ -s_1 & c_1 & 0 & 0 \\ 0 & 0 & 1 & 0 \\ a_1 c_1 & a_1 s_1 & 0 & 1"), "the matrix is transposed", {}),
    (r"J_v J_v^T = \begin{bmatrix} 1 & a_1 \\ a_2 & 1 \end{bmatrix}", "the printed matrix is 2×2, it should be 3×3", {"quantities": {"J_v": {"jacobian": 4, "rows": [1, 2, 3]}}}),
    (r"A^0_1 = " + matrix(r"c_1 & s_1 & 0 & -a_1 \\ -s_1 & c_1 & 0 & 0 \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1"), "the inverse is printed: the pose of frame 0 in frame 1; if the lower index of A^0_1 names the reference frame, say 'transforms: lower' in the front matter", {}),
    (r"A_0^1 = " + matrix(r"c_1 & s_1 & 0 & -a_1 \\ -s_1 & c_1 & 0 & 0 \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1"), "say 'transforms: upper' in the front matter", {"transforms": "lower"}),
    (r"{}^0T_1 = " + matrix(r"c_1 & s_1 & 0 & -a_1 \\ -s_1 & c_1 & 0 & 0 \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1"), "the inverse is printed: the pose of frame 0 in frame 1", {}),
    (r"R^0_1 = " + matrix(r"c_1 & s_1 & 0 \\ -s_1 & c_1 & 0 \\ 0 & 0 & 1"), "the inverse is printed", {}),
    (r"T^0_4 = A^0_1 A^1_2 A^2_3", "this is the pose of frame 3, not 4", {}),
    (r"T^0_4 = A^1_2 A^2_3 A^3_4", "this is the pose in frame 1, not 0", {}),
    (r"p_4 = " + matrix(r"-a_1 c_1 - a_2 c_{12} \\ -a_1 s_1 - a_2 s_{12} \\ d_3 + d_4"), "wrong sign of the whole", {}),
    (r"p_2 = " + matrix(r"a_1 c_1 \\ a_1 s_1 \\ 0"), "this is that of frame 1, not 2", {}),
    (r"p_4 = " + matrix(r"a_2 c_2 \\ a_2 s_2 \\ -d_3 - d_4"), "it is expressed in frame 1, not 0", {}),
    (r"x_2^0 = " + matrix(r"s_{12} \\ -c_{12} \\ 0"), "this is the y axis", {}),
    (r"{}^0T_1 = Rot(z, -\theta_1) Trans(x, a_1)", "joint theta_1 is taken the other way", {}),
    (r"A^0_1 = Rot(z, \theta_1 + \frac{\pi}{2}) Trans(x, a_1)", "theta_1 is counted from another zero: off by π/2", {}),
    (r"A^0_1 = Rot(z, \theta_1 - \frac{\pi}{2}) Trans(x, a_1)", "theta_1 is counted from another zero: off by -π/2", {}),
    (r"A^0_1 = Rot(z, \theta_1 + \pi) Trans(x, a_1)", "theta_1 is counted from another zero: off by π", {}),
    (r"{}^1T_2 = Rot(z, \theta_2) Rot(x, \frac{\pi}{2})", "this is the classic link matrix, the arm's frames are those of the modified convention", {"arm": "rx90"}),
    (r"{}^3T_4 = Rot(z, \theta_4) Trans(z, d_3) Rot(x, -\frac{\pi}{2})", "this is the classic link matrix", {"arm": "rx90"}),
    (r"A^1_2 = Rot(x, \pi) Trans(x, a_2) Rot(z, \theta_2)", "this is the modified link matrix, the arm's frames are those of the classic convention", {}),
    (rf"J = {matrix(ANGULAR + chr(92) * 2 + LINEAR)}", "the blocks are swapped: the rows are [ω; v], [v; ω] is meant", {"quantities": {"J": {"jacobian": 4}}}),
    (r"J = \begin{bmatrix} J_\omega \\ J_v \end{bmatrix}", "the blocks are swapped", {"arm": "rx90", "quantities": {"J": {"jacobian": 6}}}),
    (r"J = " + matrix(r"-l_1 s_1 - l_2 s_{12} & l_1 c_1 + l_2 c_{12} \\ -l_2 s_{12} & l_2 c_{12}"), "the matrix is transposed", {"arm": "planar_2r", "quantities": {"J": {"jacobian": 2, "rows": [1, 2]}}}),
    (r"J = {}^1J", "it is expressed in frame 1, not 0", {}),
    (r"J_v = (R^0_4)^T J_v", "it is expressed in frame 4, not 0", {}),
    (rf"J_v = {matrix(POINT)}", "its linear part is that of the origin of frame 1, not 4", {}),
    (r"J = " + matrix(POINT + r"\\ 0 & 0 & 0 & 0 \\ 0 & 0 & 0 & 0 \\ 1 & 1 & 0 & -1"), "its linear part is that of the origin of frame 1, not 4", {}),
    (r"J = " + matrix(POINT + r"\\ 0 & 0 & 0 & 0 \\ 0 & 0 & 0 & 0 \\ 1 & 0 & 0 & 0"), "this is the Jacobian of frame 1, not 4", {}),
    (f"J = {crossed([0, 1, 2, 3], 4, sliding=2)}", "z_{i-1} stands where z_i is the joint's axis (modified DH)", {"arm": "scara_modified"}),
    (f"J = {crossed([0, 1, 2, 3, 4, 5], 6)}", "z_{i-1} stands where z_i is the joint's axis (modified DH)", {"arm": "rx90"}),
    (f"J = {crossed([1, 2, 3, 4], 4, sliding=3)}", "z_i stands where z_{i-1} is the joint's axis (classic DH)", {}),
    (rf"J = {matrix(TURNED)}", "column 2: joint theta_2 is taken the other way", {}),
    (rf"J = {matrix(SWAPPED_COLUMNS + chr(92) * 2 + ANGULAR)}", "columns 1 and 2 are swapped", {}),
    (r"p_2 = " + matrix(r"a_2 c_1 + a_1 c_{12} \\ a_2 s_1 + a_1 s_{12} \\ 0"), "lengths a_1 and a_2 are swapped throughout", {}),
    (r"p_2 = " + matrix(r"a_1 s_1 + a_2 s_{12} \\ a_1 c_1 + a_2 c_{12} \\ 0"), "entries (1, 1) and (2, 1) are swapped", {}),
    (r"p_4 = " + matrix(r"-d_3 - d_4 \\ 3 \\ -d_3 - d_4"), "what is printed belongs in entry (3, 1)", {}),
    (r"T^0_4 = A^0_1 A^1_2 Trans(z, 2 d_3) Rot(x, \frac{\pi}{4}) A^3_4", "frame 3 is the first that differs from the arm's", {}),
    (r"T^0_4 = A^0_1 Rot(z, 2\theta_2) Trans(x, a_2) Rot(x, \pi) A^2_3 A^3_4", "theta_2 is counted twice", {}),
]  # fmt: skip


@pytest.mark.parametrize(
    ("latex", "words", "front"), EXPLAINED, ids=[f"{words} [{k}]" for k, (_, words, _) in enumerate(EXPLAINED)]
)
def test_a_usual_mistake_is_named(judge: Judge, latex: str, words: str, front: dict[str, Any]) -> None:
    record = judge(latex, **front)
    assert record.verdict is Verdict.REFUTED
    assert words in record.message


def test_each_convention_has_its_axes(judge: Judge) -> None:
    classic, modified = (
        f"J = {crossed(frames, 4, sliding)}" for frames, sliding in (([0, 1, 2, 3], 2), ([1, 2, 3, 4], 3))
    )
    down = modified.replace("& z_3 &", "& -z_3 &")  # d_2 counts downward on that arm
    assert judge(classic).verdict is Verdict.PROVED
    assert judge(down, arm="scara_modified").verdict is Verdict.PROVED
    assert judge(f"J = {crossed([1, 2, 3, 4, 5, 6], 6)}", arm="rx90").verdict is Verdict.PROVED
    assert judge(modified, arm="scara_modified").message == "entry (3, 3): is 1, should be -1"


def test_a_matrix_that_is_none_of_them_is_not_explained_away(judge: Judge) -> None:
    record = judge(r"p_4 = " + matrix(r"a_1 c_1 + 3 a_2^2 c_{12} \\ a_1 s_1 + 7 s_{12}^3 \\ -d_3 - d_4"))
    assert "entry (1, 1)" in record.message and "entry (2, 1)" in record.message
    assert not any(word in record.message for word in ("frame", "swapped", "transposed", "inverse"))


def test_one_wrong_entry_is_no_other_matrix(judge: Judge) -> None:
    assert judge(r"p_4 = p_3").message.startswith("entry (3, 1)")


def test_a_zero_matrix_is_no_other_frames_jacobian(judge: Judge) -> None:
    assert "frame 0" not in judge("J = 0").message
