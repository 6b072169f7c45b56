"""Read Markdown: displays and tables, the errata among them, and the sections that they stand in."""

from __future__ import annotations

import re
from bisect import bisect_left
from collections.abc import Callable, Collection, Iterator, Sequence
from dataclasses import replace
from functools import lru_cache
from pathlib import Path
from textwrap import dedent
from typing import Any

from markdown_it import MarkdownIt
from markdown_it.rules_block import StateBlock
from markdown_it.token import Token
from mdit_py_plugins.colon_fence import colon_fence_plugin
from mdit_py_plugins.dollarmath import dollarmath_plugin
from mdit_py_plugins.dollarmath.index import math_block_dollar

from armproof.verification.document.broken_formulas import broken_formula
from armproof.verification.document.code_columns import shows_rows
from armproof.verification.document.formula_links import formulas_in_html, formulas_in_line
from armproof.verification.document.front_matter import FrontMatter, split_front_matter
from armproof.verification.document.heading import begin_section
from armproof.verification.document.html_tables import read_html_tables
from armproof.verification.document.in_words import said_in_words
from armproof.verification.document.link_labels import with_quick_labels
from armproof.verification.document.markdown_hidden import without_hidden
from armproof.verification.document.model import CODE, INLINE, Display, Document, Piece, Table
from armproof.verification.document.postures import postures
from armproof.verification.document.sentences import said_above, said_below, said_in_general
from armproof.verification.document.units import MOST_BEHIND, with_unit
from armproof.verification.patterns import regex

PICTURE = "<img"  # the opening of a display whose LaTeX stands in the address of a picture
_AFTER_A_LEAD = frozenset("math_block math_block_label amsmath html_block fence colon_fence".split())
_INDENTED_BOX = regex(  # of MkDocs: what is indented behind it is its text
    r"^(?:(?P<tab>===)[+!]{0,2}|!!!|\?\?\?\+?)[ \t]+(?P<title>[^\n]*)", re.MULTILINE
)
_OF_TAB = 6  # level of the section that a tab is
_INDENTED = regex(r"\s*\$\$[ \t]*\n(?:(?!\$\$).)+\n[ \t]*\$\$[ \t]*(?:\n|$)", re.DOTALL)  # a display below "Step 3."
_STOPS = " .,;，。；"
_NUMBERED = regex(r"\s*\(?(?:[IVX]{1,5}|[ivx]{1,5}|\d{1,2}|[A-Za-z])\s*[.):–-]\s*")  # I. $x = …$
_JOINS = regex(
    r"[\s.,;]*(?:and|et|und|y|e)?[\s.,;:]*"
)  # what stands behind one of several formulas, each in its paragraph
_LISTS = regex(r",.*=", re.DOTALL)  # a_1 = 0, d_1 = 2: what is given
ALONE = "$ "  # the opening of a formula between single dollars that has a line of its own
_DERIVED = regex(  # a matrix, or a function of an angle or of a length: no value that is given
    r"\\begin\{\w*matrix|\\begin\{array|(?=.*=).*(?:\\(?:cos|sin|tan|arc[a-z]{3}|sqrt)(?![A-Za-z])|atan_?2|arctan_?2|(?<![A-Za-z\\])[cCsS]_)",
    re.DOTALL,
)
_MATRIX = regex(r"\\begin\{\w*matrix|\\begin\{array")
_FENCES = regex(r"\\(?:begin|end)\{\w*\*?\}(?:\{[|clr ]*\})?")
_LEADS_ON = regex(  # in the languages in which such lines were met
    r"(?:[:：.;,为是為]|\b(?:is|are|as|gives?|gets?|becomes?|obtains?|yields?|equals|est|sont|donne|donnent|obtient|obtenons|vaut|devient|es|son|queda|obtiene|obtenemos|resulta|será|è|sono|diventa|otteniamo|ist|sind|lautet|ergibt|é|são|fica|là))\s*\Z",
    re.IGNORECASE,
)
_SAYS = regex(r"[=<>≈]|\\(?:approx|simeq|equiv|[lg]eq?)(?![A-Za-z])|(?:∈|\\in(?![A-Za-z]))\s*(?:\\left\s*)?[(\[]")
AMS = "\\begin"  # the opening of an environment that stands in the text without dollars
_ENVIRONMENT = regex(
    r"\\begin\{((?:equation|align|gather|multline|flalign|alignat|eqnarray)\*?|(?:align|gather)ed|split)\}"
)
_WHOLE_ENVIRONMENT = regex(rf"{_ENVIRONMENT.pattern}(?:(?!\n[ \t]*\n).)*?\\end\{{\1\}}", re.DOTALL)
_LITERAL = regex(r"\s*<(?:pre|script|style|textarea)\b", re.IGNORECASE)  # what stands in it is no formula
_BAR = regex(r"(?<!\\)\|")
_BLANK = regex(r"[\s>]*")
_OPTIONS = regex(r"[\s>]*(?::[\w-]+:.*|---.*|[\w-]+:.*)?")
Rule = Callable[[StateBlock, int, int, bool], bool]
MOST_OF_A_LABEL = 6  # words
MOST_LINES = 100  # of an environment without dollars
MOST_NESTED = 12  # directives, each in another: every one is read anew
_BEGINS = regex(r"(?:\(?[A-Za-z0-9]{1,2}[.)]\s+)?\$\$")  # a display, with the label of its item: "A. $$ … $$"
FARTHEST = 12  # lines between the opening of a display and its LaTeX: blank, or a directive's options
ADMONITIONS = frozenset(["admonition", "note", "warning", "tip", "important", "caution", "error", "hint", "attention", "danger",
                         "seealso", "erratum", "errata", "card", "dropdown", "proof", "topic", "sidebar", "margin", "figure", "table",
                         "example", "exercise", "solution", "theorem", "lemma", "definition", "remark", "details", "aside", "grid",
                         "grid-item", "grid-item-card", "tab-set", "tab-item"])  # fmt: skip
