"""Numbers that a mistake would give, the likely ones first; and how many of them may be tried before one fits by chance."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from decimal import Decimal
from itertools import pairwise
from math import floor, isfinite, log10

from armproof.models.errors import written
from armproof.models.language import look_up, noted

_MOST_BY_CHANCE = 0.03  # of all numbers up to twice the right one, those that are explained
_LEAST = 3  # guesses that are tried whatever the number: they come first, and are the usual mistakes
_FINEST = -4  # the power of ten beside a number beyond which digits tell no more
_MOST_DECIMALS = 6
_SHORTENED = 0.02  # of a number, that is lost with its last digits
_MOST_CUT = 0.1  # that is lost at most
_SHORT = 4
_MANY = 3  # digits, of a number that may have been cut off
_ROUNDED = 0.01  # by how much a number changes at most when it is rounded
_SMALL = 1e-9
_EXCHANGED, _LOST = noted("two neighbouring digits are exchanged"), noted("one digit is missing")
_ROUNDED_OFF, _CUT_OFF = noted("rounded to too few digits"), noted("cut off where it is to be rounded")
_TWICE, _ONE_WRONG = noted("one digit is written twice"), noted("all digits but one are right")
_ALONE, _THIS, _PERHAPS = noted("this is {name} alone"), noted("this is {other}"), noted("is this {other}?")


@dataclass(frozen=True)
class Guess:
    """A number that a mistake would give, and what is said of it."""

    value: float
    words: Callable[[], str]
    is_exact: bool = False  # in all digits, not only as far as they go


def alone(name: str) -> str:
    """Return that a number is one part, where more belongs."""
    return written(_ALONE, name=name)


def instead(other: str) -> str:
    """Return that a number is something else."""
    return written(_THIS, other=other)


def perhaps(other: str) -> str:
    """Ask whether a number is something else, of which it may have the value by chance."""
    return written(_PERHAPS, other=other)


def explained(given: float, right: float, guesses: Iterable[Guess], share: float = _MOST_BY_CHANCE) -> str:
    """Return what is said of the first guess that a number is, to its digits; empty where none is.

    A number of few digits meets one of many guesses by chance. So no more are tried than would explain this share of all
    numbers with as many digits, two at least, up to twice the right one: three of a hundred.
    """
    if not isfinite(given):
        return ""
    step, largest = min(_unit(given, right), _unit(given, given)), 2 * max(abs(right), abs(given))
    tried: set[int] = set()
    for guess in guesses:
        if not _SMALL < abs(guess.value) <= largest or abs(guess.value - right) <= step / 2:
            continue  # who makes this mistake has the right number all the same
        if (is_exact := guess.is_exact or is_short(guess.value)) and not _has_digits(guess.value, step):
            continue
        tried |= _explains(guess.value / step, is_exact or digits_of(given) < _MANY)
        if len(tried) > max(_LEAST, share * 2 * largest / step):
            return ""
        if nearly(given, guess.value, is_exact):
            return guess.words()
    return ""


def _explains(units: float, is_rounded: bool) -> set[int]:
    """Return which numbers a value explains, in units of the last digit: it rounded, and cut off."""
    return {round(units)} if is_rounded else {round(units), int(units)}


def nearly(given: float, value: float, is_exact: bool = False) -> bool:
    """Whether a number is a value, to the digits that it has: rounded, or cut off behind three of them."""
    if not isfinite(given):
        return False
    unit = _unit(given, given)
    is_cut = digits_of(given) >= _MANY and 0 <= (value - given) * (1 if given > 0 else -1) < unit
    return abs(value - given) <= (0 if is_exact else min(unit / 2, _ROUNDED * abs(given))) + _SMALL or (
        is_cut and not is_exact
    )


def _unit(given: float, beside: float) -> float:
    """Return the unit of a number's last digit; of two digits, at least, of a number beside it that is not zero."""
    digits = log10(abs(beside or given) or 1)
    coarsest: float = 10.0 ** (floor(digits) - 1)
    finest: float = 10.0 ** floor(digits + _FINEST)
    return max(min(10.0 ** -_decimals(given), coarsest), finest)


def is_short(value: float) -> bool:
    """Whether a number ends after few decimals, so that nobody rounds it."""
    return abs(round(value, _SHORT) - value) < _SMALL


def _has_digits(value: float, step: float) -> bool:
    """Whether a number ends with the digit of this unit or before."""
    return abs(round(value / step) * step - value) < _SMALL


def _decimals(number: float) -> int:
    """Return how many digits stand behind the point; less than none where a whole number ends on zeros."""
    exponent = Decimal(f"{number:.10g}").normalize().as_tuple().exponent
    return -exponent if isinstance(exponent, int) else 0


def shortened(given: float, right: float) -> Iterator[Guess]:
    """Yield the right number rounded to the digits that are given, too few of them, and cut off behind them."""
    scale = 10.0 ** _decimals(given)
    rounded, cut = round(right * scale) / scale, int(right * scale) / scale
    for number, words, most in ((rounded, _ROUNDED_OFF, _SHORTENED), (cut, _CUT_OFF, _MOST_CUT)):
        if abs(number - right) < most * abs(right):
            yield Guess(number, lambda words=words: look_up(words), is_exact=True)  # type: ignore[misc]


def digits_exchanged(given: float, right: float) -> Iterator[Guess]:
    """Yield the right number with two neighbouring digits exchanged."""
    sign, text = _written(given, right)
    for changed in neighbours_exchanged(text):
        if changed.replace(".", "").strip("0") != text.replace(".", "").strip("0"):  # else its point has moved
            yield Guess(float(sign + changed), lambda: look_up(_EXCHANGED), is_exact=True)


def digits_astray(given: float, right: float) -> Iterator[Guess]:
    """Yield the right number with a digit lost, one written twice, one wrong."""
    sign, text = _written(given, right)
    places = [k for k, character in enumerate(text) if character != "." and text[: k + 1].strip("0.")]
    for k in places[1:]:
        yield Guess(float(sign + text[:k] + text[k + 1 :]), lambda: look_up(_LOST), is_exact=True)
    for k in places if len(places) > 1 else ():
        yield Guess(float(sign + text[:k] + text[k] + text[k:]), lambda: look_up(_TWICE), is_exact=True)
    for k in places if max(map(digits_of, (given, right))) > 2 else ():
        for digit in "0123456789":
            yield Guess(float(sign + text[:k] + digit + text[k + 1 :]), lambda: look_up(_ONE_WRONG), is_exact=True)


def digits_of(number: float) -> int:
    """Return how many digits a number has, without zeros at its ends."""
    return len(f"{abs(number):.6g}".replace(".", "").strip("0"))


def _written(given: float, right: float) -> tuple[str, str]:
    """Return the sign and the digits of the right number; of one that has many, as many as are given."""
    own = _decimals(right)
    shown = max(own, _decimals(given)) if own <= _MOST_DECIMALS else _decimals(given)
    return "-" if right < 0 else "", f"{abs(right):.{min(max(shown, 0), _MOST_DECIMALS)}f}"


def neighbours_exchanged(text: str) -> Iterator[str]:
    """Yield a number's text with two neighbouring digits exchanged, the point left where it is: 1.964 for 1.946."""
    places = [k for k, character in enumerate(text) if character.isdigit()]
    for one, other in pairwise(places):
        if text[one] != text[other]:
            yield text[:one] + text[other] + text[one + 1 : other] + text[one] + text[other + 1 :]
