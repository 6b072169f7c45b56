"""DH tables: right ones are proved, and every change of one entry is refuted at that entry."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import lru_cache
from pathlib import Path
from typing import Any

import pytest

from armproof.models.catalogue import arm_names, load_arm
from armproof.verification.check import DocumentChecker, check_document, verify, verify_text
from armproof.verification.document import Display, Document, Table
from armproof.verification.findings import Kind
from armproof.verification.tables import check_array_table, check_table
from armproof.verification.tables.check import read_array
from armproof.verification.verdict import DocumentResult, Record, Verdict

CLASSIC = ("i", "a_i", r"\alpha_i", "d_i", r"\theta_i")
MODIFIED = ("i", "a_{i-1}", r"\alpha_{i-1}", "d_i", r"\theta_i")
QUARTER = r"\frac{\pi}{2}"
THETA = [rf"\theta_{k}" for k in range(7)]

# every arm of the catalogue whose frames are DH frames
RIGHT: dict[str, tuple[tuple[str, ...], list[str]]] = {
    "scara": (CLASSIC, ["1 a_1 0 0 θ1", r"2 a_2 \pi 0 θ2", "3 0 0 d_3 0", "4 0 0 d_4 θ4"]),
    "scara_column": (CLASSIC, ["1 a_1 0 d_1 θ1", r"2 a_2 \pi 0 θ2", "3 0 0 d_3 0", "4 0 0 d_4 θ4"]),
    "scara_modified": (MODIFIED, ["1 0 0 0 θ1", "2 a_2 0 0 θ2", "3 a_3 0 -d_2 0", "4 0 0 0 θ4"]),
    "rx90": (
        MODIFIED,
        ["1 0 0 0 θ1", "2 0 +90 0 θ2", "3 a_3 0 0 θ3", "4 0 -90 d_3 θ4", "5 0 +90 0 θ5", "6 0 -90 0 θ6"],
    ),
    "spherical_wrist": (CLASSIC, ["4 0 -90 0 θ4", "5 0 +90 0 θ5", "6 0 0 d_6 θ6"]),
    "planar_2r": (CLASSIC, ["1 l_1 0 0 θ1", "2 l_2 0 0 θ2"]),
    "planar_3r": (CLASSIC, ["1 l_1 0 0 θ1", "2 l_2 0 0 θ2", "3 l_3 0 0 θ3"]),
    "spatial_rrr": (CLASSIC, ["1 0 +90 l_1 θ1", "2 l_2 0 0 θ2", "3 0 +90 0 θ3", "P 0 0 l_3 0"]),
    "polar_rp": (CLASSIC, [r"1 0 0 0 \theta", "2 r 0 0 0"]),
}
# the arm whose frames are no DH frames: those of the document stand parallel to frame 0
KR210 = (
    ("i", r"\alpha_{i-1}", "a_{i-1}", "d_i", r"\theta_i"),
    ["1 0 0 d_1+d_2 θ1", rf"2 -90 a_1 0 \theta_2-{QUARTER}", "3 0 a_2 0 θ3", "4 -90 -a_3 d_4+d_5 θ4", "5 +90 0 0 θ5",
     "6 -90 0 0 θ6", "G 0 0 d_6+d_G 0"],
)  # fmt: skip


def cells(row: str) -> tuple[str, ...]:
    for short, latex in (("+90", QUARTER), ("-90", f"-{QUARTER}"), *((f"θ{k}", name) for k, name in enumerate(THETA))):
        row = row.replace(short, latex)
    return tuple(row.split())


def right_table(arm: str) -> Table:
    header, rows = KR210 if arm == "kr210" else RIGHT[arm]
    return Table(1, header, tuple(cells(row) for row in rows))


@lru_cache(maxsize=16)
def checker(arm: str | None) -> DocumentChecker:
    front = {} if arm is None else {"arm": arm}
    return DocumentChecker(
        Document(Path("page.md"), front, (), ()), None if arm is None else load_arm(arm), confirm=False
    )


def judge(arm: str | None, table: Table) -> Record:
    record = check_table(checker(arm).checker, table)
    assert record is not None
    return record


def changed(table: Table, row: int, column: int, text: str) -> Table:
    """The table with another text at a place of its body, counted from 1."""
    rows = [list(cells) for cells in table.rows]
    rows[row - 1][column - 1] = text
    return replace(table, rows=tuple(map(tuple, rows)))


def in_columns(table: Table, order: tuple[int, ...]) -> Table:
    return replace(
        table, header=tuple(table.header[k] for k in order), rows=tuple(tuple(r[k] for k in order) for r in table.rows)
    )


def with_header(table: Table, *header: str) -> Table:
    return replace(table, header=header)


def as_array(table: Table) -> str:
    lines = [" & ".join(row) for row in (table.header, *table.rows)]
    return r"\begin{array}{c|cccc} " + lines[0] + r" \\ \hline " + r" \\ ".join(lines[1:]) + r" \\ \hline \end{array}"


def document(arm: Any, *tables: Table, displays: tuple[Display, ...] = ()) -> DocumentResult:
    front = {} if arm is None else {"arm": arm}
    return check_document(Document(Path("page.md"), front, displays, tables))


def places(record: Record) -> set[tuple[int | None, int | None]]:
    return {(entry.row, entry.column) for entry in record.entries}


# -- right tables ------------------------------------------------------------------------------------------------------


def test_every_arm_has_a_table_here() -> None:
    assert {*RIGHT, "kr210"} == set(arm_names())


@pytest.mark.parametrize("arm", [*RIGHT, "kr210"])
def test_right_tables_are_proved_and_confirmed_on_the_double_plant(arm: str) -> None:
    (record,) = document(arm, right_table(arm)).tables
    assert record.verdict is Verdict.PROVED, record.message
    assert record.samples == 1000
    assert record.max_error is not None and record.max_error < 1e-12


@pytest.mark.parametrize("arm", RIGHT)
def test_a_table_set_as_an_array_has_the_verdict_of_the_markdown_table(arm: str) -> None:
    table = right_table(arm)
    found = document(arm, displays=(Display(7, as_array(table)),))
    (record,) = found.equations
    assert record.verdict is Verdict.PROVED
    assert record.line == 7 and record.latex == as_array(table)


@pytest.mark.parametrize("order", [(4, 3, 2, 1, 0), (0, 2, 1, 3, 4), (3, 4, 1, 2, 0)])
@pytest.mark.parametrize("arm", RIGHT)
def test_columns_may_stand_in_any_order(arm: str, order: tuple[int, ...]) -> None:
    assert judge(arm, in_columns(right_table(arm), order)).verdict is Verdict.PROVED


@pytest.mark.parametrize(
    "header",
    [
        ("$i$", "$a_i$", r"$\alpha_i$ (rad)", "$d_i$", r"$\theta_i$"),
        ("Link", "a", "alpha", "d", "theta"),
        ("Joint $i$", "Link length $a_i$", r"Link twist $\alpha_i$", "Link offset $d_i$", r"Joint angle $\theta_i$"),
        ("segment", "aᵢ", "αᵢ", "rᵢ", "θᵢ"),
        ("j", "aⱼ", "⍺ⱼ", "dⱼ", "θⱼ"),
        (r"{}^{i-1}T_i", r"\mathbf{a}_i", r"\boldsymbol{\alpha}_i", "d_{i}", r"\theta_i^*"),
        ("n°", "a_j", r"\alpha_j", "d_j", "q_j"),
        (r"\text{Link}", "a_i", r"\alpha_i\,[\mathrm{rad}]", "d_i", r"\theta_i"),
        ("", "length", "twist", "offset", "angle"),
    ],
)
def test_headers_are_known_in_their_usual_spellings(header: tuple[str, ...]) -> None:
    assert judge("scara", with_header(right_table("scara"), *header)).verdict is Verdict.PROVED


@pytest.mark.parametrize(
    "star", [r"\theta_1^*", r"\theta_1^{\star}", "θ1*", "θ₁", "q_1", "q1", r"\theta_1(t)", "var", "*"]
)
def test_joint_variables_may_carry_a_star_or_another_letter(star: str) -> None:
    assert judge("scara", changed(right_table("scara"), 1, 5, star)).verdict is Verdict.PROVED


@pytest.mark.parametrize(
    ("header", "minus", "plus"),
    [
        (r"\alpha_{i-1}", r"-90^\circ", r"90^{\circ}"),
        (r"\alpha_{i-1}", "-90°", "90 deg"),
        (r"$\alpha_{i-1}$ (deg)", "-90", "90"),
        (r"\alpha_{i-1}\ [^\circ]", "270", "-270"),
        ("α_{i-1} (°)", "−90", "90"),
        (r"\alpha_{i-1}", "-pi/2", "π/2"),
        (r"\alpha_{i-1}", r"-\pi/2", r"5\pi/2"),
    ],
)
def test_twists_may_be_in_degrees_or_radians(header: str, minus: str, plus: str) -> None:
    table = with_header(right_table("rx90"), "i", "a_{i-1}", header, "d_i", r"\theta_i")
    for row, text in ((2, plus), (4, minus), (5, plus), (6, minus)):
        table = changed(table, row, 3, text)
    assert judge("rx90", table).verdict is Verdict.PROVED
    assert judge("rx90", changed(table, 6, 3, plus)).verdict is Verdict.REFUTED


def test_plain_integers_in_an_angle_column_are_degrees_and_the_message_says_so() -> None:
    record = judge("scara", changed(right_table("scara"), 2, 3, "180"))
    assert record.verdict is Verdict.PROVED
    assert "180 is read in degrees" in record.message


@pytest.mark.parametrize(
    "labels",
    [
        ("Link 4", "Link 5", "Link 6"),
        ("{}^3T_4", "{}^4T_5", "{}^5T_6"),
        (r"3 \to 4", "4-5", "5–6"),
        (r"\theta_4", r"\theta_5", r"\theta_6"),
    ],
)
def test_row_labels_select_the_frames(labels: tuple[str, ...]) -> None:
    table = right_table("spherical_wrist")
    rows = tuple((label, *row[1:]) for label, row in zip(labels, table.rows, strict=True))
    assert judge("spherical_wrist", replace(table, rows=rows)).verdict is Verdict.PROVED
    assert judge("spherical_wrist", replace(table, rows=tuple(reversed(rows)))).verdict is Verdict.PROVED
    others = tuple((label, *row[1:]) for label, row in zip(reversed(labels), table.rows, strict=True))
    assert judge("spherical_wrist", replace(table, rows=others)).verdict is Verdict.REFUTED


def test_a_table_for_some_of_the_joints_says_for_which_not() -> None:
    table = right_table("rx90")
    record = judge("rx90", replace(table, rows=table.rows[3:]))
    assert record.verdict is Verdict.PROVED
    assert "3 rows for an arm of 6 joints: none for theta_1, theta_2, theta_3" in record.message


def test_a_row_beyond_the_arm_is_left_open_unless_it_is_zero() -> None:
    table = right_table("scara")
    zeros = judge("scara", replace(table, rows=(*table.rows, ("5", "0", "0", "0", "0"))))
    assert zeros.verdict is Verdict.PROVED
    assert "5 rows for an arm of 4 joints" in zeros.message
    more = judge("scara", replace(table, rows=(*table.rows, ("5", "0", "0", "d_4", "0"))))
    assert more.verdict is Verdict.UNCHECKED
    assert "row 5 has no frame" in more.message


@pytest.mark.parametrize("label", ["P", "4", "tool", "Gripper"])
def test_a_row_for_the_tool_is_checked_against_the_frame_that_the_arm_names(label: str) -> None:
    table = changed(right_table("spatial_rrr"), 4, 1, label)
    assert judge("spatial_rrr", table).verdict is Verdict.PROVED
    assert places(judge("spatial_rrr", changed(table, 4, 4, "l_2"))) == {(4, 4)}


def test_khalils_letters_are_known() -> None:
    table = with_header(right_table("rx90"), "j", "d_j", r"\alpha_j", "r_j", r"\theta_j")
    record = judge("rx90", table)
    assert record.verdict is Verdict.PROVED
    assert "the rows hold in the modified one, d the length along x" in record.message
    wrong = judge("rx90", changed(table, 4, 4, "-d_3"))
    assert "row 4: r is -d_3, should be d_3: the sign" in wrong.message


def test_lengths_in_numbers_are_those_of_the_model() -> None:
    arm = load_arm("scara")
    table = right_table("scara")
    for row, column, symbol in ((1, 2, "a_1"), (2, 2, "a_2"), (4, 4, "d_4")):
        table = changed(table, row, column, f"{arm.lengths[symbol]}")
    assert judge("scara", table).verdict is Verdict.PROVED
    wrong = judge("scara", changed(table, 2, 2, "0.3"))
    assert [(e.row, e.column, e.correct) for e in wrong.entries] == [(2, 2, f"{arm.lengths['a_2']}")]
    millimetres = with_header(changed(table, 2, 2, f"{1000 * arm.lengths['a_2']:g}"), "i", "a_i (mm)", *CLASSIC[2:])
    millimetres = changed(millimetres, 1, 2, f"{1000 * arm.lengths['a_1']:g}")
    assert judge("scara", millimetres).verdict is Verdict.PROVED


def test_a_table_with_a_column_a_joint_is_turned() -> None:
    table = right_table("planar_2r")
    grid = tuple(zip(*(table.header, *table.rows), strict=True))
    turned = Table(1, grid[0], grid[1:])
    assert judge("planar_2r", turned).verdict is Verdict.PROVED
    wrong = judge("planar_2r", changed(turned, 1, 3, "l_1"))
    assert [(e.row, e.column, e.printed, e.correct) for e in wrong.entries] == [(1, 3, "l_1", "l_2")]


# -- wrong tables ------------------------------------------------------------------------------------------------------


def changes(arm: str, parameter: str, text: str) -> Iterator[str]:
    """Other values of an entry: its negative, 0, an offset, every other symbol."""
    yield from [] if text == "0" else ["0", text.removeprefix("-") if text.startswith("-") else f"-{text}"]
    if parameter in ("alpha", "theta"):
        yield from [QUARTER] if text == "0" else [f"{text} + {QUARTER}", f"{text} - {QUARTER}"]
        variables = [f"\\{j.symbol}" for j in load_arm(arm).joints if j.kind == "revolute"]
        yield from [other for other in variables if other != text][:2]
    else:
        symbols = [*load_arm(arm).lengths, *(j.symbol for j in load_arm(arm).joints if j.kind == "prismatic")]
        yield from (sign + other for other in symbols for sign in ("", "-") if other != text.removeprefix("-"))


@pytest.mark.parametrize("arm", RIGHT)
def test_every_change_of_one_entry_is_refuted_at_that_entry_and_undone(arm: str) -> None:
    table = right_table(arm)
    tried = 0
    for row, texts in enumerate(table.rows, 1):
        for column, parameter in enumerate(("a", "alpha", "d", "theta"), 2):
            text = texts[column - 1]
            for other in changes(arm, parameter, text):
                if text == r"\pi" and other == r"-\pi":
                    continue  # half a turn either way
                record = judge(arm, changed(table, row, column, other))
                assert record.verdict is Verdict.REFUTED, (row, column, other)
                found = [(entry.row, entry.column, entry.printed, entry.correct) for entry in record.entries]
                assert found == [(row, column, other, text)], record.message
                assert record.counterexample, (row, column, other)
                tried += 1
    assert tried > 15


@pytest.mark.parametrize("arm", RIGHT)
def test_two_wrong_rows_are_both_named(arm: str) -> None:
    table = right_table(arm)
    wrong = changed(changed(table, 1, 5, "0"), 2, 3, rf"{table.rows[1][2]} + {QUARTER}")
    assert places(judge(arm, wrong)) == {(1, 5), (2, 3)}


@pytest.mark.parametrize(
    ("arm", "row", "column", "text", "words"),
    [
        ("scara_modified", 3, 4, "d_2", "row 3: d is d_2, should be -d_2: the sign"),
        ("scara", 2, 2, "a_1", "row 2: a is a_1, should be a_2: the index"),
        ("scara", 2, 2, "a_3", "row 2: a is a_3, should be a_2: the index: the arm has no a_3"),
        ("scara", 3, 5, r"\theta_3", r"row 3: θ is \theta_3, should be 0: 'theta_3' is not bound"),
        ("scara_column", 1, 4, "0", "row 1: d is 0, should be d_1: it is missing"),
        ("rx90", 1, 2, "a_3", "row 1: a is a_3, should be 0: it should vanish"),
        ("rx90", 4, 4, "a_3", "row 4: d is a_3, should be d_3: a_3 for d_3"),
        ("rx90", 6, 3, QUARTER, rf"row 6: α is {QUARTER}, should be -{QUARTER}: the sign"),
        ("rx90", 6, 3, "-1.5708", rf"row 6: α is -1.5708, should be -{QUARTER}: a rounded number"),
        ("rx90", 2, 5, rf"\theta_2 - {QUARTER}", rf"row 2: θ is \theta_2 - {QUARTER}, should be \theta_2: the constant offset"),
        ("rx90", 2, 5, r"\theta_3", r"row 2: θ is \theta_3, should be \theta_2: the index"),
        ("scara_column", 4, 4, "d_4 + d_1", "row 4: d is d_4 + d_1, should be d_4: d_1 does not belong"),
    ],
)  # fmt: skip
def test_the_cause_is_told_in_words(arm: str, row: int, column: int, text: str, words: str) -> None:
    assert words in judge(arm, changed(right_table(arm), row, column, text)).message


def test_entries_that_stand_in_each_others_place_are_named() -> None:
    record = judge("scara_column", changed(changed(right_table("scara_column"), 1, 2, "d_1"), 1, 4, "a_1"))
    assert [entry.change for entry in record.entries] == ["a and d are swapped", "d and a are swapped"]


@pytest.mark.parametrize(("one", "other"), [(1, 2), (1, 3)])
@pytest.mark.parametrize("arm", ["rx90", "scara_column", "spatial_rrr"])
def test_swapped_headers_are_named(arm: str, one: int, other: int) -> None:
    header = list(right_table(arm).header)
    header[one], header[other] = header[other], header[one]
    record = judge(arm, with_header(right_table(arm), *header))
    assert record.verdict is Verdict.REFUTED
    assert "swapped: the headers" in record.message
    assert {(entry.equation, entry.printed) for entry in record.entries} == {(1, header[one]), (1, header[other])}


def test_rows_of_the_other_convention_under_a_header_are_named() -> None:
    record = judge("spherical_wrist", with_header(right_table("spherical_wrist"), *MODIFIED))
    assert record.verdict is Verdict.REFUTED
    assert record.message == "the rows hold in the classic convention, the headers say modified"
    assert [(e.row, e.printed, e.correct) for e in record.entries] == [
        (None, "a_{i-1}", "a_i"),
        (None, r"\alpha_{i-1}", r"\alpha_i"),
    ]
    assert record.counterexample
    other = judge("rx90", with_header(right_table("rx90"), *CLASSIC))
    assert other.message == "the rows hold in the modified convention, the headers say classic"


@pytest.mark.parametrize("arm", RIGHT)
def test_bare_and_contradictory_headers_leave_the_convention_to_the_rows(arm: str) -> None:
    convention = "modified" if RIGHT[arm][0] == MODIFIED else "classic"
    for header in (("i", "a", r"\alpha", "d", r"\theta"), ("i", "a_{i-1}", r"\alpha_i", "d_i", r"\theta_i")):
        record = judge(arm, with_header(right_table(arm), *header))
        assert record.verdict is Verdict.PROVED
        assert f"the {convention} one" in record.message or "both conventions" in record.message
        assert judge(arm, with_header(changed(right_table(arm), 1, 5, "0"), *header)).verdict is Verdict.REFUTED


def test_columns_shifted_by_a_row_are_named() -> None:
    rows = ["1 0 0 d_1 θ1", "2 a_1 0 0 θ2", r"3 a_2 \pi d_3 0", "4 0 0 d_4 θ4"]
    record = judge("scara_column", replace(right_table("scara_column"), rows=tuple(cells(row) for row in rows)))
    assert record.verdict is Verdict.REFUTED
    assert "one row too low, as in a table of the modified convention" in record.message


def test_other_frames_with_the_same_tool_pose_are_named_and_refuted() -> None:
    rows = ["1 a_1 0 0 θ1", r"2 a_2 \pi 0 θ2", "3 0 0 d_3+d_4 0", "4 0 0 0 θ4"]
    record = judge("scara", replace(right_table("scara"), rows=tuple(cells(row) for row in rows)))
    assert record.verdict is Verdict.REFUTED
    assert "the table gives {}^0T_4 of the arm, but by other frames from row 3 on" in record.message
    assert places(record) == {(3, 4), (4, 4)}
    both_wrong = judge("scara", changed(right_table("scara"), 4, 4, "0"))
    assert "other frames" not in both_wrong.message


@pytest.mark.parametrize(("turns", "slides"), [("0", "1"), ("R", "P"), ("revolute", "prismatic")])
def test_the_kind_of_each_joint_is_checked(turns: str, slides: str) -> None:
    table = right_table("scara_modified")
    kinds = (turns, turns, slides, turns)
    table = replace(
        table,
        header=(r"\sigma_i", *table.header),
        rows=tuple((kind, *row) for kind, row in zip(kinds, table.rows, strict=True)),
    )
    assert judge("scara_modified", table).verdict is Verdict.PROVED
    wrong = judge("scara_modified", changed(table, 3, 1, turns))
    assert told(wrong) == [(1, 3, 1, turns, slides)]
    assert "row 3: the joint is prismatic, not revolute" in wrong.message


def test_the_variable_of_each_joint_is_checked() -> None:
    table = right_table("scara")
    names = ("q_1", "q_2", "q_3", "q_4")
    table = replace(
        table,
        header=("Variable", *table.header),
        rows=tuple((name, *row) for name, row in zip(names, table.rows, strict=True)),
    )
    assert judge("scara", table).verdict is Verdict.PROVED
    assert told(judge("scara", changed(table, 3, 1, "q_2"))) == [(1, 3, 1, "q_2", "d_3")]
    for unknown in ("q_7", "x"):  # nothing is known of it
        assert judge("scara", changed(table, 3, 1, unknown)).verdict is Verdict.PROVED


@pytest.mark.parametrize(
    ("header", "quarter", "wrong", "correct"),
    [
        (r"\alpha_{i-1}", QUARTER, r"\pi", QUARTER),
        (r"\alpha_{i-1}", "90", "180", "90"),
        (r"\alpha_{i-1}", r"90^\circ", "0", r"90^\circ"),
        (r"\alpha_{i-1}", "90°", "0", "90°"),
        (r"\alpha_{i-1} (deg)", r"\frac{180}{2}", "20", "90"),
        (r"\alpha_{i-1} (rad)", QUARTER, "90", QUARTER),
        (r"\alpha_{i-1}", r"\frac{90\pi}{180}", "0", QUARTER),
        (r"\alpha_{i-1}", "90π/180", "0", r"\pi/2"),
    ],
)
def test_the_right_angle_is_written_as_its_column_is_and_told_in_its_cell(
    header: str, quarter: str, wrong: str, correct: str
) -> None:
    table = right_table("rx90")
    rows = tuple((row[0], row[1], row[2].replace(QUARTER, quarter), *row[3:]) for row in table.rows)
    table = replace(table, header=(*table.header[:2], header, *table.header[3:]), rows=rows)
    assert judge("rx90", table).verdict is Verdict.PROVED
    assert told(judge("rx90", changed(table, 2, 3, wrong))) == [(1, 2, 3, wrong, correct)]


def told(record: Record) -> list[tuple[Any, ...]]:
    """Return the entries that are wrong, each with the place that the findings tell."""
    places = [(finding.row, finding.column) for finding in record.findings if finding.row is not None]
    assert places == [(entry.row, entry.column) for entry in record.entries]
    return [(entry.equation, entry.row, entry.column, entry.printed, entry.correct) for entry in record.entries]


@pytest.mark.parametrize(
    ("row", "column", "text", "correct"),
    [
        (2, 5, r"\theta_2", rf"\theta_2 - {QUARTER}"),
        (2, 5, rf"\theta_2 + {QUARTER}", rf"\theta_2 - {QUARTER}"),
        (4, 3, "a_3", "-a_3"),
        (4, 4, "d_4", "d_4 + d_5"),
        (5, 2, f"-{QUARTER}", QUARTER),
    ],
)
def test_a_table_is_mended_where_the_arms_frames_are_no_dh_frames(
    row: int, column: int, text: str, correct: str
) -> None:
    record = judge("kr210", changed(right_table("kr210"), row, column, text))
    assert record.verdict is Verdict.REFUTED
    assert [(e.row, e.column, e.printed, e.correct) for e in record.entries] == [(row, column, text, correct)]


def test_a_right_table_of_an_arm_without_dh_frames_is_proved_by_what_moves_the_tool() -> None:
    record = judge("kr210", right_table("kr210"))
    assert record.verdict is Verdict.PROVED and record.findings[0].kind in (Kind.MOVES_WITH, Kind.MOVES_WITH_BUT_AT)


@pytest.mark.parametrize(
    ("along", "twist", "kind"),
    [
        ("a_{i-1}", r"\alpha_{i-1}", None),
        ("a_{i-1}", r"\alpha_i", Kind.HEADERS_CONTRADICT),
        ("a", r"\alpha", Kind.HEADERS_OPEN),
    ],
)
def test_headers_may_contradict_each_other(along: str, twist: str, kind: Kind | None) -> None:
    table = with_header(right_table("scara_modified"), "i", along, twist, "d_i", r"\theta_i")
    said = {finding.kind for finding in judge("scara_modified", table).findings}
    assert said & {Kind.HEADERS_CONTRADICT, Kind.HEADERS_OPEN} == ({kind} if kind else set())


def test_two_errors_beyond_the_arms_frames_are_not_called_proved() -> None:
    table = changed(changed(right_table("kr210"), 4, 3, "a_3"), 2, 5, r"\theta_2")
    assert judge("kr210", table).verdict is Verdict.UNCHECKED


def test_wrong_entries_of_an_array_have_their_place_in_the_latex() -> None:
    display = Display(3, as_array(changed(right_table("rx90"), 4, 4, "-d_3")), erratum=True)
    record = check_array_table(checker("rx90").checker, display)
    assert record is not None and record.verdict is Verdict.REFUTED and record.passes
    (entry,) = record.entries
    assert entry.span is not None and display.latex[slice(*entry.span)] == "-d_3"
    headers = check_array_table(
        checker("rx90").checker, Display(3, as_array(with_header(right_table("rx90"), *CLASSIC)))
    )
    assert headers is not None
    assert [headers.latex[slice(*e.span)] for e in headers.entries if e.span] == ["a_i", r"\alpha_i"]


# -- tables that are open, or no DH tables -------------------------------------------------------------------------------


def test_a_letter_of_the_documents_own_is_to_be_bound() -> None:
    table = changed(changed(right_table("planar_2r"), 1, 2, "L_a"), 2, 2, "L_b")
    record = judge("planar_2r", table)
    assert record.verdict is Verdict.UNCHECKED
    assert "'L_a' is not bound; the entry holds if it means l_1: bind it under 'symbols'" in record.message
    assert judge("planar_2r", changed(table, 2, 2, "L_a")).verdict is Verdict.REFUTED
    front = {"arm": "planar_2r", "symbols": {"L_a": "l_1", "L_b": "l_2"}}
    found = check_document(Document(Path("page.md"), front, (), (table, changed(table, 1, 2, "-L_a"))))
    assert [record.verdict for record in found.tables] == [Verdict.PROVED, Verdict.REFUTED]
    assert found.tables[1].entries[0].correct == "L_a"


def test_without_an_arm_a_table_is_unchecked_and_one_of_names_is_defined() -> None:
    record = judge(None, right_table("scara"))
    assert record.verdict is Verdict.UNCHECKED and "no arm" in record.message
    general = Table(1, MODIFIED, (("i", "a_{i-1}", r"\alpha_{i-1}", "d_i", r"\theta_i"),))
    assert judge(None, general).verdict is Verdict.DEFINED
    assert judge("rx90", general).verdict is Verdict.DEFINED


@pytest.mark.parametrize(
    ("header", "row"),
    [
        (("joint", "parent", "child", "x", "y", "z"), ("joint_1", "base_link", "link_1", "0", "0", "d_1")),
        (("joint", "min", "max"), ("1", "-90", "90")),
        (("i", "a_i", "d_i"), ("1", "0", "0")),
        (("what", "reason"), (r"$\alpha$", r"$\theta$")),
        (("i", r"\theta_i min", r"\theta_i max"), ("1", "0", "1")),
    ],
)
def test_other_tables_are_no_claims(header: tuple[str, ...], row: tuple[str, ...]) -> None:
    assert check_table(checker("scara").checker, Table(1, header, (row,))) is None


@pytest.mark.parametrize(
    "latex",
    [
        r"\begin{bmatrix} a & \alpha \\ d & \theta_1 \end{bmatrix} = A",
        r"A = \begin{array}{cc} a & \alpha \\ d & \theta \end{array}",
        r"\begin{bmatrix} \cos\alpha & \sin\theta \\ 0 & 1 \end{bmatrix}",
        r"\begin{array}{cc} a & \alpha \\ 1",
    ],
)
def test_other_displays_are_no_tables(latex: str) -> None:
    assert check_array_table(checker("scara").checker, Display(1, latex)) is None


def test_the_place_of_a_cell_is_that_of_its_text_without_blanks_and_rules() -> None:
    """There a correction is written, and nothing else is touched."""
    latex = r"\begin{array}{c|c} i & \alpha_i  \\ \hline 1 & 0\quad \\ 2  &\pi \\ \hline \end{array}"
    array = read_array(Display(1, latex))
    assert array is not None
    cells = [[latex[begin:end] for begin, end in row] for row in array.spans]
    assert cells == [["i", r"\alpha_i"], ["1", r"0\quad"], ["2", r"\pi"]]


def test_an_entry_that_cannot_be_read_is_named() -> None:
    record = judge("scara", changed(right_table("scara"), 3, 4, r"\input{x}"))
    assert record.verdict is Verdict.UNREADABLE
    assert record.message.startswith("row 3, column 4:")
    long = judge("scara", replace(right_table("scara"), rows=(("1",) * 9,)))
    assert long.verdict is Verdict.UNREADABLE and "row 1 has 9 entries" in long.message


@pytest.mark.parametrize(
    "text", ["{" * 10_000, "1" * 100_000, "-" * 5_000, "__import__('os')", "1/0", r"\theta_1/2", "\\"]
)
def test_bad_entries_do_no_harm(text: str) -> None:
    for table in (changed(right_table("scara"), 1, 4, text), changed(right_table("scara"), 1, 5, text)):
        (record,) = document("scara", table).tables
        assert record.verdict in (Verdict.UNREADABLE, Verdict.UNCHECKED, Verdict.REFUTED)
    (head,) = document(
        "scara", right_table("scara"), displays=(Display(1, r"\begin{array}{c" + text + "& α"),)
    ).equations
    assert head.verdict is Verdict.UNREADABLE


def test_an_arm_given_by_a_table_is_checked_as_well() -> None:
    spec = {
        "dh": "classic",
        "rows": [
            {"a": "a_1", "alpha": "alpha_1", "d": 0, "theta": "theta_1 + pi/2"},
            {"a": 0.3, "alpha": "pi/5", "d": "d_2", "theta": "pi/4"},
        ],
        "joints": ["theta_1", "d_2"],
    }
    right = Table(
        1,
        CLASSIC,
        (("1", "a_1", r"\alpha_1", "0", rf"\theta_1 + {QUARTER}"), ("2", "0.3", r"36^\circ", "d_2", r"45^\circ")),
    )
    bare = with_header(right, "i", "a", r"\alpha", "d", r"\theta")
    wrong = [changed(right, 1, 3, r"-\alpha_1"), changed(right, 2, 3, r"54^\circ"), changed(right, 1, 5, r"\theta_1")]
    found = document(spec, right, bare, *wrong).tables
    assert [record.verdict for record in found] == [Verdict.PROVED] * 2 + [Verdict.REFUTED] * 3
    assert [record.entries[0].correct for record in found[2:]] == [
        r"\alpha_1",
        r"36^\circ",
        r"\theta_1 + 90^\circ",
    ]


def test_a_markdown_table_of_a_file_is_read_and_an_erratum_must_be_refuted(tmp_path: Path) -> None:
    lines = [" | ".join(f"${cell}$" for cell in row) for row in right_table("rx90").rows]
    head = " | ".join(f"${cell}$" for cell in MODIFIED)
    body = "\n".join(["| " + head + " |", "|---|---|---|---|---|", *(f"| {line} |" for line in lines)])
    wrong = "\n".join("> " + line for line in body.replace("$d_3$", "$-d_3$").splitlines())
    path = tmp_path / "page.md"
    path.write_text(f"---\narm: rx90\n---\n\n{body}\n\n> **Erratum** (as printed)\n>\n{wrong}\n", encoding="utf-8")
    found = verify(path)
    assert [(record.verdict, record.erratum) for record in found.tables] == [
        (Verdict.PROVED, False),
        (Verdict.REFUTED, True),
    ]
    assert found.passed


@pytest.mark.parametrize(("twist", "verdict"), [(r"\pi", Verdict.PROVED), ("0", Verdict.REFUTED)])
def test_a_table_may_begin_with_a_row_for_the_base(twist: str, verdict: Verdict) -> None:
    table = changed(right_table("scara"), 2, 3, twist)
    assert judge("scara", replace(table, rows=(("0", "0", "0", "0", "0"), *table.rows))).verdict is verdict
    moved = replace(table, rows=(("0", "a_1", "0", "0", "0"), *table.rows))
    assert judge("scara", moved).verdict is Verdict.REFUTED


def test_an_array_of_one_row_and_its_head_is_a_table() -> None:
    array = read_array(Display(1, r"\begin{array}{cc} i & \alpha_i \\ 1 & 0 \end{array}"))
    assert array is not None and [len(row) for row in array.spans] == [2, 2]
    assert read_array(Display(1, r"\begin{array}{cc} i & \alpha_i \end{array}")) is None


@pytest.mark.parametrize("arm", ["arm: planar_2r\n", ""], ids=["named", "inferred"])
@pytest.mark.parametrize(
    ("rows", "kind"),
    [
        ("", Kind.TABLE_WITHOUT_ROWS),
        ("|1|||||\n|2|||||\n", Kind.EMPTY_ROW),
        ("|1||||$\\theta_1$|\n|2|||||\n", Kind.EMPTY_ROW),
    ],
)
def test_a_table_that_is_left_to_be_filled_in_claims_nothing(arm: str, rows: str, kind: Kind) -> None:
    head = f"---\n{arm}---\n" if arm else ""
    (record,) = verify_text(
        f"{head}| i | $a_i$ | $\\alpha_i$ | $d_i$ | $\\theta_i$ |\n|---|---|---|---|---|\n{rows}"
    ).tables
    assert record.verdict == Verdict.UNCHECKED
    assert kind in {finding.kind for finding in record.findings} or not arm


def test_an_empty_entry_among_others_is_a_zero() -> None:
    rows = "|1|$l_1$|||$\\theta_1$|\n|2|||0|$\\theta_2$|\n"
    text = f"---\narm: planar_2r\n---\n| i | $a_i$ | $\\alpha_i$ | $d_i$ | $\\theta_i$ |\n|---|---|---|---|---|\n{rows}"
    assert verify_text(text).tables[0].verdict == Verdict.REFUTED
    assert verify_text(text.replace("|2||", "|2|$l_2$|")).tables[0].verdict == Verdict.PROVED


@pytest.mark.parametrize(("labels", "is_told"), [(("1", "2"), False), (("", ""), False), (("upper", "lower"), True)])
def test_it_is_told_where_labels_name_no_frames_and_rows_are_taken_in_order(
    labels: tuple[str, str], is_told: bool
) -> None:
    rows = "".join(f"| {label} | $l_{k}$ | 0 | 0 | $\\theta_{k}$ |\n" for k, label in enumerate(labels, start=1))
    head = "| link | $a_i$ | $\\alpha_i$ | $d_i$ | $\\theta_i$ |\n|---|---|---|---|---|\n"
    [right] = verify_text(f"---\narm: planar_2r\n---\n\n{head}{rows}").tables
    [wrong] = verify_text(f"---\narm: planar_2r\n---\n\n{head}{rows.replace('l_2', 'l_1')}").tables
    assert (right.verdict, wrong.verdict) == (Verdict.PROVED, Verdict.REFUTED)
    assert right.says(Kind.ROWS_IN_ORDER) is wrong.says(Kind.ROWS_IN_ORDER) is is_told
