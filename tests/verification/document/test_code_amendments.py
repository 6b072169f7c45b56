"""Which statements change a DH table in code, which of them are carried out, and which change none."""

from __future__ import annotations

import pytest

from armproof.verification.document.code_tables import amended_in_code, code_tables
from armproof.verification.document.model import CODE, Display

TABLE = "# alpha a d theta\ndh = [[0, l1, 0, th1],\n      [0, l2, 0, th2]]\n"
AMENDING = [
    "dh = [[al, 2*a, d, th] for al, a, d, th in dh]",
    "dh[0][1], dh[1][1] = dh[1][1], dh[0][1]",
    "for row in dh:\n    row[1] = 2 * row[1]",
    "for i in range(2):\n    dh[i][3] += pi/2",
    "table.loc[2, 'a'] = 0",
    "dh.remove(dh[0])",
    "del dh[0]",
    "L1 = RevoluteDH(a=l1)\nL1.offset = pi/2",
]
HARMLESS = [
    "for row in dh:\n    print(row)",
    "dh = np.array(dh)",
    "q[1] += pi/2",
    "T[0, 3] = 5",
    "masses = [[1, 2], [3, 4]]\nmasses[0][1] = 7",
    "def fk(dh, q):\n    dh[0][3] += pi/2\n    return dh",
    "for i in range(2):\n    dh[i][3] = q[i]",
    "rows = []\nrows.append(5)",
]


def _amended(code: str) -> list[str]:
    return [*amended_in_code([Display(1, code, opening=CODE)])]


@pytest.mark.parametrize("statement", AMENDING)
def test_what_is_not_carried_out_is_told(statement: str) -> None:
    assert _amended(TABLE + statement)


@pytest.mark.parametrize("statement", HARMLESS)
def test_what_changes_no_table_is_not_told(statement: str) -> None:
    assert _amended(TABLE + statement) == []


@pytest.mark.parametrize(
    ("statement", "last"),
    [
        ("dh[1][3] += pi/2", r"\theta_{2} + \frac{\pi}{2}"),
        ("dh[1, 3] -= pi/2", r"\theta_{2}-\frac{\pi}{2}"),
        ("dh = dh[::-1]", r"\theta_{1}"),
        ("dh.append([0, l3, 0, th3])", r"\theta_{3}"),
        ("dh[-1][3] = th2", r"\theta_{2}"),
    ],
)
def test_what_is_plain_is_carried_out(statement: str, last: str) -> None:
    (table,) = code_tables([Display(1, TABLE + statement, opening=CODE)])
    assert table.rows[-1][-1].replace(" - ", "-") == last
    assert _amended(TABLE + statement) == []


def test_a_table_of_an_earlier_cell_is_amended() -> None:
    pieces = [Display(1, TABLE, cell=0, opening=CODE), Display(1, "dh[1][3] += pi/2", cell=2, opening=CODE)]
    assert [*amended_in_code(pieces)] == ["dh[1][3] += pi / 2"]


@pytest.mark.parametrize("statement", ["DH(2,4) = th2 + pi/2;", "DH = flipud(DH);", "L(2).offset = pi/2;"])
def test_matlab_changes_a_table_too(statement: str) -> None:
    assert _amended(f"% alpha a d theta\nDH = [0 l1 0 th1\n      0 l2 0 th2];\n{statement}\n")


def test_rows_of_matlab_that_make_a_table_change_none() -> None:
    assert _amended("% alpha a d theta\nDH(1,:) = [0 l1 0 th1];\nDH(2,:) = [0 l2 0 th2];\n") == []


LINKS = "robot = DHRobot([RevoluteDH(d=d1, alpha=pi/2), RevoluteDH(a=a2), RevoluteDH(a=a3)]"


@pytest.mark.parametrize(
    ("code", "tables"),
    [
        (f"{LINKS})", 1),
        (f"{LINKS})\nrobot.tool = SE3()", 1),
        (f"{LINKS}, name='tool holder')", 1),
        (f"{LINKS})\nrobot.tool = SE3(0.1, 0, 0)", 0),
        (f"{LINKS})\nrobot.base = SE3(0, 0, h)", 0),
        (f"{LINKS}, tool=SE3(0, 0, 0.2))", 0),
    ],
)
def test_code_with_a_base_or_a_tool_has_no_table_of_the_whole_arm(code: str, tables: int) -> None:
    assert len([*code_tables([Display(1, code, opening=CODE)])]) == tables
