"""Write an exact scalar compactly: products of sines and cosines folded into those of sums of angles.

For a report it is written in full where a reader could use it, else with an ellipsis.
"""

from __future__ import annotations

import itertools
import math
import re
from collections import defaultdict
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

from armproof.models.exact.polynomial import Generator
from armproof.verification.algebra.budget import Budget
from armproof.verification.algebra.ring import Scalar
from armproof.verification.latex.writer import Notation, number

Angle = tuple[tuple[str, Fraction | int], ...]  # sorted (symbol, coefficient); whole numbers as int, which hash faster
Trig = tuple[tuple[str, Angle, int], ...]  # sorted (function, angle, power): a monomial of sines and cosines
Rest = tuple[tuple[Generator, int], ...]
MAX_TERMS = 60
WRITTEN = 400  # terms: more are written as an ellipsis
FOLDED = 120  # terms: of so many, products of sines and cosines are written as those of sums of angles where shorter
LONGEST = 2000  # characters of a corrected term; what is longer is no correction that anybody could use


@dataclass(frozen=True)
class _Term:
    coefficient: Fraction
    rest: Rest
    trig: Trig


def write_scalar(value: Scalar, notation: Notation, *, folded: bool = True) -> str:
    """Return LaTeX for the value in the document's notation, such as `-a_1 S_1 - a_2 S_{12}`.

    `folded` writes products of sines and cosines as those of sums of angles wherever that is shorter; without it the
    terms are those of the normal form.
    """
    value = value.normal()
    above = _terms(value, value.numerator, folded)
    below = _terms(value, value.denominator, folded)
    if value.denominator.is_one() or not above:
        return _write_sum(value, above, notation)
    scale = _content([*above, *below])
    above, below = ([replace(term, coefficient=term.coefficient / scale) for term in terms] for terms in (above, below))
    sign = ""
    if len(above) == 1 and above[0].coefficient < 0:
        sign, above = "-", [replace(above[0], coefficient=-above[0].coefficient)]
    return f"{sign}\\frac{{{_write_sum(value, above, notation)}}}{{{_write_sum(value, below, notation)}}}"


def write_bounded(value: Any, notation: Notation) -> str:
    """Return a value in LaTeX, in the document's notation; at most LONGEST characters of it."""
    if isinstance(value, Scalar):
        terms = terms_to_write(value)
        if terms > WRITTEN:
            return r"\ldots"
        # folding into sums of angles takes its time, and makes no page of terms readable
        small = terms <= FOLDED and not value.ring.budget.is_spent
        text = write_scalar(value, notation, folded=small)
    else:
        text = str(value)
    return text if len(text) <= LONGEST else text[:LONGEST].rsplit(" ", 1)[0] + r" \ldots"


def terms_to_write(value: Scalar) -> int:
    """How many terms a value is written with, those under its roots and in its arc functions included each time."""
    total = 0
    for part in (value.numerator, value.denominator):
        if len(part) > WRITTEN:
            return len(part)
        for powers, _ in value.ring.terms(part):
            total += 1
            for kind, name in powers:
                inner = (
                    [value.ring.radicand(name)] if kind == "radical" else value.ring.arcs[name] if kind == "arc" else ()
                )
                total += sum(terms_to_write(below) for below in inner)
            if total > WRITTEN:
                return total
    return total


def _content(terms: list[_Term]) -> Fraction:
    """Return the number that leaves coprime integers when the coefficients are divided by it."""
    numerators = [abs(term.coefficient.numerator) for term in terms]
    return Fraction(math.gcd(*numerators), math.lcm(*(term.coefficient.denominator for term in terms)))


def _terms(value: Scalar, polynomial: object, folded: bool) -> list[_Term]:
    """Return the terms of a polynomial, a positive one first."""
    groups: dict[Rest, dict[Trig, Fraction]] = defaultdict(dict)
    for powers, coefficient in value.ring.terms(polynomial):  # type: ignore[arg-type]
        trig: Trig = tuple(
            sorted((k, ((name, 1),), power) for (k, name), power in powers.items() if k in ("cos", "sin"))
        )
        rest = tuple(
            sorted((generator, power) for generator, power in powers.items() if generator[0] not in ("cos", "sin"))
        )
        groups[rest][trig] = coefficient
    terms: list[_Term] = []
    for rest, trigs in groups.items():
        shorter = fold(trigs, value.ring.budget) if folded and len(trigs) <= MAX_TERMS else trigs
        for trig, coefficient in sorted(shorter.items(), key=lambda item: (len(item[0]), item[0])):
            terms.append(_Term(coefficient, rest, trig))
    return sorted(terms, key=lambda term: term.coefficient < 0)  # a positive term first reads better


def _write_sum(value: Scalar, terms: list[_Term], notation: Notation) -> str:
    text = ""
    for term in terms:
        negative = term.coefficient < 0
        written = _write_term(value, abs(term.coefficient), term.rest, term.trig, notation)
        text += (" - " if negative else " + ") + written if text else ("-" if negative else "") + written
    return text or "0"


