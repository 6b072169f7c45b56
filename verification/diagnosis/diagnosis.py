"""Why an equation is refuted: the wrong entries, the change that mends each, the cause of a whole matrix's failure."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from armproof.verification.algebra.matrix import Matrix
from armproof.verification.algebra.written import write_bounded
from armproof.verification.diagnosis.carried_errors import consequence_of, printed_error
from armproof.verification.diagnosis.causes.case import Explanation
from armproof.verification.diagnosis.causes.display import display_cause
from armproof.verification.diagnosis.counterexample import Probe
from armproof.verification.diagnosis.discrepancies import discrepancy_of
from armproof.verification.diagnosis.explain import explain_whole
from armproof.verification.diagnosis.learnt_notation import LearntNotation
from armproof.verification.diagnosis.mend import Mender
from armproof.verification.diagnosis.places import find_cell, moved_cell, swapped_cells
from armproof.verification.diagnosis.slips import swapped_lengths
from armproof.verification.equations.alignment import different_entries, exactly_equal
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.equations.outcome import Outcome
from armproof.verification.latex import nodes as n
from armproof.verification.latex.writer import Notation
from armproof.verification.verdict import Record, WrongEntry

MAX_MENDED = 6  # of so many wrong entries the change is sought; beyond, the cause lies elsewhere


class Diagnostician:
    """Turns refuted outcomes into wrong entries, words and a counterexample."""

    def __init__(self, checker: ChainChecker) -> None:
        self.checker = checker
        self._probe = Probe(checker)
        self.learnt = LearntNotation(checker.names)
        self._mender = Mender(checker, self._probe, self.learnt)

    def diagnose(self, record: Record, latex: str, outcomes: list[Outcome]) -> Record:
        """Return the record with wrong entries, a message in words and a counterexample."""
        entries: list[WrongEntry] = []
        words: list[str] = []
        counterexample = dict(record.counterexample)
        discrepancy = None
        for outcome in outcomes:
            if outcome.message and not outcome.pair:
                words.append(outcome.message)
            if outcome.pair is None or outcome.true is None or outcome.printed is None:
                continue
            notation = self.learnt.learn(latex, outcome)
            whole, cause = self._whole(outcome) if len(outcome.wrong) > 1 else ("", Explanation())
            found = self._entries(latex, outcome, notation)
            if not whole and not all(entry.change for entry in found):
                whole = cause.words
            if whole:
                words.append(whole)
                found = [replace(entry, change="") for entry in found]
            elif outcome.sampled_only:
                words.append(outcome.message)
            else:
                words.extend(self._summary(found))
            consequence = consequence_of(self.checker, outcome, found)
            if consequence:
                words.append(consequence)
            entries.extend(found)
            if not counterexample:
                sample = self._probe.worst_sample(outcome)
                counterexample = self._probe.counterexample(outcome, sample)
                discrepancy = discrepancy_of(self.checker, self._probe, outcome, sample)
            error = printed_error(self.checker, record.line, outcome, found)
            if error is not None:
                self.checker.names.state.errors.append(error)
        message = "; ".join(dict.fromkeys(word for word in words if word)) or record.message
        return replace(
            record,
            message=message,
            entries=tuple(entries),
            counterexample=counterexample,
            discrepancy=discrepancy,
        )

    def _whole(self, outcome: Outcome) -> tuple[str, Explanation]:
        """Say what a matrix is as a whole; and what mistake explains it where it was made in a part of it only."""
        whole = explain_whole(self.checker, outcome) or self._swapped_throughout(outcome) or swapped_cells(outcome)
        cause = Explanation() if whole else display_cause(self.checker, outcome)
        return whole or (cause.words if cause.is_whole else ""), cause

    def _swapped_throughout(self, outcome: Outcome) -> str:
        """Say if exchanging two lengths in the whole printed value mends it."""
        assert outcome.pair is not None and outcome.printed is not None
        for edit in swapped_lengths(outcome.printed.node, self.learnt.letters(outcome.printed.node)):
            member = self.checker.member(edit.node)
            if not (
                member.known and isinstance(member.value, Matrix) and member.value.shape == outcome.pair.true.shape
            ):
                continue
            if not different_entries(replace(outcome.pair, printed=member.value), exactly_equal):
                return f"{edit.words} throughout"
        return ""

    def _summary(self, entries: list[WrongEntry]) -> Iterator[str]:
        if len(entries) > 4 and not any(entry.change for entry in entries):
            yield f"{len(entries)} entries are wrong"
            return
        for entry in entries:
            where = "" if entry.row is None else f"entry ({entry.row}, {entry.column}): "
            if entry.change:
                yield f"{where}{entry.change}"
            else:
                yield f"{where}is {entry.printed}, should be {entry.correct}"

    def _entries(self, latex: str, outcome: Outcome, notation: Notation) -> list[WrongEntry]:
        pair = outcome.pair
        assert pair is not None and outcome.printed is not None
        wrong = outcome.wrong
        entries: list[WrongEntry] = []
        mend = len(wrong) <= MAX_MENDED and not outcome.sampled_only
        for row, column in wrong:
            true = pair.true.rows[row][column]
            cell = None if pair.is_scalar else find_cell(outcome.printed.node, row, column, outcome.printed.value)
            if cell is None and pair.is_scalar:
                cell = outcome.printed.node
                if (
                    isinstance(cell, n.At) and cell.span == cell.inner.span
                ):  # the condition of a case, printed elsewhere
                    cell = cell.inner
            printed = (
                latex[cell.span[0] : cell.span[1]].strip()
                if cell is not None
                else write_bounded(pair.printed.rows[row][column], notation)
            )
            correct, change = "", ""
            if mend and cell is not None:
                correct, change = self._mender.mend(latex, cell, true, notation)
            if not correct and outcome.sampled_only and pair.is_scalar and outcome.true is not None:
                start, end = outcome.true.node.span  # exactly, the two sides differ by no more than a sign or a branch
                correct = latex[start:end].strip()
            if not correct:
                correct = write_bounded(true, notation)
            if not change and not pair.is_scalar and mend:
                change = moved_cell(pair, row, column)
            place = (None, None) if pair.is_scalar else (row + 1, column + 1)
            span = cell.span if cell is not None else None
            entries.append(WrongEntry(outcome.equation, place[0], place[1], printed, correct, change, span))
        return entries
