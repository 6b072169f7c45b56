"""A display in its place in a document: other LaTeX is checked there, and leaves no trace."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from functools import lru_cache
from pathlib import Path

from armproof.models.catalogue import load_arm
from armproof.verification.algebra.ring import Ring
from armproof.verification.check import DocumentChecker
from armproof.verification.diagnosis.diagnosis import Diagnostician
from armproof.verification.document import Display, Document, read_document
from armproof.verification.equations.outcome import Outcome
from armproof.verification.equations.sides import Member
from armproof.verification.latex import nodes as n
from armproof.verification.verdict import Record, Verdict

SECONDS = 60.0  # for what no display may take as long as
HANDOUTS = Path(__file__).resolve().parents[2] / "course" / "handouts"


def handouts() -> list[Path]:
    """Return the course's documents that hold displays."""
    return [path for path in sorted(HANDOUTS.glob("*.md")) if "$$" in path.read_text(encoding="utf-8")]


@lru_cache(maxsize=64)
def load(path: Path) -> Document:
    """Return a document as read."""
    return read_document(path)


@dataclass
class Place:
    """A display and its verdict, and a checker that has read everything before it."""

    document: Document
    index: int
    record: Record
    checker: DocumentChecker

    @property
    def display(self) -> Display:
        """The display that stands here."""
        return self.document.displays[self.index]

    @property
    def where(self) -> str:
        """`file:line` of the display."""
        return f"{self.document.path.name}:{self.display.line}"

    def read(self, latex: str) -> list[n.Statement]:
        """Return the statements of LaTeX that stands here."""
        return self.checker.names.reader.read(latex)

    def check(self, latex: str, *, confirm: bool = False, diagnose: bool = False) -> Record:
        """Return the record of other LaTeX in this place.

        `confirm` evaluates what is proved on the double plant as well, `diagnose` looks for what is wrong and why.
        """
        self.checker.checker.confirm = confirm
        diagnostician = self.checker.on_demand.diagnostician
        try:
            if not diagnose:
                self.checker.on_demand.diagnostician = _Silent(self.checker.checker)
            with self.altered():
                return self.checker.check_display(replace(self.display, latex=latex))
        finally:
            self.checker.checker.confirm = False
            if self.checker.on_demand.diagnostician.__class__ is _Silent:
                self.checker.on_demand.diagnostician = diagnostician

    def member(self, node: n.Node) -> Member:
        """Return the exact value of a tree that stands here, or why it has none."""
        with self.checker.ring.budget.of(SECONDS):
            return self.checker.checker.member(node)

    def outcomes(self, statements: list[n.Statement]) -> list[Outcome]:
        """Return what becomes of each equation of a display that stands here; use it within `altered`."""
        with self.checker.ring.budget.of(SECONDS):
            return self.checker.statements.check(statements, self.display.line)[0]

    @contextmanager
    def altered(self) -> Iterator[None]:
        """Let displays be checked here; what they define is forgotten afterwards, and the roots that they adjoin."""
        checker, ring = self.checker, self.checker.ring
        before = checker.names.state.copy()
        grown = _grown(ring)
        try:
            yield
        finally:
            checker.names.state.become(before)
            if _grown(ring) != grown:  # generators cannot be taken back
                self.checker = _replay(self.document, self.index)


def _grown(ring: Ring) -> tuple[int, int, dict[str, int]]:
    """What displays have adjoined to a ring: square roots, arc functions, fractions of angles."""
    return len(ring.radicals), len(ring.arcs), dict(ring.parts)


class _Silent(Diagnostician):
    """Says that something is wrong and not what: most mutants need no more."""

    def diagnose(self, record: Record, latex: str, outcomes: list[Outcome]) -> Record:
        return record


def proved_indices(path: Path) -> list[int]:
    """Return the numbers of the displays of a document that are proved and no errata."""
    records = _read_through(path)
    return [index for index, record in enumerate(records) if record.verdict is Verdict.PROVED and not record.erratum]


def proved_places(path: Path, indices: Collection[int] | None = None) -> Iterator[Place]:
    """Yield the displays of a document that are proved and no errata, in order, or only those with the numbers given."""
    document = load(path)
    records = _read_through(path)
    wanted = set(proved_indices(path) if indices is None else indices)
    checker = _new_checker(document)
    for index in range(max(wanted, default=-1) + 1):
        if index in wanted:
            place = Place(document, index, records[index], checker)
            yield place
            checker = place.checker
        checker.check_display(document.displays[index])


@lru_cache(maxsize=64)
def _read_through(path: Path) -> list[Record]:
    """Return the records of a document as `armproof verify` gives them."""
    document = load(path)
    checker = _new_checker(document)
    checker.checker.confirm = True
    return [checker.check_display(display) for display in document.displays]


def _replay(document: Document, index: int) -> DocumentChecker:
    checker = _new_checker(document)
    for display in document.displays[:index]:
        checker.check_display(display)
    return checker


def _new_checker(document: Document) -> DocumentChecker:
    spec = document.front.get("arm")
    arm = None if spec is None else load_arm(spec, document.path.parent)
    return DocumentChecker(document, arm, confirm=False)
