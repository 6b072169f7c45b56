"""From a table to its record: DH tables, upright or turned, as Markdown or set as an array, and tables of joint origins."""

from __future__ import annotations

import re
from dataclasses import dataclass, replace

from armproof.verification.document import Display, Table
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.errors import EvaluationError, NotSampled, TooComplex
from armproof.verification.findings import Kind, finding_of, say
from armproof.verification.tables.cells import UnreadableCell
from armproof.verification.tables.columns import read_columns
from armproof.verification.tables.dh import DHTableCheck
from armproof.verification.tables.origins import check_origins
from armproof.verification.verdict import Record, Verdict

_OPENING = re.compile(
    r"\s*(?:(?:\\text\w*\s*\{[^{}]*\}|[A-Za-z]|\s)+(?:=|:)\s*)?(?:\\(?:displaystyle|small|footnotesize|normalsize|centering|large)\s*)*(?:\\left\s*\\?[\[({|.]\s*)?\\begin\s*"
    r"\{(?:(?P<ruled>array|tabular)\}\s*(?:\[\w\])?\s*\{(?:[^{}]|\{[^{}]*\})*\}|(?P<plain>[bpvB]?matrix|aligned)\})"
)
TWIST = re.compile(r"alpha|α|twist|torsi", re.IGNORECASE)  # no DH table without that column
_CLOSING = re.compile(
    r"\\end\s*\{(?P<name>\w+)\}\s*(?:\\right\s*\\?[\])}|.]\s*)?[.,;]?\s*(?:\\(?:tag|label)\{[^}]*\}\s*)?[.,;]?\s*"
)
_RULE = re.compile(
    r"\\(?:hline|toprule|midrule|bottomrule|hdashline|(?:cline|cmidrule)\s*(?:\([^)]*\))?\s*\{[^}]*\}|addlinespace)(?![A-Za-z])"
)
_TOKEN = re.compile(r"\\begin\s*\{|\\end\s*\{|\\\\(?:\s*\[[^\]]*\])?|\\.|[{}&]", re.DOTALL)


@dataclass(frozen=True)
class ArrayTable:
    """A table taken from a display, with the place of each cell in the LaTeX, the header's first."""

    table: Table
    spans: tuple[tuple[tuple[int, int], ...], ...]

    def span(self, row: int | None, column: int | None, text: str) -> tuple[int, int] | None:
        """Return the place of an entry of the body, or of the header of that text where there is no row."""
        if row is None:
            return next(
                (span for span, header in zip(self.spans[0], self.table.header, strict=True) if header == text), None
            )
        inside = row < len(self.spans) and column is not None and column <= len(self.spans[row])
        return self.spans[row][column - 1] if inside and column is not None else None


def read_array(display: Display) -> ArrayTable | None:
    """Return the DH table of a display that holds one array and nothing else, or None."""
    return array_in(display) if TWIST.search(display.latex) else None


def array_in(display: Display) -> ArrayTable | None:
    """Return the table of a display that holds one array and nothing else, whatever it is of, or None."""
    latex = display.latex
    if "&" not in latex:
        return None
    opening = _OPENING.match(latex)
    cut = _cut(latex, opening.end()) if opening is not None else None
    if opening is None or cut is None:
        return None
    rows, end = cut
    closing = _CLOSING.fullmatch(latex, end)
    if closing is None or closing.group("name") not in opening.groups():
        return None
    cells = [[_trimmed(latex, a, b) for a, b in row] for row in rows]
    cells = [row for row in cells if any(a < b for a, b in row)]
    width = max((len(row) for row in cells), default=0)
    kept = [k for k in range(width) if any(len(row) > k and row[k][0] < row[k][1] for row in cells)]
    if len(cells) < 2:
        return None
    spans = [[row[k] if k < len(row) else (row[-1][1], row[-1][1]) for k in kept] for row in cells]
    texts = [tuple(_RULE.sub("", latex[a:b]).strip() for a, b in row) for row in spans]
    table = Table(
        display.line, texts[0], tuple(texts[1:]), display.erratum, display.cell, display.section, display.file
    )
    return ArrayTable(table, tuple(tuple(row) for row in spans))


def _cut(latex: str, start: int) -> tuple[list[list[tuple[int, int]]], int] | None:
    r"""Return the places of the cells, cut at & and \\ outside braces and inner environments, and that of \end."""
    rows: list[list[tuple[int, int]]] = [[]]
    begin, depth = start, 0
    for token in _TOKEN.finditer(latex, start):
        text = token.group()
        if text.startswith("\\end") and depth == 0:
            rows[-1].append((begin, token.start()))
            return rows, token.start()
        if text.startswith("\\begin"):
            depth += 2  # the environment, and the brace of its name; at its end the brace's closing takes both back
        elif text == "{":
            depth += 1
        elif text == "}":
            depth -= 1
        elif depth == 0 and (text == "&" or text.startswith("\\\\")):
            rows[-1].append((begin, token.start()))
            begin = token.end()
            if text != "&":
                rows.append([])
    return None


def _trimmed(latex: str, start: int, end: int) -> tuple[int, int]:
    """Return the place of a cell without blanks and rules."""
    while (found := re.compile(r"\s+|%s" % _RULE.pattern).match(latex, start, end)) is not None:
        start = found.end()
    while end > start and latex[end - 1].isspace():
        end -= 1
    return start, end


def check_table(checker: ChainChecker, table: Table) -> Record | None:
    """Return the record of a table of DH parameters or joint origins, or None where it is neither: it claims nothing."""
    if (found := _check_upright(checker, table)) is not None:
        return found
    other = turned(table)
    if other is None or (found := _check_upright(checker, other)) is None:
        return None
    entries = tuple(
        replace(e, row=e.column - 1, column=e.row + 1) if e.row is not None and e.column is not None else e
        for e in found.entries
    )
    return replace(found, latex=_latex(table), entries=entries)


def check_array_table(checker: ChainChecker, display: Display) -> Record | None:
    """Return the record of a display that is a DH table set as an array, or None where it is not."""
    array = read_array(display)
    if array is None or (found := check_table(checker, array.table)) is None:
        return None
    entries = [replace(entry, span=array.span(entry.row, entry.column, entry.printed)) for entry in found.entries]
    return replace(found, latex=display.latex, entries=tuple(entries))


def _check_upright(checker: ChainChecker, table: Table) -> Record | None:
    record = Record(
        table.line,
        _latex(table),
        Verdict.UNCHECKED,
        table.erratum,
        cell=table.cell,
        section=table.section,
        file=table.file,
    )
    try:
        if (columns := read_columns(table.header)) is not None:
            return DHTableCheck(checker, table, columns, record).record()
        return check_origins(checker, table, record)
    except UnreadableCell as problem:
        return replace(record, verdict=Verdict.UNREADABLE, findings=(finding_of(problem),))
    except (TooComplex, RecursionError) as problem:
        return replace(record, findings=(say(Kind.TOO_LARGE, problem=finding_of(problem)),))
    except (EvaluationError, NotSampled) as problem:
        return replace(record, findings=(finding_of(problem),))


def turned(table: Table) -> Table | None:
    """Return a table that has a column a joint, turned."""
    grid = (table.header, *table.rows)
    if len({len(row) for row in grid}) != 1 or len(table.header) < 2:
        return None
    header, *rows = zip(*grid, strict=True)
    return replace(table, header=header, rows=tuple(rows))


def _latex(table: Table) -> str:
    return " \\\\\n".join(" & ".join(row) for row in (table.header, *table.rows))
