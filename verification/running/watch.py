"""Watch documents: each is checked again when it is saved, and the verdicts of what changed are told at once.

Files are looked at fifty times a second, by the time, the size and the number that the system gives them: no library, and
editors that save under another name and rename are no different. A file is read when it has stayed as it is for one look.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path

from armproof.models.errors import ArmproofError
from armproof.verification.document import read_document
from armproof.verification.findings import Kind, say
from armproof.verification.running.incremental import IncrementalChecker
from armproof.verification.verdict import DocumentResult, Failure, Record

INTERVAL = 0.02  # seconds between two looks
LONG_INTERVAL = 0.1  # where there are more documents than
FEW = 100
FOLDERS = 1.0  # seconds between two looks for new documents
GONE = 0.5  # seconds after which a file that is not there has not just been saved
MOST_CHECKERS = 40  # documents whose checkers are kept: the others are checked as a whole

Signature = tuple[int, int, int]


@dataclass(frozen=True)
class Told:
    """The verdict of a display that was checked again, and the seconds since its document was seen to have changed."""

    path: Path
    record: Record
    seconds: float


@dataclass(frozen=True)
class Settled:
    """A document as a whole, after it was checked again."""

    path: Path
    result: DocumentResult | Failure


@dataclass(frozen=True)
class Gone:
    """A document that is not there any more."""

    path: Path


Event = Told | Settled | Gone


class Watched:
    """One document: what was last seen of its file, and its verdicts."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self.result: DocumentResult | Failure | None = None
        self.checker: IncrementalChecker | None = None
        self._read: Signature | None = None
        self._seen: Signature | None = None
        self._gone_since: float | None = None
        self._told_gone = False

    def look(self, now: float) -> Event | bool:
        """Return whether the file is to be read: it changed, and stays as it is. That it is gone is told once."""
        signature = _signature(self.path)
        if signature is None:
            self._gone_since = self._gone_since or now
            if self._told_gone or now - self._gone_since < GONE:
                return False
            self._told_gone, self._read = True, None
            return Gone(self.path)
        self._gone_since, self._told_gone = None, False
        settled = signature == self._seen
        self._seen = signature
        return settled and signature != self._read

    def check(self) -> Iterator[Event]:
        """Yield the verdict of each display that is checked again, then that of the document."""
        started = time.monotonic()
        self._read = self._seen = _signature(self.path)
        self.checker = self.checker or IncrementalChecker(self.path)
        try:
            for record in self.checker.update(read_document(self.path)):
                yield Told(self.path, record, time.monotonic() - started)
            assert self.checker.result is not None
            self.result = self.checker.result
        except ArmproofError as problem:
            self.result, self.checker = Failure.of(self.path, problem), None
        yield Settled(self.path, self.result)


class Watch:
    """The documents that are watched; `find` names them, and those that are new."""

    def __init__(self, find: Callable[[], Iterable[Path]], sleep: Callable[[float], None] = time.sleep) -> None:
        self._find = find
        self._sleep = sleep
        self._documents: dict[Path, Watched] = {}
        self._recent: list[Watched] = []

    @property
    def results(self) -> list[DocumentResult | Failure]:
        """The results of all documents."""
        return [each.result for each in self._documents.values() if each.result is not None]

    def begin(self) -> Iterator[Event]:
        """Yield the results of all documents."""
        for path in self._find():
            watched = self._documents[path] = Watched(path)
            yield from (event for event in self._check(watched) if isinstance(event, Settled))

    def events(self) -> Iterator[Event]:
        """Yield what happens, for ever."""
        looked_for = time.monotonic()
        while True:
            self._sleep(INTERVAL if len(self._documents) <= FEW else LONG_INTERVAL)
            now = time.monotonic()
            if now - looked_for > FOLDERS:
                looked_for = now
                for path in self._find():
                    self._documents.setdefault(path, Watched(path))
            for watched in list(self._documents.values()):
                seen = watched.look(now)
                if isinstance(seen, bool):
                    yield from self._check(watched) if seen else ()
                else:
                    watched.result = Failure(str(watched.path), say(Kind.FILE_GONE))
                    yield seen

    def _check(self, watched: Watched) -> Iterator[Event]:
        yield from watched.check()
        self._recent = [each for each in self._recent if each is not watched] + [watched]
        for forgotten in self._recent[:-MOST_CHECKERS]:
            forgotten.checker = None
        self._recent = self._recent[-MOST_CHECKERS:]


def _signature(path: Path) -> Signature | None:
    try:
        found = path.stat()
    except OSError:
        return None
    return found.st_mtime_ns, found.st_size, found.st_ino
