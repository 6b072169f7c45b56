"""A link matrix that is given twice, by its factors and entry by entry: what is none of a link does not hide what the other tells."""

from __future__ import annotations

from armproof import verify_text

FACTORS = r"""
$$ {}^0T_1 = R_z(\theta_1) T_z(d_1) R_x(90^\circ) $$

$$ {}^1T_2 = R_z(\theta_2) T_x(a_2) $$

$$ {}^2T_3 = R_z(\theta_3) T_x(a_3) $$

$$ z = d_1 + a_2 s_2 + a_3 s_{23} $$

$$ {}^0T_1 = \begin{bmatrix} c_1 & 0 & s_1 & 0 \\ s_1 & 0 & -c_1 & 0 \\ 0 & 1 & 0 & d_1 \\ 0 & 0 & 0 & 1 \end{bmatrix} $$

$$ {}^0R_3 = \begin{bmatrix} c_1 c_{23} & -c_1 s_{23} & s_1 \\ s_1 c_{23} & -s_1 s_{23} & -c_1 \\ s_{23} & c_{23} & 0 \end{bmatrix} $$
"""


def verdicts(text: str) -> list[str]:
    return [record.verdict.value for record in verify_text(text).equations]


def test_entries_that_are_no_link_are_refuted_by_what_holds_with_the_factors() -> None:
    assert "refuted" not in verdicts(FACTORS)
    found = verdicts(FACTORS.replace("s_1 & 0 & -c_1 & 0", "s_1 & 0 & c_1 & 0"))
    assert found.count("refuted") == 1
    assert found[4] == "refuted"


def test_two_links_that_differ_leave_it_open() -> None:
    text = FACTORS.replace("0 & 1 & 0 & d_1", "0 & 1 & 0 & d_2")
    assert "refuted" not in verdicts(text)
    assert not verify_text(text).arms
