"""The report as workflow commands of GitHub Actions, which it shows as annotations beside the lines of a document."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator
from pathlib import Path

from armproof.models.language import look_up
from armproof.verification.report.text import describe_entry, describe_place, describe_verdict, ordered_records
from armproof.verification.report.totals import Totals
from armproof.verification.verdict import DocumentResult, Failure, Record, Verdict


def github_report(results: Iterable[DocumentResult | Failure], *, strict: bool = False) -> Iterator[str]:
    """Yield a line for each display that does not pass or is unchecked and each document that cannot be checked.

    The total follows, as plain lines of the log.
    """
    totals = Totals(strict)
    for result in results:
        totals.add(result)
        if isinstance(result, Failure):
            yield _command("error", result.path, result.line, look_up("cannot be checked"), result.reason)
            continue
        for record, kind in ordered_records(result):
            if record.is_remark and not record.erratum and record.accept is None:
                continue
            if not record.passes or (strict and record.verdict is Verdict.UNCHECKED and not record.is_accepted):
                yield _annotate("error", result.path, record, kind)
            elif record.accept is not None:
                yield _annotate("notice", result.path, record, kind)
            elif record.verdict is Verdict.UNCHECKED:
                yield _annotate("warning", result.path, record, kind)
    yield from totals.describe()


def _annotate(level: str, path: str, record: Record, kind: str) -> str:
    path = str(Path(path).parent / record.file) if record.file else path
    title = describe_verdict(record, kind)
    parts = [record.message, *(describe_entry(entry, record) for entry in record.entries)]
    if record.cell is not None:  # a notebook's line counts within its cell
        return _command(level, path, None, title, "\n".join([describe_place(record), *filter(None, parts)]))
    return _command(level, path, record.line, title, "\n".join(filter(None, parts)))


def _command(level: str, path: str, line: int | None, title: str, message: str) -> str:
    place = f"file={_property(_from_here(path))}" + (f",line={line}" if line is not None else "")
    return f"::{level} {place},title={_property(f'Armproof: {title}')}::{_data(message)}"


def _from_here(path: str) -> str:
    """Return a path relative to the working folder, the root of the checkout, where it lies inside."""
    try:
        return str(Path(path).resolve().relative_to(Path(os.getcwd()).resolve()))
    except ValueError:
        return path


def _data(text: str) -> str:
    return text.replace("%", "%25").replace("\r", "%0D").replace("\n", "%0A")


def _property(text: str) -> str:
    return _data(text).replace(":", "%3A").replace(",", "%2C")
