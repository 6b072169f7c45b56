"""From a document to its verdicts: one record a display, one a DH table."""

from __future__ import annotations

import re
import time
from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import replace
from functools import cached_property, lru_cache, partial
from itertools import accumulate
from operator import methodcaller
from pathlib import Path
from typing import TYPE_CHECKING, Any

from armproof.models.arm import Arm
from armproof.models.catalogue import arm_of, load_arm
from armproof.models.errors import ArmproofError
from armproof.verification.algebra.ring import Ring
from armproof.verification.diagnosis.accepted import with_accepted
from armproof.verification.display.statements import Statements
from armproof.verification.display.taken_arm import OfTakenArm, names_in
from armproof.verification.document import Display, Document, Table, parse_document, read_document
from armproof.verification.document.other_meanings import FRAME
from armproof.verification.document.sentences import not_known_in, quoted
from armproof.verification.equations.chain import ChainChecker, no_samples
from armproof.verification.equations.foreign_index import unless_written_elsewhere
from armproof.verification.equations.index_direction import TWO_SCRIPTS, shown_direction
from armproof.verification.equations.later_definitions import definitions_behind, names_lacking
from armproof.verification.equations.outcome import AsUsual, Outcome, new_one
from armproof.verification.equations.shorthands import Shorthand, own_shorthands, shorthands_in_row
from armproof.verification.errors import DocumentError, NotSampled, ReadError, TooComplex
from armproof.verification.evaluation.exact import ExactAlgebra
from armproof.verification.findings import MISPRINTS, Finding, Kind, finding_of, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.unicode import normalise_unicode, original_offset
from armproof.verification.naming.reading import read_names, spelling_of
from armproof.verification.naming.settled import settle_definitions, settle_used
from armproof.verification.naming.shown import settle_usual
from armproof.verification.naming.state import Definition, Stated, Told
from armproof.verification.tables import TWIST, check_array_table, check_table
from armproof.verification.tables.arms import (
    Inference,
    difference,
    entries_by_place,
    infer_arm,
    joints_used,
    links_of,
    links_that_explain,
    scopes,
    settle_data,
    stated_lengths,
    table_of_named,
    unless_disputed,
    with_armless,
)
from armproof.verification.verdict import (
    DECIDED,
    HOLDS,
    DocumentResult,
    EquationResult,
    IfShown,
    Record,
    SlipBefore,
    TakenArm,
    Verdict,
    worst,
)

if TYPE_CHECKING:
    from armproof.verification.correction.corrector import Corrector
    from armproof.verification.diagnosis.diagnosis import Diagnostician
    from armproof.verification.evaluation.sampled import SampledAlgebra

SECONDS_TO_DECIDE = 1.1  # a display is bounded by two seconds in all: so long to decide it,
SECONDS_TO_EXPLAIN = 0.9  # and so long to say what is wrong in it
WORK_ON_SLIPS = 30_000  # questions of the budget about slips in what is said before: counted, a verdict may rest on one
SECONDS_ON_SLIPS = 3.0  # for where a question takes longer than anywhere


def verify(path: Path | str, *, confirm: bool = True, correct: bool = False) -> DocumentResult:
    """Return the verdicts of a document file; raises DocumentError where the document as a whole cannot be checked."""
    return check_document(read_document(Path(path)), confirm=confirm, correct=correct)


def verify_text(
    text: str, format: str = "", *, path: Path | str = "document.md", confirm: bool = True, correct: bool = False
) -> DocumentResult:
    """Return the verdicts of a document's text, as `verify` does of a file that holds it.

    Args:
        text: the document, front matter and all.
        format: how it is read: md, qmd, ipynb, py, tex or rst; by default as the name of `path` says.
        path: the file that it belongs to, which need not exist: it names the document in the result and in messages, and
            arms that are given by a relative path are sought from its folder.
        confirm, correct: as for `check_document`.

    Raises:
        DocumentError: the document as a whole cannot be checked.
    """
    return check_document(
        parse_document(Path(path), text.removeprefix("\ufeff"), format), confirm=confirm, correct=correct
    )