_DIRECTIVE = regex(r"\s*\{?\s*\.?(?P<name>[\w:-]*)")  # ```{math}, :::{admonition} Erratum, ::: {.erratum}, ::: warning
_IN_SOME_FORMAT = regex(r"\.content-(?:hidden|visible)(?![\w-])")  # of Quarto: when-format, unless-meta
_HIDDEN = regex(r"\.(?:content-)?hidden(?![\w-])(?!.*\b(?:when|unless)-)")
_ERRATUM = regex(r"(?<![A-Za-z])errat(?:um|a)\b", re.IGNORECASE)
_LABEL = regex(
    r"(\$\$)[ \t]*\{#[^{}\n]*(?:\{[^{}\n]*\})?[^{}\n]*\}[ \t]*$", re.MULTILINE
)  # Quarto's: $$ {#eq-jacobian}
# \[ … \] and \\[ … \\] on lines of their own, as MathJax and many writers have them
_BRACKETS = regex(
    r"^([ \t>]*)(\\{1,2})\[((?:(?!\$\$|^[ \t>]*$)[^\n]*\n){0,60}?(?!\$\$)[^\n$]*?)\2\](?=[ \t.,;]*$)", re.MULTILINE
)
_ROUND = regex(
    r"(\\{1,2})\(((?:(?!\1[()]|[$`]|\n[ \t>]*\n).){1,400}?)\1\)", re.DOTALL
)  # \( … \) and \\( … \\) in a line
_FENCED = regex(r"^[ \t>]*(?:```|~~~)", re.MULTILINE)
_UNSEEN = regex("[\u200b\u200c\ufeff]+$", re.MULTILINE)  # behind the $$ that ends a display
_HTML_HEADING = regex(r"\s*<h(?P<level>[1-6])(?:\s[^<>]*)?>(?P<text>.*?)</h[1-6]>", re.IGNORECASE | re.DOTALL)


def place_displays(displays: Sequence[Display], lines: Sequence[str], first: int) -> list[Display]:
    """Return the displays with their places; `lines` begin on line `first`, the displays come in their order.

    A display is sought from its line on, behind its opening mark and behind the display before it.
    """
    placed: list[Display] = []
    row, column = 0, 0
    for display in displays:
        if display.opening in (INLINE, PICTURE, CODE):
            placed.append(display)
            continue
        if display.line - first > row:
            row, column = display.line - first, 0
        mark = "$" if display.opening == ALONE else display.opening
        found = _find(display, lines, row, column, "" if mark == AMS else mark) if display.closed else None
        if found is None:
            placed.append(display)
            continue
        pieces, row, column = found
        if mark == "$$" and (closing := lines[row].find(mark, column)) >= 0:
            column = closing + len(mark)
        placed.append(replace(display, pieces=tuple(replace(p, line=p.line + first) for p in pieces)))
    return placed


