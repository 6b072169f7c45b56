"""Equal formulas: terms and factors in another order, expanded, factored, with a sign or a one in another place."""

from __future__ import annotations

import random
from collections.abc import Callable, Iterator
from dataclasses import replace
from fractions import Fraction

from armproof.verification.latex import nodes as n

IsScalar = Callable[[n.Node], bool]
Rule = Callable[[n.Node, random.Random, IsScalar], n.Node | None]
FLIPPED = {"+": "-", "-": "+", "±": "∓", "∓": "±"}


def rewritten(root: n.Node, rule: Rule, chance: random.Random, is_scalar: IsScalar) -> n.Node | None:
    """Return the tree with one rule applied at one place; None where it applies nowhere."""
    found = list(_values(root))
    for node in chance.sample(found, len(found)):
        changed = rule(node, chance, is_scalar)
        if changed is not None:
            return n.substitute(root, node, changed)
    return None


def _values(node: n.Node) -> Iterator[n.Node]:
    """Yield the sums, products and functions that stand for values."""
    yield node
    if isinstance(node, n.Call | n.Power | n.Postfix | n.Labelled):
        return
    children = (
        [node.inner]
        if isinstance(node, n.At)
        else [node.operand]
        if isinstance(node, n.Derivative)
        else n.children(node)
    )
    for child in children:
        yield from _values(child)


def _group(node: n.Node) -> n.Node:
    return n.Group(node) if isinstance(node, n.Sum) else node


def _negated(node: n.Sum) -> n.Sum:
    return n.Sum(tuple((FLIPPED[sign], term) for sign, term in node.terms))


def _scalar_product(node: n.Node, is_scalar: IsScalar) -> bool:
    return (
        isinstance(node, n.Product) and "×" not in node.operators and all(is_scalar(factor) for factor in node.factors)
    )


def _times(*factors: n.Node) -> n.Product:
    """A product; a dot before a number or a bracket, which could be read as an index or an argument."""
    flat = [
        f
        for factor in factors
        for f in (
            factor.factors if isinstance(factor, n.Product) and "×" not in factor.operators else (_group(factor),)
        )
    ]
    return n.Product(
        tuple(flat), tuple("⋅" if isinstance(f, n.Number | n.Group | n.Quotient) else "" for f in flat[1:])
    )


def reordered_terms(node: n.Node, chance: random.Random, is_scalar: IsScalar) -> n.Node | None:
    if not isinstance(node, n.Sum) or len(node.terms) < 2:
        return None
    turn = chance.randrange(1, len(node.terms))
    return n.Sum((*node.terms[turn:], *node.terms[:turn]))


def reordered_factors(node: n.Node, chance: random.Random, is_scalar: IsScalar) -> n.Node | None:
    if not isinstance(node, n.Product) or not _scalar_product(node, is_scalar):
        return None
    turn = chance.randrange(1, len(node.factors))
    return _times(*node.factors[turn:], *node.factors[:turn])


def expanded(node: n.Node, chance: random.Random, is_scalar: IsScalar) -> n.Node | None:
    """a (b + c) d → a b d + a c d"""
    if not isinstance(node, n.Product) or "×" in node.operators:
        return None
    for k, factor in enumerate(node.factors):
        if isinstance(factor, n.Group) and isinstance(factor.inner, n.Sum) and is_scalar(factor):
            before, after = node.factors[:k], node.factors[k + 1 :]
            return n.Sum(tuple((sign, _times(*before, term, *after)) for sign, term in factor.inner.terms))
    return None


def factored(node: n.Node, chance: random.Random, is_scalar: IsScalar) -> n.Node | None:
    """a b + a c + d → a (b + c) + d"""
    if not isinstance(node, n.Sum):
        return None
    products = [
        (k, sign, term)
        for k, (sign, term) in enumerate(node.terms)
        if isinstance(term, n.Product) and _scalar_product(term, is_scalar)
    ]
    for i, (k, first_sign, first) in enumerate(products):
        for m, other_sign, other in products[i + 1 :]:
            for factor in first.factors:
                if factor in other.factors and "±" not in first_sign + other_sign:
                    inside = n.Group(
                        n.Sum(((first_sign, _without(first, factor)), (other_sign, _without(other, factor))))
                    )
                    rest = tuple(t for j, t in enumerate(node.terms) if j not in (k, m))
                    return n.Sum((("+", _times(factor, inside)), *rest))
    return None


def _without(product: n.Product, factor: n.Node) -> n.Node:
    rest = list(product.factors)
    rest.remove(factor)
    return rest[0] if len(rest) == 1 else _times(*rest)


