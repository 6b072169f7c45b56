"""What the displays of many documents came to, counted one document after the other."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable

from armproof.verification.verdict import DocumentResult, Failure, Record, Verdict

_ORDER = (Verdict.PROVED, Verdict.CONFIRMED, Verdict.DEFINED, Verdict.REFUTED, Verdict.UNCHECKED, Verdict.UNREADABLE)


class Tally:
    """How many records of a kind have which verdict; an erratum that is refuted is as it should be."""

    def __init__(self, noun: str, records: Iterable[Record] = ()) -> None:
        self.noun = noun
        self.verdicts: Counter[Verdict] = Counter()
        self.errata = 0
        for record in records:
            self.add(record)

    def add(self, record: Record) -> None:
        """Count a record."""
        if record.erratum and record.passes:
            self.errata += 1
        else:
            self.verdicts[record.verdict] += 1

    def __len__(self) -> int:
        return self.verdicts.total() + self.errata

    def __str__(self) -> str:
        """Return "12 displays: 8 proved, 1 refuted, 3 errata refuted"."""
        words = [f"{self.verdicts[verdict]} {verdict.value}" for verdict in _ORDER if self.verdicts[verdict]]
        if self.errata:
            words.append(f"{'1 erratum' if self.errata == 1 else f'{self.errata} errata'} refuted")
        return count(len(self), self.noun) + (f": {', '.join(words)}" if words else "")


class Totals:
    """The total of a report: of documents that are gone by the time it is written.

    Args:
        strict: whether an unchecked display lets its document fail.
    """

    def __init__(self, strict: bool = False) -> None:
        self.strict = strict
        self.documents = self.failing = self.unable = self.samples = 0
        self.largest_error: float | None = None
        self.displays, self.tables = Tally("display"), Tally("table")
        self.messages: list[str] = []  # why documents could not be checked

    def add(self, result: DocumentResult | Failure) -> None:
        """Count a document."""
        if isinstance(result, Failure):
            self.unable += 1
            self.messages.append(result.message)
            return
        self.documents += 1
        self.failing += not passes(result, self.strict)
        for tally, records in ((self.displays, result.equations), (self.tables, result.tables)):
            for record in records:
                tally.add(record)
                self._add_samples(record)

    def _add_samples(self, record: Record) -> None:
        self.samples = max(self.samples, record.samples)
        if record.max_error is not None and record.samples:
            self.largest_error = max(self.largest_error or 0.0, record.max_error)

    @property
    def passed(self) -> bool:
        """Whether every document could be checked and passes."""
        return not (self.failing or self.unable)

    def describe(self) -> list[str]:
        """Return the total in words: what the displays came to, and how many documents pass."""
        lines = []
        if self.documents:
            of_tables = f"; {self.tables}" if len(self.tables) else ""
            lines.append(f"{count(self.documents, 'document')}, {self.displays}{of_tables}")
        if self.largest_error is not None:
            where = f"{self.samples:,} configurations"
            lines.append(f"evaluated on Drake's numerical plant at {where}: largest error {self.largest_error:.1e}")
        verb = "does" if self.failing == 1 else "do"
        verdicts = [f"{count(self.failing, 'document')} {verb} not pass"] if self.failing else []
        if self.unable:
            verdicts.append(f"{self.unable} could not be checked")
        return [*lines, "; ".join(verdicts) or "everything passes"]


def passes(result: DocumentResult, strict: bool) -> bool:
    """Whether a document passes; with `strict`, an unchecked display does not."""
    return result.passed_strictly() if strict else result.passed


def count(number: int, noun: str) -> str:
    """Return "1 document", "2 documents"."""
    return f"{number} {noun}" if number == 1 else f"{number} {noun}s"
