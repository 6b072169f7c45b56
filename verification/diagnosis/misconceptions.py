"""Mistakes of a rule rather than of the pen, and what mends them: brackets left out, functions and powers term by term, quotients upside down."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from itertools import pairwise

from armproof.verification.diagnosis.brackets import missing_brackets, moved_brackets, wide_brackets
from armproof.verification.diagnosis.slips import (
    Change,
    Edit,
    is_scalar_product,
    is_trigonometric,
    on_all,
    products_of_functions,
)
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare

_ARCS = {"asin": "\\arcsin", "acos": "\\arccos", "atan": "\\arctan"}
_MOST_PLACES = 6  # at which one mistake is mended at once
_TWO = n.Number(Fraction(2), "2")


def misconceptions(root: n.Node) -> Iterator[Edit]:
    """Yield every tree that becomes of `root` if one rule of computing, at one place, was used wrongly."""
    for rule in (
        _arguments,
        _arcs,
        _upside_down,
        _squares_of_sums,
        _term_by_term,
        _under_root,
        _hypotenuses,
        _coordinates,
        _products_for_sums,
        _arguments_too_long,
        _factors_at_other_terms,
        _tangents,
        _sums_of_quotients,
        missing_brackets,
        wide_brackets,
        moved_brackets,
        _divisors,
    ):
        yield from on_all(root, rule)
    yield from _throughout(root)


def _throughout(root: n.Node) -> Iterator[Edit]:
    """Yield the trees with one mistake mended wherever it was made, where one place alone is not enough."""
    joined = root
    for _ in range(_MOST_PLACES):
        change = next(on_all(joined, products_of_functions), None)
        if change is None:
            break
        joined = change.node
    if joined is not root:
        yield Edit(joined, "function", say(Kind.PRODUCTS_OF_FUNCTIONS))
    terms = [term for node in n.walk(root) if isinstance(node, n.Sum) for _, term in node.terms]
    arcs = {id(node): angle for node in n.walk(root) if (angle := _of_radius(node)) is not None}
    if arcs:
        yield Edit(n.substitute_each(root, arcs), "function", say(Kind.ARC_OF_RADIUS))
    quotients = [each for each in (root, *terms) if _quotient_of(each) is not None][:_MOST_PLACES]
    for some in ([quotients] if len(quotients) > 1 else []) + [[each] for each in quotients]:
        angles = {id(each): _angle(each) for each in some}
        yield Edit(n.substitute_each(root, angles), "function", say(Kind.ANGLE_OF_QUOTIENT))


def _quotient_of(node: n.Node) -> n.Quotient | None:
    """Return a quotient, or that of which an arc function is taken."""
    inner = node.arguments[0] if n.is_call(node, *_ARCS) else node
    return inner if isinstance(inner, n.Quotient) else None


def _angle(node: n.Node) -> n.Node:
    """Return the angle of which a quotient is the tangent."""
    quotient = _quotient_of(node)
    assert quotient is not None
    return n.Call("atan2", (quotient.numerator, quotient.denominator), "\\text{atan2}", "macro()", span=node.span)


def _of_radius(node: n.Node) -> n.Node | None:
    """Return the angle whose sine or cosine is a quotient of one side by the root of the sum of both squares; None of anything else."""
    if not (n.is_call(node, "asin", "acos") and isinstance(quotient := bare(node.arguments[0]), n.Quotient)):
        return None
    side, root = bare(quotient.numerator), bare(quotient.denominator)
    if not (n.is_call(root, "sqrt") and isinstance(under := bare(root.arguments[0]), n.Sum)):
        return None
    bases = [bare(term.base) for _, term in under.terms if isinstance(term, n.Power) and term.exponent == _TWO]
    others = [base for base in bases if not _alike(base, side)]
    if len(bases) != 2 or len(under.terms) != 2 or len(others) != 1:
        return None
    arguments = (side, others[0]) if node.function == "asin" else (others[0], side)
    return n.Call("atan2", arguments, "\\text{atan2}", "macro()", span=node.span)


def _alike(one: n.Node, other: n.Node) -> bool:
    return isinstance(one, n.Name) and isinstance(other, n.Name) and one.key == other.key


def _under_root(node: n.Node) -> Iterator[Change]:
    """√(a - b²) for √a - b: a term under the root that belongs outside, where it is squared."""
    if not (n.is_call(node, "sqrt") and isinstance(under := bare(node.arguments[0]), n.Sum)):
        return
    for k, (sign, term) in enumerate(under.terms):
        if not (len(under.terms) > 1 and isinstance(term, n.Power) and term.exponent == _TWO):
            continue
        others, base = (*under.terms[:k], *under.terms[k + 1 :]), bare(term.base)
        root = replace(node, arguments=(n.Sum(others),))
        yield n.Group(n.Sum((("+", root), (sign, term.base)))), "function", say(Kind.UNDER_ROOT)
        if sign == "+" and isinstance(base, n.Sum) and len(base.terms) == 2:
            (_, kept), outside = base.terms
            root = replace(node, arguments=(n.Sum((*others, ("+", _squared(kept)))),))
            yield n.Group(n.Sum((("+", root), outside))), "function", say(Kind.UNDER_ROOT)


def _hypotenuses(node: n.Node) -> Iterator[Change]:
    """atan2(y, h) for atan2(y, √(h² - y²)), and atan2(y, √(x² + y²)) for atan2(y, x): the longest side is none of the two."""
    if not (n.is_call(node, "atan2") and len(node.arguments) == 2):
        return
    y, h = node.arguments
    finding = say(Kind.HYPOTENUSE)
    yield replace(node, arguments=(y, _root(h, "-", y))), "function", finding
    if (
        isinstance(root := bare(h), n.Call)
        and root.function == "sqrt"
        and isinstance(under := bare(root.arguments[0]), n.Sum)
    ):
        for _, term in under.terms:
            if isinstance(term, n.Power) and term.exponent == _TWO and not _alike(bare(term.base), bare(y)):
                yield replace(node, arguments=(y, term.base)), "function", finding


def _coordinates(node: n.Node) -> Iterator[Change]:
    """atan2(a - b, c - d) for atan2(a, c) - atan2(b, d)."""
    if not (n.is_call(node, "atan2") and len(node.arguments) == 2):
        return
    sums = [bare(argument) for argument in node.arguments]
    if all(isinstance(each, n.Sum) and len(each.terms) == 2 and each.terms[0][0] == "+" for each in sums):
        (first, (sign, second)), (third, (_, fourth)) = (each.terms for each in sums if isinstance(each, n.Sum))
        parts = [replace(node, arguments=pair) for pair in ((first[1], third[1]), (second, fourth))]
        yield n.Group(n.Sum((("+", parts[0]), (sign, parts[1])))), "function", say(Kind.COORDINATES_FOR_ANGLES)


def _products_for_sums(node: n.Node) -> Iterator[Change]:
    """a b for a + b or a² + b², and a / b for a - b: of letters, and of angles."""
    if isinstance(node, n.Quotient) and isinstance(node.denominator, n.Name):
        yield (
            n.Group(n.Sum((("+", node.numerator), ("-", node.denominator)))),
            "term",
            say(Kind.QUOTIENT_FOR_DIFFERENCE),
        )
    if not is_scalar_product(node):
        return
    for k, (one, other) in enumerate(pairwise(node.factors)):
        if all(isinstance(each, n.Name) or n.is_call(each, *n.ARCS) for each in (one, other)):
            sums = [n.Sum((("+", one), (sign, other))) for sign in "+-"]
            sums += [n.Sum((("+", _squared(one)), ("+", _squared(other))))] * (len(node.factors) == 2)
            for summed in map(n.Group, sums):
                factors = (*node.factors[:k], summed, *node.factors[k + 2 :])
                changed = (
                    summed if len(factors) == 1 else n.Product(factors, ("",) * (len(factors) - 1), span=node.span)
                )
                yield changed, "term", say(Kind.PRODUCT_FOR_SUM)


def _arguments_too_long(node: n.Node) -> Iterator[Change]:
    """f(a - b) for f(a) - b, and arctan(a - b) for arctan(a) - arctan(b)."""
    if not (
        isinstance(node, n.Call) and len(node.arguments) == 1 and (is_trigonometric(node) or node.function in _ARCS)
    ):
        return
    argument = bare(node.arguments[0])
    if not isinstance(argument, n.Sum) or len(argument.terms) != 2 or argument.terms[0][0] != "+":
        return
    (_, first), (sign, second) = argument.terms
    alone = replace(node, arguments=(first,))
    yield n.Group(n.Sum((("+", alone), (sign, second)))), "function", say(Kind.ARGUMENT_TOO_LONG)
    if node.function in _ARCS:
        other = replace(node, arguments=(second,))
        yield n.Group(n.Sum((("+", alone), (sign, other)))), "function", say(Kind.ARC_OF_SUM)


def _factors_at_other_terms(node: n.Node) -> Iterator[Change]:
    """a f - b - c for a - b f - c f: a factor at the first term that belongs at the others, or the other way round."""
    if not isinstance(node, n.Sum) or len(node.terms) < 2:
        return
    sign, term = node.terms[0]
    if is_scalar_product(term):
        for k, factor in enumerate(term.factors):
            rest = term.factors[:k] + term.factors[k + 1 :]
            alone = rest[0] if len(rest) == 1 else n.Product(rest, ("",) * (len(rest) - 1))
            others = tuple((each, n.Product((factor, other), ("",))) for each, other in node.terms[1:])
            yield n.Group(n.Sum(((sign, alone), *others), span=node.span)), "term", say(Kind.FACTOR_AT_OTHER_TERM)


def _tangents(node: n.Node) -> Iterator[Change]:
    """A sine or a cosine for the tangent, and the other way round."""
    if n.is_call(node, "sin", "cos", "tan") and not isinstance(node.arguments[0], n.JointAngles):
        for other in ("sin", "cos") if node.function == "tan" else ("tan",):
            finding = say(Kind.ANOTHER_FUNCTION, printed=node.function, correct=other)
            yield replace(node, function=other, head=f"\\{other}", style="macro()"), "function", finding


def _sums_of_quotients(node: n.Node) -> Iterator[Change]:
    """a/b + a/c for a/(b + c)."""
    if not isinstance(node, n.Sum):
        return
    for k, ((sign, one), (next_sign, other)) in enumerate(pairwise(node.terms)):
        if isinstance(one, n.Quotient) and isinstance(other, n.Quotient):
            below = n.Sum((("+", one.denominator), ("+" if sign == next_sign else "-", other.denominator)))
            terms = (*node.terms[:k], (sign, replace(one, denominator=below)), *node.terms[k + 2 :])
            yield replace(node, terms=terms), "function", say(Kind.SUM_OF_QUOTIENTS)


def _divisors(node: n.Node) -> Iterator[Change]:
    """A divisor too many."""
    if isinstance(node, n.Quotient):
        yield n.Group(node.numerator), "factor", say(Kind.EXTRA_DIVISOR)


def _arguments(node: n.Node) -> Iterator[Change]:
    """atan2(x, y) for atan2(y, x), and its arguments with another sign."""
    if not n.is_call(node, "atan2") or len(node.arguments) != 2:
        return
    yield replace(node, arguments=node.arguments[::-1]), "function", say(Kind.ARGUMENTS_EXCHANGED)
    yield from signs_of_arguments(node)


def signs_of_arguments(node: n.Node) -> Iterator[Change]:
    """An argument of atan2 with another sign: atan2(r_32, r_31) for atan2(r_32, -r_31)."""
    if not n.is_call(node, "atan2") or len(node.arguments) != 2:
        return
    y, x = node.arguments
    for number, arguments in ((1, (_negative(y), x)), (2, (y, _negative(x)))):
        yield replace(node, arguments=arguments), "sign", say(Kind.SIGN_OF_ARGUMENT, number=number)


def _negative(node: n.Node) -> n.Node:
    """Return a term with the other sign, without two signs before it."""
    if isinstance(node, n.Sum) and len(node.terms) == 1:
        sign, term = node.terms[0]
        return term if sign == "-" else n.Sum((("-", term),), span=node.span)
    return n.Sum((("-", n.Group(node) if isinstance(node, n.Sum) else node),), span=node.span)


def _arcs(node: n.Node) -> Iterator[Change]:
    """Another of the arc functions, or a function where its arc function belongs."""
    if isinstance(node, n.Call) and f"a{node.function}" in _ARCS and len(node.arguments) == 1:
        head = _ARCS[f"a{node.function}"]
        finding = say(Kind.ANOTHER_FUNCTION, printed=node.function, correct=head[1:])
        yield replace(node, function=f"a{node.function}", head=head, style="macro()"), "function", finding
    if n.is_call(node, *_ARCS):
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
    if len(node.terms) > 2 and node.terms[0][0] == "+":
        rest = n.Group(n.Sum(node.terms[1:]))
        yield _root(node.terms[0][1], "+", rest), "function", say(Kind.ROOT_TERM_BY_TERM)
    for k, ((sign, term), (next_sign, next_term)) in enumerate(pairwise(node.terms)):
        for kind in (Kind.FUNCTION_TERM_BY_TERM, Kind.ROOT_TERM_BY_TERM):
            joined = _joined(kind, term, "+" if sign == next_sign else "-", next_term)
            if joined is not None:
                terms = (*node.terms[:k], (sign, joined), *node.terms[k + 2 :])
                yield joined if terms == (("+", joined),) else replace(node, terms=terms), "function", say(kind)


def _joined(kind: Kind, one: n.Node, sign: str, other: n.Node) -> n.Node | None:
    """Return the function of the sum of two terms; None where they are no such terms."""
    if kind is Kind.ROOT_TERM_BY_TERM:
        return _root(one, sign, other)
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


def _root(one: n.Node, sign: str, other: n.Node) -> n.Node:
    """Return the root of the sum of two squares."""
    return n.Call("sqrt", (n.Sum((("+", _squared(one)), (sign, _squared(other)))),), "\\sqrt", "braces")


def _squared(node: n.Node) -> n.Node:
    """Return the square of a term, of a root what stands under it."""
    if n.is_call(node, "sqrt") and len(node.arguments) == 1:
        return n.Group(node.arguments[0])
    return n.Power(node if isinstance(node, n.Name) else n.Group(node), _TWO)


def _squares_of_sums(node: n.Node) -> Iterator[Change]:
    """(a + b)² for a² + b², and the other way round; a² - b² for (a - b)²."""
    if isinstance(node, n.Power) and node.exponent == _TWO:
        inner = node.base.inner if isinstance(node.base, n.Group) else node.base
        if isinstance(inner, n.Sum) and len(inner.terms) > 1:
            squares = tuple(("+", _squared(term)) for _, term in inner.terms)
            yield n.Group(n.Sum(squares, span=node.span)), "number", say(Kind.SQUARE_OF_SUM)
    if isinstance(node, n.Sum):
        for k, ((sign, one), (next_sign, other)) in enumerate(pairwise(node.terms)):
            bases = [each.base for each in (one, other) if isinstance(each, n.Power) and each.exponent == _TWO]
            if len(bases) == 2 and (sign == next_sign or sign == "+"):
                for inside in "+-" if sign == next_sign else "-":
                    whole = n.Power(n.Group(n.Sum((("+", bases[0]), (inside, bases[1])))), _TWO)
                    terms = (*node.terms[:k], (sign, whole), *node.terms[k + 2 :])
                    yield (
                        whole if terms == (("+", whole),) else replace(node, terms=terms),
                        "number",
                        say(Kind.SUM_OF_SQUARES),
                    )