def sign_pulled_out(node: n.Node, chance: random.Random, is_scalar: IsScalar) -> n.Node | None:
    """a − b → −(−a + b)"""
    if isinstance(node, n.Sum):
        return n.Sum((("-", n.Group(_negated(node))),))
    if isinstance(node, n.Name | n.Call | n.Product) and is_scalar(node):
        return n.Sum((("-", n.Group(n.Sum((("-", node),)))),))
    return None


def counted_twice(node: n.Node, chance: random.Random, is_scalar: IsScalar) -> n.Node | None:
    """a → 2a − a, and 2ab → ab + ab"""
    if (
        isinstance(node, n.Product)
        and isinstance(node.factors[0], n.Number)
        and node.factors[0].value == 2
        and "×" not in node.operators
    ):
        half = node.factors[1] if len(node.factors) == 2 else n.Product(node.factors[1:], node.operators[1:])
        return n.Group(n.Sum((("+", half), ("+", half))))
    if (
        not isinstance(node, n.Product | n.Name | n.Call)
        or not is_scalar(node)
        or (isinstance(node, n.Product) and "×" in node.operators)
    ):
        return None
    return n.Group(n.Sum((("+", _times(n.Number(Fraction(2), "2"), node)), ("-", node))))


def with_one_inserted(node: n.Node, chance: random.Random, is_scalar: IsScalar) -> n.Node | None:
    """a → a (cos² + sin²), of an angle that stands in the formula"""
    call = next(
        (below for below in n.walk(node) if isinstance(below, n.Call) and below.function in ("cos", "sin")), None
    )
    if (
        call is None
        or not isinstance(node, n.Product | n.Call)
        or not is_scalar(node)
        or (isinstance(node, n.Product) and "×" in node.operators)
    ):
        return None
    argument = call.arguments[0]
    if not isinstance(argument, n.JointAngles):
        square = [
            n.Power(n.Call(f, (argument,), f"\\{f}", "macro()"), n.Number(Fraction(2), "2")) for f in ("cos", "sin")
        ]
    else:
        square = [
            n.Power(n.Call(f, (argument,), h, "index"), n.Number(Fraction(2), "2"))
            for f, h in (("cos", "C"), ("sin", "S"))
        ]
    return _times(node, n.Group(n.Sum((("+", square[0]), ("+", square[1])))))


def angles_apart(node: n.Node, chance: random.Random, is_scalar: IsScalar) -> n.Node | None:
    """C_{12} → (C_1 C_2 − S_1 S_2)"""
    if not isinstance(node, n.Call) or node.function not in ("cos", "sin"):
        return None
    argument = node.arguments[0]
    if isinstance(argument, n.JointAngles) and len(argument.terms) > 1:
        (sign, _), rest = argument.terms[0], argument.terms[1:]
        if sign < 0:
            return None
        a: n.Node = n.JointAngles(argument.terms[:1])
        b: n.Node = n.JointAngles(rest)
    elif isinstance(argument, n.Sum) and len(argument.terms) > 1 and argument.terms[0][0] == "+":
        a, rest_terms = argument.terms[0][1], argument.terms[1:]
        b = rest_terms[0][1] if len(rest_terms) == 1 and rest_terms[0][0] == "+" else n.Sum(rest_terms)
    else:
        return None
    style, head = ("index", node.head) if isinstance(argument, n.JointAngles) else ("macro()", "")
    heads = {"cos": "C", "sin": "S"} if head else {"cos": "\\cos", "sin": "\\sin"}

    def call(function: str, angle: n.Node) -> n.Node:
        return n.Call(function, (angle,), heads[function], style)

    if node.function == "cos":
        terms = (("+", _times(call("cos", a), call("cos", b))), ("-", _times(call("sin", a), call("sin", b))))
    else:
        terms = (("+", _times(call("sin", a), call("cos", b))), ("+", _times(call("cos", a), call("sin", b))))
    return n.Group(n.Sum(terms))


def divided(node: n.Node, chance: random.Random, is_scalar: IsScalar) -> n.Node | None:
    """a/b → a · 1/b, and a fraction with a bar for one with a slash"""
    if not isinstance(node, n.Quotient) or not is_scalar(node):
        return None
    if chance.random() < 0.5:
        return _times(_group(node.numerator), n.Quotient(n.Number(Fraction(1), "1"), node.denominator))
    return n.Group(
        replace(
            node, numerator=n.Group(node.numerator), denominator=n.Group(node.denominator), style="slash", span=(0, 0)
        )
    )


RULES: dict[str, Rule] = {
    "terms reordered": reordered_terms,
    "factors reordered": reordered_factors,
    "expanded": expanded,
    "factored": factored,
    "sign pulled out": sign_pulled_out,
    "2a - a for a": counted_twice,
    "cos² + sin² inserted": with_one_inserted,
    "angles apart": angles_apart,
    "divided otherwise": divided,
}
