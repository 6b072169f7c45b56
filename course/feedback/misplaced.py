"""What stands in the wrong place of a table: two rows, columns or entries exchanged, a column a row too early or too late."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Sequence
from typing import TypeVar

from armproof.models.errors import written
from armproof.models.language import look_up, noted

Cell = TypeVar("Cell")
Rows = Sequence[Sequence[Cell]]
Place = tuple[int, int]

_EARLY = noted("{names} stands one row too early: every entry of the column belongs in the row below")
_LATE = noted("{names} stands one row too late: every entry of the column belongs in the row above")
_KINDS = (("a", "d"), ("alpha", "theta"))  # of which either may be taken for the other
_COLUMNS = (("a",), ("alpha",), ("a", "alpha"), ("d",), ("theta",))  # that are shifted alone or together


def misplaced(
    rows: Rows[Cell],
    wrong: Collection[Place],
    order: Sequence[str],
    zero: Cell,
    negated: Callable[[Cell], Cell | None],
    is_right: Callable[[Rows[Cell]], bool],
) -> str:
    """Say what stands in the wrong place; empty where no exchange makes all right, or other signs do as well.

    Args:
        wrong: the entries that are wrong, by row and column from 0.
        order: the names of the columns.
        zero: what stands in an empty place.
    """
    cells = [rows[k][j] for k, j in wrong]
    if len(cells) == 2 and negated(cells[0]) == cells[1]:
        return ""
    given = [[*row] for row in rows]
    tried = (each for each in _exchanges(rows, {*wrong}, order, zero) if each[1] != given)
    return next((words for words, changed in tried if is_right(changed)), "")


def _exchanges(
    rows: Rows[Cell], wrong: set[Place], order: Sequence[str], zero: Cell
) -> Iterator[tuple[str, list[list[Cell]]]]:
    lines, columns = sorted({row for row, _ in wrong}), sorted({column for _, column in wrong})
    if len(lines) == 2 and len(columns) > 1:
        one, other = lines
        words = written("rows {one} and {other} are swapped", one=one + 1, other=other + 1)
        yield words, _with(rows, {(k, j): (one + other - k, j) for k in lines for j in range(len(order))})
    yield from _of_kinds(rows, columns, order, zero)
    for names in _COLUMNS if len(wrong) > 1 else ():
        if {order[column] for column in columns} == {*names}:
            for later, words in ((1, _EARLY), (-1, _LATE)):
                yield written(look_up(words), names=list(names)), _shifted(rows, columns, later, zero)
    if len(wrong) == 2:
        yield _of_two(rows, sorted(wrong), order)


def _of_kinds(
    rows: Rows[Cell], columns: Sequence[int], order: Sequence[str], zero: Cell
) -> Iterator[tuple[str, list[list[Cell]]]]:
    """Yield two columns of lengths, or of angles, exchanged in all rows."""
    for one, other in _KINDS:
        i, j = order.index(one), order.index(other)
        filled = [k for k, row in enumerate(rows) if row[i] != zero or row[j] != zero]
        if len(filled) > 1 and (not columns or {*columns} == {i, j}):
            moved = {(k, here): (k, there) for k in filled for here, there in ((i, j), (j, i))}
            yield written("{one} and {other} are exchanged in all rows", one=one, other=other), _with(rows, moved)


def _of_two(rows: Rows[Cell], wrong: Sequence[Place], order: Sequence[str]) -> tuple[str, list[list[Cell]]]:
    """Return two entries exchanged, of one row or of two."""
    changed = _with(rows, {wrong[0]: wrong[1], wrong[1]: wrong[0]})
    (k, i), (_, j) = wrong
    if wrong[0][0] == wrong[1][0]:
        return written("row {row}: {one} and {other} are exchanged", row=k + 1, one=order[i], other=order[j]), changed
    one, other = (written("{name} of row {row}", name=order[column], row=row + 1) for row, column in wrong)
    return written("{one} and {other} are exchanged", one=one, other=other), changed


def _with(rows: Rows[Cell], moved: dict[Place, Place]) -> list[list[Cell]]:
    """Return rows in which some places hold what stood in others."""
    places = [[moved.get((k, j), (k, j)) for j in range(len(row))] for k, row in enumerate(rows)]
    return [[rows[k][j] for k, j in line] for line in places]


def _shifted(rows: Rows[Cell], columns: Sequence[int], later: int, zero: Cell) -> list[list[Cell]]:
    """Return rows whose cells in some columns are moved to the next row, or to the one before."""
    changed = [[*row] for row in rows]
    for k, row in enumerate(changed):
        for column in columns:
            row[column] = rows[k - later][column] if 0 <= k - later < len(rows) else zero
    return changed


def in_other_rows(given: Sequence[Cell], right: Sequence[Cell], name: str) -> str:
    """Say that the wrong entries of a column are those that belong in it, in other rows; empty where they are not, or signs explain it."""
    mine, theirs = ([str(cell) for cell in cells] for cells in (given, right))
    is_of_signs = [cell.replace("-", "") for cell in mine] == [cell.replace("-", "") for cell in theirs]
    if len(mine) < 2 or is_of_signs or sorted(mine) != sorted(theirs):
        return ""
    return written("the entries of {name} are right, the rows in which they stand are not", name=name)
