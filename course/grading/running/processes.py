"""The processes of one run: who descends from it, what memory they take, and how all of them are ended."""

from __future__ import annotations

import contextlib
import os
import signal
import time
from pathlib import Path

_PATIENCE = 5.0  # s to end all processes in


def memory_of(process: int) -> int:
    """Return the bytes of memory that are a process's own; 0 where the system does not say, or it has ended."""
    own = 0
    with contextlib.suppress(OSError, ValueError):
        for line in Path(f"/proc/{process}/status").read_text(encoding="utf-8", errors="replace").splitlines():
            if line.startswith("RssAnon:"):
                own = int(line.split()[1])
            elif line.startswith("RssShmem:"):
                return (own + int(line.split()[1])) * 1024
    return 0


def descendants(ancestor: int) -> list[int]:
    """Return all processes that descend from one, as far as the system says."""
    children: dict[int, list[int]] = {}
    with contextlib.suppress(OSError):
        for name in filter(str.isdigit, os.listdir("/proc")):
            with contextlib.suppress(OSError, ValueError, IndexError):
                with open(f"/proc/{name}/stat", "rb") as file:
                    parent = int(file.read().rpartition(b")")[2].split()[1])
                children.setdefault(parent, []).append(int(name))
    found = list(children.get(ancestor, ()))
    for each in found:
        found += children.get(each, ())
    return found


def end_all(first: int) -> tuple[int | None, float]:
    """End a process, its group and all that descend from this one, and wait for them.

    Returns the first one's wait status, and the seconds of processor time that all of them took, as far as the system says.

    This process must be the reaper of its descendants (PR_SET_CHILD_SUBREAPER), so that one that left the group, and whose
    parent has ended, comes back to it.
    """
    status, busy = None, 0.0
    until = time.monotonic() + _PATIENCE
    with contextlib.suppress(OSError):
        os.killpg(first, signal.SIGKILL)
    while time.monotonic() < until:
        try:
            process, how, used = os.wait4(-1, os.WNOHANG)
        except ChildProcessError:
            return status, busy
        if process == first:
            status = how
        if process:
            busy += used.ru_utime + used.ru_stime
            continue
        for each in {first, *descendants(os.getpid())} if status is None else descendants(os.getpid()):
            with contextlib.suppress(OSError):
                os.kill(each, signal.SIGKILL)
        time.sleep(0.002)
    return status, busy
