"""What a text strikes out, or puts into a box that says that it is wrong: the displays in there are denied."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import replace
from functools import lru_cache

from armproof.verification.document.cells import notebook_cells, percent_cells
from armproof.verification.document.denials import denies_within, is_not_to_copy
from armproof.verification.document.marked_wrong import MAY_MARK, marked_wrong
from armproof.verification.document.model import Document
from armproof.verification.patterns import regex

MAY_STRIKE = regex(  # what no text that strikes out or denies in a box lacks
    MAY_MARK.pattern
    + r"|<[a-z]|~~|\\(?:st|sout|xout)\b|\\begin\s*\{(?![bpvBV]?matrix|array|align|equation|cases)|^:::|^[ \t]*(?:===|!!!|\?\?\?)",
    re.MULTILINE,
)
MOST = 4000  # characters that are struck out or stand in a box: what is not closed is looked through no further
_TITLE = 120  # characters of what a box begins with
_INSIDE = rf".{{0,{MOST}}}?"
_STRUCK = regex(
    rf"<(?P<tag>del|s|strike)(?:\s[^<>\n]*)?>{_INSIDE}</(?P=tag)>|<(?P<any>span|div|p)\s[^<>\n]*line-through[^<>\n]*>{_INSIDE}</(?P=any)>|\\(?:st|sout|xout)\s*\{{{_INSIDE}(?<!\\)\}}(?=\s*(?:\\|\n|\Z))",
    re.DOTALL,
)
_STRUCK_IN_MARKDOWN = regex(rf"(?<![~\\])~~(?!~){_INSIDE}(?<![~\\])~~(?!~)", re.DOTALL)
_MATH = regex(r"\$\$.{0,4000}?\$\$|\\\[.{0,4000}?\\\]|\$(?=\S)[^$\n]{0,400}(?<=\S)\$", re.DOTALL)  # where ~ is a blank
_OPENS = regex(
    r"\\begin\s*\{(?P<name>[A-Za-z]+)\*?\}(?:\[(?P<option>[^\]\n]*)\])?"
    r"|<(?P<tag>div|section|aside|p)\s[^>\n]*class\s*=\s*[\"'](?P<class>[^\"'\n]*)[\"'][^>\n]*>"
    r"|<summary>(?P<summary>[^<\n]*)</summary>|^:::+[ \t]*(?P<words>[^\n]+)$"
    r"|^(?P<margin>[ \t]*)(?:===[+!]{0,2}|!!!|\?\?\?\+?)[ \t]+(?P<indented>[^\n]+)$",
    re.MULTILINE,
)
_FAILS = regex(r"(?:fail(?:ure)?|missing|bug|danger|error)\b")  # boxes of MkDocs, by their kind
_NO_CLAIM = regex(
    r"(?:counter-?examples?|contre-?exemples?|gegenbeispiele?|contraejemplos?|conjectures?|fallac(?:y|ies))",
    re.IGNORECASE,
)
_IN_MARKDOWN = frozenset([".md", ".qmd", ".rmd", ".markdown", ".ipynb", ".py"])


def with_struck_out(document: Document, text: str, suffix: str) -> Document:
    """Return a document whose displays know that they are struck out, stand in a box that denies them, or bear a mark that does."""
    texts = _texts(text, suffix)
    lines = {cell: [*_lines(each, suffix)] for cell, each in texts.items() if MAY_STRIKE.search(each)}
    may_mark = any(MAY_MARK.search(each) for each in texts.values())
    marked = {each.place for each in marked_wrong(document.displays, texts)} if may_mark else set()
    if not (any(lines.values()) or marked):
        return document
    displays = tuple(
        replace(each, denied=True)
        if not (each.erratum or each.file)
        and (each.place in marked or any(first <= each.line <= last for first, last in lines.get(each.cell, ())))
        else each
        for each in document.displays
    )
    return replace(document, displays=displays)


def _texts(text: str, suffix: str) -> Mapping[int | None, str]:
    """Return the texts of a document by their cells, None where there are none; its lines are those of the displays."""
    if suffix not in (".ipynb", ".py") or not text:
        return {None: text}
    cells = notebook_cells(text) if suffix == ".ipynb" else percent_cells(text)
    return {number: "\n" * (each.line - 1) + each.text for number, each in enumerate(cells) if each.kind == "markdown"}


def _lines(text: str, suffix: str) -> Iterator[tuple[int, int]]:
    """Yield the first and the last line of what is struck out or denied."""
    found = [
        *_STRUCK.finditer(text),
        *(_STRUCK_IN_MARKDOWN.finditer(_without_blanks(text)) if suffix in _IN_MARKDOWN else ()),
    ]
    places = [each.span() for each in found]
    places += [(each.start(), _end(each, text)) for each in _OPENS.finditer(text) if _denies(each)]
    for start, end in places:
        yield text.count("\n", 0, start) + 1, text.count("\n", 0, end) + 1


def _without_blanks(text: str) -> str:
    """Return a text in whose formulas no ~~ stands: there it is space and strikes nothing out; at their edge it strikes what is between two."""
    if "~~" not in text:
        return text
    edges = "$\\[] \t\n"
    return _MATH.sub(
        lambda found: (
            found.group()
            if found.group().strip(edges).startswith("~~") or found.group().strip(edges).endswith("~~")
            else found.group().replace("~", " ")
        ),
        text,
    )


def _denies(box: re.Match[str]) -> bool:
    """Whether the name or the title of a box denies what stands in it."""
    words = " ".join(filter(None, box.group("name", "option", "class", "summary", "words", "indented")))
    if box["indented"] and _FAILS.match(box["indented"]):
        return True
    return _says_no(re.sub(r"[-_{}:.=\"#]", " ", words)) or (box["name"] is None and is_not_to_copy(_title(box)))


def _title(box: re.Match[str]) -> str:
    """Return the line that a box begins with, where it is short enough for a title of its own."""
    first = box.string[box.end() : box.end() + _TITLE].strip().split("\n")[0]
    return first if len(first) <= _TITLE // 2 else ""


@lru_cache(maxsize=256)
def _says_no(words: str) -> bool:
    return denies_within(words) or _NO_CLAIM.search(words) is not None


def _end(box: re.Match[str], text: str) -> int:
    """Return where a box ends; one that is not closed ends where it begins, what is indented with its last line."""
    if box["indented"]:
        inside = re.compile(rf"(?:\n{box['margin']}(?:    |\t)[^\n]*|\n[ \t]*(?=\n|\Z))*").match(box.string, box.end())
        return inside.end() if inside is not None else box.end()
    closing = rf"\\end\s*\{{{box['name']}\*?\}}" if box["name"] else rf"</{box['tag']}>" if box["tag"] else None
    closing = closing or ("</details>" if box["summary"] else r"^:::+[ \t]*$")
    found = re.compile(closing, re.MULTILINE).search(text, box.end(), box.end() + MOST)
    return found.end() if found is not None else box.end()