def _write_term(value: Scalar, coefficient: Fraction, rest: Rest, trig: Trig, notation: Notation) -> str:
    factors: list[str] = []
    for (kind, name), power in rest:
        if kind == "sqrt":
            text = f"\\sqrt{{{name}}}"
        elif kind == "pi":
            text = "\\pi"
        elif kind == "radical":
            text = f"\\sqrt{{{write_scalar(value.ring.radicand(name), notation)}}}"
        elif kind == "arc":
            cosine, sine = value.ring.arcs[name]
            text = f"\\operatorname{{atan2}}({write_scalar(sine, notation)}, {write_scalar(cosine, notation)})"
        else:
            text = notation.symbol(name)
        factors.append(text if power == 1 else text + _exponent(power))
    for function, angle, power in trig:
        factors.append(_power_of_trig(notation.trig(function, {name: Fraction(k) for name, k in angle}), power))
    if coefficient != 1 or not factors:
        factors.insert(0, number(coefficient))
    return " ".join(factors)


def _exponent(power: int) -> str:
    return f"^{{{power}}}" if power > 9 else f"^{power}"


def _power_of_trig(text: str, power: int) -> str:
    """Write \\cos^2(\\theta_1), C_1^2 or (C\\theta_1)^2."""
    if power == 1:
        return text
    if found := re.fullmatch(r"(\\[A-Za-z]+)(\(.*\))", text):
        return found.group(1) + _exponent(power) + found.group(2)
    is_one = re.fullmatch(r"[^\s_(\\]*(?:\\mathrm\{\w\})?(?:_\{[^{}]*\}|_\w|\d+)", text) is not None
    return text + _exponent(power) if is_one else f"({text}){_exponent(power)}"


def fold(terms: dict[Trig, Fraction], budget: Budget | None = None) -> dict[Trig, Fraction]:
    """Return an equal sum with fewer terms, by writing an angle as a sum of two wherever that shortens it.

    With φ = α ± β: c_α = c_φ c_β ± s_φ s_β and s_α = s_φ c_β ∓ c_φ s_β; c_β² + s_β² = 1 then collects the terms.
    When the budget is spent the shortest sum found so far is returned.
    """
    best = terms
    while len(best) > 1:
        together = {
            pair for trig in best for pair in itertools.permutations(sorted({angle for _, angle, _ in trig}), 2)
        }
        candidates = []
        for a, b in sorted(together):
            if budget is not None and budget.is_spent:
                return best
            for sign in (1, -1):
                folded = _substitute(best, a, b, sign)
                if len(folded) < len(best):
                    candidates.append(folded)
        if not candidates:
            return best
        best = min(candidates, key=lambda folded: (len(folded), sum(len(trig) for trig in folded)))
    return best


def _substitute(terms: dict[Trig, Fraction], a: Angle, b: Angle, sign: int) -> dict[Trig, Fraction]:
    total: dict[Trig, Fraction] = defaultdict(Fraction)
    combined = _combine(a, b, sign)
    for trig, coefficient in terms.items():
        for factors, weight in _expanded(trig, a, b, combined, sign):
            for reduced, extra in _reduced(factors, b):
                total[reduced] += coefficient * (weight * extra)
    return {trig: coefficient for trig, coefficient in total.items() if coefficient}


def _combine(a: Angle, b: Angle, sign: int) -> Angle:
    total: dict[str, Fraction | int] = defaultdict(int)
    for name, coefficient in a:
        total[name] += coefficient
    for name, coefficient in b:
        total[name] += sign * coefficient
    return tuple(sorted((name, coefficient) for name, coefficient in total.items() if coefficient))


def _expanded(
    trig: Trig, a: Angle, b: Angle, combined: Angle, sign: int
) -> list[tuple[dict[tuple[str, Angle], int], int]]:
    products: list[tuple[dict[tuple[str, Angle], int], int]] = [({}, 1)]
    for function, angle, power in trig:
        if angle != a:
            for factors, _ in products:
                factors[function, angle] = factors.get((function, angle), 0) + power
            continue
        for _ in range(power):
            grown = []
            if function == "cos":
                pieces = [("cos", "cos", 1), ("sin", "sin", sign)]
            else:
                pieces = [("sin", "cos", 1), ("cos", "sin", -sign)]
            for factors, weight in products:
                for first, second, factor in pieces:
                    more = dict(factors)
                    more[first, combined] = more.get((first, combined), 0) + 1
                    more[second, b] = more.get((second, b), 0) + 1
                    grown.append((more, weight * factor))
            products = grown
    return products


def _reduced(factors: dict[tuple[str, Angle], int], b: Angle) -> list[tuple[Trig, int]]:
    """Replace s_β² by 1 − c_β², so that equal terms meet."""
    power = factors.get(("sin", b), 0)
    results: list[tuple[dict[tuple[str, Angle], int], int]] = [(dict(factors), 1)]
    for _ in range(power // 2):
        grown = []
        for entry, weight in results:
            entry[("sin", b)] -= 2
            grown.append((dict(entry), weight))
            squared = dict(entry)
            squared[("cos", b)] = squared.get(("cos", b), 0) + 2
            grown.append((squared, -weight))
        results = grown
    return [
        (tuple(sorted((f, angle, power) for (f, angle), power in entry.items() if power)), weight)
        for entry, weight in results
    ]
