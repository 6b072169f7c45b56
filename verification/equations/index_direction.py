"""Which index of T^i_j names the reference frame, as the document's own link matrices show it."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from armproof.verification.algebra.ring import Scalar
from armproof.verification.document import Display
from armproof.verification.equations.alignment import agree_exactly, align
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.equations.sides import Member
from armproof.verification.errors import EvaluationError, ReadError
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare
from armproof.verification.naming.quantities import leads_outwards

DIRECTIONS = ("upper", "lower")
TWO_SCRIPTS = re.compile(r"[TAHR]\}*\s*(?:_\s*(?:\w|\{[^{}]*\})\s*\^|\^\s*(?:\w|\{[^{}]*\})\s*_)")


def shown_direction(checker: ChainChecker, displays: Iterable[Display]) -> tuple[str, int] | None:
    """Return the direction in which the first telling link matrix holds, and its line; None where none tells.

    Args:
        displays: those in which a transform has TWO_SCRIPTS.
    """
    names = checker.names
    if names.arm is None or names.stated_transforms:
        return None
    before = names.state.transforms
    try:
        for display in displays:
            for chain in _chains(checker, display):
                if (direction := _shown_by(checker, chain)) is not None:
                    return direction, display.line
    finally:
        names.state.transforms = before
    return None


def _chains(checker: ChainChecker, display: Display) -> Iterator[n.Chain]:
    if display.erratum or not display.closed:
        return
    try:
        statements = checker.names.reader.read(display.latex)
    except (ReadError, RecursionError):
        return
    yield from (each for each in statements if isinstance(each, n.Chain) and set(each.relations) == {"="})


def _shown_by(checker: ChainChecker, chain: n.Chain) -> str | None:
    """A matrix that is printed for T^i_j is the pose of the frame that is farther from the base."""
    names = [node for member in chain.members if isinstance(node := bare(member), n.Name) and node.sub and node.sup]
    matrices = [member for member in chain.members if isinstance(bare(member), n.Matrix)]
    holding = [d for d in DIRECTIONS if names and matrices and _holds(checker, names[0], matrices[0], d)]
    return holding[0] if len(holding) == 1 else None


def _holds(checker: ChainChecker, name: n.Name, matrix: n.Node, direction: str) -> bool:
    names = checker.names
    names.state.transforms = direction
    if names.arm is None or name.base not in "TAHR" or not leads_outwards(name, names.arm, direction):
        return False
    return _equal(checker, checker.member(name), checker.member(matrix))


def _equal(checker: ChainChecker, true: Member, printed: Member) -> bool:
    try:
        pairs = list(align(true.value, printed.value, checker.exact)) if true.known and printed.known else []
    except EvaluationError:
        return False
    cells = [cell for pair in pairs for cell in pair.printed.cells]
    telling = any(isinstance(cell, Scalar) and cell.as_fraction() is None for cell in cells)
    return telling and any(agree_exactly(pair) for pair in pairs)
