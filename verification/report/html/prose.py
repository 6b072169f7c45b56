"""Words that hold formulas, as HTML: section titles with `$…$`, messages that quote LaTeX, names such as theta_1."""

from __future__ import annotations

import re
from functools import lru_cache

from markdown_it import MarkdownIt
from markdown_it.token import Token
from markupsafe import Markup, escape
from mdit_py_plugins.dollarmath import dollarmath_plugin

from armproof.verification.errors import ReadError
from armproof.verification.latex.mathml.display import pieces, write_display
from armproof.verification.latex.mathml.writer import Read
from armproof.verification.latex.plain import plain_text
from armproof.verification.latex.reader import key_as_latex
from armproof.verification.verdict import Record

# words of a formula side by side: each holds a script or a command, or is a number or a sign between such
_MATHS = r"(?=\S*[\\_^])[-+(\[{\\\w](?:[^\s,;:]|[,;:](?=\S))*(?<![,;:.])|[-+*/=]|\d+(?:\.\d+)?"
_FORMULA = re.compile(rf"(?<!\S)(?:{_MATHS})(?: (?:{_MATHS}))*(?![^\s,;:.])")
_QUOTED = re.compile(r"'([^']*\\[^']*)'")
_INLINE = 14.0  # em of a formula within words, which wraps where it is wider
_SYMBOL = re.compile(r"\b(?:theta|alpha|[A-Za-z])_(?:\d+|[a-z])\b")


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


def message(record: Record, read: Read) -> Markup:
    """Return a record's message as HTML: the terms it quotes from the display as MathML, what looks like a name too."""
    terms = {term for entry in record.entries for term in (entry.printed, entry.correct) if len(term) > 1}
    pattern = "|".join(re.escape(term) for term in sorted(terms, key=len, reverse=True))
    parts = re.split(f"({pattern})", record.message) if pattern else [record.message]
    done = (math(part, read) if part in terms else names_in(part, read) for part in parts if part)
    return Markup("").join(done)


def names_in(text: str, read: Read) -> Markup:
    """Return words as HTML, the formulas and names that stand among them (-l_2 S_{12}, theta_1, {}^0T_4) as MathML."""
    parts: list[Markup] = []
    end = 0
    for found in _FORMULA.finditer(text):
        if not re.search(r"[_^\\]", found.group()):
            continue
        parts += [_plain(text[end : found.start()]), math(_as_latex(found.group()), read)]
        end = found.end()
    return Markup("").join([*parts, _plain(text[end:])])


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
