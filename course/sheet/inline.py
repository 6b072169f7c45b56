"""The words of a document: inline Markdown, its formulas read with the letters of the document.

What is no text of the author's is not printed: HTML tags are dropped, a link is followed only to the network by whoever
reads the sheet, and a link to another document prints as that document's title.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path
from urllib.parse import unquote

from markdown_it.token import Token

from armproof.course.sheet.model import Break, Code, Formula, Inline, Link, Styled, Text, plain
from armproof.course.words import say
from armproof.models.errors import ArmproofError
from armproof.models.language import ENGLISH
from armproof.verification.document import SUFFIXES, read_document
from armproof.verification.document.catalogue import translated_sentence, translation_of
from armproof.verification.errors import ReadError
from armproof.verification.latex.mathml.box import Box
from armproof.verification.latex.mathml.display import pieces, write_display
from armproof.verification.latex.mathml.writer import Read
from armproof.verification.latex.plain import plain_text

_INLINE = 24.0  # em of a formula within words; a wider one may end a line at its relations
_SAFE = re.compile(r"(?:https?://|mailto:)[^\s\x00-\x1f]+", re.IGNORECASE)
_JOINED = re.compile(r"(?<=<mtext>\u2002)(?:or|and|if)(?=\u2002</mtext>)")
_STYLES = {"strong": "strong", "em": "emphasis"}


class InlineReader:
    """Reads inline tokens; `read` reads LaTeX with the document's letters, `folder` is the document's; `lang` its language."""

    def __init__(self, read: Read, folder: Path, lang: str = ENGLISH) -> None:
        self.read, self.folder, self.lang = read, folder, lang

    def parts(self, tokens: Iterable[Token]) -> tuple[Inline, ...]:
        """Return the parts of a flat list of inline tokens; images are left to whoever reads the block."""
        stack: list[tuple[Token | None, list[Inline]]] = [(None, [])]
        for token in tokens:
            if token.nesting == 1:
                stack.append((token, []))
            elif token.nesting == -1 and len(stack) > 1:
                opening, inside = stack.pop()
                if opening is not None:
                    stack[-1][1].extend(self._enclosed(opening, tuple(inside)))
            else:
                stack[-1][1].extend(self._leaf(token))
        return tuple(part for _, inside in stack for part in inside)

    def formula(self, latex: str) -> Formula | Text:
        """Return a formula within words; as plain text where it cannot be read."""
        try:
            return Formula(tuple(map(self.in_words, pieces(write_display(latex, self.read, widest=_INLINE)))))
        except ReadError:
            return Text(plain_text(latex))

    def in_words(self, box: Box) -> Box:
        """Return a formula with the English words that join statements (or, and, if) in the language of the sheet."""
        if self.lang == ENGLISH:
            return box
        return replace(box, markup=_JOINED.sub(lambda found: say(f"joined_{found[0]}", self.lang), box.markup))

    def _leaf(self, token: Token) -> Iterable[Inline]:
        if token.type == "math_inline":
            yield self.formula(token.content)
        elif token.type == "code_inline":
            title = self._title_of(token.content)
            yield from title or [Code(token.content)]
        elif token.type == "softbreak":
            yield Text(" ")
        elif token.type == "hardbreak" or (
            token.type == "html_inline" and re.match(r"<br\b", token.content, re.IGNORECASE)
        ):
            yield Break()
        elif token.type in ("text", "text_special", "image") and token.content:  # of a picture within words, its words
            yield Text(token.content)

    def _enclosed(self, opening: Token, inside: tuple[Inline, ...]) -> Iterable[Inline]:
        kind = opening.type.removesuffix("_open")
        if kind in _STYLES:
            yield Styled("strong" if kind == "strong" else "emphasis", inside)
        elif kind == "link":
            target = unquote(str(opening.attrGet("href") or ""))
            title = self._title_of(target) if plain(inside) in (target, Path(target).stem) else None
            if title is not None:
                yield from title
            elif _SAFE.fullmatch(target):
                yield Link(target, inside)
            else:
                yield from inside
        else:
            yield from inside

    def _title_of(self, target: str) -> tuple[Inline, ...] | None:
        """Return the title of a document beside this one, in italics; None where there is no such document."""
        if "/" in target or "\\" in target or "\0" in target or not target.endswith(SUFFIXES):
            return None
        try:
            path = self.folder / target
            title = read_document(path).front.get("title") if path.is_file() else None
        except (ArmproofError, OSError):
            return None
        if not isinstance(title, str):
            return None
        return (Styled("emphasis", (Text(translated_sentence(title, translation_of(path, self.lang))),)),)
