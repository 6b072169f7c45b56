"""A call of somebody else's function: bounded in time, what it prints and raises kept, nothing around it changed."""

from __future__ import annotations

import contextlib
import io
import linecache
import math
import random
import signal
import sys
import threading
import time
import types
import warnings
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from armproof.models.errors import written
from armproof.verification.functions.kept_state import (
    KeptModules,
    bound_recursion,
    end_threads,
    harmless_clocks,
    raise_in,
)
from armproof.verification.functions.tracing.rebuild import is_library

_REPEAT = 0.02  # s between alarms once the time is up, for what swallows the first
_GRACE = 0.1  # s after which the watchdog ends what no alarm has ended
# as they are when this is loaded: a function may replace those of the module
_SET_TIMER: Callable[..., Any] = getattr(signal, "setitimer", signal.signal)
_SET_HANDLER = signal.signal
_PRINTED = 10_000  # characters


class TimeUp(BaseException):
    """The time is up; no Exception, so that a function's own `except Exception` does not swallow it."""


class Overtime(TimeUp):
    """The time is up, and no alarm has rung; made in the thread that is late, where it stops every line that follows."""

    def __init__(self) -> None:
        super().__init__()
        _raise_at_every_line(sys._getframe(1))


@dataclass(frozen=True)
class CallError:
    """What a function raised, and where in the user's code.

    Attributes:
        type: the name of the exception; "Timeout" where the time was up.
        message: its text.
        file, line, source: the deepest line of the user's own code; line 0 where there is none.
    """

    type: str
    message: str
    file: str = ""
    line: int = 0
    source: str = ""

    @property
    def is_timeout(self) -> bool:
        """Whether the function did not end in time."""
        return self.type == "Timeout"


@dataclass(frozen=True)
class Call:
    """One call: the value returned, or the error."""

    value: Any = None
    error: CallError | None = None


