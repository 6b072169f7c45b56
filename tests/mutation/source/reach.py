"""Which tests reach a line: recorded by coverage once, so that a mutant meets no test that cannot see it.

The record is a help and no more: where there is none, or the file is newer, every test of a selection runs.
"""

from __future__ import annotations

import ast
import json
import os
import subprocess
import sys
from collections.abc import Set

import pytest
from coverage import CoverageData

from tests.mutation.source.trusted import ROOT

RECORD = ROOT / "build" / "reach.coverage"
SECONDS = ROOT / "build" / "reach.json"
TESTS = ("tests/models", "tests/verification", "course/handouts")  # and all that is labelled
LABELLED = "tests/labelled/displays"  # where the names of those begin
DERIVED = "derived "  # and behind it, those of documents that are made of others
OPTIONS = "-q -p no:cacheprovider -p tests.mutation.source.labels".split()
# pages in a browser, clusters and what watches files decide nothing, and each copy of a process would begin them anew
OPTIONS += [f"--ignore=tests/verification/{room}" for room in ("report", "running")]
QUIETLY = [*OPTIONS, *"-s -p no:xdist -p no:cov".split()]  # -s: copies would share the file that takes what is printed
RECORDING = "-p tests.mutation.source.reach --cov=models --cov=verification --cov-context=test --cov-report=".split()


def record(jobs: int) -> int:
    """Run the tests once, keep which of them reach each line and how long each takes; return the exit code.

    A test that fails is no failure of the record: under a tracer, time limits and guards are not what they are.
    """
    RECORD.parent.mkdir(exist_ok=True)
    command = [sys.executable, "-m", "pytest", *OPTIONS, *RECORDING, "-n", str(jobs), *TESTS]
    code = subprocess.run(command, cwd=ROOT, env={**os.environ, "COVERAGE_FILE": str(RECORD)}).returncode
    return 0 if code == pytest.ExitCode.TESTS_FAILED else code


TOOK: dict[str, float] = {}


def pytest_runtest_logreport(report: pytest.TestReport) -> None:
    TOOK[report.nodeid] = TOOK.get(report.nodeid, 0) + report.duration


def pytest_sessionfinish(session: pytest.Session) -> None:
    if not hasattr(session.config, "workerinput"):
        SECONDS.write_text(json.dumps(TOOK), "utf-8")


def reaching(file: str, line: int) -> Set[str] | None:
    """Return the tests that reach the function round a line, of a line that runs at import its file; None where that is not known."""
    path = ROOT / file
    if not RECORD.exists() or RECORD.stat().st_mtime < path.stat().st_mtime:
        return None
    data = CoverageData(str(RECORD))
    data.read()
    tests = {
        at: {test.rpartition("|")[0] for test in met} - {""} for at, met in data.contexts_by_lineno(str(path)).items()
    }
    inside = _lines_of_function(path.read_text("utf-8"), line)
    met = {test for at in inside or tests for test in tests.get(at, ())}
    return (tests.get(line) or met) if inside else met or None


def seconds() -> dict[str, float]:
    """Return how long each test on record took."""
    return json.loads(SECONDS.read_text("utf-8")) if SECONDS.exists() else {}


def _lines_of_function(source: str, line: int) -> range:
    """Return the lines of the innermost function round a line; none for what runs once, at import."""
    bodies = [
        range(node.body[0].lineno, (node.end_lineno or node.lineno) + 1)
        for node in ast.walk(ast.parse(source))
        if isinstance(node, ast.FunctionDef)
    ]
    return min((body for body in bodies if line in body), key=len, default=range(0))
