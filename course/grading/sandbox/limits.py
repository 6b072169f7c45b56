"""What one submission may use, and the limits that the kernel keeps for each process: memory, processor time, files, processes."""

from __future__ import annotations

import contextlib
import math
import os
import resource
from dataclasses import asdict, dataclass
from pathlib import Path

MEGABYTE = 1 << 20
LIBRARIES = {f"{library}_NUM_THREADS": "1" for library in ("OMP", "OPENBLAS", "MKL", "NUMEXPR")} | {
    "MPLBACKEND": "agg",
    "ARMPROOF_PROGRESS": "",
}  # environment variables: one thread, no window


@dataclass(frozen=True)
class Limits:
    """The limits of one submission's run.

    Attributes:
        seconds: of wall clock; the processor's time is limited to a little more.
        memory: bytes, beyond what the libraries take.
        output: bytes of what is printed that are kept; the run is ended at `flood` bytes.
        disk: bytes of files in the run's own folder; one file may take a quarter of it.
        processes: processes and threads.
        files: open files.
        results: bytes that the run may report.
    """

    seconds: float = 60.0
    memory: int = 1024 * MEGABYTE
    output: int = 200_000
    flood: int = 20_000_000
    disk: int = 200 * MEGABYTE
    processes: int = 32
    files: int = 64
    results: int = 2_000_000

    def as_json(self) -> dict[str, float]:
        """Return the limits as JSON writes them."""
        return asdict(self)


def limit_resources(limits: Limits, *, shared: bool) -> None:
    """Limit this process and its children for good.

    Args:
        limits: what the run may use beyond what is already mapped.
        shared: whether the user has other processes, of which the kernel counts all.
    """
    others = _count_threads(os.geteuid()) if shared else 0
    _limit(resource.RLIMIT_AS, _mapped() + limits.memory)
    _limit(resource.RLIMIT_CPU, math.ceil(limits.seconds) + 2)
    _limit(resource.RLIMIT_FSIZE, limits.disk // 4)
    if others is not None:
        _limit(resource.RLIMIT_NPROC, others + limits.processes)
    _limit(resource.RLIMIT_NOFILE, limits.files)
    _limit(resource.RLIMIT_CORE, 0)


def _mapped() -> int:
    """Return the bytes of address space that this process has mapped; a guess where the system does not say."""
    try:
        return int(Path("/proc/self/statm").read_text().split()[0]) * os.sysconf("SC_PAGE_SIZE")
    except OSError:
        return 8 << 30


def _count_threads(user: int) -> int | None:
    """Return how many processes and threads a user has; None where the system does not say."""
    count = 0
    for entry in Path("/proc").glob("[0-9]*"):
        with contextlib.suppress(OSError):
            if entry.stat().st_uid == user:
                count += sum(1 for _ in (entry / "task").iterdir())
    return count or None


def _limit(what: int, value: int) -> None:
    hard = resource.getrlimit(what)[1]
    wanted = value if hard == resource.RLIM_INFINITY else min(value, hard)
    with contextlib.suppress(OSError, ValueError):  # macOS refuses some
        resource.setrlimit(what, (wanted, wanted))
