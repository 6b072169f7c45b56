"""The rows of a DH table as those of an arm: which entry of each is the joint's variable, and what the others are."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from armproof.verification.algebra.ring import Ring, Scalar
from armproof.verification.document import Table
from armproof.verification.errors import EvaluationError, ReadError
from armproof.verification.evaluation.exact import ExactAlgebra
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import is_number
from armproof.verification.naming.names import Names
from armproof.verification.patterns import regex
from armproof.verification.tables.angles import letter_of, symbols_of, to_radians, with_parts_of_pi
from armproof.verification.tables.arms.candidate import Candidate, entry_text, renamed, symbol_of
from armproof.verification.tables.arms.frame_names import end_effectors, frame_names, is_tool
from armproof.verification.tables.arms.unread_columns import unread_column
from armproof.verification.tables.cells import Cell, nothing_stands_in, read_cell, read_kind
from armproof.verification.tables.columns import CONVENTIONS, Columns, Reading, plain
from armproof.verification.tables.row import ANGLES, PARAMETERS, SCALES

_MARK = regex(r"\*|\\ast|\\star|\bvar", re.IGNORECASE)  # of a variable
_OF_ANY_ROW = regex(r"(?<![A-Za-z])(q|(?:var)?theta|θ|ϑ)(?:_?\{?i\}?)?(?!\s*(?:\}\s*_|[A-Za-z_0-9₀-₉^<{(*\[']))")
_GENERAL = frozenset("ijkn")
_FIXED = regex(r"\(?(?:fixed|fixe|fest|fixiert|fij[oa]|fiss[oa]|fix[oa]|固定)\)?", re.IGNORECASE)
_SLIDES = frozenset("dqrs")  # letters of a joint that slides; l, h and their like are lengths


@dataclass(frozen=True)
class _Row:
    """A row: its place from 1, its cells by column, what its cells of words say."""

    number: int
    cells: Mapping[int, Cell]
    kind: str
    variable: str
    label: str


def candidates(table: Table, columns: Columns, names: Names, in_metres: bool = True) -> Iterator[Candidate]:
    """Yield the arms that a table can mean, one a choice of its columns; raises ReadError, EvaluationError.

    Lengths with a unit are taken in metres, or as they stand.
    """
    if amending := unread_column(table, columns):
        raise EvaluationError(say(Kind.COLUMN_UNREAD, header=amending))
    if not in_metres:
        columns = replace(columns, headers=tuple(replace(each, unit=_of_angle(each.unit)) for each in columns.headers))
    rows = [_read_row(names, table, columns, number, in_metres) for number in range(1, len(table.rows) + 1)]
    for row in rows:
        if nothing_stands_in(row.cells.values()):
            raise EvaluationError(say(Kind.EMPTY_ROW, number=row.number))
    rows = _with_fixed_tool(rows, columns.theta)
    labels = [row.label for row in rows]
    letters = [node for row in rows for cell in row.cells.values() for node in _names_in(cell) if node.key != "pi"]
    keys = {node.key for node in letters}
    if _is_general(keys):
        raise EvaluationError(say(Kind.GENERAL_LINK))
    bound = replace(names, symbols={**names.symbols, **{key: key for key in keys}})
    for reading in columns.readings(("",)):
        made = [_entries(bound, columns, reading, row) for row in rows]
        ends = end_effectors(labels, [joint for _, joint in made])
        made = made[: ends[0] + 1] if ends is not None else made
        joints = tuple(symbol_of(joint) if joint else "" for _, joint in made)
        entries = tuple(row for row, _ in made)
        in_line = all(row["a"] == row["alpha"] == "0" for row in entries)  # one arm in both conventions
        conventions = CONVENTIONS[:1] if in_line else CONVENTIONS
        found = Candidate(
            "table", table.line, table.cell, entries, joints, renamed(letters), conventions,
            stated="" if in_line else columns.stated, several_tools=bool(ends),
        )  # fmt: skip
        if not any(joints):
            raise EvaluationError(say(Kind.ROW_WITHOUT_JOINT, number=1))
        yield from (replace(found, frames=frames) for frames in _frames(labels, joints, ends))


def _with_fixed_tool(rows: list[_Row], theta: int) -> list[_Row]:
    """Return the rows, the last one without a joint where it alone gives its angle a number: θ_7 = 0."""
    *others, last = [False, *(_is_given(row.cells[theta]) for row in rows)]
    return [*rows[:-1], replace(rows[-1], kind="fixed")] if last and len(rows) > 1 and not any(others) else rows


def _is_given(cell: Cell) -> bool:
    """Whether a cell says that its letter is a number: θ_7 = 0."""
    return "=" in cell.text and len(cell.trees) == 2 and isinstance(cell.trees[0], n.Name) and is_number(cell.trees[1])


def _frames(labels: Sequence[str], joints: Sequence[str], ends: tuple[int, str] | None) -> Iterator[tuple[str, ...]]:
    """Yield the names that the frames may have; none where each row has its joint and leads to the frame of its number."""
    fixed = [not joint for joint in joints]
    if ends is not None:
        yield from ((*frames, ends[1]) for frames in frame_names(labels[: ends[0]], fixed[: ends[0]]))
    else:
        yield from frame_names(labels, fixed) if any(fixed) else [()]


def _of_angle(unit: str) -> str:
    return "" if unit in SCALES else unit


def _read_row(names: Names, table: Table, columns: Columns, number: int, in_metres: bool) -> _Row:
    texts = table.rows[number - 1]
    if len(texts) != len(table.header):
        raise ReadError(say(Kind.ROW_LENGTH, number=number, count=len(texts), width=len(table.header)))
    added = () if columns.offset is None else (columns.offset,)
    used = sorted({columns.alpha, columns.theta, *added, *(k for pair in columns.lengths for k in pair)})
    label = columns.first("label")
    if len(table.rows) > 1:  # θ or q_i in a row is the variable of that row
        own = label_number if label is not None and (label_number := plain(texts[label])).isdigit() else str(number)
        cell = _OF_ANY_ROW.sub(lambda found: f"{found[1]}_{{{own}}}", texts[columns.theta])
        texts = (*texts[: columns.theta], cell, *texts[columns.theta + 1 :])
    kind, variable = columns.first("sigma"), columns.first("q")
    named = read_cell(names, texts[variable], number, variable).name if variable is not None else None
    cells = {column: read_cell(names, texts[column], number, column, in_metres) for column in used}
    turns = any(name.key != "pi" for name in _names_in(cells[columns.theta]))
    return _Row(
        number,
        cells,
        (read_kind(texts[kind]) if kind is not None else "") or ("" if turns else _fixed_beside(texts, {*used, label})),
        named.key if named is not None else "",
        texts[label] if label is not None else "",
    )


def _fixed_beside(texts: Sequence[str], read: Collection[int | None]) -> str:
    """Return the kind of a row that a column of another name calls fixed: "fixed" for a range, or a remark."""
    beside = (plain(text).strip() for column, text in enumerate(texts) if column not in read)
    return "fixed" if any(map(_FIXED.fullmatch, beside)) else ""


def _names_in(cell: Cell) -> Iterator[n.Name]:
    return (node for tree in cell.trees for node in n.names(tree))


def _is_general(keys: set[str]) -> bool:
    """Whether the letters are those of any link: a_i, α_i, d_i, θ_i."""
    indices = {key.partition("_")[2].partition("-")[0] for key in keys}
    return bool(indices) and indices <= _GENERAL


def _entries(names: Names, columns: Columns, reading: Reading, row: _Row) -> tuple[dict[str, str], str]:
    """Return the entries of a row as text, and its joint variable, "" where nothing moves; raises EvaluationError."""
    algebra = ExactAlgebra(Ring(), None)
    values = {
        parameter: _value(names, algebra, columns, reading.columns[parameter], parameter, row)
        for parameter in PARAMETERS
    }
    place, joint = _joint_of(reading, row, values)
    slides = row.kind in ("fixed", "prismatic") or _is_marked(row.cells[reading.d]) or is_tool(row.label)
    if columns.headers[columns.theta].is_offset and not slides:
        place, joint = "theta", joint if place == "theta" and joint else f"q_{row.number}"
    if joint and joint not in symbols_of(values[place]):
        values[place] = values[place] + algebra.symbol(joint)
    if joint and columns.offset is not None and (values[place] - algebra.symbol(joint)).normal().is_zero():
        values[place] = values[place] + _value(names, algebra, columns, columns.offset, place, row)
    return {parameter: entry_text(value) for parameter, value in values.items()}, joint


def _value(names: Names, algebra: ExactAlgebra, columns: Columns, column: int, parameter: str, row: _Row) -> Scalar:
    cell = row.cells[column]
    if not cell.trees:
        return algebra.ring.zero
    unit = columns.headers[column].unit
    value, *others = cell.values(names, algebra)
    if others and set(symbols_of(value)) & set(symbols_of(others[-1])):
        value = others[-1]  # θ_2 = θ_2 - π/2
    if others and row.kind == "fixed" and parameter == "theta":
        value = others[-1]  # θ_7 = 0
    if parameter in ANGLES:
        return with_parts_of_pi(to_radians(value, unit)[0])
    return value * SCALES.get(unit, 1) if value.as_fraction() is not None and not cell.has_unit else value


def _joint_of(reading: Reading, row: _Row, values: Mapping[str, Scalar]) -> tuple[str, str]:
    """Return where a row holds its joint's variable, theta or d, and that variable, "" where nothing moves; raises EvaluationError."""
    if row.kind == "fixed":
        return "", ""
    place = {"revolute": "theta", "prismatic": "d"}.get(row.kind, "")
    cells = {place: row.cells[reading.columns[place]] for place in ("theta", "d")}
    named = [place for place in cells if row.variable and row.variable in symbols_of(values[place])]
    marked = [place for place, cell in cells.items() if _is_marked(cell)]
    if place == "" and not (marked or cells["theta"].text or any(map(_is_slide, symbols_of(values["d"])))):
        marked = ["theta"]  # an empty cell is no zero: the variable itself
    place = place or next((told[0] for told in (named, marked) if len(told) == 1), "")
    if not place:
        is_tool_length = is_tool(row.label) and not symbols_of(values["theta"])
        return ("", "") if is_tool_length else joint_of(values, row.number)
    fallback = f"{'theta' if place == 'theta' else 'd'}_{row.number}"
    return place, row.variable or _variable(values[place], place) or fallback


