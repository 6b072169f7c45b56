"""The verdicts, and the record of one display."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field, replace
from enum import StrEnum
from pathlib import Path
from typing import Any

from armproof.models.language import look_up
from armproof.verification.errors import DocumentError, located
from armproof.verification.findings import Finding, Kind, finding_of, say
from armproof.verification.findings.finding import write_all


class Verdict(StrEnum):
    """What became of an equation, from best to worst."""

    PROVED = "proved"
    CONFIRMED = "confirmed"
    DEFINED = "defined"
    UNCHECKED = "unchecked"
    UNREADABLE = "unreadable"
    REFUTED = "refuted"


class Role(StrEnum):
    """What an equation is, before anything is decided; only a claim, a condition and a law can be right or wrong."""

    CLAIM = "claim"  # all of it is bound: by front matter, by convention or by an earlier definition
    DEFINITION = "definition"  # gives a new name its meaning
    DATA = "data"  # gives a length or a joint variable its value
    CONDITION = "condition"  # with its arrow, or "if"
    LAW = "law"  # holds for any link i
    REMARK = "remark"  # nothing of the arm's or the document's kinematics in it


_ACCEPTS = (Kind.ACCEPTED, Kind.ACCEPTED_WITHOUT_REASON, Kind.ACCEPTS_NOTHING, Kind.ACCEPTS_NO_DISPLAY)
HOLDS = (Verdict.PROVED, Verdict.CONFIRMED)
DECIDED = (*HOLDS, Verdict.REFUTED)
AXES = -3  # beside the links of an arm that an equation tells of: x of its tool, -4 y, -5 z


# A display carries the worst verdict of its equations; one that only defines a name yields to one that was checked.
_WEIGHT = {
    Verdict.DEFINED: 0,
    Verdict.PROVED: 1,
    Verdict.CONFIRMED: 2,
    Verdict.UNCHECKED: 3,
    Verdict.UNREADABLE: 4,
    Verdict.REFUTED: 5,
}


def worst(verdicts: list[Verdict]) -> Verdict:
    """Return the worst verdict; refuted is the worst, defined yields to everything."""
    return max(verdicts, key=_WEIGHT.__getitem__, default=Verdict.DEFINED)


@dataclass(frozen=True)
class SlipBefore:
    """The one change of what a display before says of a name, with which an equation that is refuted would hold, and what it then says.

    It has a rival where one slip in the equation itself would mend that, too; it is the only one where no slip in another definition
    would, either, and both stand under one heading. `printed` and `correct` are the two formulas.
    """

    name: str
    line: int
    change: Finding
    formula: object
    has_rival: bool = False
    printed: str = ""
    correct: str = ""
    is_only: bool = False


@dataclass(frozen=True)
class EquationResult:
    """What became of one equation of a display.

    Attributes:
        index: its number in the display, from 1.
        role: what it is.
        read_as: what its true side was taken for, in words: "origin of frame 2 in frame 0, x"; empty where it is a formula.
        findings: why it has its verdict.
        samples, max_error: of its evaluation on the double plant.
        defines, uses: the names that it defines, and those of other equations that its sides rest on, each with the line of
            the display that defines it.
        links: the links of the arm that it tells of.
        explained_by: those of them of which another one would make it right; None where that is not known.
        is_of_no_arm: whether what is printed for a rotation, a pose or an axis is none, so that no other arm makes it right.
        against: links whose lengths it holds in no entry as the arm has them, where it is refuted.
        usual: the names in it that convention alone binds, each with the quantity that it is taken for.
        alone: the names that stand alone on a side.
        slip_before: with which slip in a definition before it holds, where it is refuted.
        order: of the arguments of atan2, with which it holds.
        may_slip: of what it rests on, where it is refuted, the definitions that claim something: (x, y) = F does not.
        of_table: how many of its entries hold with the letter of a joint with an offset read as the angle in the DH table.
    """

    index: int
    role: Role
    verdict: Verdict
    read_as: str = ""
    findings: tuple[Finding, ...] = ()
    samples: int = 0
    max_error: float | None = None
    defines: frozenset[tuple[str, int]] = frozenset()
    uses: frozenset[tuple[str, int]] = frozenset()
    links: frozenset[int] = frozenset()
    explained_by: frozenset[int] | None = None
    is_of_no_arm: bool = False
    against: frozenset[int] = frozenset()
    usual: Mapping[str, object] = field(default_factory=dict)
    alone: frozenset[str] = frozenset()
    slip_before: SlipBefore | None = None
    order: str = ""
    may_slip: frozenset[tuple[str, int]] = frozenset()
    of_table: int = 0

    @property
    def is_remark(self) -> bool:
        """Whether it is about something else than the arm and the document's kinematics."""
        return self.role is Role.REMARK and self.verdict is Verdict.UNCHECKED

    @property
    def is_decided(self) -> bool:
        """Whether it claims something, and that is decided."""
        return self.verdict in DECIDED

    def as_json(self) -> dict[str, Any]:
        """Return the equation as the report's JSON writes it."""
        return {
            "index": self.index,
            "role": self.role.value,
            "read_as": self.read_as,
            "verdict": self.verdict.value,
            "findings": [finding.as_json() for finding in self.findings],
            "samples": self.samples,
            "max_error": self.max_error,
        }


