"""How a wrong answer relates to what is asked, by values: the words where no slip of the pen explains it."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import combinations, pairwise

import numpy as np

from armproof.course.feedback.claim import ANGLE
from armproof.course.feedback.outcome import MOST_PLACES, place
from armproof.models.errors import written
from armproof.models.language import look_up, number_text, separator
from armproof.verification.latex.writer import symbol_as_latex

Letters = Mapping[str, np.ndarray]  # each letter's values at the samples
Values = Callable[[Letters], np.ndarray]  # what letters give, (samples, rows, columns)

_JOINT_ANGLE = re.compile(r"theta_\d$")
ENOUGH = 5  # samples at which both sides have a value, so that a chance agreement is none
_TOLERANCE = 1e-8
_MOST_FACTORS = 4
_LARGEST = 64  # denominator of a number in a product
_GROWN = 1.5  # by which a letter, or all of one unit, is changed to see what follows it
_MOST_LETTERS = 8


def relation(true: np.ndarray, obtained: np.ndarray, factors: Letters) -> str:
    """Return how the wrong entries of an answer relate to the right ones; empty where no simple relation holds.

    Args:
        true, obtained: what is asked and what is given, (samples, rows, columns).
        factors: what may be a factor too many or too few, by its name.
    """
    if obtained.size != true.size:
        return ""
    obtained = obtained.reshape(true.shape)
    return _told(true, obtained, lambda asked, given: _of_values(asked, given, factors))


def letters_astray(asked: Values, given: Values, at: Letters) -> str:
    """Say which letters of an answer are exchanged, missing, or do not belong in it; empty where none is.

    Args:
        asked, given: what is asked and what is given, as functions of the letters.
        at: values of the letters.
    """
    wrong = _wrong(asked(at), given(at))
    words = _letter_astray(asked, given, at, wrong)
    (where, *others) = np.argwhere(wrong).tolist() or [[0, 0]]
    if not words or others or wrong.size == 1:
        return words
    return written("entry {place}: {words}", place=place(where[0] + 1, where[1] + 1), words=words)


def letters_astray_in_each(asked: Values, given: Values, at: Letters) -> str:
    """Say of each wrong entry of a matrix which letters are exchanged in it, missing, or do not belong there."""
    wrong = _wrong(asked(at), given(at))
    told = []
    for row, column in np.argwhere(wrong).tolist()[:MOST_PLACES]:
        only = np.zeros_like(wrong)
        only[row, column] = True
        if words := _letter_astray(asked, given, at, only):
            told.append(written("entry {place}: {words}", place=place(row + 1, column + 1), words=words))
    return look_up("; ").join(told)


def _letter_astray(asked: Values, given: Values, at: Letters, wrong: np.ndarray) -> str:
    obtained, few = given(at), list(at)[:_MOST_LETTERS]
    for one, other in combinations(few, 2):
        if _same(asked({**at, one: at[other], other: at[one]})[:, wrong], obtained[:, wrong]):
            return written("{one} and {other} are exchanged", one=symbol_as_latex(one), other=symbol_as_latex(other))
    angles = [name for name in at if _JOINT_ANGLE.match(name)]
    if len(angles) > 1:
        absolute = {name: at[name] - at[before] for before, name in pairwise(angles)}
        if _same(asked({**at, **absolute})[:, wrong], obtained[:, wrong]):
            return look_up("each angle is taken as absolute, from the base: sums of angles are missing")
    for name in few:
        moved = {**at, name: at[name] * _GROWN}
        shown = symbol_as_latex(name)
        needed, used = (not _same(side(moved)[:, wrong], side(at)[:, wrong]) for side in (asked, given))
        if needed and not used:
            return written("{name} is missing: what is asked depends on it, your answer does not", name=shown)
        if used and not needed:
            return written("what is asked does not depend on {name}, your answer does", name=shown)
    return ""


def angle_astray(asked: Values, given: Values, at: Letters) -> str:
    """Say which angle is taken the other way, or counted from a direction a quarter or half a turn away; empty where none is."""
    obtained = given(at)
    wrong = _wrong(asked(at), obtained)
    for name in filter(ANGLE.match, at):
        shown = symbol_as_latex(name)
        turned = {turn: asked({**at, name: at[name] + turn * np.pi / 2})[:, wrong] for turn in (-1, 1, 2)}
        if _same(asked({**at, name: -at[name]})[:, wrong], obtained[:, wrong]):
            return written("the sign of {name} is wrong: it is taken the other way", name=shown)
        if _same(turned[2], obtained[:, wrong]):
            return written("{name} is counted from the opposite direction: half a turn away", name=shown)
        if any(_same(sign * turned[turn], obtained[:, wrong]) for turn in (-1, 1) for sign in (1, -1)):
            return written("{name} is counted from another direction: a quarter turn away", name=shown)
    return ""


def units_astray(asked: Values, given: Values, at: Letters, units: Sequence[Sequence[str]]) -> str:
    """Say if an answer is of another unit than what is asked, or adds terms of several; `units`: letters of one unit each."""
    wrong = _wrong(asked(at), given(at))
    return next(filter(None, (_units(asked, given, at, names, wrong) for names in units if names)), "")


def letter_at_fault(asked: Values, given: Values, at: Letters) -> str:
    """Say for which letter an answer is right at zero: the mistake is in how that letter comes in."""
    wrong = _wrong(asked(at), given(at))
    for name in list(at)[:_MOST_LETTERS]:
        without = {**at, name: np.zeros_like(at[name])}
        true = asked(without)[:, wrong]
        if _same(given(without)[:, wrong], true) and np.nanmax(np.abs(true)) > _TOLERANCE:
            return written("right for {name} = 0: look at how {name} comes in", name=symbol_as_latex(name))
    return ""


def _units(asked: Values, given: Values, at: Letters, names: Sequence[str], wrong: np.ndarray) -> str:
    """Say if the terms of an answer are of another unit than what is asked: all letters of one unit are made larger."""
    degrees = [_degree(side, at, names, wrong) for side in (asked, given)]
    if degrees[0] is None or degrees[0] == degrees[1]:
        return ""
    letters = separator(names).join(map(symbol_as_latex, names))
    if degrees[1] is None:
        return written("the units do not fit: your answer adds or compares what has different powers of {letters}", letters=letters)  # fmt: skip
    needed, used = (number_text(2.0**degree, "g") for degree in degrees if degree is not None)
    return written("the units do not fit: with twice {letters}, what is asked is multiplied by {needed}, your answer by {used}", letters=letters, needed=needed, used=used)  # fmt: skip


def _degree(side: Values, at: Letters, names: Sequence[str], wrong: np.ndarray) -> float | None:
    """Return the power of the letters, all made larger alike, by which all values grow; None where they do not."""
    before = side(at)[:, wrong]
    after = side({**at, **{name: at[name] * _GROWN for name in names}})[:, wrong]
    good = np.isfinite(before) & np.isfinite(after) & (np.abs(before) > _TOLERANCE) & (np.abs(after) > _TOLERANCE)
    if good.sum() < ENOUGH:
        return None
    ratio = after[good] / before[good]
    degree = round(float(np.log(np.abs(ratio[0])) / np.log(_GROWN)) * 2) / 2
    return degree if _same(ratio, np.full_like(ratio, _GROWN**degree)) else None


def _told(true: np.ndarray, obtained: np.ndarray, words_of: Callable[[np.ndarray, np.ndarray], str]) -> str:
    """Return the words on all wrong entries, if they are the same, or on those that have some."""
    places = np.argwhere(_wrong(true, obtained)).tolist()
    found = {(r, c): words_of(true[:, r, c], obtained[:, r, c]) for r, c in places}
    said = {at: words for at, words in found.items() if words}
    if (len(found) > 1 and len(set(found.values())) == 1) or true[0].size == 1:
        return next(iter(found.values()), "")
    entries = [
        written("entry {place}: {words}", place=place(r + 1, c + 1), words=words)
        for (r, c), words in list(said.items())[:MOST_PLACES]
    ]
    return look_up("; ").join(entries)


def _of_values(true: np.ndarray, obtained: np.ndarray, factors: Letters) -> str:
    good = np.isfinite(true) & np.isfinite(obtained)
    if good.sum() < ENOUGH:
        return ""
    true, obtained = true[good], obtained[good]
    factors = {name: values[good] for name, values in factors.items()}
    return next(filter(None, (*_plain(true, obtained), _multiple(true, obtained, factors))), "")


def _plain(true: np.ndarray, obtained: np.ndarray) -> Iterator[str]:
    """Yield the words of the relations that hold between one value and the other."""
    if not np.abs(true).max() > _TOLERANCE:
        yield look_up("zero belongs there")
        return
    if not np.abs(obtained).max() > _TOLERANCE:
        yield look_up("what is asked is not zero")
        return
    if _same(obtained**2, true):
        yield look_up("your answer is the root: its square is asked")
    if _same(obtained, true**2):
        yield look_up("your answer is the square of what is asked")
    if _same(obtained * true, np.ones_like(true)):
        yield look_up("numerator and denominator are exchanged")
    if _same(obtained**2 + true**2, np.ones_like(true)):
        yield look_up("a sine stands where the cosine of the same angle belongs, or a cosine where its sine does")
    for function, name in ((np.cos, look_up("cosine")), (np.sin, look_up("sine"))):
        if _same(function(obtained), true):
            yield written("your answer is the angle: its {function} is asked", function=name)
    if _same(np.sin(obtained), np.tan(true)) or _same(np.cos(obtained), np.tan(true)):
        yield look_up("the tangent of the angle is known: `atan2` belongs there, not `arcsin` or `arccos`")
    if _same(np.sin(obtained), np.sin(true)):
        yield look_up("the sine is right, the angle is not: `arcsin` gives no angle beyond a quarter turn")
    if _same(np.exp(1j * (obtained + true)), np.full(len(true), 1j)):
        yield look_up("the arguments of `atan2` are exchanged: first the side across, then the side along")
    turns = (obtained - true) / np.pi
    if _same(turns, np.round(turns)) and (np.round(turns) % 2 == 1).any():
        yield look_up("right up to half a turn: `atan2` keeps the quadrant, `arctan` does not")
    if _same(np.abs(obtained), np.abs(true)) and np.ptp(np.sign(obtained * true)) > 0:
        yield look_up("right but for the sign, and for some values only: it must hold in all quadrants")


def _multiple(true: np.ndarray, obtained: np.ndarray, factors: Letters) -> str:
    """Say by which product an answer is too large, or which product of letters it has too much or too little."""
    good = (np.abs(true) > _TOLERANCE) & (np.abs(obtained) > _TOLERANCE)
    if good.sum() < ENOUGH:
        return ""
    ratio = obtained[good] / true[good]
    if _same(ratio, np.full_like(ratio, ratio[0])):
        return _by_number(float(ratio[0]))
    known = {name: values[good] for name, values in factors.items()}
    if times := _product(ratio, known):
        return written("your answer is {product} times what is asked", product=times)
    difference = obtained[good] - true[good]
    if (more := _product(difference, known)).startswith("-"):
        return written("your answer is what is asked minus {product}", product=more[1:])
    if more:
        return written("your answer is what is asked plus {product}", product=more)
    if more := _product(obtained[good] ** 2 - true[good] ** 2, known):
        return written("the square of your answer differs from that of what is asked by {product}", product=more)
    return ""


def _product(values: np.ndarray, factors: Letters) -> str:
    """Return values as a product of powers of factors; empty where they are none, or one of many factors."""
    factors = {name: each for name, each in factors.items() if (np.abs(each) > _TOLERANCE).all()}
    if len(values) < len(factors) + ENOUGH or not (np.abs(values) > _TOLERANCE).all():
        return ""
    logarithms = np.column_stack([np.log(np.abs(each)) for each in factors.values()] + [np.ones(len(values))])
    powers = np.round(np.linalg.lstsq(logarithms, np.log(np.abs(values)), rcond=None)[0][:-1]).astype(int)
    rest = values / np.prod(
        [each**power for each, power in zip(factors.values(), powers.tolist(), strict=True)], axis=0
    )
    number = Fraction(float(np.median(rest))).limit_denominator(_LARGEST)
    if not _same(rest, np.full_like(rest, float(number))) or not 0 < np.count_nonzero(powers) <= _MOST_FACTORS:
        return ""
    over, under = ([_power(name, abs(power)) for name, power in zip(factors, powers.tolist(), strict=True) if power * sign > 0] for sign in (1, -1))  # fmt: skip
    sign = "-" if number < 0 else ""
    over = [str(abs(number.numerator))] * (abs(number.numerator) != 1 or not over) + over
    under = [str(number.denominator)] * (number.denominator != 1) + under
    below = f" / ({' '.join(under)})" if len(under) > 1 else " / " + "".join(under)
    return f"{sign}{' '.join(over)}{below if under else ''}"


def _power(name: str, power: int) -> str:
    """Return a power of a factor as text; a sum or a function of an angle in brackets."""
    shown = f"({name})" if "+" in name or "-" in name or (" " in name and power != 1) else name
    return shown if power == 1 else f"{shown}^{power}"


def _by_number(factor: float) -> str:
    size = number_text(max(abs(factor), 1 / abs(factor)), ".4g")
    if abs(abs(factor) - 1) < _TOLERANCE:
        return look_up("the sign is wrong")
    if abs(factor) > 1:
        return written("your answer is {factor} times too large", factor=size)
    return written("your answer is {factor} times too small", factor=size)


def _wrong(true: np.ndarray, obtained: np.ndarray) -> np.ndarray:
    """Return which entries differ at any sample, (rows, columns)."""
    good = np.isfinite(true) & np.isfinite(obtained)
    return np.asarray((good & (np.abs(true - obtained) > _TOLERANCE * (1 + np.abs(true)))).any(axis=0))


def _same(one: np.ndarray, other: np.ndarray) -> bool:
    good = np.isfinite(one) & np.isfinite(other)
    return bool(good.sum() >= ENOUGH and (np.abs(one - other) <= _TOLERANCE * (1 + np.abs(other)))[good].all())
