r"""The text of a LaTeX document as Markdown, for its sheet: its displays are those that were checked, in their order.

What is a display or a table, the reader of the verification says (`read_parts`); here the words between them are read:
sections, lists, quotes, errata, figures, tables, code, styles, accents. A command that means nothing on paper is dropped, of
one that is not known the words in its braces are kept, and it is named in a warning.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from pathlib import Path

from armproof.course.printing.tex_words import TOKEN, TexWords, argument, option
from armproof.course.sheet.body import Body, MarkdownLines, escaped
from armproof.course.sheet.pictures import SUFFIXES
from armproof.models.errors import written
from armproof.verification.document import Display
from armproof.verification.document.model import Words
from armproof.verification.document.tex import begins_as_erratum, read_parts
from armproof.verification.document.tex_tables import tabular_cells

_SECTIONS = {
    **dict.fromkeys("part chapter section".split(), 2),
    **dict.fromkeys("subsection frametitle".split(), 3),
    "title": 1,
    "subsubsection": 4,
    "paragraph": 5,
    "subparagraph": 6,
}
_CLEAR = set(
    "center figure table wrapfigure minipage abstract document flushleft flushright small subequations titlepage frame block "
    "multicols columns column adjustbox landscape spacing threeparttable".split()
)
_DRAWN = ("tikzpicture", "pgfpicture", "picture", "circuitikz")
_WITH_ARGUMENT = {"minipage": 1, "wrapfigure": 2, "multicols": 1, "adjustbox": 1}
_LISTS = {"itemize": "-", "enumerate": "1.", "description": "-"}
_WHOLE = re.compile(  # a table or code, which the reader hands over by itself
    r"\\begin\s*\{(?P<name>tabular[xy*]?|longtable|verbatim\*?|lstlisting|minted|Verbatim)\}[ \t]*(?:\[[^\]]*\])?(?:\{[^{}]*\})?[ \t]*\n?"
    r"(?P<code>.*?)\n?[ \t]*\\end\s*\{(?P=name)\}",
    re.DOTALL,
)
_REFERENCE = re.compile(r"\\(?:eq)?ref\{([^{}]*)\}")
_SOLUTION = re.compile(r"(?:worked)?(?:solution|corrige|correction|answer)s?", re.IGNORECASE)


def tex_body(path: Path, text: str) -> Body:
    """Return a LaTeX document as Markdown."""
    reader = _Reader(path)
    for part in read_parts(path, text):
        if isinstance(part, Display):
            reader.display(part)
        else:
            reader.words(part)
    return reader.done()


@dataclass
class _Reader:
    """Writes Markdown lines; `inline` gathers the paragraph that is open, `picture` a picture that waits for its caption."""

    path: Path
    out: MarkdownLines = field(default_factory=MarkdownLines)
    inline: str = ""
    picture: str = ""
    open: list[str] = field(default_factory=list)  # environments that indent
    spoken: TexWords = field(default_factory=TexWords)
    drawings: list[int] = field(default_factory=list)  # their lines
    heading: str = ""  # the one just written
    titles: dict[str, str] = field(default_factory=dict)  # of sections, by their labels

    def done(self) -> Body:
        """Return all that was read."""
        self.end_paragraph()
        self.out.lines = [_REFERENCE.sub(self._title, line) for line in self.out.lines]
        warnings = [
            written("{path}:{line}: '{command}' is not printed; the words in its braces are", path=self.path, line=line, command=command)
            for command, line in self.spoken.unknown.items()
        ]  # fmt: skip
        drawings = [
            written("{path}:{line}: a drawing in LaTeX is not printed; put it beside the document as a picture", path=self.path, line=line)
            for line in self.drawings
        ]  # fmt: skip
        return self.out.body([*warnings, *drawings])

    def _title(self, found: re.Match[str]) -> str:
        """Return the title of the section that is referred to; what refers to something else stays."""
        return f"“{self.titles[found[1]]}”" if found[1] in self.titles else found[0]

    def display(self, display: Display) -> None:
        """Write a display; an erratum that only a comment says to be one as such."""
        self.end_paragraph()
        alone = display.erratum and "erratum" not in self.open
        if alone:
            self.out.enter("> ")
            self.out.write("**Erratum**")
        self.out.place = display.line
        self.out.write(f"$$ {' '.join(display.latex.split())} $$")
        if alone:
            self.out.leave()

    def words(self, words: Words) -> None:
        """Write what stands between two displays."""
        self.out.place = words.line
        found = _WHOLE.fullmatch(words.text)
        if found is None:
            self._read(words.text, words.line)
            return
        self.end_paragraph()
        if found["name"].startswith(("tabular", "longtable")):
            self._table(words.text)
        else:
            self.out.write(f"```\n{found['code']}\n```")

    def end_paragraph(self) -> None:
        """Write the paragraph that is open."""
        text = re.sub(r"[ \t\n]*\u00a0[ \t\n]*", "\u00a0", re.sub(r"[ \t\n]+", " ", self.inline)).strip()
        self.inline = ""
        if text:
            self.heading = ""
            self.out.write(_unmarked(text))

    # -- blocks -----------------------------------------------------------------------------------------------------

    def _read(self, text: str, line: int) -> None:
        at = 0
        while (token := TOKEN.search(text, at)) is not None:
            self.inline += escaped(text[at : token.start()])
            if not self.inline.strip():
                self.out.place = self.spoken.line = line + text.count("\n", 0, token.start())
            at = self._block(text, token)
        self.inline += escaped(text[at:])

    def _block(self, text: str, token: re.Match[str]) -> int:
        """Read a token that begins or ends a block, or one of a paragraph; return the place behind it."""
        name, at = token["command"], token.end()
        if token["gap"] or name == "par":
            self.end_paragraph()
        elif token["begin"]:
            at = self._enter(token["begin"], text, at)
        elif token["end"]:
            self._leave(token["end"])
        elif name in _SECTIONS:
            self.end_paragraph()
            title, at = argument(text, at)
            self.heading = self.spoken.read(title)
            self.out.write(f"{'#' * _SECTIONS[name]} {self.heading}")
        elif name == "label":
            label, at = argument(text, at)
            if self.heading and not self.inline.strip():
                self.titles[label.strip()] = self.heading
        elif name == "item":
            self.end_paragraph()
            label, at = option(text, at)
            self.out.mark()
            self.inline = f"**{self.spoken.read(label)}** " if label else ""
        elif name == "includegraphics":
            target, at = argument(text, at)
            self.end_paragraph()
            self._pictured("")
            self.picture = self._file(target.strip())
            if "figure" not in self.open:
                self._pictured("")
        elif name == "caption":
            caption, at = argument(text, at)
            self.end_paragraph()
            self._pictured(self.spoken.read(caption))
        else:
            written, at = self.spoken.token(text, token)
            self.inline += written
        return at

    def _enter(self, name: str, text: str, at: int) -> int:
        self.end_paragraph()
        self.heading = ""
        plain = name.rstrip("*")
        if plain in _DRAWN:
            self.drawings.append(self.out.place)
            end = text.find(f"\\end{{{name}}}", at)
            return end if end >= 0 else len(text)
        title, at = ("", at) if plain in _LISTS else option(text, at)
        for _ in range(_WITH_ARGUMENT.get(plain, 0)):
            _, at = argument(text, at)
        if plain in _LISTS:
            self.out.enter(_LISTS[plain])
            _, at = option(text, at)
        elif plain.startswith("errat") or begins_as_erratum(text, at):
            plain = "erratum"
            self.out.enter("> ")
            if name.startswith("errat"):
                self.inline = f"**Erratum** ({self.spoken.read(title)}). " if title else "**Erratum**. "
        elif _SOLUTION.fullmatch(plain):
            self.out.enter("> ")
            self.out.write("**Solution**")
        elif plain in _CLEAR:
            plain = "figure" if plain == "wrapfigure" else plain
        else:
            self.out.enter("> ")
            if plain not in ("quote", "quotation", "verse"):
                self.inline = f"**{(title and self.spoken.read(title)) or plain.capitalize()}.** "
        self.open.append(plain if plain not in _CLEAR or plain == "figure" else "")
        return at

    def _leave(self, name: str) -> None:
        self.end_paragraph()
        self._pictured("")
        if name in _DRAWN:
            return
        if self.open and self.open.pop() not in ("", "figure"):
            self.out.leave()

    def _pictured(self, caption: str) -> None:
        """Write the picture that waits, with its caption; a caption of something else is a paragraph."""
        if self.picture:
            self.out.write(f"![{caption}]({self.picture})")
        elif caption:
            self.out.write(f"*{caption}*")
        self.picture = ""

    def _file(self, name: str) -> str:
        found = (name + suffix for suffix in ("", *SUFFIXES) if (self.path.parent / (name + suffix)).is_file())
        return next(found, name).replace(" ", "%20")

    def _table(self, text: str) -> None:
        rows = [[self.spoken.read(cell) or " " for cell in row] for row in tabular_cells(text)]
        if any(rows):
            self.out.table(rows)


def _unmarked(text: str) -> str:
    """Return a paragraph whose first signs open no list, no quote and no heading."""
    return re.sub(r"\A([-+]|\d+[.)])(?=\s)", lambda found: found[0][:-1] + "\\" + found[0][-1], text)
