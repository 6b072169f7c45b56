"""How far a long command is: a bar on a terminal, nothing anywhere else."""

from __future__ import annotations

import sys
import time
from types import TracebackType

WIDTH = 30
SILENT = 0.5  # seconds: what takes no longer needs no bar


class Progress:
    """A bar on standard error that is never left behind; it is cleared before anything else is written."""

    def __init__(self, total: int, noun: str = "documents") -> None:
        self.total = total
        self.noun = noun
        self.done = 0
        self._shown = False
        self._silent_until = time.monotonic() + SILENT
        self._on_terminal = total > 1 and sys.stderr.isatty()

    def __enter__(self) -> Progress:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, traceback: TracebackType | None
    ) -> None:
        self.clear()

    def advance(self, by: int = 1) -> None:
        """Count what is done, and show how far it is."""
        self.done += by
        if self._on_terminal and self.done < self.total and time.monotonic() > self._silent_until:
            sys.stdout.flush()
            full = WIDTH * self.done // self.total
            sys.stderr.write(f"\r\x1b[K[{'#' * full}{'.' * (WIDTH - full)}] {self.done} of {self.total} {self.noun}")
            sys.stderr.flush()
            self._shown = True

    def clear(self) -> None:
        """Take the bar away, so that a line may be written where it stood."""
        if self._shown:
            sys.stderr.write("\r\x1b[K")
            sys.stderr.flush()
            self._shown = False
