"""The report for people: a line a document, then what does not pass in it, then a total."""

from __future__ import annotations

import locale
import re
import sys
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from typing import TextIO
from unicodedata import combining, normalize

from armproof.models.errors import written
from armproof.models.language import ENGLISH, look_up, noted, number_text, of_document, spoken
from armproof.verification.latex.greek import NAMES
from armproof.verification.report.headings import with_headings
from armproof.verification.report.totals import Tally, Totals, passes
from armproof.verification.verdict import DocumentResult, EquationResult, Failure, Record, Verdict, WrongEntry

Span = tuple[str, str]  # a text and its style, "" for none
Line = tuple[Span, ...]

_ASCII = {
    **NAMES,
    **dict(zip("×·−–—…≤≥≠≈°′“”‘’∈±²³√", "x * - - - ... <= >= != ~ deg ' \" \" ' ' in +- ^2 ^3 sqrt".split(), strict=True)),
    "⇒": "=>", "⇐": "<=", "⇔": "<=>", "→": "->", "←": "<-",
    "₀": "_0", "₁": "_1", "₂": "_2", "₃": "_3", "₄": "_4", "₅": "_5", "₆": "_6", "₇": "_7", "₈": "_8", "₉": "_9",
}  # fmt: skip
LONGEST = 600  # characters of a message or of an entry
GOOD, BAD, WARN, FAINT, STRONG = "green", "bold red", "yellow", "dim", "bold"
_STYLES = {Verdict.REFUTED: BAD, Verdict.UNREADABLE: BAD, Verdict.UNCHECKED: WARN}


def write_lines(lines: Iterable[Line], stream: TextIO | None = None) -> None:
    """Write styled lines to a stream, by default standard output; never wrapped, so that formulas can be copied."""
    stream = stream or sys.stdout
    if stream.isatty():
        from rich.console import Console
        from rich.text import Text

        console = Console(file=stream, highlight=False, markup=False, emoji=False, soft_wrap=True)
        for line in lines:
            console.print(Text.assemble(*((_printable(text, stream), style) for text, style in line)))
        return
    for line in lines:
        stream.write(_printable("".join(text for text, _ in line), stream) + "\n")


def _printable(text: str, stream: TextIO) -> str:
    """Return a text without control characters (a document may hold any), in the characters that the stream can write."""
    text = re.sub(r"\s+", " ", text) if re.search(r"[\t\n\r\f\v]", text) else text
    text = re.sub(r"[\x00-\x1f\x7f-\x9f]", "?", text)
    return text if _writes_unicode(stream) else to_ascii(text)


def to_ascii(text: str) -> str:
    """Spell a text in ASCII: θ as theta, ⇒ as =>, é as e, and what has no spelling as its code."""
    spelled = "".join(_ASCII.get(character, character) for character in text)
    spelled = "".join(character for character in normalize("NFKD", spelled) if not combining(character))
    return spelled.encode("ascii", "backslashreplace").decode("ascii")


def _writes_unicode(stream: TextIO) -> bool:
    """Whether the stream is meant for Unicode: Python writes UTF-8 in the C locale too, where nobody may read it."""
    encoding = (getattr(stream, "encoding", None) or "ascii").lower().replace("-", "")
    return encoding.startswith("utf") and locale.setlocale(locale.LC_CTYPE) not in ("C", "POSIX")


def text_report(
    results: Iterable[DocumentResult | Failure], *, strict: bool = False, verbose: bool = False
) -> Iterator[Line]:
    """Yield the report of the documents that could be checked, as they come; those that could not are only counted.

    Args:
        strict: whether an unchecked equation fails its document.
        verbose: whether the reading of every equation is told as well.
    """
    totals = Totals(strict)
    for result in results:
        totals.add(result)
        if isinstance(result, DocumentResult):
            with of_document(result.front):
                result = result if spoken() == ENGLISH else with_headings(result)
                lines = [*describe_document(result, strict), *(describe_readings(result) if verbose else ())]
            yield from lines
    if totals.documents:
        yield ()
    yield from (((line, STRONG),) for line in totals.numbers())
    yield ((totals.verdict, (WARN if totals.undecided else GOOD) if totals.passed else BAD),)
    yield from ((("  " + cause, ""),) for cause in totals.undecided.causes())


def ordered_records(result: DocumentResult) -> list[tuple[Record, str]]:
    """Return the displays and the tables of a document as they stand in it, each with what it is ("" for a display).

    Only a notebook's lines count within their cells: elsewhere `cell` is None.
    """
    records = [(record, "") for record in result.equations] + [(record, "table") for record in result.tables]
    records += [(result.inverse, noted("inverse kinematics"))] if result.inverse is not None else []
    numbered = result.path.endswith(".ipynb") or any(record.file for record, _ in records)
    by_place = sorted(
        records, key=lambda item: (-1 if not numbered or item[0].cell is None else item[0].cell, item[0].line)
    )
    if result.path.endswith(".ipynb"):
        return by_place
    return [(replace(record, cell=None), kind) for record, kind in by_place]


def describe_place(record: Record) -> str:
    """Return where a display stands: "line 41", "chapters/dh.tex, line 3", or "cell 3, line 5" in a notebook."""
    if record.file:
        return f"{record.file}, {written('line {line}', line=record.line)}"
    if record.cell is None:
        return written("line {line}", line=record.line)
    return written("cell {cell}, line {line}", cell=record.cell, line=record.line)


