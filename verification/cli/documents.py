"""The documents that a command's paths name, their results, and how far the command is."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterator, Sequence
from importlib.util import find_spec
from pathlib import Path
from types import TracebackType
from typing import TYPE_CHECKING

from armproof.models.errors import ArmproofError, written
from armproof.models.language import look_up, noted
from armproof.verification.findings import Kind, say
from armproof.verification.running.processes import check_each
from armproof.verification.verdict import DocumentResult, Failure

if TYPE_CHECKING:
    from armproof.verification.running.processes import After


WIDTH = 30
SILENT = 0.5  # seconds: what takes no longer needs no bar


class Progress:
    """A bar on standard error that is never left behind; it is cleared before anything else is written."""

    def __init__(self, total: int, noun: str = noted("documents")) -> None:
        self.total = total
        self.noun = noun
        self.done = 0
        self._shown = False
        self._silent_until = time.monotonic() + SILENT
        self._on_terminal = total > 1 and sys.stderr.isatty()

    def __enter__(self) -> Progress:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, traceback: TracebackType | None
    ) -> None:
        self.clear()

    def advance(self, by: int = 1) -> None:
        """Count what is done, and show how far it is."""
        self.done += by
        if self._on_terminal and self.done < self.total and time.monotonic() > self._silent_until:
            sys.stdout.flush()
            full = WIDTH * self.done // self.total
            sys.stderr.write(f"\r\x1b[K[{'#' * full}{'.' * (WIDTH - full)}] {self._told()}")
            sys.stderr.flush()
            self._shown = True

    def _told(self) -> str:
        return written("{done} of {total} {things}", done=self.done, total=self.total, things=look_up(self.noun))

    def clear(self) -> None:
        """Take the bar away, so that a line may be written where it stood."""
        if self._shown:
            sys.stderr.write("\r\x1b[K")
            sys.stderr.flush()
            self._shown = False


def check_paths(
    paths: Sequence[Path],
    *,
    prepare: Callable[[list[Path]], After] | None = None,
    correct: bool = False,
    jobs: int | None = None,
    scheduler: str = "",
) -> list[DocumentResult | Failure]:
    """Return the result of each document that the paths name, in their order; a path that names none is a Failure.

    Args:
        prepare: given the documents before they are checked, returns what is to be done with each after its check.
        correct: whether to seek what mends each refuted display.
        jobs: the number of processes; by default one a core.
        scheduler: the address of a Dask cluster that checks them instead.

    Raises:
        ClusterError: it cannot be used.
    """
    return list(check_each_path(paths, prepare=prepare, correct=correct, jobs=jobs, scheduler=scheduler))


def check_each_path(
    paths: Sequence[Path],
    *,
    prepare: Callable[[list[Path]], After] | None = None,
    correct: bool = False,
    jobs: int | None = None,
    scheduler: str = "",
) -> Iterator[DocumentResult | Failure]:
    """Yield what `check_paths` returns, each result as soon as it is there; on a terminal, with a bar of how far it is."""
    found = named_documents(paths)
    documents = [each for each in found if isinstance(each, Path)]
    after = prepare(documents) if prepare is not None else None
    checked = _checked(documents, jobs, scheduler, after, correct)
    with Progress(len(documents)) as progress:
        for each in found:
            result = next(checked) if isinstance(each, Path) else each
            progress.clear()
            yield result
            progress.advance(isinstance(each, Path))


def _checked(
    documents: Sequence[Path], jobs: int | None, scheduler: str, after: After | None, correct: bool
) -> Iterator[DocumentResult | Failure]:
    """Yield the results from processes of this machine, or from the workers of a cluster."""
    if not scheduler:
        yield from check_each(documents, jobs, after=after, correct=correct)
        return
    from armproof.verification.running.cluster import Cluster
    from armproof.verification.running.on_cluster import check_each_on

    with Cluster(scheduler) as cluster:
        yield from check_each_on(cluster, documents, after=after, correct=correct)


def named_documents(paths: Sequence[Path]) -> dict[Path | Failure, None]:
    """Return the documents that paths name, each once and in their order, and a Failure for a path that names none."""
    from armproof.verification.document import find_documents

    found: dict[Path | Failure, None] = {}
    for path in paths:
        try:
            if path.exists() and not (path.is_dir() or path.is_file()):  # a pipe or a device, which may never end
                found[Failure(str(path), say(Kind.NOT_A_FILE))] = None
            else:
                found.update(dict.fromkeys(find_documents([path])))
        except ArmproofError as error:
            found[Failure.of(path, error)] = None
        except OSError as error:
            found[Failure(str(path), say(Kind.FILE_UNREADABLE, reason=str(error.strerror)))] = None
    return found


def find_course() -> Path:
    """Return course/ of the working folder, else the folder of the installed course."""
    here = Path("course")
    spec = None if here.is_dir() else find_spec("armproof.course")
    return Path(next(iter(spec.submodule_search_locations))) if spec and spec.submodule_search_locations else here


def check_and_report(
    paths: Sequence[Path], folder: Path, *, strict: bool = False, jobs: int | None = None, scheduler: str = ""
) -> list[DocumentResult | Failure]:
    """Return the result of each document, and write their pages, an index and verdicts.json into a folder.

    Raises:
        ReportFolderError: the folder cannot be written, or holds what is no report.
        ClusterError: the scheduler cannot be used.
    """
    from armproof.verification.report.html.folder import new_report
    from armproof.verification.report.html.site import page_names, page_writer, write_index

    names: dict[str, str] = {}
    with new_report(folder) as part:

        def prepare(documents: list[Path]) -> After:
            names.update(page_names(documents))
            return page_writer(part, names, strict=strict)

        results = check_paths(paths, prepare=prepare, correct=True, jobs=jobs, scheduler=scheduler)
        write_index(part, names, results, strict=strict)
    return results
