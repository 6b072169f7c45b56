"""A sheet as one HTML file: its style and its pictures inside, no script, nothing from the network."""

from __future__ import annotations

from armproof.course.sheet.html import HtmlWriter
from armproof.course.sheet.model import Sheet, plain
from armproof.course.sheet.proof import proof_line
from armproof.course.sheet.words import say
from armproof.verification.report.html.templating import Shell

PAPER = Shell("armproof.course.printing", ("sheet.css",), "", allowed="img-src data:; ", drawn=False)


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
