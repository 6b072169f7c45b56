"""Conditions and factored polynomials as LaTeX, and as plain text."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from fractions import Fraction
from math import prod

from armproof.models.exact.polynomial import Generator
from armproof.verification.algebra.angles import cos_sin
from armproof.verification.algebra.calculus import derivative
from armproof.verification.algebra.ring import Scalar
from armproof.verification.algebra.written import write_scalar
from armproof.verification.latex.writer import Notation, symbol_as_latex
from armproof.verification.singularities.factors import Factor
from armproof.verification.singularities.half_angles import HalfAngles, Polynomial
from armproof.verification.singularities.linear import rational_content

_TURNS = {0: "0", 1: r"\frac{\pi}{2}", 2: r"\pi", -1: r"-\frac{\pi}{2}"}


def compact_notation() -> Notation:
    """Return the notation C_{12}, S_3."""
    return Notation(style="index", cosine="C")


def write_sum(signs: Sequence[tuple[str, int]]) -> str:
    """Write Σ ± θ."""
    text = ""
    for name, sign in signs:
        text += ("-" if sign < 0 else " + " if text else "") + symbol_as_latex(name)
    return text.replace("-", " - ").strip() if not text.startswith("-") else text


def write_condition(factor: Factor) -> str:
    """Write where a factor vanishes: \\theta_5 = 0, or a trigonometric equation."""
    if factor.angle_sum is not None:
        return f"{write_sum(factor.angle_sum.signs)} = {_TURNS[factor.angle_sum.turns]}"
    linear = _single_symbol(factor)
    if linear is not None:
        return linear
    return f"{write_scalar(condition_scalar(factor), compact_notation())} = 0"


def _single_symbol(factor: Factor) -> str | None:
    """Write r = 0, or a_1 = a_2."""
    polynomial, half = factor.polynomial, factor.half
    if half.used(polynomial)[0] or polynomial.total_degree() != 1:
        return None
    value = half.ring.scalar(condition_scalar(factor).numerator)
    terms = sorted(half.ring.terms(value.numerator), key=lambda term: sorted(term[0]))
    name = next((next(iter(p))[1] for p, k in terms if p and abs(k) == 1), None)
    if name is None:
        return None
    symbol = half.ring.symbol(name)
    slope = derivative(value, symbol)
    return f"{symbol_as_latex(name)} = {write_scalar(symbol - value / slope, compact_notation())}"


def condition_scalar(factor: Factor) -> Scalar:
    """Return a scalar that vanishes where the factor does, its coefficients coprime integers, that of the first length positive.

    A factor of odd degree in a pair (t, u) is no function of the angle; its square is.
    """
    value = factor.half.squares_to_scalar(factor.polynomial)
    numbers = list(value.numerator.coeffs())
    scale = rational_content(numbers)
    first = min(value.ring.terms(value.numerator), key=lambda term: _reading_order(term[0]))
    return factor.half.ring.scalar(value.numerator / (scale if first[1] > 0 else -scale))


def _reading_order(powers: Mapping[Generator, int]) -> list[tuple[bool, str, str]]:
    """The order of terms: by their lengths, then by their angles; a constant comes last."""
    return sorted((kind in ("cos", "sin"), name, kind) for kind, name in powers) or [(True, "~", "")]


def trigonometric_factors(
    half: HalfAngles, polynomial: Polynomial, positive: frozenset[str]
) -> list[tuple[Scalar, int]]:
    """Return the factors of a polynomial in cosines and sines, with powers; their product is it up to a number.

    The factors θ = 0 and θ = π pair to sin θ, ±π/2 to cos θ; what is left unpaired comes as 1 ∓ cos θ and its like.
    """
    _, found = polynomial.factor()
    sums: dict[tuple[tuple[str, int], ...], dict[int, int]] = {}
    plain_ones: list[tuple[Scalar, int]] = []
    for raw, power in found:
        factor = Factor(half, raw, positive)
        if factor.angle_sum is not None:
            sums.setdefault(factor.angle_sum.signs, {})[factor.angle_sum.turns] = int(power)
            continue
        value = half.scalar(raw)
        if value is None:
            plain_ones.append((condition_scalar(factor), 0))
        elif value.as_fraction() is None:
            plain_ones.append((condition_scalar(factor), int(power)))
    for signs, powers in sums.items():
        plain_ones += _of_angle(half, signs, powers)
    return plain_ones


def _of_angle(half: HalfAngles, signs: tuple[tuple[str, int], ...], powers: dict[int, int]) -> list[tuple[Scalar, int]]:
    ring = half.ring
    cosine, sine = cos_sin(sum((ring.symbol(name) * sign for name, sign in signs), ring.zero))
    found: list[tuple[Scalar, int]] = []
    for first, second, value, ends in ((0, 2, sine, (1 - cosine, 1 + cosine)), (1, -1, cosine, (1 - sine, 1 + sine))):
        pairs = min(powers.get(first, 0), powers.get(second, 0))
        if pairs:
            found.append((value, pairs))
        for turns, end in zip((first, second), ends, strict=True):
            left = powers.get(turns, 0) - pairs
            if left:
                found.append((end, left // 2 if left % 2 == 0 else 0))
    return found


def write_product(value: Scalar, factors: Sequence[tuple[Scalar, int]]) -> str | None:
    """Write a scalar as a number times powers of factors; None where it is no such product (checked by normal form)."""
    ring = value.ring
    if value.is_zero() or any(power == 0 for _, power in factors):
        return None
    product = prod((factor**power for factor, power in factors), start=ring.one)
    quotient = value.numerator.leading_coefficient() / product.numerator.leading_coefficient()
    ratio = Fraction(int(quotient.p), int(quotient.q))
    if not (value - product * ring.rational(ratio)).is_zero():
        return None
    sign = "-" if ratio < 0 else ""
    head = "" if abs(ratio) == 1 else f"{abs(ratio)} "
    return sign + head + " ".join(_write_power(factor, power) for factor, power in sorted(factors, key=_order))


def _order(item: tuple[Scalar, int]) -> tuple[int, int, str]:
    value = item[0]
    kinds = {kind for kind, _ in value.generators}
    return len(value.numerator), "symbol" not in kinds, write_scalar(value, compact_notation())


def _write_power(factor: Scalar, power: int) -> str:
    text = write_scalar(factor, compact_notation())
    if len(factor.numerator) > 1 and re.search(r" [+-] ", text):
        text = f"\\left({text}\\right)"
    if power == 1:
        return text
    return f"{text}^{power}" if text.startswith("\\left") else f"({text})^{power}"
