"""What the terminal says of a class."""

from __future__ import annotations

from collections import Counter
from pathlib import Path

from armproof.course.grading.grading import Grades
from armproof.course.grading.results import Status
from armproof.course.grading.running.protections import describe
from armproof.models.errors import written
from armproof.verification.cli.application import FAILS, PASSES, complain
from armproof.verification.report.html.site import INDEX
from armproof.verification.report.text import Line, write_lines


def summarise(grades: Grades, out: Path) -> int:
    """Say what became of a class, and which protections were not in force; returns the exit code."""
    troubled = [each for each in grades.graded if each.needs_a_look]
    lines: list[Line] = []
    for each in troubled:
        what = "; ".join(part for part in (each.reason, *each.remarks) if part)
        lines.append(((each.status.value, "" if each.status is Status.GRADED else "red"),
                      (f"  {each.submission.file}: {what}", "")))  # fmt: skip
    counts = Counter(each.status for each in grades.graded)
    total = ", ".join(f"{counts[status]} {status.value}" for status in Status if counts[status])
    number = len(grades.graded)
    lines += [((f"{number} submission{'s' * (number != 1)}: {total}", "bold"),), ((f"results: {out / INDEX}", ""),)]
    write_lines(lines)
    complain(
        written("warning: not in force on this system: a submission {text}", text=each.text)
        for each in describe(grades.held)
        if not each.held
    )
    return FAILS if troubled else PASSES
