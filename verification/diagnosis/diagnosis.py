"""Why an equation is refuted: the wrong entries, the change that mends each, the cause of a whole matrix's failure."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from armproof.verification.algebra.calculus import symbols_in
from armproof.verification.algebra.matrix import Matrix, as_matrix
from armproof.verification.algebra.protocol import Value
from armproof.verification.algebra.ring import Scalar
from armproof.verification.algebra.written import write_bounded
from armproof.verification.diagnosis.carried_errors import consequence_of
from armproof.verification.diagnosis.mend import LearntNotation, Mender
from armproof.verification.diagnosis.misconceptions import signs_of_arguments
from armproof.verification.diagnosis.slips import on_all, plain_edits, single_edits, swapped_lengths
from armproof.verification.diagnosis.slips_before import (
    mends_itself,
    nothing_else_mends,
    slip_before,
    slips_before,
    written,
)
from armproof.verification.diagnosis.whole_matrix import swapped_cells, whole_matrix
from armproof.verification.equations.alignment import Pair, equal_matrices, exactly_equal
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.equations.decimals import finest_decimals
from armproof.verification.equations.outcome import AsUsual, Outcome
from armproof.verification.equations.sides import Member
from armproof.verification.errors import TooComplex
from armproof.verification.findings import MISPRINTS, Finding, Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare, is_number
from armproof.verification.latex.writer import Notation
from armproof.verification.naming.state import Definition, PrintedError
from armproof.verification.verdict import Record, SlipBefore, Verdict, WrongEntry

_PLAIN = frozenset(("sign", "function", "index", "length"))  # changes by which nothing is dropped or added

if TYPE_CHECKING:
    from armproof.verification.diagnosis.by_samples import BySamples


MAX_MENDED = 6  # of so many wrong entries the change is sought; beyond, the cause lies elsewhere


class Diagnostician:
    """Turns refuted outcomes into wrong entries, findings and, where samples may be taken, a counterexample."""

    def __init__(self, checker: ChainChecker, by_samples: BySamples | None = None) -> None:
        self.checker = checker
        self.learnt = LearntNotation(checker.names)
        self._by_samples = by_samples
        self._mender = Mender(checker, self.learnt, by_samples.probe.agreement if by_samples is not None else None)

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
            outcome, why, found = self._on_either_side(latex, outcome)
            if (error := self._printed_error(record.line, outcome, found)) is not None:
                errors = self.checker.names.state.errors
                if errors and (consequence := consequence_of(self.checker, outcome, error)):
                    why.append(consequence)
                errors.append(error)
            findings.extend(finding.at(outcome.equation) for finding in why)
            entries.extend(found)
            if outcome.there:
                counterexample = counterexample or dict(outcome.there)
            elif not counterexample and self._by_samples is not None:
                counterexample, discrepancy = self._by_samples.counterexample(outcome)
        return replace(
            record,
            findings=tuple(findings) or record.findings,
            entries=tuple(entries),
            counterexample=counterexample,
            discrepancy=discrepancy,
        )

    def slip_before(self, record: Record, outcome: Outcome, again: Callable[[], bool]) -> SlipBefore | None:
        """Return the slip in a definition before with which a refuted equation holds, as it is found `again`; None where there is none.

        One slip in the equation itself is as likely, and is told: a rival. That a term is missing, or a number wrong, says what is
        wrong, and not how that came about.
        """
        entries = [entry.finding for entry in record.entries if entry.equation == outcome.equation]
        told = [
            each for each in entries if each is not None and each.kind not in (Kind.MISSING_TERM, Kind.WRONG_NUMBER)
        ]
        found = slip_before(self.checker, self.learnt, outcome, again)
        if found is None or len(entries) == len(told) == 1:
            return found and replace(found, has_rival=True)
        if outcome.verdict is not Verdict.REFUTED:
            return found
        try:
            return replace(found, is_only=nothing_else_mends(self.checker, self.learnt, outcome, found, again))
        except TooComplex:
            return found

    def slips_before(self, outcome: Outcome) -> list[SlipBefore]:
        """Return the slips in definitions before with which a refuted equation holds, one for each value that a name then has."""
        found: dict[tuple[str, int], list[SlipBefore]] = {}
        for slip in slips_before(self.checker, self.learnt, outcome):
            before = found.setdefault((slip.name, slip.line), [])
            if not any(self._says_the_same(slip, other) for other in before):
                before.append(slip)
        return [slip for each in found.values() for slip in each]

    def mends_itself(self, outcome: Outcome) -> bool:
        """Whether one slip of its own mends a refuted equation, at one place or all through a side."""
        return len(outcome.nodes) != 2 or mends_itself(self.checker, self.learnt, outcome)

    def _says_the_same(self, one: SlipBefore, other: SlipBefore) -> bool:
        values = [self.checker.member(each.formula) for each in (one, other) if isinstance(each.formula, n.Node)]
        return all(each.known for each in values) and equal_matrices(*(as_matrix(each.value) for each in values))

    def slip_as_usual(self, latex: str, outcome: Outcome, holds: Callable[[str], bool]) -> list[WrongEntry]:
        """Return the entry that one slip mends of an equation which is left open, if its names mean what they usually do.

        What `holds` decides of the display so mended counts where the text gives the values.
        """
        usual, state = outcome.as_usual, self.checker.names.state
        if usual is None or len(usual.outcome.wrong) != 1 or None in (usual.outcome.pair, usual.outcome.printed):
            return []
        doubted = usual.meanings.keys() & state.definitions.keys() if usual.outcome.there else ()
        aside = {key: state.definitions.pop(key) for key in doubted}
        state.inferred |= usual.meanings
        aside |= self._defined_as_before(usual)
        try:
            if usual.outcome.there:
                return list(self._slips_there(latex, usual.outcome, holds))
            entries = [each for each in self._on_either_side(latex, usual.outcome)[2] if each.finding is not None]
            if not entries and (usual.before is not None or any(map(n.has_arcs, usual.outcome.nodes))):
                entries = self._slip_on_a_branch(latex, usual.outcome, holds)
        finally:
            state.forget_usual(usual.meanings)
            if usual.before is not None:
                state.definitions.pop(usual.before[0], None)
            state.definitions |= aside
        return entries

    def _defined_as_before(self, usual: AsUsual) -> dict[str, Definition]:
        """Let a name mean what it did before the equation that says it anew, and return what it means since."""
        if usual.before is None:
            return {}
        (key, definition), made = usual.before, self.checker.names.state.definitions
        since = {key: made[key]} if key in made else {}
        made[key] = definition
        return since

    def _slip_on_a_branch(self, latex: str, outcome: Outcome, holds: Callable[[str], bool]) -> list[WrongEntry]:
        """Return the one sign, function or index of which another makes a solution right on a branch: θ_2 = atan2(y, x) for θ_1."""
        found = []
        for node in outcome.nodes:
            start, end = node.span
            slips = single_edits(node, self.learnt.letters(node))
            for edit in (*slips, *on_all(node, signs_of_arguments)):
                self.checker.exact.budget.check()
                correct = written(edit.node)
                if edit.kind in _PLAIN and holds(latex[:start] + correct + latex[end:]):
                    printed = latex[start:end].strip()
                    found.append(WrongEntry(outcome.equation, None, None, printed, correct, edit.finding, node.span))
        return found if len(found) == 1 else []

    def _slips_there(self, latex: str, outcome: Outcome, holds: Callable[[str], bool]) -> Iterator[WrongEntry]:
        """Yield the sign or the function of which another one makes numbers right at the values that the text gives: 2 sin 30°."""
        node = outcome.printed.node if outcome.printed is not None else None
        if node is None or any(isinstance(below, n.Name) for below in n.walk(node)):
            return
        start, end = node.span
        for edit in plain_edits(node, self.learnt.letters(node)):
            self.checker.exact.budget.check()
            correct = written(edit.node)
            if holds(latex[:start] + correct + latex[end:]):
                yield WrongEntry(
                    outcome.equation, None, None, latex[start:end].strip(), correct, edit.finding, node.span
                )
                return

    def _printed_error(self, line: int, outcome: Outcome, entries: list[WrongEntry]) -> PrintedError | None:
        """Return the refuted equation as an error to remember, where it says something of a quantity or a name."""
        assert outcome.true is not None and outcome.printed is not None
        node = n.ungrouped(outcome.true.node)
        quantity = self.checker.quantity_of(node)
        key = repr(quantity) if quantity is not None else node.key if isinstance(node, n.Name) else ""
        cells = {(e.row or 0, e.column or 0): e.printed for e in entries}
        return PrintedError(line, key, outcome.printed.node, cells) if key else None

    def _on_either_side(self, latex: str, outcome: Outcome) -> tuple[Outcome, list[Finding], list[WrongEntry]]:
        """Return why an equation is wrong; of two formulas, c_2 = (x² + y² - …)/…, the one that a slip mends is wrong, or the longer."""
        why, found = self._explained(latex, outcome)
        turned = _turned(outcome)
        if turned is None or _is_misprint(found):
            return outcome, why, found
        otherwise, mended = self._explained(latex, turned)
        if any(entry.finding for entry in found):  # d_3² + 2d_2² = x² + …, or a sign of d_2²
            return (turned, otherwise, mended) if _is_misprint(mended) else (outcome, why, found)
        if any(entry.finding for entry in mended) or (_is_short(turned.true) and self._has_lengths(outcome.true)):
            return turned, otherwise, mended
        return outcome, why, found

    def _has_lengths(self, side: Member | None) -> bool:
        """Whether a formula is one of the author's: it holds lengths of the arm beside its quantities."""
        names = [*n.names(side.node)] if side is not None else []
        lengths = self.checker.names.arm.lengths if self.checker.names.arm is not None else {}
        return any(self.checker.names.known_symbol(each.key) in lengths for each in names)

    def _explained(self, latex: str, outcome: Outcome) -> tuple[list[Finding], list[WrongEntry]]:
        """Return why an equation is wrong, as a whole or entry by entry, and its wrong entries."""
        notation = self.learnt.learn(latex, outcome)
        if outcome.there:
            entries = [replace(entry, finding=None) for entry in self._entries(latex, outcome, notation)]
            return [say(Kind.WRONG_THERE), *_summary(entries)], entries
        cause, is_whole = self._cause(outcome) if len(outcome.wrong) > 1 else (None, False)
        entries = self._entries(latex, outcome, notation)
        if cause is not None and (is_whole or not all(entry.finding for entry in entries)):
            return [cause, *self._other_direction(outcome, cause)], [replace(entry, finding=None) for entry in entries]
        return list(outcome.findings if outcome.sampled_only else _summary(entries)), entries

    def _cause(self, outcome: Outcome) -> tuple[Finding | None, bool]:
        """Return the mistake that was made in a matrix, and whether it was made in all of it."""
        found = self._by_samples.cause(outcome, self._whole) if self._by_samples is not None else None
        if found is not None:
            return found.finding, found.is_whole
        whole = self._whole(outcome)
        return whole, whole is not None

    def _whole(self, outcome: Outcome) -> Finding | None:
        """Return what a matrix is as a whole, as far as that is decided exactly."""
        return whole_matrix(self.checker, outcome) or self._swapped_throughout(outcome) or swapped_cells(outcome)

    def _swapped_throughout(self, outcome: Outcome) -> Finding | None:
        """Return that exchanging two lengths in the whole printed value mends it."""
        assert outcome.pair is not None and outcome.printed is not None
        row, column = outcome.wrong[0]
        agrees = self._mender.agreement(outcome.pair.true.rows[row][column])
        for edit in swapped_lengths(outcome.printed.node, self.learnt.letters(outcome.printed.node)):
            cell = find_cell(edit.node, row, column, outcome.printed.value)
            if agrees is not None and cell is not None and not agrees(cell):
                continue  # one entry at a few samples tells most of them
            member = self.checker.member(edit.node)
            if member.known and isinstance(member.value, Matrix) and equal_matrices(outcome.pair.true, member.value):
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
        entries: list[WrongEntry] = []
        mend = len(outcome.wrong) <= MAX_MENDED and not outcome.sampled_only
        for row, column in outcome.wrong:
            true = pair.true.rows[row][column]
            cell: n.Node | None = outcome.printed.node
            if not pair.is_scalar:
                cell = find_cell(outcome.printed.node, row, column, outcome.printed.value)
            elif isinstance(cell, n.At) and cell.span == cell.inner.span:  # the condition of a case, printed elsewhere
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
            correct = correct or self._in_decimals(true, cell, printed) or write_bounded(true, notation)
            if change is None and not pair.is_scalar and mend:
                change = moved_cell(pair, row, column)
            place = (None, None) if pair.is_scalar else (row + 1, column + 1)
            span = cell.span if cell is not None else None
            entries.append(WrongEntry(outcome.equation, place[0], place[1], printed, correct, change, span))
        return entries

    def _in_decimals(self, true: Value, cell: n.Node | None, printed: str) -> str:
        """Return a number with as many decimals, behind the same mark, as the one printed in its place; empty of anything else."""
        decimals = finest_decimals([cell]) if cell is not None and is_number(cell) else 0
        if not decimals or not isinstance(true, Scalar) or symbols_in([true]):
            return ""
        mark = next((mark for mark in ("{,}", ",") if mark in printed), ".")
        return f"{self.checker.members.number(true):.{decimals}f}".replace(".", mark)


