"""The keeper of one run: forks it into its sandbox, watches time, memory and output, and ends all of it.

The keeper is a process of its own, made for one submission; it knows of no other one.
"""

from __future__ import annotations

import contextlib
import fcntl
import json
import os
import secrets
import signal
import sys
import tempfile
import time
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, NoReturn

from armproof.course.errors import SandboxError
from armproof.course.grading.running.own_folder import remove
from armproof.course.grading.running.processes import end_all
from armproof.course.grading.running.watch import Watch
from armproof.course.grading.sandbox.bubblewrap import SEARCHED, Sandbox
from armproof.course.grading.sandbox.kernel import PR_SET_CHILD_SUBREAPER, PR_SET_PDEATHSIG, prctl
from armproof.course.grading.sandbox.limits import LIBRARIES, Limits, limit_resources

Send = Callable[[dict[str, Any]], None]
_dumps, _write_bytes, _process = json.dumps, os.write, os.getpid  # as they are now, whatever a submission makes of them
Run = Callable[[Send, Path], None]


@dataclass
class Ended:
    """How a run ended, and what it reported: facts of the keeper, and lines that the run itself wrote.

    Attributes:
        why: "" where it ended of its own accord; else "time", "memory", "output", "disk", "sandbox".
        code: its exit code; negative, the signal.
        seconds: of wall clock.
        busy: seconds of processor time.
        printed: how many bytes it printed; `output` holds the beginning.
        lines: what it reported, in JSON.
        foreign: whether something else was written where it reports.
    """

    why: str = ""
    code: int = 0
    seconds: float = 0.0
    busy: float = 0.0
    printed: int = 0
    output: str = ""
    lines: list[str] = field(default_factory=list)
    foreign: bool = False


def keep(run: Run, bubblewrap: str, limits: Limits, base: str, user: int | None) -> Ended:
    """Run a function in a sandbox, in a new folder below `base`; returns how it ended, when nothing of it is left.

    Args:
        run: takes what sends reports, and the folder.
        bubblewrap: the program; "" for a process with limits and no sandbox.
        limits: what it may use.
        base: the folder of the runs' folders.
        user: for root, who the run is to be in its sandbox.
    """
    own = tempfile.mkdtemp(prefix="run-", dir=base)
    prctl(PR_SET_CHILD_SUBREAPER, 1)
    try:
        sandbox = Sandbox(bubblewrap, own, user) if bubblewrap else None
        return _keep(run, sandbox, limits, own)
    except SandboxError as problem:
        return Ended("sandbox", output=str(problem))
    finally:
        remove(own)


def _keep(run: Run, sandbox: Sandbox | None, limits: Limits, own: str) -> Ended:
    token = secrets.token_hex(16)
    printed, reported = os.pipe(), os.pipe()
    started = time.monotonic()
    child = os.fork()
    if child == 0:
        _be_the_run(run, sandbox, limits, Path(own), (printed[1], reported[1]), token)
    os.close(printed[1])
    os.close(reported[1])
    watch = Watch(child, limits, own, printed[0], reported[0])
    try:
        why = watch.until_it_ends(started + limits.seconds)
    finally:
        if sandbox is not None:
            sandbox.end()
        status, busy = end_all(child)
    watch.read_the_rest()
    code = os.waitstatus_to_exitcode(status) if status is not None else -signal.SIGKILL
    lines, foreign = _with_token(bytes(watch.reports), token)
    text = bytes(watch.output).decode("utf-8", errors="replace")
    return Ended(why, code, round(time.monotonic() - started, 3), round(busy, 3), watch.printed, text, lines, foreign)


def _with_token(reports: bytes, token: str) -> tuple[list[str], bool]:
    """Return the lines that begin with the token, without it, and whether there were others."""
    lines = reports.decode("utf-8", errors="replace").split("\n")
    ours = [line[len(token) :] for line in lines if line.startswith(token)]
    return ours, len(ours) + 1 < len(lines) and any(line and not line.startswith(token) for line in lines[:-1])


def _be_the_run(
    run: Run, sandbox: Sandbox | None, limits: Limits, own: Path, pipes: tuple[int, int], token: str
) -> NoReturn:
    """Be the run, and end without any of what Python does as it ends."""
    code = 1
    try:
        os.dup2(pipes[0], 2)  # what goes wrong from here on is said in the output
        os.setsid()
        os.nice(5)  # whoever watches comes first
        limit_resources(limits, shared=sandbox is None)
        if sandbox is not None:
            sandbox.enter()
        prctl(PR_SET_PDEATHSIG, signal.SIGKILL)  # a change of user clears it
        reports = _arrange(pipes)
        os.chdir(own)
        given = _environment(own)
        os.environ.clear()
        os.environ.update(given)
        me = _process()

        def send(report: dict[str, Any]) -> None:
            if _process() == me:  # not a child that the submission forked
                _write(reports, f"{token}{_dumps(report)}\n".encode())

        run(send, own)
        code = 0
    except BaseException as problem:
        with contextlib.suppress(BaseException):
            os.write(2, f"{type(problem).__name__}: {problem}\n".encode(errors="replace"))
    finally:
        os._exit(code)


def _environment(own: Path) -> dict[str, str]:
    """Return the environment of a run: nothing of the teacher's but the language in which lessons answer."""
    home = dict.fromkeys(("HOME", "TMPDIR", "MPLCONFIGDIR", "XDG_CACHE_HOME", "JUPYTER_DATA_DIR"), str(own))
    return home | LIBRARIES | {"PATH": SEARCHED, "LANG": "C.UTF-8", "LANGUAGE": os.environ.get("LANGUAGE", "")}


def _arrange(pipes: tuple[int, int]) -> int:
    """Leave nothing open but an empty standard input, the two outputs, and the reports; returns where these go."""
    output, reports = pipes
    kept = fcntl.fcntl(
        reports, fcntl.F_DUPFD_CLOEXEC, 20 + secrets.randbelow(40)
    )  # a free one: neither output nor itself
    nothing = os.open(os.devnull, os.O_RDONLY)
    for source, target in ((nothing, 0), (output, 1), (output, 2)):
        os.dup2(source, target)
    os.closerange(3, kept)
    os.closerange(kept + 1, 4096)
    sys.stdin = open(0, encoding="utf-8", closefd=False)  # noqa: SIM115 - open to the end
    sys.stdout = open(1, "w", encoding="utf-8", errors="replace", closefd=False)  # noqa: SIM115
    sys.stderr = open(2, "w", encoding="utf-8", errors="replace", closefd=False, buffering=1)  # noqa: SIM115
    return kept


def _write(pipe: int, data: bytes) -> None:
    while data:
        data = data[_write_bytes(pipe, data) :]
