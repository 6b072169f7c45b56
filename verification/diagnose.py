"""Why an equation is refuted: the wrong entries, the change that mends each, the cause of a whole matrix's failure."""

from __future__ import annotations

import re
import time
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from models.errors import ArmproofError
from verification.algebras import SampledAlgebra, Value
from verification.closed_form import write_scalar
from verification.compare import Pair, different_entries, exactly_equal
from verification.edits import Edit, Letters, single_edits, swapped_lengths
from verification.equation import ChainChecker, Outcome
from verification.errors import EvaluationError, ReadError
from verification.evaluate import Evaluator, as_scalar
from verification.explain import explain_whole
from verification.latex import nodes as n
from verification.latex.writer import Notation, Writer, symbol_as_latex
from verification.matrix import Matrix
from verification.quantities import Quantity
from verification.trig import Scalar
from verification.verdict import Record, WrongEntry

PROBES = 12
WRITTEN = 400  # terms: more are written as an ellipsis
FOLDED = 120  # terms: of so many, products of sines and cosines are written as those of sums of angles where shorter
MAX_EDITS = 600
LONGEST = 2000  # characters of a corrected term; what is longer is no correction that anybody could use
MAX_MENDED = 6  # of so many wrong entries the change is sought; beyond, the cause lies elsewhere


@dataclass
class _PrintedError:
    """A refuted equation, kept to recognise its consequences."""

    line: int
    key: str
    node: n.Node
    cells: dict[tuple[int, int], str] = field(default_factory=dict)