def _is_misprint(entries: Sequence[WrongEntry]) -> bool:
    """Whether all wrong entries are mended without a term or a factor more or less."""
    return bool(entries) and all(each.finding is not None and each.finding.kind in MISPRINTS for each in entries)


def _turned(outcome: Outcome) -> Outcome | None:
    """Return the outcome with its sides exchanged, where neither is a name alone, nor given by samples or stated values."""
    pair, true, printed = outcome.pair, outcome.true, outcome.printed
    if pair is None or not pair.is_scalar or true is None or printed is None or outcome.there or outcome.sampled_only:
        return None
    if isinstance(bare(true.node), n.Name) or _is_short(true):
        return None
    return replace(outcome, true=printed, printed=true, pair=replace(pair, true=pair.printed, printed=pair.true))


def _is_short(side: Member | None) -> bool:
    """Whether a side is a function of an angle, c_{23}: a formula is printed for it."""
    return side is not None and isinstance(bare(side.node), n.Call)


def _summary(entries: list[WrongEntry]) -> Iterator[Finding]:
    if len(entries) > 4 and not any(entry.finding for entry in entries):
        yield say(Kind.WRONG_ENTRIES, count=len(entries))
        return
    for entry in entries:
        wrong = say(Kind.WRONG_ENTRY, printed=entry.printed, correct=entry.correct)
        yield (entry.finding or wrong).at(row=entry.row, column=entry.column)


