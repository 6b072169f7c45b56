"""Small changes of a formula: what a slip of the pen does to it, and what mends it again.

One list serves both directions: the diagnosis looks for the change that makes a wrong entry right, and the mutation
test makes right entries wrong.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import partial
from itertools import combinations
from math import pi
from typing import TypeGuard, TypeVar

from armproof.verification.findings import Finding, Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.writer import SWAPPED, bare_head
from armproof.verification.naming.conventions import is_entry

Change = tuple[n.Node, str, Finding]
Item = TypeVar("Item")

_NEAR = 1e-9
_TWO = n.Number(Fraction(2), "2")
_FOUR = n.Number(Fraction(4), "4")
_FLIPPED = {"+": "-", "-": "+", "±": "∓", "∓": "±"}


@dataclass(frozen=True)
class Edit:
    """A changed tree and the kind of change: sign, index, function, factor, length, term, number, cell."""

    node: n.Node
    kind: str
    finding: Finding


@dataclass(frozen=True)
class Letters:
    """What a display may draw on, as nodes in the document's letters: the joints' indices, lengths, coordinates, and names of its own."""

    joints: tuple[int, ...] = ()
    angles: tuple[n.Name, ...] = ()
    lengths: tuple[n.Name, ...] = ()
    coordinates: tuple[n.Name, ...] = ()
    own: tuple[n.Name, ...] = ()


_MOST_CALLS = 6  # sines and cosines of which two may be exchanged


def single_edits(root: n.Node, letters: Letters) -> Iterator[Edit]:
    """Yield every tree that one small change makes of `root`, the most likely slips first."""
    yield from plain_edits(root, letters)
    yield from (edit for edit in on_all(root, lambda node: _names(node, letters)) if not _vanishes(edit.node))
    yield from swapped_lengths(root, letters)
    yield from on_all(root, _dropped_factors)
    yield from on_all(root, products_of_functions)
    yield from _numbers(root)
    yield from _squares(root, letters)
    yield from on_all(root, _dropped_terms)
    yield from _added_factors(root, letters)
    yield from on_all(root, _exchanged_arguments)
    yield from on_all(root, _entries)


def plain_edits(root: n.Node, letters: Letters) -> Iterator[Edit]:
    """Yield the trees with another sign, function or index: nothing is dropped, nothing added."""
    yield Edit(_negated(root), "sign", say(Kind.WRONG_SIGN))
    yield from on_all(root, _signs_of_angles)
    yield from on_all(root, _factors_of_angles)
    yield from on_all(root, _signs)
    yield from on_all(root, _functions)
    yield from _functions_throughout(root)
    yield from on_all(root, lambda node: _indices(node, letters))


def dropping_edits(root: n.Node, letters: Letters) -> Iterator[Edit]:
    """Yield the trees with a factor or a term less, or another number."""
    yield from on_all(root, _dropped_factors)
    yield from on_all(root, _dropped_terms)
    yield from _numbers(root)


def sign_pairs(root: n.Node) -> Iterator[Edit]:
    """Yield the trees with two signs of one sum turned: both are mistaken, or a bracket was opened without its minus."""
    for node in n.walk(root):
        if not isinstance(node, n.Sum):
            continue
        for one, other in combinations(range(len(node.terms)), 2):
            terms = tuple((_FLIPPED[sign] if k in (one, other) else sign, term) for k, (sign, term) in enumerate(node.terms))  # fmt: skip
            finding = say(Kind.WRONG_SIGNS_OF_TERMS, one=one + 1, other=other + 1)
            yield Edit(n.substitute(root, node, replace(node, terms=terms)), "sign", finding)


def _negated(node: n.Node) -> n.Node:
    if isinstance(node, n.Sum):
        return replace(node, terms=tuple((_FLIPPED[sign], term) for sign, term in node.terms), span=node.span)
    return n.Sum((("-", node),), span=node.span)


def on_all(root: n.Node, rule: Callable[[n.Node], Iterator[Change]]) -> Iterator[Edit]:
    """Yield the trees that a rule makes of `root` at each of its nodes."""
    for node in n.walk(root):
        for changed, kind, finding in rule(node):
            yield Edit(n.substitute(root, node, changed), kind, finding)


def is_trigonometric(node: n.Node) -> TypeGuard[n.Call]:
    """Whether a node is a sine or a cosine."""
    return n.is_call(node, "cos", "sin")


def is_scalar_product(node: n.Node) -> TypeGuard[n.Product]:
    """Whether a node is a product and no cross product."""
    return isinstance(node, n.Product) and "×" not in node.operators


def with_items(items: tuple[Item, ...], place: int, *new: Item) -> tuple[Item, ...]:
    """Return items with others, or none, in place of one."""
    return (*items[:place], *new, *items[place + 1 :])


def _signs(node: n.Node) -> Iterator[Change]:
    if not isinstance(node, n.Sum) or len(node.terms) == 1:
        return
    for k in (*range(1, len(node.terms)), 0):  # (h - x)² for (x - h)² last: the first term is seldom the wrong one
        yield with_sign_turned(node, k), "sign", say(Kind.WRONG_SIGN_OF_TERM, term=k + 1)


def with_sign_turned(node: n.Sum, place: int) -> n.Sum:
    """Return a sum with the other sign before one of its terms."""
    sign, term = node.terms[place]
    return replace(node, terms=with_items(node.terms, place, (_FLIPPED[sign], term)))


def _signs_of_angles(node: n.Node) -> Iterator[Change]:
    """The sign of one angle of several in a sine or cosine."""
    if not is_trigonometric(node) or not isinstance(argument := node.arguments[0], n.Sum):
        return
    for k, (_, term) in enumerate(argument.terms):
        if k and isinstance(term, n.Name):
            yield (
                replace(node, arguments=(with_sign_turned(argument, k),)),
                "sign",
                say(Kind.SIGN_OF_ANGLE, angle=_show(term)),
            )


def _factors_of_angles(node: n.Node) -> Iterator[Change]:
    """A number before an angle in a sine or cosine, and a term of a sum of angles that has one."""
    if not is_trigonometric(node):
        return
    argument = node.arguments[0]
    terms = argument.terms if isinstance(argument, n.Sum) else (("+", argument),)
    for k, (sign, term) in enumerate(terms):
        if not (is_scalar_product(term) and len(term.factors) == 2 and isinstance(term.factors[0], n.Number)):
            continue
        alone = with_items(terms, k, (sign, term.factors[1]))
        changed = alone[0][1] if len(alone) == 1 else n.Sum(alone, span=argument.span)
        yield replace(node, arguments=(changed,)), "number", say(Kind.FACTOR_OF_ANGLE, number=term.factors[0].text)
        if len(terms) > 1:
            rest = n.Sum(with_items(terms, k), span=argument.span)
            yield replace(node, arguments=(rest,)), "index", say(Kind.EXTRA_IN_ANGLE)


def _functions(node: n.Node) -> Iterator[Change]:
    if is_trigonometric(node):
        other = "sin" if node.function == "cos" else "cos"
        finding = say(Kind.SINE_FOR_COSINE if node.function == "sin" else Kind.COSINE_FOR_SINE)
        yield replace(node, function=other, head=SWAPPED.get(bare_head(node), f"\\{other}")), "function", finding


def _entries(node: n.Node) -> Iterator[Change]:
    """Another entry of a rotation, in its row or its column: r_{13} for r_{33}."""
    if not isinstance(node, n.Name) or not is_entry(node) or len(node.sub) != 2:
        return
    row, column = node.sub[0], node.sub[1]
    for sub in (*(row + other for other in "123"), *(other + column for other in "123")):
        if sub != node.sub:
            changed = replace(node, sub=sub, text=f"{node.base}_{{{sub}}}")
            yield changed, "index", say(Kind.WRONG_NAME, printed=_show(node), correct=_show(changed))


def _exchanged_arguments(node: n.Node) -> Iterator[Change]:
    if n.is_call(node, "atan2") and len(node.arguments) == 2:
        yield replace(node, arguments=node.arguments[::-1]), "function", say(Kind.ARGUMENTS_EXCHANGED)


def _functions_throughout(root: n.Node) -> Iterator[Edit]:
    """Every sine for a cosine and the other way round, where there are several."""
    calls = [node for node in n.walk(root) if is_trigonometric(node)]
    if len(calls) < 2:
        return
    exchanged = root
    for call in calls:
        [(changed, kind, _)] = _functions(call)
        exchanged = n.substitute(exchanged, call, changed)
    yield Edit(exchanged, kind, say(Kind.EXCHANGED_THROUGHOUT))


def function_pairs(root: n.Node) -> Iterator[Edit]:
    """Yield the trees with two of several sines and cosines exchanged, each for the other function."""
    calls = [node for node in n.walk(root) if is_trigonometric(node)]
    if not 2 < len(calls) <= _MOST_CALLS:  # of two it is all
        return
    changed = {id(call): next(_functions(call))[0] for call in calls}
    for pair in combinations(calls, 2):
        edited = n.substitute_each(root, {id(call): changed[id(call)] for call in pair})
        yield Edit(edited, "function", say(Kind.EXCHANGED_TWICE))


def products_of_functions(node: n.Node) -> Iterator[Change]:
    """Yield a product with two of its cosines, or sines, as one of the sum of their angles: C_1 C_2 for C_{12}, S_1 S_2 for S_{12}."""
    if not is_scalar_product(node):
        return
    calls = [(k, f) for k, f in enumerate(node.factors) if is_trigonometric(f)]
    for i, (k, one) in enumerate(calls):
        for m, other in calls[i + 1 :]:
            angle = _sum_of_angles(one.arguments[0], other.arguments[0])
            if one.function != other.function or angle is None:
                continue
            joined = replace(one, arguments=(angle,))
            factors = with_items(with_items(node.factors, m), k, joined)
            operators = (*node.operators[: m - 1], *node.operators[m:])
            grown = joined if len(factors) == 1 else replace(node, factors=factors, operators=operators)
            kind = Kind.PRODUCT_OF_COSINES if one.function == "cos" else Kind.PRODUCT_OF_SINES
            yield grown, "function", say(kind)


def _sum_of_angles(one: n.Node, other: n.Node) -> n.JointAngles | None:
    if not (isinstance(one, n.JointAngles) and isinstance(other, n.JointAngles)):
        return None
    if {index for _, index in one.terms} & {index for _, index in other.terms}:
        return None
    return n.JointAngles(tuple(sorted((*one.terms, *other.terms), key=lambda term: term[1])))


def _indices(node: n.Node, letters: Letters) -> Iterator[Change]:
    if not isinstance(node, n.JointAngles):
        return
    present = {index for _, index in node.terms}
    for k, (sign, index) in enumerate(node.terms):
        rest = with_items(node.terms, k)
        for joint in letters.joints:
            if joint not in present:
                terms = with_items(node.terms, k, (sign, joint))
                yield replace(node, terms=terms), "index", say(Kind.WRONG_INDEX, printed=index, correct=joint)
        if rest:
            yield replace(node, terms=rest), "index", say(Kind.EXTRA_INDEX, index=index)
            if k:
                terms = with_items(node.terms, k, (-sign, index))
                yield replace(node, terms=terms), "index", say(Kind.WRONG_SIGN_OF_ANGLE, index=index)
    for joint in letters.joints:
        if joint not in present:
            terms = tuple(sorted((*node.terms, (1, joint)), key=lambda term: term[1]))
            yield replace(node, terms=terms), "index", say(Kind.MISSING_INDEX, index=joint)


def _names(node: n.Node, letters: Letters) -> Iterator[Change]:
    if is_trigonometric(node):
        yield from _angle_sums(node, letters)
    if not isinstance(node, n.Name):
        return
    for family, kind, slip in (
        (letters.angles, "index", Kind.WRONG_ANGLE),
        (letters.lengths, "length", Kind.WRONG_LENGTH),
        (letters.coordinates, "index", Kind.WRONG_COORDINATE),
        ([each for each in letters.own if each.base == node.base], "index", Kind.WRONG_NAME),
        (_moving_alike(node, letters), "index", Kind.WRONG_NAME),
    ):
        plain = replace(node, dots=0)
        if any(other.key == plain.key for other in family):
            for other in family:
                if other.key != plain.key:
                    changed = replace(_with_dots(other, node.dots), span=node.span)
                    yield changed, kind, say(slip, printed=_show(node), correct=_show(changed))


def _moving_alike(node: n.Name, letters: Letters) -> list[n.Name]:
    """Return a name and those of its letter with another index that stand for what moves otherwise: q_2, which turns, beside q_3, which slides."""
    families = (letters.angles, letters.lengths)
    own = next((one for one in families if any(each.key == replace(node, dots=0).key for each in one)), ())
    other = families[own is letters.angles] if own else ()
    alike = [each for each in other if each.base == node.base]
    return [replace(node, dots=0), *alike] if alike else []


def _vanishes(root: n.Node) -> bool:
    """Whether a sum in a tree takes away what it adds, x - x: then a letter mends nothing, its factor is too many."""
    return any(
        (_FLIPPED[sign], term) in node.terms
        for node in n.walk(root) if isinstance(node, n.Sum)
        for sign, term in node.terms if isinstance(term, n.Name)
    )  # fmt: skip


def _with_dots(name: n.Name, dots: int) -> n.Name:
    """Return the rate, or the acceleration, of what a name stands for."""
    command = {0: "", 1: r"\dot", 2: r"\ddot"}.get(dots, "")
    return replace(name, dots=dots, text=f"{command}{{{name.text}}}") if command else name


def _angle_sums(node: n.Call, letters: Letters) -> Iterator[Change]:
    """Angles written out: a term too many is the sums' affair, a missing one is added here."""
    argument = node.arguments[0]
    terms = argument.terms if isinstance(argument, n.Sum) else (("+", argument),)
    if not all(isinstance(term, n.Name) for _, term in terms):
        return
    for k, (_, term) in enumerate(terms):
        if len(terms) > 1 and isinstance(term, n.Name):
            shorter = with_items(terms, k)
            rest = shorter[0][1] if len(shorter) == 1 and shorter[0][0] == "+" else n.Sum(shorter, span=argument.span)
            yield replace(node, arguments=(rest,)), "index", say(Kind.EXTRA_ANGLE, angle=_show(term))
    keys = [term.key for _, term in terms if isinstance(term, n.Name)]
    for index, angle in enumerate(letters.angles):
        if angle.key not in keys:
            behind = {other.key for other in letters.angles[index + 1 :]}
            at = next((k for k, key in enumerate(keys) if key in behind), len(keys))
            longer = n.Sum((*terms[:at], ("+", angle), *terms[at:]), span=argument.span)
            style = {"letter": "letter()", "macro": "macro()"}.get(node.style, node.style)
            yield replace(node, arguments=(longer,), style=style), "index", say(Kind.MISSING_ANGLE, angle=_show(angle))


