"""A document while it is edited: its verdicts kept up to date, each at its place in the text, with what mends it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from armproof.models.errors import ArmproofError
from armproof.verification.correction.record import correction_of, edits
from armproof.verification.document import Display, Document, Table, parse_document
from armproof.verification.document.rewriting import Change, Place, change_of
from armproof.verification.report.text import describe_entry, describe_reading, describe_record
from armproof.verification.running.incremental import IncrementalChecker
from armproof.verification.verdict import Failure, Record, Verdict

Key = tuple[int | None, int, str]  # cell, line and LaTeX


@dataclass(frozen=True)
class Mark:
    """What is said at a place of the text, [start, end), lines from 1 and columns from 0."""

    start: Place
    end: Place
    message: str
    verdict: Verdict
    fails: bool


class EditedDocument:
    """The verdicts of one document, at each moment of its editing; notebooks are those in py:percent."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self._checker = IncrementalChecker(path)
        self._document: Document | None = None
        self._records: dict[Key, Record] = {}
        self._failure: Failure | None = None

    def update(self, text: str) -> Iterator[None]:
        """Check what changed; yields where a display has its new verdict, and may be left there for a newer text."""
        try:
            self._document = parse_document(self.path, text)
            self._failure = None
            for record in self._checker.update(self._document):
                self._records[_key(record)] = record
                yield
            result = self._checker.result
            self._records = {} if result is None else {_key(record): record for record in result.records}
        except ArmproofError as error:
            self._failure, self._checker = Failure.of(self.path, error), IncrementalChecker(self.path)
        yield

    def marks(self) -> Iterator[Mark]:
        """Yield what is said of the text as it was read last: wrong entries at their places, else whole displays."""
        if self._failure is not None:
            line = self._failure.line or 1
            yield Mark((line, 0), (line, 1), self._failure.reason, Verdict.UNREADABLE, True)
            return
        for part, record in self._read():
            if not record.passes or (record.verdict is Verdict.UNCHECKED and not record.is_remark) or record.accept:
                yield from _marks(part, record)

    def hover(self, line: int) -> str:
        """Return what is known of the display or the table on a line: its verdict and reading, true entries, an example."""
        told: list[str] = []
        for part, record in self._read():
            first, last = _lines(part)
            if first <= line <= last:
                told += ["".join(text for text, _ in each).strip() for each in describe_record(record, "")]
                told += [describe_reading(outcome) for outcome in record.outcomes]
        return "\n".join(told)

    def fix(self, line: int) -> list[Change]:
        """Return the changes that mend the refuted display on a line; none where it is not known how."""
        for part, record in self._read():
            first, last = _lines(part)
            if isinstance(part, Display) and first <= line <= last and not record.passes and not record.erratum:
                changes = [change_of(part, c.start, c.end, c.text, in_notebook=False) for c in edits(record)]
                return [change for change in changes if change is not None] if None not in changes else []
        return []

    def _read(self) -> Iterator[tuple[Display | Table, Record]]:
        """Yield the displays and tables with their records, as far as there are any yet."""
        if self._document is None:
            return
        records: dict[tuple[int | None, int], list[Record]] = {}
        for record in list(self._records.values()):
            records.setdefault((record.cell, record.line), []).append(record)
        parts: list[Display | Table] = [*self._document.displays, *self._document.tables]
        for part in parts:
            own = part.latex if isinstance(part, Display) else None
            found = records.get((part.cell, part.line), [])
            yield from ((part, record) for record in found if own in (None, record.latex))


def _key(record: Record) -> Key:
    return record.cell, record.line, record.latex


def _marks(part: Display | Table, record: Record) -> Iterator[Mark]:
    """Yield a mark an entry that has a place; of what has none, one on the first line."""
    left = []
    for entry in record.entries:
        place = None
        if isinstance(part, Display) and entry.span is not None:
            found = correction_of(record.latex, entry)
            place = change_of(part, found.start, found.end, found.text, in_notebook=False)
        if place is not None:
            yield Mark(place.start, place.end, describe_entry(entry, record), record.verdict, not record.passes)
        else:
            left.append(describe_entry(entry, record))
    if left or not record.entries:
        message = "\n".join([record.message, *left]).strip() or record.verdict.value
        yield Mark((part.line, 0), (part.line + 1, 0), message, record.verdict, not record.passes)


def _lines(part: Display | Table) -> tuple[int, int]:
    if isinstance(part, Table):
        return part.line, part.line + len(part.rows) + 1
    return part.line, max([part.line, *(piece.line for piece in part.pieces)])
