"""The one small change that mends a cell: an edit of what is printed, or a term added to it."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from dataclasses import replace
from fractions import Fraction
from itertools import chain

from armproof.models.errors import ArmproofError
from armproof.verification.algebra.matrix import as_scalar
from armproof.verification.algebra.ring import Scalar
from armproof.verification.algebra.written import terms_to_write, write_bounded
from armproof.verification.diagnosis.misconceptions import misconceptions
from armproof.verification.diagnosis.slips import Letters, function_pairs, sign_pairs, single_edits
from armproof.verification.equations.alignment import exactly_equal
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.equations.outcome import Outcome
from armproof.verification.errors import EvaluationError, ReadError
from armproof.verification.evaluation.evaluator import Evaluator
from armproof.verification.findings import Finding, Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.greek import ANGLES
from armproof.verification.latex.writer import Notation, Writer, symbol_as_latex
from armproof.verification.naming.names import Names
from armproof.verification.patterns import regex

MAX_EDITS = 600
MAX_NODES = 60_000  # of the trees of all edits together: those of a long formula take their time
MAX_NUMBERS = 4  # in a cell, of which one may be wrong
MAX_TERMS = 60  # of what a cell lacks, written out: of more nothing comes that is one term
PLAIN = regex(r"[A-Za-z]+(?:_[A-Za-z0-9]+)?")
INDEXED = regex(r"[A-Za-z]+_[A-Za-z0-9]")

Agreement = Callable[[Scalar], Callable[[n.Node], bool] | None]  # whether trees may have a value, as samples tell


class LearntNotation:
    """The notation of the displays met so far; what a display does not show is as in those before it."""

    def __init__(self, names: Names) -> None:
        self.names = names

    def learn(self, latex: str, outcome: Outcome) -> Notation:
        """Return the notation of the display, falling back on what earlier displays of the document used."""
        before = self.names.state.notation
        notation = Notation(symbols=dict(before.symbols))
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
            notation.style, notation.cosine = before.style, before.cosine
            notation.underscore, notation.braces = before.underscore, before.braces
        for letter, symbol in self.names.symbols.items():
            notation.symbols.setdefault(symbol, symbol_as_latex(letter))
        self.names.state.notation = replace(notation, symbols=dict(notation.symbols), learnt=False)
        return notation

    def current(self) -> Notation:
        """Return the notation of the displays met so far."""
        notation = self.names.state.notation
        return replace(notation, symbols=dict(notation.symbols))

    def letters(self, cell: n.Node) -> Letters:
        """The joints and lengths that a slip may have confused, in the document's letters."""
        symbols, arm = self.names.state.notation.symbols, self.names.arm
        if arm is None:
            free = [symbol for symbol in symbols if not symbol.startswith("dot ")]
            names = {key: n.Name(*key.partition("_")[::2], text=symbols[key]) for key in free}
            angles = tuple(name for name in names.values() if name.base in ANGLES)
            lengths = tuple(name for name in names.values() if name not in angles)[:12]
            joints = sorted(
                {index for below in n.walk(cell) if isinstance(below, n.JointAngles) for _, index in below.terms}
            )
            return Letters(tuple(joints), angles, lengths)
        read = self.names.reader.read_expression

        def names_of(keys: list[str]) -> tuple[n.Name, ...]:
            nodes = [read(symbols.get(key) or symbol_as_latex(key)) for key in keys]
            return tuple(node for node in nodes if isinstance(node, n.Name))

        revolute = [joint.symbol for joint in arm.joints if joint.kind == "revolute"]
        prismatic = [joint.symbol for joint in arm.joints if joint.kind == "prismatic"]
        joints = [int(found.group(1)) for symbol in revolute if (found := re.search(r"_(\d)$", symbol))]
        return Letters(
            tuple(joints),
            names_of(revolute),
            names_of([*arm.lengths, *prismatic]),
            names_of(self._coordinates()),
            names_of([key for key in self.names.state.definitions if INDEXED.fullmatch(key)]),
        )

    def _coordinates(self) -> list[str]:
        """The plain names of coordinates of the arm's points, x or p_y."""
        meant = {**self.names.quantities, **self.names.state.inferred}
        of_points = (key for key, quantity in meant.items() if quantity.kind == "origin" and quantity.scalar)
        return sorted(key for key in of_points if PLAIN.fullmatch(key))


