"""Work in a copy of this process: what it changes is gone with it."""

from __future__ import annotations

import os
import resource
import select
import signal
import time
import traceback
from collections.abc import Callable
from contextlib import suppress

FAULT = "fault of the tool"
PATIENT = 20  # twentieths of a second that a process has to end, once it tells no more


def in_a_copy(work: Callable[[int], None], patience: float) -> tuple[list[str], int]:
    """Return the lines that the work told into the pipe that it was given, and its exit code; negative: the signal that ended it.

    A copy that tells nothing for so many seconds is ended.
    """
    reading, writing = os.pipe()
    copy = os.fork()
    if copy == 0:
        _run(work, writing)
    os.close(writing)
    told = b""
    while select.select([reading], [], [], patience)[0] and (more := os.read(reading, 1 << 16)):
        told += more
    os.close(reading)
    code = _end(copy)
    lines = told.decode().splitlines()
    if FAULT in lines:
        raise RuntimeError("\n".join(lines[lines.index(FAULT) :]))
    return lines, code


def tell(pipe: int, line: str) -> None:
    """Write a line into the pipe to the process that waits for the copy."""
    os.write(pipe, f"{line}\n".encode())


def allow(seconds: int) -> None:
    """End this process when it has used so many more seconds of processor time."""
    used = int(time.process_time()) + 1
    resource.setrlimit(resource.RLIMIT_CPU, (used + seconds, resource.getrlimit(resource.RLIMIT_CPU)[1]))


def _run(work: Callable[[int], None], writing: int) -> None:
    try:
        nowhere = os.open(os.devnull, os.O_RDWR)
        for number in range(3):
            os.dup2(nowhere, number)
        work(writing)
    except BaseException:
        tell(writing, f"{FAULT}\n{traceback.format_exc()}")
    finally:
        os._exit(0)  # nothing of the tests is run once more here


def _end(copy: int) -> int:
    for _ in range(PATIENT):
        done, status = os.waitpid(copy, os.WNOHANG)
        if done:
            return os.waitstatus_to_exitcode(status)
        time.sleep(0.05)
    with suppress(ProcessLookupError):
        os.kill(copy, signal.SIGKILL)
    return os.waitstatus_to_exitcode(os.waitpid(copy, 0)[1])
