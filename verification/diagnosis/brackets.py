"""Brackets left out or set too wide: a factor or a divisor that stands at one term of a sum is that of several, or the other way round."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from itertools import combinations, pairwise, permutations

from armproof.verification.diagnosis.slips import Change, is_scalar_product, with_items
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n

Parted = tuple[n.Node, Callable[[n.Node], n.Node]]  # a part of a node, and what puts another in its place
_MOST_TERMS = 4  # of a sum in brackets that may be too wide


def missing_brackets(node: n.Node) -> Iterator[Change]:
    """Yield a + b c as (a + b) c: with the factor or the divisor of one term as that of two, or of all."""
    if not isinstance(node, n.Sum):
        return
    finding = say(Kind.MISSING_BRACKETS)
    for k, ((sign, term), (next_sign, next_term)) in enumerate(pairwise(node.terms)):
        for grouped in _grouped(sign, term, next_sign, next_term):
            terms = (*node.terms[:k], (sign, grouped), *node.terms[k + 2 :])
            yield grouped if terms == (("+", grouped),) else replace(node, terms=terms), "term", finding
    if len(node.terms) > 2:
        yield from ((whole, "term", finding) for whole in _of_all(node))


def _grouped(sign: str, term: n.Node, next_sign: str, next_term: n.Node) -> Iterator[n.Node]:
    """Yield two terms as one, with a factor of either in common: of -a + b c, say, (a - b) c and (a + b) c."""
    for inside in dict.fromkeys([next_sign, "+" if next_sign == sign else "-"]):
        for part, put in _parts(next_term):
            yield put(n.Group(n.Sum((("+", term), (inside, part)), span=term.span)))
        for part, put in _parts(term):
            yield put(n.Group(n.Sum((("+", part), (inside, next_term)), span=term.span)))


def _of_all(node: n.Sum) -> Iterator[n.Node]:
    """Yield a sum with a factor or the divisor of its first or its last term as that of all."""
    for place in (0, len(node.terms) - 1):
        sign, term = node.terms[place]
        for part, put in _parts(term):
            yield put(n.Group(replace(node, terms=with_items(node.terms, place, (sign, part)))))


def _parts(node: n.Node) -> Iterator[Parted]:
    """Yield the numerator of a quotient; a product without its first factor, and without its last."""
    if isinstance(node, n.Quotient):
        yield node.numerator, lambda new: replace(node, numerator=new)
    if not is_scalar_product(node):
        return
    first, last = node.factors[0], node.factors[-1]
    yield _product(node, slice(None, -1)), lambda new: n.Product((new, last), ("",), span=node.span)
    yield _product(node, slice(1, None)), lambda new: n.Product((first, new), ("",), span=node.span)


def _product(node: n.Product, kept: slice) -> n.Node:
    factors = node.factors[kept]
    return factors[0] if len(factors) == 1 else n.Product(factors, ("",) * (len(factors) - 1), span=node.span)


def wide_brackets(node: n.Node) -> Iterator[Change]:
    """Yield a (b + c) as a b + c: with a factor before a sum as that of some of its terms."""
    if not is_scalar_product(node) or len(node.factors) > _MOST_TERMS:
        return
    for place, other in permutations(range(len(node.factors)), 2):
        factor, group = node.factors[other], node.factors[place]
        inner = group.inner if isinstance(group, n.Group) else group
        if not isinstance(inner, n.Sum) or not 1 < len(inner.terms) <= _MOST_TERMS:
            continue
        for count in range(1, len(inner.terms)):
            for kept in combinations(range(len(inner.terms)), count):
                terms = tuple(
                    (sign, n.Product((factor, term), ("",)) if k in kept else term)
                    for k, (sign, term) in enumerate(inner.terms)
                )
                narrow = n.Group(n.Sum(terms, span=node.span))
                rest = tuple(each for k, each in enumerate(node.factors) if k not in (place, other))
                yield n.Product((*rest, narrow), ("",) * len(rest)) if rest else narrow, "term", say(Kind.WIDE_BRACKETS)


def moved_brackets(node: n.Node) -> Iterator[Change]:
    """Yield (h a + b) g as h (a + b g), and the other way round: brackets around the wrong parts of a product."""
    if not is_scalar_product(node) or len(node.factors) < 2:
        return
    for place, group in enumerate(node.factors):
        inner = group.inner if isinstance(group, n.Group) else group
        if not isinstance(inner, n.Sum) or len(inner.terms) != 2:
            continue
        (sign, one), (next_sign, other) = inner.terms
        before, behind = node.factors[:place], node.factors[place + 1 :]
        if behind and is_scalar_product(one):
            term = n.Product((other, behind[0]), ("",))
            narrow = n.Group(n.Sum(((sign, _product(one, slice(1, None))), (next_sign, term)), span=node.span))
            yield _of_factors(*before, one.factors[0], narrow, *behind[1:]), "term", say(Kind.MOVED_BRACKETS)
        if before and is_scalar_product(other):
            term = n.Product((before[-1], one), ("",))
            wide = n.Group(n.Sum(((sign, term), (next_sign, _product(other, slice(None, -1)))), span=node.span))
            yield _of_factors(*before[:-1], wide, other.factors[-1], *behind), "term", say(Kind.MOVED_BRACKETS)


def _of_factors(*factors: n.Node) -> n.Node:
    return factors[0] if len(factors) == 1 else n.Product(factors, ("",) * (len(factors) - 1))
