"""A plugin of pytest that runs no test itself: each mutant is tried in a copy of the process that has collected them all."""

from __future__ import annotations

import gc
import os
import sys
import time
from collections.abc import Callable, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, field
from multiprocessing import get_context

import pytest

from tests.mutation.source.copies import allow, in_a_copy, tell
from tests.mutation.source.exchange import Loaded, NotExchangeableError, forget
from tests.mutation.source.fates import SURVIVED, Fate, read_fate, run
from tests.mutation.source.mutants import Mutant
from tests.mutation.source.order import tests_of
from tests.mutation.source.trusted import ROOT

IDLE = 5  # so many times its processor time, a test waits for what never comes
NO_EXCHANGE = "not exchangeable"
Way = Callable[[str, Mutant, int], None]


@dataclass
class Trials:
    """The mutants that are drawn, and the tests that were collected."""

    loaded: Loaded
    drawn: Sequence[tuple[str, Mutant]]
    seconds: int
    jobs: int
    until: float
    said: Callable[[Fate], object]
    fates: list[Fate] = field(default_factory=list)
    items: dict[str, pytest.Item] = field(default_factory=dict)
    sound: dict[str, bool] = field(default_factory=dict)

    def pytest_runtestloop(self, session: pytest.Session) -> bool:
        self.items = {item.nodeid: item for item in session.items}
        forget()
        gc.freeze()
        with ProcessPoolExecutor(self.jobs, get_context("fork"), _HERE.append, (self,)) as pool:
            for fate in pool.map(_fate_of, self.drawn):
                if fate is not None:
                    self.said(fate)
                    self.fates.append(fate)
        return True

    def fate_of(self, file: str, mutant: Mutant) -> Fate | None:
        """Try a mutant with its code exchanged, or imported where that cannot be."""
        return self._tried(file, mutant, self._exchanged) or self._tried(file, mutant, self._imported)

    def _tried(self, file: str, mutant: Mutant, way: Way) -> Fate | None:
        """Return the fate of a mutant; a test that fails without it, too, kills none and is left out."""
        while True:
            told, code = in_a_copy(lambda pipe: way(file, mutant, pipe), IDLE * self.seconds)
            if NO_EXCHANGE in told:
                return None
            fate, by = read_fate(told, code)
            if by not in self.items or self._is_sound(by):
                return Fate(file, mutant, fate, by, way == self._imported)

    def _is_sound(self, test: str) -> bool:
        """Whether a test passes with the code as it is."""
        if test not in self.sound:
            told, _ = in_a_copy(lambda pipe: run([self.items[test]], self.seconds, pipe), IDLE * self.seconds)
            self.sound[test] = told[-1] == SURVIVED
        return self.sound[test]

    def _unsound(self) -> list[str]:
        return [test for test, sound in self.sound.items() if not sound]

    def _exchanged(self, file: str, mutant: Mutant, pipe: int) -> None:
        try:
            self.loaded.exchange(file, mutant.index)
        except NotExchangeableError:
            return tell(pipe, NO_EXCHANGE)
        run(drawn_up(file, mutant, self.items, self._unsound()), self.seconds, pipe)

    def _imported(self, file: str, mutant: Mutant, pipe: int) -> None:
        """Become a process that imports the mutant before it collects the tests."""
        arguments = [file, str(mutant.index), str(self.seconds), str(pipe), *self._unsound()]
        os.set_inheritable(pipe, True)
        os.chdir(ROOT)
        allow(self.seconds)
        environment = {**os.environ, "PYTHONDONTWRITEBYTECODE": "1"}
        os.execve(sys.executable, [sys.executable, "-m", "tests.mutation.source.run", *arguments], environment)


def drawn_up(file: str, mutant: Mutant, items: dict[str, pytest.Item], unsound: Sequence[str]) -> list[pytest.Item]:
    """Return the tests that a mutant meets, in their order."""
    return [items[test] for test in tests_of(file, mutant, items) if test not in unsound]


_HERE: list[Trials] = []  # in the copies that the mutants are shared out to


def _fate_of(drawn: tuple[str, Mutant]) -> Fate | None:
    """Return the fate of a mutant; none where the time is up."""
    return _HERE[0].fate_of(*drawn) if time.monotonic() < _HERE[0].until else None
