"""Wrong entries as formulas: what the function computes, what it should, and the change that mends it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cached_property

from armproof.models.errors import ArmproofError
from armproof.verification.algebra.ring import Scalar
from armproof.verification.algebra.written import write_bounded
from armproof.verification.diagnosis.counterexample import Probe
from armproof.verification.diagnosis.mend import LearntNotation, Mender
from armproof.verification.errors import EvaluationError
from armproof.verification.findings import Finding, Kind, say
from armproof.verification.functions.asked import Part
from armproof.verification.functions.proof import Bench, Proof
from armproof.verification.latex.writer import Notation
from armproof.verification.verdict import WrongEntry

WRITTEN = 6  # entries that are written as formulas
WRITTEN_ANYWAY = 3  # where the cause is known
SHORT = 4  # terms of a formula that is written in any case
MENDED = 4  # wrong entries of which the change is sought; where more are wrong the cause lies elsewhere
SECONDS_TO_MEND = 0.5


def describe_entries(part: Part, proof: Proof, *, mend: bool) -> list[WrongEntry]:
    """Return the wrong entries of a part, in formulas the first few, with the change of each where it is small.

    Args:
        mend: whether to seek those changes; without them, the cause being known, long formulas are left out.
    """
    bench = proof.bench
    true = bench.true(part.asked.quantity)
    with bench.ring.budget.of(SECONDS_TO_MEND):
        return list(_entries(part, proof, true.rows, EntryWriter(bench), mend))


def _entries(
    part: Part, proof: Proof, true: Sequence[Sequence[Scalar]], writer: EntryWriter, mend: bool
) -> Iterator[WrongEntry]:
    for index, (r, c) in enumerate(part.wrong):
        printed, correct, change = "", "", None
        if index < (WRITTEN if mend else WRITTEN_ANYWAY):
            try:
                value, right = proof.entry(part.number, r, c), true[r][c]
                if mend or max(len(value.numerator), len(right.numerator)) <= SHORT:
                    printed, correct, change = writer.describe(value, right, mend and len(part.wrong) <= MENDED)
            except EvaluationError:  # the formula is beyond the algebra; the table shows its values
                pass
        yield WrongEntry(part.number, *part.place(r, c), printed, correct, change)


class EntryWriter:
    """Writes entries with the letters of the arm, and seeks the change that mends one."""

    def __init__(self, bench: Bench) -> None:
        self.bench = bench
        self.notation = Notation(style="index", cosine="C", learnt=True)

    @cached_property
    def _mender(self) -> Mender:
        learnt = LearntNotation(self.bench.names)
        return Mender(self.bench.checker, learnt, Probe(self.bench.checker).agreement)

    def describe(self, value: Scalar, true: Scalar, mend: bool) -> tuple[str, str, Finding | None]:
        """Return the formula obtained, the right one, and the change where it is a small one."""
        printed, correct = write_bounded(value, self.notation), self._correct(true)
        mended, change = self._mend(printed, true) if mend else ("", None)
        return printed, mended or correct, change

    def _correct(self, true: Scalar) -> str:
        """Write an entry of the arm's own, once for all checks if it got the time that it needs."""
        kept = self.bench.written
        if true not in kept:
            text = write_bounded(true, self.notation)
            if self.bench.ring.budget.is_spent:
                return text
            kept[true] = text
        return kept[true]

    def _mend(self, printed: str, true: Scalar) -> tuple[str, Finding | None]:
        try:
            node = self.bench.names.reader.read_expression(printed)
            return self._mender.mend(printed, node, true, self.notation)
        except (ArmproofError, NotImplementedError):
            return "", None


def summary(entries: list[WrongEntry]) -> Iterator[Finding]:
    """Yield what is wrong with a few entries."""
    changes = [entry.finding for entry in entries]
    first = changes[0] if changes else None
    if len(entries) > 1 and first is not None and all(change == first for change in changes):
        yield say(Kind.IN_EACH, change=_glossed(first), places=_places(entries))
        return
    if len(entries) > MENDED:
        yield say(Kind.WRONG_ENTRIES_AT, count=len(entries), places=_places(entries))
        return
    for entry in entries:
        if entry.finding is not None:
            finding = _glossed(entry.finding)
        elif entry.printed and entry.correct:
            finding = say(Kind.WRONG_ENTRY, printed=entry.printed, correct=entry.correct)
        else:
            finding = say(Kind.ONE_WRONG_ENTRY if entry.row else Kind.WRONG_VALUE)
        yield finding.at(row=entry.row, column=entry.column)


def _glossed(change: Finding) -> Finding:
    """Return a change with what it tells of the angles: a missing one makes an absolute angle of a relative one."""
    is_missing = change.kind in (Kind.MISSING_INDEX, Kind.MISSING_ANGLE)
    return say(Kind.ABSOLUTE_ANGLE, change=change) if is_missing else change


def _places(entries: list[WrongEntry]) -> Finding:
    rows, columns = ({getattr(entry, kind) for entry in entries} for kind in ("row", "column"))
    if len(columns) == 1:
        return say(Kind.ALL_IN_COLUMN, number=columns.pop())
    if len(rows) == 1:
        return say(Kind.ALL_IN_ROW, number=rows.pop())
    places = [say(Kind.PLACE, row=entry.row, column=entry.column) for entry in entries[:6]]
    return say(Kind.MORE_PLACES if len(entries) > 6 else Kind.PLACES, places=places)
