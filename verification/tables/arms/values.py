"""The values that a DH table gives lengths: beside their letters, l_1 (450 mm), or alone, by which a_2 and d_3 are its entries."""

from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import suppress
from fractions import Fraction

from armproof.verification.document import Document, Table
from armproof.verification.errors import EvaluationError, ReadError
from armproof.verification.evaluation.exact import ExactAlgebra
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import is_number
from armproof.verification.naming.names import Names
from armproof.verification.naming.state import Stated
from armproof.verification.patterns import regex
from armproof.verification.tables.arms.inference import dh_tables, in_metres
from armproof.verification.tables.cells import Cell, read_cell
from armproof.verification.tables.columns import read_columns
from armproof.verification.tables.row import SCALES
from armproof.verification.verdict import TakenArm

_NUMBER = regex(r"-?\d+(?:\.\d+|/\d+)?")
_GIVEN = regex(  # L_2 = L_3 = 0.2142 m, and no more
    r"((?:[lLaAdDhHrR]_(?:\d|\{\d\})\s*=\s*)+)(\d+(?:\.\d+)?)(?:\s|\\[,;: ])*(?:\\(?:text|mathrm)\s*\{\s*(mm|cm|m)\s*\}|(mm|cm|m))?"
)


def stated_lengths(document: Document, names: Names, algebra: ExactAlgebra) -> dict[str, Stated]:
    """Return the lengths of an arm to which the document's DH tables give one value each."""
    found: dict[str, set[Fraction]] = {}
    for table in dh_tables(document) if names.arm is not None else ():
        for symbol, value in _values(table, names, algebra, in_metres(document, table)):
            found.setdefault(symbol, set()).add(value)
    one_each = {symbol: values.pop() for symbol, values in found.items() if len(values) == 1}
    return {symbol: Stated(n.Number(value, str(value)), float(value)) for symbol, value in one_each.items()}


def entries_by_place(
    document: Document, taken: TakenArm, names: Names, algebra: ExactAlgebra
) -> Iterator[tuple[str, Fraction]]:
    """Yield a_i and d_i (a_{i-1} in the modified convention) of rows where a table has numbers, but zeros: nobody names these.

    So do link matrices.
    """
    if taken.source == "matrices":
        yield from _entries_of_links(taken, names)
    table = next((each for each in dh_tables(document) if each.line == taken.line), None)
    columns = read_columns(table.header) if table is not None and taken.source == "table" else None
    if table is None or columns is None:
        return
    metres = in_metres(document, table)
    for number, texts in enumerate(table.rows, 1):
        for column, along in zip(columns.lengths[0], "xz", strict=True):
            with suppress(ReadError, EvaluationError):
                cell = read_cell(names, texts[column], number, column, metres)
                value = cell.values(names, algebra)[0].as_fraction() if len(cell.trees) == 1 else None
                index = number - (along == "x" and taken.convention == "modified")
                key = f"{columns.headers[column].role}_{index}"
                if value and index and is_number(cell.trees[0]) and names.known_symbol(key) is None:
                    scale = SCALES.get(columns.headers[column].unit, 1) if metres and not cell.has_unit else 1
                    yield key, value * Fraction(scale)


def letters_of_numbers(document: Document, taken: TakenArm, names: Names) -> Iterator[tuple[str, Fraction]]:
    """Yield letters to which the text gives one value each, that of a length for which the arm has a number alone: L_2 = 0.25."""
    rows = taken.front["arm"]["rows"]
    numbers = {abs(Fraction(row[role])) for row in rows for role in "ad" if _NUMBER.fullmatch(str(row[role]))} - {0}
    found: dict[str, set[Fraction]] = {}
    for display in document.displays if numbers else ():
        for text in (display.latex, *display.said, *display.said_behind):
            if given := _GIVEN.fullmatch(text.strip().rstrip(".,;")):
                value = Fraction(given[2]) * Fraction(SCALES.get(given[3] or given[4] or "m", 1)).limit_denominator(
                    1000
                )
                for letter, index in re.findall(r"([A-Za-z])_\{?(\d)", given[1]):
                    found.setdefault(f"{letter}_{index}", set()).add(value)
    for key, values in found.items():
        if len(values) == 1 and values <= numbers and names.known_symbol(key) is None:
            yield key, next(iter(values))


def _entries_of_links(taken: TakenArm, names: Names) -> Iterator[tuple[str, Fraction]]:
    for number, row in enumerate(taken.front["arm"]["rows"], 1):
        for role in "ad":
            key = f"{role}_{number - (role == 'a' and taken.convention == 'modified')}"
            with suppress(ValueError):  # a letter
                value = Fraction(str(row[role]))
                if value and not key.endswith("_0") and names.known_symbol(key) is None:
                    yield key, value


def _values(table: Table, names: Names, algebra: ExactAlgebra, metres: bool) -> Iterator[tuple[str, Fraction]]:
    columns = read_columns(table.header)
    used = sorted({column for pair in columns.lengths for column in pair}) if columns is not None else []
    for number, texts in enumerate(table.rows, 1):
        for column in used if len(texts) == len(table.header) else ():
            with suppress(ReadError, EvaluationError):
                cell = read_cell(names, texts[column], number, column, metres)
                scale = SCALES.get(columns.headers[column].unit, 1) if columns and metres and not cell.has_unit else 1
                yield from _value(cell, names, algebra, Fraction(scale))


def _value(cell: Cell, names: Names, algebra: ExactAlgebra, scale: Fraction) -> Iterator[tuple[str, Fraction]]:
    """Yield the length of a cell that is one letter, and its value."""
    letters = [tree for tree in cell.trees if isinstance(tree, n.Name)]
    numbers = [value for tree, value in zip(cell.trees, cell.values(names, algebra), strict=True) if is_number(tree)]
    symbol = names.known_symbol(letters[0].key) if len(letters) == len(numbers) == 1 == len(cell.trees) - 1 else None
    value = numbers[0].as_fraction() if numbers else None
    if symbol is not None and value is not None and names.arm is not None and symbol in names.arm.lengths:
        yield symbol, value * scale
