"""A mutant that is imported, not exchanged, in a process of its own: `python -m tests.mutation.source.run FILE INDEX SECONDS PIPE [TEST…]`.

The file on the disk stays as it is: the importer hands out the changed tree. What becomes of it is told into the pipe; the
tests that are named are left out.
"""

from __future__ import annotations

import importlib
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import pytest

from tests.mutation.source.copies import tell
from tests.mutation.source.fates import KILLED, run
from tests.mutation.source.imports import Finder
from tests.mutation.source.mutants import Mutant, mutants_of, mutate
from tests.mutation.source.reach import QUIETLY, TESTS
from tests.mutation.source.trials import drawn_up
from tests.mutation.source.trusted import ROOT


@dataclass
class Run:
    """A plugin of pytest that runs what a mutant meets, in its order, and tells."""

    file: str
    mutant: Mutant
    seconds: int
    pipe: int
    unsound: Sequence[str]

    def pytest_runtestloop(self, session: pytest.Session) -> bool:
        if session.testsfailed:  # not all could be collected
            tell(self.pipe, KILLED)
        else:
            items = {item.nodeid: item for item in session.items}
            run(drawn_up(self.file, self.mutant, items, self.unsound), self.seconds, self.pipe)
        return True


def main(arguments: Sequence[str]) -> None:
    """Collect the tests with the mutant in place, and run those that it meets."""
    file, index, seconds, pipe, *unsound = arguments
    mutant = mutants_of((ROOT / file).read_text("utf-8"))[int(index)]
    name = ".".join(("armproof", *Path(file).with_suffix("").parts))
    assert name not in sys.modules, "a mutant that comes too late would be taken for killed, or for a survivor"
    try:
        put_in_place(file, mutant.index, name)
    except Exception:
        return tell(int(pipe), KILLED)
    pytest.main([*QUIETLY, *TESTS], plugins=[Run(file, mutant, int(seconds), int(pipe), unsound)])


def put_in_place(file: str, index: int, name: str) -> None:
    """Import the mutant of a file at once: pytest has an importer of its own, before ours."""
    code = compile(mutate((ROOT / file).read_text("utf-8"), index), ROOT / file, "exec")
    sys.meta_path.insert(0, Finder({(ROOT / file).resolve(): code}))
    importlib.import_module(name)


if __name__ == "__main__":
    main(sys.argv[1:])