def swapped_lengths(root: n.Node, letters: Letters) -> Iterator[Edit]:
    """Two lengths, exchanged throughout."""
    present = {below.key for below in n.names(root)}
    for a, b in combinations([length for length in letters.lengths if length.key in present], 2):
        swapped = renamed(root, {a.key: b, b.key: a})
        yield Edit(swapped, "length", say(Kind.SWAPPED_LENGTHS, one=_show(a), other=_show(b)))


def renamed(node: n.Node, names: dict[str, n.Name]) -> n.Node:
    """Return a tree with other names, by their keys."""
    found = [below for below in n.names(node) if below.key in names]
    return n.substitute_each(node, {id(old): replace(names[old.key], span=old.span) for old in found})


def _dropped_factors(node: n.Node) -> Iterator[Change]:
    if not is_scalar_product(node):
        return
    for k in range(len(node.factors)):
        factors = with_items(node.factors, k)
        operators = node.operators[1:] if k == 0 else (*node.operators[: k - 1], *node.operators[k:])
        smaller = factors[0] if len(factors) == 1 else replace(node, factors=factors, operators=operators)
        is_turn = abs(_number_of(n.bare(node.factors[k])) - 180 / pi) < _NEAR
        yield smaller, "factor", say(Kind.GIVEN_IN_DEGREES) if is_turn else say(Kind.EXTRA_FACTOR, factor=k + 1)


