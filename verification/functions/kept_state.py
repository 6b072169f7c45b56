"""What somebody else's function may change around it, put back: modules, signals, the recursion limit, threads."""

from __future__ import annotations

import builtins
import cmath
import contextlib
import ctypes
import math
import random
import signal
import sys
import threading
import types
from collections.abc import Callable, Iterator
from operator import is_
from typing import Any

import numpy as np

DEEPEST = 1_300  # calls within calls that a function may ask for: from 1,600 on, Python 3.13 ends in those of C
_KEPT = (np, np.linalg, math, cmath, random, builtins, signal, threading)


class KeptModules:
    """The names in the modules that functions use, as they were."""

    def __init__(self) -> None:
        self._before = [(vars(module), dict(vars(module))) for module in _KEPT]

    def put_back(self) -> None:
        """Give every name its value again; names that are new stay, as those of modules that NumPy loads late."""
        for now, before in self._before:
            if not (len(now) >= len(before) and all(map(is_, now.values(), before.values()))):
                now.update(before)


@contextlib.contextmanager
def harmless_clocks() -> Iterator[None]:
    """Within it the calls that turn the alarm clock off, block its signal or let a function recurse without end do nothing."""
    changed: list[tuple[types.ModuleType, str, Callable[..., Any]]] = [
        (sys, "setrecursionlimit", lambda limit: _SET_LIMIT(min(limit, DEEPEST))),
        (signal, "setitimer", lambda *_: (0.0, 0.0)),
        (signal, "alarm", lambda *_: 0),
        (signal, "signal", lambda number, *_: signal.getsignal(number)),
        (signal, "pthread_sigmask", lambda *_: set()),
    ]
    before = [(module, name, getattr(module, name)) for module, name, _ in changed if hasattr(module, name)]
    try:
        for module, name, replacement in changed:
            if hasattr(module, name):
                setattr(module, name, replacement)
        yield
    finally:
        for module, name, original in before:
            setattr(module, name, original)


_SET_LIMIT = sys.setrecursionlimit


def bound_recursion(limit: int) -> None:
    """Lower the recursion limit to what it was, where a function has got round `harmless_clocks`."""
    if sys.getrecursionlimit() > max(limit, DEEPEST):
        _SET_LIMIT(limit)


def end_threads(before: set[threading.Thread], seconds: float) -> None:
    """End the threads that a function has left running: cancel timers, and end the others as sys.exit does."""
    left = [thread for thread in threading.enumerate() if thread not in before and thread.is_alive()]
    for thread in left:
        if isinstance(thread, threading.Timer):
            thread.cancel()
        elif thread.ident is not None:
            raise_in(thread.ident, SystemExit)
    for thread in left:
        thread.join(seconds / len(left))


def raise_in(thread: int, problem: type[BaseException]) -> None:
    """Raise an exception in a thread, at its next step in Python."""
    ctypes.pythonapi.PyThreadState_SetAsyncExc(ctypes.c_ulong(thread), ctypes.py_object(problem))
