"""DH tables that stand in code alone: lists of links, dictionaries of parameters, rows under a comment that names the columns."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from textwrap import dedent

from armproof.verification.document.code_amendments import MAY_AMEND, CodeTables, amended_in_matlab, parsed_code
from armproof.verification.document.code_columns import (
    NAMES,
    OF_A_TABLE,
    columns_of_entries,
    columns_of_manual,
    in_radians,
    named_columns,
    names_others,
)
from armproof.verification.document.code_values import NoEntry, Values, entry, parsed
from armproof.verification.document.model import Display, Table
from armproof.verification.patterns import regex

HEADER = ("sigma", "alpha", "a", "d", "theta")
LONGEST = 40_000  # characters of a piece of code
_LINKS = regex(r"(?:(?:DH)?Link|(Revolute|Prismatic)(?:M?DH)?)")
_HAS_ENDS = regex(  # robot.tool = SE3(0.1, 0, 0), DHRobot(links, base=…), SerialLink(L, 'tool', …)
    r"(?:\.(?:tool|base)\s*=|[(,]\s*(?:tool|base)\s*=|'(?:tool|base)'\s*,)(?!=)\s*(?!(?:None|SE3\(\)|(?:np\.|sp\.)?(?:eye|identity)\(4\)|sm\.SE3\(\))\s*(?:[,;)\n]|$))\S"
)
_PARAMETER = regex(r"'?(alpha|a|d|q|theta)_?(\d)'?")
_OF_MATLAB = regex(r"(?<!\w)(?:Revolute|Prismatic|Link)(?:M?DH)?\s*\(([^()]*(?:\([^()]*\)[^()]*)*)\)")
_ROWS = regex(r"(?:(?<!\w)([A-Za-z]\w*)\s*)?=\s*\[([^\[\]]*)\]", re.DOTALL)
# DH(1,:) = […]
_ROW = regex(r"(?<!\w)([A-Za-z]\w*)\s*\(\s*(\d{1,2})\s*,\s*:\s*\)\s*=\s*\[([^\[\]]*)\]", re.DOTALL)

Row = Mapping[str, ast.expr]


@dataclass(frozen=True)
class _Found:
    """Rows of parameters in code, each with the kind of its joint where that is told, and the line on which they begin."""

    rows: tuple[tuple[str, Row], ...]
    line: int


def code_tables(displays: Iterable[Display]) -> Iterator[Table]:
    """Yield the DH tables in pieces of code, with the letters and numbers that these give; none where it has a base or a tool besides."""
    displays = [*displays]
    if any(_HAS_ENDS.search(display.latex) for display in displays):
        return
    for display in displays:
        code = dedent(display.latex)
        for found in [*_of_python(code)] or _of_matlab(code) if len(code) <= LONGEST else ():
            try:
                rows = tuple(
                    _cells(kind, row, number, _assigned(code)) for number, (kind, row) in enumerate(found.rows, 1)
                )
            except NoEntry:
                continue
            if len(rows) > 1:
                line = display.line + found.line
                yield Table(line, HEADER, rows, cell=display.cell, section=display.section, file=display.file)


def amended_in_code(displays: Iterable[Display]) -> Iterator[str]:
    """Yield the statements in pieces of code that change a DH table, and are not carried out."""
    found: list[tuple[str, str]] = []
    tables: set[str] = set()
    for display in displays:
        code = dedent(display.latex)
        if len(code) > LONGEST:
            continue
        if (tree := parsed_code(code)) is None:
            tables |= {name for name, _, _ in _matrices_of_matlab(code) if OF_A_TABLE.fullmatch(name)}
            yield from amended_in_matlab(code, tables) if MAY_AMEND.search(code) else ()
            continue
        follows = CodeTables(tree)
        found += follows.amended
        tables |= {name for name in follows.rows if _has_columns(code, name)}
    yield from (said for name, said in found if not name or name in tables or OF_A_TABLE.fullmatch(name))


def _has_columns(code: str, name: str) -> bool:
    """Whether a comment names the columns of a list, above it or in it."""
    lines = code.split("\n")
    at = next((place for place, line in enumerate(lines) if re.match(rf"\s*{re.escape(name)}\s*=", line)), None)
    return at is not None and named_columns(lines, at, at + 3) != ()


def _cells(kind: str, row: Row, number: int, values: Values) -> tuple[str, ...]:
    """Return the cells of a row; what moves a joint of a known kind is named by its number, and what stands there is added."""
    cells = {key: entry(node, values) for key, node in row.items()}
    place = {"R": "theta", "P": "d"}.get(kind, "")
    if place and not re.search(r"[A-Za-z](?<!pi)_", cells.get(place, "")):
        moved = rf"\theta_{{{number}}}" if kind == "R" else f"d_{{{number}}}"
        added = [text for text in (cells.get(place, ""), cells.get("offset", "")) if text not in ("", "0")]
        cells[place] = " + ".join([moved, *added])
    return (kind, *(cells.get(key, "0") for key in HEADER[1:]))


def _of_python(code: str) -> Iterator[_Found]:
    """Yield the rows in Python, a notebook's commands left out; none of what cannot be parsed."""
    tree = parsed_code(code)
    if tree is None:
        return
    if MAY_AMEND.search(code):
        CodeTables(tree)  # carries out what it can
    named, tables = _links_by_name(tree), _tables_by_name(tree)
    for node in ast.walk(tree):
        match node:
            case ast.List(elements) | ast.Tuple(elements) if len(elements) > 1:
                yield from _of_list(node, elements, named, code, tables.get(id(node), False))
            case ast.Dict(keys, values):
                yield from _of_dictionary(node, keys, values)