def place_table(table: Table, lines: Sequence[str], first: int) -> Table:
    """Return a table with the places of its cells; `lines` begin on line `first`."""
    rows = (table.header, *table.rows)
    numbers = [table.line - first + k + (k > 0) for k in range(len(rows))]  # the rule below the header is no row
    placed = (
        _place_row(row, lines[number], number + first) if number < len(lines) else (None,) * len(row)
        for row, number in zip(rows, numbers, strict=True)
    )
    return replace(table, pieces=tuple(placed))


def _place_row(row: Sequence[str], line: str, number: int) -> tuple[Piece | None, ...]:
    start = len(line) - len(line.lstrip(" \t>"))
    bars = [found.start() for found in _BAR.finditer(line, start)]
    edges = [*([] if bars and bars[0] == start else [start - 1]), *bars, len(line)]
    placed: list[Piece | None] = []
    for k, text in enumerate(row):
        if k + 1 >= len(edges):
            placed.append(None)
            continue
        begin, end = edges[k] + 1, edges[k + 1]
        at = line.find(text, begin, end) if text else min(begin + 1, end)
        placed.append(Piece(0, len(text), number, at, "$" in line[begin:end]) if at >= 0 else None)
    return tuple(placed)


def _find(
    display: Display, lines: Sequence[str], row: int, column: int, mark: str
) -> tuple[list[Piece], int, int] | None:
    """Return the pieces of a display, and the row and column behind it."""
    if row >= len(lines):
        return None
    opening = lines[row].find(mark, column)
    while opening >= 0:
        skipped = _BLANK if mark == "$$" else _OPTIONS
        if (found := _follow(display.latex, lines, row, opening + len(mark), skipped)) is not None:
            return found
        opening = lines[row].find(mark, opening + len(mark)) if mark else -1
    return None


def _follow(
    latex: str, lines: Sequence[str], row: int, column: int, skipped: re.Pattern[str]
) -> tuple[list[Piece], int, int] | None:
    """Return the pieces of a display that begins behind a place, or None where it does not."""
    pieces: list[Piece] = []
    at = 0
    for text in latex.split("\n"):
        if bare := text.strip():
            start = at + text.index(bare)
            for ahead in range(FARTHEST if not pieces else 1 + FARTHEST):
                if row + ahead >= len(lines):
                    return None
                found = lines[row + ahead].find(bare, column if ahead == 0 else 0)
                if found >= 0 and _nothing_between(lines[row + ahead][column if ahead == 0 else 0 : found]):
                    break
                if not skipped.fullmatch(lines[row + ahead], column if ahead == 0 else 0):
                    return None
            else:
                return None
            row, column = row + ahead, found + len(bare)
            pieces.append(Piece(start, len(bare), row, found))
        at += len(text) + 1
    return (pieces, row, column) if pieces else None


def _nothing_between(text: str) -> bool:
    return not text.strip(" \t>")


def read_markdown_file(path: Path, text: str) -> Document:
    """Return the document of a Markdown file's text."""
    front, body, first = split_front_matter(path, text)
    front = front or FrontMatter()
    displays, tables = read_markdown(body, first)
    return Document(path, front.values, tuple(displays), tuple(tables), front.lines, remarks=front.remarks)


def read_markdown(body: str, first: int, cell: int | None = None) -> tuple[list[Display], list[Table]]:
    """Return the displays and tables of a Markdown text that begins on line `first` of the file or of the cell."""
    body = without_labels(without_hidden(body))
    displays, tables = _read_blocks(body, first, cell, "", False)
    source = body.split("\n")
    return place_displays(displays, source, first), [place_table(table, source, first) for table in tables]


