"""Derivatives and substitution in the exact algebra, and what its normal form leaves open."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from fractions import Fraction
from math import prod

from flint import fmpq_mpoly

from armproof.models.exact.polynomial import Generator
from armproof.verification.algebra.angles import cos_sin, finest
from armproof.verification.algebra.ring import Ring, Scalar
from armproof.verification.algebra.roots import arc
from armproof.verification.errors import EvaluationError
from armproof.verification.findings import Kind, say


def derivative(value: Scalar, variable: Scalar) -> Scalar:
    """Return ∂value/∂variable for a variable that is a free symbol (a joint variable, a length).

    d cos θ = −sin θ, d sin θ = cos θ, d√k = dk/(2√k), d atan2(s, c) = c ds − s dc for s² + c² = 1.
    """
    ring = value.ring
    if (name := symbol_of(variable)) is None:
        raise EvaluationError(say(Kind.DERIVATIVE_BY_NO_VARIABLE))
    numerator = _poly_derivative(ring, value.numerator, name)
    denominator = _poly_derivative(ring, value.denominator, name)
    top, bottom = ring.scalar(value.numerator), ring.scalar(value.denominator)
    return (numerator * bottom - top * denominator) / (bottom * bottom)


def _poly_derivative(ring: Ring, polynomial: fmpq_mpoly, name: str) -> Scalar:
    polynomial = ring.polynomials.lift(polynomial)
    total = ring.zero
    for place, generator in ring.generators_of(polynomial):
        inner = _generator_derivative(ring, generator, name)
        if inner is not None and not inner.is_zero():
            total = total + ring.scalar(ring.reduce(polynomial.derivative(place))) * inner
    return total


def _generator_derivative(ring: Ring, generator: Generator, name: str) -> Scalar | None:
    """Return the derivative of a generator, None where it does not depend on the variable."""
    kind, label = generator
    share = ring.rational(Fraction(1, ring.parts.get(name, 1)))
    if generator == ("symbol", name):
        return ring.one
    if kind == "cos" and label == finest(ring, name):
        return -ring.generator(("sin", label)) * share
    if kind == "sin" and label == finest(ring, name):
        return ring.generator(("cos", label)) * share
    if kind == "radical":
        inner = _poly_derivative(ring, ring.radicand(label).numerator, name)
        return inner if inner.is_zero() else inner / (ring.generator(generator) * 2)
    if kind == "arc":
        (cosine, sine), variable = ring.arcs[label], ring.symbol(name)
        return cosine * derivative(sine, variable) - sine * derivative(cosine, variable)
    return None


def substitute(value: Scalar, values: Mapping[str, Scalar]) -> Scalar:
    """Return the value with symbols (joint variables, lengths) replaced, their cosines and sines with them."""
    parts: dict[str, int] | None = None
    replacements: dict[Generator, Scalar] = {}
    while parts != value.ring.parts:  # a fraction of an angle among the values changes the generators
        parts = dict(value.ring.parts)
        replacements = _replacements(value.ring, values)
    return _replaced(value, replacements)


def _replacements(ring: Ring, values: Mapping[str, Scalar]) -> dict[Generator, Scalar]:
    replacements: dict[Generator, Scalar] = {}
    for name, replacement in values.items():
        replacements["symbol", name] = replacement
        angle = finest(ring, name)
        if ("cos", angle) in ring.polynomials:
            pair = cos_sin(replacement / ring.parts.get(name, 1))
            replacements["cos", angle], replacements["sin", angle] = pair
    return replacements


def _replaced(value: Scalar, replacements: Mapping[Generator, Scalar]) -> Scalar:
    numerator = _replace(value.ring, value.numerator, replacements)
    if value.denominator.is_one():
        return numerator
    return numerator / _replace(value.ring, value.denominator, replacements)


def _replace(ring: Ring, polynomial: fmpq_mpoly, replacements: Mapping[Generator, Scalar]) -> Scalar:
    held = [g for _, g in ring.generators_of(polynomial) if g in replacements or g[0] in ("radical", "arc")]
    if not held:
        return ring.scalar(ring.polynomials.lift(polynomial))
    parts = ring.polynomials.split(polynomial, held)
    new = {generator: _replacement(ring, generator, replacements) for generator in held}
    products = (
        prod((new[generator] ** power for generator, power in powers.items()), start=ring.scalar(rest))
        for powers, rest in parts
    )
    return sum(products, ring.zero)


def _replacement(ring: Ring, generator: Generator, replacements: Mapping[Generator, Scalar]) -> Scalar:
    """Return what a generator that does not stay becomes; a root is taken anew, by its own rule."""
    kind, name = generator
    if generator in replacements:
        return replacements[generator]
    if kind == "radical":
        radical = ring.radicals[name]
        return radical.rule(_replace(ring, radical.square.numerator, replacements))
    return arc(*(_replaced(ring.lift(part), replacements) for part in ring.arcs[name]))


def angles_in(value: Scalar) -> set[str]:
    """Return the angles of which a value has the cosine or the sine."""
    return {name for kind, name in value.generators if kind in ("cos", "sin")}


def symbol_of(value: Scalar) -> str | None:
    """Return the symbol that a scalar is by itself; None of any other."""
    terms = list(value.ring.terms(value.numerator)) if value.denominator.is_one() else []
    if len(terms) != 1 or terms[0][1] != 1 or len(terms[0][0]) != 1:
        return None
    (kind, name), power = next(iter(terms[0][0].items()))
    return name if kind == "symbol" and power == 1 else None


def is_rate(symbol: str) -> bool:
    """Whether a symbol is the rate of a joint, or a higher derivative."""
    return symbol.startswith("dot")


def are_rates(cells: Sequence[Scalar]) -> bool:
    """Whether every cell is a rate by itself, as in q̇."""
    symbols = [symbol_of(cell) for cell in cells]
    return bool(symbols) and all(symbol is not None and is_rate(symbol) for symbol in symbols)


def degree_in(value: Scalar, symbols: Collection[str]) -> int | None:
    """Return of which degree a value is in symbols, terms alike; None where they are not, or roots and arc functions stand in it.

    Of lengths it tells what a value measures: -2 p_z d_3 is an area, and no coordinate.
    """
    if any(kind in ("radical", "arc") for kind, _ in value.generators):
        return None
    parts = [
        {
            sum(power for (kind, name), power in powers.items() if kind == "symbol" and name in symbols)
            for powers, _ in value.ring.terms(part)
        }
        for part in (value.numerator, value.denominator)
    ]
    return parts[0].pop() - parts[1].pop() if all(len(each) == 1 for each in parts) else None


def symbols_in(values: Iterable[Scalar]) -> set[str]:
    """Return the symbols that occur in values: as such, in angles, under roots, in arc functions."""
    found: set[str] = set()
    for value in values:
        for kind, name in value.generators:
            if kind == "symbol":
                found.add(name)
            elif kind in ("cos", "sin"):
                found |= {name.partition("/")[0]} - {"pi"} if not name[0].isdigit() else set()
            elif kind == "radical":
                found |= symbols_in([value.ring.radicand(name)])
            elif kind == "arc":
                found |= symbols_in(value.ring.arcs[name])
    return found


def leaves_open(difference: Scalar) -> bool:
    """Whether a difference that is not zero in normal form may vanish nevertheless.

    So it may if it holds a square root of an expression, an arc function, or the cosine of a constant angle that is no
    multiple of π/12 (cos 2π/5 is a generator of its own, though it is a polynomial in cos π/5).
    """
    return any(map(_is_open, difference.generators))


def _is_open(generator: Generator) -> bool:
    return generator[0] in ("radical", "arc") or is_of_fixed_angle(generator)


def is_of_fixed_angle(generator: Generator) -> bool:
    """Whether a generator is the cosine or sine of a constant angle: cos(π/5), sin(5π/36)."""
    kind, name = generator
    return kind in ("cos", "sin") and (name[:1].isdigit() or name.startswith("pi/"))
