"""Write the reports of lessons: a table row by row, then what is wrong; or JSON."""

from __future__ import annotations

import json
import sys
import time
from collections.abc import Iterable, Sequence
from pathlib import Path

from armproof.course.authoring.checking.report import Report
from armproof.course.authoring.table import head, relative, row
from armproof.verification.cli.progress import Progress
from armproof.verification.report.lines import write_lines


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
    count = f"{len(found)} lesson{'' if len(found) == 1 else 's'}"
    write_lines([(("", ""),), ((f"{count}, {passing} pass{'es' if passing == 1 else ''}; {seconds:.0f} s", ""),)])
    return found


def write_json(reports: Iterable[Report], sources: Sequence[Path]) -> list[Report]:
    """Write one JSON object when all are there; return the reports."""
    found = list(reports)
    text = json.dumps({"lessons": [report.as_json() for report in found]}, indent=1, ensure_ascii=False)
    sys.stdout.write(text + "\n")
    return found
