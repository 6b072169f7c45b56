"""Our own verdicts on the labelled cases."""

from __future__ import annotations

from collections.abc import Iterable
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from pathlib import Path

from armproof.verification.check import check_document
from armproof.verification.document.formats import parse_document
from armproof.verification.findings import Finding
from armproof.verification.verdict import DocumentResult, EquationResult, Record, WrongEntry
from tests.labelled.cases import Case

PAGE = Path("page.md")


@dataclass(frozen=True)
class Judged:
    """A case, our verdict on its display, and what we say of it: in words, and for the record in short."""

    case: Case
    verdict: str
    message: str
    said: str

    @property
    def fault(self) -> str:
        """What is wrong with the verdict, or "" where the label allows it."""
        return self.case.fault(self.verdict)


def verify_text(text: str) -> DocumentResult:
    """Return the verdicts of a document given as text."""
    return check_document(parse_document(PAGE, text))


def judge(case: Case) -> Judged:
    """Return our verdict on the last display of a case's document; an exception is the verdict "error"."""
    try:
        *before, record = verify_text(case.text).equations
    except Exception as error:
        return Judged(case, "error", f"{type(error).__name__}: {error}", "error")
    told = [f"before: {' '.join(each.verdict.value for each in before)}"] if before else []
    return Judged(case, record.verdict.value, record.message, " | ".join([*told, said_of(record)]))


def said_of(record: Record) -> str:
    """Return the verdict of a display and its wrong entries; of each equation its role, verdict, findings and reading."""
    entries = "; ".join(map(_said_of_entry, record.entries))
    said = " | ".join(filter(None, [record.verdict.value, entries, *map(_said_of_equation, record.outcomes)]))
    return " ".join(said.split())


def _said_of_entry(entry: WrongEntry) -> str:
    place = f"({entry.row},{entry.column}) " * (entry.row is not None)
    return f"{place}{entry.printed} → {entry.correct}"


def _said_of_equation(result: EquationResult) -> str:
    findings = ", ".join(map(said_of_finding, result.findings))
    return (
        f"{result.role.value} {result.verdict.value}"
        + f" [{findings}]" * bool(findings)
        + f" {result.read_as}" * bool(result.read_as)
    )


def said_of_finding(finding: Finding) -> str:
    """Return the kind of a finding and its terms, in no language: its sentence may be written anew."""
    terms = "; ".join(map(_said_of_term, finding.terms.values()))
    return finding.kind.value + f"({terms})" * bool(terms)


def _said_of_term(term: object) -> str:
    if isinstance(term, Finding):
        return said_of_finding(term)
    if isinstance(term, list | tuple):
        return ", ".join(map(_said_of_term, term))
    return f"{term:.4g}" if isinstance(term, float) else str(term)


def said_of_document(result: DocumentResult) -> str:
    """Return what is said of a document, a line each: the arms that were taken, remarks, displays and tables with their lines."""
    taken = [arm for arm in result.arms if arm.source != "front matter"]
    arms = [f"{arm}: {dict(arm.front, transforms=arm.transforms)}" for arm in taken]
    remarks = map(said_of_finding, result.remarks)
    records = (f"{record.line} {said_of(record)}" for record in result.records)
    return "".join(f"{line}\n" for line in (*arms, *remarks, *records))


def judge_all(cases: Iterable[Case], jobs: int = 1) -> list[Judged]:
    """Return our verdicts on many cases, in their order."""
    if jobs <= 1:
        return [judge(case) for case in cases]
    with ProcessPoolExecutor(jobs) as pool:
        return list(pool.map(judge, cases, chunksize=20))
