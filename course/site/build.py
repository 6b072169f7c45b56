"""Build the site: each lesson in a process of its own, all of it put in its place at once."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable, Iterator
from concurrent.futures import as_completed
from concurrent.futures.process import BrokenProcessPool
from pathlib import Path

from armproof.course.errors import SiteError
from armproof.course.site import work
from armproof.course.site.order import Built, Order
from armproof.models.errors import ArmproofError
from armproof.verification.report.html.folder import Kind, is_page, new_report
from armproof.verification.running.processes import MOST_WORKERS, cores, start_pool

FILES = "files.json"  # the digest of each file that is no page
_PATIENCE = "the process that built it ended; Drake may have aborted on its arm"


def build_site(
    order: Order, target: Path, *, workers: int | None = None, done: Callable[[Built], None] = lambda built: None
) -> Path:
    """Build the site into a folder, whole or not at all; return its index.

    Args:
        order: the lessons.
        target: a folder, new, empty or with an earlier site.
        workers: the number of processes; by default one a core, at most 4.
        done: told of each lesson as soon as it is there.

    Raises:
        SiteError: a lesson does not pass or does not run; each problem on a line.
        ReportFolderError: the folder cannot be written, or holds something else.
    """
    with new_report(target, kind_of(target)) as part:
        problems = []
        for built in _build_all(order, part, workers or min(cores(), MOST_WORKERS)):
            done(built)
            if built.problem:
                problems.append((order.sources.index(built.source), built.problem))
        if problems:
            raise SiteError("\n".join(problem for _, problem in sorted(problems)))
        _write_digests(part)
    return target / "index.html"


def kind_of(target: Path) -> Kind:
    """Return what tells the files of an earlier site in a folder: pages of ours, and what its list of files names, unchanged."""
    try:
        listed = json.loads((target / FILES).read_text(encoding="utf-8"))
    except (OSError, ValueError):
        listed = {}
    digests = listed if isinstance(listed, dict) else {}

    def is_ours(entry: Path) -> bool:
        if entry.name == FILES:
            return entry.is_file() and bool(digests)
        if entry.name in digests:
            return entry.is_file() and digests[entry.name] == _digest(entry)
        return is_page(entry)

    return Kind("site", "--out", is_ours)


def _build_all(order: Order, part: Path, workers: int) -> Iterator[Built]:
    """Yield what became of each lesson; the processes begin before Drake is imported."""
    with start_pool(workers) as pool:
        try:
            editions = [(each, pool.submit(work.describe, each).result()) for each in order.in_each_language()]
            futures = {
                pool.submit(work.build_lesson, each, described, k, part): k
                for each, described in editions for k in range(len(order.sources))
            }  # fmt: skip
            rest = [pool.submit(work.build_rest, each, described, part) for each, described in editions]
            for future in as_completed(futures):
                source = order.sources[futures[future]]
                try:
                    yield future.result()
                except BrokenProcessPool:
                    yield Built(source, problem=f"{source}: {_PATIENCE}")
            for written in rest:
                written.result()
        except ArmproofError:
            raise
        except BrokenProcessPool:
            raise SiteError("the site cannot be built: {patience}", patience=_PATIENCE) from None
        finally:
            pool.shutdown(wait=True, cancel_futures=True)


def _write_digests(part: Path) -> None:
    """Write the list of the files that are no pages, so that a notebook that a student works in is not replaced."""
    digests = {path.name: _digest(path) for path in sorted(part.iterdir()) if path.suffix != ".html"}
    (part / FILES).write_text(json.dumps(digests, indent=1) + "\n", encoding="ascii")


def _digest(path: Path) -> str:
    return hashlib.sha256(path.read_bytes()).hexdigest()
