"""`armproof verify --errata FILE`: one sheet of all mistakes, in the format that the file's name says."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from importlib.metadata import entry_points
from pathlib import Path

from armproof.models.errors import ArmproofError
from armproof.verification.report.errata import MARKDOWN, TEX, Mistake, Notation, mistakes, write_sheet
from armproof.verification.running.atomic import write_atomically
from armproof.verification.verdict import DocumentResult, Failure

SHEETS = "armproof.sheets"  # the entry points of what is printed by rooms that verification may not import


class ErrataError(ArmproofError):
    """The errata sheet cannot be written where or as it was asked for."""


class ErrataSheet:
    """Gathers the mistakes of documents, and writes the sheet of them, whole or not at all.

    Raises:
        ErrataError: the file is one of the documents, or has another suffix.
        PrintError: PDF cannot be printed here.
    """

    def __init__(self, target: Path, documents: Iterable[Path]) -> None:
        if target.resolve() in {document.resolve() for document in documents}:
            raise ErrataError("{path}: this is one of the documents", path=target)
        notation = {".md": MARKDOWN, ".tex": TEX}.get(target.suffix)
        made = _printer() if target.suffix == ".pdf" else None if notation is None else _encoded(notation)
        if made is None:
            raise ErrataError("{path}: an errata sheet is a file .md, .tex or .pdf", path=target)
        self.target, self._made = target, made
        self._found: list[Mistake] = []

    def add(self, result: DocumentResult | Failure) -> None:
        """Keep the mistakes of a document."""
        self._found += mistakes(result) if isinstance(result, DocumentResult) else []

    def write(self) -> None:
        """Write the sheet; raises ErrataError where that cannot be done."""
        try:
            write_atomically(self.target, self._made(self._found))
        except OSError as error:
            raise ErrataError("{path}: cannot be written: {reason}", path=self.target, reason=error.strerror) from None


def _encoded(notation: Notation) -> Callable[[Iterable[Mistake]], bytes]:
    return lambda found: write_sheet(found, notation).encode("utf-8")


def _printer() -> Callable[[Iterable[Mistake]], bytes] | None:
    found = next(iter(entry_points(group=SHEETS, name="errata")), None)
    return None if found is None else found.load()()  # type: ignore[no-any-return]
