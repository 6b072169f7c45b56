"""Numbers of one's own: a seed, a name or a number, gives each student other lengths, and a teacher the same again."""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, TypeVar

if TYPE_CHECKING:
    from armproof.course.feedback.task import Task

_STEP = 0.005  # m
T = TypeVar("T")


def drawn(make: Callable[..., Task], **ranges: tuple[float, float]) -> Callable[[str], Task]:
    """Return what makes the task of a seed: each number lies in its range (m), and is the same in all tasks of a lesson."""

    def own(seed: str) -> Task:
        numbers = {name: _draw(f"{seed}/{make.__module__}/{name}", *ends) for name, ends in ranges.items()}
        return replace(make(**numbers), numbers=numbers, usual=make)

    return own


def picked(key: str, options: Sequence[T]) -> T:
    """Return one of several by a hash, which every version of Python and every machine computes alike."""
    return options[int.from_bytes(hashlib.sha256(key.encode()).digest()[:8], "big") % len(options)]


def _draw(key: str, low: float, high: float) -> float:
    """Return a number in steps of 5 mm."""
    steps = round((high - low) / _STEP) + 1
    return round(low + picked(key, range(steps)) * _STEP, 3)
