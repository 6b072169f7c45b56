"""What the check of a lesson found, and how it is printed: a table row by row, then what is wrong; or JSON."""

from __future__ import annotations

import json
import sys
import time
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from statistics import median
from typing import Any

from armproof.models.errors import counted
from armproof.models.language import look_up, noted
from armproof.verification.cli.documents import Progress
from armproof.verification.report.text import Line, write_lines

SECONDS_ALLOWED = 5.0  # for a solved lesson, from the start of its kernel
HEAD = (
    noted("lesson"), noted("tasks"), noted("answers"), noted("equations"), noted("solved"), noted("student"), noted("check"), "",
)  # fmt: skip
_ORDER = ("proved", "confirmed", "defined", "refuted", "unchecked", "unreadable")


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


def write_text(reports: Iterable[Report], sources: Sequence[Path]) -> list[Report]:
    """Write each report as soon as it is there; return them all."""
    started = time.perf_counter()
    write_lines([head(sources)])
    found: list[Report] = []
    with Progress(len(sources), "lessons") as progress:
        for report in reports:
            progress.clear()
            write_lines([row(report, sources)])
            sys.stdout.flush()
            progress.advance()
            found.append(report)
    problems = [problem for report in found for problem in report.problems]
    if problems:
        write_lines([(("", ""),), *(((relative(problem), ""),) for problem in problems)])
    passing = sum(report.passes for report in found)
    seconds = time.perf_counter() - started
    told = (
        counted("{number} lesson", "{number} lessons", len(found)),
        counted("{number} passes", "{number} pass", passing),
    )
    write_lines([(("", ""),), ((look_up("; ").join((", ".join(told), f"{seconds:.0f} s")), ""),)])
    return found


def write_json(reports: Iterable[Report], sources: Sequence[Path]) -> list[Report]:
    """Write one JSON object when all are there; return the reports."""
    found = list(reports)
    text = json.dumps({"lessons": [report.as_json() for report in found]}, indent=1, ensure_ascii=False)
    sys.stdout.write(text + "\n")
    return found


def rows(cells: Sequence[Sequence[str]]) -> Iterator[Line]:
    """Yield the lines of a table, its columns as wide as their widest cell."""
    widths = [max(map(len, column)) for column in zip(*cells, strict=True)]
    for row in cells:
        yield ((("  ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True))).rstrip(), ""),)


def head(sources: Sequence[Path]) -> Line:
    """Return the head of the table of reports, which is written row by row."""
    return ((_line(tuple(map(look_up, HEAD)), sources), "bold"),)


def row(report: Report, sources: Sequence[Path]) -> Line:
    """Return the row of a report."""
    verdict = look_up("passes") if report.passes else look_up("does not pass")
    verdict = look_up("cannot be checked") if report.cannot_run else verdict
    verdict += look_up(", slow") if report.is_slow else ""
    counts = [counted(f"{{number}} {name}", f"{{number}} {name}", report.verdicts[name]) for name in _ORDER if name in report.verdicts]  # fmt: skip
    cells = (
        report.source.stem,
        str(report.tasks),
        f"{report.right} + {report.wrong}",
        ", ".join(counts) or look_up("none"),
        _seconds(report.seconds),
        _seconds(report.student_seconds),
        "" if report.median_check is None else f"{1000 * report.median_check:.0f} ms",
        verdict,
    )
    return ((_line(cells, sources), "green" if report.passes else "red"),)


def _line(cells: Sequence[str], sources: Sequence[Path]) -> str:
    least = (max((len(source.stem) for source in sources), default=6), 5, 9, 34, 6, 7, 6, 0)
    widths = (max(width, len(look_up(name))) for width, name in zip(least, HEAD, strict=True))
    return "  ".join(cell.ljust(width) for cell, width in zip(cells, widths, strict=True)).rstrip()


def _seconds(value: float | None) -> str:
    return "" if value is None else f"{value:.1f} s"


def relative(text: str) -> str:
    """Return a message with paths below the working folder as they are from there."""
    return text.replace(f"{Path.cwd()}/", "")
