"""Equations that hold but for one slip: in them, with names as usual, or in what is said before."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING

from armproof.models.errors import ArmproofError
from armproof.verification.algebra.matrix import as_matrix
from armproof.verification.check.limits import SECONDS_ON_SLIPS, SECONDS_TO_EXPLAIN, WORK_ON_SLIPS
from armproof.verification.display.statements import Statements
from armproof.verification.document import Display
from armproof.verification.equations.alignment import Pair
from armproof.verification.equations.outcome import AsUsual, Outcome
from armproof.verification.errors import TooComplex
from armproof.verification.evaluation.blocks import cells_of
from armproof.verification.findings import MISPRINTS, Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import is_number
from armproof.verification.latex.unicode import normalise_unicode
from armproof.verification.naming.state import Definition
from armproof.verification.verdict import HOLDS, EquationResult, Record, SlipBefore, Verdict

if TYPE_CHECKING:
    from armproof.verification.diagnosis.diagnosis import Diagnostician


MOST_MET = 4  # displays that are asked for all slips before them


class Slips:
    """Seeks the one slip with which an equation of a display holds, and tells which displays clear a definition of one."""

    def __init__(self, statements: Statements, diagnostician: Callable[[], Diagnostician]) -> None:
        self.diagnostician = diagnostician
        self.checker, self.statements = statements.checker, statements
        self.names, self.budget = self.checker.names, self.checker.exact.budget

    # -- in the equation, its names as usual --------------------------------------------------------------------------

    def as_usual(self, outcome: Outcome, display: Display) -> AsUsual | None:
        """Tell the one slip that mends an equation if its names mean what they usually do; return what it then would be.

        With a term or a factor more or less it may well mean something else: the point of another link, one joint's part.
        """
        if outcome.as_usual is None or display.erratum:
            return None
        try:
            with self.budget.of(SECONDS_TO_EXPLAIN):
                besides = Kind.SIGNED_DISTANCE if outcome.as_usual.before is not None else None  # of a root
                holds = partial(self._holds_so, equation=outcome.equation, besides=besides)
                slips = [*self.diagnostician().slip_as_usual(normalise_unicode(display.latex), outcome, holds)]
        except TooComplex:
            return None
        if not slips:
            return self._as_usual_before(outcome, display)
        for slip in slips:
            outcome.also(say(Kind.SLIP_AS_USUAL, change=slip.finding, printed=slip.printed, correct=slip.correct))
        told = {*MISPRINTS, Kind.MISSING_TERM} if outcome.as_usual.of_another else MISPRINTS
        return outcome.as_usual if any(slip.finding.kind in told for slip in slips if slip.finding) else None

    def _as_usual_before(self, outcome: Outcome, display: Display) -> AsUsual | None:
        """Return what an equation would be if its names mean what they usually do, where a slip in what is said before then mends it."""
        usual = outcome.as_usual
        if usual is None or not outcome.uses:
            return None
        refuted, state = replace(usual.outcome, uses=outcome.uses), self.names.state
        aside = {key: state.definitions.pop(key) for key in usual.meanings if key in state.definitions}
        state.inferred |= usual.meanings
        try:
            with self.budget.of(SECONDS_ON_SLIPS, WORK_ON_SLIPS):
                again = partial(self._holds_again, display, outcome.equation)
                slip = self.diagnostician().slip_before(Record(0, "", Verdict.REFUTED), refuted, again)
        except TooComplex:
            return None
        finally:
            state.forget_usual(usual.meanings)
            state.definitions |= aside
        return replace(usual, outcome=refuted) if slip is not None and slip.change.kind in MISPRINTS else None

    # -- in what is said before ---------------------------------------------------------------------------------------

    def before_refuted(
        self, found: list[EquationResult], display: Display, record: Record, outcomes: Sequence[Outcome]
    ) -> None:
        """Give the results of a refuted display the slips in definitions before with which they hold."""
        with suppress(TooComplex), self.budget.of(SECONDS_ON_SLIPS, WORK_ON_SLIPS):
            for place, outcome in enumerate(outcomes):
                may_slip = frozenset(filter(self._may_slip, outcome.uses))
                found[place] = replace(found[place], may_slip=may_slip)
                found[place] = replace(found[place], slip_before=self._slip_before(outcome, record, display))
        self.meet(display.line, outcomes)

    def meet(self, line: int, outcomes: Sequence[Outcome]) -> None:
        """Remember with which slips in definitions before a display holds of which one equation does not, if none of its own mends it."""
        differing = [each for each in outcomes if _differs(each)]
        if len(self.names.state.met) >= MOST_MET or len(differing) != 1 or not differing[0].uses:
            return
        outcome = _of_two_values(differing[0])
        with suppress(TooComplex):
            with self.budget.of(SECONDS_ON_SLIPS, WORK_ON_SLIPS):
                slips = self.diagnostician().slips_before(outcome)
            with self.budget.of(SECONDS_ON_SLIPS, WORK_ON_SLIPS):
                if slips and not self.diagnostician().mends_itself(outcome):
                    self.names.state.met[line] = slips

    def before_second_meaning(self, record: Record, display: Display, outcomes: Sequence[Outcome]) -> Record:
        """Return the record of a display that says a name anew, as it would be with one slip in what is said of that before."""
        found = list(record.outcomes)
        with suppress(TooComplex), self.budget.of(SECONDS_ON_SLIPS, WORK_ON_SLIPS):
            for place, outcome in enumerate(outcomes):
                is_open = outcome.verdict in (Verdict.UNCHECKED, Verdict.DEFINED)
                if is_open and outcome.tells(Kind.SECOND_MEANING) and outcome.uses:
                    again = partial(self._holds_again, display, outcome.equation)
                    slip = self.diagnostician().slip_before(record, outcome, again)
                    found[place] = replace(found[place], slip_before=slip)
        return replace(record, outcomes=tuple(found))

    def _slip_before(self, outcome: Outcome, record: Record, display: Display) -> SlipBefore | None:
        """Return the slip in a definition before with which a refuted equation holds, or None."""
        if outcome.verdict is not Verdict.REFUTED or not outcome.uses:
            return None
        again = partial(self._holds_again, display, outcome.equation)
        return self.diagnostician().slip_before(record, outcome, again)

    def is_cleared(self, record: Record, slip: SlipBefore) -> bool:
        """Whether a display that holds does so as it stands, and not if a definition has a slip: it clears it of that."""
        made = self.names.state.definitions
        before = made.get(slip.name)
        if before is None or before.line != slip.line or not isinstance(slip.formula, n.Node):
            return True
        with_slip = replace(before, evaluate=self.checker.members.meaning(slip.formula))
        return self.holds_where(record, slip.name, before) and not self.holds_where(record, slip.name, with_slip)

    def _may_slip(self, key: tuple[str, int]) -> bool:
        """Whether what is said of a name claims something: a list of letters does not, F = (F_x, F_y)."""
        before = self.names.state.definitions.get(key[0])
        told = None if before is None or before.line != key[1] else before.formula or before.whole
        if before is None or told is None or (told is before.whole and not cells_of(told)):
            return False
        from armproof.verification.diagnosis.slips_before import names_alone

        is_given = before.in_text and all(map(is_number, cells_of(told) or (told,)))  # F = (10, 5) of a sentence
        return not (is_given or names_alone(told))

    def holds_where(self, record: Record, name: str, meaning: Definition) -> bool:
        """Whether a display holds with another meaning of a name: not by what it says itself, as J = ∂p/∂θ would by its J."""
        made = self.names.state.definitions
        before = made[name]
        own = {key: made.pop(key) for key, each in [*made.items()] if each.line == record.line != before.line}
        made[name] = meaning
        try:
            with self.budget.of(SECONDS_TO_EXPLAIN):
                return all(each.verdict in HOLDS for each in self.statements.tried(record.latex))
        except (ArmproofError, RecursionError):
            return False
        finally:
            made |= {**own, name: before}

    def _holds_again(self, display: Display, equation: int) -> bool:
        return self._holds_so(display.latex, equation, Kind.ANGLES_TOLD_OTHERWISE)

    def _holds_so(self, latex: str, equation: int, besides: Kind | None = None) -> bool:
        """Whether an equation of a display holds as things are, or its outcomes tell one thing besides."""
        again = [each for each in self.statements.tried(latex) if each.equation == equation]
        is_told = (each.verdict in HOLDS or (besides is not None and each.tells(besides)) for each in again)
        return bool(again) and all(is_told)


def _differs(outcome: Outcome) -> bool:
    """Whether an equation of two values is refuted, or left open for want of an arm: what it may be meant of otherwise."""
    is_open = outcome.verdict is Verdict.UNCHECKED and outcome.tells(Kind.NO_ARM_TO_COMPARE)
    return outcome.verdict is Verdict.REFUTED or (
        is_open and len(outcome.sides) == 2 and all(each.known for each in outcome.sides)
    )


def _of_two_values(outcome: Outcome) -> Outcome:
    """Return an equation that is left open with the two values that differ."""
    if outcome.pair is not None or len(outcome.sides) != 2:
        return outcome
    one, other = (as_matrix(each.value) for each in outcome.sides)
    return replace(outcome, pair=Pair(one, other))
