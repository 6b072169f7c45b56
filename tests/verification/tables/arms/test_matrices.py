"""The arm of a document that shows no DH table: read from its link matrices, which are data then."""

from __future__ import annotations

from pathlib import Path

import pytest

from armproof import verify_text
from armproof.verification.document import parse_document
from armproof.verification.report.totals import Totals
from armproof.verification.running.incremental import IncrementalChecker
from armproof.verification.verdict import DocumentResult, Role
from tests.verification.tables.arms.test_inference import (
    CLASSIC,
    CRAIG,
    FIRST,
    SECOND,
    WHOLE,
    link,
    pose,
    verdicts,
    whole,
)

JACOBIAN = "$$ J_v = \\begin{bmatrix} -l_1 s_1 - l_2 s_{12} & -l_2 s_{12} \\\\ l_1 c_1 + l_2 c_{12} & l_2 c_{12} \\end{bmatrix} $$\n"


def turn(k: str) -> str:
    return rf"\begin{{bmatrix}} c_{k} & -s_{k} & 0 & 0 \\ s_{k} & c_{k} & 0 & 0 \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{{bmatrix}}"


def shift(x: str) -> str:
    return rf"\begin{{bmatrix}} 1 & 0 & 0 & {x} \\ 0 & 1 & 0 & 0 \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{{bmatrix}}"


def roles(result: DocumentResult) -> list[Role]:
    return [each.role for record in result.equations for each in record.outcomes]


def test_what_a_witness_confirms_is_proved() -> None:
    result = verify_text(CLASSIC)
    (arm,) = result.arms
    assert (arm.source, arm.line, arm.convention) == ("matrices", 1, "classic")
    assert verdicts(result) == ["proved"] * 3 and set(roles(result)) == {Role.CLAIM}


def test_a_wrong_product_confirms_nothing_and_is_refuted() -> None:
    result = verify_text(link(1, FIRST) + link(2, SECOND) + whole(y="l_1 s_1 - l_2 s_{12}"))
    assert verdicts(result) == ["defined", "defined", "refuted"] and roles(result)[:2] == [Role.DATA] * 2
    assert "for the arm of the matrices at line 1" in result.equations[2].message
    assert [(entry.row, entry.column) for entry in result.equations[2].entries] == [(2, 4)]


def test_link_matrices_alone_decide_nothing() -> None:
    assert verdicts(verify_text(link(1, FIRST) + link(2, SECOND))) == ["unchecked", "unchecked"]


def test_the_second_convention_is_fitted_too() -> None:
    displays = CRAIG + pose(WHOLE, "c_{12}", "s_{12}", "l_1 + l_2 c_1", "l_2 s_1")
    result = verify_text(displays)
    assert result.arms[0].convention == "modified" and verdicts(result) == ["proved"] * 3
    assert verify_text(displays.replace("l_2 s_1", "l_2 c_1")).equations[2].verdict == "refuted"


@pytest.mark.parametrize(
    ("first", "second", "both"),
    [("A_1", "A_2", "{}^0T_2"), ("T_0^1", "T_1^2", "T_0^2"), ("T_{01}", "T_{12}", "T_{02}")],
)
def test_link_matrices_are_named_as_they_are_written(first: str, second: str, both: str) -> None:
    right = link(1, first) + link(2, second) + whole(both)
    assert verdicts(verify_text(right)) == ["proved"] * 3
    assert verdicts(verify_text(right.replace("l_2 s_{12}", "l_2 c_{12}")))[2] == "refuted"


def test_a_matrix_that_is_no_link_gives_no_arm_and_is_named() -> None:
    result = verify_text(link(1, FIRST) + link(2, SECOND, "-l_2 s_2").replace("l_2 c_2", "l_3 c_2") + whole())
    assert result.arms == () and "refuted" not in verdicts(result)
    assert "the matrix at line 3 is that of no DH link" in result.equations[1].message


