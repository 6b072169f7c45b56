"""Polynomials in cosines, sines and lengths, only to print formulas with: what is true is asked of the plant."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

Polynomial = dict[tuple[str, ...], Fraction]  # sorted factors → coefficient
PolynomialMatrix = list[list[Polynomial]]
ZERO: Polynomial = {}


def constant(value: Fraction | int) -> Polynomial:
    """Return a number as a polynomial."""
    return {(): Fraction(value)} if value else {}


def atom(name: str) -> Polynomial:
    """Return a factor as a polynomial."""
    return {(name,): Fraction(1)}


def add(left: Polynomial, right: Polynomial) -> Polynomial:
    """Return the sum."""
    found = dict(left)
    for factors, coefficient in right.items():
        found[factors] = found.get(factors, Fraction(0)) + coefficient
    return {factors: coefficient for factors, coefficient in found.items() if coefficient}


def times(left: Polynomial, right: Polynomial) -> Polynomial:
    """Return the product."""
    found: Polynomial = {}
    for some, a in left.items():
        for others, b in right.items():
            found = add(found, {tuple(sorted((*some, *others))): a * b})
    return found


def product(left: PolynomialMatrix, right: PolynomialMatrix) -> PolynomialMatrix:
    """Return the matrix product."""
    columns = list(zip(*right, strict=True))
    return [[_dot(row, column) for column in columns] for row in left]


def _dot(row: list[Polynomial], column: tuple[Polynomial, ...]) -> Polynomial:
    total = ZERO
    for a, b in zip(row, column, strict=True):
        total = add(total, times(a, b)) if a and b else total
    return total


def derivative(value: Polynomial, joint: str, angle: str) -> Polynomial:
    """Return ∂/∂joint: of c_i and s_i where the joint is the angle i, else of the joint itself."""
    total: Polynomial = {}
    rules = {f"c{angle}": (f"s{angle}", -1), f"s{angle}": (f"c{angle}", 1)} if angle else {joint: ("", 1)}
    for factors, coefficient in value.items():
        for k, factor in enumerate(factors):
            if factor in rules:
                becomes, sign = rules[factor]
                rest = (*factors[:k], *((becomes,) if becomes else ()), *factors[k + 1 :])
                total = add(total, {tuple(sorted(rest)): sign * coefficient})
    return total


def to_latex(value: Polynomial, spell: Callable[[str], str]) -> str:
    """Print a polynomial; `spell` writes a factor."""
    text = ""
    for factors, coefficient in value.items():
        sign = "-" if coefficient < 0 else "+" if text else ""
        size = abs(coefficient)
        number = "" if size == 1 and factors else number_of(size)
        text += f" {sign} " + " ".join([*([number] if number else []), *(spell(factor) for factor in factors)])
    return text.strip().replace("- ", "-", 1) if text.strip().startswith("- ") else text.strip() or "0"


def number_of(value: Fraction) -> str:
    """Print a number: a decimal where it has few places, else a fraction."""
    if value.denominator == 1:
        return str(value.numerator)
    if 1000 % value.denominator == 0:
        return f"{float(value):g}"
    return rf"\frac{{{value.numerator}}}{{{value.denominator}}}"


def count_terms(matrix: PolynomialMatrix) -> int:
    """Return the number of terms in a matrix."""
    return sum(len(cell) for row in matrix for cell in row)
