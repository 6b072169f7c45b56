"""Check many documents, on several cores: one result a document, in the order given, whatever becomes of the others."""

from __future__ import annotations

import os
import traceback
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from armproof.models.errors import ArmproofError
from armproof.verification.findings import Finding, Kind, say
from armproof.verification.running.processes import share_out, usual_workers
from armproof.verification.verdict import DocumentResult, Failure

if TYPE_CHECKING:
    from armproof.verification.document import Document

    After = Callable[[Document, DocumentResult], None]


def check_each(
    paths: Sequence[Path], workers: int | None = None, *, after: After | None = None, correct: bool = False
) -> Iterator[DocumentResult | Failure]:
    """Yield the result of each document in the order given, or why it could not be checked; none is kept.

    The documents are shared out to processes, which begin before Drake is imported. A document that ends its process
    (Drake aborts on some model files) fails alone.

    Args:
        paths: the documents.
        workers: the number of processes; 1 checks in this one. By default one a core, at most 4, and 1 where there is
            nothing to share or Drake is imported already.
        after: called with each document and its result, in the process that checked it; it must be picklable.
        correct: whether to seek what mends each refuted display.
    """
    check = partial(check_one, after=after, correct=correct)
    workers = usual_workers() if workers is None else workers
    yield from share_out(check, paths, workers, _ended, weight=_size, preload="armproof.verification.check")


def check_one(path: Path, after: After | None = None, correct: bool = False) -> DocumentResult | Failure:
    """Return the result of a document, or why it could not be checked; no exception leaves this function."""
    try:
        from armproof.verification import check
        from armproof.verification.document import read_document

        if after is None:
            return check.verify(path, correct=correct)
        document = read_document(path)
        result = check.check_document(document, correct=correct)
        after(document, result)
        return result
    except ArmproofError as error:
        return Failure.of(path, error)
    except Exception as error:
        return Failure(str(path), _internal_error(error))


def _ended(path: Path) -> Failure:
    return Failure(str(path), say(Kind.PROCESS_ENDED))


def _size(path: Path) -> int:
    try:
        return path.stat().st_size
    except OSError:
        return 0


def _internal_error(error: Exception) -> Finding:
    """Describe a fault of Armproof itself by the exception and the place in our code that raised it."""
    root = Path(__file__).resolve().parents[2]
    ours = tuple(str(root / room) + os.sep for room in ("models", "verification", "course"))
    frames = [frame for frame in traceback.extract_tb(error.__traceback__) if frame.filename.startswith(ours)]
    where = f" at {Path(frames[-1].filename).relative_to(root)}:{frames[-1].lineno}" if frames else ""
    text = f"{type(error).__name__}: {str(error)[:200]}" if str(error) else type(error).__name__
    return say(Kind.OUR_FAULT, reason=f"{text}{where}")
