"""The whole report: a page a document, written by the process that checked it, then the index and the verdicts as JSON."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from unicodedata import combining, normalize

from armproof.verification.document import Document
from armproof.verification.report.headings import sentences_of
from armproof.verification.report.html import prose
from armproof.verification.report.html.states import STATES, count_states, records_of
from armproof.verification.report.html.templating import REPORT, versions
from armproof.verification.report.json_ import json_report
from armproof.verification.report.totals import Totals, passes
from armproof.verification.verdict import DocumentResult, Failure

INDEX, VERDICTS = "index.html", "verdicts.json"
_LONGEST = 80  # characters of a page's name


def page_names(paths: Sequence[Path]) -> dict[str, str]:
    """Return the file name of each document's page: of plain letters whatever the document is called, each its own."""
    names: dict[str, str] = {}
    taken = {INDEX}
    for path in paths:
        stem = _plain(path.stem) or "document"
        name, number = f"{stem}.html", 2
        while name.casefold() in taken:
            name, number = f"{stem}-{number}.html", number + 1
        taken.add(name.casefold())
        names[str(path)] = name
    return names


def page_writer(
    folder: Path, names: dict[str, str], *, strict: bool = False
) -> Callable[[Document, DocumentResult], None]:
    """Return what writes the page of a document that was checked; it can be sent to another process."""
    return partial(_write_page, folder, names, strict)


def write_index(
    folder: Path, names: dict[str, str], results: Sequence[DocumentResult | Failure], *, strict: bool = False
) -> None:
    """Write the index of the pages, and the verdicts as JSON beside it."""
    (folder / VERDICTS).write_text(json_report(results, strict=strict), encoding="ascii")
    (folder / INDEX).write_text(render_index(names, results, strict=strict), encoding="utf-8")


@dataclass(frozen=True)
class Row:
    """A document in the index."""

    result: DocumentResult
    page: str
    title: str
    counts: dict[str, int]
    passed: bool


def render_index(names: dict[str, str], results: Sequence[DocumentResult | Failure], *, strict: bool = False) -> str:
    """Return the page that lists all documents."""
    documents = [result for result in results if isinstance(result, DocumentResult)]
    rows = [_row(result, names[result.path], strict) for result in documents]
    counts = count_states(records_of(documents))
    totals = Totals.of(results, strict)
    return REPORT.render(
        "index.html",
        totals=totals,
        counts=counts,
        states=STATES,
        rows=rows,
        failures=[result for result in results if isinstance(result, Failure)],
        verdicts=VERDICTS,
        versions=versions(),
    )


def _row(result: DocumentResult, page: str, strict: bool) -> Row:
    title = prose.plain_title(sentences_of(result.path)(result.title)) if result.title else Path(result.path).name
    return Row(result, page, title, count_states(result.records), passes(result, strict))


def _write_page(folder: Path, names: dict[str, str], strict: bool, document: Document, result: DocumentResult) -> None:
    from armproof.verification.report.html.page import (
        render_page,  # which loads the models: only where documents are checked
    )

    page = render_page(document, result, INDEX, strict=strict)
    (folder / names[str(document.path)]).write_text(page, encoding="utf-8")


def _plain(stem: str) -> str:
    bare = "".join(c for c in normalize("NFKD", stem) if not combining(c))
    return re.sub(r"[^A-Za-z0-9._]+", "-", bare).strip("-.")[:_LONGEST]
