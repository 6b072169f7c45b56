"""Check many documents, on several cores: one result a document, in the order given, whatever becomes of the others."""

from __future__ import annotations

import os
import re
import signal
import sys
import traceback
from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from armproof.models.errors import ArmproofError

if TYPE_CHECKING:
    from concurrent.futures import ProcessPoolExecutor

    from armproof.verification.document import Document
    from armproof.verification.verdict import DocumentResult

    After = Callable[[Document, DocumentResult], None]
    Check = Callable[[Path], "DocumentResult | Failure"]

MOST_WORKERS = 4  # each holds Drake, some 120 MB
AHEAD = 16  # documents a process that are shared out before their results are taken
_PLACE = re.compile(r":(\d+): ")


@dataclass(frozen=True)
class Failure:
    """A document that could not be checked, and why: "file:line: message"."""

    path: str
    message: str

    @property
    def line(self) -> int | None:
        """The line of the document that is at fault, if the message names one."""
        found = _PLACE.match(self.message.removeprefix(self.path))
        return int(found.group(1)) if found else None

    @property
    def reason(self) -> str:
        """The message without file and line."""
        return _PLACE.sub("", self.message.removeprefix(self.path), count=1).removeprefix(": ")


def check_all(
    paths: Sequence[Path], workers: int | None = None, *, after: After | None = None, correct: bool = False
) -> list[DocumentResult | Failure]:
    """Return the result of each document, or why it could not be checked: what `check_each` yields."""
    return list(check_each(paths, workers, after=after, correct=correct))


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
    if workers is None:
        workers = 1 if "pydrake" in sys.modules else min(_cores(), MOST_WORKERS)
    check = partial(check_one, after=after, correct=correct)
    if min(workers, len(paths)) <= 1:
        yield from map(check, paths)
        return
    begin = 0
    while begin < len(paths):  # again where a process ended
        for result in _check_in_processes(paths[begin:], min(workers, len(paths) - begin), check):
            begin += 1
            yield result


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
        return Failure(str(path), _with_file(path, str(error)))
    except Exception as error:
        return Failure(str(path), f"{path}: {_internal_error(error)}")


def _check_in_processes(paths: Sequence[Path], workers: int, check: Check) -> Iterator[DocumentResult | Failure]:
    """Yield the results of the documents, up to the last that was shared out when a process ended."""
    from concurrent.futures.process import BrokenProcessPool

    ahead = AHEAD * workers
    with _start_pool(workers) as pool:
        try:
            # The largest first, so that no core waits for the other at the end; the others as results are taken.
            largest = sorted(range(len(paths))[:ahead], key=lambda k: _size(paths[k]), reverse=True)
            shared = {k: pool.submit(check, paths[k]) for k in largest}
            for index in range(len(paths)):
                yield shared.pop(index).result()
                if index + ahead < len(paths):
                    shared[index + ahead] = pool.submit(check, paths[index + ahead])
            return
        except BrokenProcessPool:
            done = {k: future.result() for k, future in shared.items() if future.done() and not future.exception()}
    for k in range(index, min(index + ahead, len(paths))):
        yield done[k] if k in done else _check_alone(paths[k], check)


def _check_alone(path: Path, check: Check) -> DocumentResult | Failure:
    """Return the result of a document that may have ended a process, from a process of its own."""
    from concurrent.futures.process import BrokenProcessPool

    with _start_pool(1) as pool:
        try:
            return pool.submit(check, path).result()
        except BrokenProcessPool:
            return Failure(str(path), f"{path}: the process that checked it ended; Drake may have aborted on its arm")


def _start_pool(workers: int) -> ProcessPoolExecutor:
    from concurrent.futures import ProcessPoolExecutor
    from multiprocessing import get_context

    return ProcessPoolExecutor(workers, mp_context=get_context("fork"), initializer=_begin)


def _begin() -> None:
    """Leave interrupts to the parent, and load the checker while the documents arrive."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    with suppress(ImportError):  # which checking a document reports
        import armproof.verification.check  # noqa: F401


def _cores() -> int:
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def _size(path: Path) -> int:
    try:
        return path.stat().st_size
    except OSError:
        return 0


def _with_file(path: Path, message: str) -> str:
    return message if message.startswith(str(path)) else f"{path}: {message}"


def _internal_error(error: Exception) -> str:
    """Describe a fault of Armproof itself by the exception and the place in our code that raised it."""
    root = Path(__file__).resolve().parents[2]
    ours = tuple(str(root / room) + os.sep for room in ("models", "verification", "course"))
    frames = [frame for frame in traceback.extract_tb(error.__traceback__) if frame.filename.startswith(ours)]
    where = f" at {Path(frames[-1].filename).relative_to(root)}:{frames[-1].lineno}" if frames else ""
    text = f"{type(error).__name__}: {str(error)[:200]}" if str(error) else type(error).__name__
    return f"internal error of Armproof, please report it: {text}{where}"
