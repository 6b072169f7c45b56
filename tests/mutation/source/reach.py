"""Which tests reach a line: recorded by coverage once, so that a mutant meets no test that cannot see it.

The record is a help and no more: where there is none, or the file is newer, every test of a selection runs.
"""

from __future__ import annotations

import ast
import os
import subprocess
import sys
from collections import Counter
from collections.abc import Set

import pytest
from coverage import CoverageData

from tests.mutation.source.trusted import ROOT

RECORD = ROOT / "build" / "reach.coverage"
RECORDED = ("tests/models", "tests/verification", "tests/labelled", "course/handouts")


def record() -> int:
    """Run the tests once and keep which of them reach each line; return the exit code.

    A test that fails is no failure of the record: under a tracer, time limits and guards are not what they are.
    """
    RECORD.parent.mkdir(exist_ok=True)
    rooms = [f"--cov={room}" for room in ("models", "verification")]
    command = [
        sys.executable,
        "-m",
        "pytest",
        "-q",
        "-n",
        "auto",
        *rooms,
        "--cov-context=test",
        "--cov-report=",
        *RECORDED,
    ]
    code = subprocess.run(command, cwd=ROOT, env={**os.environ, "COVERAGE_FILE": str(RECORD)}).returncode
    return 0 if code == pytest.ExitCode.TESTS_FAILED else code


def reaching(file: str, line: int) -> Set[str] | None:
    """Return the tests that reach the function round a line; None where that is not known, or it runs at import."""
    path = ROOT / file
    inside = _lines_of_function(path.read_text("utf-8"), line)
    if not inside or not RECORD.exists() or RECORD.stat().st_mtime < path.stat().st_mtime:
        return None
    data = CoverageData(str(RECORD))
    data.read()
    tests = data.contexts_by_lineno(str(path))
    met = tests.get(line) or [test for each in inside for test in tests.get(each, ())]
    return {test.rpartition("|")[0] for test in met} - {""}


def _lines_of_function(source: str, line: int) -> range:
    """Return the lines of the innermost function round a line; none at the level of the module, which runs once, at import."""
    bodies = [
        range(node.body[0].lineno, (node.end_lineno or node.lineno) + 1)
        for node in ast.walk(ast.parse(source))
        if isinstance(node, ast.FunctionDef)
    ]
    return min((body for body in bodies if line in body), key=len, default=range(0))


def files_of(tests: Set[str]) -> list[str]:
    """Return the files of tests, those with the fewest first."""
    counts = Counter(test.partition("::")[0] for test in tests)
    return sorted(counts, key=lambda file: (counts[file], file))
