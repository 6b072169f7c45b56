r"""Read LaTeX: `$$`, `\[ \]` and the display environments, tables, sections, errata, and the author's own macros.

The front matter stands in the comments at the head of the file:

    % ---
    % arm: scara
    % ---

An erratum is a display in an `erratum` environment, in one that begins with the word Erratum, or below a comment
`% Erratum`.
"""

from __future__ import annotations

import re
from bisect import bisect
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from armproof.verification.document.front_matter import FRONT_MATTER_KEYS, FrontMatter, split_front_matter
from armproof.verification.document.model import INLINE, Display, Document, Table
from armproof.verification.document.tex_macros import blank, closing_brace, find_macros
from armproof.verification.document.tex_tables import read_tabular

ENVIRONMENTS = (
    "equation align gather multline flalign alignat eqnarray displaymath dmath dgroup math xalignat IEEEeqnarray"
).split()
_DISPLAY = re.compile(r"(?:%s)\*?" % "|".join(ENVIRONMENTS))
_WITH_ARGUMENT = re.compile(r"(?:alignat|xalignat|IEEEeqnarray)\*?")
_COMMENT = re.compile(r"(?<!\\)((?:\\\\)*)%([^\n]*)")
_HIDDEN = re.compile(
    r"\\begin\{(verbatim\*?|lstlisting|minted|comment|Verbatim)\}.*?\\end\{\1\}|\\verb\*?([^\w\s*]).*?\2|\\(?:short)?intertext\s*\{[^{}]*\}",
    re.DOTALL,
)
_TOKEN = re.compile(
    r"\\begin\s*\{(?P<begin>\w+\*?)\}|\\end\s*\{(?P<end>\w+\*?)\}|\\(?P<section>chapter|(?:sub)*section|paragraph)\*?\s*(?:\[[^\]]*\])?\s*\{"
    r"|(?P<bracket>\\\[)|(?P<macro>\\[A-Za-z]+)|\\.|(?P<dollars>\$\$?)",
    re.DOTALL,
)
_ERRATUM = re.compile(
    r"\s*(?:\[(?:[^\]]*[={\s])?\W*errat(?:um|a)\b|(?:\\(?:textbf|textit|emph|textsc|bfseries|itshape|bf|it|noindent|paragraph)(?![A-Za-z])[\s*{]*|\{)*errat(?:um|a)\b)",
    re.IGNORECASE,
)


def read_tex(path: Path, text: str) -> Document:
    """Return the document of a LaTeX file."""
    text = text.replace("\r\n", "\n")
    front = _front_matter(path, text)
    scanner = _Scanner(text)
    displays = tuple(scanner.displays())
    return Document(path, front.values, displays, tuple(scanner.tables), front.lines, remarks=front.remarks)


def _front_matter(path: Path, text: str) -> FrontMatter:
    """Read the comments at the head of the file: fenced by `---`, or beginning with one of our keys."""
    head: list[str] = []
    first = 1
    for line in text.split("\n"):
        found = re.match(r"[ \t]*%+ ?(?!\s*!)(.*)$", line)
        if found is None and (head or line.strip()) and not re.match(r"[ \t]*%", line):
            break
        stripped = found.group(1).rstrip() if found else ""
        is_start = stripped.rstrip() == "---" or re.match(r"(?:%s)\s*:" % "|".join(FRONT_MATTER_KEYS), stripped)
        if head or is_start:
            head.append(stripped)
        else:
            first += 1
    if not head:
        return FrontMatter()
    fenced = head[0] == "---"
    block = "\n".join(head if fenced else ["---", *head, "---"])
    return split_front_matter(path, block + "\n", first if fenced else first - 1)[0] or FrontMatter()


@dataclass
class _Region:
    """An environment that is open: where it began to be an erratum, if it is one."""

    name: str
    erratum: bool


