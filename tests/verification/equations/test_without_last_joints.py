"""A Jacobian that is printed without the columns of its last joints, which are zero: a wrist turns about the point and does not move it."""

from __future__ import annotations

import pytest

from armproof.verification.check import verify_text

LINKS = "\n".join(
    rf"$$ A_{k} = \begin{{bmatrix}} c_{k} & -s_{k} & 0 & {x} \\ s_{k} & c_{k} & 0 & {y} \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{{bmatrix}} $$"
    for k, x, y in ((1, "l_1 c_1", "l_1 s_1"), (2, "l_2 c_2", "l_2 s_2"), (3, "0", "0"))
)
JACOBIAN = (
    r"$$ J = \begin{bmatrix} -l_1 s_1 - l_2 s_{12} & -l_2 s_{12} \\ l_1 c_1 + l_2 c_{12} & l_2 c_{12} \end{bmatrix} $$"
)


def verdicts(*displays: str) -> list[str]:
    return [record.verdict.value for record in verify_text("\n".join((LINKS, *displays))).equations][3:]


def test_columns_of_zeros_may_be_left_out() -> None:
    assert verdicts("$$ x = l_1 c_1 + l_2 c_{12} $$", JACOBIAN, r"$$ \det J = l_1 l_2 s_2 $$") == ["proved"] * 3


@pytest.mark.parametrize("wrong", ["l_1 c_{12} \\end", "l_2 s_{12} \\end"])
def test_a_wrong_entry_beside_them_is_found(wrong: str) -> None:
    assert verdicts("$$ x = l_1 c_1 + l_2 c_{12} $$", JACOBIAN.replace("l_2 c_{12} \\end", wrong))[-1] == "refuted"


def test_a_matrix_of_another_size_that_is_not_near_stays_open() -> None:
    other = r"$$ J = \begin{bmatrix} -d_1 s_1 & d_2 \\ d_1 c_1 & d_2 s_2 \end{bmatrix} $$"
    assert verdicts("$$ x = l_1 c_1 + l_2 c_{12} $$", other)[-1] == "unchecked"


@pytest.mark.parametrize(("determinant", "verdict"), [("-a_1 a_2 s_2", "proved"), ("a_1 a_2 s_2", "refuted")])
def test_the_determinant_of_a_linear_part_is_that_of_the_columns_printed(determinant: str, verdict: str) -> None:
    front = "---\narm:\n  dh: classic\n  rows:\n  - {a: a_1, alpha: 0, d: 0, theta: theta_1}\n  - {a: a_2, alpha: pi, d: 0, theta: theta_2}\n  - {a: 0, alpha: 0, d: d_3, theta: 0}\n  - {a: 0, alpha: 0, d: 0, theta: theta_4}\n  joints: [theta_1, theta_2, d_3, theta_4]\n---\n"
    linear = r"-a_1 s_1 - a_2 s_{12} & -a_2 s_{12} & 0 \\ a_1 c_1 + a_2 c_{12} & a_2 c_{12} & 0 \\ 0 & 0 & -1"
    displays = rf"$$ J_v = \begin{{bmatrix}} {linear} \end{{bmatrix}} $$", rf"$$ \det(J_v) = {determinant} $$"
    found = verify_text(front + "\n\n".join(displays)).equations
    assert [record.verdict.value for record in found] == ["proved", verdict]