def _read_blocks(
    body: str, first: int, cell: int | None, section: str, in_erratum: bool, depth: int = 0
) -> tuple[list[Display], list[Table]]:
    """Return the displays and tables of a text, or of what stands in one of its directives; without their places."""
    if depth > MOST_NESTED:
        raise RecursionError
    displays: list[Display] = []
    tables: list[Table] = []
    quotes = [in_erratum]  # and one a nested blockquote: whether it is an erratum
    in_table, is_behind, line = False, False, first  # behind a display
    lead, lead_line = "", first  # the text that may lead to what comes next
    tokens = display_reader().parse(_UNSEEN.sub(lambda found: " " * len(found.group()), body))
    for index, token in enumerate(tokens):
        erratum, content = any(quotes), token.content
        line = line if token.map is None else first + token.map[0]  # what closes has no place of its own
        box = _INDENTED_BOX.search(lead) if token.type == "code_block" else None
        is_indented = bool(lead) and token.type == "code_block" and (box or _INDENTED.match(content)) is not None
        is_next = token.type in _AFTER_A_LEAD or is_indented
        if is_next or (token.type == "inline" and (_BEGINS.match(content) or _stands_alone(token))):
            displays.extend(said_below(lead, lead_line, section) if lead else ())
            lead = ""
        if token.type == "html_block" and (heading := _HTML_HEADING.match(content)) is not None:
            section = begin_section(section, re.sub(r"<[^<>]*>", "", heading["text"]).strip(), int(heading["level"]))
        if token.type == "heading_open":
            section, is_behind = begin_section(section, tokens[index + 1].content, int(token.tag[1:])), False
        elif token.type == "blockquote_open":
            quotes.append(_is_erratum(tokens, index))
        elif token.type == "blockquote_close":
            quotes.pop()
        elif token.type in ("math_block", "math_block_label"):
            displays.extend(_block_displays(content, line, erratum, cell, section))
            displays.extend(said_above(token.info, line, section) if token.info else ())  # $$ … $$ (wrong): no label
            is_behind = True
        elif is_indented:
            inner = begin_section(section, box["title"], _OF_TAB) if box is not None and box["tab"] else section
            erratum = erratum or (box is not None and _ERRATUM.search(box["title"]) is not None)
            more, more_tables = _read_blocks(dedent(content), line, cell, inner, erratum, depth + 1)
            displays += more
            tables += more_tables
            is_behind = True
        elif token.type == "code_block":
            displays.append(Display(line, content, cell=cell, section=section, opening=CODE))
        elif token.type == "amsmath":
            displays.append(Display(line, content, erratum, cell, section, opening=AMS))
            is_behind = True
        elif token.type == "html_block" and (in_html := [*_within_html(content, line, erratum, cell, section)]):
            displays.extend(in_html)
        elif token.type == "html_block" and "<table" in content:
            for at, rows in read_html_tables(content):
                tables.append(Table(line + at - 1, rows[0], rows[1:], erratum, cell, section))
        elif token.type == "html_block" and "<img" in content:
            found = formulas_in_html(content)
            displays.extend(_of_picture(latex, line + at, erratum, cell, section, alone) for at, latex, alone in found)
        elif token.type == "inline":
            in_text = _inline_displays(token, first, erratum, cell, section, is_behind and not in_table)
            displays.extend(
                each for each in in_text if not in_table or each.opening == INLINE or _SAYS.search(each.latex)
            )
            if token.level == 1 and shows_rows(content):
                displays.append(Display(line, content, cell=cell, section=section, opening=CODE))
            is_behind = token.content.rstrip().endswith("$$")
            is_lead = not in_table and tokens[index - 1].type != "heading_open"
            lead, lead_line = content.split("$$")[-1] if is_lead else "", line
        elif token.type in ("table_open", "table_close"):
            if in_table := token.type == "table_open":
                tables.append(_read_table(tokens, index, first, erratum, cell, section))
        elif token.type in ("fence", "colon_fence") and (inside := _DIRECTIVE.match(token.info)) is not None:
            if inside.group("name") == "math":
                displays.extend(_math_directive(token, line, erratum, cell, section))
                is_behind = True
            elif token.type == "colon_fence" and _HIDDEN.search(token.info):
                pass
            elif token.type == "colon_fence" or inside["name"].removeprefix("prf:") in ADMONITIONS:
                erratum = erratum or _ERRATUM.search(token.info) is not None or _begins_as_erratum(content)
                inner = _without_options(content)
                more, more_tables = _read_blocks(inner, line + 1, cell, section, erratum, depth + 1)
                may_not_print = _IN_SOME_FORMAT.search(token.info) is not None
                displays += [replace(each, may_not_print=True) for each in more] if may_not_print else more
                tables += more_tables
            else:
                displays.append(Display(line + 1, content, cell=cell, section=section, opening=CODE))
    return displays, tables


