"""Print checked documents into a folder: one file a sheet, there as a whole or not at all."""

from __future__ import annotations

import tempfile
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from armproof.course.errors import PrintError
from armproof.course.printing.document import Edition, make_sheet
from armproof.course.printing.pdf import check_installed, write_pdf
from armproof.course.sheet.html import HtmlWriter
from armproof.course.sheet.model import Sheet, plain
from armproof.course.sheet.proof import proof_line
from armproof.course.words import say
from armproof.models.errors import existing_language, written
from armproof.verification.cli.application import complain
from armproof.verification.document import Document
from armproof.verification.report.html.templating import Shell
from armproof.verification.running.atomic import write_atomically
from armproof.verification.verdict import DocumentResult

PAPER = Shell("armproof.course.printing", ("sheet.css",), (), allowed="img-src data:; ", drawn=False)
FORMATS = ("pdf", "html")


def write_html(sheet: Sheet) -> str:
    """Return the whole page."""
    writer = HtmlWriter(sheet.lang)
    return PAPER.render(
        "sheet.html",
        sheet=sheet,
        say=say,
        plain_title=plain(sheet.title),
        title=writer.words(sheet.title),
        source=writer.words(sheet.source),
        body=writer.body(sheet.blocks),
        proof=proof_line(sheet.records, sheet.lang, sheet.arm),
    )


@dataclass(frozen=True)
class Printer:
    """Prints the documents that it is given with their verdicts; what does not pass it leaves unless it prints drafts.

    Attributes:
        format: pdf or html.
        folder: where the sheets are written.
        edition: draft, solutions, language.
    """

    format: str
    folder: Path
    edition: Edition

    def __call__(self, document: Document, result: DocumentResult) -> None:
        """Print a document that passes; raises PrintError where that cannot be done."""
        if not (result.passed or self.edition.draft):
            return
        with tempfile.TemporaryDirectory(prefix="armproof-figures-") as figures:
            sheet = make_sheet(document, result, self.edition, Path(figures))
            data = render(sheet, self.format)
        complain(written("warning: {text}", text=warning) for warning in sheet.warnings)
        target = self.path_of(document.path)
        try:
            write_atomically(target, data)
        except OSError as error:
            raise PrintError("{target}: cannot be written: {reason}", target=target, reason=error.strerror) from None

    def path_of(self, document: Path) -> Path:
        """Return the file that a document is printed into."""
        return self.folder / f"{document.stem}{'-solutions' if self.edition.solutions else ''}.{self.format}"


def render(sheet: Sheet, form: str) -> bytes:
    """Return a sheet as a file's bytes, pdf or html.

    Raises:
        PrintError: another format, or Typst is missing for pdf.
    """
    if form not in FORMATS:
        raise PrintError("no format '{form}'; a sheet is printed as {formats}", form=form, formats=" or ".join(FORMATS))
    return write_pdf(sheet) if form == "pdf" else write_html(sheet).encode("utf-8")


def prepare(printer: Printer, documents: Sequence[Path]) -> Printer:
    """Return the printer, once all that does not depend on a document's content is known to be in order.

    Raises:
        PrintError: Typst is missing for pdf; two documents that would be one file; a folder that cannot be made.
        LanguageError: an unknown language.
    """
    if printer.format == "pdf":
        check_installed()
    if printer.edition.lang is not None:
        existing_language(printer.edition.lang)
    seen: dict[Path, Path] = {}
    for document in documents:
        target = printer.path_of(document)
        if target in seen:
            raise PrintError("{document} and {other} would both be {target}; print them into different folders",
                document=document, other=seen[target], target=target)  # fmt: skip
        if target.exists() and target.samefile(document):
            raise PrintError("{target}: this is the document itself", target=target)
        seen[target] = document
    try:
        printer.folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise PrintError("{folder}: cannot be written: {reason}", folder=printer.folder, reason=error.strerror) from None  # fmt: skip
    return printer
