"""One display to its record: decided, explained and corrected, each within its time."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from functools import cached_property, partial
from typing import TYPE_CHECKING

from armproof.models.errors import ArmproofError
from armproof.verification.check.as_shown import as_shown_beside, rate_as_shown
from armproof.verification.check.limits import SECONDS_TO_DECIDE, SECONDS_TO_EXPLAIN
from armproof.verification.check.signs_above import has_sign, unless_signs_clash_above
from armproof.verification.check.slips import Slips
from armproof.verification.check.told_values import values_in_text
from armproof.verification.check.words_around import WordsAround
from armproof.verification.conditions.by_turned_angles import unless_by_angles
from armproof.verification.conditions.circumstances import Circumstances
from armproof.verification.conditions.told_names import unless_of_valueless
from armproof.verification.display.statements import Statements
from armproof.verification.display.taken_arm import OfTakenArm, names_in
from armproof.verification.document import Display
from armproof.verification.document.joint_limits import LIMITED
from armproof.verification.document.other_meanings import OMEGA_FIRST
from armproof.verification.document.sentences import WOULD_BE
from armproof.verification.document.told_notation import ORDINATE_FIRST
from armproof.verification.equations.argument_order import USUAL, order_shown
from armproof.verification.equations.foreign_index import unless_written_elsewhere
from armproof.verification.equations.outcome import AsUsual, Outcome, new_one
from armproof.verification.errors import NotSampled, ReadError, TooComplex
from armproof.verification.findings import Finding, Kind, finding_of, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.unicode import normalise_unicode, original_offset
from armproof.verification.naming.state import Told
from armproof.verification.tables import TWIST, check_array_table
from armproof.verification.tables.arms import Inference, is_of_no_arm, lengths_against, links_of, links_that_explain
from armproof.verification.verdict import DECIDED, HOLDS, EquationResult, IfShown, Record, Verdict, worst

if TYPE_CHECKING:
    from armproof.verification.correction.corrector import Corrector
    from armproof.verification.diagnosis.diagnosis import Diagnostician


class DisplayChecker:
    """Checks displays of one document, each by what stands above it.

    Attributes:
        inferred: the document, and what its arm was taken from.
        direction: which index names the reference, and the line of the display that shows it.
    """

    def __init__(
        self, statements: Statements, inferred: Inference, direction: tuple[str, int], correct: bool, samples: bool
    ) -> None:
        self.statements, self.checker = statements, statements.checker
        self.names, self.ring = self.checker.names, self.checker.exact.ring
        self.inferred, self.direction, self.correct = inferred, direction, correct
        self.samples = samples

    # What explains, corrects or limits is loaded where there is something to explain, to correct, to limit.

    @cached_property
    def diagnostician(self) -> Diagnostician:
        """Says what is wrong with a refuted display."""
        with self.checker.exact.budget.paused():
            from armproof.verification.diagnosis.diagnosis import Diagnostician

            if not self.samples:
                return Diagnostician(self.checker)
            from armproof.verification.diagnosis.by_samples import BySamples

            return Diagnostician(self.checker, BySamples(self.checker))

    @cached_property
    def corrector(self) -> Corrector:
        """Seeks what mends a refuted display."""
        with self.checker.exact.budget.paused():
            from armproof.verification.correction.corrector import Corrector

            return Corrector(self.checker, self.diagnostician, self.statements.tried)

    @cached_property
    def slips(self) -> Slips:
        """Seeks the one slip that mends an equation."""
        return Slips(self.statements, lambda: self.diagnostician)

    @cached_property
    def words(self) -> WordsAround:
        """Heeds what the words around a display say of it."""
        return WordsAround(self.circumstances)

    def parts_of(self, latex: str) -> Iterator[n.Node]:
        """Yield all that is read in the formulas of a display."""
        try:
            yield from (below for each in self.names.reader.read(latex) for below in n.walk(each))
        except ReadError:
            return

    @property
    def circumstances(self) -> Circumstances:
        """Heeds what the text between displays says."""
        return self.statements.claims.circumstances

    def check(self, display: Display) -> Record:
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
        if self.names.arm is None and (told := values_in_text(self.statements.claims.displays, display)) is not None:
            self.names.state.listed = (*display.listed, told)
        self.names.state.limits_joints = LIMITED in display.meant
        self.names.state.omega_is_first = OMEGA_FIRST in display.meant
        self.checker.rows.take_task(display.meant)
        self.ring.forget_signs()
        try:
            with self.ring.budget.of(SECONDS_TO_DECIDE):
                if display.said:
                    self.circumstances.text.heed(display.said, display.said_above, display.said_outside, display.line)
                elif self.names.state.told.is_direct and not display.goes_on:
                    self.circumstances.text.heed_words()
                if TWIST.search(display.latex) and (table := check_array_table(self.checker, display)) is not None:
                    return self._with_array_corrected(table, display)
                statements = self.names.reader.read(display.latex)
                if display.erratum and self.names.arm is None:  # it is quoted: what the text says is not said of it
                    self.names.state.told = Told()
                if display.said_behind:
                    self.circumstances.text.heed_behind(display.said_behind, statements, display.line)
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
        if _is_spoken_of(display) or self.words.meanings.order_doubt is not None:
            outcomes = [self.words.judge(outcome, display) for outcome in outcomes]
        if not display.erratum and has_sign(display.latex):
            above = self.statements.claims.displays
            outcomes = [unless_signs_clash_above(each, self.checker, above, display) for each in outcomes]
        if not display.erratum:
            outcomes = [unless_of_valueless(self.names, outcome) for outcome in outcomes]
        outcomes = [unless_by_angles(outcome, self.checker) for outcome in outcomes]
        for key in {key for outcome in outcomes for key in outcome.defines if display.may_not_print}:
            self.names.doubt(key)
        if not outcomes:
            return replace(record, verdict=Verdict.UNCHECKED, findings=(say(Kind.NO_EQUATION), say(Kind.BEYOND)))
        if self.direction == ("lower", display.line):
            outcomes[0].also(say(Kind.LOWER_IS_REFERENCE))
        if self.inferred.arm is not None:
            of_taken_arm = OfTakenArm(self.checker, self.inferred.document, self.inferred.arm)
            outcomes = [of_taken_arm.judge(outcome) for outcome in outcomes]
        outcomes = [
            unless_written_elsewhere(each, display, self.inferred.document) if each.tells(Kind.NO_SUCH_LENGTH) else each
            for each in outcomes
        ]
        slips = [
            None if each.as_usual is None else self.slips.as_usual(each, display) or self._as_shown(each, outcomes)
            for each in outcomes
        ]
        for place, slip in enumerate(slips):
            if slip is not None and not slip.meanings:  # what the text says is so: this follows from it but for a slip
                outcomes[place] = slip.outcome
                self.names.state.definitions |= dict([slip.before] if slip.before is not None else [])
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

    def _as_shown(self, outcome: Outcome, outcomes: Sequence[Outcome]) -> AsUsual | None:
        """Return what an equation would be if its names mean what they usually do, where the others of its display, or its rate, tell that."""
        held = {key for each in outcomes if each.verdict in HOLDS for key in self._keys_in(each)}
        return as_shown_beside(outcome, held, self.checker) or rate_as_shown(outcome, self.checker)

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
        found = [self._result(outcome, judged, ORDINATE_FIRST in display.meant) for outcome in outcomes]
        if display.erratum:
            return replace(judged, outcomes=tuple(found))
        if judged.verdict is not Verdict.REFUTED:
            says_anew = any(outcome.uses and outcome.tells(Kind.SECOND_MEANING) for outcome in outcomes)
            judged = replace(judged, outcomes=tuple(found))
            self.slips.meet(display.line, outcomes)
            return self.slips.before_second_meaning(judged, display, outcomes) if says_anew else judged
        if any(outcome.uses for outcome in outcomes):
            self.slips.before_refuted(found, display, judged, outcomes)
        return replace(judged, outcomes=tuple(found))

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

    def _result(self, outcome: Outcome, record: Record, in_told_order: bool) -> EquationResult:
        """Return what became of one equation; why it is refuted is what the diagnosis of the display found."""
        result = outcome.result(record.line)
        if (state := self.names.state).conventional:
            keys = self._keys_in(outcome) & state.conventional
            result = replace(result, usual={key: state.inferred[key] for key in sorted(keys) if key in state.inferred})
        if self.names.offset_joints:
            result = replace(result, of_table=self.checker.angles.entries_of_table(outcome))
        if "tan" in record.latex.lower() and outcome.verdict in DECIDED:
            result = replace(result, order=USUAL if in_told_order else self._order(outcome))
        if self.inferred.arm is not None:
            source, told_by = self.inferred.arm.source, self.inferred.arm.told_by
            result = replace(result, links=links_of(outcome, self.checker.members, source, told_by))
        if outcome.verdict is not Verdict.REFUTED:
            return result
        if self.inferred.arm is not None and outcome.pair is not None:
            members = self.checker.members
            result = replace(
                result,
                explained_by=links_that_explain(outcome, members),
                is_of_no_arm=is_of_no_arm(outcome, members),
                against=lengths_against(outcome.pair, members),
            )
        return replace(result, findings=tuple(each for each in record.findings if each.equation == outcome.equation))

    def _order(self, outcome: Outcome) -> str:
        try:
            with self.ring.budget.of(SECONDS_TO_EXPLAIN):
                return order_shown(outcome, lambda chain: self.checker.check(chain, outcome.equation, 0, define=False))
        except (ArmproofError, RecursionError):
            return ""

    def _keys_in(self, outcome: Outcome) -> frozenset[str]:
        """Return the names in an equation, those of which it has the rates where it holds, and those that stand behind names that the document defines."""
        keys = {name.key for name in names_in(outcome)}
        if outcome.verdict in HOLDS:
            keys |= {name.undotted.key for name in names_in(outcome)}
        made = (self.names.state.definitions[key].node for key in keys & self.names.state.definitions.keys())
        behind = {b.key for node in made if node is not None for b in n.names(node)}
        return frozenset(keys | behind)

    def _with_array_corrected(self, record: Record, display: Display) -> Record:
        if record.verdict is not Verdict.REFUTED or not self.correct:
            return record
        from armproof.verification.correction.tables import correct_array

        with self.ring.budget.of(SECONDS_TO_DECIDE):
            return replace(record, corrections=correct_array(self.checker, display, record))

    def _with_later_definitions(
        self, statements: list[n.Statement], display: Display
    ) -> tuple[list[Outcome], dict[str, float]]:
        """Return the outcomes; a name may be defined after its use in the display ("…, where D = …")."""
        known = len(self.names.state.definitions)
        define = not (display.erratum or display.denied or display.faulted or WOULD_BE in display.meant)
        latex = normalise_unicode(display.latex)
        check = partial(self.statements.check, statements, display.line, define=define, latex=latex)
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


def _is_spoken_of(display: Display) -> bool:
    """Whether the text around a display may say that it is so elsewhere, in a case, of something else, or not at all."""
    elsewhere = display.of_other_point or display.in_other_frame
    says = (
        display.said_next
        or display.supposed
        or display.meant
        or display.directions
        or display.denied
        or display.faulted
        or display.strange
    )
    return bool(elsewhere or says or display.may_not_print)
