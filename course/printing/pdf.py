"""A sheet as PDF, by Typst: its source is calls of the template's functions, the document's own text as escaped text.

Nothing of a document is markup or code there: every ASCII sign of its words but quotation marks, which Typst sets as the
language has them, is escaped, code is a string, and mathematics comes from the checked tree.
"""

from __future__ import annotations

import re
import shutil
import tempfile
import unicodedata
from collections.abc import Callable, Mapping, Sequence
from importlib import resources
from importlib.util import find_spec
from pathlib import Path

from armproof.course.errors import PrintError
from armproof.course.printing.mathematics import quoted, typst_mathematics
from armproof.course.sheet import model as s
from armproof.course.sheet.proof import proof_line, remark
from armproof.course.words import say
from armproof.verification.latex.mathml.box import Box
from armproof.verification.latex.mathml.display import Line

_SPECIAL = re.compile(r"[!#$%&*+\-./:;<=>?@\[\\\]^_`{|}~]")
_JOINT = re.compile(r"<mo>[⇒⇔⇐]</mo>|<mtext>[^<]*</mtext>")
_WHOLE = 9.0  # em of a formula within words that stays on one line
_FRENCH = re.compile(r" (?=[;:!?»])|(?<=«) ")
MISSING = "a PDF sheet is typeset by Typst, which is not installed: pip install 'armproof[print]'; --format html needs nothing"


class TypstWriter:
    """Writes one sheet; `names` gives each picture's file the name it has beside the source."""

    def __init__(self, sheet: s.Sheet, names: Mapping[Path, str]) -> None:
        self.sheet = sheet
        self.lang = sheet.lang
        self.names = names
        self.blocks: dict[type, Callable[..., str]] = {
            s.Heading: self._heading,
            s.Paragraph: self._paragraph,
            s.Display: self._display,
            s.Table: self._table,
            s.Listing: self._list,
            s.Quote: self._quote,
            s.Listed: lambda block: f"#code-block({quoted_lines(block.text)})",
            s.Picture: self._picture,
            s.Blank: lambda block: f"#blank({block.height:g}mm)",
            s.Rule: lambda block: "#rule",
        }

    def source(self) -> str:
        """Return the whole source."""
        sheet = self.sheet
        settings = {
            "title": self._content(sheet.title),
            "plain-title": quoted(s.plain(sheet.title)),
            "source": self._content(sheet.source) if sheet.source else "none",
            "lang": quoted(sheet.lang),
            "draft": quoted(say("draft", sheet.lang)) if sheet.draft else "none",
            "proof": quoted(sheet.foot or proof_line(sheet.records, sheet.lang, sheet.arm)),
            "own": quoted(say("own_are", sheet.lang)) if sheet.has_own else "none",
            "edition": quoted(say("edition", sheet.lang)) if sheet.solutions else "none",
            "named": "none"
            if sheet.solutions
            else f"({quoted(say('name', sheet.lang))}, {quoted(say('date', sheet.lang))})",
        }
        arguments = ", ".join(f"{name}: {value}" for name, value in settings.items())
        body = self._body(sheet.blocks)
        return f'#import "sheet.typ": *\n#show: sheet.with({arguments})\n\n{body}\n'

    def _body(self, blocks: Sequence[s.Block]) -> str:
        return "\n\n".join(self.blocks[type(block)](block) for block in blocks)

    # -- blocks -----------------------------------------------------------------------------------------------------

    def _heading(self, block: s.Heading) -> str:
        return f"#heading(level: {max(2, block.level)}){self._content(block.parts)}"

    def _paragraph(self, block: s.Paragraph) -> str:
        words = self._content(block.parts)
        return f"#block(sticky: true){words}" if block.leads else f"#par{words}"

    def _display(self, block: s.Display) -> str:
        note = quoted(remark(block.record, self.lang))
        if not block.lines:
            return f"#raw-display({quoted_lines(block.record.latex)}, {note})"
        lines = "".join(f"{_line(line)}, " for line in block.lines)
        number = self._number(f"({block.number})" if block.number else "", block.own)
        return f"#displayed(({lines}), note: {note}, number: {number})"

    def _number(self, number: str, own: bool) -> str:
        """Return what stands beside a display or a table: its number, a dagger if it is not the source's."""
        mark = "#super[†]" if own else ""
        return f"[{escaped(number, self.lang)}{mark}]" if number or own else "none"

    def _table(self, block: s.Table) -> str:
        aligns = ", ".join("auto" if column == "auto" else column for column in block.columns)
        header = "".join(f"{self._content(cell)}, " for cell in block.header)
        width = len(block.header)
        cells = [cell for row in block.rows for cell in (*row, *[()] * (width - len(row)))[:width]]
        rows = "".join(f"{self._content(cell)}, " for cell in cells)
        note, number = quoted(remark(block.record, self.lang)), self._number("", block.own)
        return f"#data-table({width}, ({aligns},), ({header}), ({rows}), {note}, number: {number})"

    def _list(self, block: s.Listing) -> str:
        items = ", ".join(f"[{self._body(item)}]" for item in block.items)
        return f"#list({items})" if block.start is None else f"#enum(start: {block.start}, {items})"

    def _quote(self, block: s.Quote) -> str:
        body = f"[{self._body(block.blocks)}]"
        if block.kind == "erratum":
            return f"#erratum-block({quoted(say('erratum', self.lang))}){body}"
        return f"#{'solution' if block.kind == 'solution' else 'quoted'}-block{body}"

    def _picture(self, block: s.Picture) -> str:
        width = "none" if block.width is None else f"{block.width:g}mm"
        caption = self._content(block.caption) if block.caption else "none"
        return f"#picture({quoted(self.names[block.path])}, {width}, {caption})"

    # -- words ------------------------------------------------------------------------------------------------------

    def _content(self, parts: Sequence[s.Inline]) -> str:
        return f"[{''.join(self._part(part) for part in parts)}]"

    def _part(self, part: s.Inline) -> str:
        if isinstance(part, s.Text):
            return escaped(part.text, self.lang)
        if isinstance(part, s.Styled):
            return f"#{'strong' if part.kind == 'strong' else 'emph'}{self._content(part.parts)};"
        if isinstance(part, s.Code):
            return f"#raw({quoted(part.text)});"
        if isinstance(part, s.Formula):
            whole = sum(piece.width for piece in part.pieces) < _WHOLE
            written = " ".join(map(_within_words, part.pieces))
            return f"#box[{written}];" if whole else written
        if isinstance(part, s.Link):
            return f"#link({quoted(part.target)}){self._content(part.parts)};"
        return "#linebreak();"