class Diagnostician:
    """Turns refuted outcomes into wrong entries, words and a counterexample."""

    def __init__(self, checker: ChainChecker) -> None:
        self.checker = checker
        self.names = checker.names
        self.errors: list[_PrintedError] = []
        self._probe: SampledAlgebra | None = None
        self._notation = Notation()

    # -- the record ---------------------------------------------------------------------------------------------------

    def diagnose(self, record: Record, latex: str, outcomes: list[Outcome]) -> Record:
        """Return the record with wrong entries, a message in words and a counterexample."""
        entries: list[WrongEntry] = []
        words: list[str] = []
        counterexample = dict(record.counterexample)
        for outcome in outcomes:
            if outcome.message and not outcome.pair:
                words.append(outcome.message)
            if outcome.pair is None or outcome.true is None or outcome.printed is None:
                continue
            notation = self._learn(latex, outcome)
            found = self._entries(latex, outcome, notation)
            whole = None
            if len(outcome.wrong) > 1:
                whole = explain_whole(self.checker, outcome) or self._swapped_throughout(outcome) or _swapped_cells(outcome)
            if whole:
                words.append(whole)
                found = [replace(entry, change="") for entry in found]
            elif outcome.sampled_only:
                words.append(outcome.message)
            else:
                words.extend(self._summary(found))
            consequence = self._consequence(outcome, found)
            if consequence:
                words.append(consequence)
            entries.extend(found)
            if not counterexample:
                counterexample = self._counterexample(outcome)
            self._remember(record.line, outcome, found)
        message = "; ".join(dict.fromkeys(word for word in words if word)) or record.message
        return replace(record, message=message, entries=tuple(entries), counterexample=counterexample)

    def _swapped_throughout(self, outcome: Outcome) -> str:
        """Say if exchanging two lengths in the whole printed value mends it."""
        assert outcome.pair is not None and outcome.printed is not None
        for edit in swapped_lengths(outcome.printed.node, self._letters(outcome.printed.node)):
            member = self.checker.member(edit.node)
            if not (member.known and isinstance(member.value, Matrix) and member.value.shape == outcome.pair.true.shape):
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

    # -- wrong entries ------------------------------------------------------------------------------------------------

    def _entries(self, latex: str, outcome: Outcome, notation: Notation) -> list[WrongEntry]:
        pair = outcome.pair
        assert pair is not None and outcome.printed is not None
        wrong = outcome.wrong
        entries: list[WrongEntry] = []
        mend = len(wrong) <= MAX_MENDED and not outcome.sampled_only
        for row, column in wrong:
            true = pair.true.rows[row][column]
            cell = None if pair.is_scalar else _cell(outcome.printed.node, row, column, outcome.printed.value)
            if cell is None and pair.is_scalar:
                cell = outcome.printed.node
            printed = latex[cell.span[0] : cell.span[1]].strip() if cell is not None else self._written(pair.printed.rows[row][column], notation)
            correct, change = "", ""
            if mend and cell is not None:
                correct, change = self._mended(latex, cell, true, notation)
            if not correct and outcome.sampled_only and pair.is_scalar and outcome.true is not None:
                start, end = outcome.true.node.span  # exactly, the two sides differ by no more than a sign or a branch
                correct = latex[start:end].strip()
            if not correct:
                correct = self._written(true, notation)
            if not change and not pair.is_scalar and mend:
                change = _moved_cell(pair, row, column)
            place = (None, None) if pair.is_scalar else (row + 1, column + 1)
            span = cell.span if cell is not None else None
            entries.append(WrongEntry(outcome.equation, place[0], place[1], printed, correct, change, span))
        return entries

    def _written(self, value: Any, notation: Notation) -> str:
        if isinstance(value, Scalar):
            terms = _terms_to_write(value)
            if terms > WRITTEN:
                return r"\ldots"
            # folding into sums of angles takes its time, and makes no page of terms readable
            small = terms <= FOLDED and time.monotonic() < self.checker.exact.ring.deadline
            text = write_scalar(value, notation, folded=small)
        else:
            text = str(value)
        return text if len(text) <= LONGEST else text[:LONGEST].rsplit(" ", 1)[0] + r" \ldots"

    def _mended(self, latex: str, cell: n.Node, true: Scalar, notation: Notation) -> tuple[str, str]:
        """Return the cell with the one small change that makes it right, and that change in words."""
        probe = self.probe()
        try:
            target = probe.from_exact(true)
        except EvaluationError:
            return "", ""
        scale = 1.0 + np.abs(target)
        letters = self._letters(cell)
        with np.errstate(all="ignore"):
            for count, edit in enumerate(single_edits(cell, letters)):
                if count > MAX_EDITS or time.monotonic() > self.checker.exact.ring.deadline:
                    break
                if not self._agrees(edit, target, scale, probe):
                    continue
                try:
                    value = as_scalar(Evaluator(self.names, self.checker.exact).evaluate(edit.node))
                    if isinstance(value, Scalar) and exactly_equal(true, value):
                        text = Writer(latex, cell, notation).write(edit.node)
                        if self._reads_as(text, true):
                            return text, edit.words
                except (ArmproofError, NotImplementedError):
                    continue
        return self._missing_term(latex, cell, true, notation)

    def _missing_term(self, latex: str, cell: n.Node, true: Scalar, notation: Notation) -> tuple[str, str]:
        """Return the cell with one term added, where just one is missing."""
        try:
            printed = as_scalar(Evaluator(self.names, self.checker.exact).evaluate(cell))
            if not isinstance(printed, Scalar) or printed.as_fraction() is not None or true.is_zero():
                return "", ""
            missing = self._written(true - printed, notation)
        except EvaluationError:
            return "", ""
        if re.search(r".[ ][-+] ", re.sub(r"\([^()]*\)|\{[^{}]*\}", "", missing)) or "frac" in missing:
            return "", ""
        text = latex[cell.span[0] : cell.span[1]].strip()
        joined = f"{text} - {missing[1:]}" if missing.startswith("-") else f"{text} + {missing}"
        return (joined, f"the term {missing} is missing") if self._reads_as(joined, true) else ("", "")

    def _agrees(self, edit: Edit, target: np.ndarray, scale: np.ndarray, probe: SampledAlgebra) -> bool:
        try:
            value = as_scalar(Evaluator(self.names, probe).evaluate(edit.node))
        except (ArmproofError, TypeError):
            return False
        return not isinstance(value, Matrix | list) and bool(np.all(np.abs(value - target) < 1e-7 * scale))

    def _reads_as(self, text: str, true: Scalar) -> bool:
        """Whether the corrected LaTeX, read again, is right: what the report offers must verify."""
        try:
            node = self.names.reader.read_expression(text)
            value = as_scalar(Evaluator(self.names, self.checker.exact).evaluate(node))
        except (ReadError, EvaluationError):
            return False
        return isinstance(value, Scalar) and exactly_equal(true, value)

    # -- notation -----------------------------------------------------------------------------------------------------

    def _learn(self, latex: str, outcome: Outcome) -> Notation:
        """Return the notation of the display, falling back on what earlier displays of the document used."""
        notation = Notation(symbols=dict(self._notation.symbols))
        assert outcome.printed is not None and outcome.true is not None
        for node in (outcome.printed.node, outcome.true.node):
            for below in n.walk(node):
                if isinstance(below, n.Call):
                    notation.learn(below, latex[below.span[0] : below.span[1]])
                elif isinstance(below, n.Name) and below.text and below.key not in self.names.quantities:
                    symbol = self.names.known_symbol(below.key)
                    if symbol is not None and not below.dots:
                        notation.symbols.setdefault(symbol, below.text)
                    elif self.names.is_free(below):
                        notation.symbols.setdefault(below.key, below.text)
        if not notation.learnt:
            notation.style, notation.cosine = self._notation.style, self._notation.cosine
            notation.underscore, notation.braces = self._notation.underscore, self._notation.braces
        for letter, symbol in self.names.symbols.items():
            notation.symbols.setdefault(symbol, symbol_as_latex(letter))
        self._notation = Notation(dict(notation.symbols), notation.style, notation.cosine, notation.underscore, notation.braces)
        return notation

    def _letters(self, cell: n.Node) -> Letters:
        """The joints and lengths that a slip may have confused, in the document's letters."""
        symbols = self._notation.symbols
        arm = self.names.arm
        if arm is None:
            free = [symbol for symbol in symbols if not symbol.startswith("dot ")]
            names = {key: n.Name(*_base_and_index(key), text=symbols[key]) for key in free}
            angles = tuple(name for name in names.values() if name.base in ("theta", "alpha", "phi", "psi", "beta"))
            lengths = tuple(name for name in names.values() if name not in angles)[:12]
            joints = sorted({index for below in n.walk(cell) if isinstance(below, n.JointAngles) for _, index in below.terms})
            return Letters(tuple(joints), angles, lengths)
        read = self.names.reader.read_expression

        def names_of(keys: list[str]) -> tuple[n.Name, ...]:
            nodes = [read(symbols.get(key) or symbol_as_latex(key)) for key in keys]
            return tuple(node for node in nodes if isinstance(node, n.Name))

        revolute = [joint.symbol for joint in arm.joints if joint.kind == "revolute"]
        prismatic = [joint.symbol for joint in arm.joints if joint.kind == "prismatic"]
        joints = [int(found.group(1)) for symbol in revolute if (found := re.search(r"_(\d)$", symbol))]
        return Letters(tuple(joints), names_of(revolute), names_of([*arm.lengths, *prismatic]))

    # -- counterexamples ----------------------------------------------------------------------------------------------

    def probe(self) -> SampledAlgebra:
        """A few generic configurations with round values, on the double plant."""
        if self._probe is None:
            arm = self.names.arm
            generator = np.random.default_rng(7)
            columns = []
            for joint in arm.joints if arm is not None else ():
                low, high = (-2.6, 2.6) if joint.kind == "revolute" else (0.1, 0.9)
                columns.append(np.round(generator.uniform(low, high, PROBES), 1))
            q = np.array(columns).T if columns else np.zeros((PROBES, 0))
            self._probe = SampledAlgebra(self.checker.exact, np.where(np.abs(q) < 0.05, 0.3, q), 7)
        return self._probe

    def _counterexample(self, outcome: Outcome) -> dict[str, float]:
        """Return a generic configuration at which the printed and the true value differ."""
        assert outcome.true is not None and outcome.printed is not None
        probe = self.probe()
        with np.errstate(all="ignore"):
            try:
                worst = self._sampled_difference(outcome, probe)
            except EvaluationError:
                worst = np.zeros(probe.samples)
        best = int(np.nanargmax(worst)) if np.isfinite(worst).any() else 0
        arm = self.names.arm
        values: dict[str, float] = {}
        depends = self._symbols_of(outcome)
        if arm is not None and (not depends or any(joint.symbol in depends for joint in arm.joints)):
            values = {joint.symbol: float(probe.q[best, k]) for k, joint in enumerate(arm.joints)}
        for member in (outcome.true, outcome.printed):
            for below in n.walk(member.node):
                symbol = self.names.known_symbol(below.key) if isinstance(below, n.Name) else None
                if symbol is None and isinstance(below, n.Name) and not depends and self._is_free_symbol(below):
                    symbol = below.key
                if symbol is not None:
                    values.setdefault(symbol, round(float(probe.symbol(symbol)[best]), 6))
        for symbol in depends:  # those that a defined name brings along
            values.setdefault(symbol, round(float(probe.symbol(symbol)[best]), 6))
        return values

    def _symbols_of(self, outcome: Outcome) -> list[str]:
        """The symbols on which the wrong entries depend."""
        pair = outcome.pair
        if pair is None or outcome.sampled_only:
            return []
        ring = self.checker.exact.ring
        parts = [
            part
            for row, column in outcome.wrong
            for cell in (pair.true.rows[row][column], pair.printed.rows[row][column])
            if isinstance(cell, Scalar)
            for part in (cell.numerator, cell.denominator)
        ]
        generators = {generator for part in parts for powers, _ in ring.terms(part) for generator in powers}
        names = {name.split("/")[0] for kind, name in generators if kind in ("symbol", "cos", "sin")}
        return sorted(name for name in names if name != "pi" and not name[:1].isdigit())

    def _is_free_symbol(self, name: n.Name) -> bool:
        return self.names.is_free(name) and name.key in self.names.used and name.key not in self.names.definitions

    def _sampled_difference(self, outcome: Outcome, probe: SampledAlgebra) -> np.ndarray:
        assert outcome.true is not None and outcome.printed is not None
        if outcome.pair is not None and not outcome.sampled_only:
            cells = [(outcome.pair.true.rows[r][c], outcome.pair.printed.rows[r][c]) for r, c in outcome.wrong]
            return np.max([np.abs(probe.from_exact(a - b)) for a, b in cells], axis=0) if cells else np.zeros(probe.samples)
        true, printed = (as_scalar(Evaluator(self.names, probe).evaluate(m.node)) for m in (outcome.true, outcome.printed))
        if isinstance(true, Matrix) or isinstance(printed, Matrix):
            return np.zeros(probe.samples)
        return np.abs(true - printed)

    # -- causes and consequences --------------------------------------------------------------------------------------

    def _remember(self, line: int, outcome: Outcome, entries: list[WrongEntry]) -> None:
        assert outcome.true is not None and outcome.printed is not None
        key = self._subject(outcome)
        if key:
            cells = {(e.row or 0, e.column or 0): e.printed for e in entries}
            self.errors.append(_PrintedError(line, key, outcome.printed.node, cells))

    def _subject(self, outcome: Outcome) -> str:
        assert outcome.true is not None
        node = outcome.true.node
        while isinstance(node, n.Group):
            node = node.inner
        quantity = self.checker.quantity_of(node)
        if quantity is not None:
            return repr(quantity)
        return node.key if isinstance(node, n.Name) else ""

    def _consequence(self, outcome: Outcome, entries: list[WrongEntry]) -> str:
        """Say if an error repeats one printed before, or follows from it."""
        key = self._subject(outcome)
        for error in self.errors:
            same = error.key == key and all(error.cells.get((e.row or 0, e.column or 0)) == e.printed for e in entries)
            if key and same and entries:
                return f"the same error as in line {error.line}"
        followed = self._follows(outcome)
        return f"follows from line {followed}" if followed else ""

    def _follows(self, outcome: Outcome) -> int | None:
        """Return the line of an earlier error that, carried on, gives just what is printed here."""
        pair = outcome.pair
        assert pair is not None and outcome.true is not None
        arm = self.names.arm
        node = outcome.true.node
        quantity = self.checker.quantity_of(node)
        if arm is None or quantity is None or quantity.kind != "pose" or quantity.rows or quantity.columns:
            return None
        frames = list(arm.frames)
        try:
            first, last = frames.index(quantity.reference), frames.index(quantity.frame)
        except ValueError:
            return None
        if last - first < 2:
            return None
        printed: dict[str, _PrintedError] = {}
        for error in self.errors:
            printed.setdefault(error.key, error)
        evaluator = Evaluator(self.names, self.checker.exact)
        # the pose as a product of two, the printed value of one of them in the place of the true one
        for split in range(first + 1, last):
            left = Quantity("pose", frames[split], frames[first])
            right = Quantity("pose", frames[last], frames[split])
            factors: list[Value] = []
            used: list[int] = []
            for factor in (left, right):
                wrong = printed.get(repr(factor))
                if wrong is None:
                    factors.append(self.checker.exact.quantity(factor))
                    continue
                used.append(wrong.line)
                factors.append(evaluator.evaluate(wrong.node))
            if not used or not all(isinstance(f, Matrix) for f in factors):
                continue
            product = factors[0] @ factors[1]
            if product.shape == pair.printed.shape and all(
                exactly_equal(a, b) for row, other in zip(product.rows, pair.printed.rows, strict=True) for a, b in zip(row, other, strict=True)
            ):
                return min(used)
        return None


