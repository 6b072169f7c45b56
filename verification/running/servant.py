"""A process of its own that does one thing after another for this one, and ends when this one does, however that ends."""

from __future__ import annotations

import signal
import socket
import subprocess
import sys
from collections.abc import Callable
from contextlib import suppress
from multiprocessing.connection import Connection
from typing import Any

from armproof.models.language import asked, speak, spoken

PATIENCE = 5.0  # s to end in
IDLE = 60.0  # s without a request, after which it ends: it holds Drake, and whoever asked may be gone


class ServantEnded(Exception):
    """What a servant was asked for ended its process (Drake aborts on some models)."""


class Servant:
    """Does what it is asked in a process of its own, which is started at the first request and again where it ended."""

    def __init__(self) -> None:
        self._process: subprocess.Popen[bytes] | None = None

    def __enter__(self) -> Servant:
        return self

    def __exit__(self, *problem: object) -> None:
        self.end()

    def ask(self, work: Callable[..., Any], *arguments: Any) -> Any:
        """Return what a function returns in the other process, in the language that is spoken here.

        Args:
            work: a function that can be imported, which raises nothing.
            arguments: values that can be pickled.

        Raises:
            ServantEnded: it ended meanwhile.
        """
        if self._process is None or self._process.poll() is not None:
            self.end()
            self._start()
        try:
            self._connection.send((work, arguments, asked(), spoken()))
            return self._connection.recv()
        except (EOFError, OSError):
            self.end()
            raise ServantEnded from None
        except BaseException:  # an interrupt: what it answers would be taken for the answer to the next request
            self.end()
            raise

    def end(self) -> None:
        """End the process; where there is none, nothing."""
        process, self._process = self._process, None
        if process is not None:
            self._connection.close()
            with suppress(OSError):
                process.kill()
            with suppress(subprocess.TimeoutExpired):
                process.wait(PATIENCE)

    def _start(self) -> None:
        ours, theirs = socket.socketpair()
        command = [sys.executable, "-P", "-m", "armproof.verification.running.servant", str(theirs.fileno())]
        with theirs:
            self._process = subprocess.Popen(command, pass_fds=[theirs.fileno()], stdin=subprocess.DEVNULL)
        self._connection = Connection(ours.detach())


def serve(connection: Connection) -> None:
    """Do what is asked until the other end is closed, or asks for nothing any more."""
    with suppress(EOFError, OSError):
        while connection.poll(IDLE):
            work, arguments, asked_for, spoken_there = connection.recv()
            speak(asked_for, spoken_there)
            connection.send(work(*arguments))


if __name__ == "__main__":
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # which is for the process that asks
    serve(Connection(int(sys.argv[1])))
