"""`armproof handout`: course documents as A4 sheets with the verdicts behind them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from enum import StrEnum
from pathlib import Path
from typing import Annotated

import typer

from armproof.verification.cli.application import CANNOT_RUN, FAILS, complain, ending, tell
from armproof.verification.cli.documents import check_paths
from armproof.verification.verdict import DocumentResult, Failure


class Format(StrEnum):
    """The formats of a sheet."""

    pdf = "pdf"
    html = "html"


Documents = Annotated[list[Path], typer.Argument(metavar="DOC", help="Documents or folders.")]
SheetFormat = Annotated[
    Format, typer.Option("--format", help="pdf (needs the extra 'print') or html, one file a sheet.")
]
Solutions = Annotated[bool, typer.Option("--solutions", help="The teacher's edition: worked solutions and errata.")]
Draft = Annotated[bool, typer.Option("--draft", help="Print what does not pass as well, with DRAFT across every page.")]
Out = Annotated[Path, typer.Option("--out", metavar="DIR", help="The folder that the sheets are written into.")]
Language = Annotated[str | None, typer.Option("--lang", metavar="en|fr", help="By default the document's own.")]


def handout(
    documents: Documents,
    sheet_format: SheetFormat = Format.pdf,
    solutions: Solutions = False,
    draft: Draft = False,
    out: Out = Path("build/handouts"),
    lang: Language = None,
) -> None:
    """Print documents as A4 sheets with their figures, every equation proved.

    Exit code 0: all are printed; 1: one does not pass, and is printed as a draft only; 2: one cannot be printed.
    """
    from armproof.course.printing.document import Edition
    from armproof.course.printing.printing import Printer, prepare

    with ending():
        printer = Printer(sheet_format.value, out, Edition(draft, solutions, lang))
        results = check_paths(documents, prepare=lambda paths: prepare(printer, paths))
    raise typer.Exit(_say_what_was_printed(results, printer.path_of, draft))


def _say_what_was_printed(
    results: Sequence[DocumentResult | Failure], path_of: Callable[[Path], Path], draft: bool
) -> int:
    code = 0
    for result in results:
        if isinstance(result, Failure):
            complain([result.message])
            code = CANNOT_RUN
        elif result.passed or draft:
            typer.echo(path_of(Path(result.path)))
        else:
            wrong = sum(not record.passes for record in result.records)
            tell(
                "{path}: not printed: 1 equation is not proved; armproof verify says which, --draft prints it as a draft" if wrong == 1
                else "{path}: not printed: {wrong} equations are not proved; armproof verify says which, --draft prints it as a draft",
                path=result.path, wrong=wrong,
            )  # fmt: skip
            code = max(code, FAILS)
    return code
