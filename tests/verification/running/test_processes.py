"""Work shared out to processes: the results in order, whatever becomes of a process."""

from __future__ import annotations

import os
import time

import pytest

from armproof.verification.running import processes
from armproof.verification.running.processes import share_out, usual_workers


def square(number: int) -> int:
    """Return a square; a negative number ends the process, as Drake does on some models."""
    if number < 0:
        os._exit(6)
    time.sleep(0.002 * (number % 3))
    return number * number


def ended(number: int) -> int:
    return -1


@pytest.mark.parametrize(
    ("tasks", "ahead"),
    [
        ([*range(12)], 1),
        ([-1, 1, 2], 16),
        ([3, -1, 4, -2, *range(8)], 1),
        ([3, -1, 4, -2, *range(8)], 16),
        ([-1] * 3, 16),
        ([], 1),
    ],
)
def test_each_task_has_its_own_result_in_its_place(
    tasks: list[int], ahead: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(processes, "AHEAD", ahead)
    found = list(share_out(square, tasks, 2, ended, weight=lambda number: -number))
    assert found == [-1 if number < 0 else number * number for number in tasks]


def test_one_worker_works_in_this_process() -> None:
    assert list(share_out(lambda _: os.getpid(), [1, 2], 1, ended)) == [os.getpid()] * 2
    assert os.getpid() not in share_out(_pid, [1, 2], 2, ended)


def _pid(_: int) -> int:
    return os.getpid()


def test_where_drake_is_imported_nothing_is_shared_out(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(processes, "cores", lambda: 64)
    monkeypatch.setitem(processes.sys.modules, "pydrake", processes)
    assert usual_workers() == 1
    monkeypatch.delitem(processes.sys.modules, "pydrake")
    assert usual_workers() == processes.MOST_WORKERS
