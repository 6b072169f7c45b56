"""Python as HTML: the few kinds of words that help to read it, each a class; no style and no script in it."""

from __future__ import annotations

import re
from collections.abc import Iterable
from itertools import groupby

from markupsafe import Markup, escape

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
