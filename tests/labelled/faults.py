"""Where our verdicts differ from the labels, and the list of what is not yet right; the list can only shrink."""

from __future__ import annotations

import hashlib
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import lru_cache

from tests.labelled.cases import FALSE_PASS, FALSE_REFUTATION, HERE, UNDECIDED, load_cases
from tests.labelled.judging import Judged, judge_all
from tests.labelled.pages import STRICT, load_pages

NOT_YET = HERE / "not_yet.txt"
WEIGHT = {UNDECIDED: 0, "unread": 1, STRICT: 2, FALSE_REFUTATION: 3, FALSE_PASS: 4, "error": 5}
HEADER = """\
# Where our verdicts are not yet right. A test holds this list against them: whatever is mended must leave it
# (python -m tests.labelled --update), and nothing is added but a new case that fails from the start.
"""


@dataclass(frozen=True)
class Fault:
    """One verdict that its label does not allow; `key` names the display, whatever stands before it in the file."""

    key: str
    kind: str
    where: str
    said: str
    message: str = ""

    @property
    def line(self) -> str:
        """The fault as a line of the list."""
        return f"{self.key}  {self.kind:16}  {self.where} | {self.said}"


@lru_cache
def judged_cases(jobs: int = 1) -> tuple[Judged, ...]:
    """Return our verdicts on all labelled displays and spellings."""
    return tuple(judge_all(load_cases(), jobs))


@lru_cache
def faults_of_cases(jobs: int = 1) -> tuple[Fault, ...]:
    """Return the faults of the labelled displays and spellings."""
    return faults_among(judged_cases(jobs))


def faults_among(judged: Iterable[Judged]) -> tuple[Fault, ...]:
    """Return the faults among our verdicts on cases."""
    return tuple(
        Fault(j.case.key, j.fault, f"{j.case.about} ({j.case.label})", j.case.one_line, f"{j.verdict}: {j.message}")
        for j in judged
        if j.fault
    )


@lru_cache
def faults_of_pages() -> tuple[Fault, ...]:
    """Return the faults of the attacks, of their true twins and of the strangers' pages."""
    return tuple(
        Fault(_digest(page.kind, page.name, kind == STRICT, said), kind, page.title, said, message)
        for page in load_pages()
        for kind, said, message in page.faults()
    )


def _digest(*parts: object) -> str:
    return hashlib.sha1("\n".join(map(str, parts)).encode(), usedforsecurity=False).hexdigest()[:8]


def read_not_yet() -> dict[str, str]:
    """Return the list: key → kind of fault."""
    lines = [line for line in NOT_YET.read_text("utf-8").splitlines() if line and not line.startswith("#")]
    return {line[:8]: line[10:26].strip() for line in lines}


def write_not_yet(faults: Iterable[Fault]) -> None:
    """Write the list anew."""
    NOT_YET.write_text(HEADER + "".join(f"{fault.line}\n" for fault in faults), "utf-8")


def unexpected(faults: Iterable[Fault], listed: Mapping[str, str]) -> list[Fault]:
    """Return the faults that are not listed, or listed as a lesser one."""
    return [f for f in faults if f.key not in listed or WEIGHT[f.kind] > WEIGHT[listed[f.key]]]


def mended(faults: Iterable[Fault], listed: Mapping[str, str]) -> list[str]:
    """Return the keys of the list that name no fault any more."""
    return sorted(set(listed) - {fault.key for fault in faults})
