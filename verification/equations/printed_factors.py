"""Factors that a product prints: with a zero beside it a wrong entry of R changes nothing, and is none of R all the same."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from armproof.verification.algebra.matrix import Matrix, is_zero
from armproof.verification.equations.rigid import mends_of, of_angles
from armproof.verification.equations.sides import Members
from armproof.verification.findings import Finding, Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare

_SPACE = 3


def factors_otherwise(chain: n.Chain, members: Members) -> Iterator[tuple[int, Finding]]:
    """Yield the place of a member of a chain, and the entry of a matrix in it that is not the named factor's in the member before.

    All other factors of the two products are equal: what the matrix stands for is sure then.
    """
    for place, (before, after) in enumerate(pairwise(chain.members), 1):
        for one, other in zip(_terms(before), _terms(after), strict=False):
            if found := _otherwise(one, other, members):
                yield place, found


def factors_no_rotation(chain: n.Chain, members: Members) -> Iterator[tuple[int, Finding]]:
    """Yield the place of a member of a chain in which a matrix times a column is a rotation but for one entry, which may meet a zero."""
    for place, member in enumerate(chain.members):
        products = (below for below in n.walk(member) if isinstance(below, n.Product))
        for one, other in (pair for product in products for pair in pairwise(map(bare, product.factors))):
            is_turn = isinstance(one, n.Matrix) and len(one.rows) == len(one.rows[0]) == _SPACE and _is_column(other)
            value = members.evaluate(one).value if is_turn else None
            if isinstance(value, Matrix) and of_angles(value) and any(mends_of(value)):
                yield max(1, place), say(Kind.NOT_IN_GROUP, group="SO(3)")


def _is_column(node: n.Node) -> bool:
    return not isinstance(node, n.Matrix) or len(node.rows[0]) == 1


def letters_of_factor(one: n.Node, other: n.Node, members: Members) -> tuple[n.Node, n.Matrix] | None:
    """Return the factor of a product, and the matrix of letters that another one prints in its place; None unless all else is equal."""
    one, other = bare(one), bare(other)
    if not (isinstance(one, n.Product) and isinstance(other, n.Product)) or len(one.factors) != len(other.factors):
        return None
    pairs = [*zip(map(bare, one.factors), map(bare, other.factors), strict=True)]
    values = [tuple(members.evaluate(each).value for each in pair) for pair in pairs]
    unequal = [pair for pair, value in zip(pairs, values, strict=True) if _entry(*value) != ()]
    if len(unequal) != 1 or not isinstance(unequal[0][1], n.Matrix):
        return None
    ((factor, letters),) = unequal
    return factor, letters  # type: ignore[return-value]


def _terms(node: n.Node) -> list[n.Node]:
    node = bare(node)
    return [bare(term) for _, term in node.terms] if isinstance(node, n.Sum) else [node]


def _otherwise(one: n.Node, other: n.Node, members: Members) -> Finding | None:
    if not (isinstance(one, n.Product) and isinstance(other, n.Product)) or len(one.factors) != len(other.factors):
        return None
    pairs = [*zip(map(bare, one.factors), map(bare, other.factors), strict=True)]
    printed = [(name, matrix) for name, matrix in pairs if isinstance(matrix, n.Matrix) and len(matrix.rows[0]) > 1]
    if len(printed) != 1 or isinstance(printed[0][0], n.Matrix):
        return None
    ((name, matrix),) = printed
    values = {id(each): members.evaluate(each).value for pair in pairs for each in pair}
    if any(_entry(values[id(a)], values[id(b)]) != () for a, b in pairs if b is not matrix):
        return None
    if not (entry := _entry(values[id(name)], values[id(matrix)])):
        return None
    text = next((each.text for each in n.names(name)), "")
    return say(Kind.FACTOR_OTHERWISE, name=text, row=entry[0], column=entry[1])


def _entry(one: object, other: object) -> tuple[int, ...] | None:
    """Return the place of the first entry in which two values differ, () where none does, None where they cannot be compared."""
    if not (isinstance(one, Matrix) and isinstance(other, Matrix)) or one.shape != other.shape:
        return None
    cells = ((r, c) for r, c in one.places if not is_zero(one.rows[r][c] - other.rows[r][c]))
    return next(((r + 1, c + 1) for r, c in cells), ())
