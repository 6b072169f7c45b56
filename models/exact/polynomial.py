"""Exact entries: polynomials over the rationals in cosines, sines, lengths and square roots.

An entry is a mapping of monomials to nonzero `Fraction` coefficients; a monomial is a sorted tuple of
(generator, power) pairs. `{}` is 0 and `{(): Fraction(1)}` is 1. The generators:

    ("cos", angle), ("sin", angle)   angle: a joint "theta_1", a constant symbol "alpha_1", or a number: "pi/5", "0.3" (rad)
    ("symbol", name)                 a length or the variable of a prismatic joint (m)
    ("sqrt", prime)                  the square root of a prime, "2", "3", "5", …

Every entry that this room hands out is in normal form: no sine and no root to a power above 1 (s² = 1 − c², r² = p).
Two entries are then equal, for all values of the generators, exactly when the mappings are.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from fractions import Fraction
from math import sqrt
from typing import TypeVar

from flint import fmpz

from armproof.models.errors import Fault, ModelError

Generator = tuple[str, str]
Monomial = tuple[tuple[Generator, int], ...]
Entry = Mapping[Monomial, Fraction]
Rows = tuple[tuple[Entry, ...], ...]

ZERO: Entry = {}
ONE: Entry = {(): Fraction(1)}
SMALL_PRIMES = 2000  # the first so many are tried on every number
MOST_BITS = 112  # of a number without small factors that is factored none the less, which takes up to 0.2 s

T = TypeVar("T")


def number(value: int | Fraction) -> Entry:
    """Return the constant entry of a rational number."""
    return {(): Fraction(value)} if value else ZERO


def generator(kind: str, name: str) -> Entry:
    """Return the entry that is one generator, such as ("cos", "theta_1")."""
    return {(((kind, name), 1),): Fraction(1)}


def root(value: int | Fraction) -> Entry:
    """Return the square root of a rational number ≥ 0 as a rational times a product of roots of primes.

    Raises:
        ModelError: the number is so large that its factors are not sought.
    """
    value = Fraction(value)
    if not value:
        return ZERO
    outside, primes = 1, []
    for prime, power in _factors(fmpz(value.numerator * value.denominator)):
        outside *= prime ** (power // 2)
        if power % 2:
            primes.append(prime)
    monomial = tuple(sorted((("sqrt", str(prime)), 1) for prime in primes))
    return {monomial: Fraction(outside, value.denominator)}


def _factors(number: fmpz) -> Iterator[tuple[int, int]]:
    """Yield the primes of a positive number with their powers."""
    for factor, power in number.factor(trial_limit=SMALL_PRIMES):
        half = factor.isqrt()
        if factor.is_probable_prime():
            yield int(factor), power
        elif factor.bit_length() <= MOST_BITS:
            yield from ((int(prime), power * times) for prime, times in factor.factor())
        elif half * half == factor:
            yield from ((prime, 2 * power * times) for prime, times in _factors(half))
        else:
            raise ModelError(Fault.ROOT_OF_LARGE_NUMBER, digits=len(str(number)))


def add(*entries: Entry) -> Entry:
    """Return the sum of entries."""
    total: dict[Monomial, Fraction] = {}
    for entry in entries:
        for monomial, coefficient in entry.items():
            total[monomial] = total[monomial] + coefficient if monomial in total else coefficient
    return {monomial: coefficient for monomial, coefficient in total.items() if coefficient}


def scale(entry: Entry, factor: int | Fraction) -> Entry:
    """Return an entry times a rational number."""
    return {monomial: coefficient * factor for monomial, coefficient in entry.items()} if factor else ZERO


def multiply(*entries: Entry) -> Entry:
    """Return the product of entries, in normal form."""
    product, *others = entries or (ONE,)
    if not all(entries):
        return ZERO
    if not others:
        return normal_form(product)
    for entry in others:
        terms: dict[Monomial, Fraction] = {}
        for left, left_coefficient in product.items():
            for right, right_coefficient in entry.items():
                powers = dict(left)
                for gen, power in right:
                    powers[gen] = powers.get(gen, 0) + power
                monomial = tuple(sorted(powers.items()))
                coefficient = left_coefficient * right_coefficient
                terms[monomial] = terms[monomial] + coefficient if monomial in terms else coefficient
        product = normal_form(terms)
    return product


def normal_form(entry: Entry) -> Entry:
    """Return the entry with every s² replaced by 1 − c² and every r² of a square root by its number."""
    done: dict[Monomial, Fraction] = {}
    pending = list(entry.items())
    while pending:
        monomial, coefficient = pending.pop()
        high = next((item for item in monomial if item[1] > 1 and item[0][0] in ("sin", "sqrt")), None)
        if high is None:
            done[monomial] = done[monomial] + coefficient if monomial in done else coefficient
            continue
        (kind, name), power = high
        powers = dict(monomial)
        powers[kind, name] = power % 2
        if kind == "sqrt":
            pending.append((_monomial(powers), coefficient * int(name) ** (power // 2)))
            continue
        powers[kind, name] = power - 2
        pending.append((_monomial(powers), coefficient))
        powers["cos", name] = powers.get(("cos", name), 0) + 2
        pending.append((_monomial(powers), -coefficient))
    return {monomial: coefficient for monomial, coefficient in done.items() if coefficient}


def _monomial(powers: Mapping[Generator, int]) -> Monomial:
    return tuple(sorted(item for item in powers.items() if item[1]))


def matrix_product(left: Rows, right: Rows) -> Rows:
    """Return the product of two matrices of entries."""
    columns = tuple(zip(*right, strict=True))
    return tuple(
        tuple(add(*(multiply(a, b) for a, b in zip(row, column, strict=True))) for column in columns) for row in left
    )


def transpose(rows: Rows) -> Rows:
    """Return the transpose of a matrix of entries."""
    return tuple(zip(*rows, strict=True))


def generators(entries: Iterable[Entry]) -> set[Generator]:
    """Return every generator that occurs in the entries."""
    return {gen for entry in entries for monomial in entry for gen, _ in monomial}


def root_value(name: str) -> float:
    """Return the value of the generator ("sqrt", name)."""
    return sqrt(int(name))