def joint_of(values: Mapping[str, Scalar], number: int) -> tuple[str, str]:
    """Return where the values of a row hold a joint's variable, theta or d, and that variable.

    Both are empty where nothing in the row moves; raises EvaluationError where the variable is one of several letters.
    """
    if symbol := _variable(values["theta"], "theta"):
        return "theta", symbol
    if (symbol := _variable(values["d"], "d")) and _is_slide(symbol):
        return "d", symbol
    if not symbols_of(values["theta"]) and not any(map(_is_slide, symbols_of(values["d"]))):
        return "", ""
    raise EvaluationError(say(Kind.ROW_WITHOUT_JOINT, number=number))


def _is_marked(cell: Cell) -> bool:
    return cell.kind == "variable" or (cell.kind == "value" and _MARK.search(cell.text) is not None)


def _variable(value: Scalar, place: str) -> str:
    """Return the one symbol of a sum that can be a joint's variable, or an empty text; of several the one that is named so."""
    terms = [(powers, factor) for powers, factor in value.ring.terms(value.numerator) if ("pi", "") not in powers]
    found = [name for powers, factor in terms if abs(factor) == 1 for kind, name in powers if kind == "symbol"]
    if len(found) > 1:
        found = [name for name in found if (letter_of(name) in ("theta", "q") if place == "theta" else _is_slide(name))]
    return found[0] if len(found) == 1 else ""


def _is_slide(symbol: str) -> bool:
    return letter_of(symbol) in _SLIDES and symbol[-1].isdigit()