def _terms_to_write(value: Scalar) -> int:
    """How many terms a value is written with, those under its roots and in its arc functions included each time."""
    total = 0
    for part in (value.numerator, value.denominator):
        if len(part) > WRITTEN:
            return len(part)
        for powers, _ in value.ring.terms(part):
            total += 1
            for kind, name in powers:
                inner = [value.ring.radicand(name)] if kind == "radical" else value.ring.arcs[name] if kind == "arc" else ()
                total += sum(_terms_to_write(below) for below in inner)
            if total > WRITTEN:
                return total
    return total


def _base_and_index(key: str) -> tuple[str, str]:
    base, _, index = key.partition("_")
    return base, index


def _cell(node: n.Node, row: int, column: int, value: Value = None) -> n.Node | None:
    """Return the tree of a printed entry, where the printed member is a matrix written out.

    `value` is the member's: a matrix of blocks that are names or products has fewer cells than its value has entries.
    """
    while isinstance(node, n.Group | n.Labelled):
        node = node.inner
    if isinstance(node, n.Postfix) and node.operator == "T":
        return _cell(node.base, column, row, value.transpose if isinstance(value, Matrix) else None)
    if isinstance(node, n.Sequence):
        index = max(row, column)
        return node.items[index] if index < len(node.items) else None
    if not isinstance(node, n.Matrix):
        return None
    if any(isinstance(below, n.Matrix) for cells in node.rows for below in cells):
        return _cell_of_blocks(node, row, column)
    if isinstance(value, Matrix) and (len(node.rows), *{len(cells) for cells in node.rows}) != value.shape:
        return None
    try:
        return node.rows[row][column]
    except IndexError:
        return None


