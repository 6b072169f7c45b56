r"""Formulas that a text shows as pictures: <img src="https://latex.codecogs.com/gif.latex?p_x&space;=&space;l_1c_1"> has its LaTeX in its address."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from urllib.parse import unquote, unquote_plus

from markdown_it.token import Token

from armproof.verification.patterns import regex

_PAIRS = r"(?:[\w-]+=[^&]*&(?:amp;)?)*?"
_ADDRESS = regex(  # what follows the ? is all LaTeX, or one value of several
    rf"https?://(?:(?:latex\.codecogs\.com/[\w./]*\?|(?:tex\.s2cms\.ru|i\.upmath\.me)/(?:svg|png)/)(?P<all>.*)"
    rf"|(?:render\.githubusercontent\.com/render/math\?{_PAIRS}math|(?:chart\.googleapis|chart\.apis\.google)\.com/chart\?{_PAIRS}chl"
    rf"|(?:www\.)?zhihu\.com/equation\?{_PAIRS}tex|math\.now\.sh/?\?{_PAIRS}from)=(?P<one>[^&]*).*)",
    re.DOTALL,
)
_OPTIONS = regex(
    r"\s*\\(?:inline|dpi\s*\{\d+\}|(?:bg|fn)_\w+|bg\s*\{\w+\}|(?:tiny|small|normal|large|Large|LARGE|huge)(?![A-Za-z]))\s*"
)
_ENTITIES = {"space": " ", "nbsp": " ", "plus": "+", "amp": "&", "lt": "<", "gt": ">", "quot": '"', "hash": "#"}
_ENTITY = regex(rf"&({'|'.join(_ENTITIES)});")
_PICTURE = regex(r"<img\b[^>]*?\bsrc\s*=\s*(?:\"([^\"]*)\"|'([^']*)')[^>]*>", re.IGNORECASE | re.DOTALL)
_NO_TEXT = ("image", "html_inline", "link_open", "link_close")
_TAG = regex(r"<[^<>]*>")


def latex_of(address: str) -> str:
    """Return the LaTeX that an address of a picture shows, "" where it is that of another picture."""
    found = _ADDRESS.fullmatch(address.strip())
    if found is None:
        return ""
    latex = (
        unquote(_ENTITY.sub(lambda each: _ENTITIES[each[1]], found["all"]))
        if found["all"]
        else unquote_plus(found["one"] or "")
    )
    while option := _OPTIONS.match(latex):
        latex = latex[option.end() :]
    return " ".join(latex.split())


def formulas_in_html(html: str) -> Iterator[tuple[int, str, bool]]:
    """Yield the formulas that pictures of a piece of HTML show: the line in it (from 0), the LaTeX, and whether that line has no text."""
    lines = html.split("\n")
    for found in _PICTURE.finditer(html):
        if latex := latex_of(found[1] or found[2] or ""):
            number = html.count("\n", 0, found.start())
            yield number, latex, not _TAG.sub("", lines[number] if found[0] in lines[number] else "").strip()


def formulas_in_line(tokens: Sequence[Token]) -> Iterator[tuple[int, str, bool]]:
    """Yield those of an inline text's tokens: how many lines stand before, the LaTeX, and whether that line has no text."""
    lines: list[list[Token]] = [[]]
    for token in tokens:
        lines.append([]) if token.type in ("softbreak", "hardbreak") else lines[-1].append(token)
    for number, line in enumerate(lines):
        alone = all(token.type in _NO_TEXT or not token.content.strip() for token in line)
        for token in line:
            yield from ((number, latex, alone) for latex in _shown_by(token))


def _shown_by(token: Token) -> list[str]:
    if token.type == "image":
        return [latex] if (latex := latex_of(str(token.attrs.get("src", "")))) else []
    return [latex for _, latex, _ in formulas_in_html(token.content)] if token.type == "html_inline" else []


def shows_its_latex(picture: str) -> bool:
    """Whether a picture, as a text has it, has its LaTeX in its address."""
    return _ADDRESS.search(picture) is not None
