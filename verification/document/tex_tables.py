r"""Tables of LaTeX: a `tabular` taken apart into header and rows, rules and dollars removed."""

from __future__ import annotations

import re
from collections.abc import Callable

from armproof.verification.document.model import Piece, Table
from armproof.verification.patterns import regex

_RULE = regex(
    r"\\(?:hline|toprule|midrule|bottomrule|endhead|endfirsthead|(?:cline|cmidrule)\s*(?:\([^)]*\))?\s*\{[^}]*\}|addlinespace|centering)(?![A-Za-z])"
)
_ARGUMENTS = regex(r"\s*(?:\[[^\]]*\]\s*)?(?:\{(?:[^{}]|\{[^{}]*\})*\}\s*){1,2}")
_CUT = regex(r"\\\\(?:\s*\[[^\]]*\])?|\\tabularnewline|\\.|[{}&]", re.DOTALL)


def read_tabular(content: str, offset: int, place: Callable[[int], tuple[int, int]]) -> Table | None:
    r"""Return the table of what stands between \begin{tabular} and \end{tabular}, or None where cells are merged.

    `offset` is where the content begins in the file; `place` gives the line and column of a place in the file.
    """
    arguments = _ARGUMENTS.match(content)
    if arguments is None or "\\multicolumn" in content or "\\multirow" in content:
        return None
    rows = [[_trimmed(content, *span) for span in row] for row in _rows(content, arguments.end())]
    rows = [row for row in rows if any(begin < end for begin, end in row)]
    if len(rows) < 2:
        return None
    texts = [tuple(content[begin:end] for begin, end in row) for row in rows]
    pieces = tuple(
        tuple(Piece(0, end - begin, *place(offset + begin), _in_dollars(content, begin, end)) for begin, end in row)
        for row in rows
    )
    return Table(place(offset)[0], texts[0], tuple(texts[1:]), pieces=pieces)


def tabular_cells(tabular: str) -> list[list[str]]:
    r"""Return the cells of a whole tabular as they stand, rules removed; one that is merged stands in the first column of its own."""
    content = re.sub(r"\A\\begin\s*\{[\w*]+\}|\\end\s*\{[\w*]+\}\s*\Z", "", tabular)
    arguments = _ARGUMENTS.match(content)
    rows = [
        [_merged(_RULE.sub("", content[begin:end])) for begin, end in row]
        for row in _rows(content, arguments.end() if arguments else 0)
    ]
    return [
        [cell.strip() for cells in row for cell in cells]
        for row in rows
        if any("".join(cells).strip() for cells in row)
    ]


def _merged(cell: str) -> list[str]:
    """Return a cell and the empty ones that it is merged with."""
    found = re.match(r"\s*\\multicolumn\s*\{(\d+)\}\s*\{[^{}]*\}", cell)
    return (
        [cell[found.end() :], *[""] * (int(found[1]) - 1)]
        if found
        else [re.sub(r"\\multirow\s*\{[^{}]*\}\s*\{[^{}]*\}", "", cell)]
    )


def _rows(content: str, start: int) -> list[list[tuple[int, int]]]:
    """Return the places of the cells, cut at & and the ends of rows outside braces."""
    rows: list[list[tuple[int, int]]] = [[]]
    begin, depth = start, 0
    for token in _CUT.finditer(content, start):
        text = token.group()
        if text in "{}":
            depth += 1 if text == "{" else -1
        elif depth == 0 and (text == "&" or text.startswith("\\\\") or text == "\\tabularnewline"):
            rows[-1].append((begin, token.start()))
            begin = token.end()
            if text != "&":
                rows.append([])
    rows[-1].append((begin, len(content)))
    return rows


def _trimmed(content: str, start: int, end: int) -> tuple[int, int]:
    """Return the place of a cell without blanks, rules and the dollars around it."""
    blank = re.compile(r"\s+|\$|%s" % _RULE.pattern)
    while (found := blank.match(content, start, end)) is not None:
        start = found.end()
    while end > start and (content[end - 1].isspace() or content[end - 1] == "$"):
        end -= 1
    return start, end


def _in_dollars(content: str, begin: int, end: int) -> bool:
    return content[begin - 1 : begin] == "$" or "$" in content[begin:end]