class _Scanner:
    """Finds the displays of a LaTeX text, which keeps its length: what does not print is blank in `visible`."""

    def __init__(self, text: str) -> None:
        self.text = text
        self.marks = [
            m.start() for m in _COMMENT.finditer(text) if re.match(r"[%\s]*errat(?:um|a)\b", m.group(2), re.I)
        ]
        visible = _COMMENT.sub(lambda m: m.group(1) + " " * (len(m.group()) - len(m.group(1))), text)
        visible = _HIDDEN.sub(lambda m: blank(m.group()), visible)
        self.macros, self.visible = find_macros(visible)
        begin, end = (re.search(r"\\%s\s*\{document\}" % which, self.visible) for which in ("begin", "end"))
        self.start = begin.end() if begin else 0
        self.stop = end.start() if end else len(text)
        self.newlines = [m.start() for m in re.finditer("\n", text)]
        self.section = ""
        self.regions: list[_Region] = []
        self.tables: list[Table] = []

    def line(self, offset: int) -> int:
        """Return the line (from 1) of a place in the file."""
        return bisect(self.newlines, offset - 1) + 1 if offset else 1

    def place(self, offset: int) -> tuple[int, int]:
        """Return the line (from 1) and the column (from 0) of a place in the file."""
        line = self.line(offset)
        return line, offset - (self.newlines[line - 2] + 1 if line > 1 else 0)

    def displays(self) -> Iterator[Display]:
        """Yield the displays in their order, and gather the tables."""
        position = self.start
        while (token := _TOKEN.search(self.visible, position, self.stop)) is not None:
            position = token.end()
            if token.group("section"):
                close = closing_brace(self.visible, token.end() - 1)
                self.section = " ".join(self.visible[token.end() : close].split())
                position = token.end() if close < 0 else close + 1
            elif (opened := self._opened(token)) is not None:
                begin, end, after = opened
                if token.group() not in ("$", "\\("):
                    yield self._display(token, begin, end)
                elif end >= 0:
                    latex, _ = self.macros.expanded(self.visible[begin:end], begin, self.place)
                    yield Display(self.line(token.start()), latex, section=self.section, opening=INLINE)
                position = after
            elif token.group("begin"):
                position = self._enter(token)
            elif token.group("end"):
                self._leave(token.group("end"))

    def _opened(self, token: re.Match[str]) -> tuple[int, int, int] | None:
        """Return where the mathematics that a token opens begins, ends (-1: never), and what is read next; or None."""
        dollars, name = token.group("dollars"), token.group("begin")
        if dollars:
            end = _find(self.visible, r"(?<!\\)" + re.escape(dollars), token.end(), self.stop)
            return (token.end(), end, token.end() if end < 0 else end + len(dollars))
        if token.group() == "\\(":
            end = _find(self.visible, r"(?<!\\)\\\)", token.end(), self.stop)
            return (token.end(), end, token.end() if end < 0 else end + 2)
        if token.group("bracket"):
            closing, again = r"(?<!\\)\\\]", r"(?<!\\)\\\["
        elif name and _DISPLAY.fullmatch(name):
            closing, again = (r"\\%s\s*\{%s\}" % (which, re.escape(name)) for which in ("end", "begin"))
        elif (name := self.macros.opens(token.group("macro") or "")) is not None:
            closing, again = self.macros.closings(name), re.escape(token.group("macro")) + r"(?![A-Za-z])"
        else:
            return None
        begin = token.end()
        end = _find(self.visible, closing, begin, self.stop)
        repeated = _find(self.visible, again, begin, self.stop)
        if 0 <= repeated < end:
            end = -1
        if end < 0:
            return begin, -1, begin
        found = re.compile(closing).match(self.visible, end)
        return begin, end, found.end() if found else end

    def _display(self, token: re.Match[str], begin: int, end: int) -> Display:
        opening = token.group().strip()
        if _WITH_ARGUMENT.fullmatch(token.group("begin") or ""):
            argument = re.compile(r"\s*\{[^{}]*\}").match(self.visible, begin)
            begin = argument.end() if argument else begin
        marked = bool(self.marks) and self.marks[0] < token.start()
        self.marks = [mark for mark in self.marks if mark > token.start()]
        erratum = marked or any(region.erratum for region in self.regions)
        line = self.line(token.start())
        if end < 0:
            rest = self.visible[begin : self.stop].split("\n\n")[0]
            return Display(line, rest, erratum, None, self.section, closed=False, opening=opening)
        while begin < end and self.visible[begin] == "\n":
            begin += 1
        latex, pieces = self.macros.expanded(self.visible[begin:end].rstrip("\n"), begin, self.place)
        return Display(line, latex, erratum, None, self.section, opening=opening, pieces=pieces)

    # -- environments --------------------------------------------------------------------------------------------------

    def _enter(self, token: re.Match[str]) -> int:
        """Enter an environment that is no display, or read the table that it is; return where to read on."""
        name = token.group("begin")
        marked = bool(self.marks) and self.marks[0] < token.start()
        if name.rstrip("*") in ("tabular", "tabularx", "tabulary", "longtable"):
            end = _find(self.visible, r"\\end\s*\{%s\}" % re.escape(name), token.end(), self.stop)
            if end >= 0:
                erratum = marked or any(region.erratum for region in self.regions)
                table = read_tabular(self.visible[token.end() : end], token.end(), self.place)
                if table is not None:
                    self.tables.append(_with_context(table, self.line(token.start()), erratum, self.section))
                    self.marks = [mark for mark in self.marks if mark > token.start()]
                return end
        is_erratum = name.lower().startswith("errat") or _ERRATUM.match(self.visible, token.end()) is not None
        self.regions.append(_Region(name, is_erratum))
        return token.end()

    def _leave(self, name: str) -> None:
        while self.regions and any(region.name == name for region in self.regions):
            if self.regions.pop().name == name:
                return


def _find(text: str, pattern: str, begin: int, end: int) -> int:
    found = re.compile(pattern).search(text, begin, end)
    return found.start() if found else -1


def _with_context(table: Table, line: int, erratum: bool, section: str) -> Table:
    return Table(line, table.header, table.rows, erratum, None, section, table.pieces)
