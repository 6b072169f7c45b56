"""What becomes of a mutant, and how the process that tries it tells."""

from __future__ import annotations

import signal
from collections.abc import Sequence
from dataclasses import dataclass

import pytest
from _pytest.runner import runtestprotocol

from tests.mutation.source.copies import allow, tell
from tests.mutation.source.mutants import Mutant

KILLED, SURVIVED, TIMEOUT = "killed", "survived", "timeout"
OUT_OF_TIME = (-signal.SIGXCPU, -signal.SIGKILL)


@dataclass(frozen=True)
class Fate:
    """What became of a mutant: killed, killed by the clock, or survived."""

    file: str
    mutant: Mutant
    fate: str
    by: str = ""  # the test that it was met by last
    imported: bool = False  # in a process of its own: it could not be exchanged


def run(items: Sequence[pytest.Item], seconds: int, pipe: int) -> None:
    """Run tests until one fails, each with so much processor time; tell each that begins, and what became of the mutant."""
    for item, following in zip(items, [*items[1:], None], strict=True):
        tell(pipe, item.nodeid)
        allow(seconds)
        if any(report.failed for report in runtestprotocol(item, log=False, nextitem=following)):
            return tell(pipe, KILLED)
    tell(pipe, SURVIVED)


def read_fate(told: Sequence[str], code: int) -> tuple[str, str]:
    """Return the fate that a process told, or that its end means, and the test that ran last."""
    *before, last = ["", *told]
    if last in (SURVIVED, KILLED):
        return last, before[-1] if last == KILLED else ""
    return TIMEOUT if code in OUT_OF_TIME else KILLED, last
