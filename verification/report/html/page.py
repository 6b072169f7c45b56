"""The page of one document: the answer, the errata sheet, every equation, the coverage, the arm, what it was computed with."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from itertools import groupby

from markupsafe import Markup

from armproof.models.catalogue import arm_of
from armproof.models.language import of_document
from armproof.verification.diagnosis import counterexample
from armproof.verification.document import Document
from armproof.verification.evaluation import sampled
from armproof.verification.naming.reading import read_names
from armproof.verification.report.headings import sentences_of, with_headings
from armproof.verification.report.html import prose
from armproof.verification.report.html.card import arm_card
from armproof.verification.report.html.figures import painter_of
from armproof.verification.report.html.items import Item, ItemWriter
from armproof.verification.report.html.states import STATES, count_states, state_of
from armproof.verification.report.html.templating import REPORT, said, versions
from armproof.verification.report.totals import Totals
from armproof.verification.verdict import DocumentResult, Record


@dataclass(frozen=True)
class Section:
    """A section of the document: its title, its items, and how many there are of each state."""

    title: Markup
    items: tuple[Item, ...]
    counts: dict[str, int]


def render_page(document: Document, result: DocumentResult, index: str = "index.html", *, strict: bool = False) -> str:
    """Return the page of a document that was checked.

    Args:
        document: the document as it was read, for its letters and its arm.
        index: the file name of the page that lists all documents.
        strict: whether an unchecked equation fails the document.
    """
    with of_document(result.front or document.front):
        return _rendered(document, with_headings(result), index, strict)


def _rendered(document: Document, result: DocumentResult, index: str, strict: bool) -> str:
    front = result.front or document.front  # with the arm that was inferred
    arm = arm_of(front, document.path.parent)  # loaded already, when it was checked
    read = read_names(arm, front).reader.read
    painter = painter_of(arm)
    writer = ItemWriter(read, painter)
    pairs = list(writer.items(result))
    records = [record for _, record in pairs]
    counts = count_states(records)
    wrong = [
        writer.correction(item, record) for item, record in pairs if not record.passes and record.verdict == "refuted"
    ]
    errata = [writer.correction(item, record) for item, record in pairs if state_of(record).key == "erratum"]
    name = str(document.path)
    return REPORT.render(
        "document.html",
        title=prose.title(result.title, read) if result.title else name,
        plain_title=prose.plain_title(result.title) if result.title else name,
        source=prose.title(sentences_of(document.path)(str(document.front.get("source") or "")), read),
        path=name,
        index=index,
        result=result,
        remarks=[prose.message([remark], read) for remark in result.remarks],
        totals=Totals.of([result], strict),
        counts=counts,
        states=STATES,
        wrong=wrong,
        unsettled=[item for item, record in pairs if _is_unsettled(record)],
        errata=errata,
        sheet={correction.item.anchor for correction in (*wrong, *errata)},
        sections=list(_sections(pairs)),
        card=arm_card(arm, painter, read) if arm is not None and painter is not None else None,
        versions=versions(),
        seeds=(sampled.SEED, counterexample.SEED),
        samples=sampled.SAMPLES,
        largest=max((r.max_error for r in records if r.max_error is not None and r.samples), default=None),
    )


def _is_unsettled(record: Record) -> bool:
    """Whether an equation needs its author without being refuted: unread, unchecked, or an erratum that holds."""
    if record.erratum and not record.passes:
        return True
    return state_of(record).key in ("unreadable", "unchecked", "accepted") or record.accept is not None


def _sections(pairs: Iterable[tuple[Item, Record]]) -> Iterable[Section]:
    for _, group in groupby(pairs, key=lambda pair: pair[0].section_key):
        inside = list(group)
        items = tuple(item for item, _ in inside)
        yield Section(items[0].section or said("Before the first heading"), items, count_states(r for _, r in inside))
