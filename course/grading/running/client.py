"""The teacher's side of the grading server: starts it, sends it submissions, and starts it anew should it ever be lost."""

from __future__ import annotations

import json
import os
import queue
import signal
import socket
import subprocess
import sys
import tempfile
import threading
from collections.abc import Iterable, Sequence
from contextlib import suppress
from pathlib import Path
from typing import Any

from armproof.course.errors import GradingError
from armproof.course.grading.running.keeper import Ended
from armproof.course.grading.running.own_folder import remove
from armproof.course.grading.sandbox.bubblewrap import find_bubblewrap
from armproof.course.grading.sandbox.limits import LIBRARIES, Limits
from armproof.models.language import spoken

LOST = "the process that runs it was lost twice"
_GRACE = 30.0  # s beyond a submission's own time, after which a keeper that does not answer is given up
_STARTING = 300.0
_PATIENCE = 8.0
_KEPT = "PATH PYTHONPATH PYTHONHOME LD_LIBRARY_PATH DYLD_LIBRARY_PATH VIRTUAL_ENV HOME SYSTEMROOT".split()


class Client:
    """A context in which submissions can be run, from as many threads as there are jobs.

    Attributes:
        jobs: how many at once.
        catalogue: the lessons and tasks of the course.
        held: which protections are in force, by the names of `protections.ATTEMPTS`.
    """

    def __init__(
        self, jobs: int, limits: Limits, used: Iterable[str] = (), own: Path | None = None, *, unprotected: bool = False
    ) -> None:
        """Take what the server is started with.

        Args:
            jobs: how many submissions at once.
            limits: for each of them.
            used: the lessons that will be asked for.
            own: the folder of a teacher's own lessons.
            unprotected: run them without a sandbox.
        """
        self.jobs, self._limits, self._unprotected = jobs, limits, unprotected
        self._own = "" if own is None else str(own.resolve())
        self._used = " ".join(sorted(set(used)))
        self._lock = threading.Lock()
        self._generation = 0
        self._closed = False
        self.catalogue: list[dict[str, Any]] = []
        self.held: dict[str, bool] = {}

    def __enter__(self) -> Client:
        self._bubblewrap = "" if self._unprotected else find_bubblewrap()
        try:
            self._start()
        except BaseException:
            self.__exit__()
            raise
        return self

    def __exit__(self, *problem: object) -> None:
        self._closed = True
        self._stop()

    def run(self, cells: Sequence[str], limits: Limits | None = None) -> Ended:
        """Run the code cells of a submission; a server that was lost meanwhile is started anew, and it is run once more.

        Args:
            cells: their sources.
            limits: other limits than those of the class.
        """
        limits = limits or self._limits
        line = json.dumps({"cells": list(cells), "limits": limits.as_json()}).encode() + b"\n"
        for _ in range(2):
            generation = self._generation
            slot = self._free.get()
            try:
                return self._ask(slot, line, limits.seconds)
            except (OSError, ValueError, TypeError):
                self._restart(generation)
            finally:
                if generation == self._generation:
                    self._free.put(slot)
        return Ended("server", output=LOST)

    def _ask(self, slot: socket.socket, line: bytes, seconds: float) -> Ended:
        slot.settimeout(seconds + _GRACE)
        slot.sendall(line)
        return Ended(**json.loads(_read_line(slot)))

    def _restart(self, generation: int) -> None:
        with self._lock:
            if generation == self._generation and not self._closed:
                self._stop()
                self._start()

    def _start(self) -> None:
        self._base = tempfile.mkdtemp(prefix="armproof-grade-")
        os.chmod(self._base, 0o711)  # a run of another user finds its own folder there, and none other
        pairs = [socket.socketpair() for _ in range(self.jobs)]
        ends = [theirs.fileno() for _, theirs in pairs]
        server = (sys.executable, "-P", "-m", "armproof.course.grading.running.server")
        command = [*server, self._base, self._bubblewrap, self._used, self._own, *map(str, ends)]
        self._server = subprocess.Popen(
            command, pass_fds=ends, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, env=_environment(),
            cwd=self._base, start_new_session=True,
        )  # fmt: skip
        self._slots = [ours for ours, _ in pairs]
        for _, theirs in pairs:
            theirs.close()
        hello = self._hello()
        self.catalogue, self.held = hello["catalogue"], hello["held"]
        self._free: queue.Queue[socket.socket] = queue.Queue()
        for slot in self._slots:
            self._free.put(slot)
        self._generation += 1

    def _hello(self) -> dict[str, Any]:
        hello: dict[str, Any] = {}
        try:
            for slot in self._slots:
                slot.settimeout(_STARTING)
                hello = json.loads(_read_line(slot))
        except (OSError, ValueError):
            raise GradingError("the grading server did not start; what it said stands above") from None
        if "error" in hello:
            raise GradingError(hello["error"])
        return hello

    def _stop(self) -> None:
        for slot in getattr(self, "_slots", ()):
            with suppress(OSError):
                slot.shutdown(socket.SHUT_RDWR)  # wakes a thread that waits for it
            slot.close()
        server = getattr(self, "_server", None)
        if server is None:
            return
        for how in (signal.SIGTERM, signal.SIGKILL):
            with suppress(ProcessLookupError, PermissionError):
                os.killpg(server.pid, how)
            with suppress(subprocess.TimeoutExpired):
                server.wait(_PATIENCE)
                break
        remove(self._base)


def _read_line(slot: socket.socket) -> bytes:
    parts: list[bytes] = []
    while not parts or not parts[-1].endswith(b"\n"):
        part = slot.recv(1 << 16)
        if not part:
            raise ConnectionError("the server has ended")
        parts.append(part)
    return b"".join(parts)


def _environment() -> dict[str, str]:
    """Return an environment of the server without anything of the teacher's that a submission might read."""
    kept = {name: os.environ[name] for name in _KEPT if name in os.environ}
    if "PYTHONPATH" in kept:
        parts = (Path(part).resolve() for part in kept["PYTHONPATH"].split(os.pathsep) if part)
        kept["PYTHONPATH"] = os.pathsep.join(map(str, parts))
    return kept | LIBRARIES | {"PYTHONUTF8": "1", "PYTHONDONTWRITEBYTECODE": "1", "LANGUAGE": spoken()}