def test_a_matrix_with_one_wrong_entry_is_told_by_what_else_holds() -> None:
    links = link(1, FIRST) + link(2, SECOND, "-l_2 s_2")
    assert verdicts(verify_text(links + whole())) == ["proved", "refuted", "proved"]
    (entry,) = verify_text(links + whole()).equations[1].entries
    assert (entry.row, entry.column, entry.correct) == (2, 4, "l_2 s_2")
    assert "refuted" not in verdicts(verify_text(links))


def test_link_matrices_of_two_arms_give_none() -> None:
    other = link(1, FIRST).replace("l_1", "b_1")
    result = verify_text(CLASSIC + other)
    assert result.arms == ()


def test_the_first_of_more_link_matrices_are_no_arm() -> None:
    more = r"$$ J_v = \\begin{bmatrix} -l_1 s_1 - l_2 s_{12} - l_3 s_{123} \\end{bmatrix} $$"
    result = verify_text(link(1, FIRST) + link(2, SECOND) + more)
    assert result.arms == () and "refuted" not in verdicts(result)


def test_offsets_slides_and_twists_are_fitted() -> None:
    first = (
        r"$$ A_1 = \begin{bmatrix} -s_1 & 0 & c_1 & 0 \\ c_1 & 0 & s_1 & 0 \\ 0 & 1 & 0 & d_1 \\ 0 & 0 & 0 & 1 \end{bmatrix} $$"
        + "\n\n"
    )
    second = (
        r"$$ A_2 = \begin{bmatrix} 1 & 0 & 0 & 0 \\ 0 & 1 & 0 & 0 \\ 0 & 0 & 1 & d_2 \\ 0 & 0 & 0 & 1 \end{bmatrix} $$"
        + "\n\n"
    )
    point = r"$$ p_2 = \begin{bmatrix} d_2 c_1 \\ d_2 s_1 \\ d_1 \end{bmatrix} $$" + "\n"
    result = verify_text(first + second + point)
    arm = result.arms[0].front["arm"]
    assert arm["joints"] == ["theta_1", "d_2"] and "theta_1 + pi/2" in arm["rows"][0].values()
    assert (
        verdicts(result)[2] == "proved"
        and verify_text(first + second + point.replace("c_1", "s_1")).equations[2].verdict != "proved"
    )


def test_the_jacobian_is_a_witness() -> None:
    assert verdicts(verify_text(link(1, FIRST) + link(2, SECOND) + JACOBIAN)) == ["proved"] * 3
    wrong = JACOBIAN.replace("& -l_2 s_{12}", "& l_2 s_{12}")
    assert verdicts(verify_text(link(1, FIRST) + link(2, SECOND) + wrong)) == ["defined", "defined", "refuted"]


def test_one_display_may_hold_them_all() -> None:
    together = (link(1, FIRST) + link(2, SECOND) + whole()).replace(" $$\n\n$$ ", r", \quad ")
    assert verdicts(verify_text(together)) == ["proved"]
    wrong = (link(1, FIRST) + link(2, SECOND) + whole(y="l_1 s_1")).replace(" $$\n\n$$ ", r", \quad ")
    result = verify_text(wrong)
    assert verdicts(result) == ["refuted"] and roles(result) == [Role.DATA, Role.DATA, Role.CLAIM]


def test_a_law_that_only_this_arm_cannot_have_is_not_refuted() -> None:
    law = r"$$ \dot{x} = J \dot{q} $$" + "\n\n" + r"$$ \dot{q} = J^{-1} \dot{x} $$" + "\n\n"
    slide = (
        r"$$ A_3 = \begin{bmatrix} 1 & 0 & 0 & 0 \\ 0 & 1 & 0 & 0 \\ 0 & 0 & 1 & d_3 \\ 0 & 0 & 0 & 1 \end{bmatrix} $$"
        + "\n\n"
    )
    stuck = link(1, "A_1").replace("l_1 c_1", "0").replace("l_1 s_1", "0") + link(2, "A_2") + slide
    result = verify_text(law + stuck)
    assert len(result.arms) == 1 and "refuted" not in verdicts(result)


