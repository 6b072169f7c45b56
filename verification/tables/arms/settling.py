"""What an inferred arm was taken from is data: it is defined where a decided claim rests on it, and refutes only what else confirms it."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace

from armproof.verification.document import Display, Document, Table
from armproof.verification.findings import Finding, Kind, say
from armproof.verification.tables.arms.own_letters import has_index_of_another, has_other_sign
from armproof.verification.tables.arms.support import FRAMES, ORDER, TOLD
from armproof.verification.tables.arms.turns import link_of
from armproof.verification.verdict import AXES, HOLDS, EquationResult, Record, Role, TakenArm, Verdict, worst

_DISPUTES = (Kind.CONVENTION_DISPUTED, Kind.COLUMN_UNREAD)


@dataclass(frozen=True)
class Inference:
    """A document whose front matter names the arm that it shows, and what that was taken from; or why there is none.

    `unfit` is the arm as its link matrices are printed, where nothing else holds with it: one of them may hold a slip.
    """

    document: Document
    arm: TakenArm | None = None
    problem: Finding | None = None
    line: int | None = None  # of what gives no arm, or not one
    unfit: Inference | None = None

    @property
    def is_disputed(self) -> bool:
        """Whether the document shows an arm of which its words say something else: what it defines is that of neither."""
        return self.arm is None and self.problem is not None and self.problem.kind in _DISPUTES


def settle_data(
    inferred: Inference, equations: Iterable[Record], tables: Iterable[Record]
) -> tuple[tuple[Record, ...], tuple[Record, ...]]:
    """Return the records of displays and tables, what the arm was taken from as data among them."""
    equations, tables, taken = tuple(equations), tuple(tables), inferred.arm
    if taken is None:
        if inferred.is_disputed and inferred.problem is not None:
            equations = tuple(_unless_it_rests_on(inferred.problem, record) for record in equations)
        return _told(inferred, equations), _told(inferred, tables)
    claims = [each for record in equations for each in record.outcomes if not _is_data(taken, record, each.links)]
    confirmed = frozenset(link for each in claims if each.verdict in HOLDS for link in each.links)
    settled = _Settled(
        taken,
        confirmed,
        any(_is_sure(taken, each, confirmed) for each in claims) or _shown_twice(taken, tables),
        {key: each.links for each in claims for key in each.defines},
        _never_as_usual(inferred, equations),
        _against(taken, equations, confirmed),
        _in_several_entries(taken, equations),
    )
    return tuple(map(settled.display, equations)), tuple(map(settled.table, tables))


def _against(taken: TakenArm, records: Iterable[Record], confirmed: frozenset[int]) -> Mapping[int, frozenset[int]]:
    """Return, for each link, the lines that do not hold of it: of a printed matrix those that another one would make right."""
    found: dict[int, frozenset[int]] = {}
    for record in records:
        for each in record.outcomes if not record.erratum else ():
            if each.is_of_no_arm:  # whatever the arm is: that speaks against none of its links
                continue
            of_matrices = taken.source == "matrices"
            own = _links_at_fault(each, record, confirmed) | (each.against - confirmed)
            links = own if of_matrices else each.links
            if ORDER in links - confirmed:  # another order of the joints would make it right: it tells of that alone
                links = frozenset({ORDER})
            for link in links if each.verdict is Verdict.REFUTED else ():
                found[link] = found.get(link, frozenset()) | {record.line}
    return found


def _in_several_entries(taken: TakenArm, records: Iterable[Record]) -> Mapping[int, frozenset[int]]:
    """Return, for each printed link matrix, the lines that do not hold with it in more than one entry: it, or they, may be wrong."""
    found: dict[int, frozenset[int]] = {}
    for record in records if taken.source == "matrices" else ():
        for each in record.outcomes if not record.erratum else ():
            several = sum(entry.equation == each.index for entry in record.entries) > 1
            for link in each.links if several and each.verdict is Verdict.REFUTED else ():
                found[link] = found.get(link, frozenset()) | {record.line}
    return found


def _links_at_fault(result: EquationResult, record: Record, confirmed: frozenset[int]) -> frozenset[int]:
    """Return the links of which nothing holds and of which another one makes a pose right that several entries would have to mend."""
    wrong = [entry for entry in record.entries if entry.equation == result.index]
    links = result.explained_by or frozenset()
    return links - confirmed if len(wrong) > 1 and links and min(links) > 0 else frozenset()


def _is_sure(taken: TakenArm, claim: EquationResult, confirmed: frozenset[int]) -> bool:
    """Whether a claim is decided by the arm, and not only other than what that was taken from."""
    if claim.verdict in HOLDS:
        return bool(claim.links or claim.usual)
    is_own = taken.source == "matrices" and not claim.links & taken.mended
    sure = is_own or {link for link in claim.links if link > 0} <= confirmed
    return claim.is_decided and bool(claim.links) and sure


def _never_as_usual(inferred: Inference, records: Iterable[Record]) -> frozenset[str]:
    """Return the names that convention binds, and of which nothing holds while several displays are refuted, not only beside the arm's source.

    They are not what they were taken for: x and y of a planar arm in a section of its own.
    """
    taken = inferred.arm
    assert taken is not None
    parts: list[Display | Table] = [*inferred.document.displays, *inferred.document.tables]
    here = {each.section for each in parts if (each.cell, each.line) in taken.lines}
    refuted: dict[str, set[tuple[int, int]]] = {}
    held: set[str] = set()
    for record in records:
        for outcome in record.outcomes:
            if outcome.verdict in HOLDS:
                held |= outcome.usual.keys()
            is_number = any(each.kind is Kind.WRONG_THERE for each in outcome.findings)  # worked out from what is above
            is_wrong = outcome.verdict is Verdict.REFUTED and record.section not in here and not is_number
            for key in outcome.usual if is_wrong else ():
                refuted.setdefault(key, set()).add((record.cell or 0, record.line))
    return frozenset(key for key, places in refuted.items() if len(places) > 1 and key not in held)


def _shown_twice(taken: TakenArm, tables: Iterable[Record]) -> bool:
    """Whether a table says the same as what the arm was taken from: link matrices, a closed form."""
    return any(table.verdict in HOLDS and not _is_data(taken, table) for table in tables)


def _told(inferred: Inference, records: tuple[Record, ...]) -> tuple[Record, ...]:
    """Say of a table or a matrix why no arm was taken from it."""
    if (problem := inferred.problem) is None:
        return records
    return tuple(
        replace(
            record, findings=(problem, *(each for each in record.findings if each.kind is not Kind.NO_ARM_FOR_TABLE))
        )
        if record.line == inferred.line and record.verdict is Verdict.UNCHECKED
        else record
        for record in records
    )


def _unless_it_rests_on(problem: Finding, record: Record) -> Record:
    """Leave open what a document says of an arm that its text denies: what its displays define, and what is made of that."""
    if record.erratum:
        return record
    rests = [each.verdict is Verdict.DEFINED or (each.verdict in HOLDS and bool(each.uses)) for each in record.outcomes]
    if not any(rests):
        return record
    outcomes = tuple(
        replace(each, verdict=Verdict.UNCHECKED, findings=(problem,)) if is_open else each
        for each, is_open in zip(record.outcomes, rests, strict=True)
    )
    return replace(
        record,
        outcomes=outcomes,
        verdict=worst([each.verdict for each in outcomes]),
        findings=(problem, *record.findings),
    )


def _is_data(taken: TakenArm, record: Record, links: frozenset[int] = frozenset()) -> bool:
    """Whether the arm was taken from a table, or from the equation in a display that is about these links."""
    place = (record.cell, record.line)
    count = len(taken.front["arm"]["rows"]) if "arm" in taken.front else 0
    of_tool = bool(links) and not (FRAMES in links and max(links) < count)  # of another point it is no source
    is_source = {"table": True, "matrices": len(links) == 1 or place in taken.products}.get(taken.source, of_tool)
    return place in taken.lines and is_source


def _is_of_any_arm(result: EquationResult) -> bool:
    slips = (Kind.SLIP_OF_ANY_JACOBIAN, Kind.SLIP_FOR_EACH_JOINT, Kind.SLIP_AS_VECTORS)
    return any(each.kind in slips for each in result.findings)


@dataclass(frozen=True)
class _Settled:
    """The records of a document whose arm was taken from a part of it.

    Attributes:
        confirmed: the links of which something that is no data holds.
        is_used: whether anything else is decided with this arm.
        named: what defined names tell of.
        never_as_usual: the names that convention binds and that are none of the arm's.
        against: the lines that do not hold, for each link that they tell of.
        in_doubt: those that do not hold of a link in several entries.
    """

    taken: TakenArm
    confirmed: frozenset[int]
    is_used: bool
    named: Mapping[tuple[str, int], frozenset[int]]
    never_as_usual: frozenset[str] = frozenset()
    against: Mapping[int, frozenset[int]] = field(default_factory=dict)
    in_doubt: Mapping[int, frozenset[int]] = field(default_factory=dict)

    def table(self, record: Record) -> Record:
        """Return the record of a table: data, or another table, which is not refuted by this one."""
        if _is_data(self.taken, record):
            data = self._data(1, frozenset(self.against) - {FRAMES, 0})
            return Record(
                record.line, record.latex, data.verdict, record.erratum, data.findings, (data,), cell=record.cell,
                section=record.section, file=record.file,
            )  # fmt: skip
        if record.verdict is Verdict.REFUTED and not record.erratum:
            other = say(Kind.SECOND_TABLE, source=self.taken.source, line=self.taken.line)
            return replace(record, verdict=Verdict.UNCHECKED, findings=(other, *record.findings), corrections=None)
        return record

    def display(self, record: Record) -> Record:
        """Return the record of a display."""
        if not record.outcomes:  # a table that is set as an array, or what was not read
            return self.table(record) if record.verdict in (*HOLDS, Verdict.REFUTED) else record
        outcomes = tuple(self._outcome(each, record) for each in record.outcomes)
        verdict = worst([each.verdict for each in outcomes])
        findings = list(record.findings)
        if outcomes != record.outcomes:
            findings = [finding for each in outcomes if each.verdict is verdict for finding in each.findings]
        if any(each.is_decided and each.links for each in outcomes):
            findings.append(say(Kind.FOR_ARM_OF, source=self.taken.source, line=self.taken.line))
        corrections = record.corrections if verdict is record.verdict else None
        return replace(record, outcomes=outcomes, verdict=verdict, findings=tuple(findings), corrections=corrections)

    def _outcome(self, result: EquationResult, record: Record) -> EquationResult:
        """Return an equation's result; unchecked where it differs from the source in what nothing else confirms."""
        if result.verdict in (Verdict.UNCHECKED, Verdict.DEFINED) and self._is_of_screws(record):
            return self._data(result.index)
        if result.verdict in HOLDS and _is_data(self.taken, record, result.links):
            return result if result.links <= self.confirmed else self._data(result.index, result.links)
        links = result.links.union(*(self.named.get(key, ()) for key in result.uses))
        doubtful = frozenset(map(link_of, links - self.confirmed))
        is_of_links = bool(doubtful) and min(doubtful) > 0 and (len(doubtful) == 1 or self._is_alone(result, record))
        is_of_links = is_of_links and not doubtful & self._hand
        explained = result.explained_by  # of what is no pose, 0, nobody asked which link would make it right
        if is_of_links and explained is not None and 0 not in explained and not doubtful & explained:
            links, doubtful = self.confirmed & links, frozenset()  # no link in its place makes it right
        has_entry = any(entry.equation == result.index for entry in record.entries)
        has_sides = (
            bool(links) or has_entry or result.role is Role.CONDITION
        )  # else a shape, or an inverse that this arm's Jacobian does not have
        is_own = self.taken.source == "matrices" and not (links - self.confirmed) & self.taken.mended
        is_own = is_own and not _links_at_fault(result, record, self.confirmed)
        is_slip = self._is_slip(links, result, record) or self._is_off_its_place(doubtful, result, record)
        is_slip = is_slip or self._has_slip_in_length(doubtful, result, record)
        is_sure = has_sides and (is_own or not doubtful or is_slip)
        is_sure = is_sure and (not self.taken.told_by or TOLD in self.confirmed)
        is_sure = is_sure or result.is_of_no_arm
        if result.verdict is not Verdict.REFUTED or record.erratum or _is_of_any_arm(result):
            return result
        if others := result.usual.keys() & self.never_as_usual:
            doubt = say(Kind.NEVER_AS_USUAL, name=min(others))
            return replace(result, verdict=Verdict.UNCHECKED, findings=(doubt.at(result.index),))
        if is_sure:
            return result
        doubt = say(Kind.OTHER_THAN_SOURCE, source=self.taken.source, line=self.taken.line)
        return replace(result, verdict=Verdict.UNCHECKED, findings=(doubt.at(result.index), *result.findings))

    def _is_of_screws(self, record: Record) -> bool:
        """Whether a display gives axes, the pose at zero or the product of an arm that was taken from these, and nothing speaks against them."""
        kinds = {finding.kind for each in record.outcomes for finding in each.findings}
        is_source = self.taken.is_of_screws and record.place in self.taken.products
        return is_source and kinds.isdisjoint((Kind.OTHER_SCREWS, Kind.CONTRADICTED))

    @staticmethod
    def _is_alone(result: EquationResult, record: Record) -> bool:
        """Whether one entry alone of a pose is wrong: other links would be seen in more."""
        wrong = [entry for entry in record.entries if entry.equation == result.index]
        return [bool(each.row) for each in wrong] == [True] and 0 not in (result.explained_by or ())

    def _is_slip(self, links: frozenset[int], result: EquationResult, record: Record) -> bool:
        """Whether one entry alone is other than coordinates say that fit together: x = ∂y/∂θ_1, which one slip in them would break."""
        wrong = [entry for entry in record.entries if entry.equation == result.index]
        is_pinned = self.taken.source == "closed form" and not (self.taken.mended or self.taken.told_by)
        alone = all(len(self.against.get(link, ())) < 2 for link in links)
        if not is_pinned or not alone or len(wrong) != 1:
            return False
        is_told = wrong[0].finding is not None
        if not wrong[0].row:  # a formula: what nothing pins of the coordinates may be what is wrong
            return is_told and links - self.confirmed <= self._pinned
        return FRAMES not in links - self.confirmed or is_told

    def _is_off_its_place(self, doubtful: frozenset[int], result: EquationResult, record: Record) -> bool:
        """Whether one coordinate alone of a pose is wrong that holds elsewhere: in another frame's the others would be, too."""
        wrong = [entry for entry in record.entries if entry.equation == result.index]
        if doubtful != {FRAMES} or len(wrong) != 1 or wrong[0].column != 4 or not wrong[0].row:
            return False
        return AXES - (wrong[0].row - 1) in self.confirmed

    def _has_slip_in_length(self, doubtful: frozenset[int], result: EquationResult, record: Record) -> bool:
        """Whether one length of a link alone is other than its row says, which tells what the author calls it."""
        wrong = [entry for entry in record.entries if entry.equation == result.index]
        if self.taken.source != "table" or len(doubtful) != 1 or len(wrong) != 1 or wrong[0].finding is None:
            return False
        link = min(doubtful)
        is_alone = self.against.get(link) == frozenset({record.line})  # else the row may be what is wrong
        return has_index_of_another(self.taken, link, wrong[0]) or (
            is_alone and has_other_sign(self.taken, link, wrong[0])
        )

    @property
    def _pinned(self) -> frozenset[int]:
        """What coordinates tell for certain that fit together: of z only where it turns, and no constant."""
        rows = self.taken.front["arm"]["rows"]
        turns_up = any(str(row["alpha"]) != "0" for row in rows)
        return frozenset({*range(1, len(rows) + 1)} - self._hand | {AXES, AXES - 1, *([AXES - 2] if turns_up else [])})

    @property
    def _hand(self) -> frozenset[int]:
        """The joint that turns a tool behind a slide downwards, either way, of which its coordinates tell nothing."""
        rows = self.taken.front["arm"]["rows"] if self.taken.source == "closed form" else []
        is_turn = bool(rows) and all(rows[-1][column] == 0 for column in ("a", "alpha", "d"))
        return frozenset({len(rows)} if is_turn and any(row["alpha"] == "pi" for row in rows) else ())

    def _data(self, index: int, links: frozenset[int] = frozenset()) -> EquationResult:
        doubts = (
            lines.get(link, frozenset()) for lines in (self.against, self.in_doubt) for link in links - self.confirmed
        )
        lines = sorted(frozenset[int]().union(*doubts))
        is_known = self.taken.in_words or (self.is_used and not lines and not links & self._hand - self.confirmed)
        verdict = Verdict.DEFINED if is_known else Verdict.UNCHECKED
        gives = say(Kind.GIVES_ARM, convention=self.taken.convention)
        doubt = (say(Kind.CONTRADICTED, lines=lines),) if lines and not self.taken.in_words else ()
        return EquationResult(index, Role.DATA, verdict, findings=(gives, *doubt), links=links)