def _cell_of_blocks(node: n.Matrix, row: int, column: int) -> n.Node | None:
    """Follow a place into a matrix of written-out blocks; None where a block's size is not written out."""
    top = 0
    for cells in node.rows:
        sizes = [(len(c.rows), len(c.rows[0])) if isinstance(c, n.Matrix) else (1, 1) for c in cells]
        height = max(size[0] for size in sizes)
        if row < top + height:
            left = 0
            for cell, size in zip(cells, sizes, strict=True):
                if column < left + size[1]:
                    return _cell(cell, row - top, column - left) if isinstance(cell, n.Matrix) else cell if height == 1 else None
                left += size[1]
            return None
        top += height
    return None


def _swapped_cells(outcome: Outcome) -> str:
    """Say if the two wrong entries are each other's."""
    pair = outcome.pair
    if pair is None or len(outcome.wrong) != 2 or outcome.sampled_only:
        return ""
    (r, c), (s, d) = outcome.wrong
    true, printed = pair.true.rows, pair.printed.rows
    if exactly_equal(true[r][c], printed[s][d]) and exactly_equal(true[s][d], printed[r][c]):
        return f"entries ({r + 1}, {c + 1}) and ({s + 1}, {d + 1}) are swapped"
    return ""


def _moved_cell(pair: Pair, row: int, column: int) -> str:
    """Say if the printed entry is the true one of another place: swapped cells or a transposed matrix."""
    printed = pair.printed.rows[row][column]
    if not isinstance(printed, Scalar) or printed.as_fraction() is not None:
        return ""
    for r, cells in enumerate(pair.true.rows):
        for c, true in enumerate(cells):
            if (r, c) != (row, column) and exactly_equal(true, printed):
                return f"what is printed belongs in entry ({r + 1}, {c + 1})"
    return ""
