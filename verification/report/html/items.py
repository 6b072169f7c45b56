"""The equations of a page: each record with its formula, its words, its entries and its figure as HTML."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from markupsafe import Markup

from armproof.models.errors import written
from armproof.models.language import look_up, number_text
from armproof.verification.latex.mathml.writer import Read
from armproof.verification.report.html import prose
from armproof.verification.report.html.figures import ArmPainter, Figure
from armproof.verification.report.html.formulas import Formula, as_it_should_be, as_printed
from armproof.verification.report.html.states import State, state_of
from armproof.verification.report.text import describe_place, describe_reading, ordered_records
from armproof.verification.verdict import DocumentResult, Record, WrongEntry


@dataclass(frozen=True)
class Entry:
    """A wrong entry: where it is, what is printed, what is right, and both values at the counterexample."""

    place: str
    printed: Markup
    correct: Markup
    latex: str
    change: Markup
    values: tuple[str, str] | None


@dataclass(frozen=True)
class Item:
    """One equation or table of a document."""

    anchor: str
    place: str
    state: State
    kind: str
    section: Markup
    section_key: str
    printed: Formula
    message: Markup
    readings: tuple[str, ...]
    samples: int
    max_error: float | None
    words: str


@dataclass(frozen=True)
class Correction:
    """A refuted equation in the errata sheet: as printed, as it should be, and why."""

    item: Item
    should_be: Formula | None
    entries: tuple[Entry, ...]
    counterexample: tuple[Markup, ...]
    figure: Figure | None


class ItemWriter:
    """Writes the records of one document with its letters and its arm."""

    def __init__(self, read: Read, painter: ArmPainter | None) -> None:
        self.read = read
        self.painter = painter

    def items(self, result: DocumentResult) -> Iterator[tuple[Item, Record]]:
        """Yield the displays and tables of a document in their order."""
        seen: dict[str, int] = {}
        for record, kind in ordered_records(result):
            place = describe_place(record)
            anchor = place.replace(", ", "-").replace(" ", "-")
            seen[anchor] = seen.get(anchor, 0) + 1
            if seen[anchor] > 1:
                anchor = f"{anchor}-{seen[anchor]}"
            yield self._item(record, kind, place, anchor), record

    def correction(self, item: Item, record: Record) -> Correction:
        """Return what the errata sheet says of a refuted record."""
        values = [
            (prose.symbol(name, self.read), number_text(value, ".6g").replace("-", "−"))
            for name, value in record.counterexample.items()
        ]
        return Correction(
            item,
            as_it_should_be(record, self.read, is_table=item.kind == "table"),
            tuple(self._entries(record)),
            tuple(Markup("{} = {}").format(name, value) for name, value in values),
            self.painter.at_counterexample(record) if self.painter is not None else None,
        )

    def _item(self, record: Record, kind: str, place: str, anchor: str) -> Item:
        return Item(
            anchor=anchor,
            place=place,
            state=state_of(record),
            kind=kind,
            section=prose.title(record.section, self.read),
            section_key=record.section,
            printed=as_printed(record, self.read, is_table=kind == "table"),
            message=prose.message(record.findings, self.read),
            readings=tuple(describe_reading(each) for each in record.outcomes),
            samples=record.samples,
            max_error=record.max_error,
            words=" ".join(f"{prose.plain_title(record.section)} {record.message}".split()),
        )

    def _entries(self, record: Record) -> Iterator[Entry]:
        several = len({entry.equation for entry in record.entries}) > 1
        count: dict[int, int] = {}
        for entry in record.entries:
            index = count.get(entry.equation, 0)
            count[entry.equation] = index + 1
            yield Entry(
                _place(entry, several),
                prose.math(entry.printed, self.read),
                prose.math(entry.correct, self.read),
                entry.correct,
                prose.message([entry.finding] if entry.finding is not None else [], self.read),
                _values(record, entry, index),
            )


def _place(entry: WrongEntry, several: bool) -> str:
    parts = [written("equation {number}", number=entry.equation)] if several else []
    if entry.row is not None:
        parts.append(written("row {row}, column {column}", row=entry.row, column=entry.column))
    return ", ".join(parts) or look_up("the value")


def _values(record: Record, entry: WrongEntry, index: int) -> tuple[str, str] | None:
    """Return the printed and the true value at the counterexample, where they are known."""
    found = record.discrepancy
    if found is None or found.equation != entry.equation or index >= len(found.values):
        return None
    printed, true = (number_text(value, ".5g").replace("-", "−") for value in found.values[index])
    return printed, true
