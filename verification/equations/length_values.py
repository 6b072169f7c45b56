"""Numbers where the arm has lengths: the values of the lengths for which an equation holds."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from fractions import Fraction

from armproof.models.exact.polynomial import Generator
from armproof.verification.algebra.calculus import is_of_fixed_angle, substitute, symbols_in
from armproof.verification.algebra.ring import Scalar


def length_values(differences: Iterable[Scalar], lengths: Mapping[str, float]) -> dict[str, Fraction] | None:
    """Return the values of lengths that follow from differences that are to vanish; None where no positive ones make them.

    `lengths` are the arm's own, for their signs alone. Every coefficient of what moves vanishes; one that is linear in a
    single length gives it its value. What products of lengths, and lengths under roots, leave open stays open.
    """
    plain = [each for each in differences if not _is_hidden(each, set(lengths))]
    equations = [each for difference in plain for each in _coefficients(difference, set(lengths))]
    found: dict[str, Fraction] = {}
    while True:
        solved = next((pair for each in equations if (pair := _solved(each, lengths)) is not None), None)
        if solved is None:
            return None if any(_holds_never(each, lengths) for each in equations) else found
        name, value = solved
        if value * Fraction(lengths[name] or 1.0) <= 0:
            return None
        found[name] = value
        equations = [rest for e in equations if not (rest := substitute(e, {name: e.ring.rational(value)})).is_zero()]


def _is_hidden(difference: Scalar, lengths: set[str]) -> bool:
    """Whether a length stands under a root, or in an arc function."""
    ring = difference.ring
    inner = [ring.radicand(name) for kind, name in difference.generators if kind == "radical"]
    inner += [each for kind, name in difference.generators if kind == "arc" for each in ring.arcs[name]]
    return not lengths.isdisjoint(symbols_in(inner))


def _coefficients(difference: Scalar, lengths: set[str]) -> list[Scalar]:
    """The coefficients, polynomials in lengths, π, roots of numbers and sines of fixed angles, of the products of all other generators."""
    ring = difference.ring
    found: dict[tuple[tuple[Generator, int], ...], Scalar] = {}
    for powers, number in ring.terms(difference.numerator):
        fixed = {generator for generator in powers if _is_fixed(generator) or generator[1] in lengths}
        rest = tuple(sorted(item for item in powers.items() if item[0] not in fixed))
        term = ring.rational(number)
        for generator in fixed:
            term = term * ring.generator(generator) ** powers[generator]
        found[rest] = found.get(rest, ring.zero) + term
    return [each for each in found.values() if not each.is_zero()]


def _is_fixed(generator: Generator) -> bool:
    """Whether a generator is a number: √2, π, or the sine of a fixed angle, "5*pi/36"."""
    return generator[0] in ("sqrt", "pi") or is_of_fixed_angle(generator)


def _solved(equation: Scalar, lengths: Mapping[str, float]) -> tuple[str, Fraction] | None:
    """Return the length that an equation k l − v = 0 fixes, and its value."""
    terms = list(equation.ring.terms(equation.numerator))
    alone = [(powers, number) for powers, number in terms if powers]
    if len(alone) != 1 or len(alone[0][0]) != 1:
        return None
    ((generator, power),) = alone[0][0].items()
    constant = sum((number for powers, number in terms if not powers), Fraction(0))
    return (generator[1], -constant / alone[0][1]) if power == 1 and generator[1] in lengths else None


def _holds_never(equation: Scalar, lengths: Mapping[str, float]) -> bool:
    """Whether no lengths make an equation hold: a number that is not zero, as 1 − √2 is none, or terms of one sign."""
    terms = list(equation.ring.terms(equation.numerator))
    has_sines = any(kind in ("cos", "sin") for powers, _ in terms for kind, _ in powers)  # which may be negative
    one_sign = len({number > 0 for _, number in terms}) == 1 and all(value >= 0 for value in lengths.values())
    one_sign = one_sign and not has_sines
    return one_sign or not any(name in lengths for powers, _ in terms for _, name in powers)