@dataclass(frozen=True)
class WrongEntry:
    """One wrong cell, in the document's notation; a scalar has no row and column. `span` is its place in the display."""

    equation: int
    row: int | None
    column: int | None
    printed: str
    correct: str
    finding: Finding | None = None  # the small change that mends it
    span: tuple[int, int] | None = None

    @property
    def change(self) -> str:
        """The small change that mends it, in words; empty where none does."""
        return str(self.finding) if self.finding is not None else ""

    def as_json(self) -> dict[str, Any]:
        """Return the entry as the report's JSON writes it."""
        place = {} if self.row is None else {"row": self.row, "column": self.column}
        change = {"change": self.change} if self.change else {}
        return {"equation": self.equation, **place, "printed": self.printed, "correct": self.correct, **change}


@dataclass(frozen=True)
class Correction:
    """A piece of a display's LaTeX as the author wrote it, [start, end), and what belongs there."""

    start: int
    end: int
    text: str


Rows = tuple[tuple[float, ...], ...]


def as_rows(matrix: Iterable[Iterable[float]]) -> Rows:
    """Return the numbers of a matrix as data."""
    return tuple(tuple(map(float, row)) for row in matrix)


@dataclass(frozen=True)
class Drawn:
    """A true and a printed pose or vector of the arm, in frame 0.

    Attributes:
        kind: "pose" (4×4: both sides), or "axis", "difference", "velocity" and "angular velocity" (3×1: at the frame).
        frame: the frame whose pose it is, or from whose origin the vector is drawn.
        joint: of a velocity, the joint (from 1) that alone moves; 0: none.
    """

    kind: str
    frame: str
    true: Rows
    printed: Rows
    joint: int = 0


@dataclass(frozen=True)
class Discrepancy:
    """The printed and the true value of each wrong entry of one equation at the counterexample, (printed, true)."""

    equation: int
    values: tuple[tuple[float, float], ...] = ()
    drawn: Drawn | None = None


@dataclass(frozen=True)
class IfShown:
    """The record of a display while its names mean what they usually do, and these meanings; whether it is of another point as it stands."""

    record: Record
    meanings: Mapping[str, object]
    of_another: bool = False