class Guard:
    """A context for calls of a user's function that share a limit of time.

    Inside it the standard output and error streams are kept in `printed`, warnings are silent and the standard input is empty;
    after it the random states of NumPy and `random`, NumPy's error and print settings, the recursion limit and the alarm
    clock are what they were, after each call the names in NumPy and `math`. Threads that a function starts end with the guard.
    KeyboardInterrupt passes through.
    """

    def __init__(self, seconds: float) -> None:
        self.seconds = seconds
        self._spent = 0.0
        self._inside = False
        self._alarms = 0
        self._buffer = _Bounded()
        self._stack = contextlib.ExitStack()
        self._by_signal = False
        self._overdue = False  # whether the watchdog has raised in this thread
        self._deadline = math.inf

    @property
    def printed(self) -> str:
        """What was printed so far."""
        return self._buffer.getvalue()

    @property
    def left(self) -> float:
        """The seconds that are left to the function; what is done between its calls does not count."""
        return self.seconds - self._spent

    def __enter__(self) -> Guard:
        enter, later = self._stack.enter_context, self._stack.callback
        enter(contextlib.redirect_stdout(self._buffer))
        enter(contextlib.redirect_stderr(self._buffer))
        enter(warnings.catch_warnings())
        warnings.simplefilter("ignore")
        later(setattr, sys, "stdin", sys.stdin)
        sys.stdin = io.StringIO()
        later(np.random.set_state, np.random.get_state())  # noqa: NPY002 - the user's, kept as it is
        later(random.setstate, random.getstate())
        enter(np.errstate())
        enter(np.printoptions())
        later(sys.setrecursionlimit, sys.getrecursionlimit())
        later(sys.settrace, sys.gettrace())
        self._modules = KeptModules()
        later(self._modules.put_back)
        later(end_threads, set(threading.enumerate()), _GRACE)
        self._by_signal = hasattr(signal, "setitimer") and threading.current_thread() is threading.main_thread()
        if self._by_signal:
            self._take_alarm()
            self._watch(threading.get_ident())
        return self

    def __exit__(self, *problem: object) -> None:
        self._stack.close()

    def call(self, function: Callable[[], Any]) -> Call:
        """Return what the function returns, iterators as lists, or what it raises."""
        if self.left <= 0:
            return Call(error=self._timeout(None))
        started = time.monotonic()
        try:
            with harmless_clocks():
                return self._call_with_alarm(function) if self._by_signal else self._call_in_thread(function)
        finally:
            self._modules.put_back()
            self._spent += time.monotonic() - started

    def _call(self, function: Callable[[], Any]) -> Call:
        self._alarms = 0
        try:
            self._inside = True
            try:
                value = function()
                value = list(value) if hasattr(value, "__next__") else value
            finally:
                self._inside = False
        except TimeUp as up:
            return Call(error=self._timeout(up.__traceback__))
        except SystemExit as end:
            return Call(error=_describe(end, written("the function ends the program: it calls exit()")))
        except Exception as problem:
            return Call(error=_describe(problem))
        if self._alarms:  # it swallowed the alarm
            return Call(error=self._timeout(None))
        return Call(value)

    def _timeout(self, traceback: types.TracebackType | None) -> CallError:
        place = _place(traceback)
        return CallError("Timeout", written("it did not end within {seconds:g} s", seconds=self.seconds), *place)

    # -- by the alarm clock, in the main thread ------------------------------------------------------------------------

    def _take_alarm(self) -> None:
        """Take the alarm clock over, and give it back with the guard."""
        handler, (left, interval) = signal.getsignal(signal.SIGALRM), signal.getitimer(signal.ITIMER_REAL)
        entered = time.monotonic()

        def give_back() -> None:
            signal.signal(signal.SIGALRM, handler)
            if left:
                signal.setitimer(signal.ITIMER_REAL, max(left - (time.monotonic() - entered), 1e-3), interval)

        self._stack.callback(give_back)
        signal.setitimer(signal.ITIMER_REAL, 0)

    def _call_with_alarm(self, function: Callable[[], Any]) -> Call:
        _SET_HANDLER(signal.SIGALRM, self._alarm)
        _SET_TIMER(signal.ITIMER_REAL, max(self.left, 1e-3), _REPEAT)
        self._deadline = time.monotonic() + max(self.left, 1e-3) + _GRACE
        try:
            return self._call(function)
        except TimeUp as up:  # rung as the call ended
            sys.settrace(None)  # what follows is ours: the watchdog may have set a trap at its lines
            return Call(error=self._timeout(up.__traceback__))
        finally:
            self._deadline = math.inf
            _SET_TIMER(signal.ITIMER_REAL, 0)
            self._let_pending_rise()

    def _let_pending_rise(self) -> None:
        """Let an exception of the watchdog that is still to come rise here and end.

        Taking it back with NULL leaves CPython 3.11 looking for it: from then on a profiler or debugger never ends.
        """
        if self._overdue:
            self._overdue = False
            with contextlib.suppress(TimeUp):
                raise_in(threading.get_ident(), TimeUp)
                for _ in range(100):
                    pass

    def _watch(self, thread: int) -> None:
        """Watch over a thread whose function may have stopped the alarm clock, until the guard is left."""
        left, limit = threading.Event(), sys.getrecursionlimit()

        def watch() -> None:
            while not left.wait(_REPEAT):
                bound_recursion(limit)
                if self._inside and time.monotonic() > self._deadline:
                    self._overdue = True
                    raise_in(thread, Overtime)

        watchdog = threading.Thread(target=watch, daemon=True)
        watchdog.start()
        self._stack.callback(watchdog.join)
        self._stack.callback(left.set)

    def _alarm(self, signum: int, frame: types.FrameType | None) -> None:
        if not self._inside:
            return
        self._alarms += 1
        if self._alarms > 1:  # `except: pass` swallowed the first: raise at the next line, in the handler itself
            _raise_at_every_line(frame)
        raise TimeUp

    # -- by a watchdog, in any other thread -----------------------------------------------------------------------------

    def _call_in_thread(self, function: Callable[[], Any]) -> Call:
        """Make the call in a thread of its own: one that sleeps cannot be woken, and is left behind."""
        done: list[Call] = []
        worker = threading.Thread(target=lambda: done.append(self._call(function)), daemon=True)
        worker.start()
        worker.join(max(self.left, 0.0))
        late = worker.is_alive()
        for _ in range(10):
            if self._inside and worker.ident is not None:
                raise_in(worker.ident, TimeUp)
            worker.join(_REPEAT)
            if not worker.is_alive():
                break
        if done and (not late or done[0].error is not None):
            return done[0]
        return Call(error=self._timeout(None))


def _raise_at_every_line(frame: types.FrameType | None) -> None:
    sys.settrace(_raise_at_a_line)
    while frame is not None and frame.f_code is not Guard._call.__code__:
        frame.f_trace = _raise_at_a_line
        frame = frame.f_back


def _raise_at_a_line(frame: types.FrameType, event: str, argument: Any) -> Any:
    if event == "line" and not is_library(frame.f_code.co_filename):
        raise TimeUp
    return _raise_at_a_line


class _Bounded(io.StringIO):
    """Keeps the beginning of what is written to it."""

    def write(self, text: str) -> int:
        """Write as much as there is room for."""
        super().write(text[: max(_PRINTED - self.tell(), 0)])
        return len(text)


def _describe(problem: BaseException, message: str = "") -> CallError:
    return CallError(type(problem).__name__, message or str(problem), *_place(problem.__traceback__))


def _place(traceback: types.TracebackType | None) -> tuple[str, int, str]:
    """Return file, line and source of the deepest frame in the user's own code."""
    place = ("", 0, "")
    while traceback is not None:
        name = traceback.tb_frame.f_code.co_filename
        if not is_library(name):
            place = (name, traceback.tb_lineno, linecache.getline(name, traceback.tb_lineno).strip())
        traceback = traceback.tb_next
    return place