def describe_verdict(record: Record, kind: str = "") -> str:
    """Return the verdict of a record: "table refuted", "erratum not refuted but proved"."""
    verdict = look_up(record.verdict)
    if record.erratum:
        return f"{look_up(kind)} {written('erratum not refuted but {verdict}', verdict=verdict)}".strip()
    return f"{look_up(kind)} {verdict}".strip()


def describe_entry(entry: WrongEntry, record: Record) -> str:
    """Return a wrong entry of a display on one line."""
    change = f" ({entry.change})" if entry.change else ""
    cell = _cell(entry, record)
    told = written("printed {printed}, correct {correct}", printed=_short(entry.printed), correct=_short(entry.correct))
    return f"{cell}{': ' if cell else ''}{told}{change}"


# -- one document ------------------------------------------------------------------------------------------------------


def describe_document(result: DocumentResult, strict: bool) -> Iterator[Line]:
    """Yield the lines on a document: whether it passes, what its displays came to, then what does not pass in it."""
    passed = passes(result, strict)
    tables = f"{look_up('; ')}{Tally('table', result.tables)}" if result.tables else ""
    arm = f" ({result.told_arm})" if result.told_arm else ""
    yield (
        (look_up("passes ") if passed else look_up("FAILS  "), GOOD if passed else BAD),
        (result.path, STRONG),
        (arm, FAINT),
        (f"  {Tally('display', result.equations)}{tables}", ""),
    )
    yield from (((f"    {remark}", FAINT),) for remark in result.remarks)
    if result.inverse is not None and result.inverse.passes and result.inverse.verdict is not Verdict.UNCHECKED:
        verdict, message = look_up(result.inverse.verdict), _short(result.inverse.message)
        words = written("inverse kinematics {verdict}: {message}", verdict=verdict, message=message)
        yield ((f"    {words}", FAINT),)
    records = ordered_records(result)
    for record, kind in records:
        if not record.passes or record.verdict is Verdict.UNCHECKED or record.accept is not None:
            yield from describe_record(record, kind)
    errata = [record for record, _ in records if record.erratum and record.passes and not record.is_accepted]
    if errata:
        yield (("    " + written("errata refuted, as they must be: {places}", places=_places(errata)), FAINT),)


def describe_readings(result: DocumentResult) -> Iterator[Line]:
    """Yield a line an equation: what it is, what its verdict is, and what it was read as."""
    for record, _ in ordered_records(result):
        for each in record.outcomes:
            place = describe_place(record)
            if len(record.outcomes) > 1:
                place += ", " + written("equation {number}", number=each.index)
            yield (("    " + written("{place}: {reading}", place=place, reading=describe_reading(each)), FAINT),)


def describe_reading(result: EquationResult) -> str:
    """Return "claim, proved: origin of frame 2 in frame 0"."""
    verdict = f"{look_up(result.role)}, {look_up(result.verdict)}"
    return written("{verdict}: {reading}", verdict=verdict, reading=result.read_as) if result.read_as else verdict


def describe_record(record: Record, kind: str) -> Iterator[Line]:
    """Yield the lines on a display or a table that does not pass: what is printed, what is correct, for example where."""
    section = f"  {record.section}" if record.section else ""
    style = BAD if not record.passes else _STYLES.get(record.verdict, "")
    yield (
        ("    ", ""),
        (describe_place(record), STRONG),
        ("  ", ""),
        (describe_verdict(record, kind), style),
        (section, FAINT),
    )
    if record.message:
        yield (("        ", ""), (_short(record.message), ""))
    for entry in record.entries:
        cell = f"{_cell(entry, record)}   " if _cell(entry, record) else ""
        change = ((f"   ({entry.change})", FAINT),) if _is_news(entry, record) else ()
        yield ((f"        {cell}{look_up('printed')}  ", ""), (_short(entry.printed), BAD))
        yield ((f"        {'':{len(cell)}}{look_up('correct')}  ", ""), (_short(entry.correct), GOOD), *change)
    if record.counterexample:
        values = [f"{symbol} = {number_text(value, '.6g')}" for symbol, value in record.counterexample.items()]
        yield (("        ", ""), (written("for example at {values}", values=values), FAINT))


def _cell(entry: WrongEntry, record: Record) -> str:
    """Return where in its display an entry stands: "equation 2, row 1, column 3", as far as there is more than one."""
    equation = [written("equation {number}", number=entry.equation)] if record.latex.count("=") > 1 else []
    place = written("row {row}, column {column}", row=entry.row, column=entry.column)
    return ", ".join([*equation, *([place] if entry.row is not None else [])])


def _is_news(entry: WrongEntry, record: Record) -> bool:
    """Whether an entry's change is not said by the findings already."""
    return entry.finding is not None and not any(finding.holds(entry.finding) for finding in record.findings)


def _short(text: str) -> str:
    """Return a text without what nobody reads; the JSON report has it whole."""
    return text if len(text) <= LONGEST else f"{text[: LONGEST - 4]} ..."


def _places(records: Sequence[Record]) -> str:
    if len(records) == 1:
        return describe_place(records[0])
    if any(record.cell is not None for record in records):
        return look_up("; ").join(map(describe_place, records))
    return written("lines {lines}", lines=[record.line for record in records])
