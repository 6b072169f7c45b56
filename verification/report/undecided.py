"""Why equations are not decided: the causes, the most frequent first, each with what to write."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

from armproof.models.errors import MessageKind
from armproof.verification.findings import Finding, Kind
from armproof.verification.verdict import EquationResult, Record, Verdict

_BIND = "bind it in the front matter: quantities: …"
_ARM = "name the arm in the front matter: arm: …"
_EXPECTED: dict[MessageKind, tuple[str, str]] = {
    Kind.NOT_BOUND: ("a name is not bound", _BIND),
    Kind.NOT_BOUND_BECAUSE: ("a name is not bound", _BIND),
    Kind.NEVER_USED: ("no decided claim uses what is defined", "bind the name in the front matter (quantities: …)"),
    Kind.DEFINES: ("no decided claim uses what is defined", "bind the name in the front matter (quantities: …)"),
    Kind.DEFINES_ENTRIES: ("no decided claim uses what is defined", "bind the name in the front matter (quantities: …)"),
    Kind.DEFINES_WITHOUT_VALUE: ("a definition rests on names without a value", "bind those names: quantities: …"),
    Kind.LEFT_OUT: ("an expression stands beside an equation", "give it a display of its own, or write it as text"),
    Kind.PATTERN: ("an ellipsis, a sum or an integral leaves terms out", "write the terms out"),
    Kind.CONDITION: ("a condition stands alone", r"write what follows from it, with \Rightarrow"),
    Kind.CONFIGURATION: ("a configuration stands alone", r"write what holds there, with \Rightarrow"),
    Kind.NO_EQUATION: ("no equation is stated", "write both sides, with ="),
    Kind.NUMBERS_OF_NOWHERE: ("numbers without a configuration", "state the joint values and lengths before them"),
    Kind.NO_ARM_FOR_TABLE: ("a table without an arm", _ARM),
    Kind.QUANTITY_WITHOUT_ARM: ("a quantity without an arm", _ARM),
    Kind.TOO_LARGE: ("too large to decide", "split it into steps, each with a name"),
}  # fmt: skip


class Undecided:
    """Counts equations, tables and the like: how many claim something, and why some of them are not decided."""

    def __init__(self) -> None:
        self.total: Counter[str] = Counter()  # by noun; remarks are not among them
        self.open: Counter[str] = Counter()
        self._causes: Counter[str] = Counter()

    def add(self, record: Record, noun: str = "equation") -> None:
        """Count the equations of a record, or the record where it has none."""
        for each in record.outcomes or (record,):
            if isinstance(each, EquationResult) and each.is_remark:
                continue
            self.total[noun] += 1
            if each.verdict in (Verdict.UNCHECKED, Verdict.UNREADABLE):
                self.open[noun] += 1
                self._causes[_cause(each.findings or record.findings)] += 1

    def __bool__(self) -> bool:
        return self.open.total() > 0

    def __str__(self) -> str:
        """Return "12 of 40 equations and 1 of 2 tables not decided"."""
        parts = [
            f"{number:,} of {self.total[noun]:,} {noun}{'' if self.total[noun] == 1 else 's'}"
            for noun, number in self.open.items()
        ]
        return f"{' and '.join(parts)} not decided"

    def causes(self) -> Iterator[str]:
        """Yield "8 × a name is not bound: bind it in the front matter: quantities: …", the most frequent first."""
        for cause, number in sorted(self._causes.items(), key=lambda item: (-item[1], item[0])):
            yield f"{number:,} × {cause}"


def _cause(findings: tuple[Finding, ...]) -> str:
    """Return the cause in words: one sentence a kind, with what to write where that is known."""
    if not findings:
        return "compared with nothing"
    last = findings[-1]
    finding = last if last.kind is Kind.NEVER_USED else findings[0]
    if finding.kind in _EXPECTED:
        return ": ".join(_EXPECTED[finding.kind])
    return str(finding)
