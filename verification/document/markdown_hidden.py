r"""What a Markdown text holds and does not show, besides the comments of HTML: it is blank, and every other character at its place.

Elements of HTML that are hidden, MyST's lines that begin with %, Obsidian's %% … %%, Jekyll's and Hugo's comments and tags: {% include figure.html %}.
Nothing is hidden in code.
"""

from __future__ import annotations

import re
from bisect import bisect_left
from collections.abc import Iterator

from armproof.verification.document.tex_macros import blank
from armproof.verification.patterns import regex

_FENCE = regex(r"[ \t>]{0,12}(?P<fence>`{3,}|~{3,})[ \t]*(?P<info>[^\n`]*)$")
_DIRECTIVE = regex(r"\{(?!code|math)[\w:-]+\}")
_HIDDEN_TAG = regex(
    r"(?<!`)<(?P<name>[a-z][a-z0-9]*)(?=\s)(?:[^<>\"']|\"[^\"]*\"|'[^']*')*?"
    r"(?:\sstyle\s*=\s*(?:\"[^\"<>]*(?:display\s*:\s*none|visibility\s*:\s*hidden)[^\"<>]*\"|'[^'<>]*(?:display\s*:\s*none|visibility\s*:\s*hidden)[^'<>]*')|\shidden(?=[\s>=]))"
    r"(?:[^<>\"']|\"[^\"]*\"|'[^']*')*>",
    re.IGNORECASE,
)
_COMMENTS = regex(
    r"\{%-?\s*comment\s*-?%\}.*?\{%-?\s*endcomment\s*-?%\}|\{\{[<%]\s*comment\s*[%>]\}\}.*?\{\{[<%]\s*/comment\s*[%>]\}\}"
    r"|^[ ]{0,3}%%(?!%)(?:(?!%%).)*%%[ \t]*$"  # on lines of its own
    r"|(?<![`%\\])%%(?![%`])(?:(?!%%)[^\n])+%%(?![%`])",  # in a line
    re.DOTALL | re.MULTILINE,
)
_TAGS = regex(  # no sentence: what it puts there is not known
    r"\{%-?\s*[a-z]\w*\b(?:(?!%\}|[$\\]).)*%\}|\{\{<\s*/?[a-z][\w/-]*(?:(?!>\}\}|[$\\]).)*>\}\}|\{\{%\s*/?[a-z][\w/-]*(?:(?!%\}\}|[$\\]).)*%\}\}"
    r"|^[ \t]*\{\{-?\s*[a-z][\w.]*(?:\s*\|[^{}$\\\n]*)?\s*-?\}\}[ \t]*$",
    re.DOTALL | re.MULTILINE,
)
_LINE = regex(r"(?:\A|(?<=\n))(?P<before>[ \t]*\n|\A)(?P<lines>(?:%(?!%)[^\n]*(?:\n|\Z))+)")


def without_hidden(body: str) -> str:
    """Return a text with what it does not show blank."""
    if not any(mark in body for mark in ("%", "{{")) and not any(each in body.lower() for each in ("hidden", "none")):
        return body
    shown = list(body)
    searched = body
    for begin, end in _code(body):
        searched = searched[:begin] + blank(searched[begin:end]) + searched[end:]
    for begin, end in _hidden(searched):
        shown[begin:end] = blank(body[begin:end])
    return "".join(shown)


def _hidden(text: str) -> Iterator[tuple[int, int]]:
    for found in _HIDDEN_TAG.finditer(text):
        if (end := _end_of(found["name"], text, found.end())) is not None:
            yield found.start(), end
    dollars = [found.start() for found in re.finditer(r"\$\$", text)]
    for found in (*_COMMENTS.finditer(text), *_TAGS.finditer(text)):
        if bisect_left(dollars, found.start()) % 2 == 0:  # within a display % is TeX's
            yield found.span()
    yield from (found.span("lines") for found in _LINE.finditer(text))


def _end_of(name: str, text: str, begin: int) -> int | None:
    """Return where an element ends; None where it never does."""
    depth = 1
    for found in re.compile(rf"<(?P<close>/?){name}(?=[\s>/])[^<>]*>", re.IGNORECASE).finditer(text, begin):
        depth += -1 if found["close"] else 1
        if depth == 0:
            return found.end()
    return None


def _code(body: str) -> Iterator[tuple[int, int]]:
    """Yield where code stands between fences; what stands in a directive is text."""
    inside: list[str] = []  # the fences of the directives around
    fence, begin, at = "", 0, 0
    for line in body.split("\n"):
        found = _FENCE.match(line)
        mark = found["fence"] if found is not None else ""
        closes = found is not None and not found["info"].strip()
        if fence:
            if closes and mark.startswith(fence):
                yield begin, at + len(line)
                fence = ""
        elif closes and inside and mark.startswith(inside[-1]):
            inside.pop()
        elif found is not None and _DIRECTIVE.match(found["info"]):
            inside.append(mark)
        elif mark:
            fence, begin = mark, at
        at += len(line) + 1
    if fence:
        yield begin, len(body)
