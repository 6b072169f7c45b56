"""What the check of a lesson found."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from statistics import median
from typing import Any

SECONDS_ALLOWED = 5.0  # for a solved lesson, from the start of its kernel


@dataclass(frozen=True)
class Report:
    """The check of one lesson.

    Attributes:
        source: its file.
        problems: what is wrong, each as "file:line: message".
        cannot_run: whether the source is no lesson, so that nothing else was looked at.
        tasks, right, wrong: how many tasks, and right and wrong answers to them, were tried.
        verdicts: of its equations, how many of each.
        seconds, student_seconds: the solved lesson's and the student's notebook's time in a kernel.
        check_seconds: of each call of `check` in the solved lesson, the first left out.
    """

    source: Path
    problems: tuple[str, ...] = ()
    cannot_run: bool = False
    tasks: int = 0
    right: int = 0
    wrong: int = 0
    verdicts: Mapping[str, int] = field(default_factory=dict)
    seconds: float | None = None
    student_seconds: float | None = None
    check_seconds: tuple[float, ...] = ()

    @property
    def passes(self) -> bool:
        """Whether nothing is wrong."""
        return not self.problems

    @property
    def median_check(self) -> float | None:
        """The median time of a check in seconds."""
        return median(self.check_seconds) if self.check_seconds else None

    @property
    def is_slow(self) -> bool:
        """Whether the solved lesson takes longer than it should."""
        return self.seconds is not None and self.seconds > SECONDS_ALLOWED

    def as_json(self) -> dict[str, Any]:
        """Return the report as JSON writes it."""
        return {
            "lesson": self.source.stem,
            "passes": self.passes,
            "problems": list(self.problems),
            "tasks": self.tasks,
            "right": self.right,
            "wrong": self.wrong,
            "equations": dict(self.verdicts),
            "seconds": self.seconds,
            "student_seconds": self.student_seconds,
            "median_check_seconds": self.median_check,
        }
