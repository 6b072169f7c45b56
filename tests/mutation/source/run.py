"""One mutant against the tests that speak of its file, in a process of its own: `python -m tests.mutation.source.run FILE INDEX SECONDS`.

The file on the disk stays as it is: the importer hands out the changed tree. Exit code 0: it survived, 3: killed.
"""

from __future__ import annotations

import importlib
import importlib.abc
import importlib.machinery
import math
import os
import resource
import sys
import time
from collections.abc import Sequence, Set
from contextlib import redirect_stdout
from pathlib import Path
from random import Random
from types import CodeType

import pytest

from tests.mutation.source.mutants import mutants_of, mutate
from tests.mutation.source.reach import files_of, reaching
from tests.mutation.source.trusted import selection

SURVIVED, KILLED = 0, 3  # 1 is what Python says of a fault of this tool
UNCHANGED = -1  # the index of the file as it is
EVERY_TEST = ("tests/models", "tests/verification")  # what survives the nearest tests meets all of them
TIMES_AS_LONG = 5  # as these take


class Changed(importlib.machinery.SourceFileLoader):
    """Loads one file as its mutant."""

    code: CodeType

    def get_code(self, fullname: str) -> CodeType:
        return self.code


class Finder(importlib.abc.MetaPathFinder):
    """Finds one file as its mutant, and leaves all others to the importers behind it."""

    def __init__(self, path: Path, code: CodeType) -> None:
        self.path, self.code = path.resolve(), code
        self.asked = False

    def find_spec(self, fullname, path, target=None):
        if fullname.rpartition(".")[2] not in (self.path.stem, self.path.parent.name) or self.asked:
            return None
        self.asked = True
        try:
            spec = importlib.util.find_spec(fullname)
        finally:
            self.asked = False
        if spec is None or spec.origin is None or Path(spec.origin).resolve() != self.path:
            return None
        spec.loader = loader = Changed(fullname, spec.origin)
        loader.code = self.code
        return spec


def main(arguments: Sequence[str]) -> int:
    """Run the selection with the mutant in place; return whether it survived."""
    file, index, seconds = arguments
    allow(int(seconds))
    try:
        if int(index) != UNCHANGED:
            put_in_place(file, int(index))
        own, room, course = selection(file)
        tests = seeing(file, int(index))
        if tests is not None and (
            tests_fail(own, tests) or tests_fail(room, tests) or tests_fail(files_of(tests), tests)
        ):
            return KILLED
        allow(TIMES_AS_LONG * int(seconds))
        if tests_fail(own) or tests_fail(room) or labels_differ() or tests_fail(course):
            return KILLED
        return KILLED if tests is None and tests_fail(EVERY_TEST) else SURVIVED
    except Exception as error:
        print(f"{type(error).__name__}: {error}", file=sys.stderr)
        return KILLED


def seeing(file: str, index: int) -> Set[str] | None:
    """Return the tests that reach a mutant; None where all must run."""
    return reaching(file, mutants_of(Path(file).read_text("utf-8"))[index].line) if index != UNCHANGED else None


def allow(seconds: int) -> None:
    """End this process when it has used so many more seconds of processor time."""
    used = math.ceil(time.process_time())
    resource.setrlimit(resource.RLIMIT_CPU, (used + seconds, resource.getrlimit(resource.RLIMIT_CPU)[1]))


def put_in_place(file: str, index: int) -> None:
    """Import the mutant of a file at once: pytest has an importer of its own, before ours."""
    code = compile(mutate(Path(file).read_text("utf-8"), index), file, "exec")
    sys.meta_path.insert(0, Finder(Path(file), code))
    module = importlib.import_module(".".join(("armproof", *Path(file).with_suffix("").parts)))
    assert isinstance(module.__loader__, Changed)


def labels_differ() -> bool:
    """Whether what is said of a labelled display or page is not what is on record, or no label allows it."""
    from tests.labelled.cases import load_cases
    from tests.labelled.faults import faults_of_pages, read_not_yet
    from tests.labelled.judging import judge
    from tests.labelled.record import differences, pages_that_differ, read_record

    listed, record = read_not_yet(), read_record()
    cases = list(load_cases())
    Random(1).shuffle(cases)  # another kind of display each time: what is wrong shows early
    for case in cases:
        judged = judge(case)
        if bool(judged.fault) != (case.key in listed) or judged.fault == "error" or differences([judged], record):
            return True
    mine = {fault.key for fault in faults_of_pages()}
    return mine != set(listed) - {case.key for case in cases} or bool(pages_that_differ())


class Only:
    """Takes the tests away that cannot see a mutant."""

    def __init__(self, tests: Set[str]) -> None:
        self.tests = tests

    def pytest_collection_modifyitems(self, items: list[pytest.Item]) -> None:
        items[:] = [item for item in items if item.nodeid in self.tests]


def tests_fail(places: Sequence[str], tests: Set[str] | None = None) -> bool:
    """Whether one of the tests of these places fails; `tests` are those that count, if not all."""
    if not places:
        return False
    options = ["-x", "-q", "-p", "no:cacheprovider", "-p", "no:xdist", "-p", "no:cov"]
    with open(os.devnull, "w") as nowhere, redirect_stdout(nowhere):
        code = pytest.main([*options, *places], plugins=[] if tests is None else [Only(tests)])
    return code not in (pytest.ExitCode.OK, pytest.ExitCode.NO_TESTS_COLLECTED)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
