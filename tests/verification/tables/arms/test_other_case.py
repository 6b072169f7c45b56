"""L_2 in formulas for the l_2 of link matrices, and where it may be something else."""

from __future__ import annotations

from armproof import verify_text

A1 = (
    r"$$ A_1 = \begin{bmatrix} c_1 & 0 & s_1 & 0 \\ s_1 & 0 & -c_1 & 0 \\ 0 & 1 & 0 & l_1 \\ 0 & 0 & 0 & 1 \end{bmatrix} $$"
    "\n\n"
)
A2 = (
    r"$$ A_2 = \begin{bmatrix} c_2 & -s_2 & 0 & l_2 c_2 \\ s_2 & c_2 & 0 & l_2 s_2 \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix} $$"
    "\n\n"
)
P = r"$$ p_x = L_2 c_1 c_2, \quad p_y = L_2 s_1 c_2, \quad p_z = L_1 + L_2 s_2 $$" "\n\n"


def verdicts(text: str) -> list[str]:
    return [each.verdict.value for record in verify_text(text).equations for each in record.outcomes]


def test_a_length_written_large_is_the_one_of_the_matrices() -> None:
    result = verify_text(A1 + A2 + P)
    assert "L_2: l_2" in result.arms[0].front_matter
    assert verdicts(A1 + A2 + P) == ["proved"] * 5
    assert verdicts(A1 + A2 + P.replace("L_1 + L_2 s_2", "L_1 - L_2 s_2"))[-1] == "refuted"


def test_it_is_not_where_the_document_says_what_it_is() -> None:
    said = "$$ L_2 = l_2 + b $$\n\n"
    assert "L_2: l_2" not in verify_text(A1 + A2 + said + P).arms[0].front_matter
    assert "proved" not in verdicts(A1 + A2 + said + P)[-3:]


def test_it_is_not_where_both_stand_in_one_display() -> None:
    both = r"$$ L_1 + l_1 = b $$" "\n\n"
    assert "proved" not in verdicts(A1 + A2 + both + P)[-3:]
