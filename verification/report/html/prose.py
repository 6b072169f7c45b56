"""Words that hold formulas, as HTML: section titles with `$…$`, messages that quote LaTeX, names such as theta_1."""

from __future__ import annotations

import re
from collections.abc import Sequence
from functools import lru_cache
from itertools import groupby

from markdown_it import MarkdownIt
from markdown_it.token import Token
from markupsafe import Markup, escape
from mdit_py_plugins.dollarmath import dollarmath_plugin

from armproof.models.language import look_up
from armproof.verification.errors import ReadError
from armproof.verification.findings import Finding
from armproof.verification.findings.finding import Piece, distinct
from armproof.verification.findings.finding import pieces as pieces_of
from armproof.verification.latex.mathml.display import pieces, write_display
from armproof.verification.latex.mathml.writer import Read
from armproof.verification.latex.plain import plain_text
from armproof.verification.latex.reader import key_as_latex
from armproof.verification.patterns import regex

_QUOTED = regex(r"'([^']*\\[^']*)'")
_INLINE = 14.0  # em of a formula within words, which wraps where it is wider
_SYMBOL = regex(r"\b(?:theta|alpha|[A-Za-z])_(?:\d+|[a-z])\b")


def math(latex: str, read: Read) -> Markup:
    """Return LaTeX as inline MathML; as plain text where it cannot be read."""
    try:
        lines = write_display(latex, read, widest=_INLINE)
    except ReadError:
        return escape(plain_text(latex))
    return Markup(" ").join(Markup(f"<math>{piece.markup}</math>") for piece in pieces(lines))


def title(text: str, read: Read) -> Markup:
    """Return a title in inline Markdown as HTML: its formulas as MathML, its emphasis, links and code as plain words."""
    parts: list[Markup] = []
    for token in _inline(text):
        if token.type.startswith("math_inline"):
            parts.append(math(token.content, read))
        elif token.type in ("softbreak", "hardbreak"):
            parts.append(Markup(" "))
        elif token.content:
            parts.append(escape(_without_commands(token.content)))
    return Markup("").join(parts)


def plain_title(text: str) -> str:
    """Return a title as plain text, for the name of a page or a label."""
    return "".join(plain_text(t.content) if t.type.startswith("math") else t.content for t in _inline(text))


def message(findings: Sequence[Finding], read: Read) -> Markup:
    """Return findings as HTML: their formulas as MathML, a command that they quote as code."""
    return Markup(look_up("; ")).join(_finding(finding, read) for finding in distinct(findings))


def _finding(finding: Finding, read: Read) -> Markup:
    parts: list[Markup] = []
    for is_words, group in groupby(pieces_of(finding), key=lambda piece: piece[1] is Piece.WORDS):
        if is_words:
            parts.append(_plain("".join(text for text, _ in group)))
        else:
            parts += [math(text, read) if kind is Piece.LATEX else symbol(text, read) for text, kind in group]
    return Markup("").join(parts)


def _plain(text: str) -> Markup:
    """Return words as HTML; a command that they quote is code."""
    parts = _QUOTED.split(text)
    return Markup("").join(
        Markup("<code>{}</code>").format(part) if k % 2 else escape(_without_commands(part))
        for k, part in enumerate(parts)
    )


def symbols_in(text: str, read: Read) -> Markup:
    """Return a card's words as HTML, the symbols in them (theta_2, z_6) as MathML."""
    parts: list[Markup] = []
    end = 0
    for found in _SYMBOL.finditer(text):
        parts += [escape(text[end : found.start()]), symbol(found.group(), read)]
        end = found.end()
    return Markup("").join([*parts, escape(text[end:])])


def symbol(name: str, read: Read) -> Markup:
    """Return a model's symbol, such as theta_1 or "dot theta_1", as MathML."""
    return math(_as_latex(name), read)


def _as_latex(name: str) -> str:
    dots = name.count("dot ")
    bare = key_as_latex(_braced(name.replace("dot ", "")))
    return f"\\{'d' * dots}ot{{{bare}}}" if dots else bare


def _braced(name: str) -> str:
    """Brace the scripts of a canonical name: {}^i-1T_i → {}^{i-1}T_i, alpha_i-1 → alpha_{i-1}."""
    return re.sub(r"([_^])(\w[-+]\d|\w+(?:,\w+(?:_\w+)?)+)", r"\1{\2}", name)


def _without_commands(text: str) -> str:
    """Return text in which no LaTeX command is left; white space at its ends counts."""
    if "\\" not in text and "$" not in text:
        return text
    before, after = text[: len(text) - len(text.lstrip())], text[len(text.rstrip()) :]
    return f"{before}{plain_text(text)}{after}"


@lru_cache(maxsize=512)
def _inline(text: str) -> tuple[Token, ...]:
    blocks = _markdown().parseInline(text)
    return tuple(blocks[0].children or ()) if blocks else ()


@lru_cache(maxsize=1)
def _markdown() -> MarkdownIt:
    return MarkdownIt("commonmark").use(dollarmath_plugin, double_inline=True)