def _assigned(code: str) -> Values:
    found = re.findall(r"^[ \t]*(?:self\.)?([A-Za-z]\w*)[ \t]*=[ \t]*([-\d.][^=;#%\n]*)", code, re.MULTILINE)
    values: dict[str, ast.expr] = {}
    for key, text in found:
        try:
            values[key] = parsed(text)
        except NoEntry:
            continue
    return values


def _links_by_name(tree: ast.AST) -> dict[str, tuple[str, Row]]:
    """Return the links that are given a name: L1 = RevoluteDH(a=1)."""
    found = {}
    for node in ast.walk(tree):
        match node:
            case ast.Assign([ast.Name(name)], ast.Call() as call) if (link := _link(call)) is not None:
                found[name] = link
    return found


def _tables_by_name(tree: ast.AST) -> dict[int, bool]:
    """Return which lists are tables of DH parameters by their name: DH = np.array([[…], […]])."""
    found = {}
    for node in ast.walk(tree):
        match node:
            case ast.Assign([ast.Name(name) | ast.Attribute(_, name)], value):
                inner = value.args[0] if isinstance(value, ast.Call) and value.args else value
                found[id(inner)] = OF_A_TABLE.fullmatch(name) is not None
    return found


def _link(node: ast.expr) -> tuple[str, Row] | None:
    """Return the kind and the parameters of a call such as RevoluteDH(d=0.3, alpha=pi/2)."""
    if not isinstance(node, ast.Call):
        return None
    function = node.func.attr if isinstance(node.func, ast.Attribute) else getattr(node.func, "id", "")
    match = _LINKS.fullmatch(function)
    if match is None or node.args:
        return None
    row = {word.arg: word.value for word in node.keywords if word.arg in ("a", "alpha", "d", "theta", "offset")}
    sigma = next((word.value for word in node.keywords if word.arg in ("sigma", "jointtype")), None)
    is_sliding = isinstance(sigma, ast.Constant) and sigma.value in (1, "P")
    return (match[1] or ("P" if is_sliding else "R"))[0], {str(key): value for key, value in row.items()}


def _of_list(
    node: ast.expr, elements: Sequence[ast.expr], named: Mapping[str, tuple[str, Row]], code: str, is_table: bool
) -> Iterator[_Found]:
    links = [named.get(each.id) if isinstance(each, ast.Name) else _link(each) for each in elements]
    if all(links):
        yield _Found(tuple(filter(None, links)), _line(elements[0], node))
    elif all(isinstance(each, ast.List | ast.Tuple) and len(each.elts) == 4 for each in elements):
        where = code.split("\n"), node.lineno - 1, node.end_lineno or node.lineno
        told, is_table = named_columns(*where), is_table and not names_others(*where)
        yield from _of_rows([each.elts for each in elements], told, is_table, node.lineno - 1)  # type: ignore[attr-defined]
    elif all(isinstance(each, ast.Dict) for each in elements):
        rows = [_by_word(each) for each in elements]  # type: ignore[arg-type]
        if all(len(row) == 4 for row in rows):
            yield _Found(tuple(_of_moving(rows)), node.lineno - 1)


def _line(first: ast.expr, node: ast.expr) -> int:
    return (node if isinstance(first, ast.Name) else first).lineno - 1


def _by_word(node: ast.Dict) -> Row:
    pairs = ((getattr(key, "value", ""), value) for key, value in zip(node.keys, node.values, strict=True))
    return {NAMES[key.lower()]: value for key, value in pairs if isinstance(key, str) and key.lower() in NAMES}