def _number_of(node: n.Node) -> float:
    """Return the number that is written, of a quotient too; 0 of anything else."""
    if isinstance(node, n.Quotient):
        below = _number_of(node.denominator)
        return _number_of(node.numerator) / below if below else 0.0
    if isinstance(node, n.Name):
        return pi if node.key == "pi" else 0.0
    return float(node.value) if isinstance(node, n.Number) else 0.0


def _dropped_terms(node: n.Node) -> Iterator[Change]:
    if isinstance(node, n.Quotient) and _is_one_and_more(n.bare(node.denominator)):
        yield node.numerator, "factor", say(Kind.EXTRA_DIVISOR)
    if not isinstance(node, n.Sum) or len(node.terms) < 2:
        return
    for k in range(len(node.terms)):
        terms = with_items(node.terms, k)
        yield replace(node, terms=terms), "term", say(Kind.EXTRA_TERM, term=k + 1)


def _is_one_and_more(node: n.Node) -> bool:
    """Whether a sum is 1 + x, of which 1 alone divides by nothing."""
    return isinstance(node, n.Sum) and ("+", n.Number(Fraction(1), "1")) in [
        (sign, n.bare(term)) for sign, term in node.terms
    ]


def _numbers(root: n.Node) -> Iterator[Edit]:
    """No divisor 2, another number, and in the place of a power a lower or a higher one."""
    powers = [node for node in n.walk(root) if isinstance(node, n.Power) and isinstance(node.exponent, n.Number)]
    exponents = {id(power.exponent) for power in powers}
    quotients = [node for node in n.walk(root) if isinstance(node, n.Quotient)]
    below = {id(part) for quotient in quotients for part in n.walk(quotient.denominator)}
    ones = {id(quotient.numerator) for quotient in quotients if quotient.numerator == n.Number(Fraction(1), "1")}
    for quotient in quotients:
        if quotient.denominator == _TWO and id(quotient.numerator) not in ones:
            above = quotient.numerator
            whole = n.Group(above) if isinstance(above, n.Sum) else above
            yield Edit(n.substitute(root, quotient, whole), "number", say(Kind.EXTRA_DIVISOR))
    for node in sorted(n.walk(root), key=lambda node: id(node) not in below):
        if isinstance(node, n.Number) and node.value and id(node) not in exponents | ones:
            for value in (node.value * 2, node.value / 2, node.value + 1):
                changed = n.substitute(root, node, n.Number(value, span=node.span))
                size = "small" if value > node.value else "large"
                yield Edit(changed, "number", say(Kind.WRONG_NUMBER, number=node.text, size=size))
    for power in powers:
        assert isinstance(power.exponent, n.Number)
        higher = n.Number(power.exponent.value + 1, str(power.exponent.value + 1), span=power.exponent.span)
        for other, size in ((_first_power(power.base), "large"), (replace(power, exponent=higher), "small")):
            finding = say(Kind.WRONG_POWER, number=power.exponent.text, size=size)
            yield Edit(n.substitute(root, power, other), "number", finding)


