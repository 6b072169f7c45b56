"""Check many documents, on several cores: one result a document, in the order given, whatever becomes of the others."""

from __future__ import annotations

import os
import re
import signal
import sys
import traceback
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from models.errors import ArmproofError

if TYPE_CHECKING:
    from concurrent.futures import ProcessPoolExecutor

    from verification.verdict import DocumentResult

MOST_WORKERS = 4  # each holds Drake, some 120 MB
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


def check_all(paths: Sequence[Path], workers: int | None = None) -> list[DocumentResult | Failure]:
    """Return the result of each document, or why it could not be checked.

    The documents are shared out to processes, which begin before Drake is imported. A document that ends its process
    (Drake aborts on some model files) fails alone.

    Args:
        paths: the documents.
        workers: the number of processes; 1 checks in this one. By default one a core, at most 4, and 1 where there is
            nothing to share or Drake is imported already.
    """
    if workers is None:
        workers = 1 if "pydrake" in sys.modules else min(_cores(), MOST_WORKERS)
    if min(workers, len(paths)) <= 1:
        return [check_one(path) for path in paths]
    results = _check_in_processes(paths, min(workers, len(paths)))
    for path in paths:
        if path not in results:  # its process ended, or that of a document before it
            results.update(_check_in_processes([path], 1))
    ended = "the process that checked it ended; Drake may have aborted on its arm"
    return [results.get(path) or Failure(str(path), f"{path}: {ended}") for path in paths]


def check_one(path: Path) -> DocumentResult | Failure:
    """Return the result of a document, or why it could not be checked; no exception leaves this function."""
    try:
        from verification.check import verify

        return verify(path)
    except ArmproofError as error:
        return Failure(str(path), _with_file(path, str(error)))
    except Exception as error:
        return Failure(str(path), f"{path}: {_internal_error(error)}")


def _check_in_processes(paths: Sequence[Path], workers: int) -> dict[Path, DocumentResult | Failure]:
    """Return the results of the documents, without those that were not checked when a process ended."""
    from concurrent.futures.process import BrokenProcessPool

    results: dict[Path, DocumentResult | Failure] = {}
    with _start_pool(workers) as pool:
        # The largest first, so that no core waits for the other at the end.
        futures = {path: pool.submit(check_one, path) for path in sorted(paths, key=_size, reverse=True)}
        for path, future in futures.items():
            try:
                results[path] = future.result()
            except BrokenProcessPool:
                continue
    return results


def _start_pool(workers: int) -> ProcessPoolExecutor:
    from concurrent.futures import ProcessPoolExecutor
    from multiprocessing import get_context

    return ProcessPoolExecutor(workers, mp_context=get_context("fork"), initializer=_begin)


def _begin() -> None:
    """Leave interrupts to the parent, and load the checker while the documents arrive."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    with suppress(ImportError):  # which checking a document reports
        import verification.check  # noqa: F401


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
    root = Path(__file__).resolve().parents[1]
    ours = tuple(str(root / room) + os.sep for room in ("models", "verification", "course"))
    frames = [frame for frame in traceback.extract_tb(error.__traceback__) if frame.filename.startswith(ours)]
    where = f" at {Path(frames[-1].filename).relative_to(root)}:{frames[-1].lineno}" if frames else ""
    text = f"{type(error).__name__}: {str(error)[:200]}" if str(error) else type(error).__name__
    return f"internal error of Armproof, please report it: {text}{where}"
