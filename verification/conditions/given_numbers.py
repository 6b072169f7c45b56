"""Numbers that the text between displays gives joints, lengths and letters: whether an equation fails there, or is written as one that holds for any."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction

from armproof.verification.algebra.calculus import angles_in, substitute, symbols_in
from armproof.verification.algebra.ring import Scalar
from armproof.verification.equations.alignment import Pair
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.equations.given_values import GivenValues
from armproof.verification.errors import WhereDefined
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare_key, is_number

_STARTS = (Fraction(1, 3), Fraction(1), Fraction(3, 2))  # of the values of what the text gives none
_APART = 0.02


def given_numbers(
    checker: ChainChecker, given: GivenValues, conditions: Sequence[n.Chain], pair: Pair | None
) -> dict[str, Scalar]:
    """Return the values that conditions give to joints and lengths, or to letters where there is no arm.

    None where another condition is on what stands in a pair, or may be.
    """
    sides = (pair.true, pair.printed) if pair is not None else ()
    held = symbols_in(cell for side in sides for cell in side.cells)
    found: dict[str, Scalar] = {}
    for condition in conditions:
        values = given.values_of(condition) or _value_of_letter(checker, condition)
        if not values and _may_be_on(condition, held):
            return {}
        numbers = {name: checker.member(node).value for name, node in values.items()}
        found |= {name: each for name, each in numbers.items() if isinstance(each, Scalar) and not symbols_in([each])}
        if not numbers.keys() <= found.keys():
            return {}
    return found


def keeps_letters(checker: ChainChecker, given: GivenValues, conditions: Sequence[n.Chain], pair: Pair | None) -> bool:
    """Whether both sides are written with each angle and slide that a text gives a value: they are of any, "cos θ_2 = (x² + y² - …)/…"."""
    values = given_numbers(checker, given, conditions, pair)
    if pair is None or not values:
        return False
    true, printed = (symbols_in(side.cells) for side in (pair.true, pair.printed))
    cells = (*pair.true.cells, *pair.printed.cells)
    joints = {*given.joints} or {angle for each in cells for angle in angles_in(each)}
    named = values.keys() & joints & (true | printed)
    return bool(named) and named <= true & printed


def fails_at_values(checker: ChainChecker, values: Mapping[str, Scalar], pair: Pair | None) -> bool:
    """Whether two sides differ at values of joints and lengths, whatever the others are, and by more than rounded values may make."""
    if pair is None or not values or pair.true.shape != pair.printed.shape:
        return False
    with WhereDefined():
        return any(_is_apart(checker, substitute(each, values)) for each in pair.differences())
    return False


def _is_apart(checker: ChainChecker, difference: Scalar) -> bool:
    """Whether a difference is far from zero at each of some values of what stands in it."""
    rest = sorted(symbols_in([difference]))
    for start in _STARTS:
        others = {
            name: difference.ring.rational(start + Fraction(7 * place % 11, 13)) for place, name in enumerate(rest)
        }
        value = substitute(difference, others)
        if symbols_in([value]) or abs(checker.members.number(value)) < _APART:
            return False
    return True


def _value_of_letter(checker: ChainChecker, chain: n.Chain) -> dict[str, n.Node]:
    """Return the number that a condition gives a letter by itself, in a document without an arm."""
    key = bare_key(chain.members[0])
    is_number_alone = chain.relations == ("=",) and is_number(chain.members[-1])
    return {key: chain.members[-1]} if checker.names.arm is None and key is not None and is_number_alone else {}


def _may_be_on(condition: n.Chain, held: set[str]) -> bool:
    below = [each for member in condition.members for each in n.walk(member)]
    keys = {each.key for each in below if isinstance(each, n.Name)}
    return not held.isdisjoint(keys) or any(isinstance(each, n.JointAngles) for each in below)