def _first_power(base: n.Node) -> n.Node:
    """Return the base of a power as it is written alone: \\cos of \\cos^2."""
    return replace(base, head=bare_head(base)) if isinstance(base, n.Call) else base


def _squares(root: n.Node, letters: Letters) -> Iterator[Edit]:
    """The square of a length, a sine or a cosine, where the first power stands."""
    lengths = {length.key for length in letters.lengths}
    for node in _formulas(root):
        if (isinstance(node, n.Name) and node.key in lengths) or is_trigonometric(node):
            square = n.Power(node, _TWO, span=node.span)
            yield Edit(n.substitute(root, node, square), "number", say(Kind.MISSING_SQUARE))


def _formulas(node: n.Node) -> Iterator[n.Node]:
    """Yield the nodes that stand for values: not angles in a cosine, exponents, or what a derivative is taken by."""
    yield node
    if isinstance(node, n.Call) and node.function not in (
        "sqrt",
        "abs",
        "norm",
        "frobenius",
        "det",
        "adj",
        "com",
        "tr",
        "rank",
        *n.ARCS,  # an angle is worked out of a formula: slips are made in that, too
    ):
        return
    if isinstance(node, n.Power | n.Postfix):
        return  # a power of a power is no slip
    inside = (
        [node.inner]
        if isinstance(node, n.At | n.Labelled)
        else [node.operand]
        if isinstance(node, n.Derivative)
        else n.children(node)
    )
    for child in inside:
        yield from _formulas(child)


