"""One entry of a DH table against the rest of its document: it is named, and neither side is refuted."""

from __future__ import annotations

import pytest

from armproof.verification.check import verify_text

HEAD = "| i | $\\theta_i$ | $d_i$ | $a_i$ | $\\alpha_i$ |\n|---|---|---|---|---|\n"
ROWS = "| 1 | $\\theta_1$ | 35 | 0 | $\\pi/2$ |\n| 2 | $\\theta_2$ | 0 | 107.5 | 0 |\n| 3 | $\\theta_3$ | 0 | 54.5 | 0 |\n\n"
FORMULAS = (
    "$$ P_z = d_1 + a_2 \\sin\\theta_2 + a_3 \\sin(\\theta_2 + \\theta_3) $$\n\n"
    "$$ P_x = \\cos\\theta_1 (a_2 \\cos\\theta_2 + a_3 \\cos(\\theta_2 + \\theta_3)) $$\n\n"
    "$$ P_x^2 + P_y^2 + (P_z - d_1)^2 = a_2^2 + a_3^2 + 2 a_2 a_3 \\cos\\theta_3 $$\n\n"
    "$$ P_y = \\sin\\theta_1 (a_2 \\cos\\theta_2 + a_3 \\cos(\\theta_2 + \\theta_3)) $$\n"
)


@pytest.mark.parametrize(
    ("printed", "slip"),
    [("35 | 0 | $\\pi/2$", "35 | 0 | $-\\pi/2$"), ("107.5 | 0 |", "107.5 | 90° |")],
)
def test_an_entry_of_a_table_of_numbers_is_named_with_the_lines_that_hold_without_it(printed: str, slip: str) -> None:
    right, wrong = (verify_text(HEAD + rows + FORMULAS) for rows in (ROWS, ROWS.replace(printed, slip)))
    assert {record.verdict.value for record in right.equations} == {"proved"}
    assert "refuted" not in {record.verdict.value for record in wrong.equations}
    [table] = wrong.tables
    assert table.verdict == "unchecked" and [finding.kind for finding in table.findings] == ["link_disputed"]


def test_a_table_that_its_only_link_matrix_contradicts_does_not_pass() -> None:
    head = "| i | $\\alpha_{i-1}$ | $a_{i-1}$ | $d_i$ | $\\theta_i$ |\n|---|---|---|---|---|\n"
    rows = "| 1 | 0 | 0 | 0 | $\\theta_1$ |\n| 2 | 90° | $a_1$ | 0 | $\\theta_2$ |\n\n"
    first = "\\begin{bmatrix} c_1 & -s_1 & 0 & 0 \\\\ s_1 & c_1 & 0 & 0 \\\\ 0 & 0 & 1 & 0 \\\\ 0 & 0 & 0 & 1 \\end{bmatrix}"
    second = "\\begin{bmatrix} c_2 & -s_2 & 0 & a_1 \\\\ 0 & 0 & 1 & 0 \\\\ -s_2 & -c_2 & 0 & 0 \\\\ 0 & 0 & 0 & 1 \\end{bmatrix}"
    found = verify_text(f"{head}{rows}$$ {{}}^0_1T = {first} $$\n\n$$ {{}}^1_2T = {second} $$\n")
    [table] = found.tables
    assert table.verdict == "unchecked" and "refuted" not in {record.verdict.value for record in found.equations}


POSES = (
    r"{}^0T_1 = \begin{bmatrix} c_1 & 0 & s_1 & 0 \\ s_1 & 0 & -c_1 & 0 \\ 0 & 1 & 0 & d_1 \\ 0 & 0 & 0 & 1 \end{bmatrix}",
    r"{}^0T_2 = \begin{bmatrix} c_1 c_2 & -c_1 s_2 & s_1 & a_2 c_1 c_2 \\ s_1 c_2 & -s_1 s_2 & -c_1 & a_2 s_1 c_2 \\ s_2 & c_2 & 0 & d_1 + a_2 s_2 \\ 0 & 0 & 0 & 1 \end{bmatrix}",
    r"{}^0T_3 = \begin{bmatrix} c_1 c_{23} & -c_1 s_{23} & s_1 & c_1 (a_2 c_2 + a_3 c_{23}) \\ s_1 c_{23} & -s_1 s_{23} & -c_1 & s_1 (a_2 c_2 + a_3 c_{23}) \\ s_{23} & c_{23} & 0 & d_1 + a_2 s_2 + a_3 s_{23} \\ 0 & 0 & 0 & 1 \end{bmatrix}",
)


@pytest.mark.parametrize(("angle", "table_verdict"), [("$\\theta_1$", "defined"), ("0", "unchecked")])
def test_a_row_that_turns_although_its_table_has_no_angle_is_named(angle: str, table_verdict: str) -> None:
    rows = f"| 1 | {angle} | $d_1$ | 0 | $\\pi/2$ |\n| 2 | $\\theta_2$ | 0 | $a_2$ | 0 |\n| 3 | $\\theta_3$ | 0 | $a_3$ | 0 |\n\n"
    found = verify_text(HEAD + rows + "\n\n".join(f"$$ {pose} $$" for pose in POSES) + "\n")
    [table] = found.tables
    assert table.verdict == table_verdict
    if table_verdict == "unchecked":
        [finding] = table.findings
        assert finding.kind == "link_disputed" and finding.terms["correct"] == "theta_1"
        assert [each.verdict.value for each in found.equations] == ["unchecked"] * 3
    else:
        assert [each.verdict.value for each in found.equations] == ["proved"] * 3


UPRIGHT = "| 1 | 0 | $d_1$ | 0 | 0 |\n| 2 | $\\theta_2$ | 0 | $a_2$ | 0 |\n| 3 | $\\theta_3$ | 0 | $a_3$ | 0 |\n\n"
PLACES = (
    r"A_2 = \begin{bmatrix} c_2 & -s_2 & 0 & a_2 c_2 \\ s_2 & c_2 & 0 & a_2 s_2 \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}",
    r"x = a_2 c_2 + a_3 c_{23}",
    r"y = a_2 s_2 + a_3 s_{23}",
    r"z = d_1",
    r"x^2 + y^2 = a_2^2 + a_3^2 + 2 a_2 a_3 c_3",
)


def said_of(rows: str, *displays: str) -> tuple[str, list[str]]:
    """Return what becomes of a table and of the displays behind it."""
    found = verify_text(HEAD + rows + "".join(f"$$ {each} $$\n\n" for each in displays))
    return found.tables[0].verdict.value, [each.verdict.value for each in found.equations]


def test_a_length_that_has_the_index_of_another_row_is_refuted_where_the_displays_have_its_own() -> None:
    assert said_of(UPRIGHT, *PLACES) == ("defined", ["proved"] * 5)
    slipped = UPRIGHT.replace("$a_3$", "$a_2$")
    assert said_of(slipped, *PLACES) == ("refuted", ["proved"] * 5)
    assert said_of(slipped, *PLACES[:4], PLACES[4].replace("+ 2", "- 2")) == ("refuted", [*["proved"] * 4, "refuted"])


def test_two_links_of_one_length_are_no_slip() -> None:
    alike = tuple(each.replace("a_3", "a_2") for each in PLACES)
    assert said_of(UPRIGHT.replace("$a_3$", "$a_2$"), *alike) == ("defined", ["proved"] * 5)
    other = tuple(each.replace("a_3", "a_4") for each in PLACES)  # whose index it is, nothing tells
    table, found = said_of(UPRIGHT.replace("$a_3$", "$a_2$"), *other)
    assert table != "refuted" and "refuted" not in found
