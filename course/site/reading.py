"""The Markdown of a lesson as blocks: with the verdicts of its displays, links between lessons, and tasks' questions."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from pathlib import Path
from urllib.parse import unquote

from markdown_it.token import Token

from armproof.course.sheet.body import Body
from armproof.course.sheet.editions import is_solution, with_solutions
from armproof.course.sheet.inline import InlineReader
from armproof.course.sheet.model import Block, Heading, Inline, Link, Paragraph, Styled, Text, with_inner
from armproof.course.sheet.reading import BlockReader
from armproof.course.site.cells import Cell
from armproof.models.arm import Arm
from armproof.models.catalogue import arm_of
from armproof.models.language import ENGLISH
from armproof.verification.document import Document
from armproof.verification.latex.mathml.writer import Read
from armproof.verification.naming.reading import read_names
from armproof.verification.verdict import DocumentResult, Record, Verdict

_LESSON = re.compile(r"(?:\.\./)?(?:\./)?(?:\w+/)?(?P<stem>(?:\d\d_)?[a-z]\w*)(?:\.ipynb|\.py|\.html)?(?P<at>#[\w-]+)?")


_NUMBER = re.compile(r"(?<![\w])(?:[Ll]esson|[Ll]eçon)[ \u00a0](\d+)\b")


def unlinked(parts: Iterable[Inline]) -> tuple[Inline, ...]:
    """Return inline parts without their links, the words of which stay."""
    found: list[Inline] = []
    for part in parts:
        found += unlinked(part.parts) if isinstance(part, Link) else [part]
    return tuple(found)


class LessonInline(InlineReader):
    """Reads inline Markdown; a link to another lesson, and "lesson 9" in its words, lead to the page of that lesson."""

    def __init__(self, read: Read, folder: Path, pages: Mapping[str, str], lang: str) -> None:
        super().__init__(read, folder, lang)
        self.pages = pages

    def _leaf(self, token: Token) -> Iterable[Inline]:
        for part in super()._leaf(token):
            if isinstance(part, Text):
                yield from self._linked(part.text)
            else:
                yield part

    def _linked(self, text: str) -> Iterable[Inline]:
        end = 0
        for found in _NUMBER.finditer(text):
            if (page := self.pages.get(found.group(1))) is not None:
                yield Text(text[end : found.start()])
                yield Link(page, (Text(found.group()),))
                end = found.end()
        yield Text(text[end:])

    def _enclosed(self, opening: Token, inside: tuple[Inline, ...]) -> Iterable[Inline]:
        found = _LESSON.fullmatch(unquote(str(opening.attrGet("href") or ""))) if opening.type == "link_open" else None
        page = self.pages.get(found.group("stem")) if found is not None else None
        if found is None or page is None:
            yield from super()._enclosed(opening, unlinked(inside) if opening.type == "link_open" else inside)
        else:
            yield Link(f"{page}{found.group('at') or ''}", unlinked(inside))


class LessonReader:
    """Reads the Markdown cells of one lesson in their order, and the questions of its tasks.

    Attributes:
        arm: the lesson's arm, or None.
        read: reads LaTeX with the lesson's letters.
        warnings: what of the lesson is not shown.
    """

    def __init__(
        self, document: Document, result: DocumentResult, pages: Mapping[str, str], solutions: bool, lang: str = ENGLISH
    ) -> None:
        self.arm: Arm | None = arm_of(document.front, document.path.parent)
        self.read: Read = read_names(self.arm, document.front).reader.read
        self.inline = LessonInline(self.read, document.path.parent, pages, lang)
        self.solutions = solutions
        self.result = result
        self._blocks = BlockReader(self.inline, result)

    @property
    def warnings(self) -> list[str]:
        """What of the lesson is not shown, and why."""
        return self._blocks.warnings

    def cell(self, cell: Cell) -> tuple[Block, ...]:
        """Return the blocks of a Markdown cell, its worked solutions as quotes, or left out."""
        blocks = with_solutions(self._blocks.read(Body(cell.source, cell.line, cell.number)))
        return blocks if self.solutions else _without_solutions(blocks)

    def text(self, text: str) -> tuple[Block, ...]:
        """Return the blocks of a question, a hint or an output: its displays are no claims, its headings none of the page."""
        empty = DocumentResult(self.result.path, self.result.arm, ())
        return tuple(
            Paragraph((Styled("strong", block.parts),)) if isinstance(block, Heading) else block
            for block in _QuestionReader(self.inline, empty).read(Body(text))
        )

    def close(self) -> None:
        """Raise PrintError where a display that was checked is not on the page."""
        self._blocks.close()


def _without_solutions(blocks: Iterable[Block]) -> tuple[Block, ...]:
    return tuple(with_inner(block, _without_solutions) for block in blocks if not is_solution(block))


class _QuestionReader(BlockReader):
    """Reads Markdown whose displays have no verdicts."""

    def _display(self, latex: str | None) -> Block:
        return self._written(Record(self.body.first, latex or "", Verdict.DEFINED, cell=self.body.cell))