def _of_dictionary(node: ast.Dict, keys: Sequence[ast.expr | None], values: Sequence[ast.expr]) -> Iterator[_Found]:
    """Yield the rows of {alpha0: 0, a0: 0, d1: 0.75, q1: q1, …}: where they begin with 0, those of link i have i-1."""
    told: dict[tuple[str, int], ast.expr] = {}
    for key, value in zip(keys, values, strict=True):
        text = key.id if isinstance(key, ast.Name) else key.value if isinstance(key, ast.Constant) else ""
        if match := _PARAMETER.fullmatch(str(text)):
            told[NAMES[match[1]], int(match[2])] = value
    before = int(("alpha", 0) in told)
    rows = [
        {"theta": ast.Name(f"q{number}")}
        | {key: told[at] for key in HEADER[1:] if (at := (key, number - before * (key in ("alpha", "a")))) in told}
        for number in sorted(number for name, number in told if name == "d")
    ]
    if len(rows) > 1 and all(len(row) == 4 for row in rows):
        yield _Found(tuple(_of_moving(rows)), node.lineno - 1)


def _of_moving(rows: Sequence[Row]) -> Iterator[tuple[str, Row]]:
    """Yield rows with the kind of each joint: where all angles are numbers each joint turns, from there on."""
    letters = (each for row in rows for each in ast.walk(row["theta"]) if isinstance(each, ast.Name | ast.Attribute))
    has_variable = any(
        getattr(each, "attr", getattr(each, "id", "pi")) not in ("pi", "np", "math", "sp") for each in letters
    )
    yield from (("" if has_variable else "R", row) for row in rows)


def _of_matlab(code: str) -> Iterator[_Found]:
    """Yield the rows of Link([theta d a alpha]), of Revolute('d', 1, 'a', 2), and of a matrix under a comment that names its columns."""
    plain = re.sub(r"%.*", "", code)
    calls = [*_OF_MATLAB.finditer(plain)]
    try:
        links = [_link_of_matlab(call[0], call[1]) for call in calls]
        if len(links) > 1:
            yield _Found(tuple(links), plain[: calls[0].start()].count("\n"))
            return
        for name, at, rows in _matrices_of_matlab(code):
            lines = code.split("\n")
            columns = named_columns(lines, at, at + 3) or columns_of_manual(code)
            is_table = OF_A_TABLE.fullmatch(name) is not None and not names_others(lines, at, at + 3)
            if len(rows) > 1 and all(len(row) == 4 for row in rows) and (columns or is_table):
                yield from _of_rows([[*map(parsed, row)] for row in rows], columns, is_table, at)
    except NoEntry:
        return


def _matrices_of_matlab(code: str) -> Iterator[tuple[str, int, list[list[str]]]]:
    """Yield the name, the line and the rows of each matrix: DH = [… ; …], or DH(1,:) = […] and so on."""
    by_row: dict[str, list[tuple[int, int, list[str]]]] = {}
    for found in _ROW.finditer(code):
        at = code[: found.start()].count("\n")
        by_row.setdefault(found[1], []).append((int(found[2]), at, _numbers(_on_one_line(found[3]))))
    for name, told in by_row.items():
        if [number for number, _, _ in told] == [*range(1, len(told) + 1)]:
            yield name, told[0][1], [row for _, _, row in told]
    for found in _ROWS.finditer(code):
        lines = re.split(r"[;\n]", _on_one_line(found[2]))
        yield found[1] or "", code[: found.start(2)].count("\n"), [row for line in lines if (row := _numbers(line))]


def _on_one_line(rows: str) -> str:
    return re.sub(r"%.*|\.\.\.[^\n]*\n?", "", rows)


def _of_rows(rows: Sequence[Sequence[ast.expr]], told: tuple[str, ...], is_table: bool, line: int) -> Iterator[_Found]:
    """Yield rows of four entries whose columns are told, or are found by what stands in them where the name is that of a table."""
    if columns := told or (columns_of_entries(rows) if is_table else ()):
        named = [dict(zip(columns, row, strict=True)) for row in rows]
        yield _Found(tuple(_of_moving(named if told else in_radians(named))), line)


def _link_of_matlab(call: str, arguments: str) -> tuple[str, Row]:
    if listed := re.match(r"\s*\[([^\]]*)\]", arguments):
        theta, d, a, alpha, *more = _numbers(listed[1])
        kind = "P" if more[:1] == ["1"] else "R"
        words = {"theta": theta, "d": d, "a": a, "alpha": alpha} | ({"offset": more[1]} if len(more) > 1 else {})
    else:
        pairs = re.findall(r"'(alpha|a|d|theta|offset)'\s*,\s*([^,]+)", arguments)
        if not pairs:
            raise NoEntry
        words, kind = dict(pairs), "P" if re.search("prismatic|'sigma'\\s*,\\s*1", call, re.IGNORECASE) else "R"
    return kind, {key: parsed(text) for key, text in words.items()}


def _numbers(text: str) -> list[str]:
    """Return the entries of a row of Matlab, parted by commas or blanks."""
    closed = re.sub(r"\s*([*/^])\s*", r"\1", text.strip())
    closed = re.sub(r"\s+([-+])\s+", r"\1", closed)
    return [part for part in re.split(r"[,\s]+", closed) if part]
