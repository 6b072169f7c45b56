"""Documents without front matter: `python -m tests.labelled.bare` prints how much of them is decided, and how much of what is wrong is found."""

from __future__ import annotations

import re
import sys
import time
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

from armproof.verification.check import verify_text
from armproof.verification.verdict import DocumentResult, Record
from tests.labelled.cases import DECIDED, HERE, PASSES
from tests.labelled.pages import HEAD, MARK

DATA = re.compile(r"^~", re.MULTILINE)


@dataclass(frozen=True)
class Bare:
    """A document: its text with mistakes as «right¦wrong», and with ~ before each line that holds no claim."""

    path: Path
    marked: str

    def text(self, wrong: int = -1) -> str:
        """Return the document with one of its mistakes, or with none."""
        sides = iter(range(len(MARK.findall(self.marked))))
        return MARK.sub(lambda match: match[2] if next(sides) == wrong else match[1], DATA.sub("", self.marked))

    def verify(self, wrong: int = -1) -> DocumentResult:
        """Return our verdicts on it."""
        return verify_text(self.text(wrong), path=self.path)

    @cached_property
    def data(self) -> frozenset[int]:
        """The lines that hold no claim."""
        lines = self.marked.split("\n")
        return frozenset(number for number, line in enumerate(lines, 1) if line.startswith("~"))

    @property
    def mistakes(self) -> Iterator[tuple[int, int, tuple[int, int] | None]]:
        """Yield each mistake: its number, its line, and its row and column where it is an entry of a matrix."""
        for number, match in enumerate(MARK.finditer(self.marked)):
            before = self.marked[: match.start()]
            line = before.count("\n") + 1
            inside = re.split(r"\\begin\{[bp]?matrix\}", before.rpartition("\n")[2])
            entry = None
            if len(inside) == 2 and "matrix}" not in inside[-1]:
                row = re.split(r"\\\\", MARK.sub(r"\1", inside[-1]))
                entry = (len(row), row[-1].count("&") + 1)
            yield number, line, entry


def load() -> tuple[Bare, ...]:
    """Return the documents."""
    _, *parts = HEAD.split((HERE / "bare.txt").read_text("utf-8"))
    return tuple(Bare(Path(name), text) for name, text in zip(parts[::2], parts[1::2], strict=True))


def is_found(record: Record, entry: tuple[int, int] | None) -> bool:
    """Whether a record refutes its display, and names the entry that is wrong."""
    named = {(each.row, each.column) for each in record.entries}
    return record.verdict.value == "refuted" and (entry is None or entry in named or not named)


def judge(document: Bare) -> Iterator[tuple[str, int, str]]:
    """Yield what became of each claim and each mistake, with its line and our message."""
    for record in document.verify().equations:
        if record.verdict.value == "refuted":
            yield "false alarm", record.line, record.message
        elif record.line not in document.data:
            yield ("decided" if record.verdict.value in DECIDED else "undecided"), record.line, record.message
    for number, line, entry in document.mistakes:
        for record in document.verify(number).equations:
            if record.line == line and record.verdict.value in PASSES:
                yield "false pass", line, record.message
            elif record.line == line:
                yield ("found" if is_found(record, entry) else "missed"), line, record.message


def main() -> int:
    """Print each document and the totals; return 1 where anything true is refuted or anything false passes."""
    totals: Counter[str] = Counter()
    for document in load():
        if sys.argv[1:] and document.path.name not in sys.argv[1:]:
            continue
        started = time.perf_counter()
        found = list(judge(document))
        counts = Counter(kind for kind, _, _ in found)
        totals += counts
        print(f"{document.path.name:20}", dict(counts), f"{time.perf_counter() - started:.1f} s")
        for kind, line, message in found:
            if kind not in ("decided", "found"):
                print(f"    {kind} at line {line}: {message[:160]}")
    claims, mistakes = (
        sum(totals[kind] for kind in kinds) for kinds in (("decided", "undecided"), ("found", "missed"))
    )
    print(
        f"true and decided: {totals['decided']} of {claims}; mistakes found: {totals['found']} of {mistakes}", end="; "
    )
    print(f"false alarms: {totals['false alarm']}; false passes: {totals['false pass']}")
    return 1 if totals["false alarm"] or totals["false pass"] else 0


if __name__ == "__main__":
    sys.exit(main())
