"""The corrected copy of a document: its text with only what is wrong changed, checked again until nothing more mends."""

from __future__ import annotations

from codecs import BOM_UTF8
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import zip_longest
from pathlib import Path

from armproof.verification.check import check_document
from armproof.verification.correction.record import applied
from armproof.verification.correction.tables import cell_spans
from armproof.verification.document import SUFFIXES, Display, Document, Table, parse_document
from armproof.verification.document.front_matter import read_bytes, read_text, suffix_of
from armproof.verification.document.rewriting import Change, change_of, change_of_cell, rewrite
from armproof.verification.errors import DocumentError
from armproof.verification.findings import Kind, say
from armproof.verification.running.atomic import write_atomically
from armproof.verification.verdict import DocumentResult, Record, Verdict

MOST_ROUNDS = 8  # what a display defines, the next ones build on


@dataclass(frozen=True)
class CorrectedCopy:
    """A document's text and verdicts before and after its correction."""

    path: Path
    before: str
    after: str
    first: DocumentResult
    result: DocumentResult

    @property
    def remaining(self) -> tuple[Record, ...]:
        """What does not pass in the corrected copy."""
        return tuple(record for record in self.result.records if not record.passes)


@dataclass(frozen=True)
class _Mending:
    """The changes that mend one display or one table."""

    index: int  # of the display or the table in its document
    changes: tuple[Change, ...]
    latex: str  # the display as it is to be read then; "" for a table


def correct_file(path: Path) -> CorrectedCopy:
    """Return the corrected copy of a document file; raises DocumentError where it is none."""
    if not path.exists():
        raise DocumentError(say(Kind.NO_SUCH_FILE), path=path)
    if not path.is_file():
        raise DocumentError(say(Kind.NOT_ONE_FILE), path=path)
    if suffix_of(path) not in SUFFIXES:
        raise DocumentError(say(Kind.UNKNOWN_SUFFIX, suffix=path.suffix, suffixes=list(SUFFIXES)), path=path)
    return correct_text(path, read_text(path))


def save(copy: CorrectedCopy, target: Path) -> None:
    """Write a corrected copy; raises DocumentError where the document has changed since it was read, OSError as usual."""
    original = read_bytes(copy.path)
    mark = BOM_UTF8 if original.startswith(BOM_UTF8) else b""
    if original != mark + copy.before.encode("utf-8"):
        raise DocumentError(say(Kind.HAS_CHANGED), path=copy.path)
    data = mark + copy.after.encode("utf-8")
    if not (target.exists() and target.read_bytes() == data):
        write_atomically(target, data)


def correct_text(path: Path, text: str) -> CorrectedCopy:
    """Return the corrected copy of a document's text; errata stay as they are.

    `path` says how the text is read. What cannot be mended is left as it is. Raises DocumentError where the document as a
    whole cannot be checked.
    """
    before = text
    document = parse_document(path, text)
    first = result = check_document(document, correct=True)
    for _ in range(MOST_ROUNDS):
        mendings = [*_of_displays(document, result), *_of_tables(document, result)]
        text, document, progress = _made(path, text, document, mendings)
        if not progress:
            break
        result = check_document(document, correct=True)
    return CorrectedCopy(path, before, text, first, result)


def _of_displays(document: Document, result: DocumentResult) -> Iterator[_Mending]:
    notebook = suffix_of(document.path) == ".ipynb"
    for index, (display, record) in enumerate(zip(document.displays, result.equations, strict=True)):
        if record.erratum or record.passes or record.verdict is not Verdict.REFUTED or not record.corrections:
            continue
        changes = [change_of(display, c.start, c.end, c.text, in_notebook=notebook) for c in record.corrections]
        known = tuple(change for change in changes if change is not None)
        if len(known) == len(changes):
            yield _Mending(index, known, applied(display.latex, record.corrections))


def _of_tables(document: Document, result: DocumentResult) -> Iterator[_Mending]:
    records = {(record.cell, record.line): record for record in result.tables}
    notebook = suffix_of(document.path) == ".ipynb"
    for index, table in enumerate(document.tables):
        record = records.get((table.cell, table.line))
        if record is None or record.erratum or record.is_accepted or not record.corrections:
            continue
        places = {span: place for place, span in cell_spans(table).items()}
        changes = [
            change_of_cell(table, *places[c.start, c.end], c.text, in_notebook=notebook) for c in record.corrections
        ]
        known = tuple(change for change in changes if change is not None)
        if len(known) == len(changes):
            yield _Mending(index, known, "")


def _made(path: Path, text: str, document: Document, mendings: Sequence[_Mending]) -> tuple[str, Document, bool]:
    """Return the text and the document with the mendings that are read again as they are meant, and whether any is."""
    made: list[_Mending] = []
    best = text, document
    for tried in (list(mendings), *([*made, mending] for mending in mendings)):
        if not tried or len(tried) <= len(made):
            continue
        try:
            changed = rewrite(suffix_of(path), text, [change for mending in tried for change in mending.changes])
            read = parse_document(path, changed)
        except (DocumentError, ValueError):
            continue
        if _is_as_meant(document, read, tried):
            made, best = tried, (changed, read)
        if len(made) == len(mendings):
            break
    return *best, bool(made)


def _is_as_meant(before: Document, after: Document, mendings: Sequence[_Mending]) -> bool:
    """Whether nothing but the mended displays and tables differs, and those read as they should."""
    meant = {mending.index: mending.latex for mending in mendings if mending.latex}
    tables = {mending.index for mending in mendings if not mending.latex}
    return all(
        _same(old, new, meant.get(index))
        for index, (old, new) in enumerate(zip_longest(before.displays, after.displays))
    ) and all(
        _same_table(old, new, index in tables)
        for index, (old, new) in enumerate(zip_longest(before.tables, after.tables))
    )


def _same(old: Display | None, new: Display | None, meant: str | None) -> bool:
    if old is None or new is None:
        return False
    latex = old.latex if meant is None else meant
    return replace(new, latex="", line=0) == replace(old, latex="", line=0) and latex.split() == new.latex.split()


def _same_table(old: Table | None, new: Table | None, changed: bool) -> bool:
    if old is None or new is None:
        return False
    sizes = [[len(row) for row in (table.header, *table.rows)] for table in (old, new)]
    return sizes[0] == sizes[1] and (changed or replace(old, line=0) == replace(new, line=0))