@dataclass(frozen=True)
class Record:
    """The verdict of one display, or of one DH table.

    `corrections` is what mends it, from left to right, verified by checking the display so corrected: empty where nothing
    does, None where it was not sought.
    """

    line: int
    latex: str
    verdict: Verdict
    erratum: bool = False
    findings: tuple[Finding, ...] = ()  # why
    outcomes: tuple[EquationResult, ...] = ()  # one an equation, in their order; none for a table
    entries: tuple[WrongEntry, ...] = ()
    counterexample: Mapping[str, float] = field(default_factory=dict)
    samples: int = 0
    max_error: float | None = None
    cell: int | None = None
    section: str = ""
    discrepancy: Discrepancy | None = None  # the sides at the counterexample, for a drawing
    corrections: tuple[Correction, ...] | None = None
    arm_index: int | None = None  # of the document's arms, that which it was compared with
    file: str = ""  # in which it stands, of a document of several
    if_shown: IfShown | None = (
        None  # what it is if the rest of the document shows its names to mean what they usually do
    )

    @property
    def place(self) -> tuple[int | None, int]:
        """Its cell and its line."""
        return self.cell, self.line

    @property
    def is_decided(self) -> bool:
        """Whether something that it claims is decided."""
        return self.verdict in DECIDED or any(outcome.is_decided for outcome in self.outcomes)

    @property
    def is_remark(self) -> bool:
        """Whether all that is unchecked in it is about something else than the arm: it never fails `--strict`."""
        unchecked = [each for each in self.outcomes if each.verdict is Verdict.UNCHECKED]
        return self.verdict is Verdict.UNCHECKED and bool(unchecked) and all(each.is_remark for each in unchecked)

    def with_outcomes(self, outcomes: tuple[EquationResult, ...]) -> Record:
        """Return the record with other outcomes, some of which are left open: it has the worst verdict of them."""
        verdict = worst([each.verdict for each in outcomes])
        if verdict is self.verdict or verdict is not Verdict.UNCHECKED:
            return replace(self, verdict=verdict, outcomes=outcomes)
        findings = tuple(finding for each in outcomes if each.verdict is verdict for finding in each.findings)
        known = replace(self, verdict=verdict, outcomes=outcomes, findings=findings)
        return replace(known, entries=(), counterexample={}, discrepancy=None, corrections=None)

    def left_open(self, doubt: Finding, is_meant: Callable[[EquationResult], bool]) -> Record:
        """Return the record with those of its outcomes left open for a doubt that are meant."""
        if not any(map(is_meant, self.outcomes)):
            return self
        opened = self.with_outcomes(
            tuple(
                replace(each, verdict=Verdict.UNCHECKED, findings=(doubt.at(each.index),)) if is_meant(each) else each
                for each in self.outcomes
            )
        )
        said = (finding for each in opened.outcomes if each.verdict is opened.verdict for finding in each.findings)
        return opened if opened.verdict is not Verdict.UNCHECKED else replace(opened, findings=tuple(said))

    @property
    def message(self) -> str:
        """The findings in words."""
        return write_all(self.findings)

    def says(self, kind: Kind) -> bool:
        """Whether one of the findings is of a kind."""
        return any(finding.kind is kind for finding in self.findings)

    @property
    def accept(self) -> Finding | None:
        """What became of its author's comment that accepts a finding; None where there is none."""
        return next((finding for finding in self.findings if finding.kind in _ACCEPTS), None)

    @property
    def is_accepted(self) -> bool:
        """Whether its author accepts, with a reason, what was found: it is counted apart."""
        return self.says(Kind.ACCEPTED)

    @property
    def passes(self) -> bool:
        """Whether the display does not fail its document: an erratum must be refuted, everything else must not."""
        if self.is_accepted:
            return True
        if self.erratum:
            return self.verdict is Verdict.REFUTED
        return self.verdict not in (Verdict.REFUTED, Verdict.UNREADABLE)

    def as_json(self) -> dict[str, Any]:
        """Return the record as the report's JSON writes it."""
        return {
            "line": self.line,
            **({"file": self.file} if self.file else {} if self.cell is None else {"cell": self.cell}),
            "latex": self.latex,
            "verdict": self.verdict.value,
            "erratum": self.erratum,
            "message": self.message,
            "findings": [finding.as_json() for finding in self.findings],
            "outcomes": [outcome.as_json() for outcome in self.outcomes],
            "entries": [entry.as_json() for entry in self.entries],
            "counterexample": dict(self.counterexample),
            "samples": self.samples,
            "max_error": self.max_error,
            "arm_index": self.arm_index,
        }


@dataclass(frozen=True)
class TakenArm:
    """An arm of a document, and what it was taken from.

    Attributes:
        source: "front matter", "table", "matrices", "closed form", "description" or "figure".
        line, cell: where that stands: the key of the front matter, the table, the first link matrix.
        convention: classic, modified, or empty where the arm is none of a DH table.
        transforms: which index of a transform's name is the reference, upper or lower.
        front: the keys of front matter that name this arm.
        lines: the places (cell, line) of all that it was taken from: data, not claims.
        products: those of them where a product shows its factors; of exponentials, where it, its axes and its pose at zero stand.
        several_tools: whether the table shows more end effectors than this arm's.
        is_part: whether the document speaks of joints behind its last one.
        mended: the links, from 1, whose printed matrices are none, and would be with another entry.
        in_words: whether the text names the arm of the Jacobian that it was taken from.
        rivals: the front matter of other arms of which as much holds, where the text tells of the arm.
        told_by: the joint whose equation must hold before anything is refuted for it, where a law of cosines gave it.
    """

    name: str
    line: int
    source: str
    convention: str
    transforms: str
    front: Mapping[str, Any]
    cell: int | None = None
    lines: frozenset[tuple[int | None, int]] = frozenset()
    products: frozenset[tuple[int | None, int]] = frozenset()
    several_tools: bool = False
    is_part: bool = False
    told_by: str = ""
    mended: frozenset[int] = frozenset()
    in_words: bool = False
    rivals: tuple[Mapping[str, Any], ...] = ()

    def __str__(self) -> str:
        """Return "arm of the table at line 12, classic DH"."""
        return str(say(Kind.ARM_OF, source=self.source, line=self.line, convention=self.convention))

    @property
    def is_of_screws(self) -> bool:
        """Whether it was taken from a product of exponentials."""
        return self.source == "closed form" and bool(self.products)

    @property
    def front_matter(self) -> str:
        """The YAML that names it, an arm's rows on a line each."""
        import yaml  # which `armproof --help` does without

        return yaml.dump(dict(self.front), default_flow_style=None, sort_keys=False, allow_unicode=True, width=1000)

    def as_json(self) -> dict[str, Any]:
        """Return the arm as the report's JSON writes it."""
        return {
            "name": self.name,
            "line": self.line,
            **({} if self.cell is None else {"cell": self.cell}),
            "from": self.source,
            "convention": self.convention,
            "transforms": self.transforms,
            "front_matter": self.front_matter,
        }


