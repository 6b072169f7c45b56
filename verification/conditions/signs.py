"""Conditions that compare: 0 < θ_2 < π ⇒ det J > 0, as signs of scalars, and what follows from signs.

An interval of an angle is one or two signs: a < θ < b, no wider than a half turn, says sin(θ − a) > 0 and sin(b − θ) > 0.
A sign follows from others where its irreducible factors are theirs, but for what is positive and what occurs twice.
"""

from __future__ import annotations

import itertools
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from math import prod

from flint import fmpq_mpoly

from armproof.verification.algebra.matrix import as_scalar
from armproof.verification.algebra.ring import Scalar
from armproof.verification.conditions.system import Undecided, is_angle
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.evaluation.evaluator import Evaluator
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare

ORDERS = {"<": (False, ">"), "≤": (False, "≥"), ">": (True, ">"), "≥": (True, "≥")}  # which are turned round
MOST_TERMS, MOST_TOGETHER = 60, 3


@dataclass(frozen=True)
class Sign:
    """A scalar with its relation to zero: >, ≥ or ≠."""

    value: Scalar
    relation: str


@dataclass
class _Bounds:
    """An angle with the constants between which it is, each with whether it is left out."""

    angle: Scalar
    low: tuple[Scalar, bool] | None = None
    high: tuple[Scalar, bool] | None = None


@dataclass(frozen=True)
class Signs:
    """What equations and comparisons that hold together say: signs; and whether an equation stands among them."""

    signs: tuple[Sign, ...]
    has_equation: bool = False


@dataclass(frozen=True)
class Reader:
    """Reads comparisons as signs."""

    checker: ChainChecker
    bounds: dict[str, _Bounds] = field(default_factory=dict)

    def read(self, chains: Iterable[n.Chain]) -> Signs:
        """Return the signs of chains that hold together; raises Undecided where one is none."""
        found: list[Sign] = []
        has_equation = False
        for chain in chains:
            for left, relation, right in zip(chain.members, chain.relations, chain.members[1:], strict=False):
                has_equation |= relation == "="
                found += self._of_pair(left, relation, right) if relation != "=" else ()
        found += [sign for bounds in self.bounds.values() for sign in self._of_bounds(bounds)]
        return Signs(tuple(found), has_equation)

    def _of_pair(self, left: n.Node, relation: str, right: n.Node) -> Iterator[Sign]:
        if (interval := n.interval_of(relation, right)) is not None:
            order = "<" if interval.brackets == "()" else "≤"
            yield from self._of_pair(interval.items[0], order, left)
            yield from self._of_pair(left, order, interval.items[1])
            return
        inner = bare(left)
        if n.is_call(inner, "abs") and relation in "<≤":  # |θ_2| < π/2
            yield from self._of_pair(inner.arguments[0], relation, right)
            yield from self._of_pair(n.Sum((("-", right),)), relation, inner.arguments[0])
            return
        if n.has_branches(left) or n.has_branches(right):
            raise Undecided(say(Kind.SIGNS_UNTOLD))
        a, b = self._scalar(left), self._scalar(right)
        if relation == "≠":
            yield Sign(1 - self.checker.exact.cos_sin(a - b)[0] if self._is_angle(a - b) else a - b, "≠")
            return
        if relation not in ORDERS:
            raise Undecided(say(Kind.RELATION_IS_NONE, relation=relation))
        turned, order = ORDERS[relation]
        small, large = (b, a) if turned else (a, b)
        if not self._is_bound(small, large, order == ">"):
            yield Sign(large - small, order)

    def _scalar(self, node: n.Node) -> Scalar:
        value = as_scalar(Evaluator(self.checker.names, self.checker.exact).evaluate(node))
        if not isinstance(value, Scalar):
            raise Undecided(say(Kind.MATRIX_FOR_CONDITION))
        return value

    def _is_angle(self, value: Scalar) -> bool:
        return is_angle(self.checker, value)

    def _is_bound(self, small: Scalar, large: Scalar, is_open: bool) -> bool:
        """Remember a bound of an angle, and say whether a comparison is one."""
        angle = next((each for each in (large, small) if self._is_angle(each)), None)
        number = small if angle is large else large
        if angle is None or self._turns(number) is None:
            return False
        bounds = self.bounds.setdefault(str(angle.numerator), _Bounds(angle))
        side = "low" if angle is large else "high"
        if getattr(bounds, side) is not None:
            raise Undecided(say(Kind.RELATION_IS_NONE, relation="<"))
        setattr(bounds, side, (number, is_open))
        return True

    def _turns(self, value: Scalar) -> Fraction | None:
        return (value / self.checker.exact.pi()).as_fraction()

    def _of_bounds(self, bounds: _Bounds) -> Iterator[Sign]:
        if bounds.low is None or bounds.high is None:
            value, is_open = bounds.low or bounds.high or (bounds.angle, True)
            above = bounds.angle - value if bounds.low is not None else value - bounds.angle
            yield Sign(above, ">" if is_open else "≥")
            return
        (low, low_open), (high, high_open) = bounds.low, bounds.high
        wide = self._turns(high - low)
        if wide is None or not 0 < wide <= 1 or (wide == 1 and low_open != high_open):
            raise Undecided(say(Kind.WIDE_INTERVAL))
        sine = self.checker.exact.cos_sin
        yield Sign(sine(bounds.angle - low)[1], ">" if low_open else "≥")
        yield Sign(sine(high - bounds.angle)[1], ">" if high_open else "≥")


