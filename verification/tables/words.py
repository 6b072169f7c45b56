"""What is wrong with a printed entry of a table."""

from __future__ import annotations

import math

from armproof.verification.algebra.angles import cos_sin
from armproof.verification.algebra.ring import Scalar
from armproof.verification.findings import Finding, Kind, say
from armproof.verification.latex.reader import key_as_latex
from armproof.verification.tables.angles import in_radians, rational_part

ROUNDED = 5e-3  # rad: 1.57 for π/2


def change_of_length(printed: Scalar, right: Scalar) -> Finding | None:
    """Return what is wrong with a printed length; None where it is nothing short."""
    return say(Kind.THE_SIGN) if (printed + right).is_zero() else _change_of_terms(printed, right)


def change_of_angle(printed: Scalar, right: Scalar) -> Finding | None:
    """Return what is wrong with a printed angle; `right` as a sum of symbols and a multiple of π."""
    if _same_angle(printed, -right):
        return say(Kind.THE_SIGN)
    if rational_part(printed) and _same_angle(in_radians(printed), right):
        return say(Kind.DEGREES_FOR_RADIANS)
    if _is_rounded(printed - right):
        return say(Kind.ROUNDED)
    if symbols_of(printed) and _signs(printed) == _signs(right):
        return say(Kind.THE_OFFSET)
    return _change_of_terms(printed, right)


def _same_angle(one: Scalar, other: Scalar) -> bool:
    cosine, sine = cos_sin(one - other)
    return (cosine - 1).is_zero() and sine.is_zero()


def _is_rounded(difference: Scalar) -> bool:
    """Whether a difference is a decimal and a multiple of π that nearly cancel."""
    terms = {tuple(powers): float(c) for powers, c in difference.ring.terms(difference.normal().numerator)}
    if terms.keys() != {(), (("pi", ""),)}:
        return False
    return abs(terms[()] + math.pi * terms[("pi", ""),]) < ROUNDED


def _change_of_terms(printed: Scalar, right: Scalar) -> Finding | None:
    if printed.is_zero():
        return say(Kind.IS_MISSING)
    if right.is_zero():
        return say(Kind.SHOULD_VANISH)
    one, other = symbols_of(printed), symbols_of(right)
    gone, more = sorted(other - one), sorted(one - other)
    if len(gone) == len(more) == 1:
        is_index = letter_of(gone[0]) == letter_of(more[0])
        return (
            say(Kind.THE_INDEX)
            if is_index
            else say(Kind.LETTER_FOR_LETTER, printed=key_as_latex(more[0]), correct=key_as_latex(gone[0]))
        )
    if len(gone) == 1 and not more:
        return say(Kind.LETTER_MISSING, letter=key_as_latex(gone[0]))
    if len(more) == 1 and not gone:
        return say(Kind.LETTER_EXTRA, letter=key_as_latex(more[0]))
    if one == other and one:
        return say(Kind.A_SIGN if _signs(printed) != _signs(right) else Kind.A_FACTOR)
    return None


def letter_of(symbol: str) -> str:
    """Return a symbol without its index."""
    return symbol.partition("_")[0]


def symbols_of(value: Scalar) -> set[str]:
    """Return the symbols of a sum."""
    return {name for powers, _ in value.ring.terms(value.numerator) for kind, name in powers if kind == "symbol"}


def _signs(value: Scalar) -> dict[str, bool]:
    """Which terms with a symbol are negative."""
    return {
        " ".join(sorted(name for _, name in powers)): c < 0
        for powers, c in value.ring.terms(value.numerator)
        if any(kind == "symbol" for kind, _ in powers)
    }
