"""The keeper of one run: forks it into its sandbox, watches time, memory and output, and ends all of it.

The keeper is a process of its own, made for one submission; it knows of no other one.
"""

from __future__ import annotations

import contextlib
import json
import os
import secrets
import select
import signal
import sys
import tempfile
import time
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, NoReturn

from armproof.course.grading.limits import Limits
from armproof.course.grading.own_folder import remove, size_of
from armproof.course.grading.processes import descendants, end_all, memory_of
from armproof.course.grading.sandbox.kernel import PR_SET_CHILD_SUBREAPER, prctl
from armproof.course.grading.sandbox.namespaces import enter_namespaces
from armproof.course.grading.sandbox.plan import Plan, enter
from armproof.course.grading.sandbox.privileges import give_folder

_TICK = 0.05  # s between looks at the run's memory
_SURVEY = 0.5  # s between looks at all of its processes, and at its folder
_CHUNK = 1 << 16
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


def keep(run: Run, plan: Plan, limits: Limits, base: str, user: int | None) -> Ended:
    """Run a function in the sandbox, in a new folder below `base`; returns how it ended, when nothing of it is left."""
    own = tempfile.mkdtemp(prefix="run-", dir=base)
    try:
        owner = give_folder(own, user) if plan.user else None
        return _keep(run, plan, limits, own, owner)
    finally:
        remove(own)


def _keep(run: Run, plan: Plan, limits: Limits, own: str, user: int | None) -> Ended:
    token = secrets.token_hex(16)
    printed, reported = os.pipe(), os.pipe()
    prctl(PR_SET_CHILD_SUBREAPER, 1)
    if plan.namespaces and not enter_namespaces():
        return Ended("sandbox", output="the namespaces that were there when grading began are not")
    started = time.monotonic()
    child = os.fork()
    if child == 0:
        _be_the_run(run, plan, limits, Path(own), user, (printed[1], reported[1]), token)
    os.close(printed[1])
    os.close(reported[1])
    watch = _Watch(child, limits, own, printed[0], reported[0])
    try:
        why = watch.until_it_ends(started + limits.seconds)
    finally:
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


class _Watch:
    """Reads what a run prints and reports, within the limits."""

    def __init__(self, child: int, limits: Limits, own: str, output: int, reports: int) -> None:
        self._child, self._limits, self._own = child, limits, own
        self._pipes = {output, reports}
        self._output_pipe = output
        self._inherited = memory_of(os.getpid())
        self._next_survey = time.monotonic() + _SURVEY
        self.output, self.reports, self.printed = bytearray(), bytearray(), 0

    def until_it_ends(self, deadline: float) -> str:
        """Return why it is to be ended: "" if it ended by itself."""
        while not self._has_ended():
            left = deadline - time.monotonic()
            if left <= 0:
                return "time"
            if self._pipes:
                ready, _, _ = select.select(list(self._pipes), [], [], min(_TICK, left))
                for pipe in ready:
                    self._read(pipe)
            else:
                time.sleep(0.002)
            if why := self._excess():
                return why
        return ""

    def read_the_rest(self) -> None:
        """Read what is left in the pipes after all who write to them have ended."""
        for pipe in tuple(self._pipes):
            os.set_blocking(pipe, False)
            with contextlib.suppress(BlockingIOError):
                while pipe in self._pipes and self.printed < 2 * self._limits.flood:
                    self._read(pipe)

    def _has_ended(self) -> bool:
        if not hasattr(os, "waitid"):  # macOS: what closes both pipes has ended, or soon will have
            return not self._pipes
        return os.waitid(os.P_PID, self._child, os.WEXITED | os.WNOHANG | os.WNOWAIT) is not None

    def _read(self, pipe: int) -> None:
        data = os.read(pipe, _CHUNK)
        if not data:
            self._pipes.discard(pipe)
            os.close(pipe)
        elif pipe == self._output_pipe:
            self.printed += len(data)
            self.output += data[: max(self._limits.output - len(self.output), 0)]
        else:
            self.reports += data[: max(self._limits.results - len(self.reports), 0)]

    def _excess(self) -> str:
        if self.printed > self._limits.flood or len(self.reports) >= self._limits.results:
            return "output"
        if memory_of(self._child) - self._inherited > self._limits.memory:
            return "memory"
        if time.monotonic() < self._next_survey:
            return ""
        processes = {self._child, *descendants(os.getpid())}
        taken = sum(max(memory_of(each) - self._inherited, 0) for each in processes)
        disk = size_of(self._own)
        self._next_survey = time.monotonic() + _SURVEY
        return "memory" if taken > self._limits.memory else "disk" if disk > self._limits.disk else ""


def _be_the_run(
    run: Run, plan: Plan, limits: Limits, own: Path, user: int | None, pipes: tuple[int, int], token: str
) -> NoReturn:
    """Be the run, and end without any of what Python does as it ends."""
    code = 1
    try:
        os.setsid()
        reports = _arrange(pipes)
        me = _process()

        def send(report: dict[str, Any]) -> None:
            if _process() == me:  # not a child that the submission forked
                _write(reports, f"{token}{_dumps(report)}\n".encode())

        enter(plan, own, user, limits)
        run(send, own)
        code = 0
    except BaseException as problem:
        with contextlib.suppress(BaseException):
            os.write(2, f"{type(problem).__name__}: {problem}\n".encode(errors="replace"))
    finally:
        os._exit(code)


def _arrange(pipes: tuple[int, int]) -> int:
    """Leave nothing open but an empty standard input, the two outputs, and the reports; returns where these go."""
    output, reports = pipes
    kept = os.dup2(reports, 20 + secrets.randbelow(40), inheritable=False)
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
