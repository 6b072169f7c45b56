"""What a correction leaves as it is: the quantity that an equation is about; and what it may not write, a tautology."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Sequence

from armproof.verification.correction.alternatives import IDENTITY, Corrections
from armproof.verification.equations.outcome import Outcome
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare
from armproof.verification.naming.names import Names
from armproof.verification.patterns import regex

_LAYOUT = regex(r"\\(?:left|right|[,;:! ])|[&\s(){}]")


def quantities(names: Names, statements: Sequence[n.Statement], outcomes: Sequence[Outcome]) -> list[n.Name]:
    """Return the names that say what an equation is about: a correction changes what is said of them, not them.

    A cell of a matrix is an entry, whatever stands in it; only a matrix of nothing but names is itself a quantity.
    """
    found = [
        each
        for each in _outside_matrices(statements)
        if isinstance(each, n.Name)
        and names.known_symbol(each.key) is None
        and not names.is_free(each)
        and not IDENTITY.fullmatch(each.key)
    ]
    first = [statement.members[0].span for statement in statements if isinstance(statement, n.Chain)]
    said = [  # of another quantity, by a formula that has a value and stands behind an equals sign
        outcome.printed.node.span
        for outcome in outcomes
        if outcome.pair is not None
        and outcome.printed is not None
        and outcome.true is not None
        and outcome.printed.node.span not in first
        and any(_within(each, outcome.true.node.span) for each in found)
    ]
    return [each for each in found if not any(_within(each, span) for span in said)]


def keeps(latex: str, corrections: Corrections, names: Sequence[n.Name]) -> bool:
    """Whether corrections leave names where they stand, or write them again as often."""
    for change in corrections:
        over = [
            latex[slice(*name.span)].strip()
            for name in names
            if change.start < name.span[1] and name.span[0] < change.end
        ]
        if any(change.text.count(name) < number for name, number in Counter(over).items()):
            return False
    return True


def tautologies(latex: str, statements: Sequence[n.Statement]) -> int:
    """Return how many members of the equations are written, but for brackets and blanks, as one before them is."""
    repeated = 0
    for statement in statements:
        if isinstance(statement, n.Chain) and "=" in statement.relations:
            written = [_LAYOUT.sub("", latex[slice(*member.span)]) for member in statement.members]
            repeated += len(written) - len(set(written))
    return repeated


def _outside_matrices(nodes: Iterable[object]) -> Iterator[n.Node]:
    for node in nodes:
        if isinstance(node, n.Node) and (not isinstance(node, n.Matrix) or _is_of_names(node)):
            yield node
            yield from _outside_matrices(n.children(node))


def _is_of_names(matrix: n.Matrix) -> bool:
    return all(isinstance(bare(cell), n.Name) for cell in matrix.cells)


def _within(name: n.Name, span: tuple[int, int]) -> bool:
    return span[0] <= name.span[0] and name.span[1] <= span[1]
