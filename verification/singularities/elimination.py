"""Elimination among polynomials: pseudo-remainders, and chains of relations each with a variable of its own."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import log2

from armproof.verification.errors import EvaluationError, TooComplex
from armproof.verification.singularities.factors import Factor
from armproof.verification.singularities.half_angles import HalfAngles, Polynomial

MOST_TERMS = 20_000
MOST_WORK = (
    70  # bits: the course's arms stay below 60, one of 77 with eleven variables takes minutes; FLINT cannot be stopped
)


class BeyondReach(EvaluationError):
    """The exact decomposition was given up: too many terms, too little time, or a system that the method cannot split."""


@dataclass(frozen=True, eq=False)
class Relation:
    """An irreducible factor that is zero, and the variable it is solved for (by index)."""

    factor: Factor
    slot: int

    @property
    def polynomial(self) -> Polynomial:
        """The polynomial that is zero."""
        return self.factor.polynomial


def pseudo_remainder(half: HalfAngles, polynomial: Polynomial, relation: Relation) -> Polynomial:
    """Return lc^k·polynomial modulo the relation, in its variable (t with u = 1 for an angle)."""
    divisor = dehomogenised(half, relation.polynomial, relation.slot)
    rest = dehomogenised(half, polynomial, relation.slot)
    degree = divisor.degrees()[relation.slot]
    top = leading(half, divisor, relation.slot)
    variable = half.context.gen(relation.slot)
    while not rest.is_zero() and rest.degrees()[relation.slot] >= degree:
        shift = rest.degrees()[relation.slot] - degree
        head = leading(half, rest, relation.slot)
        common = head.gcd(top)
        rest = rest * divmod(top, common)[0] - divisor * divmod(head, common)[0] * variable**shift
        if len(rest) > MOST_TERMS:
            raise BeyondReach("a remainder of {count:,} terms", count=len(rest))
    return rest


def dehomogenised(half: HalfAngles, polynomial: Polynomial, slot: int) -> Polynomial:
    """Return the polynomial with u = 1 for the angle of which `slot` is t."""
    if slot >= 2 * len(half.angles):
        return polynomial
    return half.substitute(polynomial, {slot + 1: half.one})


def leading(half: HalfAngles, polynomial: Polynomial, slot: int) -> Polynomial:
    """Return the coefficient of the highest power of a variable."""
    degree = polynomial.degrees()[slot]
    terms = {
        tuple(0 if k == slot else int(e) for k, e in enumerate(exponents)): coefficient
        for exponents, coefficient in polynomial.terms()
        if exponents[slot] == degree
    }
    return half.context.from_dict(terms)


def resultant(half: HalfAngles, a: Polynomial, b: Polynomial, slot: int) -> Polynomial:
    """Return the resultant in a variable: zero exactly where the two have a common (perhaps complex) root."""
    a, b = dehomogenised(half, a, slot), dehomogenised(half, b, slot)
    degrees = [int(polynomial.degrees()[slot]) for polynomial in (a, b)]
    # the determinant of Sylvester's matrix has at most |a|^deg(b) |b|^deg(a) products
    work = degrees[1] * log2(max(len(a), 1)) + degrees[0] * log2(max(len(b), 1))
    if len(a) * len(b) > MOST_TERMS or work > MOST_WORK:
        raise BeyondReach("the resultant of polynomials of {one:,} and {other:,} terms, degrees {first} and {second}",
            one=len(a), other=len(b), first=degrees[0], second=degrees[1])  # fmt: skip
    try:
        return a.resultant(b, f"h{slot}")
    except (ValueError, RuntimeError) as problem:
        raise TooComplex(str(problem)) from None


def variables(half: HalfAngles, polynomial: Polynomial, constant: frozenset[int]) -> set[int]:
    """Return the variables (t for an angle) of a polynomial that are not constants such as lengths."""
    angles, others = half.used(polynomial)
    return {half.slots(a)[0] for a in angles} | {half.slot(g) for g in others if half.slot(g) not in constant}


def arrange(half: HalfAngles, factors: Sequence[Factor], constant: frozenset[int]) -> tuple[Relation, ...] | None:
    """Return the factors as a triangular chain, each solved for a variable that no earlier one holds; None if there is none.

    Among the variables that of lowest degree is taken, a prismatic one before an angle.
    """
    rest, chain = list(factors), list[Relation]()
    while rest:
        found = None
        for factor in rest:
            others = [variables(half, other.polynomial, constant) for other in rest if other is not factor]
            own = variables(half, factor.polynomial, constant).difference(*others)
            if own:
                found = Relation(factor, min(own, key=lambda slot: _cost(half, factor.polynomial, slot)))
                break
        if found is None:
            return None
        rest = [factor for factor in rest if factor is not found.factor]
        chain.insert(0, found)
    return tuple(chain)


def _cost(half: HalfAngles, polynomial: Polynomial, slot: int) -> tuple[int, bool, int]:
    degree = dehomogenised(half, polynomial, slot).degrees()[slot]
    return degree, slot < 2 * len(half.angles), slot