# -- what follows ---------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class _Factors:
    """A scalar as a sign and its irreducible factors that are not positive, those of its denominator too."""

    sign: int
    powers: Counter[str]
    below: frozenset[str]  # those of its denominator

    @property
    def odd(self) -> frozenset[str]:
        """Those that change its sign."""
        return frozenset(key for key, power in self.powers.items() if power % 2)


def follow(given: Sequence[Sign], asked: Sequence[Sign], positive: frozenset[str]) -> bool:
    """Whether each sign that is asked for follows from those that are given."""
    for sign in (*given, *asked):
        sign.value.ring.lift(sign.value)
    known = [(sign, _factors(sign.value, positive)) for sign in given]
    nonzero = {key for sign, factors in known if factors and sign.relation != "≥" for key in factors.powers}
    ordered = [factors for sign, factors in known if factors and sign.relation != "≠"]
    return bool(asked) and all(_follows(sign, _factors(sign.value, positive), ordered, nonzero) for sign in asked)


def _follows(sign: Sign, factors: _Factors | None, ordered: Sequence[_Factors], nonzero: set[str]) -> bool:
    if factors is None:
        return False
    if sign.relation == "≠" or sign.relation == ">":
        if not nonzero.issuperset(factors.powers):
            return False
        if sign.relation == "≠":
            return True
    elif not factors.below.issubset(nonzero):  # a factor above that vanishes leaves 0 ≥ 0
        return False
    choices = (each for count in range(MOST_TOGETHER + 1) for each in itertools.combinations(ordered, count))
    return any(_product_is(factors, chosen, nonzero) for chosen in choices)


def _product_is(factors: _Factors, chosen: Sequence[_Factors], nonzero: set[str]) -> bool:
    """Whether the product of signs is that of the factors: what occurs in it twice, and not in them, must not vanish."""
    total: Counter[str] = sum((each.powers for each in chosen), Counter())
    sign = prod(each.sign for each in chosen)
    odd = {key for key, power in total.items() if power % 2}
    return sign == factors.sign and odd == factors.odd and nonzero.issuperset(set(total) - factors.odd)


def _factors(value: Scalar, positive: frozenset[str]) -> _Factors | None:
    """Return the factors of a scalar; None of zero, and of one that is too large."""
    parts = (value.numerator, value.denominator)
    if value.is_zero() or any(len(part) > MOST_TERMS for part in parts):
        return None
    powers, below = Counter[str](), set[str]()
    for part in parts:
        value.ring.budget.check()
        for factor, power in part.factor()[1]:
            monic = factor / factor.leading_coefficient()
            if not _is_positive(value, monic, positive):
                powers[str(monic)] += int(power)
                below |= {str(monic)} if part is value.denominator else set()
    leading = value.numerator.leading_coefficient() * value.denominator.leading_coefficient()  # of monic factors: 1
    return _Factors(1 if leading > 0 else -1, powers, frozenset(below))


def _is_positive(value: Scalar, factor: fmpq_mpoly, positive: frozenset[str]) -> bool:
    """Whether a factor is a sum of products of lengths."""
    names = {(kind, name) for _, (kind, name) in value.ring.generators_of(factor)}
    lengths = all((kind == "symbol" and name in positive) or kind in ("sqrt", "pi") for kind, name in names)
    return lengths and all(coefficient > 0 for coefficient in factor.coeffs())
