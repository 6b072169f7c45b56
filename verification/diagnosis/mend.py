"""The one small change that mends a cell: an edit of what is printed, or a term added to it."""

from __future__ import annotations

import re
from collections.abc import Callable

from armproof.models.errors import ArmproofError
from armproof.verification.algebra.ring import Scalar
from armproof.verification.algebra.values import as_scalar
from armproof.verification.algebra.written import write_bounded
from armproof.verification.diagnosis.learnt_notation import LearntNotation
from armproof.verification.diagnosis.slips import single_edits
from armproof.verification.equations.alignment import exactly_equal
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.errors import EvaluationError, ReadError
from armproof.verification.evaluation.evaluator import Evaluator
from armproof.verification.findings import Finding, Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.writer import Notation, Writer

MAX_EDITS = 600

Agreement = Callable[[Scalar], Callable[[n.Node], bool] | None]  # whether trees may have a value, as samples tell


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
        for count, edit in enumerate(single_edits(cell, self.learnt.letters(cell))):
            if count > MAX_EDITS or self.exact.budget.is_spent:
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
        return self._missing_term(latex, cell, true, notation)

    def _missing_term(self, latex: str, cell: n.Node, true: Scalar, notation: Notation) -> tuple[str, Finding | None]:
        """Return the cell with one term added, where just one is missing."""
        try:
            printed = as_scalar(Evaluator(self.names, self.exact).evaluate(cell))
            if not isinstance(printed, Scalar) or printed.as_fraction() is not None or true.is_zero():
                return "", None
            missing = write_bounded(true - printed, notation)
        except EvaluationError:
            return "", None
        if re.search(r".[ ][-+] ", re.sub(r"\([^()]*\)|\{[^{}]*\}", "", missing)) or "frac" in missing:
            return "", None
        text = latex[cell.span[0] : cell.span[1]].strip()
        joined = f"{text} - {missing[1:]}" if missing.startswith("-") else f"{text} + {missing}"
        return (joined, say(Kind.MISSING_TERM, term=missing)) if self._reads_as(joined, true) else ("", None)

    def _reads_as(self, text: str, true: Scalar) -> bool:
        """Whether the corrected LaTeX, read again, is right: what the report offers must verify."""
        try:
            node = self.names.reader.read_expression(text)
            value = as_scalar(Evaluator(self.names, self.exact).evaluate(node))
        except (ReadError, EvaluationError):
            return False
        return isinstance(value, Scalar) and exactly_equal(true, value)