def find_cell(node: n.Node, row: int, column: int, value: Value = None) -> n.Node | None:
    """Return the tree of a printed entry, where the printed member is a matrix written out.

    `value` is the member's: a matrix of blocks that are names or products has fewer cells than its value has entries.
    """
    node = bare(node)
    if isinstance(node, n.Postfix) and node.operator == "T":
        return find_cell(node.base, column, row, value.transpose if isinstance(value, Matrix) else None)
    if isinstance(node, n.Sequence):
        index = max(row, column)
        return node.items[index] if index < len(node.items) else None
    if not isinstance(node, n.Matrix):
        return None
    if any(isinstance(below, n.Matrix) for below in node.cells):
        return _cell_of_blocks(node, row, column)
    if isinstance(value, Matrix) and (len(node.rows), *{len(cells) for cells in node.rows}) != value.shape:
        return None
    try:
        return node.rows[row][column]
    except IndexError:
        return None


def _cell_of_blocks(node: n.Matrix, row: int, column: int) -> n.Node | None:
    """Follow a place into a matrix of written-out blocks; None where a block's size is not written out."""
    sizes = [
        [(len(c.rows), len(c.rows[0])) if isinstance(c, n.Matrix) else (1, 1) for c in cells] for cells in node.rows
    ]
    heights = [max(height for height, _ in each) for each in sizes]
    if (down := _part_at(row, heights)) is None or (across := _part_at(column, [w for _, w in sizes[down[0]]])) is None:
        return None
    cell = node.rows[down[0]][across[0]]
    if isinstance(cell, n.Matrix):
        return find_cell(cell, down[1], across[1])
    return cell if heights[down[0]] == 1 else None


def _part_at(place: int, sizes: Sequence[int]) -> tuple[int, int] | None:
    """Return in which of the parts of these sizes a place is, and where in it; None behind the last."""
    for part, size in enumerate(sizes):
        if place < size:
            return part, place
        place -= size
    return None


def moved_cell(pair: Pair, row: int, column: int) -> Finding | None:
    """Return that the printed entry is the true one of another place: swapped cells or a transposed matrix."""
    printed = pair.printed.rows[row][column]
    if not isinstance(printed, Scalar) or printed.as_fraction() is not None:
        return None
    for (r, c), true, _ in pair.entries():
        if (r, c) != (row, column) and exactly_equal(true, printed):
            return say(Kind.OF_ANOTHER_ENTRY, other_row=r + 1, other_column=c + 1)
    return None
