"""A guarded call ends, keeps what it meets, and leaves everything as it was."""

from __future__ import annotations

import math
import random
import signal
import subprocess
import sys
import threading
import time
import warnings
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from armproof.verification.functions.guarded_call import Call, CallError, Guard, Overtime

HERE = __file__


def returns() -> int:
    return 3


def loops() -> None:
    while True:
        pass


def swallows() -> None:
    while True:
        try:  # noqa: SIM105
            len("abc")
        except:  # noqa: E722
            pass


def sleeps() -> None:
    time.sleep(30)


def sleeps_and_swallows() -> None:
    while True:
        try:  # noqa: SIM105
            time.sleep(30)
        except:  # noqa: E722
            pass


def answers_late() -> int:
    try:
        while True:
            pass
    except BaseException:
        return 3


def endless() -> Any:
    k = 0
    while True:
        yield k
        k += 1


def recurses() -> None:
    recurses()


def divides() -> float:
    return 1 / int("0")  # the line that is reported


def leaves() -> None:
    sys.exit(1)


def asks() -> str:
    return input("a value? ")


SET_TIMER = signal.setitimer  # as a function may keep them that was loaded before


def stops_the_clock() -> None:
    signal.setitimer(signal.ITIMER_REAL, 0)
    signal.alarm(0)
    loops()


def stops_the_clock_itself() -> None:
    SET_TIMER(signal.ITIMER_REAL, 0)
    swallows()


def ignores_the_alarm() -> None:
    signal.signal(signal.SIGALRM, signal.SIG_IGN)
    loops()


def blocks_the_alarm() -> None:
    signal.pthread_sigmask(signal.SIG_BLOCK, [signal.SIGALRM])
    loops()


def starts_a_timer() -> None:
    threading.Timer(0.01, lambda: SET_TIMER(signal.ITIMER_REAL, 0)).start()
    loops()


def recurses_deep() -> None:
    sys.setrecursionlimit(10**9)
    recurses()


def recurses_deep_in_c() -> Any:
    sys.setrecursionlimit(10**9)

    class Item:
        def __lt__(self, other: Any) -> bool:
            return bool(sorted([Item(), Item()]))

    return sorted([Item(), Item()])


def call(function: Callable[[], Any], seconds: float = 0.3) -> Call:
    with Guard(seconds) as guard:
        return guard.call(function)


def in_a_thread(function: Callable[[], Any], seconds: float = 0.3) -> Call:
    found: list[Call] = []
    thread = threading.Thread(target=lambda: found.append(call(function, seconds)))
    thread.start()
    thread.join(10)
    return found[0]


@pytest.mark.parametrize("run", [call, in_a_thread])
@pytest.mark.parametrize("function", [loops, swallows, sleeps, sleeps_and_swallows, answers_late, endless])
def test_what_never_ends_is_stopped(run: Callable[..., Call], function: Callable[[], Any]) -> None:
    started = time.monotonic()
    found = run(function, 0.1)
    assert found.error is not None and found.error.is_timeout
    assert time.monotonic() - started < 2.0


@pytest.mark.parametrize(
    "function", [stops_the_clock, stops_the_clock_itself, ignores_the_alarm, blocks_the_alarm, starts_a_timer]
)
def test_no_function_stops_the_clock(function: Callable[[], Any]) -> None:
    started = time.process_time()
    found = call(function, 0.1)
    assert found.error is not None and found.error.is_timeout
    assert time.process_time() - started < 2.0
    assert call(returns) == Call(3)


@pytest.mark.parametrize("function", [recurses_deep, recurses_deep_in_c])
def test_no_function_lets_itself_recurse_without_end(function: Callable[[], Any]) -> None:
    limit = sys.getrecursionlimit()
    found = call(function, seconds=5.0)
    assert found.error is not None and found.error.type == "RecursionError"
    assert sys.getrecursionlimit() == limit


def test_a_watchdog_that_barks_as_the_call_ends_is_a_timeout_too(monkeypatch: pytest.MonkeyPatch) -> None:
    """On a busy machine it raises in our own lines, behind those of the function."""
    timeout, late = Guard._timeout, [1]

    def interrupted(guard: Guard, traceback: Any) -> CallError:
        if late:
            late.clear()
            raise Overtime
        return timeout(guard, traceback)

    monkeypatch.setattr(Guard, "_timeout", interrupted)
    found = call(loops)
    assert not late and found.error is not None and found.error.is_timeout
    assert call(returns) == Call(3)


def test_a_function_may_recurse_a_little_deeper() -> None:
    def count(k: int) -> int:
        return 0 if k == 0 else 1 + count(k - 1)

    def deeper() -> int:
        sys.setrecursionlimit(1_900)
        return count(1_100)

    assert call(lambda: count(1_100)).error is not None
    assert call(deeper) == Call(1_100)


def spoils() -> float:
    np.cos = np.sin
    np.linalg.inv = np.linalg.pinv
    del math.sin  # type: ignore[attr-defined]
    math.pi = np.array([3, 3])  # type: ignore[misc]
    return 1.0


def spoils_and_raises() -> None:
    spoils()
    raise ValueError


def spoils_and_yields() -> Any:
    yield spoils()
    yield 2.0


def spoils_in_a_thread() -> None:
    thread = threading.Thread(target=spoils)
    thread.start()
    thread.join()


