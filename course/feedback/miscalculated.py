"""What goes wrong when a formula is worked out: another sign or function, a part left out, a quotient or a root taken wrongly."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from itertools import combinations

from armproof.course.feedback.guesses import neighbours_exchanged
from armproof.verification.diagnosis.slips import (
    Letters,
    dropping_edits,
    is_trigonometric,
    plain_edits,
    sign_pairs,
)
from armproof.verification.findings import Kind
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare

_QUARTER, _HALF = (n.Number(Fraction(degrees), str(degrees)) for degrees in (90, 180))
_ONE = n.Number(Fraction(1), "1")
_DECIMALS = 6
_MOST_TERMS = 6  # of a sum of which two are left out
_NONE = Letters()


def done_otherwise(tree: n.Node) -> Iterator[n.Node]:
    """Yield the formulas in which one thing is done otherwise, the most likely first."""
    yield from (edit.node for edit in plain_edits(tree, _NONE))
    for node in n.walk(tree):
        for other in _otherwise(node):
            yield n.substitute(tree, node, other)
    yield from (edit.node for edit in dropping_edits(tree, _NONE) if edit.finding.kind is not Kind.WRONG_NUMBER)


def done_twice(tree: n.Node) -> Iterator[n.Node]:
    """Yield the formulas in which two like things are done otherwise: two signs, or two terms left out of a long sum."""
    yield from (edit.node for edit in sign_pairs(tree))
    if isinstance(tree, n.Sum) and 3 < len(tree.terms) <= _MOST_TERMS:
        for some in combinations(tree.terms, len(tree.terms) - 2):
            yield replace(tree, terms=some)


def _otherwise(node: n.Node) -> Iterator[n.Node]:
    """Yield what becomes of one node: a root left out, a quotient turned or multiplied, …"""
    if n.is_call(node, "sqrt"):
        yield from _without_root(node.arguments[0])
    elif n.is_call(node, "atan2"):
        above, below = node.arguments
        yield replace(node, arguments=(below, above))
        yield n.Quotient(above, below, "slash")
    elif isinstance(node, n.Quotient):
        yield replace(node, numerator=node.denominator, denominator=node.numerator)
        yield n.Product((node.numerator, node.denominator), ("⋅",))
        yield node.numerator
        yield replace(node, numerator=_ONE)
        yield replace(node, numerator=_ONE, denominator=n.Group(n.Product((node.numerator, node.denominator), ("⋅",))))
        yield from _as_far_as_the_first_term(node)
    elif isinstance(node, n.Product):
        yield from _without_brackets(node)
    elif is_trigonometric(node):
        yield from _other_angles(node)


def _without_root(under: n.Node) -> Iterator[n.Node]:
    """Yield what stands under a root, and a sum of squares whose root is taken term by term."""
    yield under
    total = bare(under)
    if isinstance(total, n.Sum) and all(isinstance(term, n.Power) for _, term in total.terms):
        yield n.Group(n.Sum(tuple((sign, term.base) for sign, term in total.terms if isinstance(term, n.Power))))


def _without_brackets(node: n.Product) -> Iterator[n.Node]:
    """Yield a product with the last factor's brackets left out, so that its first term alone is multiplied; and the sum of two factors."""
    *others, last = node.factors
    total = bare(last)
    if isinstance(total, n.Sum) and len(total.terms) > 1:
        (sign, first), *rest = total.terms
        yield n.Group(n.Sum(((sign, replace(node, factors=(*others, first))), *rest)))
    if len(others) == 1 and not any(map(is_trigonometric, n.walk(node))):
        yield n.Group(n.Sum((("+", others[0]), ("+", last))))


def _as_far_as_the_first_term(node: n.Quotient) -> Iterator[n.Node]:
    """Yield a quotient without its brackets: the last term above the line alone is divided."""
    total = bare(node.numerator)
    if isinstance(total, n.Sum) and len(total.terms) > 1:
        *others, (sign, last) = total.terms
        yield n.Group(n.Sum((*others, (sign, replace(node, numerator=last)))))


def _other_angles(node: n.Call) -> Iterator[n.Node]:
    """Yield a sine or cosine of the other angle on the line, and of that to the right angle."""
    if isinstance(node.arguments[0], n.Postfix) or not any(isinstance(part, n.Postfix) for part in n.walk(node)):
        return
    for degrees in (_HALF, _QUARTER):
        other = n.Sum((("+", n.Postfix(degrees, "deg")), ("-", n.Group(bare(node.arguments[0])))))
        yield replace(node, arguments=(other,), style="macro()")


def without_degrees(tree: n.Node) -> n.Node:
    """Return a formula with the numbers of its degrees taken as radians."""
    return n.substitute_each(
        tree, {id(node): node.base for node in n.walk(tree) if isinstance(node, n.Postfix) and node.operator == "deg"}
    )


def leaves_of(tree: n.Node) -> list[n.Name | n.Number]:
    """Return the given values in a formula: its letters, and its numbers that are no exponents and no degrees."""
    apart = {id(node.exponent) for node in n.walk(tree) if isinstance(node, n.Power)}
    apart |= {id(node.base) for node in n.walk(tree) if isinstance(node, n.Postfix)}
    return [node for node in n.walk(tree) if isinstance(node, n.Name | n.Number) and id(node) not in apart]


def misread(value: float) -> Iterator[float]:
    """Yield a given value with its point one place further, and with two of its digits exchanged."""
    yield from (value / 10, value * 10)
    text = f"{value:.{_DECIMALS}g}"
    if "e" not in text:
        yield from map(float, neighbours_exchanged(text))


def number_node(value: float) -> n.Node:
    """Return a number as a tree, in brackets where it is negative."""
    text = f"{abs(value):.{_DECIMALS}g}"
    number = n.Number(Fraction(text), text)
    return number if value >= 0 else n.Group(n.Sum((("-", number),)))
