"""Read reStructuredText: `.. math::` blocks, sections, errata.

The front matter stands in a comment at the head of the file or in its field list (docinfo):

    ..                            :arm: scara
       arm: scara                 :source: F. Morbidi, TD 3
       source: F. Morbidi, TD 3

An erratum is a block in an `.. erratum::` or `.. admonition:: Erratum`, or in a block quote that begins with **Erratum**.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

from armproof.verification.document.front_matter import FRONT_MATTER_KEYS, FrontMatter, split_front_matter
from armproof.verification.document.heading import RULE, begin_section, is_ruled
from armproof.verification.document.in_words import said_in_words
from armproof.verification.document.model import INLINE, Display, Document, Piece
from armproof.verification.document.postures import postures
from armproof.verification.document.sentences import said_above, said_below, said_in_general
from armproof.verification.document.units import MOST_BEHIND, with_unit
from armproof.verification.patterns import regex

_MATH = regex(r"(?P<margin>\s*(?:[-*+]\s+|\d+[.)]\s+)?)\.\. math::[ \t]*(?P<argument>.*)$")
_ERRATUM = regex(r"\s*+\.\. (?:errat(?:um|a)|[\w-]+::\s*errat(?:um|a))\b|\s[*_\s]*+errat(?:um|a)\b", re.IGNORECASE)
_OPTION = regex(r"\s*:[\w-]+:")
_ROLE = regex(r":math:`([^`]*)`")
_ROLE_OR_SIGN = regex(r":math:`([^`]+)`|(=)")
_ALONE = regex(
    r"(?:\|\s+|\s{4,}|)(?:\\\s+)?:math:`[^`]+`(?:(?:\\\s)?\s*=\s*(?:\\\s)?:math:`[^`]+`)*(?:\\\s)?\s*[.,;]?\s*"
)
_COMMENT = regex(r"\s*\.\.(?:\s+(?!\S+::)|\s*$)")
# code, and what stands behind a paragraph that ends with ::; `.. note::` ends so, too, and hides nothing
_HIDES = regex(
    r"\s*\.\. (?:code|code-block|sourcecode|parsed-literal|raw|testcode|doctest)::"
    r"|(?!\s*\.\. ).*(?<!:)::\s*$"
)


def read_rst(path: Path, text: str) -> Document:
    """Return the document of a reStructuredText file."""
    lines = text.replace("\r\n", "\n").split("\n")
    front = _front_matter(path, lines)
    return Document(path, front.values, tuple(_displays(lines)), (), front.lines, remarks=front.remarks)


def _front_matter(path: Path, lines: list[str]) -> FrontMatter:
    """Read the YAML of the first comment, or the fields at the head or below the title."""
    row = next((k for k, line in enumerate(lines) if line.strip()), len(lines))
    if row + 1 < len(lines) and not lines[row].startswith(("..", ":")):  # a title, under its rule or between two
        row += 3 if RULE.match(lines[row]) else 2
        row = next((k for k in range(row, len(lines)) if lines[k].strip()), len(lines))
    if row >= len(lines):
        return FrontMatter()
    if re.fullmatch(r"\.\.(?: .*)?", lines[row].rstrip()) and not re.match(r"\.\. [\w|\[_-]+.*::", lines[row]):
        return _of_comment(path, lines, row)
    if re.match(r":[A-Za-z_]+:", lines[row]):
        return _of_fields(path, lines, row)
    return FrontMatter()


def _of_comment(path: Path, lines: list[str], row: int) -> FrontMatter:
    block = [lines[row][2:]] if lines[row][2:].strip() else []
    first = row if block else row + 1
    block += _indented(lines, row + 1)
    margin = min((len(line) - len(line.lstrip()) for line in block if line.strip()), default=0)
    head = [line[margin:] for line in block]
    while head and not head[0].strip():
        head, first = head[1:], first + 1
    keyed = head and (head[0].rstrip() == "---" or re.match(r"(?:%s)\s*:" % "|".join(FRONT_MATTER_KEYS), head[0]))
    return _parsed(path, head, first + 1) if keyed else FrontMatter()


def _of_fields(path: Path, lines: list[str], row: int) -> FrontMatter:
    head: list[str] = []
    for line in lines[row:]:
        field = re.match(r":([A-Za-z_]+):(.*)$", line)
        if field is None and not (line.startswith(" ") and line.strip()):
            break
        head.append(f"{field.group(1)}:{field.group(2)}" if field else line)
    return _parsed(path, head, row + 1)


def _parsed(path: Path, head: list[str], first: int) -> FrontMatter:
    fenced = head[0].rstrip() == "---"
    block = "\n".join(head if fenced else ["---", *head, "---"])
    return split_front_matter(path, block + "\n", first if fenced else first - 1)[0] or FrontMatter()


def _indented(lines: list[str], row: int) -> Iterator[str]:
    """Yield the lines of a block from a row on, as long as they are indented or blank."""
    for line in lines[row:]:
        if line.strip() and not line.startswith((" ", "\t")):
            return
        yield line


def _displays(lines: list[str]) -> Iterator[Display]:
    section, rules = "", list[str]()  # the marks that underline headings, in the order of their ranks
    erratum: int | None = None  # the indent of the erratum that is open
    hidden: int | None = None  # the indent of a comment or of code
    is_behind = False  # a display
    for row, line in enumerate(lines):
        if not line.strip():
            continue
        indent = len(line) - len(line.lstrip())
        if hidden is not None and indent > hidden:
            continue
        hidden = None
        if erratum is not None and (indent < erratum or (indent == erratum and not line.startswith(" "))):
            erratum = None
        if _COMMENT.match(line) and not _ERRATUM.match(line):
            hidden = indent
            continue
        yield from postures(line, row + 1, section)
        if is_behind:
            yield from said_above(line, row + 1, section)
        yield from said_in_general(line, row + 1, section)
        is_behind = _MATH.match(line) is not None
        if (alone := _alone(line, row, erratum is not None, section)) is not None:
            yield alone
            is_behind = True
            continue
        for role in _ROLE.finditer(line):
            latex = with_unit(role[1], line[role.end() :][:MOST_BEHIND])
            yield Display(row + 1, latex, section=section, opening=INLINE)
            if (said := said_in_words(line, role.start())) is not None:
                yield Display(row + 1, said, section=section, opening=INLINE)
        yield from said_below(line, row + 1, section)
        if (found := _MATH.match(line)) is not None:
            yield from _block(lines, row, found, erratum is not None, section)
            hidden = len(found.group("margin"))
        elif _ERRATUM.match(line) and erratum is None:
            erratum = indent + 1 if line.lstrip().startswith("..") else indent
        elif _HIDES.match(line):
            hidden = indent
        elif row + 1 < len(lines) and is_ruled(line, lines[row + 1]):
            if (mark := lines[row + 1].strip()[0]) not in rules:
                rules.append(mark)
            section = begin_section(section, line.strip(), rules.index(mark))


def _alone(line: str, row: int, erratum: bool, section: str) -> Display | None:
    """Return the equation of a line that holds nothing else, between roles or within one: :math:`r^2` = :math:`x^2 + y^2`."""
    if _ALONE.fullmatch(line) is None or "=" not in line:
        return None
    latex, pieces = "", []
    for part in _ROLE_OR_SIGN.finditer(line):
        text, group = (part[1], 1) if part[1] is not None else (part[2], 2)
        latex += " " * bool(latex)
        pieces.append(Piece(len(latex), len(text), row + 1, part.start(group)))
        latex += text
    return Display(row + 1, latex, erratum, None, section, opening=":math:", pieces=tuple(pieces))


def _block(lines: list[str], row: int, found: re.Match[str], erratum: bool, section: str) -> Iterator[Display]:
    """Yield the equations of a math block: blank lines stand between them, but behind a = it goes on, with another = or without."""
    margin = len(found.group("margin"))
    group: list[tuple[int, str]] = []
    if argument := found.group("argument").strip():
        group.append((row, argument))
    options, opening = True, row
    for number in range(row + 1, len(lines)):
        line = lines[number]
        if line.strip() and len(line) - len(line.lstrip()) <= margin:
            break
        if options and _OPTION.match(line):
            continue
        options = options and not line.strip() and not group
        if text := line.strip():
            goes_on = bool(group) and group[-1][1].endswith("=")
            group.append((number, text.removeprefix("=").lstrip() or text if goes_on else text))
        elif group and not group[-1][1].endswith("=") and is_whole("\n".join(text for _, text in group)):
            yield _display(lines, opening, group, erratum, section)
            group, opening = [], -1
    if group:
        yield _display(lines, opening, group, erratum, section)


def is_whole(text: str) -> bool:
    r"""Whether no environment is open: a blank line within a matrix ends no equation."""
    return text.count("\\begin{") == text.count("\\end{")


def _display(lines: list[str], row: int, group: list[tuple[int, str]], erratum: bool, section: str) -> Display:
    """Return an equation of a block: the first at the block's own row, the others (row -1) where they begin."""
    pieces: list[Piece] = []
    at = 0
    for number, text in group:
        pieces.append(Piece(at, len(text), number + 1, lines[number].rindex(text)))
        at += len(text) + 1
    line = (row if row >= 0 else group[0][0]) + 1
    latex = "\n".join(text for _, text in group)
    return Display(line, latex, erratum, None, section, opening=".. math::", pieces=tuple(pieces))