def _within_html(content: str, line: int, erratum: bool, cell: int | None, section: str) -> Iterator[Display]:
    """Yield the displays between the tags of a block of HTML: <center>$$ … $$</center>, or an environment."""
    shown = _without_comments(content)
    parts = shown.split("$$")
    for place in range(1, len(parts), 2):
        at = line + "$$".join(parts[:place]).count("\n")
        yield Display(at, parts[place], erratum, cell, section, closed=place + 1 < len(parts))
    for found in _WHOLE_ENVIRONMENT.finditer(shown) if len(parts) == 1 and not _LITERAL.match(shown) else ():
        at = line + shown.count("\n", 0, found.start())
        yield Display(at, found.group(), erratum, cell, section, opening=AMS)


def _without_comments(content: str) -> str:
    """Return HTML with blanks for its comments; one that is never closed is none, and is looked for once."""
    shown = ""
    while (start := content.find("<!--")) >= 0 and (end := content.find("-->", start)) >= 0:
        shown += content[:start] + re.sub(r"[^\n]", " ", content[start : end + 3])
        content = content[end + 3 :]
    return shown + content


def _of_picture(latex: str, line: int, erratum: bool, cell: int | None, section: str, alone: bool) -> Display:
    """Return the formula of a picture: a display, where it says something and stands alone on its line."""
    is_display = alone and _SAYS.search(latex) is not None
    return Display(line, latex, erratum and is_display, cell, section, opening=PICTURE if is_display else INLINE)


def without_labels(body: str) -> str:
    """Return a text whose equations have no labels and stand between dollars, every other character at its place."""
    if "\\[" in body:
        dollars = [found.start() for found in re.finditer(r"\$\$", body)]
        body = _BRACKETS.sub(lambda found: _in_dollars(found, dollars), body)
    if "\\(" in body:
        dollars = [found.start() for found in re.finditer(r"\$\$", body)]
        fences = [found.start() for found in _FENCED.finditer(body)]
        body = _ROUND.sub(lambda found: _in_dollar(found, dollars, fences), body)
    return _LABEL.sub(lambda found: found.group(1) + " " * (len(found.group()) - len(found.group(1))), body)


def _in_dollar(found: re.Match[str], *closings: Sequence[int]) -> str:
    if any(bisect_left(each, found.start()) % 2 for each in closings):  # within a display, or code
        return found.group()
    slashes, latex = found.groups()
    return f"{'$'.rjust(len(slashes) + 1)}{latex}{'$'.ljust(len(slashes) + 1)}"


def _in_dollars(found: re.Match[str], dollars: Sequence[int]) -> str:
    if bisect_left(dollars, found.start()) % 2:  # within a display it is the end of a row
        return found.group()
    margin, slashes, latex = found.groups()
    return f"{margin}{'$$'.rjust(len(slashes) + 1)}{latex}{'$$'.ljust(len(slashes) + 1)}"


@lru_cache(maxsize=1)
def markdown_reader() -> MarkdownIt:
    """Return the reader of the Markdown that documents are written in."""
    return _new_reader()


def _new_reader() -> MarkdownIt:
    return with_quick_labels(
        MarkdownIt("commonmark", {"maxNesting": 100})
        .enable("table")
        .use(colon_fence_plugin)
        .use(dollarmath_plugin, allow_labels=True, double_inline=True)
    )


@lru_cache(maxsize=1)
def display_reader() -> MarkdownIt:
    """Return the reader that finds displays: one on lines of its own, or an environment, ends the paragraph before it."""
    reader = _new_reader()
    ends: Any = {"alt": ["paragraph", "reference", "blockquote", "list"]}
    reader.block.ruler.before("html_block", "amsmath", _quiet(_environment), ends)
    reader.block.ruler.at("math_block", _quiet(_single(math_block_dollar(True, allow_blank_lines=True))), ends)
    return reader


