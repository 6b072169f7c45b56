"""Tables of joint origins: right ones are proved, and every change of one cell is refuted at that cell."""

from __future__ import annotations

from dataclasses import replace
from functools import lru_cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from armproof.models.arm import Arm
from armproof.models.catalogue import arm_names, load_arm
from armproof.models.loading.origins import joint_origins
from armproof.models.numeric.drake_arm import plant_of
from armproof.verification.check import DocumentChecker, check_document, verify
from armproof.verification.document import Document, Table
from armproof.verification.tables import check_table
from armproof.verification.tables.origins import _is_axis
from armproof.verification.verdict import Record, Verdict

HEADER = ("Joint Name", "Parent Link", "Child Link", "x(m)", "y(m)", "z(m)", "roll", "pitch", "yaw")
# document 001, the table at its head
KR210 = """
joint_1 base_link link_1 0 0 0.33 0 0 0
joint_2 link_1 link_2 0.35 0 0.42 0 0 0
joint_3 link_2 link_3 0 0 1.25 0 0 0
joint_4 link_3 link_4 0.96 0 -0.054 0 0 0
joint_5 link_4 link_5 0.54 0 0 0 0 0
joint_6 link_5 link_6 0.193 0 0 0 0 0
gripper-joint link_6 gripper_link 0.11 0 0 0 0 0
"""
# the links of the Stäubli RX-90, whose joints are turned against each other
RX90 = r"""
theta_1 base link_1 0 0 0 0 0 0
theta_2 link_1 link_2 0 0 0 \pi/2 0 0
theta_3 link_2 link_3 a_3 0 0 0 0 0
theta_4 link_3 link_4 0 d_3 0 -\pi/2 0 0
theta_5 link_4 link_5 0 0 0 \pi/2 0 0
theta_6 link_5 link_6 0 0 0 -\pi/2 0 0
"""
TABLES = {
    name: Table(1, HEADER, tuple(tuple(line.split()) for line in text.strip().splitlines()))
    for name, text in (("kr210", KR210), ("rx90", RX90))
}
TILTED = """<robot name="tilted">
  <link name="base"/><link name="arm"/><link name="hand"/>
  <joint name="lift" type="prismatic"><parent link="base"/><child link="arm"/>
    <origin xyz="0.1 -0.2 0.3" rpy="0.5235987755982988 1.5707963267948966 0"/><axis xyz="0 0 -1"/><limit lower="0" upper="1" effort="1" velocity="1"/></joint>
  <joint name="turn" type="revolute"><parent link="arm"/><child link="hand"/>
    <origin xyz="0 0 0.5" rpy="0.4 0.6283185307179586 -0.7853981633974483"/><axis xyz="0 0.6 0.8"/>
    <limit lower="-1" upper="1" effort="1" velocity="1"/></joint>
</robot>"""


@lru_cache(maxsize=8)
def checker(arm: str | None) -> DocumentChecker:
    front = {} if arm is None else {"arm": arm}
    return DocumentChecker(Document(Path("page.md"), front, (), ()), None if arm is None else load_arm(arm))


def find(arm: str | None, table: Table) -> Record | None:
    return check_table(checker(arm).checker, table)


def judge(arm: str, table: Table) -> Record:
    record = find(arm, table)
    assert record is not None
    return record


def changed(table: Table, row: int, column: int, text: str) -> Table:
    """The table with another text at a place of its body, counted from 1."""
    rows = [list(cells) for cells in table.rows]
    rows[row - 1][column - 1] = text
    return replace(table, rows=tuple(map(tuple, rows)))


def without(table: Table, *columns: int) -> Table:
    kept = [k for k in range(len(table.header)) if k + 1 not in columns]
    return replace(
        table, header=tuple(table.header[k] for k in kept), rows=tuple(tuple(r[k] for k in kept) for r in table.rows)
    )


def beside(table: Table, header: str, *cells: str) -> Table:
    rows = tuple((*row, cell) for row, cell in zip(table.rows, cells, strict=True))
    return replace(table, header=(*table.header, header), rows=rows)