@dataclass(frozen=True)
class DocumentResult:
    """The verdicts of one document, in the order of its displays; DH tables beside them."""

    path: str
    arm: str
    equations: tuple[Record, ...]
    tables: tuple[Record, ...] = ()
    warnings: tuple[str, ...] = ()  # what is doubtful about the arm's own model
    seconds: float = 0.0
    title: str = ""
    inverse: Record | None = None  # the closed-form inverse that the front matter announces, as a whole
    arms: tuple[TakenArm, ...] = ()
    front: Mapping[str, Any] = field(default_factory=dict)  # the front matter, and what was inferred beside it
    remarks: tuple[Finding, ...] = ()  # on how the document was read

    @property
    def passed(self) -> bool:
        """All equations proved, confirmed, defined or (without strict) unchecked, and all errata refuted."""
        return all(record.passes for record in self.records)

    @property
    def told_arm(self) -> str:
        """The arm that it was checked against, in words: its name, or what it was taken from."""
        inferred = [str(arm) for arm in self.arms if arm.source != "front matter"]
        return look_up("; ").join(inferred) or self.arm

    @property
    def claims(self) -> bool:
        """Whether anything in it was decided, beside what is accepted."""
        return any(record.is_decided and not record.is_accepted for record in self.records)

    @property
    def records(self) -> tuple[Record, ...]:
        """All that has a verdict: displays, tables, the inverse as a whole."""
        return (*self.equations, *self.tables, *([self.inverse] if self.inverse is not None else []))

    def passed_strictly(self) -> bool:
        """As `passed`, with something decided and nothing unchecked but remarks and what is accepted."""
        unchecked = any(
            record.verdict is Verdict.UNCHECKED and not (record.is_remark or record.is_accepted)
            for record in self.records
        )
        return self.passed and not unchecked and self.claims

    def as_json(self) -> dict[str, Any]:
        """Return the document as the report's JSON writes it."""
        tables = {"tables": [record.as_json() for record in self.tables]} if self.tables else {}
        return {
            "path": self.path,
            "arm": self.arm,
            "arms": [arm.as_json() for arm in self.arms],
            "passed": self.passed,
            "equations": [record.as_json() for record in self.equations],
            **tables,
            **({"inverse": self.inverse.as_json()} if self.inverse is not None else {}),
            **({"warnings": list(self.warnings)} if self.warnings else {}),
            **({"remarks": [remark.as_json() for remark in self.remarks]} if self.remarks else {}),
        }


@dataclass(frozen=True)
class Failure:
    """A document that could not be checked: why, and in which line, where one is at fault."""

    path: str
    finding: Finding
    line: int | None = None

    @classmethod
    def of(cls, path: Path, error: Exception) -> Failure:
        """Return what an error says of a document."""
        if isinstance(error, DocumentError) and error.path is not None and str(error.path) == str(path):
            return cls(str(path), finding_of(error), error.line)
        return cls(str(path), say(Kind.PROBLEM, reason=str(error)))

    @property
    def reason(self) -> str:
        """Why, in words."""
        return str(self.finding)

    @property
    def message(self) -> str:
        """Why, behind file and line."""
        return located(self.path, self.line, self.reason)

    def as_json(self) -> dict[str, Any]:
        """Return the failure as the report's JSON writes it."""
        findings = [self.finding.as_json()]
        return {"path": self.path, "line": self.line, "message": self.message, "findings": findings}


def summary(results: list[DocumentResult]) -> dict[str, int]:
    """Count the verdicts of all displays; `beyond` counts remarks among the unchecked ones, `accepted`, if any, what authors accept."""
    counts = {verdict.value: 0 for verdict in (Verdict.PROVED, Verdict.CONFIRMED, Verdict.DEFINED, Verdict.REFUTED,
                                               Verdict.UNCHECKED, Verdict.UNREADABLE)} | {"beyond": 0}  # fmt: skip
    for result in results:
        for record in result.equations:
            counts[record.verdict.value] += 1
            counts["beyond"] += record.is_remark
            if record.is_accepted:
                counts["accepted"] = counts.get("accepted", 0) + 1
    return counts