ONE = r"\begin{bmatrix} c_1 & -s_1 & 0 & l_1 c_1 \\ s_1 & c_1 & 0 & l_1 s_1 \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}"
TWO = ONE.replace("_1", "_2")
BOTH = r"\begin{bmatrix} c_{12} & -s_{12} & 0 & l_1 c_1 + l_2 c_{12} \\ s_{12} & c_{12} & 0 & l_1 s_1 + l_2 s_{12} \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix}"
STILL = r"\begin{bmatrix} 1 & 0 & 0 & 0.2 \\ 0 & 1 & 0 & 0 \\ 0 & 0 & 1 & 0.1 \\ 0 & 0 & 0 & 1 \end{bmatrix}"


@pytest.mark.parametrize(
    ("product", "claim", "found"),
    [
        (f"T_0^1 T_1^2 = {ONE} {TWO}", "", ["unchecked"]),  # nothing else tells
        (f"T_0^1 T_1^2 = {ONE} {TWO}", BOTH, ["proved", "proved"]),
        (f"T_0^1 T_1^2 = {ONE} {TWO}", BOTH.replace("l_2 s_{12}", "l_2 s_2"), ["defined", "refuted"]),
        (rf"T_0^1 \cdot T_1^2 = {ONE} \cdot {TWO}", BOTH, ["proved", "proved"]),
    ],
)
def test_a_product_shows_links_factor_by_factor_and_they_are_data(product: str, claim: str, found: list[str]) -> None:
    text = f"$$ {product} $$\n\n" + (f"$$ T_0^2 = {claim} $$\n" if claim else "")
    assert verdicts(verify_text(text)) == found


@pytest.mark.parametrize("root", ["", "$$ r = \\sqrt{x^2 + y^2} $$\n\n"])
def test_a_root_before_the_links_hides_no_arm(root: str) -> None:
    assert verdicts(verify_text(root + CLASSIC))[-3:] == ["proved"] * 3


def test_links_named_as_poses_are_links() -> None:
    links = f"$$ T_1 = {ONE} $$\n\n$$ T_2 = {TWO} $$\n\n"
    assert verdicts(verify_text(links + f"$$ T = T_1 T_2 = {BOTH} $$\n"))[-1] == "proved"
    assert (
        verdicts(verify_text(links + f"$$ T = T_1 T_2 = {BOTH.replace('l_2 s_{12}', 'l_2 s_2')} $$\n"))[-1] == "refuted"
    )
    assert "T_2: {pose: '2', in: '1'}" in verify_text(links).arms[0].front_matter


@pytest.mark.parametrize(("height", "verdict"), [("0.1", "proved"), ("0.2", "refuted")])
def test_a_link_of_numbers_between_others_does_not_move(height: str, verdict: str) -> None:
    links = f"$$ A_1 = {ONE} $$\n\n$$ A_2 = {STILL} $$\n\n$$ A_3 = {ONE.replace('_1', '_3')} $$\n\n"
    result = verify_text(links + f"$$ T_3^0 = A_1 A_2 A_3 $$\n\n$$ z = {height} $$\n\n$$ x^2 = x^2 $$\n")
    assert "joints: [theta_1, theta_3]" in result.arms[0].front_matter
    column = rf"\begin{{bmatrix}} l_1 c_1 + 0.2 c_1 + l_3 c_{{13}} \\ l_1 s_1 + 0.2 s_1 + l_3 s_{{13}} \\ {height} \end{{bmatrix}}"
    assert verdicts(verify_text(links + f"$$ p_3 = {column} $$\n"))[-1] == verdict


def test_matrices_that_a_table_repeats_are_shown_twice() -> None:
    table = "| i | a | alpha | d | theta |\n|---|---|---|---|---|\n| 1 | $l_1$ | 0 | 0 | $\\theta_1$ |\n| 2 | %s | 0 | 0 | $\\theta_2$ |\n\n"
    links = link(1, "T_{01}") + link(2, "T_{12}")
    assert set(verdicts(verify_text(table % "$l_2$" + links))) <= {"proved", "defined"}


