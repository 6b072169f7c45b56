"""A mutant is tried in a copy of this process: what is exchanged, what must be imported, and what is told of it."""

from __future__ import annotations

import os
import signal
import sys
import time
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path
from types import ModuleType, SimpleNamespace

import pytest

from tests.mutation.source import exchange, trials
from tests.mutation.source.copies import allow, in_a_copy, tell
from tests.mutation.source.exchange import Loaded, NotExchangeableError
from tests.mutation.source.fates import KILLED, SURVIVED, TIMEOUT, Fate, read_fate
from tests.mutation.source.mutants import Mutant, mutants_of
from tests.mutation.source.order import in_order
from tests.mutation.source.reach import LABELLED
from tests.mutation.source.run import put_in_place
from tests.mutation.source.trials import Trials

SOURCE = """
from dataclasses import dataclass
from functools import cache
LIMIT = 3
@dataclass
class Arm:
    joints: int = 6
    @property
    def free(self, locked=1): return self.joints - locked
@cache
def twice(x):
    return [y * 2 for y in (x,)][0]
def made_at_import(x): return x + 5
FIVE = made_at_import(0)
def unused(x): return x and 7
"""


def worth(module: ModuleType) -> tuple[int, int]:
    return module.Arm(6).free, module.twice(2)


@pytest.fixture
def imported(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    """The file, as it was imported."""
    file = tmp_path / "a.py"
    file.write_text(SOURCE, "utf-8")
    monkeypatch.setattr(exchange, "ROOT", tmp_path)
    spec = spec_from_file_location("a", file)
    monkeypatch.setitem(sys.modules, "a", module := module_from_spec(spec))
    spec.loader.exec_module(module)
    return module


def loaded(module: ModuleType) -> Loaded:
    functions = [module.Arm.free.fget, module.twice.__wrapped__, module.made_at_import]
    ran = {exchange._place(module.made_at_import.__code__)}
    return Loaded({module.__file__: functions}, frozenset(ran))


def mutant(words: str, line: int) -> Mutant:
    return next(each for each in mutants_of(SOURCE) if each.words == words and each.line == line)


@pytest.mark.parametrize(
    ("words", "line", "value"), [("Sub → Add", 9, (7, 4)), ("Mult → Add", 12, (5, 4)), ("2 → 3", 12, (5, 6))]
)
def test_a_function_has_the_code_of_its_mutant(imported, words: str, line: int, value: tuple[int, int]):
    assert worth(imported) == (5, 4)
    imported.twice.cache_clear()
    loaded(imported).exchange("a.py", mutant(words, line).index)
    assert worth(imported) == value


@pytest.mark.parametrize(
    ("words", "line"),
    [("3 → 4", 4), ("6 → 7", 7), ("1 → 2", 9), ("Add → Sub", 13), ("0 → 1", 14), ("And → Or", 15)],
    ids=[
        "a constant",
        "a field",
        "a default",
        "a function that ran at import",
        "its argument",
        "a function that is gone",
    ],
)
def test_what_was_made_at_import_cannot_be_exchanged(imported, words: str, line: int):
    with pytest.raises(NotExchangeableError):
        loaded(imported).exchange("a.py", mutant(words, line).index)
    assert worth(imported) == (5, 4)


def test_such_a_mutant_is_put_in_place_before_its_file_is_imported():
    def work(pipe: int) -> None:
        name, file = "armproof.verification.algebra.protocol", "verification/algebra/protocol.py"
        sys.modules.pop(name, None)
        found = mutants_of((exchange.ROOT / file).read_text("utf-8"))
        put_in_place(file, found[0].index, name)
        tell(pipe, type(sys.modules[name].__loader__).__name__)

    assert in_a_copy(work, 10) == (["Changed"], 0)


def test_a_copy_tells_and_how_it_ends():
    here = os.getpid()

    def work(pipe: int) -> None:
        tell(pipe, "first\nsecond")
        os.kill(os.getpid(), signal.SIGXCPU)

    assert in_a_copy(work, 10) == (["first", "second"], -signal.SIGXCPU)
    assert in_a_copy(lambda pipe: allow(1), 10) == ([], 0) and os.getpid() == here
    with pytest.raises(RuntimeError, match="ZeroDivisionError"):
        in_a_copy(lambda pipe: tell(pipe, str(1 // 0)), 10)


def test_a_copy_that_tells_nothing_is_ended(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr("tests.mutation.source.copies.PATIENT", 1)
    assert in_a_copy(lambda pipe: time.sleep(60), 0.01) == ([], -signal.SIGKILL)


@pytest.mark.parametrize(
    ("told", "code", "fate"),
    [
        (["test_a", "test_b", KILLED], 0, (KILLED, "test_b")),
        (["test_a", SURVIVED], 0, (SURVIVED, "")),
        (["test_a"], -signal.SIGXCPU, (TIMEOUT, "test_a")),
        (["test_a"], -signal.SIGSEGV, (KILLED, "test_a")),
        ([KILLED], 0, (KILLED, "")),
        ([], 0, (KILLED, "")),
    ],
)
def test_the_end_of_a_process_is_a_fate(told: list[str], code: int, fate: tuple[str, str]):
    assert read_fate(told, code) == fate


def test_quick_tests_of_its_own_come_first_then_labelled_displays_then_the_quickest_files():
    took = {"test_a.py::slow": 9, "test_b.py::x": 5, "test_c.py::x": 1, "test_c.py::y": 2}
    collected = [
        "test_a.py::quick",
        "test_b.py::x",
        "test_c.py::y",
        "test_a.py::slow",
        "test_c.py::x",
        f"{LABELLED}::1",
    ]
    tests = in_order(collected, {"test_a.py"}, took, collected)
    assert tests == [collected[k] for k in (0, 5, 2, 4, 1, 3)]


class Check:
    """A test that passes where a function has the value that it should have; one that is unsound passes nowhere."""

    def __init__(self, nodeid: str, passes) -> None:
        self.nodeid, self.passes = nodeid, passes


@pytest.fixture
def try_mutant(imported, monkeypatch: pytest.MonkeyPatch):
    """Try a mutant of the file against what is said of it, in a copy as ever."""
    report = lambda item, **_: [SimpleNamespace(failed=not item.passes())]  # noqa: E731
    monkeypatch.setattr("tests.mutation.source.fates.runtestprotocol", report)

    def tried(words: str, line: int, *tests: Check) -> Fate | None:
        items = {test.nodeid: test for test in tests}
        monkeypatch.setattr(trials, "tests_of", lambda file, mutant, items: list(items))
        tool = Trials(loaded(imported), (), 9, 1, time.monotonic() + 9, print, items=items)
        monkeypatch.setattr(tool, "_imported", lambda file, mutant, pipe: tell(pipe, SURVIVED))
        return tool.fate_of("a.py", mutant(words, line))

    return tried


def test_a_mutant_is_killed_by_the_first_test_that_fails_with_it_and_not_without(imported, try_mutant):
    never = Check("never passes", lambda: False)
    six = Check("joints", lambda: imported.Arm(6).joints == 6)
    five = Check("free", lambda: imported.Arm(6).free == 5)
    assert try_mutant("Sub → Add", 9, six, never, five) == Fate("a.py", mutant("Sub → Add", 9), KILLED, "free")


def test_a_mutant_that_nothing_can_kill_survives(imported, try_mutant):
    assert try_mutant("Sub → Add", 9, Check("truth", lambda: True)) == Fate("a.py", mutant("Sub → Add", 9), SURVIVED)
    assert worth(imported) == (5, 4)  # the change is gone with the copy


def test_what_cannot_be_exchanged_is_imported_and_said_to_be(try_mutant):
    fate = try_mutant("3 → 4", 4, Check("never asked", lambda: False))
    assert fate == Fate("a.py", mutant("3 → 4", 4), SURVIVED, imported=True)


def test_a_test_that_takes_forever_is_ended(imported, try_mutant):
    def endless() -> bool:
        if imported.Arm(6).free == 7:
            os.kill(os.getpid(), signal.SIGXCPU)
        return True

    assert try_mutant("Sub → Add", 9, Check("endless", endless)).fate == TIMEOUT


def test_a_copy_is_what_a_process_that_imports_would_be():
    """The modules of the tool load nothing of what they change: a mutant that is imported would come too late."""
    code = "import sys, tests.mutation.source.run; print(any(name.startswith('armproof.') for name in sys.modules))"
    told, _ = in_a_copy(lambda pipe: os.dup2(pipe, 1) and os.execv(sys.executable, [sys.executable, "-c", code]), 10)
    assert told == ["False"]
