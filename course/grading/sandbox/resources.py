"""The limits that the kernel keeps for each process: memory, processor time, files, processes."""

from __future__ import annotations

import contextlib
import math
import os
import resource
from pathlib import Path

from armproof.course.grading.sandbox.limits import Limits


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