@pytest.mark.parametrize("y", ["l_1 s_1 + l_2 s_{12}", "l_1 s_1 - l_2 s_{12}"])
@pytest.mark.parametrize(
    ("first", "second"),
    [
        (r"R_z(\theta_1) \operatorname{Trans}(l_1, 0, 0)", r"Rot(z, \theta_2) Trans(x, l_2)"),
        (" ".join([turn("1"), shift("l_1")]), " ".join([turn("2"), shift("l_2")])),
        (r"𝑅_𝑧(𝜃_1) 𝑇𝑟𝑎𝑛𝑠(𝑙_1, 0, 0)", r"𝑅_𝑧(𝜃_2) \cdot 𝑇𝑟𝑎𝑛𝑠(𝑙_2, 0, 0)"),
    ],
)
def test_a_link_may_be_shown_by_elementary_steps(first: str, second: str, y: str) -> None:
    result = verify_text(f"$$ {FIRST} = {first} $$\n\n$$ {SECOND} = {second} $$\n\n" + whole(y=y))
    assert [arm.source for arm in result.arms] == ["matrices"]
    assert verdicts(result) == (["defined", "defined", "refuted"] if "-" in y else ["proved"] * 3)


def test_the_height_of_the_base_may_be_the_first_link() -> None:
    base = (
        r"$$ T_1^0 = \begin{bmatrix} 1 & 0 & 0 & 0 \\ 0 & 1 & 0 & 0 \\ 0 & 0 & 1 & h \\ 0 & 0 & 0 & 1 \end{bmatrix} $$"
    )
    links = base + "\n\n" + link(1, "T_2^1") + link(2, "T_3^2")
    right = links + whole("T_3^0").replace("1 & 0 \\\\ 0 & 0 & 0 & 1", "1 & h \\\\ 0 & 0 & 0 & 1")
    assert "& h" in right[len(links) :] and verdicts(verify_text(right)) == ["proved"] * 4
    assert verdicts(verify_text(links + whole("T_3^0")))[3] == "refuted"


def test_a_product_that_is_written_the_other_way_round_than_the_links_is_left_open() -> None:
    links = link(1, "T_1^0") + link(2, "T_2^1")
    blocks = "$$ T_0^2 = T_0^1 T_1^2 = \\begin{bmatrix} R & P \\\\ 0 & 1 \\end{bmatrix} $$\n"
    point = "$$ P = \\begin{bmatrix} l_1 c_1 + l_2 c_{12} \\\\ l_1 s_1 + l_2 s_{12} \\\\ 0 \\end{bmatrix} $$\n"
    result = verify_text(links + whole("T_2^0") + blocks + point)
    assert verdicts(result) == ["proved"] * 3 + ["unchecked", "proved"]
    assert "holds only if the lower index" in result.equations[3].message
    assert verdicts(verify_text(links + whole("T_2^0") + blocks + point.replace("+ l_2 s", "- l_2 s")))[4] == "refuted"
    assert verdicts(verify_text(links + "$$ T_2^0 = T_2^1 T_1^0 $$\n"))[2] == "refuted"
    assert verdicts(verify_text(links + whole("T_2^0") + "$$ T_0^2 = T_0^1 T_0^1 $$\n"))[3] == "refuted"


def test_watching_leaves_open_what_checking_leaves_open() -> None:
    text = link(1, "T_1^0") + link(2, "T_2^1") + whole("T_2^0") + "$$ T_0^2 = T_0^1 T_1^2 $$\n"
    checker = IncrementalChecker(Path("sheet.md"))
    for each in (text, text + "$$ x = l_1 c_1 + l_2 c_{12} $$\n"):
        list(checker.update(parse_document(Path("sheet.md"), each)))
        assert checker.result is not None
        found = [record.verdict.value for record in checker.result.equations]
        assert found == verdicts(verify_text(each)) and found[3] == "unchecked"