def _within_words(piece: Box) -> str:
    mathematics = f"${typst_mathematics(piece.markup)}$"
    if "<mtable" not in piece.markup:
        return mathematics
    return f"#box[#set par(leading: 0pt)\n{mathematics}]"  # a line is as high as a matrix in it


def _line(line: Line) -> str:
    statements = (f"({''.join(f'{piece}, ' for piece in statement)})" for statement in _joined(line))
    return f"({''.join(f'{statement}, ' for statement in statements)})"


def _joined(line: Line) -> list[list[str]]:
    """Return the pieces of each statement; what a word or an arrow joins is one statement."""
    statements: list[list[str]] = []
    joint = ""
    for statement in line:
        written = [typst_mathematics(piece.markup) for piece in statement]
        if len(statement) == 1 and _JOINT.fullmatch(statement[0].markup):
            joint += f"joint({written[0]})"
        elif joint and statements:
            statements[-1] += [f"{joint}{written[0]}", *written[1:]]
            joint = ""
        else:
            statements.append([f"{joint}{written[0]}", *written[1:]])
            joint = ""
    if joint:
        statements.append([joint])
    return [[f"box($display({piece})$)" for piece in statement] for statement in statements]


def escaped(text: str, lang: str) -> str:
    """Return words as Typst text in which nothing is markup."""
    words = "".join(" " if unicodedata.category(c) == "Cc" else c for c in text)
    if lang == "fr":
        words = _FRENCH.sub("\u00a0", words)
    return _SPECIAL.sub(lambda found: f"\\{found.group()}", words)


def quoted_lines(text: str) -> str:
    """Return lines of code as a string of Typst."""
    return "(" + " + ".join(f'{quoted(line)} + "\\n"' for line in text.strip("\n").split("\n")) + ")"


def check_installed() -> None:
    """Raise PrintError where Typst is not installed."""
    if find_spec("typst") is None:
        raise PrintError(MISSING)


def write_pdf(sheet: s.Sheet) -> bytes:
    """Return a sheet as PDF.

    Typst sees a folder of its own with the source, the template and the pictures, and nothing else.

    Raises:
        PrintError: Typst is not installed, or cannot typeset the sheet (a picture that is none).
    """
    check_installed()
    import typst

    with tempfile.TemporaryDirectory(prefix="armproof-sheet-") as name:
        folder = Path(name)
        names = _copy_pictures(sheet, folder)
        template = resources.files("armproof.course.printing").joinpath("templates", "sheet.typ")
        (folder / "sheet.typ").write_text(template.read_text(encoding="utf-8"), encoding="utf-8")
        main = folder / "main.typ"
        main.write_text(TypstWriter(sheet, names).source(), encoding="utf-8")
        try:
            pdf = typst.compile(str(main), root=str(folder), ignore_system_fonts=True, format="pdf", timestamp=0)
        except typst.TypstError as error:
            raise PrintError("it cannot be typeset: {reason}", reason=str(error).strip().splitlines()[0]) from None
    return bytes(pdf)


def _copy_pictures(sheet: s.Sheet, folder: Path) -> dict[Path, str]:
    names: dict[Path, str] = {}
    for block in s.walk(sheet.blocks):
        if isinstance(block, s.Picture) and block.path not in names:
            names[block.path] = f"picture-{len(names) + 1}{block.path.suffix.lower()}"
            shutil.copyfile(block.path, folder / names[block.path])
    return names
