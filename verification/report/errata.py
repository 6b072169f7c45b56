"""The errata sheet of a class: where each mistake stands, what is printed, what is right and why, the gravest first.

Its sentences are findings, and a notation (Markdown, LaTeX) says how their words, names and formulas are written. It holds no
display and no date: it is no document to be verified itself, and the same verdicts give the same bytes.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field
from pathlib import Path

from armproof.models.language import look_up, number_text
from armproof.verification.correction import corrected_latex
from armproof.verification.findings import Finding, Kind, say
from armproof.verification.findings.finding import Piece, distinct, pieces
from armproof.verification.latex.unicode import normalise_unicode
from armproof.verification.latex.writer import symbol_as_latex
from armproof.verification.patterns import regex
from armproof.verification.report.headings import sentences_of
from armproof.verification.report.text import ordered_records
from armproof.verification.verdict import DocumentResult, Record, Verdict, WrongEntry

_ERRATUM = regex(r"[>%\s.]*(?:\\\w+\{?)*[*_]*errat(?:um|a)\b[*_}:.\s]*", re.IGNORECASE)
_NAMED = regex(  # each left side that is short, where an equation begins: in x = …, y = … there are two
    r"(?=(?:^|\\\\|\\q?quad|\\(?:begin|text)\{[^{}]*\}|[,;&])((?:(?!\\(?:begin|left|frac|text|q?quad)(?![a-z])|\\\\)[^=&<>\[|]){1,60})&?=)"
)
_FORMULA = regex(r"\$([^$]+)\$")
_SPACING = regex(r"(\\\\)\s*\[[^\]]*\]")
_RESTATES = (Kind.WRONG_ENTRY, Kind.SAME_ERROR)  # what the lines of the sheet say already
NEAR = 8  # lines above a display in which its erratum begins
LONGEST = 300  # characters of what a source says of its erratum

Spelled = Iterable[tuple[str, Piece]]


@dataclass(frozen=True)
class Notation:
    """How a sheet is written: words, names and formulas; its title, the heading of a mistake, what is said of it, the whole."""

    words: Callable[[str], str]
    name: Callable[[str], str]
    title: str
    heading: str
    source: str
    item: str
    whole: str

    def write(self, spelled: Spelled) -> str:
        """Return a sentence."""
        write = {Piece.WORDS: self.words, Piece.NAME: self.name, Piece.LATEX: _formula}
        return "".join(write[piece](text) for text, piece in spelled)


@dataclass
class Mistake:
    """A refuted display or table, and the lines of its document in which the same error stands again."""

    path: str
    record: Record
    kind: str
    again: list[int] = field(default_factory=list)

    @property
    def gravity(self) -> tuple[int, ...]:
        """What sorts it: whether it is accepted; a table, of which all else is computed; what is carried on; what no entry mends; many entries."""
        return (
            self.record.is_accepted,
            self.kind != "table",
            -len(self.again),
            bool(self.record.entries),
            -len(self.record.entries),
        )


def mistakes(result: DocumentResult) -> list[Mistake]:
    """Return what is refuted in a document, its errata among it; an error said again stands with the first."""
    found: dict[tuple[int | str | None, int], Mistake] = {}
    for record, kind in ordered_records(result):
        if record.verdict is not Verdict.REFUTED:
            continue
        line = next((f.terms["line"] for f in record.findings if f.kind is Kind.SAME_ERROR), 0)
        if record.cell is None and not record.file and (None, line) in found:
            found[None, line].again.append(record.line)
        else:
            found[record.file or record.cell, record.line] = Mistake(result.path, record, kind)
    return list(found.values())


def write_sheet(found: Iterable[Mistake], notation: Notation) -> str:
    """Return the sheet of mistakes, the gravest first."""
    ordered = sorted(found, key=lambda mistake: mistake.gravity)
    documents = len({mistake.path for mistake in ordered})
    number = say(Kind.ERRATA_COUNT, mistakes=len(ordered), documents=documents) if ordered else say(Kind.NO_ERRATA)
    parts = [notation.title.format(look_up("Errata")), notation.write(pieces(number)), "\n\n"]
    parts += [_one(index, mistake, notation) for index, mistake in enumerate(ordered, 1)]
    return notation.whole.format("".join(parts))


def _one(index: int, mistake: Mistake, notation: Notation) -> str:
    record = mistake.record
    place = Kind.ERRATA_PLACE if record.cell is None else Kind.ERRATA_PLACE_IN_CELL
    where = say(place, index=index, path=record.file or Path(mistake.path).name, line=record.line, cell=record.cell)
    section = look_up(": ") + sentences_of(mistake.path)(record.section) if record.section else ""
    lines = [notation.heading.format(notation.write([*pieces(where), *_spelled(section)]))]
    if source := _said_by_source(Path(mistake.path).parent / (record.file or Path(mistake.path).name), record):
        lines.append(notation.source.format(notation.write(_spelled(source))))
    lines += [notation.item.format(notation.write(pieces(said))) for said in _said(mistake)]
    return "".join(lines) + "\n"


def _said(mistake: Mistake) -> Iterator[Finding]:
    """Yield what is printed and what is right, why, an example, and where it stands again."""
    record = mistake.record
    told_name = ""
    for entry in record.entries:
        name = _name_of_formula(record.latex, entry)
        if name and name != told_name:
            yield say(Kind.IN_FORMULA, name=name)
        told_name = name
        terms = {"printed": entry.printed, "correct": entry.correct}
        change = entry.finding is not None
        said = say(Kind.PRINTED_BECAUSE, **terms, change=entry.finding) if change else say(Kind.PRINTED_RIGHT, **terms)
        yield said.at(row=entry.row, column=entry.column)
    if not record.entries:
        yield say(Kind.PRINTED, printed=record.latex) if record.latex else say(Kind.PRINTED_WHOLE)
        if (correct := corrected_latex(record)) is not None:
            yield say(Kind.RIGHT, correct=correct)
    told = [entry.finding for entry in record.entries if entry.finding is not None]
    reasons = [f for f in record.findings if f.kind not in _RESTATES and not any(f.holds(each) for each in told)]
    yield from (say(Kind.WHY, reason=reason) for reason in distinct(reasons))
    if record.counterexample:
        values = record.counterexample.items()
        yield say(Kind.FOR_EXAMPLE, values=[f"{symbol_as_latex(name)} = {_decimal(value)}" for name, value in values])
    if mistake.again:
        yield say(Kind.ALSO_IN, lines=mistake.again)


def _decimal(value: float) -> str:
    """Return a number as it stands in a formula: a comma with no space behind it."""
    return number_text(value, ".6g").replace(",", "{,}")


def _name_of_formula(latex: str, entry: WrongEntry) -> str:
    """Return the left side of the equation in which an entry stands; empty where that is long, or not sure."""
    end = entry.span[0] if entry.span else len(latex)
    names = [name for found in _NAMED.finditer(normalise_unicode(latex), 0, end) if _is_whole(name := found[1].strip())]
    return names[-1] if names and (entry.span or len(names) == 1) else ""


def _is_whole(name: str) -> bool:
    """Whether it is no piece of something in brackets."""
    return bool(name) and all(name.count(left) == name.count(right) for left, right in ("{}", "()"))


def _said_by_source(path: Path, record: Record) -> str:
    """Return what stands behind the word Erratum: (slide 41, as printed)."""
    if not record.erratum or record.cell is not None or path.suffix == ".ipynb":
        return ""
    try:
        above = path.read_text(encoding="utf-8").split("\n")[max(0, record.line - NEAR) : record.line]
    except (OSError, UnicodeDecodeError):
        return ""
    begins = next((k for k in reversed(range(len(above))) if _ERRATUM.match(above[k])), None)
    if begins is None:
        return ""
    said = " ".join(line.lstrip("> %") for line in above[begins:])
    said = sentences_of(path)(re.split(r"\$\$|\\\[|\\begin|\.\. math", said)[0].strip())
    text = " ".join(_ERRATUM.sub("", said, count=1).replace("*", "").split())
    return text[:LONGEST].removeprefix("(").removesuffix(")")


def _spelled(text: str) -> Spelled:
    """Yield the words and the formulas of a line of a document."""
    for index, part in enumerate(_FORMULA.split(text)):
        yield part, Piece.LATEX if index % 2 else Piece.WORDS


def _formula(latex: str) -> str:
    """Return a formula on one line, without what opens a display, $$ or the bracket behind a line of a matrix."""
    text = " ".join(normalise_unicode(latex).split())
    return f"${_SPACING.sub(lambda found: found[1], text)}$"


def _markdown_words(text: str) -> str:
    return re.sub(r"([\\`*_<>\[\]$|#])", r"\\\1", text)


_TEX = {
    "\\": r"\textbackslash{}",
    "~": r"\textasciitilde{}",
    "^": r"\textasciicircum{}",
    "\u00a0": "~",
    "\u202f": r"\,",
}


def _tex_words(text: str) -> str:
    def spelled(character: str) -> str:
        if character in "&%$#_{}":
            return "\\" + character
        latex = normalise_unicode(character)
        return _TEX.get(character) or (character if latex == character else f"${latex.strip()}$")

    return "".join(map(spelled, text))


MARKDOWN = Notation(
    words=_markdown_words,
    name=lambda text: f"`{text}`",
    title="# {}\n\n",
    heading="## {}\n\n",
    source="*{}*\n\n",
    item="- {}\n",
    whole="{}",
)
TEX = Notation(
    words=_tex_words,
    name=lambda text: rf"\texttt{{{_tex_words(text)}}}",
    title="\\section*{{{}}}\n\n",
    heading="\\subsection*{{{}}}\n\n",
    source="\\emph{{{}}}\n\n",
    item="\\par\\hangindent=1em $\\bullet$ {}\n",
    whole=(
        "\\documentclass[11pt,a4paper]{{article}}\n\\usepackage[utf8]{{inputenc}}\n\\usepackage[T1]{{fontenc}}\n"
        "\\usepackage{{amsmath,amssymb,bm}}\n\\setlength{{\\parindent}}{{0pt}}\n\\begin{{document}}\n\n{}\\end{{document}}\n"
    ),
)
