"""Submissions run on the workers of a Dask cluster: each worker has a grading server of its own, and its sandbox.

Only the code cells of a notebook travel, and how each run ended comes back: names stay here.
"""

from __future__ import annotations

import asyncio
import os
import threading
from collections.abc import Iterable, Mapping, Sequence
from contextlib import ExitStack
from dataclasses import asdict, dataclass
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from armproof.course.errors import GradingError
from armproof.course.grading.running.client import LOST, Client
from armproof.course.grading.running.keeper import Ended
from armproof.course.grading.sandbox.limits import MEGABYTE, Limits
from armproof.models.language import spoken, use
from armproof.verification.running.cluster import Cluster, TaskEnded
from armproof.verification.running.processes import cores

_LARGEST = 20 * MEGABYTE  # of a teacher's own lessons
_AHEAD = 2  # submissions a thread of the workers that are sent before their results are taken


@dataclass(frozen=True)
class Setup:
    """What a grading server is started with, as it travels.

    Attributes:
        run: the run of `armproof grade` that it is for.
        limits: for each submission.
        used: the lessons that will be asked for.
        own: the files of a teacher's own lessons, by their names below their folder.
        unprotected: whether there is no sandbox.
        lang: the language that is spoken.
    """

    run: str
    limits: Limits
    used: tuple[str, ...]
    own: tuple[tuple[str, bytes], ...]
    unprotected: bool
    lang: str


class OnWorkers:
    """A context in which submissions can be run, as in a `Client`, on the workers of a cluster.

    Attributes:
        jobs: how many submissions are sent at once.
        catalogue: the lessons and tasks of the course.
        held: which protections are in force on every worker, by the names of `protections.ATTEMPTS`.
    """

    def __init__(
        self,
        scheduler: str,
        limits: Limits,
        used: Iterable[str] = (),
        own: Path | None = None,
        *,
        unprotected: bool = False,
    ) -> None:
        """Take the address of the cluster's scheduler, and what each server is started with, as for a `Client`.

        Raises:
            ClusterError: others could read what is sent there.
            GradingError: the teacher's own lessons cannot be sent.
        """
        self._cluster, self.jobs = Cluster(scheduler, private=True), 0
        files = () if own is None else tuple(_files_of(own))
        self._setup = Setup(os.urandom(8).hex(), limits, tuple(sorted(set(used))), files, unprotected, spoken())
        self.catalogue: list[dict[str, Any]] = []
        self.held: dict[str, bool] = {}

    def __enter__(self) -> OnWorkers:
        """Start the servers; raises GradingError where one of them has no sandbox, and ClusterError as a `Cluster` does."""
        with ExitStack() as opened:
            opened.enter_context(self._cluster)
            opened.callback(self._cluster.on_each, end, self._setup.run)
            self._begin(self._cluster.on_each(begin, self._setup))
            self._opened = opened.pop_all()
        return self

    def __exit__(self, *problem: object) -> None:
        self._opened.close()

    def run(self, cells: Sequence[str], limits: Limits | None = None) -> Ended:
        """Run the code cells of a submission on a worker; one that is lost meanwhile is replaced by another.

        Raises:
            GradingError: a worker that came later has no sandbox.
            ClusterError: the scheduler is lost, or all workers are.
        """
        try:
            return Ended(**self._cluster.result(self._cluster.submit(run, self._setup, tuple(cells), limits)))
        except TaskEnded:
            return Ended("server", output=LOST)

    def _begin(self, begun: Mapping[str, Any]) -> None:
        for worker, found in begun.items():
            if isinstance(found, Exception):
                raise GradingError("worker {worker}: {reason}", worker=worker, reason=str(found))
        if not begun:
            raise GradingError("all workers of the Dask cluster were lost")
        self.jobs = _AHEAD * self._cluster.threads
        self.catalogue = next(iter(begun.values()))[0]
        held = [each for _, each in begun.values()]
        self.held = {name: all(each[name] for each in held) for name in held[0]}


def _files_of(folder: Path) -> Iterable[tuple[str, bytes]]:
    """Yield the files of a teacher's own lessons; hidden ones and notebooks are none."""
    total = 0
    for path in sorted(folder.rglob("*")):
        name = path.relative_to(folder)
        if (
            path.suffix == ".ipynb"
            or any(part.startswith((".", "__pycache__")) for part in name.parts)
            or not path.is_file()
        ):
            continue
        if (total := total + path.stat().st_size) > _LARGEST:
            raise GradingError("{folder}: more than {number} MB, which is not sent to a cluster; put nothing but the lessons into it",
                folder=folder, number=_LARGEST // MEGABYTE)  # fmt: skip
        yield str(name), path.read_bytes()


# -- on a worker -------------------------------------------------------------------------------------------------------

_lock = threading.Lock()
_open: dict[str, tuple[Client, ExitStack]] = {}  # the servers of this worker, by the run that each is for


async def begin(setup: Setup) -> tuple[list[dict[str, Any]], dict[str, bool]]:
    """Start this worker's server, which the scheduler's questions need not wait for; returns its catalogue and what is held."""
    client = await asyncio.to_thread(_client_of, setup)
    return client.catalogue, client.held


def run(setup: Setup, cells: tuple[str, ...], limits: Limits | None) -> dict[str, Any]:
    """Run the code cells of a submission on this worker; raises GradingError where it has no sandbox."""
    with use(setup.lang):
        return asdict(_client_of(setup).run(cells, limits))


async def end(run: str) -> None:
    """End this worker's server for a run."""
    await asyncio.to_thread(_end, run)


def _end(run: str) -> None:
    with _lock:
        _, opened = _open.pop(run, (None, None))
    if opened is not None:
        opened.close()


def _client_of(setup: Setup) -> Client:
    """Return what runs submissions here: its server is started at the first request."""
    with _lock, use(setup.lang):
        if setup.run not in _open:
            _open[setup.run] = _opened(setup)
        return _open[setup.run][0]


def _opened(setup: Setup) -> tuple[Client, ExitStack]:
    with ExitStack() as opened:
        own = _unpacked(setup.own, opened) if setup.own else None
        client = Client(cores(), setup.limits, setup.used, own, unprotected=setup.unprotected)
        return opened.enter_context(client), opened.pop_all()


def _unpacked(files: Iterable[tuple[str, bytes]], opened: ExitStack) -> Path:
    folder = Path(opened.enter_context(TemporaryDirectory(prefix="armproof-lessons-")))
    for name, data in files:
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_bytes(data)
    return folder
