"""Work shared out to several processes, and many documents checked so: a task that ends its process (Drake aborts on some models) fails alone."""

from __future__ import annotations

import os
import signal
import sys
import traceback
from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from functools import partial
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, TypeVar

from armproof.models.errors import ArmproofError
from armproof.models.language import asked, speak, spoken
from armproof.verification.findings import Finding, Kind, say
from armproof.verification.verdict import DocumentResult, Failure

if TYPE_CHECKING:
    from concurrent.futures import Future, ProcessPoolExecutor

    from armproof.verification.document import Document

    After = Callable[[Document, DocumentResult], None]


MOST_WORKERS = 4  # each holds Drake, some 120 MB
AHEAD = 16  # tasks a process that are shared out before their results are taken
Task = TypeVar("Task")
Result = TypeVar("Result")
Work = Callable[[Task], Result]


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
    yield from share_out(check, paths, workers, process_ended, weight=_size, preload="armproof.verification.check")


def check_one(
    path: Path, after: After | None = None, correct: bool = False, found: DocumentResult | None = None
) -> DocumentResult | Failure:
    """Return the result of a document, or why it could not be checked; no exception leaves this function.

    Args:
        path: the document.
        after: called with it and its result.
        correct: whether to seek what mends each refuted display.
        found: its result, where it was checked elsewhere.
    """
    try:
        from armproof.verification import check
        from armproof.verification.document import read_document

        if after is None:
            return found or check.verify(path, correct=correct)
        document = read_document(path)
        result = found or check.check_document(document, correct=correct)
        after(document, result)
        return result
    except ArmproofError as error:
        return Failure.of(path, error)
    except Exception as error:
        return Failure(str(path), _internal_error(error))


def process_ended(path: Path) -> Failure:
    """Return what is said of a document that ended the process which checked it."""
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


def cores() -> int:
    """Return the number of cores that this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def usual_workers() -> int:
    """Return the number of processes where none is asked for: one a core, at most 4; 1 where Drake is imported already."""
    return 1 if "pydrake" in sys.modules else min(cores(), MOST_WORKERS)


def start_pool(workers: int, *, fresh: bool = False, preload: str = "") -> ProcessPoolExecutor:
    """Return a pool whose processes leave interrupts to this one.

    Args:
        workers: the number of processes.
        fresh: whether they begin as new interpreters rather than as copies of this process.
        preload: a module that they import while the tasks arrive.
    """
    from concurrent.futures import ProcessPoolExecutor
    from multiprocessing import get_context

    context = get_context("spawn" if fresh else "fork")
    return ProcessPoolExecutor(workers, mp_context=context, initializer=_begin, initargs=(preload, asked(), spoken()))


def _begin(preload: str, asked: str, spoken: str) -> None:
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    speak(asked, spoken)
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # matrices are small, and each core has its process already
    with suppress(ImportError):  # which the tasks report
        if preload:
            import_module(preload)


def share_out(
    work: Work[Task, Result],
    tasks: Sequence[Task],
    workers: int,
    ended: Work[Task, Result],
    *,
    weight: Callable[[Task], float] = lambda task: 0.0,
    fresh: bool = False,
    preload: str = "",
) -> Iterator[Result]:
    """Yield the result of each task in the order given; none is kept.

    Args:
        work: what is done with a task; it must be picklable where there are several processes.
        tasks: the tasks.
        workers: the number of processes; 1 works in this one.
        ended: the result of a task that ended its process.
        weight: the heaviest tasks are begun first, so that no core waits for another at the end.
        fresh, preload: of the processes, as for `start_pool`.
    """
    if min(workers, len(tasks)) <= 1:
        yield from map(work, tasks)
        return

    def start(processes: int) -> ProcessPoolExecutor:
        return start_pool(processes, fresh=fresh, preload=preload)

    begin = 0
    while begin < len(tasks):  # again where a process ended
        for result in _share_out_once(work, tasks[begin:], min(workers, len(tasks) - begin), ended, weight, start):
            begin += 1
            yield result


def _share_out_once(
    work: Work[Task, Result],
    tasks: Sequence[Task],
    workers: int,
    ended: Work[Task, Result],
    weight: Callable[[Task], float],
    start: Callable[[int], ProcessPoolExecutor],
) -> Iterator[Result]:
    """Yield the results of the tasks, up to the last that was shared out when a process ended."""
    from concurrent.futures.process import BrokenProcessPool

    ahead = AHEAD * workers
    shared: dict[int, Future[Result]] = {}
    given = 0
    with start(workers) as pool:
        try:
            for k in sorted(range(len(tasks))[:ahead], key=lambda k: weight(tasks[k]), reverse=True):
                shared[k] = pool.submit(work, tasks[k])
            while given < len(tasks):
                result = shared[given].result()
                del shared[given]
                given += 1
                yield result
                if given - 1 + ahead < len(tasks):
                    shared[given - 1 + ahead] = pool.submit(work, tasks[given - 1 + ahead])
            return
        except BrokenProcessPool:
            done = {k: future.result() for k, future in shared.items() if future.done() and not future.exception()}
    for k in range(given, min(given + ahead, len(tasks))):
        yield done[k] if k in done else _alone(work, tasks[k], ended, start)


def _alone(
    work: Work[Task, Result], task: Task, ended: Work[Task, Result], start: Callable[[int], ProcessPoolExecutor]
) -> Result:
    """Return the result of a task that may have ended a process, from a process of its own."""
    from concurrent.futures.process import BrokenProcessPool

    with start(1) as pool:
        try:
            return pool.submit(work, task).result()
        except BrokenProcessPool:
            return ended(task)
