"""Why an equation is refuted: the wrong entries, the change that mends each, the cause of a whole matrix's failure."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from armproof.models.errors import ArmproofError
from armproof.verification.algebra.matrix import Matrix
from armproof.verification.algebra.written import write_bounded
from armproof.verification.diagnosis.carried_errors import consequence_of, printed_error
from armproof.verification.diagnosis.causes.case import Explanation
from armproof.verification.diagnosis.causes.display import display_case
from armproof.verification.diagnosis.causes.find import find_other, find_slip
from armproof.verification.diagnosis.counterexample import Probe
from armproof.verification.diagnosis.discrepancy import discrepancy_of
from armproof.verification.diagnosis.learnt_notation import LearntNotation
from armproof.verification.diagnosis.mend import Mender
from armproof.verification.diagnosis.places import find_cell, moved_cell
from armproof.verification.diagnosis.slips import swapped_lengths
from armproof.verification.diagnosis.whole_matrix import swapped_cells, whole_matrix
from armproof.verification.equations.alignment import different_entries, exactly_equal
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.equations.outcome import Outcome
from armproof.verification.findings import Finding, Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.writer import Notation
from armproof.verification.verdict import Record, WrongEntry

MAX_MENDED = 6  # of so many wrong entries the change is sought; beyond, the cause lies elsewhere


class Diagnostician:
    """Turns refuted outcomes into wrong entries, findings and a counterexample."""

    def __init__(self, checker: ChainChecker) -> None:
        self.checker = checker
        self._probe = Probe(checker)
        self.learnt = LearntNotation(checker.names)
        self._mender = Mender(checker, self._probe, self.learnt)

    def diagnose(self, record: Record, latex: str, outcomes: list[Outcome]) -> Record:
        """Return the record with wrong entries, why they are wrong, and a counterexample."""
        entries: list[WrongEntry] = []
        findings: list[Finding] = []
        counterexample = dict(record.counterexample)
        discrepancy = None
        for outcome in outcomes:
            if outcome.pair is None or outcome.true is None or outcome.printed is None:
                said = () if outcome.pair is not None else outcome.findings
                findings.extend(finding.at(outcome.equation) for finding in said)
                continue
            why, found = self._explained(latex, outcome)
            if consequence := consequence_of(self.checker, outcome, found):
                why.append(consequence)
            findings.extend(finding.at(outcome.equation) for finding in why)
            entries.extend(found)
            if not counterexample:
                sample = self._probe.worst_sample(outcome)
                counterexample = self._probe.counterexample(outcome, sample)
                discrepancy = discrepancy_of(self.checker, self._probe, outcome, sample)
            error = printed_error(self.checker, record.line, outcome, found)
            if error is not None:
                self.checker.names.state.errors.append(error)
        return replace(
            record,
            findings=tuple(findings) or record.findings,
            entries=tuple(entries),
            counterexample=counterexample,
            discrepancy=discrepancy,
        )

    def _explained(self, latex: str, outcome: Outcome) -> tuple[list[Finding], list[WrongEntry]]:
        """Return why an equation is wrong, as a whole or entry by entry, and its wrong entries."""
        notation = self.learnt.learn(latex, outcome)
        cause = self._cause(outcome) if len(outcome.wrong) > 1 else Explanation()
        entries = self._entries(latex, outcome, notation)
        if cause.finding is not None and (cause.is_whole or not all(entry.finding for entry in entries)):
            hint = self._other_direction(outcome, cause.finding)
            return [cause.finding, *hint], [replace(entry, finding=None) for entry in entries]
        return list(outcome.findings if outcome.sampled_only else _summary(entries)), entries

    def _cause(self, outcome: Outcome) -> Explanation:
        """Return what a matrix is as a whole, or else the mistake that was made in it or in a part of it."""
        if (case := display_case(self.checker, outcome)) is None:
            return Explanation(self._whole(outcome))
        try:
            with np.errstate(all="ignore"):
                other = find_other(case)
                if other.is_whole:
                    return other
                whole = self._whole(outcome)
                return Explanation(whole) if whole is not None else find_slip(case, other)
        except ArmproofError:
            return Explanation()

    def _whole(self, outcome: Outcome) -> Finding | None:
        """Return what a matrix is as a whole, as far as that is decided exactly."""
        return whole_matrix(self.checker, outcome) or self._swapped_throughout(outcome) or swapped_cells(outcome)

    def _swapped_throughout(self, outcome: Outcome) -> Finding | None:
        """Return that exchanging two lengths in the whole printed value mends it."""
        assert outcome.pair is not None and outcome.printed is not None
        for edit in swapped_lengths(outcome.printed.node, self.learnt.letters(outcome.printed.node)):
            member = self.checker.member(edit.node)
            if not (
                member.known and isinstance(member.value, Matrix) and member.value.shape == outcome.pair.true.shape
            ):
                continue
            if not different_entries(replace(outcome.pair, printed=member.value), exactly_equal):
                return say(Kind.THROUGHOUT, change=edit.finding)
        return None

    def _other_direction(self, outcome: Outcome, finding: Finding) -> Iterator[Finding]:
        """Yield what to write where a pose is inverted only because its indices are read the other way round."""
        node = outcome.true.node if outcome.true is not None else None
        if finding.kind is Kind.INVERSE_PRINTED and isinstance(node, n.Name) and node.sub and node.sup:
            index = "lower" if self.checker.names.transforms == "upper" else "upper"
            yield say(Kind.OTHER_DIRECTION, index=index, name=node.text)

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
            correct, change = "", None
            if mend and cell is not None:
                correct, change = self._mender.mend(latex, cell, true, notation)
            if not correct and outcome.sampled_only and pair.is_scalar and outcome.true is not None:
                start, end = outcome.true.node.span  # exactly, the two sides differ by no more than a sign or a branch
                correct = latex[start:end].strip()
            if not correct:
                correct = write_bounded(true, notation)
            if change is None and not pair.is_scalar and mend:
                change = moved_cell(pair, row, column)
            place = (None, None) if pair.is_scalar else (row + 1, column + 1)
            span = cell.span if cell is not None else None
            entries.append(WrongEntry(outcome.equation, place[0], place[1], printed, correct, change, span))
        return entries


def _summary(entries: list[WrongEntry]) -> Iterator[Finding]:
    if len(entries) > 4 and not any(entry.finding for entry in entries):
        yield say(Kind.WRONG_ENTRIES, count=len(entries))
        return
    for entry in entries:
        wrong = say(Kind.WRONG_ENTRY, printed=entry.printed, correct=entry.correct)
        yield (entry.finding or wrong).at(row=entry.row, column=entry.column)
