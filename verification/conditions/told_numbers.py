"""What is computed with numbers of which the text says that they are not what they are read as."""

from __future__ import annotations

from collections.abc import Sequence

from armproof.verification.document.sentences import quoted
from armproof.verification.document.told_numbers import numbers_told
from armproof.verification.equations.inequalities import is_numbers
from armproof.verification.equations.outcome import Outcome
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.verdict import DECIDED


def unless_of_told_numbers(outcome: Outcome, meant: Sequence[str]) -> Outcome:
    """Leave open a number that is decided, where the text says something else of the numbers that give it."""
    told = next(numbers_told(meant), None)
    if told is None or outcome.verdict not in DECIDED or not any(map(_is_number, outcome.nodes)):
        return outcome
    return outcome.left_open(say(Kind.NUMBERS_TOLD, text=quoted(told)))


def _is_number(node: n.Node) -> bool:
    """Whether a side is made of numbers, and not of zeros alone."""
    return is_numbers(node) and any(isinstance(below, n.Number) and below.value != 0 for below in n.walk(node))
