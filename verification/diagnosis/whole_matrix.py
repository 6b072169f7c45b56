"""A matrix that disagrees as a whole, decided exactly: where it is no quantity of an arm that samples could tell."""

from __future__ import annotations

from collections.abc import Iterator

from armproof.models.errors import ArmproofError
from armproof.verification.algebra.matrix import Matrix, inverse_pose, is_zero
from armproof.verification.algebra.protocol import link_matrix
from armproof.verification.equations.alignment import Pair, equal_matrices, exactly_equal
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.equations.outcome import Outcome
from armproof.verification.findings import Finding, Kind, say
from armproof.verification.latex import nodes as n

Candidate = tuple[Finding, Matrix]


def whole_matrix(checker: ChainChecker, outcome: Outcome) -> Finding | None:
    """Return which other matrix was printed: transposed, inverted, of the other sign, the other general link matrix."""
    pair, true = outcome.pair, outcome.true
    if pair is None or true is None or outcome.sampled_only or pair.is_scalar or is_zero(pair.printed):
        return None
    try:
        return next(
            (said for said, other in _others(checker, true.node, pair) if equal_matrices(other, pair.printed)), None
        )
    except ArmproofError:
        return None


def _others(checker: ChainChecker, node: n.Node, pair: Pair) -> Iterator[Candidate]:
    true = pair.true
    if true.shape[0] == true.shape[1] > 1:
        yield say(Kind.TRANSPOSED), true.transpose
    yield say(Kind.SIGN_OF_WHOLE), true.map(lambda cell: -cell)
    if isinstance(node, n.Name) and node.base == "link":
        yield from _other_links(checker, node.sub)
    elif true.shape == (4, 4):
        yield say(Kind.INVERTED), inverse_pose(true)


def _other_links(checker: ChainChecker, convention: str) -> Iterator[Candidate]:
    """Yield the general link matrix of the other convention, in its own letters and in those of this one."""
    exact, other = checker.exact, "classic" if convention == "modified" else "modified"
    here, there = ("i-1", "i") if convention == "modified" else ("i", "i-1")
    renamed = {f"{letter}_{there}": exact.symbol(f"{letter}_{here}") for letter in ("a", "alpha")}
    for matrix in (link_matrix(exact, other), exact.substitute(link_matrix(exact, other), renamed)):
        yield say(Kind.OTHER_GENERAL_LINK, other=other, convention=convention), matrix


def swapped_cells(outcome: Outcome) -> Finding | None:
    """Return that the two wrong entries are each other's."""
    pair = outcome.pair
    if pair is None or len(outcome.wrong) != 2 or outcome.sampled_only:
        return None
    (r, c), (s, d) = outcome.wrong
    true, printed = pair.true.rows, pair.printed.rows
    if exactly_equal(true[r][c], printed[s][d]) and exactly_equal(true[s][d], printed[r][c]):
        return say(Kind.SWAPPED_ENTRIES, row=r + 1, column=c + 1, other_row=s + 1, other_column=d + 1)
    return None