def test_links_may_stand_side_by_side_in_one_display() -> None:
    both = link(1, FIRST).strip().strip("$") + link(2, SECOND).strip().strip("$")
    assert verdicts(verify_text(f"$$ {both} $$\n\n" + whole())) == ["proved"] * 2
    assert verdicts(verify_text(f"$$ {both} $$\n\n" + whole(y="l_1 s_1 - l_2 s_{12}"))) == ["defined", "refuted"]


def test_a_link_of_a_length_that_nobody_can_name_gives_no_arm() -> None:
    first = turn("1").replace("1 & 0 \\\\ 0 & 0 & 0 & 1", r"1 & d_1 _+ d_2 \\ 0 & 0 & 0 & 1")
    second = turn("2").replace("0 & 0 & 1 & 0", "0 & 0 & 1 & l_2")
    assert "_+" in first
    assert not verify_text(rf"$$ {{}}^0T_1 = {first} \qquad {{}}^1T_2 = {second} $$").arms


def test_the_pose_of_a_frame_that_is_fixed_on_the_last_confirms_the_links() -> None:
    tool = (
        turn("9")
        .replace("c_9", "1")
        .replace("s_9", "0")
        .replace("-0", "0")
        .replace("1 & 0 \\\\ 0 & 0 & 0 & 1", "1 & 0.3 \\\\ 0 & 0 & 0 & 1")
    )
    to_tool = whole("T_G^0").replace("0 & 0 & 1 & 0", "0 & 0 & 1 & 0.3")
    text = link(1, "T_1^0") + link(2, "T_2^1") + f"$$ T_G^2 = {tool} $$\n\n"
    assert verdicts(verify_text(text + to_tool)) == ["proved", "proved", "defined", "proved"]
    assert verdicts(verify_text(text + to_tool.replace("0.3", "0.4")))[-1] != "proved"


def test_a_tool_whose_axes_are_turned_is_no_mistake() -> None:
    tool = "\\begin{bmatrix} 1 & 0 & 0 & 0 \\\\ 0 & 1 & 0 & 0 \\\\ 0 & 0 & 1 & 0.3 \\\\ 0 & 0 & 0 & 1 \\end{bmatrix}"
    text = (
        link(1, "T_1^0")
        + link(2, "T_2^1")
        + f"$$ T_G^2 = {tool} $$\n\n"
        + whole("T_G^0").replace("0 & 0 & 1 & 0", "0 & 0 & 1 & 0.3")
    )
    turned = "$$ T_G^0 = \\begin{bmatrix} -s_{12} & -c_{12} & 0 & l_1 c_1 + l_2 c_{12} \\\\ c_{12} & -s_{12} & 0 & l_1 s_1 + l_2 s_{12} \\\\ 0 & 0 & 1 & 0.3 \\\\ 0 & 0 & 0 & 1 \\end{bmatrix} $$\n\n"
    found = verify_text(text + turned).equations[-1]
    assert found.verdict == "unchecked" and "turned_tool" in [finding.kind for finding in found.findings]
    about_x = "$$ T_G^0 = \\begin{bmatrix} c_{12} & 0 & s_{12} & l_1 c_1 + l_2 c_{12} \\\\ s_{12} & 0 & -c_{12} & l_1 s_1 + l_2 s_{12} \\\\ 0 & 1 & 0 & 0.3 \\\\ 0 & 0 & 0 & 1 \\end{bmatrix} $$\n\n"
    assert "turned_tool" in [finding.kind for finding in verify_text(text + about_x).equations[-1].findings]
    moved = about_x.replace("0.3", "0.4")
    assert verdicts(verify_text(text + moved))[-1] == "refuted"
    mirrored = turned.replace("-c_{12} & 0 &", "c_{12} & 0 &").replace("-s_{12} & 0 & l_1 s_1", "s_{12} & 0 & l_1 s_1")
    assert verdicts(verify_text(text + mirrored))[-1] == "refuted"


