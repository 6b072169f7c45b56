"""Rules that students' formulas break: brackets of an argument left out, roots on the wrong side or where none belongs, squares forgotten."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from itertools import chain, pairwise
from typing import TypeGuard

from armproof.verification.diagnosis.slips import Change, Edit, is_scalar_product, is_trigonometric, on_all, with_items
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare

_ARCS = ("asin", "acos", "atan")
_TWO = n.Number(Fraction(2), "2")


def rule_slips(cell: n.Node) -> Iterator[Edit]:
    """Yield the trees that become of an entry if one of these rules is kept."""
    return chain(
        on_all(cell, _short_arguments),
        roots_astray(cell),
        on_all(cell, _squares_lost),
        on_all(cell, _roots_lost),
        _groups_squared(cell),
        on_all(cell, _extra_roots),
    )


def roots_astray(cell: n.Node) -> Iterator[Edit]:
    """Yield the trees in which a root of a number is on the other side of the line, is left out, or is taken."""
    for rule in (_roots_on_other_side, _roots):
        yield from on_all(cell, rule)


def arguments_exchanged(cell: n.Node) -> Iterator[Edit]:
    """Yield the tree with the arguments of every atan2 exchanged, where there are several: in values that looks like a wrong sign."""
    calls = [node for node in n.walk(cell) if n.is_call(node, "atan2") and len(node.arguments) == 2]
    if len(calls) > 1:
        turned: dict[int, n.Node] = {id(call): replace(call, arguments=call.arguments[::-1]) for call in calls}
        yield Edit(n.substitute_each(cell, turned), "function", say(Kind.ARGUMENTS_EXCHANGED))


def _short_arguments(node: n.Node) -> Iterator[Change]:
    """cos θ_1 + θ_2 as cos(θ_1 + θ_2), and sin a / 2 as sin(a / 2): an argument without its brackets."""
    if isinstance(node, n.Quotient) and _is_of_one_argument(call := bare(node.numerator)):
        divided = replace(node, numerator=call.arguments[0])
        yield replace(call, arguments=(divided,), style="macro()"), "function", say(Kind.ARGUMENT_TOO_SHORT)
    if not isinstance(node, n.Sum):
        return
    for k, ((sign, term), (next_sign, next_term)) in enumerate(pairwise(node.terms)):
        *before, call = term.factors if is_scalar_product(term) else (term,)
        if not is_trigonometric(call) or not _has_letters(call):
            continue
        inside = n.Sum((("+", call.arguments[0]), (next_sign, next_term)))
        whole: n.Node = replace(call, arguments=(inside,), style="macro()")
        if isinstance(term, n.Product):
            whole = replace(term, factors=(*before, whole))
        terms = (*node.terms[:k], (sign, whole), *node.terms[k + 2 :])
        changed = whole if terms == (("+", whole),) else replace(node, terms=terms)
        yield changed, "function", say(Kind.ARGUMENT_TOO_SHORT)


def _is_of_one_argument(node: n.Node) -> TypeGuard[n.Call]:
    """Whether a node is a function of an angle, or the angle of one."""
    is_of_angle = is_trigonometric(node) or n.is_call(node, *_ARCS)
    return isinstance(node, n.Call) and is_of_angle and _has_letters(node)


def _has_letters(call: n.Call) -> bool:
    """Whether the argument of a function is written as such, and no index as in C_{12}."""
    return not isinstance(call.arguments[0], n.JointAngles)


def _roots_on_other_side(node: n.Node) -> Iterator[Change]:
    """A root of a number above the line as one below it, and the other way round."""
    finding = say(Kind.ROOT_ON_OTHER_SIDE)
    if isinstance(node, n.Product) or _is_root(node):
        factors = node.factors if isinstance(node, n.Product) else (node,)
        for k, factor in enumerate(factors):
            if _is_root(factor):
                yield n.Quotient(_product(with_items(factors, k)), factor, "frac", span=node.span), "number", finding
    if isinstance(node, n.Quotient):
        below = bare(node.denominator)
        factors = below.factors if isinstance(below, n.Product) else (below,)
        for k, factor in enumerate(factors):
            if _is_root(factor):
                above = n.Product((n.Group(node.numerator), factor), ("",))
                yield replace(node, numerator=above, denominator=_product(with_items(factors, k))), "number", finding


def _is_root(node: n.Node) -> TypeGuard[n.Call]:
    """Whether a node is the root of a number."""
    return n.is_call(node, "sqrt") and isinstance(bare(node.arguments[0]), n.Number)


def _product(factors: tuple[n.Node, ...]) -> n.Node:
    if not factors:
        return n.Number(Fraction(1), "1")
    return factors[0] if len(factors) == 1 else n.Product(factors, ("",) * (len(factors) - 1))


def _roots(node: n.Node) -> Iterator[Change]:
    """A number as its root, and a root as the number."""
    if _is_root(node):
        yield node.arguments[0], "number", say(Kind.EXTRA_ROOT)
    elif isinstance(node, n.Number) and math.isqrt(int(node.value)) ** 2 != node.value > 0:  # √4 is another number
        yield n.Call("sqrt", (node,), "\\sqrt", "braces"), "number", say(Kind.MISSING_ROOT)


def _roots_lost(node: n.Node) -> Iterator[Change]:
    """x² + y² as √(x² + y²), and x² + y² - a as √(x² + y²) - a."""
    if not isinstance(node, n.Sum) or len(node.terms) < 2:
        return
    squares = next((k for k, (_, term) in enumerate(node.terms) if not _is_square(term)), len(node.terms))
    if squares > 1 and node.terms[0][0] == "+":
        root = n.Call("sqrt", (n.Sum(node.terms[:squares]),), "\\sqrt", "braces")
        rest = node.terms[squares:]
        changed = replace(node, terms=(("+", root), *rest)) if rest else root
        yield changed, "function", say(Kind.MISSING_ROOT)


def _extra_roots(node: n.Node) -> Iterator[Change]:
    """√(x² + y²) as x² + y²."""
    if n.is_call(node, "sqrt"):
        yield n.Group(node.arguments[0]), "function", say(Kind.EXTRA_ROOT)


def _is_square(node: n.Node) -> bool:
    return isinstance(node, n.Power) and node.exponent == _TWO


def _squares_lost(node: n.Node) -> Iterator[Change]:
    """x + y, or 2 x + 2 y, as x² + y², of all letters of a sum; and a sum in brackets as its square."""
    if not isinstance(node, n.Sum) or len(node.terms) < 2:
        return
    letters = [_to_be_squared(term) for _, term in node.terms]
    if sum(letter is not None for letter in letters) > 1:
        pairs = zip(node.terms, letters, strict=True)
        squared = tuple((sign, term if letter is None else n.Power(letter, _TWO)) for (sign, term), letter in pairs)
        yield replace(node, terms=squared), "number", say(Kind.MISSING_SQUARES)
    for k, (sign, term) in enumerate(node.terms):
        if isinstance(term, n.Group) and isinstance(bare(term), n.Sum):
            terms = with_items(node.terms, k, (sign, n.Power(term, _TWO)))
            yield replace(node, terms=terms), "number", say(Kind.MISSING_SQUARE)


def _to_be_squared(term: n.Node) -> n.Name | None:
    """Return the letter of a term that may be its square: x, and 2 x, which x*2 is for x**2; None of any other term."""
    if is_scalar_product(term) and len(term.factors) == 2 and _TWO in term.factors:
        term = next(factor for factor in term.factors if factor != _TWO)
    return term if isinstance(term, n.Name) else None


def _groups_squared(cell: n.Node) -> Iterator[Edit]:
    """Yield the tree with all sums in brackets squared that are terms of a sum, where they are several."""
    terms = [term for node in n.walk(cell) if isinstance(node, n.Sum) for _, term in node.terms]
    groups = [term for term in terms if isinstance(term, n.Group) and isinstance(bare(term), n.Sum)]
    if len(groups) > 1:
        squares: dict[int, n.Node] = {id(group): n.Power(group, _TWO) for group in groups}
        yield Edit(n.substitute_each(cell, squares), "number", say(Kind.MISSING_SQUARES))
