"""Which index of T^i_j names the reference frame, as the document's own link matrices show it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from armproof.verification.algebra.ring import Scalar
from armproof.verification.document import Display
from armproof.verification.equations.alignment import align, different_entries, exactly_equal
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.equations.sides import Member
from armproof.verification.errors import EvaluationError, ReadError
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare
from armproof.verification.naming.quantities import leads_outwards
from armproof.verification.patterns import regex

DIRECTIONS = ("upper", "lower")
FEW = 2  # wrong entries of a matrix that tells the direction all the same,
MANY = 2  # of more than so many times as many that are no numbers
TWO_SCRIPTS = regex(r"[TAHR]\}*\s*(?:_\s*(?:\w|\{[^{}]*\})\s*\^|\^\s*(?:\w|\{[^{}]*\})\s*_)")


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
        read = [(chain, display.line) for display in displays for chain in _chains(checker, display)]
        for most in (0, FEW):  # a matrix with a slip tells it where none without one does
            for chain, line in read:
                if (direction := _shown_by(checker, chain, most)) is not None:
                    return direction, line
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


def _shown_by(checker: ChainChecker, chain: n.Chain, most: int) -> str | None:
    """A matrix that is printed for T^i_j, with at `most` so many wrong entries, is the pose of the frame that is farther from the base."""
    names = [node for member in chain.members if isinstance(node := bare(member), n.Name) and node.sub and node.sup]
    matrices = [member for member in chain.members if isinstance(bare(member), n.Matrix)]
    holding = [d for d in DIRECTIONS if names and matrices and _holds(checker, names[0], matrices[0], d, most)]
    return holding[0] if len(holding) == 1 else None


def _holds(checker: ChainChecker, name: n.Name, matrix: n.Node, direction: str, most: int) -> bool:
    names = checker.names
    names.state.transforms = direction
    if names.arm is None or name.base not in "TAHR" or not leads_outwards(name, names.arm, direction):
        return False
    return _equal(checker, checker.member(name), checker.member(matrix), most)


def _equal(checker: ChainChecker, true: Member, printed: Member, most: int) -> bool:
    try:
        pairs = list(align(true.value, printed.value, checker.exact)) if true.known and printed.known else []
    except EvaluationError:
        return False
    telling = [sum(not _is_number(cell) for cell in pair.printed.cells) for pair in pairs]
    wrong = [len(different_entries(pair, exactly_equal)) for pair in pairs]
    return any(count > MANY * most and off <= most for count, off in zip(telling, wrong, strict=True))


def _is_number(cell: object) -> bool:
    return not isinstance(cell, Scalar) or cell.as_fraction() is not None