def entries(record: Record) -> list[tuple[Any, ...]]:
    return [(entry.row, entry.column, entry.printed, entry.correct) for entry in record.entries]


def table_of(arm: Arm) -> Table:
    """The table that the lengths of the arm and the poses of its double plant call for."""
    rows = []
    for name, origin in joint_origins(arm).items():
        X_PF = plant_of(arm).GetJointByName(name).frame_on_parent().GetFixedPoseInBodyFrame()
        rpy = X_PF.rotation().ToRollPitchYaw().vector() / np.pi
        rows.append(
            (name, origin.parent, origin.child, *(f"{x:g}" for x in X_PF.translation()), *(rf"{a:g}\pi" for a in rpy))
        )
    return Table(1, HEADER, tuple(rows))


# -- right tables ----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("arm", TABLES)
def test_right_tables_are_proved(arm: str) -> None:
    record = judge(arm, TABLES[arm])
    assert record.verdict is Verdict.PROVED, record.message
    assert record.message == f"the origins of {len(TABLES[arm].rows)} joints of the model"


@pytest.mark.parametrize("name", arm_names())
def test_the_numbers_of_every_arm_are_proved_and_one_more_is_refuted(name: str) -> None:
    table = table_of(load_arm(name))
    assert judge(name, table).verdict is Verdict.PROVED, judge(name, table).message
    for row in range(1, len(table.rows) + 1):
        for column in range(4, 10):
            printed = table.rows[row - 1][column - 1]
            wrong = judge(name, changed(table, row, column, f"{printed} + 0.01"))
            assert wrong.verdict is Verdict.REFUTED
            assert {(entry.row, entry.column) for entry in wrong.entries} == {(row, column)}


@pytest.mark.parametrize(
    ("header", "scale"), [("x (m)", 1), ("x [mm]", 1000), ("$x$ (cm)", 100), ("x", 1), ("x, mm", 1000)]
)
def test_numbers_are_in_the_unit_of_the_header(header: str, scale: int) -> None:
    table = replace(TABLES["kr210"], header=(*HEADER[:3], header, *HEADER[4:]))
    for row, cells in enumerate(table.rows, 1):
        table = changed(table, row, 4, f"{float(cells[3]) * scale:g}")
    assert judge("kr210", table).verdict is Verdict.PROVED
    (entry,) = judge("kr210", changed(table, 2, 4, "7")).entries
    assert entry.correct == f"{0.35 * scale:g}"


def test_symbols_and_numbers_may_stand_side_by_side() -> None:
    table = changed(changed(TABLES["kr210"], 2, 4, "a_1 = 0.35"), 4, 6, "-a_3$ = −0.054")
    assert judge("kr210", table).verdict is Verdict.PROVED
    assert entries(judge("kr210", changed(table, 2, 4, "d_2 = 0.35"))) == [(2, 4, "d_2 = 0.35", "a_1 = 0.35")]
    assert entries(judge("kr210", changed(table, 2, 4, "a_1 = 0.36"))) == [(2, 4, "a_1 = 0.36", "a_1 = 0.35")]


@pytest.mark.parametrize(("quarter", "header"), [("90", "roll (deg)"), ("90", "roll"), (r"90^\circ", "roll"), (r"\frac{\pi}{2}", "roll (rad)")])  # fmt: skip
def test_angles_may_be_in_degrees_or_radians(quarter: str, header: str) -> None:
    table = replace(TABLES["rx90"], header=(*HEADER[:6], header, *HEADER[7:]))
    for row in (2, 4, 5, 6):
        table = changed(table, row, 7, quarter if row in (2, 5) else f"-{quarter}")
    assert judge("rx90", table).verdict is Verdict.PROVED
    assert entries(judge("rx90", changed(table, 4, 7, quarter)))[0][:3] == (4, 7, quarter)


def test_names_may_be_spelt_with_blanks_hyphens_and_capitals() -> None:
    rows = tuple(
        (f"`{row[0].replace('_', ' ').title()}`", row[1].replace("_", r"\_"), *row[2:]) for row in TABLES["kr210"].rows
    )
    assert judge("kr210", replace(TABLES["kr210"], rows=rows)).verdict is Verdict.PROVED


