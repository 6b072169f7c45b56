"""Watch one run: its time, its memory, the files it writes, and what it prints and reports."""

from __future__ import annotations

import contextlib
import os
import select
import time

from armproof.course.grading.running.own_folder import size_of
from armproof.course.grading.running.processes import descendants, memory_of
from armproof.course.grading.sandbox.limits import Limits

_TICK = 0.05  # s between looks at the run's memory
_SURVEY = 0.5  # s between looks at all of its processes, and at its folder
_CHUNK = 1 << 16


class Watch:
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
