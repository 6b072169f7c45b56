"""Numbers of one's own: a seed, a name or a number, gives each student other lengths, and a teacher the same again."""

from __future__ import annotations

import hashlib
from collections.abc import Callable
from dataclasses import replace
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from armproof.course.feedback.task import Task

_STEP = 0.005  # m


def drawn(make: Callable[..., Task], **ranges: tuple[float, float]) -> Callable[[str], Task]:
    """Return what makes the task of a seed: each number lies in its range (m), and is the same in all tasks of a lesson."""

    def own(seed: str) -> Task:
        numbers = {name: _draw(f"{seed}/{make.__module__}/{name}", *ends) for name, ends in ranges.items()}
        return replace(make(**numbers), numbers=numbers)

    return own


def _draw(key: str, low: float, high: float) -> float:
    """Return a number in steps of 5 mm: a hash, which every version of Python and every machine computes alike."""
    steps = round((high - low) / _STEP) + 1
    chosen = int.from_bytes(hashlib.sha256(key.encode()).digest()[:8], "big") % steps
    return round(low + chosen * _STEP, 3)
