"""The report as web pages, for `armproof verify --report`."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from armproof.verification.cli.documents import check_paths
from armproof.verification.verdict import DocumentResult, Failure

if TYPE_CHECKING:
    from armproof.verification.running.batch import After


def check_and_report(
    paths: Sequence[Path], folder: Path, *, strict: bool = False, jobs: int | None = None
) -> list[DocumentResult | Failure]:
    """Return the result of each document, and write their pages, an index and verdicts.json into a folder.

    Raises:
        ReportFolderError: the folder cannot be written, or holds what is no report.
    """
    from armproof.verification.report.html.folder import new_report
    from armproof.verification.report.html.site import page_names, page_writer, write_index

    names: dict[str, str] = {}
    with new_report(folder) as part:

        def prepare(documents: list[Path]) -> After:
            names.update(page_names(documents))
            return page_writer(part, names, strict=strict)

        results = check_paths(paths, prepare=prepare, correct=True, jobs=jobs)
        write_index(part, names, results, strict=strict)
    return results
