"""What the displays of many documents came to, counted one document after the other."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator
from operator import itemgetter

from armproof.models.errors import MessageKind, counted, written
from armproof.models.language import look_up, noted, noted_plural, number_text
from armproof.verification.findings import Finding, Kind
from armproof.verification.verdict import DocumentResult, EquationResult, Failure, Record, Verdict

_EXPECTED: dict[MessageKind, str] = {
    kind: sentence
    for sentence, kinds in {
        noted("a name is not bound: bind it in the front matter: quantities: …"): (Kind.NOT_BOUND, Kind.NOT_BOUND_BECAUSE),
        noted("no decided claim uses what is defined: bind the name in the front matter (quantities: …)"): (
            Kind.NEVER_USED, Kind.DEFINES, Kind.DEFINES_ENTRIES),
        noted("a definition rests on names without a value: bind those names: quantities: …"): (Kind.DEFINES_WITHOUT_VALUE,),
        noted("an expression stands beside an equation: give it a display of its own, or write it as text"): (Kind.LEFT_OUT,),
        noted("an ellipsis, a sum or an integral leaves terms out: write the terms out"): (Kind.TERMS_UNWRITTEN, Kind.PATTERN),
        noted("a condition stands alone: write what follows from it, with \\Rightarrow"): (Kind.CONDITION,),
        noted("a configuration stands alone: write what holds there, with \\Rightarrow"): (Kind.CONFIGURATION,),
        noted("no equation is stated: write both sides, with ="): (Kind.NO_EQUATION,),
        noted("numbers without a configuration: state the joint values and lengths before them"): (Kind.NUMBERS_OF_NOWHERE,),
        noted("a table without an arm: name the arm in the front matter: arm: …"): (Kind.NO_ARM_FOR_TABLE,),
        noted("a quantity without an arm: name the arm in the front matter: arm: …"): (Kind.QUANTITY_WITHOUT_ARM,),
        noted("a sentence beside an equation has words that are not known here: say it in plainer ones"): (Kind.STRANGE_WORDS, Kind.STRANGE_LETTER),
        noted("too large to decide: split it into steps, each with a name"): (Kind.TOO_LARGE,),
    }.items()
    for kind in kinds
}  # fmt: skip
_UNBOUND = {
    Kind.NOT_BOUND,
    Kind.NOT_BOUND_BECAUSE,
    Kind.NEVER_USED,
    Kind.DEFINES,
    Kind.DEFINES_ENTRIES,
    Kind.DEFINES_WITHOUT_VALUE,
}
_CONTRADICT = {Kind.LINK_DISPUTED, Kind.SLIP_IN_LINK, Kind.CONTRADICTED, Kind.RESTS_ON_DOUBT}  # one of two is wrong
_NOUNS = {
    "document": noted_plural("{number} document", "{number} documents"),
    "display": noted_plural("{number} display", "{number} displays"),
    "table": noted_plural("{number} table", "{number} tables"),
    "remark": noted_plural("{number} remark", "{number} remarks"),
}
_OPEN = {
    "equation": noted_plural("{open:,} of {number:,} equation", "{open:,} of {number:,} equations"),
    "table": noted_plural("{open:,} of {number:,} table", "{open:,} of {number:,} tables"),
    "inverse": noted_plural("{open:,} of {number:,} inverse", "{open:,} of {number:,} inverses"),
}
_ORDER = (Verdict.PROVED, Verdict.CONFIRMED, Verdict.DEFINED, Verdict.REFUTED, Verdict.UNCHECKED, Verdict.UNREADABLE)


class Undecided:
    """Counts equations, tables and the like: how many claim something, and why some of them are not decided."""

    def __init__(self) -> None:
        self.total: Counter[str] = Counter()  # by noun; remarks are not among them
        self.open: Counter[str] = Counter()
        self._causes: Counter[str] = Counter()
        self.contradictory = False  # whether something is wrong, and what of two things is not known

    def add(self, record: Record, noun: str = "equation", *, arm: bool = True) -> None:
        """Count the equations of a record, or the record where it has none; `arm`: whether its document needs none."""
        for each in record.outcomes or (record,):
            if isinstance(each, EquationResult) and each.is_remark:
                continue
            self.total[noun] += 1
            if each.verdict in (Verdict.UNCHECKED, Verdict.UNREADABLE):
                self.open[noun] += 1
                self._causes[_cause(each.findings or record.findings, arm)] += 1
                self.contradictory |= any(finding.kind in _CONTRADICT for finding in each.findings)

    def __bool__(self) -> bool:
        return self.open.total() > 0

    def __str__(self) -> str:
        """Return "12 of 40 equations and 1 of 2 tables not decided"."""
        parts = [counted(*_OPEN[noun], self.total[noun], open=number) for noun, number in self.open.items()]
        told = look_up(" and ").join(parts)
        return counted("{parts} not decided", "{parts} not decided", self.open.total(), parts=told)

    def causes(self) -> Iterator[str]:
        """Yield "8 × a name is not bound: bind it in the front matter: quantities: …", the most frequent first."""
        for cause, number in sorted(self._causes.items(), key=lambda item: (-item[1], item[0])):
            yield f"{number_text(number, ',')} × {cause}"


def _cause(findings: tuple[Finding, ...], arm: bool) -> str:
    """Return the cause in words: one sentence a kind, with what to write where that is known.

    Without an arm no name of kinematics is bound, and to bind them one by one would be the wrong advice.
    """
    if not findings:
        return look_up("compared with nothing")
    last = findings[-1]
    finding = last if last.kind is Kind.NEVER_USED else findings[0]
    if not arm and finding.kind in _UNBOUND:
        return look_up("no arm is known: name it in the front matter (arm: …), or print its DH table")
    if finding.kind in _EXPECTED:
        return look_up(_EXPECTED[finding.kind])
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
        words = [count(self.verdicts[verdict], verdict.value) for verdict in _ORDER if self.verdicts[verdict]]
        if self.remarks:
            words.append(count(self.remarks, "remark"))
        if self.errata:
            words.append(counted("{number} erratum refuted", "{number} errata refuted", self.errata))
        if self.accepted:
            words.append(counted("{number} accepted", "{number} accepted", self.accepted))
        told = count(len(self), self.noun)
        return written("{what}: {parts}", what=told, parts=", ".join(words)) if words else told


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
            told = [str(self.displays), *([str(self.tables)] if len(self.tables) else [])]
            lines.append(f"{count(self.documents, 'document')}, {look_up('; ').join(told)}")
        if self.largest_error is not None:
            error, path = self.largest_error
            within = written(", in {path}", path=path) if self.documents > 1 else ""
            one, many = noted_plural(
                "evaluated on Drake's numerical plant at {number:,} configuration: largest error {error:.1e}{within}",
                "evaluated on Drake's numerical plant at {number:,} configurations: largest error {error:.1e}{within}",
            )
            lines.append(counted(one, many, self.samples, error=error, within=within))
        return lines

    @property
    def verdict(self) -> str:
        """The answer in a sentence: everything passes only where every claim was decided."""
        if self.passed:
            return self._nothing_wrong
        strictly = self._fails_strictly() if self.strict else []
        why = written(" (--strict: {reasons})", reasons=look_up("; ").join(strictly)) if strictly else ""
        verdicts = []
        if self.failing:
            one, many = noted_plural("{number} document does not pass{why}", "{number} documents do not pass{why}")
            verdicts.append(counted(one, many, self.failing, why=why))
        if self.unable:
            verdicts.append(counted("{number} could not be checked", "{number} could not be checked", self.unable))
        if self.undecided and not why:
            verdicts.append(str(self.undecided))
        return look_up("; ").join(verdicts)

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
            return f"{told}{look_up('; ')}{self.undecided}" if self.undecided else told
        if self.undecided.contradictory:
            return written("some lines contradict each other; {undecided}", undecided=self.undecided)
        if self.undecided:
            return written("nothing wrong found; {undecided}", undecided=self.undecided)
        return look_up("everything passes") if self.decides_all else look_up("no claim was found")

    def _fails_strictly(self) -> list[str]:
        """Return what fails documents with `--strict` alone."""
        found = [str(self.undecided)] if self.undecided else []
        if self.without_claim:
            found.append(written("no claim was found in {documents}", documents=self.without_claim))
        return found


def passes(result: DocumentResult, strict: bool) -> bool:
    """Whether a document passes; with `strict`, an unchecked display does not."""
    return result.passed_strictly() if strict else result.passed


def count(number: int, noun: str) -> str:
    """Return "1 document", "2 documents"; of a verdict "2 refuted"."""
    return counted(*_NOUNS.get(noun, (f"{{number}} {noun}",) * 2), number)
