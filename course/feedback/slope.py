"""The slope of the course, in one table: how long each lesson takes, what comes before it, and the task that returns in it."""

from __future__ import annotations

import csv
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

SLOPE = Path(__file__).resolve().parents[1] / "slope.csv"
REVIEW = "review"  # what a task of an earlier lesson is called where it returns


@dataclass(frozen=True)
class Stage:
    """A lesson on the slope.

    Attributes:
        number: its place in the course, from 1.
        minutes: how long it takes, about.
        before: the lessons that it builds on, by name.
        review: the task of an earlier lesson that returns in it, as lesson.task; empty for none.
    """

    number: int
    minutes: int
    before: tuple[str, ...]
    review: str


@lru_cache(maxsize=1)
def stages() -> dict[str, Stage]:
    """Return the stages in the order of the course, by the names of the lessons."""
    with SLOPE.open(encoding="utf-8", newline="") as file:
        return {
            row["lesson"]: Stage(number, int(row["minutes"]), tuple(row["before"].split()), row["review"])
            for number, row in enumerate(csv.DictReader(file), 1)
        }