def check_document(
    document: Document, *, confirm: bool = True, correct: bool = False, arm: Arm | None = None, samples: bool = True
) -> DocumentResult:
    """Return the verdicts of a document.

    Args:
        document: what was read.
        confirm: also evaluate each proved equation on the double plant.
        correct: also seek what mends each refuted one.
        arm: the document's arm, such as one read from a value; by default the one that its front matter names.
        samples: whether samples may be taken. Without them neither NumPy nor Drake is needed, and what they alone
            decide is unchecked.
    """
    seeks = arm is None and ("arms" in document.front or (samples and "arm" not in document.front))
    parts = [infer_arm(part) for part in scopes(document)] if seeks else [Inference(document)]
    options = confirm and samples, correct and samples, samples
    results = [DocumentChecker(p.document, arm or load_arm_of(p.document), *options, p).run() for p in parts]
    results = [_unless_of_another_arm(k, parts, result) for k, result in enumerate(results)] if samples else results
    if seeks and samples:
        results = [unless_disputed(part, result, plainly) for part, result in zip(parts, results, strict=True)]
        results = [with_armless(part, result, plainly) for part, result in zip(parts, results, strict=True)]
    result = results[0] if len(results) == 1 else joined(document, results)
    return with_accepted(document, result) if document.accepts else result


def plainly(part: Inference) -> DocumentResult:
    """Return the verdicts of a part of a document, and nothing that takes time to find out besides."""
    return DocumentChecker(part.document, load_arm_of(part.document), False, False, True, part).run()


def _unless_of_another_arm(place: int, parts: Sequence[Inference], result: DocumentResult) -> DocumentResult:
    """Leave open what is refuted in the part of one arm, and holds of another that the document shows."""
    refuted = any(each.verdict is Verdict.REFUTED and not each.erratum for each in result.equations)
    others = [(part, part.arm) for k, part in enumerate(parts) if k != place and part.arm is not None]
    if parts[place].arm is None or not refuted:
        return result
    for part, arm in others:
        there = replace(part.document, displays=parts[place].document.displays, tables=())
        records = plainly(replace(part, document=there))
        holding = {each.place for each in records.equations if each.verdict in HOLDS}
        doubt = say(Kind.HOLDS_OF_OTHER_ARM, line=arm.line)
        found = (
            each.left_open(doubt, lambda one: one.verdict is Verdict.REFUTED) if each.place in holding else each
            for each in result.equations
        )
        result = replace(result, equations=tuple(found))
    return result


def joined(document: Document, results: Sequence[DocumentResult]) -> DocumentResult:
    """Return the results of a document's parts as one: each record keeps the index of its arm among all of them."""
    before = list(accumulate((len(result.arms) for result in results), initial=0))
    counted = list(zip(results, before, strict=False))
    return replace(
        next((result for result in results if result.arms), results[0]),
        equations=tuple(_moved(record, first) for result, first in counted for record in result.equations),
        tables=tuple(_moved(record, first) for result, first in counted for record in result.tables),
        seconds=sum(result.seconds for result in results),
        arms=tuple(arm for result in results for arm in result.arms),
        front=document.front,
        remarks=tuple(dict.fromkeys(remark for result in results for remark in result.remarks)),
    )


def _moved(record: Record, first: int) -> Record:
    return record if record.arm_index is None else replace(record, arm_index=record.arm_index + first)


def load_arm_of(document: Document) -> Arm | None:
    """Return the arm that a document's front matter names; raises DocumentError where that cannot be loaded."""
    try:
        return arm_of(document.front, document.path.parent)
    except ArmproofError as error:
        raise document.fault("arm" if "arm" in document.lines else "arms", error) from None


@lru_cache(maxsize=16)
def _difference(name: str, table: Table) -> Finding | None:
    about = DocumentChecker(Document(Path(), {}, (), (table,)), load_arm(name), confirm=False)
    return difference(about.checker, name, table)


