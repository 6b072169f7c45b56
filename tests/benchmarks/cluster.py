"""How many documents a Dask cluster checks with one worker and with two, and what they cost its scheduler and this process."""

from __future__ import annotations

import os
import pickle
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path
from statistics import mean

from armproof.verification.report.text import text_report
from armproof.verification.running.cluster import Cluster
from armproof.verification.running.on_cluster import MOST_AT_ONCE, check_each_on
from armproof.verification.running.parcels import Parcel, check_parcel, pack
from armproof.verification.verdict import DocumentResult
from tests.benchmarks.documents import synthetic
from tests.clusters import Running, run_cluster

DISPLAYS = 20
TASKS = 200  # that are only handed to and fro
TICKS = os.sysconf("SC_CLK_TCK")


@dataclass(frozen=True)
class Measured:
    """What was measured.

    Attributes:
        one, two: seconds with one worker and with two, the connection and the import of Drake included.
        client: seconds of processor time of this process for a document: sent, taken back, written.
        scheduler: seconds of processor time of the scheduler for a task of `MOST_AT_ONCE` documents.
        sent, received: mean bytes of a document and of its result.
    """

    one: float
    two: float
    client: float
    scheduler: float
    sent: float
    received: float

    @property
    def efficiency(self) -> float:
        """The time with one worker against twice that with two."""
        return self.one / (2 * self.two)


def measure(number: int) -> Measured:
    """Check so many different documents with one worker and with two, on a cluster that speaks TLS on this machine."""
    with tempfile.TemporaryDirectory() as folder:
        paths = [Path(folder) / f"{k:05}.md" for k in range(number)]
        for k, path in enumerate(paths):
            path.write_text(synthetic(DISPLAYS, 2 + 7 * k), encoding="utf-8")
        some = [parcel for path in paths[:MOST_AT_ONCE] if (parcel := pack(path))]
        with run_cluster(_new(folder, "one"), 1) as running:
            one, client = _time_checks(running, 1, paths)
        with run_cluster(_new(folder, "two"), 2) as running:
            two, _ = _time_checks(running, 2, paths)
            scheduler = _time_tasks(running, some)
    sent = mean(len(pickle.dumps(parcel)) for parcel in some)
    return Measured(one, two, client / number, scheduler, sent, mean(len(check_parcel(each, False)) for each in some))


def _new(folder: str, name: str) -> Path:
    path = Path(folder) / name
    path.mkdir()
    return path


def _time_checks(running: Running, workers: int, paths: list[Path]) -> tuple[float, float]:
    """Return the seconds of a run with its report, and this process's seconds of processor time."""
    _wait_for(running, workers)
    started, own = time.perf_counter(), time.process_time()
    with Cluster(running.address) as cluster:
        results = list(check_each_on(cluster, paths))
        for _ in text_report(results, strict=False):
            pass
    if not all(isinstance(each, DocumentResult) and each.passed for each in results):
        raise SystemExit("a synthetic document does not pass")
    return time.perf_counter() - started, time.process_time() - own


def _time_tasks(running: Running, parcels: list[Parcel]) -> float:
    """Return the scheduler's seconds of processor time for a task that comes back as it is sent."""
    with Cluster(running.address) as cluster:
        before = _busy(running.scheduler.pid)
        for _ in cluster.share_out(list, [parcels] * TASKS, list):
            pass
        return (_busy(running.scheduler.pid) - before) / TASKS


def _wait_for(running: Running, workers: int) -> None:
    threads = 0
    while threads < workers:
        with Cluster(running.address) as cluster:
            threads = cluster.threads


def _busy(pid: int) -> float:
    """Return the seconds of processor time that a process has taken."""
    fields = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / TICKS
