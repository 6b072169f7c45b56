"""An errata sheet on paper: found by the entry point "armproof.sheets", since the verification imports nothing of the course."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from pathlib import Path

from armproof.course.printing.pdf import check_installed, write_pdf
from armproof.course.sheet.body import Body
from armproof.course.sheet.inline import InlineReader
from armproof.course.sheet.model import Heading, Sheet
from armproof.course.sheet.reading import BlockReader
from armproof.models.language import spoken
from armproof.verification.naming.reading import read_names
from armproof.verification.report.errata import MARKDOWN, Mistake, write_sheet
from armproof.verification.report.html.templating import version_of
from armproof.verification.verdict import DocumentResult


def errata_printer() -> Callable[[Iterable[Mistake]], bytes]:
    """Return what prints an errata sheet as PDF; raises PrintError where Typst is missing."""
    check_installed()
    return print_errata


def print_errata(found: Iterable[Mistake]) -> bytes:
    """Return an errata sheet as PDF."""
    inline = InlineReader(read_names(None, {}).reader.read, Path())
    title, *blocks = BlockReader(inline, DocumentResult("", "", ())).read(Body(write_sheet(found, MARKDOWN)))
    assert isinstance(title, Heading)
    return write_pdf(Sheet(title.parts, (), spoken(), "", tuple(blocks), foot=f"Armproof {version_of('armproof')}"))