def test_letters_by_their_rows_are_the_numbers_of_the_links() -> None:
    text = (link(1, "T_1^0") + link(2, "T_2^1") + whole("T_2^0")).replace("l_1", "0.5").replace("l_2", "0.3")
    column = "$$ p_2 = \\begin{bmatrix} a_1 c_1 + a_2 c_{12} \\\\ a_1 s_1 + a_2 s_{12} \\\\ 0 \\end{bmatrix} $$\n"
    assert verdicts(verify_text(text + column))[-1] == "proved"
    assert verdicts(verify_text(text + column.replace("a_2 s", "a_1 s")))[-1] == "refuted"


CYLINDRICAL = r"""
$${}^0T_1 = \begin{bmatrix} c_1 & -s_1 & 0 & 0 \\ s_1 & c_1 & 0 & 0 \\ 0 & 0 & 1 & l_1 \\ 0 & 0 & 0 & 1 \end{bmatrix}, \quad
{}^1T_2 = \begin{bmatrix} 1 & 0 & 0 & 0 \\ 0 & 0 & 1 & 0 \\ 0 & -1 & 0 & d_2 \\ 0 & 0 & 0 & 1 \end{bmatrix}, \quad
{}^2T_3 = \begin{bmatrix} 1 & 0 & 0 & 0 \\ 0 & 1 & 0 & 0 \\ 0 & 0 & 1 & d_3 \\ 0 & 0 & 0 & 1 \end{bmatrix}$$

$${}^0T_3 = {}^0T_1 {}^1T_2 {}^2T_3 = \begin{bmatrix} c_1 & 0 & -s_1 & -d_3 s_1 \\ s_1 & 0 & c_1 & d_3 c_1 \\ 0 & -1 & 0 & l_1 + d_2 \\ 0 & 0 & 0 & 1 \end{bmatrix}$$

$$p_x = -d_3 s_1, \quad p_y = d_3 c_1, \quad p_z = l_1 + d_2$$

$$J_v = \begin{bmatrix} -d_3 c_1 & 0 & -s_1 \\ -d_3 s_1 & 0 & c_1 \\ 0 & 1 & 0 \end{bmatrix}$$

$$\det J_v = d_3$$
"""


def with_slip(printed: str, other: str) -> DocumentResult:
    """The verdicts of a cylindrical arm's sheet with one thing printed otherwise, where that stands first."""
    assert printed in CYLINDRICAL
    return verify_text(CYLINDRICAL.replace(printed, other, 1))


@pytest.mark.parametrize(
    ("printed", "other"),
    [
        ("{}^0T_1 = ", "{}^1T_1 = "),
        ("{}^1T_2 = ", "{}^1T_3 = "),
        ("{}^2T_3 = ", "{}^2T_2 = "),
        ("-1 & 0 & d_2", "-1 & 0 & d_1"),
        ("-1 & 0 & d_2", "-1 & 0 & d_3"),
        ("-1 & 0 & d_2", "1 & 0 & d_2"),
        ("1 & 0 & 0 & 0 ", "1 & 0 & 1 & 0 "),
        ("c_1 & -s_1", "c_2 & -s_1"),
        ("0 & 0 & 0 & 1", "0 & 0 & 1 & 1"),
    ],
)
def test_a_link_matrix_with_a_slip_is_refuted_and_costs_the_others_nothing(printed: str, other: str) -> None:
    assert set(verdicts(with_slip(printed, printed))) == {"proved"}
    first, *others = verdicts(with_slip(printed, other))
    assert first == "refuted" and set(others) == {"proved"}


@pytest.mark.parametrize(
    ("printed", "other", "correct"),
    [("& l_1", "& l_2", "l_1"), ("& l_1", "& -l_1", "l_1"), ("& d_2", "& -d_2", "d_2"), ("1 & d_3", "1 & -d_3", "d_3")],
)
def test_a_length_in_a_link_matrix_against_the_rest_leaves_both_open(printed: str, other: str, correct: str) -> None:
    first, *others = with_slip(printed, other).equations
    assert first.verdict.value == "unchecked" and first.findings[0].terms["correct"] == correct
    assert "refuted" not in {each.verdict.value for each in others} and "one of the two is wrong" in others[0].message