def _single(rule: Rule) -> Rule:
    """Return a rule for one display: $$$$, the end of one and the opening of the next, stands in none."""

    def found(state: StateBlock, start: int, last: int, silent: bool) -> bool:
        line, count = state.line, len(state.tokens)
        if rule(state, start, last, silent) and "$$" not in state.tokens[-1].content:
            return True
        state.line = line
        del state.tokens[count:]
        return False

    return found


def _quiet(rule: Rule) -> Rule:
    """Return a rule that leaves nothing behind where it is only asked whether it would end a paragraph.

    Within a display that began in the paragraph it does not.
    """

    def asked(state: StateBlock, start: int, last: int, silent: bool) -> bool:
        line, count = state.line, len(state.tokens)
        found = rule(state, start, last, silent)
        if silent:
            state.line = line
            del state.tokens[count:]
        return found and not (silent and _within_display(state, start))

    return asked


def _within_display(state: StateBlock, line: int) -> bool:
    """Whether an odd number of double dollars stands before a line."""
    if "dollars" not in state.env:
        state.env["dollars"] = [found.start() for found in re.finditer(r"\$\$", state.src)]
    return bisect_left(state.env["dollars"], state.bMarks[line]) % 2 == 1


def _environment(state: StateBlock, start: int, last: int, _silent: bool) -> bool:
    """Read an environment for equations that stands in the text without dollars, as MathJax does."""
    begin = state.bMarks[start] + state.tShift[start]
    opened = _ENVIRONMENT.match(state.src, begin)
    if opened is None or state.is_code_block(start) or _within_display(state, start):
        return False
    closing = re.compile(r"\\end\{%s\}[ \t.,;]*$" % re.escape(opened[1]))
    for line in range(start, min(last, start + MOST_LINES)):
        text = state.src[state.bMarks[line] : state.eMarks[line]]
        if not text.strip(" \t>"):
            return False
        if closing.search(text):
            token, state.line = state.push("amsmath", "math", 0), line + 1
            token.content = state.getLines(start, state.line, state.sCount[start], False).strip()
            token.map = [start, state.line]
            return True
    return False


def _is_erratum(tokens: list[Token], start: int) -> bool:
    """Whether the first words of a blockquote are **Erratum**."""
    first = next((t for t in tokens[start + 1 :] if t.type in ("inline", "blockquote_close", "math_block")), None)
    return (
        first is not None
        and first.type == "inline"
        and bool(re.match(r"[*_\s]*errat(?:um|a)\b", first.content, re.IGNORECASE))
    )


def _begins_as_erratum(content: str) -> bool:
    return re.match(r"[#*_\s]*errat(?:um|a)\b", content, re.IGNORECASE) is not None


def _math_directive(token: Token, line: int, erratum: bool, cell: int | None, section: str) -> Iterator[Display]:
    """Yield the equation of a MyST directive, its options left out."""
    latex = _without_options(token.content).lstrip("\n").rstrip()
    if latex:
        yield Display(line, latex, erratum, cell, section, opening=f"{token.markup}{token.info}")


def _without_options(content: str) -> str:
    """Return what stands in a directive, the lines of its options left empty: between two rules, or each between colons."""
    lines, after = content.split("\n"), 0
    if lines[0].strip() == "---" and "---" in (rest := [text.strip() for text in lines[1:]]):
        after = rest.index("---") + 2
    while after < len(lines) and re.match(r"\s*(?::[\w-]+:.*)?$", lines[after]):
        after += 1
    return "\n" * after + "\n".join(lines[after:])


def _block_displays(content: str, line: int, erratum: bool, cell: int | None, section: str) -> Iterator[Display]:
    """Yield the displays of a block: `$$ a = 1 $$ $$ b = 2 $$` on one line are two."""
    for index, part in enumerate(content.split("$$")):
        if index % 2 == 0:
            yield Display(line, part.strip("\n"), erratum, cell, section)
        line += part.count("\n")