class Mender:
    """Seeks the change of a printed cell after which it is proved; what it offers has been read again and verified."""

    def __init__(self, checker: ChainChecker, learnt: LearntNotation, agreement: Agreement | None) -> None:
        self.names = checker.names
        self.exact = checker.exact
        self.agreement = agreement or (lambda _true: lambda _node: True)
        self.learnt = learnt

    def mend(self, latex: str, cell: n.Node, true: Scalar, notation: Notation) -> tuple[str, Finding | None]:
        """Return the cell with the one small change that makes it right, and that change; else an empty text and None.

        The edits are tried on samples first, where some may be taken; what agrees there is decided exactly.
        """
        if (agrees := self.agreement(true)) is None:
            return "", None
        most = min(MAX_EDITS, MAX_NODES // sum(1 for _ in n.walk(cell)))
        rules = (
            sign_pairs,
            function_pairs,
            *([] if true.is_zero() else [misconceptions]),
        )  # x / x is no slip for x - x
        of_more = (edit for rule in rules for edit in rule(cell))
        for count, edit in enumerate(chain(single_edits(cell, self.learnt.letters(cell)), of_more)):
            if count > most or self.exact.budget.is_spent:
                break
            if not agrees(edit.node):
                continue
            try:
                value = as_scalar(Evaluator(self.names, self.exact).evaluate(edit.node))
                if isinstance(value, Scalar) and exactly_equal(true, value):
                    text = Writer(latex, cell, notation).write(edit.node)
                    if self._reads_as(text, true):
                        return text, edit.finding
            except (ArmproofError, NotImplementedError):
                continue
        return self._other_number(latex, cell, true, notation) or self._missing_term(latex, cell, true, notation)

    def _other_number(self, latex: str, cell: n.Node, true: Scalar, notation: Notation) -> tuple[str, Finding] | None:
        """Return the cell, of letters, with another number in place of one of its few, a whole one where they are several."""
        if true.is_zero() or not any(isinstance(node, n.Name) for node in n.walk(cell)):
            return None
        powers = {id(power.exponent) for power in n.walk(cell) if isinstance(power, n.Power)}
        numbers = [
            node for node in n.walk(cell) if isinstance(node, n.Number) and node.value and id(node) not in powers
        ]
        for node in numbers if len(numbers) <= MAX_NUMBERS else ():
            for value in self._numbers_for(cell, node, true):
                if value <= 0 or (len(numbers) > 1 and value.denominator > 1):
                    continue
                changed = n.substitute(cell, node, n.Number(value, span=node.span))
                if self._reads_as(text := Writer(latex, cell, notation).write(changed), true):
                    size = "small" if value > node.value else "large"
                    return text, say(Kind.WRONG_NUMBER, number=node.text, size=size)
        return None

    def _numbers_for(self, cell: n.Node, node: n.Number, true: Scalar) -> Iterator[Fraction]:
        """Yield the numbers with which a cell would have a value: of a factor in one of its terms, and of a divisor of them all."""
        if (printed := self._value(cell)) is None:
            return
        rest = self._value(n.substitute(cell, node, n.Number(Fraction(0), "0")))
        quotients = [(printed, true)] if rest is None else [(true - rest, printed - rest), (printed, true)]
        for above, below in quotients:
            if not below.is_zero() and (ratio := (above / below).as_fraction()) is not None:
                yield node.value * ratio

    def _value(self, cell: n.Node) -> Scalar | None:
        try:
            value = as_scalar(Evaluator(self.names, self.exact).evaluate(cell))
        except (ArmproofError, NotImplementedError):
            return None
        return value if isinstance(value, Scalar) and terms_to_write(value) <= MAX_TERMS else None

    def _missing_term(self, latex: str, cell: n.Node, true: Scalar, notation: Notation) -> tuple[str, Finding | None]:
        """Return the cell with one term added, where just one is missing."""
        try:
            printed = as_scalar(Evaluator(self.names, self.exact).evaluate(cell))
            if not isinstance(printed, Scalar) or printed.as_fraction() is not None or true.is_zero():
                return "", None
            if terms_to_write(difference := true - printed) > MAX_TERMS or _is_of_like_terms(difference, printed):
                return "", None
            missing = write_bounded(difference, notation)
        except EvaluationError:
            return "", None
        if not _is_one_term(missing) or "frac" in missing:
            return "", None
        if _is_one_term(right := write_bounded(true, notation)) and not self._has_angles_of(missing, cell, right):
            return "", None
        text = latex[cell.span[0] : cell.span[1]].strip()
        joined = f"{text} - {missing[1:]}" if missing.startswith("-") else f"{text} + {missing}"
        return (joined, say(Kind.MISSING_TERM, term=missing)) if self._reads_as(joined, true) else ("", None)

    def _has_angles_of(self, missing: str, cell: n.Node, true: str) -> bool:
        """Whether a missing term has no sine or cosine of its own: s_1 c_2 for c_1 s_2 lacks no s_{12}, it has them exchanged."""
        try:
            read = [self.names.reader.read_expression(text) for text in (missing, true)]
        except ReadError:
            return False
        own, printed = _angles_of(read[:1]), _angles_of([cell])
        return not printed or all(angle in (*printed, *_angles_of(read[1:])) for angle in own)

    def _reads_as(self, text: str, true: Scalar) -> bool:
        """Whether the corrected LaTeX, read again, is right: what the report offers must verify."""
        try:
            node = self.names.reader.read_expression(text)
            value = as_scalar(Evaluator(self.names, self.exact).evaluate(node))
        except (ReadError, EvaluationError):
            return False
        return isinstance(value, Scalar) and exactly_equal(true, value)


def _is_of_like_terms(one: Scalar, other: Scalar) -> bool:
    """Whether one is a number times the other: 35 x^3 and 15 x^3."""
    return not other.is_zero() and (one / other).as_fraction() is not None


def _is_one_term(latex: str) -> bool:
    """Whether no sum is written, but in brackets."""
    return re.search(r".[ ][-+] ", re.sub(r"\([^()]*\)|\{[^{}]*\}", "", latex)) is None


def _angles_of(nodes: list[n.Node]) -> list[tuple[n.Node, ...]]:
    """Return the angles whose sines and cosines stand in trees."""
    calls = [below for node in nodes for below in n.walk(node) if isinstance(below, n.Call)]
    return [call.arguments for call in calls if call.function in ("cos", "sin")]
