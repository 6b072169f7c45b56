r"""What a display names by an operation that the text tells, and prints without it: "The manipulability is $w = \det J = …$"."""

from __future__ import annotations

from contextlib import suppress

from armproof.verification.document import Display
from armproof.verification.document.told_operations import (
    COMPOSED,
    LENGTH,
    NEVER_NEGATIVE,
    OPERATION,
    SCALED,
    SQUARE,
    TRACE,
)
from armproof.verification.equations.outcome import Outcome
from armproof.verification.errors import ReadError
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare
from armproof.verification.naming.names import Names
from armproof.verification.verdict import HOLDS

_SIZES = ("abs", "norm", "sqrt")
_NAME_AND_TWO = 3  # members of a chain that names what it computes
_SQUARES = 2  # terms of x² + y², which is no length


def unless_of_told_operation(outcome: Outcome, display: Display, names: Names) -> Outcome:
    """Leave open what names the result of an operation, where what it equates with the name has none of it."""
    told = next((each.removeprefix(OPERATION).strip() for each in display.meant if each.startswith(OPERATION)), "")
    if not told or outcome.verdict not in HOLDS:
        return outcome
    with suppress(ReadError, RecursionError):
        chains = [each for each in names.reader.read(display.latex) if isinstance(each, n.Chain)]
        if any(_lacks(told, bare(each.members[1])) for each in chains if _names_result(each)):
            return outcome.left_open(say(Kind.OF_OTHER_QUANTITY))
    return outcome


def _names_result(chain: n.Chain) -> bool:
    return len(chain.members) >= _NAME_AND_TWO and isinstance(bare(chain.members[0]), n.Name)


def _lacks(told: str, said: n.Node) -> bool:
    """Whether an expression shows nothing of an operation."""
    if told == NEVER_NEGATIVE:
        return not any(n.is_call(each, *_SIZES) or _is_square(each) for each in n.walk(said))
    if told == LENGTH:
        return isinstance(said, n.Sum) and sum(_is_square(bare(term)) for _, term in said.terms) >= _SQUARES
    if told == SQUARE:
        return n.is_call(said, *_SIZES)
    if told == TRACE:
        return isinstance(said, n.Call) and not n.is_call(said, "tr", "trace")
    is_plain = isinstance(said, n.Call) or (isinstance(said, n.Name) and not said.dots)
    return told in (SCALED, COMPOSED) and is_plain


def _is_square(node: n.Node) -> bool:
    return isinstance(node, n.Power) and isinstance(node.exponent, n.Number) and node.exponent.value % 2 == 0