class DocumentChecker:
    """Checks the displays of one document in order, each with the names that those before it defined."""

    def __init__(
        self,
        document: Document,
        arm: Arm | None,
        confirm: bool = True,
        correct: bool = False,
        samples: bool = True,
        inferred: Inference | None = None,
    ) -> None:
        self.document = document
        self.arm = arm
        self.inferred = inferred or Inference(document)
        try:
            self.names = read_names(arm, document.front)
        except DocumentError as error:
            raise document.fault(error.key or "quantities", error) from None
        self.names = replace(self.names, is_part=self.inferred.arm is not None and self.inferred.arm.is_part)
        self.names = replace(self.names, lacks_base=self._lacks_base())
        if self._shown_transforms:  # by what the arm was taken from, and not stated by the author
            self.names = replace(self.names, stated_transforms="")
        self.names.reader.spelling = spelling_of(document, self.names.reader.words)
        self.ring = Ring()
        if arm is not None:  # any numbers, as lengths are, until a display says which
            self.names.state.adopted |= {key for key in self.names.reader.spelling.masses if self._is_unknown(key)}
        self.exact = ExactAlgebra(self.ring, arm)
        self.checker = ChainChecker(self.names, self.exact, self.sampled)
        self.checker.confirm = confirm
        self.statements = Statements(self.checker)
        self._lacked: set[tuple[int, str]] = set()
        self.correct = correct
        self.samples = samples
        self.direction = self.direction_in(document)
        self.names.state.transforms = self._shown_transforms or self.direction[0]
        self.lengths = self.lengths_in(document)
        self.names.state.configuration.update(self.lengths)
        self._name_entries()
        self.shorthands = self.shorthands_in(document)
        self.names.state.own_shorthands = self.shorthands

    def _lacks_base(self) -> bool:
        """Whether the arm was taken from the links behind the first ones, of which the document speaks, too."""
        if self.inferred.arm is None or self.arm is None:
            return False
        first = self.arm.frames[0]
        return first.isdigit() and any(0 < joint <= int(first) for joint in joints_used(self.document.displays))

    def _is_unknown(self, key: str) -> bool:
        return self.names.known_symbol(key) is None and key not in self.names.quantities

    @cached_property
    def _shown_transforms(self) -> str:
        """Which index names the reference, as what the arm was taken from shows it; else an empty text."""
        return str(self.inferred.arm.front.get("transforms", "")) if self.inferred.arm is not None else ""

    def shorthands_in(self, document: Document) -> frozenset[Shorthand]:
        """Return the shorthands that the text of a document says to be something else than they usually are."""
        said = [text for display in document.displays for text in (*display.said, *display.said_behind)]
        said += [equation for table in document.tables for row in table.rows for equation in shorthands_in_row(row)]
        with suppress(TooComplex), self.ring.budget.of(SECONDS_TO_DECIDE):
            return frozenset(own_shorthands(self.checker.members, said)) if said else frozenset()
        return frozenset()

    def direction_in(self, document: Document) -> tuple[str, int]:
        """Return which index names the reference, as a document's first link matrix shows it, and its line; else ("", 0)."""
        if self._shown_transforms:
            return "", 0
        displays = [display for display in document.displays if TWO_SCRIPTS.search(normalise_unicode(display.latex))]
        try:
            with self.ring.budget.of(SECONDS_TO_DECIDE):
                return (shown_direction(self.checker, displays) if displays else None) or ("", 0)
        except TooComplex:
            return "", 0

    def lengths_in(self, document: Document) -> dict[str, Stated]:
        """Return the values that a document's DH tables give lengths beside their letters."""
        if not document.tables and not any(TWIST.search(display.latex) for display in document.displays):
            return {}
        with self.ring.budget.of(SECONDS_TO_DECIDE):
            return stated_lengths(document, self.names, self.exact)

    def _name_entries(self) -> None:
        """Let a_2 and d_3 be the numbers of the rows of the table that the arm was taken from."""
        taken = self.inferred.arm
        with self.ring.budget.of(SECONDS_TO_DECIDE):
            for key, value in (
                entries_by_place(self.document, taken, self.names, self.exact) if taken is not None else ()
            ):
                self.names.define(key, methodcaller("rational", value), taken.line if taken else 0, by_table=True)

    def sampled(self) -> SampledAlgebra:
        """The double plant at the configurations of the six families; raises NotSampled where none may be taken."""
        if not self.samples:
            no_samples()
        return self._samples

    # What samples, explains or corrects is loaded where there is something to sample, to explain, to correct.

    @cached_property
    def _samples(self) -> SampledAlgebra:
        with self.ring.budget.paused():
            from armproof.verification.evaluation.sampled import plant_samples

            return plant_samples(self.exact)

    @cached_property
    def diagnostician(self) -> Diagnostician:
        """Says what is wrong with a refuted display."""
        with self.ring.budget.paused():
            from armproof.verification.diagnosis.diagnosis import Diagnostician

            if not self.samples:
                return Diagnostician(self.checker)
            from armproof.verification.diagnosis.by_samples import BySamples

            return Diagnostician(self.checker, BySamples(self.checker))

    @cached_property
    def corrector(self) -> Corrector:
        """Seeks what mends a refuted display."""
        with self.ring.budget.paused():
            from armproof.verification.correction.corrector import Corrector

            return Corrector(self.checker, self.diagnostician, self._outcomes_of)

    def run(self) -> DocumentResult:
        """Return the verdicts of all displays and tables, in the order of the document."""
        started = time.perf_counter()
        equations = tuple(self.check_display(display) for display in self.document.displays)
        return replace(self.result_of(equations), seconds=time.perf_counter() - started)

    def result_of(self, equations: tuple[Record, ...]) -> DocumentResult:
        """Return the document's result for the records of its displays; its tables are checked with the names of them all."""
        tables = tuple(record for table in self.document.tables if (record := self._table(table)) is not None)
        if any(record.if_shown is not None for record in equations):
            equations = settle_usual(equations)
        if any(each.order for record in equations for each in record.outcomes):
            from armproof.verification.equations.argument_order import settle_orders

            equations = settle_orders(equations)
        if self._has_definitions(equations):
            equations = settle_used(settle_definitions(equations, self._tells))
        if self.inferred.arm is not None or self.inferred.problem is not None:
            equations, tables = settle_data(self.inferred, equations, tables)
        if self._has_definitions(equations):  # what was refuted by an arm that nothing confirms may have used them
            equations = settle_used(equations)
        index = None if self.arm is None else 0
        return DocumentResult(
            str(self.document.path),
            self.arm.name if self.arm is not None else "",
            tuple(replace(record, arm_index=index) for record in equations),
            tuple(replace(record, arm_index=index) for record in tables),
            self.arm.warnings if self.arm is not None else (),
            title=str(self.document.front.get("title", "")),
            inverse=self._inverse(),
            arms=self._arms(),
            front=self.document.front,
            remarks=(*self.document.remarks, *self._named()),
        )

    @staticmethod
    def _has_definitions(records: Sequence[Record]) -> bool:
        outcomes = (each for record in records for each in record.outcomes)
        return any(each.defines or each.uses or each.verdict is Verdict.DEFINED for each in outcomes)

    def _arms(self) -> tuple[TakenArm, ...]:
        if self.inferred.arm is not None or self.arm is None:
            return (self.inferred.arm,) if self.inferred.arm is not None else ()
        spec: dict[str, Any] = {k: v for k, v in self.document.front.items() if k in ("arm", "transforms")}
        convention = self.arm.dh.convention if self.arm.dh is not None else ""
        line = self.document.lines.get("arm") or self.document.lines.get("arms", 1)
        return (TakenArm(self.arm.name, line, "front matter", convention, self.names.transforms, spec),)

    def _named(self) -> Iterator[Finding]:
        """Yield how the document's table differs from an arm of the catalogue that its text names, but its front matter does not."""
        by_author = self.inferred.arm is None and self.arm is not None
        table = table_of_named(self.document) if self.samples and not by_author else None
        if table is not None:
            yield from filter(None, (_difference(name, table) for name in self.document.named))

    def _inverse(self) -> Record | None:
        if "inverse" not in self.document.front:
            return None
        if not self.samples:
            line = self.document.lines.get("inverse", 1)
            left_open = (say(Kind.NOT_SAMPLED),)
            return Record(line, "", Verdict.UNCHECKED, section="Inverse kinematics", findings=left_open)
        from armproof.verification.inverse.document import check_inverse

        return check_inverse(self.document, self.names)

    def _table(self, table: Table) -> Record | None:
        with self.ring.budget.of(SECONDS_TO_DECIDE):
            record = check_table(self.checker, table)
        if record is None or record.verdict is not Verdict.REFUTED or not self.correct:
            return record
        from armproof.verification.correction.tables import correct_table

        with self.ring.budget.of(SECONDS_TO_DECIDE):
            return replace(record, corrections=correct_table(self.checker, table, record))

    # -- displays ---------------------------------------------------------------------------------------------------

    def check_display(self, display: Display) -> Record:
        """Return the record of one display; what it lacks may be said right behind it."""
        record = again = self._check(display)
        if record.verdict is not Verdict.UNCHECKED:
            return record
        after, missing = self.names.state.copy() if names_lacking(record) else None, frozenset[str]()
        while new := names_lacking(again) - missing:
            missing |= new
            behind = definitions_behind(self.document.displays, display, missing, self.names.reader)
            if not behind:
                break
            for each in (*behind, display):
                again = self._check(each)
        if after is not None:
            self._lacked.add((display.line, display.latex))
            self.names.state.become(after)
        return again if again.verdict in DECIDED else record

    def lacked(self, display: Display) -> bool:
        """Whether a display lacked names by what stands above it."""
        return (display.line, display.latex) in self._lacked

    def _check(self, display: Display) -> Record:
        """Return the record of one display by what stands above it."""
        record = Record(
            display.line,
            display.latex,
            Verdict.UNREADABLE,
            display.erratum,
            cell=display.cell,
            section=display.section,
            file=display.file,
        )
        if not display.closed:
            return replace(record, findings=(say(Kind.NEVER_ENDS, opening=display.opening),))
        self.names.state.enter(display.section)
        self.names.state.listed = display.listed
        self.ring.forget_signs()
        try:
            with self.ring.budget.of(SECONDS_TO_DECIDE):
                if display.said:
                    self.statements.claims.circumstances.heed(
                        display.said, display.said_above, display.said_outside, display.line
                    )
                if TWIST.search(display.latex) and (table := check_array_table(self.checker, display)) is not None:
                    return self._with_array_corrected(table, display)
                statements = self.names.reader.read(display.latex)
                if display.erratum and self.arm is None:  # it is quoted: what the text around says is not said of it
                    self.names.state.told = Told()
                if display.said_behind:
                    self.statements.claims.circumstances.heed_behind(display.said_behind, statements, display.line)
                return self._judge(record, display, statements)
        except ReadError as error:
            return replace(record, findings=(_unreadable(display, error),))
        except NotSampled as error:
            return replace(record, verdict=Verdict.UNCHECKED, findings=(finding_of(error),))
        except TooComplex as error:
            return replace(
                record, verdict=Verdict.UNCHECKED, findings=(say(Kind.TOO_LARGE, problem=finding_of(error)),)
            )
        except RecursionError:
            return replace(record, verdict=Verdict.UNCHECKED, findings=(say(Kind.NESTED_TOO_DEEPLY),))
        except Exception as error:  # a fault of ours must not cost the other displays their verdicts
            return replace(record, findings=(say(Kind.INTERNAL_ERROR, type=type(error).__name__, reason=str(error)),))

    def _judge(self, record: Record, display: Display, statements: list[n.Statement]) -> Record:
        outcomes, extra = self._with_later_definitions(statements, display)
        outcomes = [self._as_words_say(outcome, display) for outcome in outcomes]
        if not outcomes:
            return replace(record, verdict=Verdict.UNCHECKED, findings=(say(Kind.NO_EQUATION), say(Kind.BEYOND)))
        if self.direction == ("lower", display.line):
            outcomes[0].also(say(Kind.LOWER_IS_REFERENCE))
        if self.inferred.arm is not None:
            of_taken_arm = OfTakenArm(self.checker, self.document, self.inferred.arm)
            outcomes = [of_taken_arm.judge(outcome) for outcome in outcomes]
        outcomes = [
            unless_written_elsewhere(each, display, self.document) if each.tells(Kind.NO_SUCH_LENGTH) else each
            for each in outcomes
        ]
        slips = [self._with_slip(outcome, display) for outcome in outcomes]
        for place, slip in enumerate(slips):
            if slip is not None and not slip.meanings:  # what the text says is so: this follows from it but for a slip
                outcomes[place] = slip.outcome
        found = self._told(record, display, statements, outcomes, extra)
        meanings = {key: meant for slip in slips if slip is not None for key, meant in slip.meanings.items()}
        if not meanings:
            return found
        usual = [each if slip is None else slip.outcome for each, slip in zip(outcomes, slips, strict=True)]
        self.names.state.inferred |= meanings
        told = self._told(record, display, statements, usual, extra)
        self.names.state.forget_usual(meanings)
        of_another = any(slip.of_another for slip in slips if slip is not None)
        return replace(found, if_shown=IfShown(told, meanings, of_another))

    def _as_words_say(self, outcome: Outcome, display: Display) -> Outcome:
        """Leave open what the words around a display say to be so elsewhere, in a case, of another point, or not at all."""
        if display.said_next and not display.erratum:
            outcome = self.statements.claims.circumstances.judge_behind(outcome, display.said_next)
        if display.supposed:
            outcome = outcome.unless_refuted(say(Kind.IS_SUPPOSED))
        if display.of_other_point or (display.meant and self._is_of_other_frame(display)):
            outcome = self._unless_of_the_tool(outcome)
        if display.in_other_frame and outcome.verdict in DECIDED and any(map(self._is_in_base, names_in(outcome))):
            outcome = outcome.left_open(say(Kind.OF_OTHER_POINT))
        if display.meant and not display.erratum and outcome.verdict in DECIDED:
            outcome = self.statements.claims.circumstances.unless_meant_otherwise(outcome, display.meant)
        if display.denied and outcome.verdict is not Verdict.UNCHECKED:
            outcome = replace(outcome.left_open(say(Kind.DENIED)), defines=())
        if display.strange and outcome.verdict is not Verdict.UNCHECKED:
            words = ", ".join(not_known_in(display.strange))
            outcome = outcome.left_open(say(Kind.STRANGE_WORDS, text=quoted(display.strange), words=words))
        return outcome

    def _is_of_other_frame(self, display: Display) -> bool:
        """Whether the sentence beside a display is of the origin of another frame than the last."""
        frames = {each.partition(" ")[2] for each in display.meant if each.startswith(FRAME)}
        return self.arm is not None and bool(frames - {self.arm.frames[-1]})

    def _is_in_base(self, name: n.Name) -> bool:
        """Whether a name is taken as of the base, and no index and no front matter says so."""
        return (
            name.key not in self.names.quantities
            and self.names.quantity(name) is not None
            and not re.search(r"\^|_[bs]\b", name.key)
        )

    def _unless_of_the_tool(self, outcome: Outcome) -> Outcome:
        """Leave open what is decided by a name that convention alone binds to the tool, where the text speaks of another point."""
        by_convention = self.names.state.conventional | ({"J"} - {*self.names.quantities})
        named = {replace(name, dots=0).key for name in names_in(outcome)} & by_convention
        is_open = outcome.as_usual is None and all(re.search(r"[\d^]|_[bs]\b", key) for key in named)
        if is_open or (outcome.as_usual is None and outcome.verdict not in DECIDED):
            return outcome
        return replace(outcome.left_open(say(Kind.OF_OTHER_POINT)), as_usual=None)

    def _told(
        self,
        record: Record,
        display: Display,
        statements: list[n.Statement],
        outcomes: list[Outcome],
        extra: dict[str, float],
    ) -> Record:
        """Return the record of a display with what became of its equations, and why."""
        judged = self._explained(self._record_of(record, outcomes, extra), display, outcomes)
        if judged.verdict is Verdict.REFUTED and self.correct:
            judged = replace(judged, corrections=self.corrector.correct(judged, statements, outcomes))
        found = [self._result(outcome, judged) for outcome in outcomes]
        if display.erratum:
            return replace(judged, outcomes=tuple(found))
        if judged.verdict is not Verdict.REFUTED:
            return self._by_slip_before(replace(judged, outcomes=tuple(found)), display, outcomes)
        with suppress(TooComplex), self.ring.budget.of(SECONDS_ON_SLIPS, WORK_ON_SLIPS):
            for place, outcome in enumerate(outcomes):
                may_slip = frozenset(filter(self._may_slip, outcome.uses))
                found[place] = replace(found[place], may_slip=may_slip)
                found[place] = replace(found[place], slip_before=self._slip_before(outcome, judged, display))
        return replace(judged, outcomes=tuple(found))

    def _by_slip_before(self, record: Record, display: Display, outcomes: Sequence[Outcome]) -> Record:
        """Return the record of a display that says a name anew, as it would be with one slip in what is said of that before."""
        found = list(record.outcomes)
        with suppress(TooComplex), self.ring.budget.of(SECONDS_ON_SLIPS, WORK_ON_SLIPS):
            for place, outcome in enumerate(outcomes):
                is_open = outcome.verdict in (Verdict.UNCHECKED, Verdict.DEFINED)
                if is_open and outcome.tells(Kind.SECOND_MEANING) and outcome.uses:
                    again = partial(self._holds_again, display, outcome.equation)
                    slip = self.diagnostician.slip_before(record, outcome, again)
                    found[place] = replace(found[place], slip_before=slip)
        return replace(record, outcomes=tuple(found))

    def _record_of(self, record: Record, outcomes: Sequence[Outcome], extra: dict[str, float]) -> Record:
        """Return the record with the verdict of a display's outcomes, and what they say."""
        verdict = worst([outcome.verdict for outcome in outcomes])
        leading = [outcome for outcome in outcomes if outcome.verdict is verdict]
        errors = [outcome.max_error for outcome in outcomes if outcome.max_error is not None]
        return replace(
            record,
            verdict=verdict,
            findings=tuple(finding.at(outcome.equation) for outcome in leading for finding in outcome.findings),
            samples=max((outcome.samples for outcome in outcomes), default=0),
            max_error=max(errors, default=None),
            counterexample=extra,
        )

    def _explained(self, record: Record, display: Display, outcomes: Sequence[Outcome]) -> Record:
        """Return a refuted record with what is wrong."""
        if record.verdict is not Verdict.REFUTED:
            return record
        refuted = [outcome for outcome in outcomes if outcome.verdict is Verdict.REFUTED]
        try:
            with self.ring.budget.of(SECONDS_TO_EXPLAIN):
                return self.diagnostician.diagnose(record, normalise_unicode(display.latex), refuted)
        except TooComplex:
            return replace(record, findings=record.findings or (say(Kind.TOO_LARGE_TO_TELL),))

    def _slip_before(self, outcome: Outcome, record: Record, display: Display) -> SlipBefore | None:
        """Return the slip in a definition before with which a refuted equation holds, or None."""
        if outcome.verdict is not Verdict.REFUTED or not outcome.uses:
            return None
        again = partial(self._holds_again, display, outcome.equation)
        return self.diagnostician.slip_before(record, outcome, again)

    def _tells(self, record: Record, slip: SlipBefore) -> bool:
        """Whether a display that holds does so as it stands, and not if a definition has a slip: it clears it of that."""
        made = self.names.state.definitions
        before = made.get(slip.name)
        if before is None or before.line != slip.line or not isinstance(slip.formula, n.Node):
            return True
        with_slip = replace(before, evaluate=self.checker.members.meaning(slip.formula))
        return self._holds_where(record, slip.name, before) and not self._holds_where(record, slip.name, with_slip)

    def _may_slip(self, key: tuple[str, int]) -> bool:
        """Whether what is said of a name claims something: a list of letters does not, F = (F_x, F_y)."""
        before = self.names.state.definitions.get(key[0])
        if before is None or before.line != key[1] or before.formula is None:
            return False
        from armproof.verification.diagnosis.slips_before import names_alone

        return not names_alone(before.formula)

    def _holds_where(self, record: Record, name: str, meaning: Definition) -> bool:
        before = self.names.state.definitions[name]
        self.names.state.definitions[name] = meaning
        try:
            with self.ring.budget.of(SECONDS_TO_EXPLAIN):
                return all(each.verdict in HOLDS for each in self._outcomes_of(record.latex))
        except (ArmproofError, RecursionError):
            return False
        finally:
            self.names.state.definitions[name] = before

    def _holds_again(self, display: Display, equation: int) -> bool:
        return self._holds_so(display.latex, equation, Kind.ANGLES_TOLD_OTHERWISE)

    def _holds_so(self, latex: str, equation: int, besides: Kind | None = None) -> bool:
        """Whether an equation of a display holds as things are, or its outcomes tell one thing besides."""
        again = [each for each in self._outcomes_of(latex) if each.equation == equation]
        is_told = (each.verdict in HOLDS or (besides is not None and each.tells(besides)) for each in again)
        return bool(again) and all(is_told)

    def _with_slip(self, outcome: Outcome, display: Display) -> AsUsual | None:
        """Tell the one slip that mends an equation if its names mean what they usually do; return what it then would be.

        With a term or a factor more or less it may well mean something else: the point of another link, one joint's part.
        """
        if outcome.as_usual is None or display.erratum:
            return None
        try:
            with self.ring.budget.of(SECONDS_TO_EXPLAIN):
                holds = partial(self._holds_so, equation=outcome.equation)
                slips = [*self.diagnostician.slip_as_usual(normalise_unicode(display.latex), outcome, holds)]
        except TooComplex:
            return None
        if not slips:
            return self._with_slip_before(outcome, display)
        for slip in slips:
            outcome.also(say(Kind.SLIP_AS_USUAL, change=slip.finding, printed=slip.printed, correct=slip.correct))
        told = {*MISPRINTS, Kind.MISSING_TERM} if outcome.as_usual.of_another else MISPRINTS
        return outcome.as_usual if any(slip.finding.kind in told for slip in slips if slip.finding) else None

    def _with_slip_before(self, outcome: Outcome, display: Display) -> AsUsual | None:
        """Return what an equation would be if its names mean what they usually do, where a slip in what is said before then mends it."""
        usual = outcome.as_usual
        if usual is None or not outcome.uses:
            return None
        refuted, state = replace(usual.outcome, uses=outcome.uses), self.names.state
        aside = {key: state.definitions.pop(key) for key in usual.meanings if key in state.definitions}
        state.inferred |= usual.meanings
        try:
            with self.ring.budget.of(SECONDS_ON_SLIPS, WORK_ON_SLIPS):
                again = partial(self._holds_again, display, outcome.equation)
                slip = self.diagnostician.slip_before(Record(0, "", Verdict.REFUTED), refuted, again)
        except TooComplex:
            return None
        finally:
            state.forget_usual(usual.meanings)
            state.definitions |= aside
        return replace(usual, outcome=refuted) if slip is not None and slip.change.kind in MISPRINTS else None

    def _result(self, outcome: Outcome, record: Record) -> EquationResult:
        """Return what became of one equation; why it is refuted is what the diagnosis of the display found."""
        result = outcome.result(record.line)
        if (state := self.names.state).conventional:
            keys = self._keys_in(outcome) & state.conventional
            result = replace(result, usual={key: state.inferred[key] for key in sorted(keys) if key in state.inferred})
        if "tan" in record.latex.lower() and outcome.verdict in DECIDED:
            result = replace(result, order=self._order(outcome))
        if self.inferred.arm is not None:
            source, told_by = self.inferred.arm.source, self.inferred.arm.told_by
            result = replace(result, links=links_of(outcome, self.checker.members, source, told_by))
        if outcome.verdict is not Verdict.REFUTED:
            return result
        if self.inferred.arm is not None and outcome.pair is not None:
            result = replace(result, explained_by=links_that_explain(outcome, self.checker.members))
        return replace(result, findings=tuple(each for each in record.findings if each.equation == outcome.equation))

    def _order(self, outcome: Outcome) -> str:
        from armproof.verification.equations.argument_order import order_shown

        try:
            with self.ring.budget.of(SECONDS_TO_EXPLAIN):
                return order_shown(outcome, lambda chain: self.checker.check(chain, outcome.equation, 0, define=False))
        except (ArmproofError, RecursionError):
            return ""

    def _keys_in(self, outcome: Outcome) -> frozenset[str]:
        """Return the names in an equation, and those that stand behind names that the document defines."""
        keys = {name.key for name in names_in(outcome)}
        made = (self.names.state.definitions[key].node for key in keys & self.names.state.definitions.keys())
        behind = {b.key for node in made if node is not None for b in n.walk(node) if isinstance(b, n.Name)}
        return frozenset(keys | behind)

    def _with_array_corrected(self, record: Record, display: Display) -> Record:
        if record.verdict is not Verdict.REFUTED or not self.correct:
            return record
        from armproof.verification.correction.tables import correct_array

        with self.ring.budget.of(SECONDS_TO_DECIDE):
            return replace(record, corrections=correct_array(self.checker, display, record))

    def _outcomes_of(self, latex: str) -> list[Outcome]:
        """Return the outcomes of a display that is tried: it defines nothing."""
        read = self.names.reader.read(latex)
        return self.statements.check(read, 0, define=False, latex=normalise_unicode(latex))[0]

    def _with_later_definitions(
        self, statements: list[n.Statement], display: Display
    ) -> tuple[list[Outcome], dict[str, float]]:
        """Return the outcomes; a name may be defined after its use in the display ("…, where D = …")."""
        known = len(self.names.state.definitions)
        check = partial(
            self.statements.check, statements, display.line, define=not (display.erratum or display.denied),
            latex=normalise_unicode(display.latex),
        )  # fmt: skip
        outcomes, extra = check()
        if len(self.names.state.definitions) > known and any(o.verdict is Verdict.UNCHECKED for o in outcomes):
            again, extra = check()
            outcomes = [
                new_one(old, outcomes, again) if old.verdict is Verdict.UNCHECKED and not old.defines else old
                for old in outcomes
            ]
        return outcomes, extra


def _unreadable(display: Display, error: ReadError) -> Finding:
    """Say at which line and column of the document a display cannot be read."""
    offset = original_offset(display.latex, error.offset)
    before = display.latex[:offset]
    pieces = [piece for piece in display.pieces if piece.at <= offset]
    line = pieces[-1].line if pieces else display.line + before.count("\n") + ("\n" in display.latex)
    column = offset - (before.rfind("\n") + 1) + 1
    place = {"line": line, "at": column, "problem": finding_of(error)}
    if display.cell is None or display.file:
        return say(Kind.UNREADABLE, **place)
    return say(Kind.UNREADABLE_IN_CELL, cell=display.cell, **place)