@pytest.mark.parametrize("wrong", ["l_1 - d_2", "l_2 + d_2"])
def test_one_display_against_a_link_matrix_is_refuted(wrong: str) -> None:
    assert verdicts(with_slip("p_z = l_1 + d_2", f"p_z = {wrong}")) == [
        "proved",
        "proved",
        "refuted",
        "proved",
        "proved",
    ]


def test_what_holds_speaks_for_a_link_matrix() -> None:
    """Two displays that have the same slip are wrong where a third one holds as the matrix is printed."""
    wrong = CYLINDRICAL.replace("l_1 + d_2", "l_1 - d_2")
    assert verdicts(verify_text(wrong + "\n$$\\dot p_z = \\dot d_2$$\n"))[:3] == ["proved", "refuted", "refuted"]


TABLE = "| i | a | alpha | d | theta |\n|---|---|---|---|---|\n| 1 | 0 | 0 | $l_1$ | $\\theta_1$ |\n| 2 | 0 | $-\\pi/2$ | $d_2$ | 0 |\n| 3 | 0 | 0 | $d_3$ | 0 |\n"


@pytest.mark.parametrize(
    ("printed", "other", "column", "correct"),
    [
        ("$-\\pi/2$", "$\\pi/2$", "alpha", "-pi/2"),
        ("$l_1$", "$-l_1$", "d", "l_1"),
        ("$l_1$", "0", "d", "l_1"),
        ("3 | 0 | 0", "3 | $l_1$ | 0", "a", "0"),
        ("$\\theta_1$", "$-\\theta_1$", "theta", "theta_1"),
    ],
)
def test_a_cell_of_a_table_against_the_rest_leaves_both_open(
    printed: str, other: str, column: str, correct: str
) -> None:
    """The matrix of the second link holds or not by itself; the first and the third have no matrix here."""
    text = TABLE + CYLINDRICAL[CYLINDRICAL.index("$${}^0T_3") :].replace("{}^0T_1 {}^1T_2 {}^2T_3 = ", "")
    assert set(verdicts(verify_text(text))) == {"proved"}
    result = verify_text(text.replace(printed, other, 1))
    (table,) = result.tables
    assert table.verdict.value == "unchecked" and "refuted" not in verdicts(result)
    assert (table.findings[0].terms["column"], table.findings[0].terms["correct"]) == (column, correct)
    assert Totals.of([result]).verdict.startswith("some lines contradict each other; ")


def test_a_letter_where_the_table_has_nothing_is_not_defined_by_it() -> None:
    """A_1 with h beside a table without it: h is no name for zero."""
    lacking = TABLE.replace("$l_1$", "0") + CYLINDRICAL[: CYLINDRICAL.index(", \\quad")] + "$$\n"
    assert verdicts(verify_text(lacking)) == ["unchecked"]


LINKS = r"""
$$ T_0^1 = \begin{bmatrix} c_1 & -s_1 & 0 & l_1 c_1 \\ s_1 & c_1 & 0 & l_1 s_1 \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix} $$

$$ T_1^2 = \begin{bmatrix} c_2 & -s_2 & 0 & l_2 c_2 \\ s_2 & c_2 & 0 & l_2 s_2 \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix} $$

$$ T_0^2 = \begin{bmatrix} c_{12} & -s_{12} & 0 & l_1 c_1 + l_2 c_{12} \\ s_{12} & c_{12} & 0 & l_1 s_1 + l_2 s_{12} \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix} $$
"""