def _added_factors(root: n.Node, letters: Letters) -> Iterator[Edit]:
    """A length or a sine or cosine, missing from one term."""
    factors: list[tuple[n.Node, Finding]] = [
        (length, say(Kind.MISSING_FACTOR, factor=_show(length))) for length in letters.lengths
    ]
    style = next((b for b in n.walk(root) if is_trigonometric(b)), None)
    factors += _functions_of(style, letters) if style is not None else []
    factors += [(number, say(Kind.MISSING_FACTOR, factor=number.text)) for number in (_TWO, _FOUR)]
    terms = [term for node in _formulas(root) if isinstance(node, n.Sum) for _, term in node.terms]
    targets = terms if isinstance(root, n.Sum) else [*terms, root]
    targets += [node.denominator for node in _formulas(root) if isinstance(node, n.Quotient)]
    for target in targets:
        for factor, missing in factors:
            before = target.factors if is_scalar_product(target) else (target,)
            if factor is _FOUR and (target not in terms or any(isinstance(n.bare(each), n.Number) for each in before)):
                continue  # there another number is wrong
            operators = target.operators if is_scalar_product(target) else ()
            grown = n.Product((factor, *before), ("", *operators), span=target.span)
            yield Edit(n.substitute(root, target, grown), "factor", missing)


def _functions_of(style: n.Call, letters: Letters) -> Iterator[tuple[n.Node, Finding]]:
    """Yield the cosines and sines of the joints, written as `style` is, each with what is said where it is missing."""
    arguments: list[tuple[n.Node, partial[Finding]]]
    if isinstance(style.arguments[0], n.JointAngles):
        arguments = [(n.JointAngles(((1, k),)), partial(say, Kind.MISSING_FUNCTION, index=k)) for k in letters.joints]
    else:
        arguments = [(name, partial(say, Kind.MISSING_FUNCTION_OF, angle=_show(name))) for name in letters.angles]
    for argument, missing in arguments:
        for function in ("cos", "sin"):
            other = SWAPPED.get(bare_head(style), f"\\{function}")
            head = bare_head(style) if style.function == function else other
            call = replace(style, function=function, head=head, arguments=(argument,))
            yield call, missing(function=function)


def _show(name: n.Name) -> str:
    return name.text or name.key
