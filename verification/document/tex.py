r"""Read LaTeX: `$$`, `\[ \]` and the display environments, tables, sections, errata, and the author's own macros.

The front matter stands in the comments at the head of the file:

    % ---
    % arm: scara
    % ---

An erratum is a display in an `erratum` environment, in one that begins with the word Erratum, or below a comment
`% Erratum`.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from armproof.verification.document.front_matter import FRONT_MATTER_KEYS, FrontMatter, split_front_matter
from armproof.verification.document.heading import begin_section
from armproof.verification.document.in_words import said_in_words
from armproof.verification.document.model import CODE, INLINE, Display, Document, Table, Words
from armproof.verification.document.postures import FARTHEST as LED_BY
from armproof.verification.document.postures import postures
from armproof.verification.document.sentences import said_above, said_below, said_in_general
from armproof.verification.document.tex_accents import with_letters
from armproof.verification.document.tex_conditionals import without_branches
from armproof.verification.document.tex_definitions import find_macros, without_unprinted
from armproof.verification.document.tex_macros import blank, closing_brace
from armproof.verification.document.tex_project import Project
from armproof.verification.document.tex_tables import read_tabular
from armproof.verification.document.units import MOST_BEHIND, with_unit
from armproof.verification.patterns import regex

ENVIRONMENTS = (
    "equation align gather multline flalign alignat eqnarray displaymath dmath dgroup math xalignat IEEEeqnarray empheq"
).split()
_DISPLAY = regex(r"(?:%s)\*?" % "|".join(ENVIRONMENTS))
_WITH_ARGUMENT = regex(r"(?:alignat|xalignat|IEEEeqnarray|empheq)\*?")
_ARGUMENTS = regex(r"\s*(?:\[(?:[^][{}]|\{[^{}]*\})*\]\s*)?\{[^{}]*\}")
_COMMENT = regex(r"(?<!\\)((?:\\\\)*)%([^\n]*)")
_HIDDEN = regex(
    r"\\begin\{(verbatim\*?|lstlisting|minted|comment|Verbatim)\}.*?\\end\{\1\}|\\verb\*?([^\w\s*]).*?\2",
    re.DOTALL,
)
_EXCLUDED = regex(r"\\exclude(?:comment|version)\s*\{\s*([A-Za-z]+)\s*\}")
_LISTING = regex(r"\\begin\{(verbatim\*?|lstlisting|minted|Verbatim)\}.*?\\end\{\1\}", re.DOTALL)
_VERB = regex(r"\\verb\*?([^\w\s*])[^\n]*?\1")
_OPEN_TITLE = regex(r"[\\\n]")  # what ends one whose brace is never closed
_TITLE = regex(r"\\title\s*(?:\[[^\]]*\]\s*)?\{")
_TOKEN = regex(
    r"\\begin\s*\{(?P<begin>\w+\*?)\}|\\end\s*\{(?P<end>\w+\*?)\}|\\(?P<section>chapter|(?:sub)*section|paragraph|frametitle)\*?\s*(?:\[[^\]]*\])?\s*\{"
    r"|(?P<bracket>\\\[)|(?P<macro>\\[A-Za-z]+)|\\.|(?P<dollars>\$\$?)",
    re.DOTALL,
)
_MATRIX = regex(r"\\begin\s*\{(?:array|[bpvBV]?matrix)\*?\}")
_MATRIX_IN_CELL = regex(r"\$[^$]*=[^$]*\\begin\s*\{(?:array|[bpvBV]?matrix)\*?\}[^$]*\$")  # A_1 = […] & A_2 = […]
_ERRATUM = regex(
    r"\s*(?:\[(?:[^\]]*[={\s])?\W*errat(?:um|a)\b|(?:\\(?:textbf|textit|emph|textsc|bfseries|itshape|bf|it|noindent|paragraph)(?![A-Za-z])[\s*{]*|\{)*errat(?:um|a)\b)",
    re.IGNORECASE,
)


def read_tex(path: Path, text: str) -> Document:
    """Return the document of a LaTeX file."""
    text = text.replace("\r\n", "\n")
    front = _front_matter(path, text)
    project = _project(path, text)
    scanner = _Scanner(project)
    displays = (*scanner.displays(), *scanner.code())
    remarks = (*front.remarks, *project.left_out.values())
    return Document(path, front.values, displays, tuple(scanner.tables), front.lines, remarks=remarks)


def read_parts(path: Path, text: str) -> Iterator[Words | Display]:
    r"""Yield the displays of a LaTeX file, as `read_tex` reads them, and what stands between them.

    Its title, a tabular and code (\begin{verbatim}) are each by itself.
    """
    yield from _Scanner(_project(path, text.replace("\r\n", "\n"))).parts()


def inputs_of(path: Path, text: str) -> tuple[Path, ...]:
    """Return the files that a LaTeX file inputs and its local packages, each once, under the names that it asks for."""
    return tuple(dict.fromkeys(_project(path, text.replace("\r\n", "\n")).read))


def begins_as_erratum(text: str, at: int) -> bool:
    """Whether the environment whose content begins at a place is an erratum by its first words."""
    return _ERRATUM.match(text, at) is not None


def _project(path: Path, text: str) -> Project:
    project = Project(path.parent.resolve(), _without_false_branches)
    project.add(text, path.name, (path.resolve(),))
    return project


def _without_comments(text: str) -> str:
    """Return a text with its comments and what is shown as it is typed blank, as long as it was."""
    return _HIDDEN.sub(lambda m: blank(m.group()), _uncommented(text))


def _without_false_branches(text: str) -> str:
    """Return a text without what its file alone tells not to be printed: a switch may be set in another file."""
    return without_branches(_without_comments(text), follows=False)[0]


def _without_excluded(text: str) -> str:
    r"""Return a text without the environments that \excludecomment names."""
    for name in dict.fromkeys(_EXCLUDED.findall(text)):
        hidden = re.compile(rf"\\begin\s*\{{{name}\}}.*?\\end\s*\{{{name}\}}", re.DOTALL)
        text = hidden.sub(lambda found: blank(found.group()), text)
    return text


def _uncommented(text: str) -> str:
    return _COMMENT.sub(lambda m: m.group(1) + " " * (len(m.group()) - len(m.group(1))), text)


def _front_matter(path: Path, text: str) -> FrontMatter:
    """Read the comments at the head of the file: fenced by `---`, or beginning with one of our keys."""
    head: list[str] = []
    first = 1
    for line in text.split("\n"):
        found = re.match(r"[ \t]*%+ ?(?!\s*!)(.*)$", line)
        if found is None and (head or line.strip()) and not re.match(r"[ \t]*%", line):
            break
        stripped = found.group(1).rstrip() if found else ""
        is_start = stripped.rstrip() == "---" or re.match(r"(?:%s)\s*:" % "|".join(FRONT_MATTER_KEYS), stripped)
        if head or is_start:
            head.append(stripped)
        else:
            first += 1
    if not head:
        return FrontMatter()
    fenced = head[0] == "---"
    block = "\n".join(head if fenced else ["---", *head, "---"])
    return split_front_matter(path, block + "\n", first if fenced else first - 1)[0] or FrontMatter()


# an exercise in an environment, of the author's own too: homeworkProblem
_EXERCISE = regex(r"\w*(?:problem|exerci[sc]e|ejercicio|exercicio|esercizio|aufgabe|question)\*?", re.IGNORECASE)
_OPTION = regex(r"\s*\[[^\]\d]*(\d+(?:\.\d+)*)[^\]]*\]")  # \begin{homeworkProblem}[Question 4]
_ROBOT_OF = regex(  # what an exercise begins with that is about the robot of another
    r"\b(?:robot|manipulator|arm|mechanism|bras|brazo|braço|manipulador|roboter)s?\b[^.]{0,60}?\b(?:in|of|from|de|du|da|do|aus)\s+(?:the\s+)?"
    r"(?:question|problem|exerci[sc]e|aufgabe|ejercicio|exercício|problema|problème)\s+(\d+(?:\.\d+)*)",
    re.IGNORECASE,
)
_PARAGRAPH = regex(  # up to what ends it
    r"\s*(?:(?!\n\s*\n|\$\$|\\\[|\\(?:begin|end)\s*\{|\\(?:item|chapter|(?:sub)*section|paragraph)(?![A-Za-z])).)+",
    re.DOTALL,
)
_EDGE = regex(
    r"\\[\[\]]|\$\$|\\(?:begin|end)\s*\{(?:%s)\*?\}" % "|".join(ENVIRONMENTS)
)  # of a display: where it ends, or begins in vain
LEVELS = ("chapter", "section", "subsection", "subsubsection", "frametitle", "paragraph")
EXERCISE_LEVEL = LEVELS.index("section") + 0.5
FARTHEST = 500  # characters behind the beginning of an exercise


@dataclass
class _Region:
    """An environment that is open: where it began to be an erratum, if it is one, and the section that it stands in."""

    name: str
    erratum: bool
    section: str = ""


class _Scanner:
    """Finds the displays of a LaTeX text, which keeps its length: what does not print is blank in `visible`."""

    def __init__(self, project: Project) -> None:
        self.project, self.place = project, project.place
        self.text = text = project.text
        self.marks = [
            m.start() for m in _COMMENT.finditer(text) if re.match(r"[%\s]*errat(?:um|a)\b", m.group(2), re.I)
        ]
        printed, self.unclear = without_branches(_without_excluded(_without_comments(text)), project.definitions)
        self.macros, visible = find_macros(printed, project.definitions)
        self.visible = without_unprinted(visible, self.macros)
        begin, end = (re.search(r"\\%s\s*\{document\}" % which, self.visible) for which in ("begin", "end"))
        self.start = begin.end() if begin else 0
        self.stop = end.start() if end else len(text)
        self.section = self.exercise = ""
        self.exercises, self.exercise_names = 0, dict[str, str]()  # by the number that the author gives each
        self.regions: list[_Region] = []
        self.tables: list[Table] = []
        self.nowhere: dict[str, int] = {}  # from where on what closes mathematics is not found
        self.layout = 0  # where the tabular ends that arranges matrices in its cells
        self.spans: list[tuple[int, int, Display | None]] = []  # of displays and tabulars, once they are read

    def line(self, offset: int) -> int:
        """Return the line (from 1) of a place in its file."""
        return self.place(offset)[0]

    def where(self, offset: int) -> dict[str, Any]:
        """Return the file of a place and the stretch of text it is in, of a project of several files."""
        file = self.project.file(offset)
        return {"file": file, "cell": self.project.number(offset)} if file else {}

    def displays(self) -> Iterator[Display]:
        """Yield the displays in their order, and gather the tables."""
        position, is_behind = self.start, False
        while (token := _TOKEN.search(self.visible, position, self.stop)) is not None:
            between = with_letters(self.visible[position : token.start()])
            yield from postures(
                between, self.line(position), self.section, self.visible[max(0, position - LED_BY) : position]
            )
            yield from self._said(position, between, is_behind)
            is_behind = is_behind and not between.strip()
            position = token.end()
            if token.group("section"):
                close = closing_brace(self.visible, token.end() - 1)
                behind = self.visible[token.end() : close if close >= 0 else None]
                title = behind if close >= 0 else _OPEN_TITLE.split(behind, maxsplit=1)[0]
                title = " ".join(with_letters(title).split()).replace("---", "—").replace("--", "–")
                level = LEVELS.index(token.group("section"))
                is_behind = False
                self.section = begin_section(
                    self.section, f"{self.exercise}: {title}" if self.exercise else title, level
                )
                yield from postures(title, self.line(position), self.section)
                position = token.end() if close < 0 else close + 1
                yield from self._in_title(token.end(), position)
            elif (opened := self._opened(token)) is not None:
                begin, end, after = opened
                if token.group() not in ("$", "\\(") or self._is_set_apart(begin, end):
                    paragraph = _EDGE.split(self.visible[max(self.start, token.start() - 400) : token.start()])[-1]
                    paragraph = paragraph.rstrip().rsplit("\n\n")[-1]
                    yield from said_below(with_letters(paragraph), self.line(token.start()), self.section)
                    yield (display := self._display(token, begin, end))
                    self.spans.append((token.start(), after, display))
                    is_behind = True
                elif end >= 0:
                    is_behind = False
                    yield from self._inline(token.start(), begin, end, after)
                position = after
            elif token.group("begin"):
                position = self._enter(token)
            elif token.group("end"):
                self._leave(token.group("end"))
        yield from self._said(position, with_letters(self.visible[position : self.stop]), is_behind)

    def _in_title(self, position: int, stop: int) -> Iterator[Display]:
        """Yield the formulas of a title, which is over at `stop`."""
        while (token := _TOKEN.search(self.visible, position, stop)) is not None:
            opened = self._opened(token) if token.group() in ("$", "\\(") else None
            position = token.end()
            if opened is not None and 0 <= opened[1] < stop:
                yield from self._inline(token.start(), *opened)
                position = opened[2]

    def _inline(self, start: int, begin: int, end: int, after: int) -> Iterator[Display]:
        """Yield a formula within a sentence, and what the words before it make of it."""
        latex, _ = self.macros.expanded(self.visible[begin:end], begin, self.place)
        found = [with_unit(latex, self.visible[after : after + MOST_BEHIND])]
        if (said := said_in_words(self.visible, start)) is not None:
            found.append(self.macros.expanded(said, begin, self.place)[0])
        for each in found:
            yield Display(self.line(start), each, section=self.section, opening=INLINE, **self.where(begin))

    def _said(self, position: int, between: str, is_behind: bool) -> Iterator[Display]:
        """Yield what the text at a place says in general, and of the display that it stands right behind."""
        if (
            is_behind
            and (found := _PARAGRAPH.match(self.visible, position, min(position + 400, self.stop))) is not None
        ):
            yield from said_above(with_letters(found.group()), self.line(position), self.section)
        yield from said_in_general(between, self.line(position), self.section)

    def parts(self) -> Iterator[Words | Display]:
        """Yield the displays and the words between them."""
        for _ in self.displays():
            pass
        if (title := _TITLE.search(self.visible)) is not None and title.start() < self.start:
            yield self._words(title.start(), closing_brace(self.visible, title.end() - 1) + 1)
        listings = {found.start(): found for found in self._listings()}
        cursor = self.start
        for begin, end, display in sorted([*self.spans, *((*each.span(), None) for each in listings.values())], key=lambda span: span[0]):  # fmt: skip
            if not cursor <= begin < self.stop:
                continue
            yield self._words(cursor, begin)
            if begin in listings:
                yield Words(self.line(begin), self.text[begin:end])
            else:
                yield display or self._words(begin, end)
            cursor = end
        yield self._words(cursor, self.stop)

    def code(self) -> Iterator[Display]:
        """Yield the listings, each from the line on which it begins."""
        for found in self._listings():
            head = self.text.find("\n", found.start())
            content = self.text[head : self.text.rfind("\\end", found.start(), found.end())] if head >= 0 else ""
            yield Display(self.line(found.start()), content, opening=CODE)

    def _listings(self) -> Iterator[re.Match[str]]:
        return _LISTING.finditer(_uncommented(self.text))

    def _words(self, begin: int, end: int) -> Words:
        """Return a stretch of text, its macros expanded; code within words, which is no mathematics, is seen again."""
        visible = self.visible[begin:end]
        for found in _VERB.finditer(_uncommented(self.text[begin:end])):
            visible = visible[: found.start()] + found.group() + visible[found.end() :]
        return Words(self.line(begin), self.macros.expanded(visible, begin, self.place)[0])

    def _opened(self, token: re.Match[str]) -> tuple[int, int, int] | None:
        """Return where the mathematics that a token opens begins, ends (-1: never), and what is read next; or None."""
        dollars, name = token.group("dollars"), token.group("begin")
        if dollars:
            end = self._find(r"(?<!\\)" + re.escape(dollars), token.end())
            return (token.end(), end, token.end() if end < 0 else end + len(dollars))
        if token.group() == "\\(":
            end = self._find(r"(?<!\\)\\\)", token.end())
            return (token.end(), end, token.end() if end < 0 else end + 2)
        if token.group("bracket"):
            closing, again = r"(?<!\\)\\\]", r"(?<!\\)\\\["
        elif name and _DISPLAY.fullmatch(name):
            closing, again = (r"\\%s\s*\{%s\}" % (which, re.escape(name)) for which in ("end", "begin"))
        elif (own := self.macros.opens(token.group("macro") or f"\\begin{{{name}}}")) is not None:
            closing, again = self.macros.closings(own), re.escape(token.group()) + r"(?![A-Za-z])"
        else:
            return None
        begin = token.end()
        end = self._find(rf"(?:{closing})|(?:{again})", begin)
        found = re.compile(closing).match(self.visible, end) if end >= 0 else None
        return (begin, -1, begin) if found is None else (begin, end, found.end())

    def _find(self, pattern: str, begin: int) -> int:
        """Return where a pattern is found next, -1 for nowhere: what is nowhere is looked for once, however often it is opened."""
        if begin >= self.nowhere.get(pattern, len(self.visible) + 1):
            return -1
        found = re.compile(pattern).search(self.visible, begin, self.stop)
        if found is None:
            self.nowhere[pattern] = begin
        return found.start() if found is not None else -1

    def _display(self, token: re.Match[str], begin: int, end: int) -> Display:
        opening = "\\(" if token.group() == INLINE else token.group().strip()
        if _WITH_ARGUMENT.fullmatch(token.group("begin") or ""):
            argument = _ARGUMENTS.match(self.visible, begin)
            begin = argument.end() if argument else begin
        marked = bool(self.marks) and self.marks[0] < token.start()
        self.marks = [mark for mark in self.marks if mark > token.start()]
        erratum = marked or any(region.erratum for region in self.regions)
        line = self.line(token.start())
        if end < 0:
            rest = self.visible[begin : self.stop].partition("\n\n")[0].partition(token.group())[0]
            return Display(
                line, rest, erratum, section=self.section, closed=False, opening=opening, **self.where(begin)
            )
        while begin < end and self.visible[begin] == "\n":
            begin += 1
        is_unclear = any(first <= token.start() < last for first, last in self.unclear)
        latex, pieces = self.macros.expanded(self.visible[begin:end].rstrip("\n"), begin, self.place)
        where = self.where(begin)
        pieces = pieces if where.get("file", "") in ("", self.project.parts[0].file) else ()
        return Display(
            line,
            latex,
            erratum,
            section=self.section,
            opening=opening,
            pieces=pieces,
            may_not_print=is_unclear,
            **where,
        )

    # -- environments --------------------------------------------------------------------------------------------------

    def _enter(self, token: re.Match[str]) -> int:
        """Enter an environment that is no display, or read the table that it is; return where to read on."""
        name = token.group("begin")
        marked = bool(self.marks) and self.marks[0] < token.start()
        if name.rstrip("*") in ("tabular", "tabularx", "tabulary", "longtable"):
            end = self._find(r"\\end\s*\{%s\}" % re.escape(name), token.end())
            if end >= 0:
                erratum = marked or any(region.erratum for region in self.regions)
                table = read_tabular(self.visible[token.end() : end], token.end(), self.place)
                if _MATRIX_IN_CELL.search(self.visible, token.end(), end):
                    self.layout = end
                    return self._behind_columns(token.end())
                if table is not None:
                    line = self.line(token.start())
                    context = {"line": line, "erratum": erratum, "section": self.section, **self.where(token.start())}
                    self.tables.append(replace(table, **context))
                    self.marks = [mark for mark in self.marks if mark > token.start()]
                closing = self.visible.index("}", end) + 1
                self.spans.append((token.start(), closing, None))
                return end
        is_erratum = name.lower().startswith("errat") or begins_as_erratum(self.visible, token.end())
        self.regions.append(_Region(name, is_erratum, self.section))
        if _EXERCISE.fullmatch(name):
            self.exercise = self._next_exercise(token.end())
            self.section = begin_section(self.section, self.exercise, EXERCISE_LEVEL)
        return token.end()

    def _behind_columns(self, begin: int) -> int:
        arguments = _ARGUMENTS.match(self.visible, begin)
        return arguments.end() if arguments else begin

    def _is_set_apart(self, begin: int, end: int) -> bool:
        """Whether a formula is the matrix in a cell of a tabular that only arranges such."""
        return end < self.layout and _MATRIX.search(self.visible, begin, end) is not None

    def _next_exercise(self, begin: int) -> str:
        """Return the name of the exercise that begins: that of an earlier one, where it goes on with the robot of that."""
        self.exercises += 1
        option = _OPTION.match(self.visible, begin)
        number = option[1] if option is not None else str(self.exercises)
        other = _ROBOT_OF.search(self.visible, begin, begin + FARTHEST)
        earlier = self.exercise_names.get(other[1]) if other is not None else None
        self.exercise_names[number] = earlier or f"Exercise {self.exercises}"  # [10 points] may stand at several
        return self.exercise_names[number]

    def _leave(self, name: str) -> None:
        while self.regions and any(region.name == name for region in self.regions):
            if (left := self.regions.pop()).name == name:
                if _EXERCISE.fullmatch(name):
                    self.section, self.exercise = left.section, ""
                return
