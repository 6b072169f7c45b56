"""`armproof verify --watch`: the report, then a line for each display that is checked again."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from pathlib import Path

from armproof.models.errors import counted, written
from armproof.models.language import look_up
from armproof.verification.cli.application import complain
from armproof.verification.report.text import (
    BAD,
    FAINT,
    GOOD,
    STRONG,
    Line,
    describe_document,
    describe_place,
    describe_record,
    text_report,
    write_lines,
)
from armproof.verification.report.totals import passes
from armproof.verification.running.watch import Event, Gone, Settled, Told, Watch
from armproof.verification.verdict import DocumentResult, Failure


def watch_documents(
    find: Callable[[], list[Path]], failures: Sequence[Failure], *, strict: bool
) -> list[DocumentResult | Failure]:
    """Verify the documents, then again whatever is saved, until the user ends it; return the last results.

    Raises KeyboardInterrupt where it is ended before the first report.
    """
    watch = Watch(find)
    for _ in watch.begin():
        pass
    results = [*watch.results, *failures]
    write_lines(text_report(results, strict=strict))
    complain(result.message for result in results if isinstance(result, Failure))
    number = len(watch.results)
    told = counted("watching {number} document; Ctrl-C ends", "watching {number} documents; Ctrl-C ends", number)
    write_lines([((told, FAINT),)])
    sys.stdout.flush()
    try:
        for event in watch.events():
            write_lines(_lines(event, strict))
            sys.stdout.flush()
    except KeyboardInterrupt:
        write_lines([()])
    return [*watch.results, *failures]


def _lines(event: Event, strict: bool) -> Iterator[Line]:
    """Yield the lines of an event, the time of the day before them."""
    clock = (f"{time.strftime('%H:%M:%S')}  ", FAINT)
    if isinstance(event, Gone):
        yield (clock, (written("{path}: it is gone; it is read again if it comes back", path=event.path), BAD))
    elif isinstance(event, Told):
        yield from _told(event, clock, strict)
    elif isinstance(event.result, Failure):
        yield (clock, (event.result.message, BAD))
    else:
        yield from _settled(event, event.result, clock, strict)


def _told(event: Told, clock: tuple[str, str], strict: bool) -> Iterator[Line]:
    record, seconds = event.record, (f"  ({event.seconds * 1e3:.0f} ms)", FAINT)
    notebook = event.path.suffix == ".ipynb"
    place = f"{event.path}: {describe_place(record)}" if notebook else f"{record.file or event.path}:{record.line}"
    what = written("erratum {verdict}", verdict=look_up(record.verdict)) if record.erratum else look_up(record.verdict)
    yield (clock, (place, STRONG), (f"  {what}", GOOD if record.passes else BAD), seconds)
    if not record.passes:
        _, *rest = describe_record(record if notebook else replace(record, cell=None), "")
        yield from rest


def _settled(event: Settled, result: DocumentResult, clock: tuple[str, str], strict: bool) -> Iterator[Line]:
    first, *_ = describe_document(result, strict)
    tables = [record for record in result.records if not record.passes and record not in result.equations]
    yield (clock, *first)
    for record in tables:
        yield from describe_record(record, "table")
    if passes(result, strict):
        return
    wrong = sum(not record.passes for record in result.equations)
    if wrong > 1:
        yield (("          ", ""), (written("{count} displays do not pass", count=wrong), FAINT))


__all__ = ["watch_documents"]
