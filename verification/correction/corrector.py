"""Seek what mends a refuted display, the smallest change first; what is offered has been checked as part of the display."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from dataclasses import replace

from armproof.models.errors import ArmproofError
from armproof.verification.algebra.protocol import OutsideAlgebra
from armproof.verification.conditions.implication import is_condition
from armproof.verification.correction.alternatives import Corrections, alternatives, trimmed, true_value
from armproof.verification.correction.kept import keeps, quantities, tautologies
from armproof.verification.correction.record import applied
from armproof.verification.correction.rephrasings import rephrasings
from armproof.verification.diagnosis.diagnosis import Diagnostician
from armproof.verification.diagnosis.slips import single_edits
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.equations.outcome import Outcome
from armproof.verification.latex import nodes as n
from armproof.verification.latex.unicode import normalise_unicode, original_offset
from armproof.verification.latex.writer import Notation, Writer
from armproof.verification.verdict import HOLDS, Correction, Record, Verdict

SECONDS_TO_CORRECT = 1.3
MOST_TRIALS = 60

Check = Callable[[str], list[Outcome]]  # a display's LaTeX to the outcomes of its equations


class Corrector:
    """Corrects the refuted displays of one document; `check` gives the outcomes of a display, defining nothing."""

    def __init__(self, checker: ChainChecker, diagnostician: Diagnostician, check: Check) -> None:
        self.checker = checker
        self.diagnostician = diagnostician
        self.check = check

    def correct(self, record: Record, statements: list[n.Statement], outcomes: Sequence[Outcome]) -> Corrections:
        """Return the corrections that mend a refuted display, at places of its LaTeX as the author wrote it, or none."""
        latex = normalise_unicode(record.latex)
        budget = self.checker.exact.budget
        kept = quantities(self.checker.names, statements, outcomes)
        before = tautologies(latex, statements)
        confirm, self.checker.confirm = self.checker.confirm, False
        try:
            with budget.of(SECONDS_TO_CORRECT):
                for count, corrections in enumerate(self._candidates(latex, record, statements, outcomes)):
                    if count > MOST_TRIALS or budget.is_spent:
                        break
                    corrections = spaced(latex, corrections)
                    if not corrections or not keeps(latex, corrections, kept):
                        continue
                    left = self._left(latex, corrections, outcomes)
                    if left == set() and self._tautologies(latex, corrections) <= before:
                        return _in_original(record.latex, latex, corrections)
        except ArmproofError:  # no time left
            return ()
        finally:
            self.checker.confirm = confirm
        return ()

    def _tautologies(self, latex: str, corrections: Corrections) -> int:
        """Return how many members the corrected display repeats; it has been read before."""
        after = applied(latex, corrections)
        return tautologies(after, self.checker.names.reader.read(after))

    def _left(self, latex: str, corrections: Corrections, before: Sequence[Outcome]) -> set[int] | None:
        """Return the equations that the corrections leave without a proof; None where they leave no display."""
        try:
            after = self.check(applied(latex, corrections))
        except (ArmproofError, OutsideAlgebra, ValueError, RecursionError):
            return None
        if _number(after, Verdict.UNCHECKED) > _number(before, Verdict.UNCHECKED):
            return None
        wrong = {outcome.equation for outcome in before if outcome.verdict is Verdict.REFUTED}
        right = {outcome.equation for outcome in after if outcome.verdict in HOLDS}
        return (wrong - right) | {outcome.equation for outcome in after if outcome.verdict is Verdict.REFUTED}

    # -- what may be tried ---------------------------------------------------------------------------------------------

    def _candidates(
        self, latex: str, record: Record, statements: list[n.Statement], outcomes: Sequence[Outcome]
    ) -> Iterator[Corrections]:
        notation = self._notation(latex, outcomes)
        refuted = [outcome for outcome in outcomes if outcome.verdict is Verdict.REFUTED]
        if any(outcome.printed is None for outcome in refuted):  # of an implication: its equations one by one
            refuted = self._equation_by_equation(statements) or refuted
        options = [list(alternatives(latex, outcome, record.entries)) for outcome in refuted]
        yield from self._combined(latex, outcomes, refuted, options)
        yield from rephrasings(latex, statements, self.checker)
        for choices, outcome in zip(options, refuted, strict=True):
            choices.extend(true_value(latex, outcome, notation))
        yield from self._combined(latex, outcomes, refuted, options)
        yield from self._slips(latex, statements, notation)

    def _equation_by_equation(self, statements: list[n.Statement]) -> list[Outcome]:
        """Return the refuted equations of a derivation, a = b ⇒ c = d, each taken as a claim of its own."""
        first = next((statement for statement in statements if isinstance(statement, n.Chain)), None)
        arrows = {statement.kind for statement in statements if isinstance(statement, n.Connective)}
        if first is None or is_condition(first) or not arrows <= {"⇒", "words", "and"}:
            return []
        outcomes: list[Outcome] = []
        equation = 1
        for chain in statements:
            if isinstance(chain, n.Chain):
                if set(chain.relations) == {"="}:
                    outcomes.extend(self.checker.check(chain, equation, 0, define=False))
                equation += len(chain.relations)
        return [outcome for outcome in outcomes if outcome.verdict is Verdict.REFUTED]

    def _combined(
        self, latex: str, outcomes: Sequence[Outcome], refuted: Sequence[Outcome], options: list[list[Corrections]]
    ) -> Iterator[Corrections]:
        """Yield one alternative an equation, and after each trial the next of those equations that it left wrong."""
        chosen = [0] * len(options)
        while options and all(options):
            corrections = joined([choices[k] for choices, k in zip(options, chosen, strict=True)])
            yield corrections
            wrong = self._left(latex, corrections, outcomes)
            stuck = [k for k, outcome in enumerate(refuted) if wrong is None or outcome.equation in wrong]
            movable = [k for k in stuck if chosen[k] + 1 < len(options[k])]
            if not movable:
                return
            for k in movable:
                chosen[k] += 1

    def _slips(self, latex: str, statements: list[n.Statement], notation: Notation) -> Iterator[Corrections]:
        """Yield the display with one slip of the pen mended in one side of it: for conditions, which have no entries."""
        learnt = self.diagnostician.learnt
        for member in (each for chain in statements if isinstance(chain, n.Chain) for each in chain.members):
            for edit in single_edits(member, learnt.letters(member)):
                with suppress(NotImplementedError):
                    yield (Correction(*member.span, Writer(latex, member, notation).write(edit.node)),)

    def _notation(self, latex: str, outcomes: Sequence[Outcome]) -> Notation:
        notation = self.diagnostician.learnt.current()
        for outcome in outcomes:
            if outcome.printed is not None and outcome.true is not None:
                notation = self.diagnostician.learnt.learn(latex, outcome)
        return notation


def _number(outcomes: Sequence[Outcome], verdict: Verdict) -> int:
    return sum(outcome.verdict is verdict for outcome in outcomes)


def spaced(latex: str, corrections: Corrections) -> Corrections:
    """Return corrections whose commands do not run into a letter behind them."""
    return tuple(
        replace(c, text=f"{c.text} ") if _ends_in_command(c.text) and latex[c.end : c.end + 1].isalpha() else c
        for c in corrections
    )


def _ends_in_command(text: str) -> bool:
    return "\\" in text and text.rpartition("\\")[2].isalpha()


def joined(parts: Sequence[Corrections]) -> Corrections:
    """Return corrections as one, from left to right; the same one twice counts once, one within another not at all."""
    every = sorted({c for part in parts for c in part}, key=lambda c: (c.start, -c.end))
    kept: list[Correction] = []
    for correction in every:
        if not kept or correction.start >= kept[-1].end or kept[-1].start == kept[-1].end < correction.end:
            kept.append(correction)
    return tuple(kept)


def _in_original(original: str, latex: str, corrections: Corrections) -> Corrections:
    """Return corrections at their places in the LaTeX before its Unicode signs were written as commands."""
    placed = (trimmed(latex, correction) for correction in corrections)
    return tuple(
        Correction(original_offset(original, c.start), original_offset(original, c.end), c.text) for c in placed
    )