def _inline_displays(
    token: Token, first: int, erratum: bool, cell: int | None, section: str, is_behind: bool
) -> Iterator[Display]:
    """Yield the displays of a text and what it says, of the display too that it stands right behind."""
    base = first + (token.map[0] if token.map else 0)
    cursor = end = 0  # behind the last formula, behind the last display
    children = token.children or []
    if (whole := _broken_formula(token)) is not None:
        yield Display(base, whole, erratum, cell, section, opening=ALONE)
        return
    alone = _on_own_lines(token)
    ends = [*_ends_of_texts(token, alone), len(token.content)]
    text = token.content[: ends[0]]
    if is_behind:
        yield from said_above(text, base, section)
    yield from said_in_general(text, base, section)
    for place, child in enumerate(children):
        if child.type == "math_inline_double" or place in alone:
            mark = "$$" if child.type == "math_inline_double" else "$"
            at = token.content.find(mark + child.content, cursor)
            cursor = end = at + len(child.content) + 2 * len(mark)
            yield from said_below(text, base, section)
            line, opening = base + token.content.count("\n", 0, at), ALONE if place in alone else mark
            yield Display(line, child.content, erratum, cell, section, opening=opening)
            ends.pop(0)
            text = token.content[end : ends[0]]
            yield from said_above(text, base, section)
            yield from said_in_general(text, base, section)
        elif child.type == "math_inline":
            quoted = re.fullmatch(r"`(.*)`", child.content, re.DOTALL)  # GitHub's $`…`$
            latex = quoted[1] if quoted else child.content
            if quoted and _is_only_formula(children):
                yield Display(base, latex, erratum, cell, section, opening="$`")
            else:
                at = token.content.find("$" + child.content, cursor)
                after = token.content[at + len(child.content) + 2 :] if at >= 0 else ""
                measured = with_unit(latex, after[:MOST_BEHIND])
                yield Display(base, measured, cell=cell, section=section, opening=INLINE)
                if at >= 0 and (said := said_in_words(token.content, at)) is not None:
                    yield Display(base, said, cell=cell, section=section, opening=INLINE)
                cursor = max(cursor, at + len(child.content) + 2)
        elif child.type == "text" and "$$" not in child.content:
            yield from postures(child.content, base, section, token.content[end:cursor])
        elif child.type == "text" and (at := token.content.find("$$", cursor)) >= 0:
            yield Display(
                base + token.content.count("\n", 0, at), token.content[at + 2 :], erratum, cell, section, closed=False
            )
            return
    for at, latex, alone_ in formulas_in_line(token.children or []):
        yield _of_picture(latex, base + at, erratum, cell, section, alone_)


def _is_only_formula(children: Sequence[Token]) -> bool:
    """Whether a paragraph holds one formula, with its number before it or what joins it to the next behind."""
    held = [each for each in children if each.content.strip()]
    place = next(k for k, each in enumerate(held) if each.type == "math_inline")
    before, behind = held[:place], held[place + 1 :]
    said = [*zip(before, [_NUMBERED] * len(before), strict=True), *zip(behind, [_JOINS] * len(behind), strict=True)]
    is_plain = all(each.type == "text" and pattern.fullmatch(each.content) for each, pattern in said)
    return is_plain and len(before) <= 1 and len(behind) <= 1


def _ends_of_texts(token: Token, alone: Collection[int]) -> Iterator[int]:
    """Yield where the displays of a text begin, in their order."""
    cursor = 0
    for place, child in enumerate(token.children or ()):
        if child.type == "math_inline_double" or place in alone:
            mark = "$$" if child.type == "math_inline_double" else "$"
            at = token.content.find(mark + child.content, cursor)
            cursor = at + len(child.content) + 2 * len(mark)
            yield at


