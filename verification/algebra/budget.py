"""The time that a proof may take: processor time of its thread, so that a busy machine changes no verdict."""

from __future__ import annotations

import math
import time
from collections.abc import Iterator
from contextlib import contextmanager

from armproof.verification.errors import TooComplex
from armproof.verification.findings import Kind, say


class Budget:
    """Seconds of this thread's processor time, counted from now; without a number, as many as it takes.

    The owner of a budget gives it; each phase of the work (to decide, to explain) takes the place of the one before with
    `of`. Who computes with it only asks.
    """

    def __init__(self, seconds: float = math.inf) -> None:
        self.asked = 0  # how often: a measure of the work that is the same on every machine
        self._last = math.inf
        self._end = time.thread_time() + seconds
        self._asked_from = 0.0  # of the wall clock, which costs little to read: before, no thread can have used so much

    @property
    def is_spent(self) -> bool:
        """Whether the time is over, or the work done."""
        self.asked += 1
        if self.asked > self._last:
            return True
        now = time.monotonic()
        if now < self._asked_from:
            return False
        left = self._end - time.thread_time()
        self._asked_from = now + left
        return left < 0

    def check(self) -> None:
        """Raise TooComplex when the time is over."""
        if self.is_spent:
            raise TooComplex(say(Kind.OUT_OF_TIME))

    def share(self, seconds: float) -> Budget:
        """Return a budget of so many seconds that ends no later than this one."""
        part = Budget(seconds)
        part._end = min(part._end, self._end)
        return part

    @contextmanager
    def paused(self) -> Iterator[None]:
        """Let what is done once for all displays, to load a library or a plant, cost this one no time."""
        begun = time.thread_time()
        try:
            yield
        finally:
            self._end += time.thread_time() - begun

    @contextmanager
    def of(self, seconds: float, work: float = math.inf) -> Iterator[None]:
        """Give a phase of the work so many seconds of its own, and so many questions; behind it, what was left before holds again."""
        before, last = self._end, self._last
        self._end, self._last, self._asked_from = time.thread_time() + seconds, self.asked + work, 0.0
        try:
            yield
        finally:
            self._end, self._last, self._asked_from = before, last, 0.0
