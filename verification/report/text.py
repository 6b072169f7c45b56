"""The report for people: a line a document, then what does not pass in it, then a total."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace

from verification.batch import Failure
from verification.report.lines import Line
from verification.verdict import DocumentResult, Record, Verdict, WrongEntry

LONGEST = 600  # characters of a message or of an entry
GOOD, BAD, WARN, FAINT, STRONG = "green", "bold red", "yellow", "dim", "bold"
_ORDER = (Verdict.PROVED, Verdict.CONFIRMED, Verdict.DEFINED, Verdict.REFUTED, Verdict.UNCHECKED, Verdict.UNREADABLE)
_STYLES = {Verdict.REFUTED: BAD, Verdict.UNREADABLE: BAD, Verdict.UNCHECKED: WARN}


def text_report(results: Sequence[DocumentResult | Failure], *, strict: bool = False) -> list[Line]:
    """Return the report of the documents that could be checked; those that could not are only counted."""
    lines: list[Line] = []
    for result in results:
        if isinstance(result, DocumentResult):
            lines.extend(_describe_document(result, strict))
    *totals, verdict = describe_total(results, strict=strict)
    passed = all(isinstance(result, DocumentResult) and passes(result, strict) for result in results)
    if lines:
        lines.append(())
    return [*lines, *(((total, STRONG),) for total in totals), ((verdict, GOOD if passed else BAD),)]


def passes(result: DocumentResult, strict: bool) -> bool:
    """Whether a document passes; with `strict`, an unchecked display does not."""
    return result.passed_strictly() if strict else result.passed


def ordered_records(result: DocumentResult) -> list[tuple[Record, str]]:
    """Return the displays and the tables of a document as they stand in it, each with what it is ("" for a display).

    Only a notebook's lines count within their cells: elsewhere `cell` is None.
    """
    records = [(record, "") for record in result.equations] + [(record, "table") for record in result.tables]
    if not result.path.endswith(".ipynb"):
        records = [(replace(record, cell=None), kind) for record, kind in records]
    return sorted(records, key=lambda item: (-1 if item[0].cell is None else item[0].cell, item[0].line))


def describe_total(results: Sequence[DocumentResult | Failure], *, strict: bool = False) -> list[str]:
    """Return the total in words: what the displays came to, and how many documents pass."""
    documents = [result for result in results if isinstance(result, DocumentResult)]
    records = [record for document in documents for record in document.equations]
    tables = [record for document in documents for record in document.tables]
    lines = []
    if documents:
        of_tables = f"; {_tally(tables, 'table')}" if tables else ""
        lines.append(f"{_count(len(documents), 'document')}, {_tally(records, 'display')}{of_tables}")
    errors = [record.max_error for record in (*records, *tables) if record.max_error is not None and record.samples]
    if errors:
        samples = max(record.samples for record in (*records, *tables))
        lines.append(
            f"evaluated on Drake's numerical plant at {samples:,} configurations: largest error {max(errors):.1e}"
        )
    failing = sum(not passes(document, strict) for document in documents)
    unable = len(results) - len(documents)
    verdicts = [f"{_count(failing, 'document')} {'does' if failing == 1 else 'do'} not pass"] if failing else []
    if unable:
        verdicts.append(f"{unable} could not be checked")
    return [*lines, "; ".join(verdicts) or "everything passes"]


def describe_place(record: Record) -> str:
    """Return where a display stands: "line 41", or "cell 3, line 5" in a notebook."""
    return f"line {record.line}" if record.cell is None else f"cell {record.cell}, line {record.line}"


def describe_entry(entry: WrongEntry, record: Record) -> str:
    """Return a wrong entry of a display on one line."""
    change = f" ({entry.change})" if entry.change else ""
    cell = _cell(entry, record)
    return f"{cell}{': ' if cell else ''}printed {_short(entry.printed)}, correct {_short(entry.correct)}{change}"


# -- one document ------------------------------------------------------------------------------------------------------


def _describe_document(result: DocumentResult, strict: bool) -> Iterator[Line]:
    passed = passes(result, strict)
    tables = f"; {_tally(result.tables, 'table')}" if result.tables else ""
    arm = f" ({result.arm})" if result.arm else ""
    yield (
        ("passes " if passed else "FAILS  ", GOOD if passed else BAD),
        (result.path, STRONG),
        (arm, FAINT),
        (f"  {_tally(result.equations, 'display')}{tables}", ""),
    )
    records = ordered_records(result)
    for record, kind in records:
        if not record.passes or record.verdict is Verdict.UNCHECKED:
            yield from _describe_record(record, kind)
    errata = [record for record, _ in records if record.erratum and record.passes]
    if errata:
        yield ((f"    errata refuted, as they must be: {_places(errata)}", FAINT),)


def _describe_record(record: Record, kind: str) -> Iterator[Line]:
    section = f"  {record.section}" if record.section else ""
    what = f"{kind} " if kind else ""
    verdict = f"erratum not refuted but {record.verdict.value}" if record.erratum else record.verdict.value
    style = BAD if not record.passes else _STYLES.get(record.verdict, "")
    yield (("    ", ""), (describe_place(record), STRONG), ("  ", ""), (what + verdict, style), (section, FAINT))
    if record.message:
        yield (("        ", ""), (_short(record.message), ""))
    for entry in record.entries:
        cell = f"{_cell(entry, record)}   " if _cell(entry, record) else ""
        change = ((f"   ({entry.change})", FAINT),) if entry.change and entry.change not in record.message else ()
        yield ((f"        {cell}printed  ", ""), (_short(entry.printed), BAD))
        yield ((f"        {'':{len(cell)}}correct  ", ""), (_short(entry.correct), GOOD), *change)
    if record.counterexample:
        values = ", ".join(f"{symbol} = {value:.6g}" for symbol, value in record.counterexample.items())
        yield (("        ", ""), (f"for example at {values}", FAINT))


def _cell(entry: WrongEntry, record: Record) -> str:
    """Return where in its display an entry stands: "equation 2, row 1, column 3", as far as there is more than one."""
    equation = [f"equation {entry.equation}"] if record.latex.count("=") > 1 else []
    place = [] if entry.row is None else [f"row {entry.row}", f"column {entry.column}"]
    return ", ".join(equation + place)


def _short(text: str) -> str:
    """Return a text without what nobody reads; the JSON report has it whole."""
    return text if len(text) <= LONGEST else f"{text[: LONGEST - 4]} ..."


def _places(records: Sequence[Record]) -> str:
    if len(records) == 1:
        return describe_place(records[0])
    if any(record.cell is not None for record in records):
        return "; ".join(map(describe_place, records))
    return "lines " + ", ".join(str(record.line) for record in records)


def _errata(number: int) -> str:
    return "1 erratum" if number == 1 else f"{number} errata"


def _count(number: int, noun: str) -> str:
    return f"{number} {noun}" if number == 1 else f"{number} {noun}s"


def _tally(records: Iterable[Record], noun: str) -> str:
    """Return "12 displays: 8 proved, 1 refuted, 3 errata refuted"; an erratum that is refuted is as it should be."""
    records = list(records)
    counts = Counter(record.verdict for record in records if not (record.erratum and record.passes))
    words = [f"{counts[verdict]} {verdict.value}" for verdict in _ORDER if counts[verdict]]
    errata = sum(record.erratum and record.passes for record in records)
    if errata:
        words.append(f"{_errata(errata)} refuted")
    return f"{_count(len(records), noun)}" + (f": {', '.join(words)}" if words else "")