@pytest.mark.parametrize("columns", [(2, 3), (7, 8, 9), (2, 3, 7, 8, 9)])
def test_links_and_angles_may_be_left_out(columns: tuple[int, ...]) -> None:
    table = without(TABLES["kr210"], *columns)
    assert judge("kr210", table).verdict is Verdict.PROVED
    assert judge("kr210", changed(table, 1, table.header.index("z(m)") + 1, "0.34")).verdict is Verdict.REFUTED


def test_a_table_for_some_of_the_joints_says_for_which_not() -> None:
    record = judge("kr210", replace(TABLES["kr210"], rows=TABLES["kr210"].rows[:5]))
    assert record.verdict is Verdict.PROVED
    assert "no row for joint_6, gripper-joint" in record.message


def test_types_and_axes_are_checked() -> None:
    kinds = beside(TABLES["kr210"], "Type", *["revolute"] * 5, "R", "fixed")
    table = beside(kinds, "axis", "z", "y", "$y$", "1 0 0", "[0, 1, 0]", "+x", "-")
    assert judge("kr210", table).verdict is Verdict.PROVED
    assert entries(judge("kr210", changed(table, 3, 10, "prismatic"))) == [(3, 10, "prismatic", "revolute")]
    assert entries(judge("kr210", changed(table, 3, 11, "-y"))) == [(3, 11, "-y", "0 1 0")]
    assert entries(judge("kr210", changed(table, 5, 11, "z"))) == [(5, 11, "z", "0 1 0")]
    garbled = judge("kr210", changed(table, 5, 11, "up"))
    assert garbled.verdict is Verdict.UNCHECKED and "row 5: axis: 'up' is no axis" in garbled.message


def test_other_angles_of_the_same_rotation_are_right(tmp_path: Path) -> None:
    (tmp_path / "tilted.urdf").write_text(TILTED, encoding="utf-8")
    rows = (
        ("lift", "base", "arm", "0.1", "-0.2", "0.3", "0", r"\pi/2", r"-\pi/6"),
        ("turn", "arm", "hand", "0", "0", "0.5", r"0.4 + \pi", r"\pi - \pi/5", r"\pi - \pi/4"),
    )
    table = Table(1, HEADER, rows)
    wrong = (changed(table, 1, 9, r"\pi/6"), changed(table, 2, 8, r"\pi/5"), changed(table, 2, 6, "0.4"))
    front = {"arm": str(tmp_path / "tilted.urdf")}
    found = check_document(Document(tmp_path / "page.md", front, (), (table, *wrong))).tables
    assert [record.verdict for record in found] == [Verdict.PROVED] + [Verdict.REFUTED] * 3
    assert found[3].entries[0].correct == "0.5"


# -- wrong tables ----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("arm", TABLES)
def test_every_change_of_one_cell_is_refuted_at_that_cell_and_undone(arm: str) -> None:
    table = TABLES[arm]
    for row, texts in enumerate(table.rows, 1):
        for column, text in enumerate(texts, 1):
            others = (
                ["link_7"]
                if column < 4
                else ["1", *([] if text == "0" else ["0", text.removeprefix("-") if "-" in text else f"-{text}"])]
            )
            for other in others:
                record = judge(arm, changed(table, row, column, other))
                assert record.verdict is Verdict.REFUTED, (row, column, other)
                assert entries(record) == [(row, column, other, text)], record.message


@pytest.mark.parametrize(
    ("arm", "row", "column", "text", "words"),
    [
        ("kr210", 4, 6, "0.054", "row 4: 0.054 should be -0.054: the sign"),
        ("kr210", 2, 4, "", "row 2: empty should be 0.35: it is missing"),
        ("kr210", 2, 5, "0.42", "row 2: 0.42 should be 0: it should vanish"),
        ("kr210", 2, 4, "d_1", "row 2: d_1 should be a_1: d_1 for a_1"),
        ("kr210", 5, 2, "link_3", "row 5: link_3 should be link_4: the parent link"),
        ("rx90", 2, 7, "1.5708", r"row 2: 1.5708 should be \pi/2: a rounded number"),
        ("rx90", 4, 7, r"\pi/2", r"row 4: \pi/2 should be -\pi/2: the sign"),
    ],
)
def test_the_cause_is_told_in_words(arm: str, row: int, column: int, text: str, words: str) -> None:
    assert words in judge(arm, changed(TABLES[arm], row, column, text)).message


