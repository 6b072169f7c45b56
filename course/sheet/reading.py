"""Read a checked document into the blocks of a sheet, each display and each table with its verdict.

The Markdown is read by the reader that the verification uses, in the same order: the k-th display on the sheet is the
k-th record, and one whose LaTeX is not the record's is an error. So nothing is printed that was not checked.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import replace
from pathlib import Path

from markdown_it.token import Token
from markdown_it.tree import SyntaxTreeNode

from armproof.course.errors import PrintError
from armproof.course.sheet.body import Body
from armproof.course.sheet.inline import InlineReader
from armproof.course.sheet.model import (
    Block,
    Display,
    Heading,
    Inline,
    Listed,
    Listing,
    Paragraph,
    Picture,
    Quote,
    Rule,
    Table,
    Text,
    plain,
)
from armproof.course.sheet.numbers import Numbers, tag_of
from armproof.course.sheet.pictures import find_picture
from armproof.verification.correction import edits
from armproof.verification.document import Display as Source
from armproof.verification.document.markdown import ADMONITIONS, display_reader, without_labels
from armproof.verification.errors import ReadError
from armproof.verification.latex.mathml.display import write_display
from armproof.verification.latex.mathml.marks import WRONG
from armproof.verification.latex.mathml.writer import WIDEST
from armproof.verification.latex.unicode import normalise_unicode
from armproof.verification.tables.check import read_array
from armproof.verification.verdict import DocumentResult, Record, Verdict

_DIRECTIVE = re.compile(r"\s*\{?\s*\.?(?P<name>[\w:-]*)\}?\s*(?P<title>[^\n]*)")
_ERRATUM = re.compile(r"[#*_\s]*errat(?:um|a)\b", re.IGNORECASE)
_SOLUTION = re.compile(r"[#*_\s]*(?:worked\s+)?(?:solution|corrigé)s?\b", re.IGNORECASE)
_SOLUTION_HEADING = re.compile(r"(?:worked )?(?:solution|corrigé)s?(?: *\d[\w.]*)?(?: *[.:–—-].*)?", re.IGNORECASE)
_MATRIX = 64.0  # em beyond which a matrix's cells are broken into lines: one a little too wide is made smaller instead
_COMMENT = re.compile(r"<!--.*?-->", re.DOTALL)
_OWN = re.compile(r"<!--\s*own\s*-->")  # what the source does not have: the display or table below it, or the section


class BlockReader:
    """Reads the Markdown of one document; without `numbers` displays have those of their authors alone.

    `warnings` collects what of it is not printed.
    """

    def __init__(self, inline: InlineReader, result: DocumentResult, numbers: Numbers | None = None) -> None:
        self.inline = inline
        self.path = Path(result.path)
        self.records = iter(result.equations)
        self.numbers = numbers or Numbers(tuple(map(tag_of, result.equations)))
        self.left = iter(self.numbers.of_displays)
        self.tables = {(record.line, record.cell): record for record in result.tables}
        self.warnings: list[str] = []
        self.body = Body("")
        self.next_is_own = False
        self.own_level = 0  # of the heading whose whole section is the document's own; 0: none

    def read(self, body: Body) -> list[Block]:
        """Return the blocks of a Markdown text.

        Raises:
            PrintError: a display has no verdict of its own.
        """
        self.body = body
        tree = SyntaxTreeNode(display_reader().parse(without_labels(self.numbers.referred(body.text))))
        return list(self._blocks(tree.children))

    def close(self) -> None:
        """Raise PrintError where a verdict has no display on the sheet."""
        left = next(self.records, None)
        if left is not None:
            raise PrintError("{path}:{line}: this display was checked, and would not be on the sheet", path=self.path, line=left.line)  # fmt: skip

    # -- blocks -----------------------------------------------------------------------------------------------------

    def _blocks(self, nodes: Iterable[SyntaxTreeNode]) -> Iterator[Block]:
        for node in nodes:
            yield from self._block(node)

    def _block(self, node: SyntaxTreeNode) -> Iterator[Block]:
        if node.type == "heading":
            yield self._heading(node)
        elif node.type == "paragraph":
            yield from self._paragraph(node)
        elif node.type in ("math_block", "math_block_label", "amsmath"):
            yield from (self._display(part) for part in node.content.split("$$")[::2])
        elif node.type == "blockquote":
            yield self._quote(list(self._blocks(node.children)), _first_words(node))
        elif node.type in ("bullet_list", "ordered_list"):
            yield self._list(node)
        elif node.type == "table":
            yield self._table(node)
        elif node.type in ("fence", "colon_fence"):
            yield from self._fence(node)
        elif node.type == "code_block":
            yield Listed(node.content)
        elif node.type == "hr":
            yield Rule()
        elif node.type == "html_block":
            yield from self._html(node)

    def _paragraph(self, node: SyntaxTreeNode) -> Iterator[Block]:
        """Yield the paragraph, the displays and pictures in it on lines of their own."""
        words: list[Token] = []
        for token in _tokens(node):
            if token.type == "math_inline_double":
                yield from self._words(words, leads=True)
                yield self._display(token.content)
            elif token.type == "image":
                yield from self._words(words)
                yield from self._picture(token, node)
            elif token.type == "text" and "$$" in token.content:  # opened and never closed: what follows was not read
                before = token.content[: token.content.index("$$")]
                yield from self._words([*words, Token("text", "", 0, content=before)])
                yield self._display(None)
                return
            else:
                words.append(token)
                continue
            words = []
        yield from self._words(words)

    def _heading(self, node: SyntaxTreeNode) -> Heading:
        level = int(node.tag[1:])
        if level <= self.own_level:
            self.own_level = 0
        if self.next_is_own:
            self.own_level, self.next_is_own = level, False
        return Heading(level, self.inline.parts(_tokens(node)))

    def _own(self) -> bool:
        """Whether the display or table that is read is the document's own."""
        own, self.next_is_own = self.next_is_own or self.own_level > 0, False
        return own

    def _words(self, tokens: list[Token], *, leads: bool = False) -> Iterator[Block]:
        parts = self.inline.parts(tokens)
        if parts and not all(isinstance(part, Text) and not part.text.strip() for part in parts):
            ending = parts[-1].text.rstrip() if isinstance(parts[-1], Text) else "x"
            yield Paragraph(parts, leads or not ending.endswith((".", "!", "?", ".)")))

    def _quote(self, blocks: list[Block], words: str) -> Quote:
        kinds = (("erratum", _ERRATUM), ("solution", _SOLUTION))
        kind = next((kind for kind, pattern in kinds if pattern.match(words)), "plain")
        return Quote(kind, tuple(blocks))  # type: ignore[arg-type]

    def _list(self, node: SyntaxTreeNode) -> Listing:
        items = tuple(tuple(self._blocks(item.children)) for item in node.children)
        return Listing(items, int(node.attrs.get("start", 1)) if node.type == "ordered_list" else None)

    def _fence(self, node: SyntaxTreeNode) -> Iterator[Block]:
        found = _DIRECTIVE.match(node.info)
        name, title = (found.group("name"), found.group("title")) if found else ("", "")
        if name == "math":
            record = next(self.records, None)
            if record is None or record.latex.strip() not in node.content:
                raise PrintError("{place}: this display was not checked", place=self._place(node))
            yield self._written(record)
        elif node.type == "colon_fence" or name in ADMONITIONS:
            blocks = self._inside(node)
            heading = [Paragraph((Text(title.strip(" {}")),))] if title.strip(" {}") else []
            words = f"{name if _ERRATUM.match(name) else title} {node.content}".strip()
            yield self._quote([*heading, *blocks], words)
        else:
            yield Listed(node.content)

    def _inside(self, node: SyntaxTreeNode) -> list[Block]:
        """Return the blocks in a directive, whose lines are counted from that of its opening."""
        outer = self.body
        self.body = replace(outer, first=self._line(node) + 1, lines=())
        blocks = list(self._blocks(SyntaxTreeNode(display_reader().parse(node.content)).children))
        self.body = outer
        return blocks

    def _html(self, node: SyntaxTreeNode) -> Iterator[Block]:
        self.next_is_own = self.next_is_own or _OWN.search(node.content) is not None
        text = _COMMENT.sub("", node.content)
        if "$$" in text:
            yield self._display(None)
        elif text.strip():
            self.warnings.append(f"{self._place(node)}: HTML is not printed; write it in Markdown")

    def _picture(self, token: Token, node: SyntaxTreeNode) -> Iterator[Block]:
        target = str(token.attrGet("src") or "")
        caption = self.inline.parts(token.children or ())
        found = find_picture(target, self.path.parent)
        if isinstance(found, Path):
            yield Picture(found, None, caption)
            return
        self.warnings.append(f"{self._place(node)}: the picture '{target[:80]}' is not printed: {found}")
        if caption:
            yield Paragraph((Text("["), *caption, Text("]")))

    def _place(self, node: SyntaxTreeNode) -> str:
        line, cell = self._line(node), self.body.cell
        return f"{self.path}:{line}" if cell is None else f"{self.path}: cell {cell}, line {line}"

    def _line(self, node: SyntaxTreeNode) -> int:
        return self.body.line(node.map[0] if node.map else 0)

    # -- mathematics ------------------------------------------------------------------------------------------------

    def _display(self, latex: str | None) -> Block:
        """Return the next display with its verdict; `latex` is None where the display never ends."""
        record = next(self.records, None)
        if record is None or (latex is not None and _squeezed(latex) != _squeezed(record.latex)):
            shown = " ".join((latex or "").split())[:60]
            raise PrintError("{path}: the display '{shown}' has no verdict, so it is not printed", path=self.path, shown=shown)  # fmt: skip
        return self._written(record)

    def _written(self, record: Record) -> Block:
        number = next(self.left, "") or tag_of(record)
        own = self._own() and not record.erratum
        if record.verdict is Verdict.UNREADABLE:
            return Display((), record, number, own)
        spans = [entry.span for entry in record.entries if entry.span is not None] or [
            (len(normalise_unicode(record.latex[: edit.start])), len(normalise_unicode(record.latex[: edit.end])))
            for edit in edits(record)
        ]
        try:
            widest = _MATRIX if "\\begin" in record.latex else WIDEST
            lines = write_display(record.latex, self.inline.read, spans, WRONG if spans else None, widest)
        except ReadError:
            array = read_array(Source(record.line, record.latex))
            if array is None:
                return Display((), record, number, own)
            cells = [
                tuple((self.inline.formula(cell),) for cell in row) for row in (array.table.header, *array.table.rows)
            ]
            return Table(cells[0], tuple(cells[1:]), ("center",) * len(cells[0]), record, own)
        spoken = tuple(tuple(tuple(map(self.inline.in_words, each)) for each in line) for line in lines)
        return Display(spoken, record, number, own)

    def _table(self, node: SyntaxTreeNode) -> Table:
        rows: list[tuple[tuple[Inline, ...], ...]] = []
        columns: tuple[str, ...] = ()
        for part in node.children:
            for row in part.children:
                rows.append(tuple(self.inline.parts(_tokens(cell)) for cell in row.children))
                columns = columns or tuple(_alignment(cell) for cell in row.children)
        return Table(
            rows[0], tuple(rows[1:]), columns, self.tables.get((self._line(node), self.body.cell)), self._own()
        )


def _tokens(node: SyntaxTreeNode) -> list[Token]:
    """Return the flat inline tokens of a paragraph, a heading or a cell."""
    found: list[Token] = []
    for child in node.children:
        if child.type == "inline" and child.token is not None:
            found.extend(child.token.children or [])
    return found


def _first_words(node: SyntaxTreeNode) -> str:
    first = next((each for each in node.walk() if each.type in ("inline", "math_block")), None)
    return first.content if first is not None and first.type == "inline" else ""


def _alignment(cell: SyntaxTreeNode) -> str:
    found = re.search(r"text-align:\s*(left|center|right)", str(cell.attrs.get("style", "")))
    return found.group(1) if found else "auto"


def _squeezed(latex: str) -> str:
    return "".join(latex.split())


def opens_solution(parts: tuple[Inline, ...]) -> bool:
    """Whether a heading opens a worked solution: "Solution", "Solution 2", "Solution: the pose", "Corrigé"."""
    return _SOLUTION_HEADING.fullmatch(plain(parts).strip()) is not None