def spoils_and_loops() -> None:
    spoils()
    loops()


def spoils_later() -> None:
    def later() -> None:
        while True:
            time.sleep(0.001)
            np.cos = np.sin

    threading.Thread(target=later, daemon=True).start()
    time.sleep(0.01)


@pytest.mark.filterwarnings("ignore::pytest.PytestUnhandledThreadExceptionWarning")  # a thread that goes on is ended
@pytest.mark.parametrize(
    "function", [spoils, spoils_and_raises, spoils_and_yields, spoils_in_a_thread, spoils_and_loops, spoils_later]
)
def test_modules_are_put_back_whatever_happens(function: Callable[[], Any]) -> None:
    before = np.cos, np.linalg.inv, math.sin, math.pi, threading.active_count()
    call(function)
    until = time.monotonic() + 10.0  # a thread that is told to end does when its turn comes
    while threading.active_count() > before[-1] and time.monotonic() < until:
        time.sleep(0.01)
    assert (np.cos, np.linalg.inv, math.sin, math.pi, threading.active_count()) == before


def test_between_calls_modules_are_as_they_were() -> None:
    before = np.cos
    with Guard(1.0) as guard:
        seen = guard.call(lambda: (setattr(np, "cos", np.sin), np.cos is before)[1])
        assert seen == Call(False) and np.cos is before


@pytest.mark.parametrize("run", [call, in_a_thread])
def test_what_ends_in_time_is_returned(run: Callable[..., Call]) -> None:
    assert run(returns) == Call(3)
    assert run(lambda: (k * k for k in range(3))) == Call([0, 1, 4])


def test_the_calls_of_a_guard_share_its_time() -> None:
    with Guard(0.2) as guard:
        assert guard.call(loops).error is not None
        late = guard.call(returns)
    assert late.error is not None and late.error.is_timeout


@pytest.mark.parametrize(
    ("function", "type_", "source"),
    [
        (divides, "ZeroDivisionError", "return 1 / int"),
        (recurses, "RecursionError", "recurses()"),
        (leaves, "SystemExit", "sys.exit(1)"),
        (asks, "EOFError", "return input"),
        (lambda: np.linalg.inv(np.zeros((2, 2))), "LinAlgError", "np.linalg.inv"),
    ],
)
def test_what_is_raised_is_told_with_the_line_of_the_user(function: Any, type_: str, source: str) -> None:
    error = call(function).error
    assert error is not None
    assert error.type == type_ and error.file == HERE and source in error.source and error.line > 0


def test_an_interrupt_passes_through() -> None:
    def interrupted() -> None:
        raise KeyboardInterrupt

    before = sys.stdout
    with pytest.raises(KeyboardInterrupt):
        call(interrupted)
    assert sys.stdout is before


def test_what_is_printed_is_kept_up_to_a_bound(capsys: pytest.CaptureFixture[str]) -> None:
    def prints() -> None:
        print("theta", 1)
        print("an error", file=sys.stderr)
        print("x" * 50_000)

    with Guard(1.0) as guard:
        guard.call(prints)
    assert guard.printed.startswith("theta 1\nan error\n") and len(guard.printed) == 10_000
    assert capsys.readouterr() == ("", "")


def disturbs() -> None:
    np.random.seed(1)  # noqa: NPY002
    np.random.rand()  # noqa: NPY002
    random.seed(1)
    np.seterr(all="raise")
    np.set_printoptions(precision=1)
    sys.setrecursionlimit(5000)
    warnings.simplefilter("error")
    warnings.warn("of the user", stacklevel=1)


def test_the_state_of_the_program_is_what_it_was() -> None:
    def state() -> list[Any]:
        numpy_state = np.random.get_state()[1].tolist()  # noqa: NPY002
        return [numpy_state, random.getstate(), np.geterr(), np.get_printoptions(), sys.getrecursionlimit(),
                list(warnings.filters), sys.stdout, sys.stdin, sys.gettrace(), signal.getsignal(signal.SIGALRM)]  # fmt: skip

    before = state()
    call(disturbs)
    call(swallows)
    assert state() == before


def test_an_alarm_that_was_set_still_rings() -> None:
    rung: list[int] = []
    handler = signal.signal(signal.SIGALRM, lambda *_: rung.append(1))
    try:
        signal.setitimer(signal.ITIMER_REAL, 60.0)
        call(loops, seconds=0.1)
        left, _ = signal.getitimer(signal.ITIMER_REAL)
        assert not rung and 0.0 < left < 60.0
        signal.setitimer(signal.ITIMER_REAL, 0.01)
        until = time.monotonic() + 10.0
        while not rung and time.monotonic() < until:
            time.sleep(0.01)
        assert rung == [1]
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, handler)


def test_a_profiler_goes_on_after_a_call() -> None:
    program = (
        "import sys, faulthandler; faulthandler.dump_traceback_later(60, exit=True)\n"
        "from armproof.verification.functions.guarded_call import Guard\n"
        "with Guard(1.0) as guard: guard.call(lambda: 1)\n"
        "sys.setprofile(lambda *_: None); (lambda: 1)(); sys.setprofile(None); print('done')"
    )
    ended = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=False)
    assert ended.stdout == "done\n", ended.stderr