def test_a_joint_that_the_arm_does_not_have_is_named_by_its_child_link_or_left_open() -> None:
    wrong = changed(TABLES["kr210"], 7, 1, "joint_7")
    assert entries(judge("kr210", wrong)) == [(7, 1, "joint_7", "gripper-joint")]
    record = judge("kr210", without(wrong, 2, 3))
    assert record.verdict is Verdict.UNCHECKED
    assert "row 7: no joint 'joint_7' in the model; its joints are joint_1, joint_2" in record.message


def test_a_cell_that_is_not_bound_or_not_readable_is_no_proof() -> None:
    unbound = judge("kr210", changed(TABLES["kr210"], 2, 4, "L_5"))
    assert unbound.verdict is Verdict.UNCHECKED and "row 2: x: 'L_5' is not bound" in unbound.message
    unreadable = judge("kr210", changed(TABLES["kr210"], 2, 4, r"\input{x}"))
    assert unreadable.verdict is Verdict.UNREADABLE and unreadable.message.startswith("row 2, column 4:")


@pytest.mark.parametrize("text", ["{" * 10_000, "1" * 100_000, "__import__('os')", "1/0", r"\theta_1/2", "*", "\\"])
def test_bad_cells_do_no_harm(text: str) -> None:
    tables = tuple(changed(TABLES["kr210"], 2, column, text) for column in range(1, 10))
    for record in check_document(Document(Path("page.md"), {"arm": "kr210"}, (), tables)).tables:
        assert record.verdict in (Verdict.UNREADABLE, Verdict.UNCHECKED, Verdict.REFUTED)


# -- other tables ----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("header", "rows"),
    [
        (("point", "x", "y", "z"), [("joint_1", "0", "0", "1")]),  # points, by their header
        (("name", "x", "y", "z"), [("A", "0", "0", "1"), ("B", "1", "2", "3")]),  # points, by their names
        (("joint", "x", "y", "z"), [("shoulder", "0", "0", "1"), ("joint_2", "1", "2", "3")]),  # another arm's joints
        (("joint", "x", "y"), [("joint_1", "0", "0")]),
        (("joint", "mass", "x", "y", "z"), [("joint_1", "12", "0", "0", "0.1")]),  # centres of mass
        (("joint", "min", "max"), [("joint_1", "-185", "185")]),
        (HEADER, []),
    ],
)
def test_other_tables_are_no_claims(header: tuple[str, ...], rows: list[tuple[str, ...]]) -> None:
    assert find("kr210", Table(1, header, tuple(rows))) is None


def test_without_an_arm_there_is_no_claim() -> None:
    assert find(None, TABLES["kr210"]) is None


def test_a_markdown_table_of_a_file_is_read_and_an_erratum_must_be_refuted(tmp_path: Path) -> None:
    lines = ["| " + " | ".join(row) + " |" for row in (HEADER, ["---"] * len(HEADER), *TABLES["kr210"].rows)]
    wrong = "\n".join("> " + line for line in lines).replace("0.054", "0.54")
    body = "\n".join(lines)
    path = tmp_path / "page.md"
    path.write_text(f"---\narm: kr210\n---\n\n{body}\n\n> **Erratum** (as printed)\n>\n{wrong}\n", encoding="utf-8")
    found = verify(path)
    assert [record.verdict for record in found.tables] == [Verdict.PROVED, Verdict.REFUTED]
    assert entries(found.tables[1]) == [(4, 6, "-0.54", "-0.054")]
    assert found.passed


def test_an_axis_is_printed_to_nine_digits() -> None:
    assert _is_axis((0.6, 0.0, 0.8), (0.6, 0.0, 0.8 + 1e-10)) and not _is_axis((0.6, 0.0, 0.8), (0.6, 0.0, 0.8 + 1e-8))
