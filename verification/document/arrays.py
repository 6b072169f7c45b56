"""Tables that are set as an array in a display."""

from __future__ import annotations

import re
from dataclasses import dataclass

from armproof.verification.document.model import Display, Table
from armproof.verification.patterns import regex

_OPENING = regex(
    r"\s*(?:(?:\\text\w*\s*\{[^{}]*\}|[A-Za-z]|\s)+(?:=|:)\s*)?(?:\\(?:displaystyle|small|footnotesize|normalsize|centering|large)\s*)*(?:\\left\s*\\?[\[({|.]\s*)?\\begin\s*"
    r"\{(?:(?P<ruled>array|tabular)\}\s*(?:\[\w\])?\s*\{(?:[^{}]|\{[^{}]*\})*\}|(?P<plain>[bpvB]?matrix|aligned)\})"
)
_CLOSING = regex(
    r"\\end\s*\{(?P<name>\w+)\}\s*(?:\\right\s*\\?[\])}|.]\s*)?[.,;]?\s*(?:\\(?:tag|label)\{[^}]*\}\s*)?[.,;]?\s*"
)
_RULE = regex(
    r"\\(?:hline|toprule|midrule|bottomrule|hdashline|(?:cline|cmidrule)\s*(?:\([^)]*\))?\s*\{[^}]*\}|addlinespace)(?![A-Za-z])"
)
_TOKEN = regex(r"\\begin\s*\{|\\end\s*\{|\\\\(?:\s*\[[^\]]*\])?|\\.|[{}&]", re.DOTALL)


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
