"""The blocks of a lesson as HTML for a screen: headings that can be linked to, and what is wide takes the keyboard's focus."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass
from itertools import groupby
from unicodedata import combining, normalize

from markupsafe import Markup, escape

from armproof.course.sheet import model as s
from armproof.course.sheet.html import NARROW, HtmlWriter
from armproof.course.site.reading import unlinked
from armproof.models.language import look_up, spoken

_KINDS = (  # of Pygments, the first that holds; the others are plain
    ("Comment", "comment"),
    ("Literal.String", "string"),
    ("Literal.Number", "number"),
    ("Keyword", "keyword"),
    ("Operator.Word", "keyword"),
    ("Name.Function", "name"),
    ("Name.Class", "name"),
    ("Name.Decorator", "name"),
)
_MARKERS = re.compile(r"^[ \t]*### (?:BEGIN|END) SOLUTION[ \t]*\n?", re.MULTILINE)
_LONGEST = 60  # characters of an anchor


def highlight(source: str) -> Markup:
    """Return Python source as the inside of a <code> element, without the lines that mark a solution."""
    parts = []
    for kind, words in groupby(_words(_MARKERS.sub("", source).strip("\n")), key=lambda pair: pair[0]):
        text = "".join(word for _, word in words)
        parts.append(Markup('<span class="py-{}">{}</span>').format(kind, text) if kind else escape(text))
    return Markup("").join(parts)


def _words(source: str) -> Iterable[tuple[str, str]]:
    from pygments.lexers.python import PythonLexer  # type: ignore[import-untyped]

    lexer = PythonLexer(stripnl=False, ensurenl=False)
    for token, word in lexer.get_tokens(source):
        name = str(token).removeprefix("Token.")
        yield next((kind for prefix, kind in _KINDS if name.startswith(prefix)), ""), word


@dataclass(frozen=True)
class Entry:
    """A heading in the contents of a page."""

    level: int
    anchor: str
    title: Markup
    is_part: bool = False  # no heading of the lesson's own: a task


class PageWriter(HtmlWriter):
    """Writes the blocks of one page; `contents` collects its headings."""

    def __init__(self) -> None:
        super().__init__(spoken())
        self.contents: list[Entry] = []
        self._anchors: set[str] = {"main", "objectives", "reference"}  # which the page has
        self._level = 1
        self.blocks[s.Listed] = self._listed

    def heading(self, level: int, words: Markup, plain: str) -> Markup:
        """Return a heading with an anchor; no level is left out."""
        self._level = min(6, max(2, level), self._level + 1)
        anchor = self._anchor(plain)
        self.contents.append(Entry(self._level, anchor, words))
        return Markup('<h{0} id="{1}">{2}</h{0}>').format(self._level, anchor, words)

    def section(self, anchor: str, words: Markup) -> str:
        """Return the anchor of a part of the page, which stands in the contents unless the heading before it is its own."""
        anchor = self._anchor(anchor)
        headed = self.contents and self.contents[-1].level > 2 and self.contents[-1].title.startswith(look_up("Task"))
        if not headed or self.contents[-1].is_part:
            self.contents.append(Entry(3, anchor, words, is_part=True))
        return anchor

    def _heading(self, block: s.Heading) -> Markup:
        return self.heading(block.level, self.words(unlinked(block.parts)), s.plain(block.parts))

    def _quote(self, block: s.Quote) -> Markup:
        if block.kind == "solution":
            inside = block.blocks[1:] if isinstance(block.blocks[0], s.Heading) else block.blocks
            return Markup('<details class="solution"><summary>{}</summary>{}</details>').format(look_up("Solution"), self.body(inside))  # fmt: skip
        return super()._quote(block)

    def _part(self, part: s.Inline) -> Markup:
        written = super()._part(part)
        if isinstance(part, s.Formula) and any(piece.width > NARROW for piece in part.pieces):
            return Markup('<span class="long" tabindex="0" role="group" aria-label="{}">{}</span>').format(look_up("Formula"), written)  # fmt: skip
        return written

    def _listed(self, block: s.Listed) -> Markup:
        return listing(Markup.escape(block.text.strip("\n")), look_up("Listing"))

    def _anchor(self, plain: str) -> str:
        bare = "".join(c for c in normalize("NFKD", plain.lower()) if not combining(c))
        stem = re.sub(r"[^a-z0-9]+", "-", bare).strip("-")[:_LONGEST].strip("-") or "section"
        name, number = stem, 2
        while name in self._anchors:
            name, number = f"{stem}-{number}", number + 1
        self._anchors.add(name)
        return name


def python(source: str, label: str = "Python") -> Markup:
    """Return Python source as a listing."""
    return listing(highlight(source), label)


def listing(code: Markup, label: str) -> Markup:
    """Return lines of code as a block that can be scrolled by the keyboard."""
    return Markup('<pre class="code" tabindex="0" role="group" aria-label="{}"><code>{}</code></pre>').format(
        label, code
    )
