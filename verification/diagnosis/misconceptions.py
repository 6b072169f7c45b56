"""Mistakes of a rule rather than of the pen, and what mends them: brackets left out, functions and powers term by term, quotients upside down."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from fractions import Fraction
from itertools import pairwise

from armproof.verification.diagnosis.slips import Change, Edit, is_scalar_product, is_trigonometric, on_all, with_items
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n

Parted = tuple[n.Node, Callable[[n.Node], n.Node]]  # a part of a node, and what puts another in its place

_ARCS = {"asin": "\\arcsin", "acos": "\\arccos", "atan": "\\arctan"}
_TWO = n.Number(Fraction(2), "2")


def misconceptions(root: n.Node) -> Iterator[Edit]:
    """Yield every tree that becomes of `root` if one rule of computing, at one place, was used wrongly."""
    for rule in (_arguments, _arcs, _upside_down, _squares_of_sums, _term_by_term, _brackets):
        yield from on_all(root, rule)


def _arguments(node: n.Node) -> Iterator[Change]:
    """atan2(x, y) for atan2(y, x), and its arguments with another sign."""
    if not isinstance(node, n.Call) or node.function != "atan2" or len(node.arguments) != 2:
        return
    y, x = node.arguments
    yield replace(node, arguments=(x, y)), "function", say(Kind.ARGUMENTS_EXCHANGED)
    for number, arguments in ((1, (_negative(y), x)), (2, (y, _negative(x)))):
        yield replace(node, arguments=arguments), "sign", say(Kind.SIGN_OF_ARGUMENT, number=number)


def _negative(node: n.Node) -> n.Node:
    """Return a term with the other sign, without two signs before it."""
    if isinstance(node, n.Sum) and len(node.terms) == 1:
        sign, term = node.terms[0]
        return term if sign == "-" else n.Sum((("-", term),), span=node.span)
    return n.Sum((("-", n.Group(node) if isinstance(node, n.Sum) else node),), span=node.span)


def _arcs(node: n.Node) -> Iterator[Change]:
    """Another of the arc functions."""
    if isinstance(node, n.Call) and node.function in _ARCS:
        for function, head in _ARCS.items():
            if function != node.function:
                finding = say(Kind.ANOTHER_FUNCTION, printed=_ARCS[node.function][1:], correct=head[1:])
                yield replace(node, function=function, head=head), "function", finding


def _upside_down(node: n.Node) -> Iterator[Change]:
    if isinstance(node, n.Quotient):
        changed = replace(node, numerator=node.denominator, denominator=node.numerator)
        yield changed, "number", say(Kind.UPSIDE_DOWN)


def _term_by_term(node: n.Node) -> Iterator[Change]:
    """sin a + sin b for sin(a + b), and x + y for √(x² + y²): a function of a sum is taken of each term."""
    if not isinstance(node, n.Sum):
        return
    for k, ((sign, term), (next_sign, next_term)) in enumerate(pairwise(node.terms)):
        for kind in (Kind.FUNCTION_TERM_BY_TERM, Kind.ROOT_TERM_BY_TERM):
            joined = _joined(kind, term, "+" if sign == next_sign else "-", next_term)
            if joined is not None:
                terms = (*node.terms[:k], (sign, joined), *node.terms[k + 2 :])
                yield joined if terms == (("+", joined),) else replace(node, terms=terms), "function", say(kind)


def _joined(kind: Kind, one: n.Node, sign: str, other: n.Node) -> n.Node | None:
    """Return the function of the sum of two terms; None where they are no such terms."""
    if kind is Kind.ROOT_TERM_BY_TERM:
        squares = [_squared(each) for each in (one, other)]
        return n.Call("sqrt", (n.Sum((("+", squares[0]), (sign, squares[1]))),), "\\sqrt", "braces")
    if not (is_trigonometric(one) and is_trigonometric(other) and one.function == other.function):
        return None
    first, second = one.arguments[0], other.arguments[0]
    if isinstance(first, n.JointAngles) and isinstance(second, n.JointAngles):
        turned = tuple((factor * (1 if sign == "+" else -1), index) for factor, index in second.terms)
        if {index for _, index in first.terms} & {index for _, index in turned}:
            return None
        return replace(
            one, arguments=(n.JointAngles(tuple(sorted((*first.terms, *turned), key=lambda each: each[1]))),)
        )
    style = {"letter": "letter()", "macro": "macro()"}.get(one.style, one.style)
    return replace(one, arguments=(n.Sum((("+", first), (sign, second))),), style=style)


def _squared(node: n.Node) -> n.Node:
    """Return the square of a term, of a root what stands under it."""
    if isinstance(node, n.Call) and node.function == "sqrt" and len(node.arguments) == 1:
        return n.Group(node.arguments[0])
    return n.Power(node if isinstance(node, n.Name) else n.Group(node), _TWO)


def _squares_of_sums(node: n.Node) -> Iterator[Change]:
    """(a + b)² for a² + b², and the other way round."""
    if isinstance(node, n.Power) and node.exponent == _TWO:
        inner = node.base.inner if isinstance(node.base, n.Group) else node.base
        if isinstance(inner, n.Sum) and len(inner.terms) > 1:
            squares = tuple(("+", _squared(term)) for _, term in inner.terms)
            yield n.Group(n.Sum(squares, span=node.span)), "number", say(Kind.SQUARE_OF_SUM)
    if isinstance(node, n.Sum):
        for k, ((sign, one), (next_sign, other)) in enumerate(pairwise(node.terms)):
            bases = [each.base for each in (one, other) if isinstance(each, n.Power) and each.exponent == _TWO]
            if len(bases) == 2 and sign == next_sign:
                for inside in ("+", "-"):
                    whole = n.Power(n.Group(n.Sum((("+", bases[0]), (inside, bases[1])))), _TWO)
                    terms = (*node.terms[:k], (sign, whole), *node.terms[k + 2 :])
                    yield (
                        whole if terms == (("+", whole),) else replace(node, terms=terms),
                        "number",
                        say(Kind.SUM_OF_SQUARES),
                    )


def _brackets(node: n.Node) -> Iterator[Change]:
    """a + b c for (a + b) c: a factor or a divisor that stands at one term of a sum is that of two, or of all."""
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
    """Yield two terms as one, with the factor of either in common: of -a + b c, say, (a - b) c and (a + b) c."""
    for inside in dict.fromkeys([next_sign, "+" if next_sign == sign else "-"]):
        if (parts := _first_factor(next_term)) is not None:
            yield parts[1](n.Group(n.Sum((("+", term), (inside, parts[0])), span=term.span)))
        if (parts := _last_factor(term)) is not None:
            yield parts[1](n.Group(n.Sum((("+", parts[0]), (inside, next_term)), span=term.span)))


def _of_all(node: n.Sum) -> Iterator[n.Node]:
    """Yield a sum with the last factor or divisor of its last term, or the first factor of its first term, as that of all."""
    sign, last = node.terms[-1]
    if (parts := _first_factor(last)) is not None:
        if isinstance(last, n.Quotient):
            yield replace(last, numerator=replace(node, terms=(*node.terms[:-1], (sign, parts[0]))))
        else:
            less = _without_last(last)
            if less is not None:
                yield n.Product(
                    (n.Group(replace(node, terms=(*node.terms[:-1], (sign, less[0])))), less[1]), ("",), span=node.span
                )
    first_sign, first = node.terms[0]
    if (parts := _last_factor(first)) is not None and first_sign == "+":
        yield parts[1](n.Group(n.Sum((("+", parts[0]), *node.terms[1:]), span=node.span)))


def _without_last(node: n.Node) -> tuple[n.Node, n.Node] | None:
    """Return a product without its last factor, and that factor."""
    if not is_scalar_product(node):
        return None
    factors = node.factors[:-1]
    rest = factors[0] if len(factors) == 1 else replace(node, factors=factors, operators=node.operators[:-1])
    return rest, node.factors[-1]


def _first_factor(node: n.Node) -> Parted | None:
    """Return the first factor of a product, or the numerator of a quotient."""
    if isinstance(node, n.Quotient):
        return node.numerator, lambda new: replace(node, numerator=new)
    if is_scalar_product(node):
        return node.factors[0], lambda new: replace(node, factors=with_items(node.factors, 0, new))
    return None


def _last_factor(node: n.Node) -> Parted | None:
    """Return the last factor of a product."""
    if not is_scalar_product(node):
        return None
    return node.factors[-1], lambda new: replace(node, factors=(*node.factors[:-1], new))
