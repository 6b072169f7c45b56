"""What stands in the wrong place of a table is told as that; what is wrong in another way is not."""

import pytest

from armproof.course.feedback.misplaced import in_other_rows, misplaced

ORDER = ("alpha", "a", "d", "theta")
RIGHT = [["0", "0", "h", "1"], ["p", "a", "0", "2"], ["-p", "b", "0", "3"], ["0", "0", "c", "0"]]


def told(rows: list[list[str]], knows_places: bool = True) -> str:
    wrong = {(k, j) for k, row in enumerate(rows) for j, cell in enumerate(row) if cell != RIGHT[k][j]}
    return misplaced(rows, wrong if knows_places else (), ORDER, "0", negated, lambda other: other == RIGHT)


def negated(cell: str) -> str:
    return cell.removeprefix("-") if cell.startswith("-") else f"-{cell}"


@pytest.mark.parametrize(
    ("rows", "words"),
    [
        ([RIGHT[0], RIGHT[2], RIGHT[1], RIGHT[3]], "rows 2 and 3 are swapped"),
        ([[one, d, a, theta] for one, a, d, theta in RIGHT], "a and d are exchanged in all rows"),
        ([["p", "a", *RIGHT[0][2:]], ["-p", "b", *RIGHT[1][2:]], ["0", "0", *RIGHT[2][2:]], RIGHT[3]], "one row too early"),
        ([RIGHT[0], ["p", "b", "0", "2"], ["-p", "a", "0", "3"], RIGHT[3]], "a of row 2 and a of row 3 are exchanged"),
        ([RIGHT[0], ["p", "0", "a", "2"], *RIGHT[2:]], "row 2: a and d are exchanged"),
    ],
)  # fmt: skip
def test_what_is_exchanged_is_told(rows: list[list[str]], words: str) -> None:
    assert words in told(rows)


def test_columns_are_told_where_no_entry_is() -> None:
    assert (
        told([[one, d, a, theta] for one, a, d, theta in RIGHT], knows_places=False)
        == "a and d are exchanged in all rows"
    )


@pytest.mark.parametrize(
    "rows",
    [
        [RIGHT[0], RIGHT[2], ["p", "b", "0", "2"], RIGHT[3]],
        [RIGHT[0], ["-p", "a", "0", "2"], ["p", "a", "0", "3"], RIGHT[3]],
        [RIGHT[0], ["-p", "a", "0", "2"], ["p", "b", "0", "3"], RIGHT[3]],
        [RIGHT[0], ["p", "c", "0", "2"], *RIGHT[2:]],
    ],
)
def test_of_anything_else_no_exchange_is_told(rows: list[list[str]]) -> None:
    assert told(rows) == ""


def test_entries_in_other_rows_are_told_as_right_ones() -> None:
    assert "the entries of d are right" in in_other_rows(["c", "h", "0"], ["h", "0", "c"], "d")
    assert in_other_rows(["c", "h", "0"], ["h", "0", "b"], "d") == in_other_rows(["c"], ["c"], "d") == ""
    assert in_other_rows(["-p", "p"], ["p", "-p"], "alpha") == ""