def _on_own_lines(token: Token) -> set[int]:
    """Return which children are formulas between single dollars that stand for displays.

    They do where a paragraph holds nothing else; on a line of their own behind a colon, or behind what leads on to them, if
    they are equations with functions, or behind the label of an item, "- Position: $x = …$"; and at the end of a line where
    they say what a matrix is, for nobody mentions one.
    """
    children = token.children or []
    says = {
        place for place, child in enumerate(children) if child.type == "math_inline" and _SAYS.search(child.content)
    }
    says = {place for place in says if not children[place].content.startswith("`")}
    if _stands_alone(token):
        return says
    if token.level % 2 == 0:  # a heading, a cell
        return set()
    found: set[int] = set()
    is_led = False
    for line in _lines_of(children):
        held = [place for place in line if children[place].content.strip(_STOPS)]
        is_alone = bool(held) and all(children[place].type == "math_inline" for place in held)
        own = [place for place in held if place in says]
        if is_alone and is_led and token.level == 1:
            found |= {place for place in own if not _LISTS.search(children[place].content)}
        if is_alone and len(held) == 1 and own and _DERIVED.search(children[own[0]].content):
            found |= {*own} if _leads_on(children[: own[0]]) else set()
        if own and own[-1] == held[-1] and _leads_on(children[: own[-1]]):
            found |= {place for place in own[-1:] if _claims_a_matrix(children[place].content)}
        if token.level > 1 and own and own[-1] == held[-1] and _DERIVED.search(children[own[-1]].content):
            found |= {own[-1]} if _is_label([children[place] for place in held[:-1]]) else set()
        if not is_alone:
            is_led = bool(held) and children[held[-1]].content.rstrip().endswith((":", "："))
    return found


def _is_label(before: Sequence[Token]) -> bool:
    """Whether what stands before a formula on its line is a few words and a colon."""
    said = "".join(each.content for each in before).strip()
    is_of_words = all(each.type == "text" for each in before) and len(said.split()) <= MOST_OF_A_LABEL
    return is_of_words and said.endswith((":", "：")) and len(said) > 1


def _leads_on(before: Sequence[Token]) -> bool:
    """Whether what stands before a formula in its paragraph says that this is so, as "is" does; "from" or "let" give what is asked about."""
    said = [child for child in before if child.type not in ("softbreak", "hardbreak") and child.content.strip()]
    return not said or said[-1].type != "text" or _LEADS_ON.search(said[-1].content) is not None


def _claims_a_matrix(latex: str) -> bool:
    """Whether a formula says what a matrix is, in letters; one of numbers alone is given: v = (0, 3)."""
    return bool(_MATRIX.search(latex)) and re.search("[A-Za-z]", _FENCES.sub("", latex).rpartition("=")[2]) is not None


def _lines_of(children: Sequence[Token]) -> Iterator[list[int]]:
    """Yield the places of the children of each line of a paragraph."""
    line: list[int] = []
    for place, child in enumerate(children):
        if child.type in ("softbreak", "hardbreak"):
            yield line
            line = []
        else:
            line.append(place)
    yield line


def _stands_alone(token: Token) -> bool:
    """Whether a paragraph holds formulas alone, a line each: $T_2^0 = T_1^0 T_2^1$, which many write for displays.

    So does an item of a list, or behind a number, whose formulas are matrices, or equations with functions; others there are mostly what is given.
    """
    if _broken_formula(token) is not None:
        return True
    held = [each for each in token.children or () if each.content.strip(_STOPS) or each.type == "softbreak"]
    is_numbered = bool(held) and held[0].type == "text" and _NUMBERED.fullmatch(held[0].content) is not None
    held = held[is_numbered:]
    kinds = {each.type for each in held}
    formulas = [each.content for each in held if each.type == "math_inline"]
    may_stand = (token.level == 1 and not is_numbered) or (
        token.level % 2 == 1 and all(_DERIVED.search(each) for each in formulas)
    )
    return may_stand and "math_inline" in kinds and kinds <= {"math_inline", "softbreak"}


def _broken_formula(token: Token) -> str | None:
    """Return the equation that a paragraph or an item holds in several pieces; of an item as _stands_alone asks it."""
    whole = broken_formula(token.children or []) if token.level % 2 == 1 else None
    if whole is None or _SAYS.search(whole) is None:
        return None
    return whole if token.level == 1 or _DERIVED.search(whole) else None


def _read_table(tokens: list[Token], start: int, first: int, erratum: bool, cell: int | None, section: str) -> Table:
    rows: list[list[str]] = []
    for token in tokens[start:]:
        if token.type == "tr_open":
            rows.append([])
        elif token.type == "inline":
            rows[-1].append(token.content.strip().strip("$").strip())
        elif token.type == "table_close":
            break
    opening = tokens[start]
    line = first + (opening.map[0] if opening.map else 0)
    filled = [row for row in rows[1:] if any(row)]  # a blank one below the others is a rule
    return Table(line, tuple(rows[0]), tuple(map(tuple, filled or rows[1:])), erratum, cell, section)
