"""What the displays of many documents came to, counted one document after the other."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator
from operator import itemgetter

from armproof.models.errors import MessageKind, counted, written
from armproof.verification.findings import Finding, Kind
from armproof.verification.verdict import DocumentResult, EquationResult, Failure, Record, Verdict

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
    Kind.TERMS_UNWRITTEN: ("an ellipsis, a sum or an integral leaves terms out", "write the terms out"),
    Kind.PATTERN: ("an ellipsis, a sum or an integral leaves terms out", "write the terms out"),
    Kind.CONDITION: ("a condition stands alone", r"write what follows from it, with \Rightarrow"),
    Kind.CONFIGURATION: ("a configuration stands alone", r"write what holds there, with \Rightarrow"),
    Kind.NO_EQUATION: ("no equation is stated", "write both sides, with ="),
    Kind.NUMBERS_OF_NOWHERE: ("numbers without a configuration", "state the joint values and lengths before them"),
    Kind.NO_ARM_FOR_TABLE: ("a table without an arm", _ARM),
    Kind.QUANTITY_WITHOUT_ARM: ("a quantity without an arm", _ARM),
    Kind.TOO_LARGE: ("too large to decide", "split it into steps, each with a name"),
}  # fmt: skip
_UNBOUND = {
    Kind.NOT_BOUND,
    Kind.NOT_BOUND_BECAUSE,
    Kind.NEVER_USED,
    Kind.DEFINES,
    Kind.DEFINES_ENTRIES,
    Kind.DEFINES_WITHOUT_VALUE,
}
_NO_ARM = "no arm is known: name it in the front matter (arm: …), or print its DH table"
_ORDER = (Verdict.PROVED, Verdict.CONFIRMED, Verdict.DEFINED, Verdict.REFUTED, Verdict.UNCHECKED, Verdict.UNREADABLE)


class Undecided:
    """Counts equations, tables and the like: how many claim something, and why some of them are not decided."""

    def __init__(self) -> None:
        self.total: Counter[str] = Counter()  # by noun; remarks are not among them
        self.open: Counter[str] = Counter()
        self._causes: Counter[str] = Counter()

    def add(self, record: Record, noun: str = "equation", *, arm: bool = True) -> None:
        """Count the equations of a record, or the record where it has none; `arm`: whether its document needs none."""
        for each in record.outcomes or (record,):
            if isinstance(each, EquationResult) and each.is_remark:
                continue
            self.total[noun] += 1
            if each.verdict in (Verdict.UNCHECKED, Verdict.UNREADABLE):
                self.open[noun] += 1
                self._causes[_cause(each.findings or record.findings, arm)] += 1

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


def _cause(findings: tuple[Finding, ...], arm: bool) -> str:
    """Return the cause in words: one sentence a kind, with what to write where that is known.

    Without an arm no name of kinematics is bound, and to bind them one by one would be the wrong advice.
    """
    if not findings:
        return "compared with nothing"
    last = findings[-1]
    finding = last if last.kind is Kind.NEVER_USED else findings[0]
    if not arm and finding.kind in _UNBOUND:
        return _NO_ARM
    if finding.kind in _EXPECTED:
        return ": ".join(_EXPECTED[finding.kind])
    return str(finding)


class Tally:
    """How many records of a kind have which verdict; an erratum that is refuted is as it should be."""

    def __init__(self, noun: str, records: Iterable[Record] = ()) -> None:
        self.noun = noun
        self.verdicts: Counter[Verdict] = Counter()
        self.errata = self.remarks = self.accepted = 0
        for record in records:
            self.add(record)

    def add(self, record: Record) -> None:
        """Count a record."""
        if record.is_accepted:
            self.accepted += 1
        elif record.erratum and record.passes:
            self.errata += 1
        elif record.is_remark:
            self.remarks += 1
        else:
            self.verdicts[record.verdict] += 1

    def __len__(self) -> int:
        return self.verdicts.total() + self.errata + self.remarks + self.accepted

    def __str__(self) -> str:
        """Return "12 displays: 8 proved, 1 refuted, 3 errata refuted"."""
        words = [f"{self.verdicts[verdict]} {verdict.value}" for verdict in _ORDER if self.verdicts[verdict]]
        if self.remarks:
            words.append(count(self.remarks, "remark"))
        if self.errata:
            words.append(f"{'1 erratum' if self.errata == 1 else f'{self.errata} errata'} refuted")
        if self.accepted:
            words.append(written("{number} accepted", number=self.accepted))
        return count(len(self), self.noun) + (f": {', '.join(words)}" if words else "")


class Totals:
    """The total of a report: of documents that are gone by the time it is written.

    Args:
        strict: whether an unchecked display lets its document fail.
    """

    def __init__(self, strict: bool = False) -> None:
        self.strict = strict
        self.documents = self.failing = self.unable = self.samples = 0
        self.largest_error: tuple[float, str] | None = None  # and the document in which it is
        self.displays, self.tables = Tally("display"), Tally("table")
        self.undecided = Undecided()
        self.claims = False  # whether anything is decided
        self.without_claim: list[str] = []  # documents in which there is nothing to decide
        self.messages: list[str] = []  # why documents could not be checked

    @classmethod
    def of(cls, results: Iterable[DocumentResult | Failure], strict: bool = False) -> Totals:
        """Return the total of results."""
        totals = cls(strict)
        for result in results:
            totals.add(result)
        return totals

    def add(self, result: DocumentResult | Failure) -> None:
        """Count a document."""
        if isinstance(result, Failure):
            self.unable += 1
            self.messages.append(result.message)
            return
        self.documents += 1
        self.failing += not passes(result, self.strict)
        self.claims |= result.claims
        undecided = self.undecided.open.total()
        inverse = [result.inverse] if result.inverse is not None else []
        for noun, records in (("equation", result.equations), ("table", result.tables), ("inverse", inverse)):
            for record in records:
                self._add_record(record, noun, result)
        if not result.claims and self.undecided.open.total() == undecided:
            self.without_claim.append(result.path)

    def _add_record(self, record: Record, noun: str, result: DocumentResult) -> None:
        self.undecided.add(record, noun, arm=bool(result.arm or result.arms or result.claims))
        if noun != "inverse":
            (self.tables if noun == "table" else self.displays).add(record)
        self.samples = max(self.samples, record.samples)
        if record.max_error is not None and record.samples:
            error = (record.max_error, result.path)
            self.largest_error = max(self.largest_error or error, error, key=itemgetter(0))

    @property
    def passed(self) -> bool:
        """Whether every document could be checked and passes."""
        return not (self.failing or self.unable)

    def describe(self) -> list[str]:
        """Return the total in words: the numbers, whether everything passes, then why equations are not decided."""
        return [*self.numbers(), self.verdict, *self.undecided.causes()]

    def numbers(self) -> list[str]:
        """Return what the displays came to, and the largest error."""
        lines = []
        if self.documents:
            of_tables = f"; {self.tables}" if len(self.tables) else ""
            lines.append(f"{count(self.documents, 'document')}, {self.displays}{of_tables}")
        if self.largest_error is not None:
            error, path = self.largest_error
            where = f"{self.samples:,} configurations"
            within = f", in {path}" if self.documents > 1 else ""
            lines.append(f"evaluated on Drake's numerical plant at {where}: largest error {error:.1e}{within}")
        return lines

    @property
    def verdict(self) -> str:
        """The answer in a sentence: everything passes only where every claim was decided."""
        if self.passed:
            return self._nothing_wrong
        verb = "does" if self.failing == 1 else "do"
        strictly = self._fails_strictly() if self.strict else []
        why = f" (--strict: {'; '.join(strictly)})" if strictly else ""
        verdicts = [f"{count(self.failing, 'document')} {verb} not pass{why}"] if self.failing else []
        if self.unable:
            verdicts.append(f"{self.unable} could not be checked")
        if self.undecided and not why:
            verdicts.append(str(self.undecided))
        return "; ".join(verdicts)

    @property
    def decides_all(self) -> bool:
        """Whether there are claims, and each is decided."""
        return self.claims and not self.undecided and not self.accepted

    @property
    def accepted(self) -> int:
        """How many findings the authors accept: they are not right."""
        return self.displays.accepted + self.tables.accepted

    @property
    def _nothing_wrong(self) -> str:
        if self.accepted:
            told = counted("nothing else wrong found; {number} finding is accepted, not right",
                           "nothing else wrong found; {number} findings are accepted, not right", self.accepted)  # fmt: skip
            return f"{told}; {self.undecided}" if self.undecided else told
        if self.undecided:
            return f"nothing wrong found; {self.undecided}"
        return "everything passes" if self.decides_all else "no claim was found"

    def _fails_strictly(self) -> list[str]:
        """Return what fails documents with `--strict` alone."""
        found = [str(self.undecided)] if self.undecided else []
        if self.without_claim:
            found.append(f"no claim was found in {', '.join(self.without_claim)}")
        return found


def passes(result: DocumentResult, strict: bool) -> bool:
    """Whether a document passes; with `strict`, an unchecked display does not."""
    return result.passed_strictly() if strict else result.passed


def count(number: int, noun: str) -> str:
    """Return "1 document", "2 documents"."""
    return f"{number} {noun}" if number == 1 else f"{number} {noun}s"