@pytest.mark.parametrize(
    "link",
    [
        r"c_2 & 0 & -s_2 & l_2 c_2 \\ s_2 & 0 & c_2 & l_2 s_2 \\ 0 & 1 & 0 & 0",
        r"c_2 & -s_2 & 0 & l_2 c_2 \\ 0 & 0 & 1 & 0 \\ s_2 & c_2 & 0 & l_2 s_2",
    ],
)
def test_two_columns_or_rows_that_are_exchanged_in_a_link_matrix_hide_no_arm(link: str) -> None:
    right = r"c_2 & -s_2 & 0 & l_2 c_2 \\ s_2 & c_2 & 0 & l_2 s_2 \\ 0 & 0 & 1 & 0"
    assert verdicts(verify_text(LINKS)) == ["proved"] * 3
    assert verdicts(verify_text(LINKS.replace(right, link))) == ["proved", "refuted", "proved"]


def test_a_display_with_a_length_that_the_arm_lacks_speaks_against_a_link_matrix() -> None:
    """Either may be wrong: T_1^2 with l_1 for l_2, or what has l_2 below it."""
    assert verdicts(verify_text(LINKS))[:3] == ["proved", "proved", "proved"]
    first, second, whole_pose, *_ = verify_text(
        LINKS.replace("l_2 c_2", "l_1 c_2").replace("l_2 s_2", "l_1 s_2", 1)
    ).equations
    assert [each.verdict.value for each in (first, second, whole_pose)] == ["defined", "unchecked", "unchecked"]
    assert "one of the two is wrong" in second.message and "one of the two is wrong" in whole_pose.message


def test_a_section_that_prints_the_first_link_again_is_about_the_same_arm() -> None:
    first = LINKS[: LINKS.index("$$ T_1^2")]
    speed = "$$ \\dot q = J^{-1} \\dot p_2 $$\n"
    assert len(verify_text("# One\n" + LINKS + "# Two\n" + first + speed).arms) == 1
    assert len(verify_text("# One\n" + LINKS + "# Two\n" + LINKS.replace("l_1", "h") + speed).arms) == 2


LEANING = r"""
$$ T_{01} = \begin{bmatrix} c_1 & 0 & s_1 & 0 \\ s_1 & 0 & -c_1 & 0 \\ 0 & 1 & 0 & a_1 \\ 0 & 0 & 0 & 1 \end{bmatrix} $$

$$ T_{12} = \begin{bmatrix} c_2 & -s_2 & 0 & -a_2 s_2 \\ s_2 & c_2 & 0 & a_2 c_2 \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix} $$

$$ T_{02} = \begin{bmatrix} c_1 c_2 & -c_1 s_2 & s_1 & -a_2 c_1 s_2 \\ s_1 c_2 & -s_1 s_2 & -c_1 & HERE \\ s_2 & c_2 & 0 & a_1 + a_2 c_2 \\ 0 & 0 & 0 & 1 \end{bmatrix} $$
"""


@pytest.mark.parametrize(("entry", "verdict"), [("-a_2 s_1 s_2", "proved"), ("a_2 s_1 s_2", "refuted")])
def test_a_link_may_lie_along_y_of_the_frame_that_its_joint_turns(entry: str, verdict: str) -> None:
    assert verdicts(verify_text(LEANING.replace("HERE", entry)))[-1] == verdict


@pytest.mark.parametrize(("entry", "verdict"), [("l_1 s_1 + d_2 c_1", "proved"), ("l_1 s_1 - d_2 c_1", "refuted")])
def test_a_link_may_slide_along_y(entry: str, verdict: str) -> None:
    slide = (
        r"$$ T_{12} = \begin{bmatrix} 1 & 0 & 0 & 0 \\ 0 & 1 & 0 & d_2 \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix} $$"
        + "\n\n"
    )
    first = link(1, FIRST).replace("^0T_1", "T_{01}") + slide
    whole = rf"$$ T_{{02}} = \begin{{bmatrix}} c_1 & -s_1 & 0 & l_1 c_1 - d_2 s_1 \\ s_1 & c_1 & 0 & {entry} \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{{bmatrix}} $$"
    assert verdicts(verify_text(first + whole))[-1] == verdict
