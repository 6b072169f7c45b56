"""The mistake behind wrong numbers: their signs, order, unit, a factor, a given value that is missing or stands alone."""

from __future__ import annotations

import operator
import re
from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from functools import partial
from itertools import combinations, permutations

import numpy as np

from armproof.models.errors import counted, written
from armproof.models.language import look_up, noted, separator

_TOLERANCE = 1e-6
_LARGEST_FACTOR = 10
_LARGEST_PART = 5  # above and below the line of a share
_MOST_ASTRAY = 2  # things too many or too few: a larger number would be the answer itself
_POWERS_OF_TEN = (100, 1000)
_NEAR = 2e-3  # of numbers that were rounded, where the mistake is sought
_SMALL = 0.1  # rad: below it an angle and its tangent are nearly one
_DIGITS = 1e-4  # of a sum or a quotient of given values, which many could meet by chance
_FUNCTIONS = {"sin": noted("sine"), "cos": noted("cosine"), "tan": noted("tangent")}
_NOT_ZERO = {
    "m": noted("it is not zero: something reaches that way"),
    "m/s": noted("it is not zero: something moves that way"),
    "rad": noted("it is not zero: something has turned"),
    "rad/s": noted("it is not zero: something turns"),
    "–": noted("it is not zero"),
}
_SIGN = r"[A-Za-z](?:_\{?\w+\}?)?"
_GIVEN = re.compile(rf"(?<![\w\\])(?<!dot )({_SIGN}(?: [-+] {_SIGN})*) = (\d+(?:\.\d+)?)(?![\w.^]|\s*\\?°)")

_NUMBER = re.compile(r"(?<![\w.\\^{}_])\d+(?:\.\d+)?(?![\w.°^}]|\s*\\?°)")
_MOST_STATED = 6
_CLOSE = ((0.01, noted("a hundredth")), (0.1, noted("a tenth: a slip in the reckoning?")))
_OF_ANGLES = ("rad", "rad/s")
_TWO = {"+": operator.add, "·": operator.mul, "/": operator.truediv, "-": operator.sub}

near = partial(np.allclose, rtol=_NEAR, atol=_TOLERANCE)


def values_in(text: str) -> dict[str, float]:
    """Return the values that a task's text gives to letters: {"a_1": 0.4} of "$a_1 = 0.4$ m"; not angles in degrees."""
    return {name: float(value) for name, value in _GIVEN.findall(text)}


def numbers_in_text(text: str) -> tuple[float, ...]:
    """Return the numbers that a task's text gives, each once: not zero, no indices, exponents or degrees; none where there are many."""
    found = dict.fromkeys(float(number) for number in _NUMBER.findall(text))
    return tuple(number for number in found if number) if len(found) <= _MOST_STATED else ()


def number_slip(
    given: np.ndarray,
    right: np.ndarray,
    labels: Sequence[str],
    known: Mapping[str, float],
    unit: str = "–",
    stated: Sequence[float] = (),
) -> str:
    """Return the usual mistake behind wrong numbers, of all of them or of each; empty where none is recognised.

    Args:
        labels: what each number is.
        known: given values, which may be missing in a number, or stand for it.
        stated: numbers that the task's text gives.
        unit: of the numbers; without one, whole numbers are numbers of things, of which none is "not zero".
    """
    is_count = unit == "–"
    if whole := next(_whole(given, right, unit), ""):
        return whole
    wrong = np.flatnonzero(wrong_numbers(given, right)).tolist()
    told = [
        (
            labels[k],
            _of_function(labels[k], number, float(right[k]))
            or _of_one(number, float(right[k]), known, len(right), unit)
            or _of_another(number, float(right[k]), right, labels)
            or _of_stated(number, stated, unit)
            or _of_two_others(number, right, labels)
            or _of_a_function(number, float(right[k]), unit)
            or _of_a_count(number, right, k, is_count)
            or _of_reach(number, known, unit)
            or _of_factor(number, float(right[k]))
            or _of_share(number, float(right[k]))
            or _by_size(number, float(right[k]), len(wrong) == 1 < right.size),
        )
        for k in wrong
        for number in [float(given[k])]
    ]
    if right.size == 1:
        return "".join(words for _, words in told)
    of: dict[str, list[str]] = {}
    for label, words in told:
        of.setdefault(words, []).append(label)
    return look_up("; ").join(
        written("{label}: {words}", label=separator(labels).join(labels), words=words) for words, labels in of.items() if words
    )  # fmt: skip


def _whole(given: np.ndarray, right: np.ndarray, unit: str) -> Iterator[str]:
    """Yield what explains all wrong numbers at once."""
    wrong = wrong_numbers(given, right)
    if all(map(_is_rounded, given.tolist(), right.tolist())):
        yield look_up("right, but rounded: hand over the expression itself, such as `np.pi / 2`, or seven digits")
        return
    if near(given, right):  # of more digits than the right one has
        return
    if near(np.abs(given), np.abs(right)):
        yield look_up("the sign is wrong")
    if near(np.sort(given), np.sort(right)):
        yield look_up("the numbers are right, their order is not")
    if near(np.sort(np.abs(given)), np.sort(np.abs(right))):
        yield look_up("the numbers are right, their order and signs are not")
    if (
        right.size > 1
        and not (right.size == 3 and near(np.linalg.norm(right), 1))  # a direction
        and (kinds := sorted(set(right.tolist()))) in ([0, 1], [-1, 1])
        and not set(given.tolist()) <= {*kinds}
        and near(given, np.round(given))
    ):
        yield written("each of them is {one:g} or {other:g}", one=kinds[1], other=kinds[0])
    if unit not in _OF_ANGLES and near(given, 1000 * right):
        yield look_up("in millimetres? Metres are asked for")
    if unit not in _OF_ANGLES and near(given, 100 * right) and not near(right, np.round(right)):
        yield look_up("in centimetres? Metres are asked for")
    if unit in ("–", *_OF_ANGLES) and near(given, np.degrees(right)) and not near(right, np.round(right)):
        yield look_up("in degrees? Radians are asked for")
    if unit in _OF_ANGLES and near(given, np.radians(right)):
        yield look_up("π / 180 is too much: the value itself is in radians")
    if (
        unit in ("–", *_OF_ANGLES)
        and near(np.abs(given), np.degrees(np.abs(right)))
        and not near(right, np.round(right))
    ):
        yield look_up("in degrees, where radians are asked for, and a sign is wrong")
    if factor := _common_factor(given[wrong], right[wrong]):
        yield written("wrong by a factor of {factor}", factor=factor)
    if factor := _common_factor(-given[wrong], right[wrong]):
        yield written("wrong by a factor of {factor}, and in sign", factor=factor)
    if right.size == 3 and near(np.linalg.norm(right), 1) and near(right, np.round(right)):
        if near(given @ right, 0) and near(np.linalg.norm(given), 1):
            yield look_up("the length is right, the direction is not: yours is at right angles to it")
        if not near(np.linalg.norm(given), 1):
            yield look_up("a direction has the length 1, yours has not")
        return
    if unit == "–" and near(right, np.round(right)) and near(np.abs(given - right)[wrong], 1):
        if (given < right)[wrong].all():
            yield counted("one too few", "{number} too few", 1)
        if (given > right)[wrong].all():
            yield counted("one too many", "{number} too many", 1)


def wrong_numbers(given: np.ndarray, right: np.ndarray) -> np.ndarray:
    """Return which numbers are wrong, and not only rounded; where none is, those that differ at all."""
    far = ~np.isclose(given, right, rtol=_NEAR, atol=_TOLERANCE)
    far &= ~np.array([_is_rounded(one, other) for one, other in zip(given.tolist(), right.tolist(), strict=True)])
    return far if far.any() else ~np.isclose(given, right, rtol=_TOLERANCE)


def _is_rounded(given: float, right: float) -> bool:
    """Whether a number is the right one to the decimals that it has, two digits at least; or nearly one that has many digits."""
    decimals = repr(given).partition(".")[2]
    is_plain = decimals.isdigit() and abs(given) >= 10 ** (1 - len(decimals)) and decimals != "0"
    if given == right or (is_plain and round(right, len(decimals)) == given):
        return True
    has_many = float(f"{right:.4g}") != right or float(f"{given:.4g}") != given
    return bool(has_many and near(given, right) and np.isclose(given, right, rtol=_NEAR / 2))


def _common_factor(given: np.ndarray, right: np.ndarray) -> int:
    """Return the whole number by which all numbers are too large, or too small; 0 where there is none."""
    if (right == 0).any() or np.abs(given / right).min() <= _TOLERANCE or not near(given / right, given[0] / right[0]):
        return 0
    ratio = float(given[0] / right[0])
    if ratio < 0:
        return 0
    factor = max(ratio, 1 / ratio)
    return (
        round(factor)
        if near(factor, round(factor)) and (1 < round(factor) <= _LARGEST_FACTOR or round(factor) in _POWERS_OF_TEN)
        else 0
    )


def _of_share(given: float, right: float) -> str:
    """Return which fraction of small numbers a number is of the right one, where that is no whole number."""
    if near(right, round(right)) or not right:
        return ""
    share = Fraction(given / right).limit_denominator(_LARGEST_PART)
    if not (1 < share.numerator <= _LARGEST_PART and share.denominator > 1 and near(given, float(share) * right)):
        return ""
    return written("this is {share} of what is asked", share=share)


def _of_function(label: str, given: float, right: float) -> str:
    """Return that a number is the angle, where its sine, cosine or tangent is asked."""
    for name, words in _FUNCTIONS.items():
        function = getattr(np, name)
        if label.startswith(name) and (near(function(given), right) or near(function(np.radians(given)), right)):
            return written("this is the angle: its {function} is asked", function=look_up(words))
    return ""


def _of_one(given: float, right: float, known: Mapping[str, float], count: int, unit: str) -> str:
    """Return the mistake in one number; a count has none beside its value."""
    is_count = unit == "–"
    if is_count and float(right).is_integer() and right and float(given).is_integer():
        return ""
    if right == 0:
        return look_up("zero belongs there") if count > 1 and not (is_count and float(given).is_integer()) else ""
    if given == 0:
        return look_up(_NOT_ZERO.get(unit, _NOT_ZERO["–"]))
    if near(given, -right):
        return look_up("the sign is wrong")
    if unit in _OF_ANGLES and np.isclose(given, np.degrees(right), rtol=_NEAR):
        return look_up("in degrees? Radians are asked for")
    if words := _of_parts(given, right, known) or _of_parts(given, right, _pairs(known)) or _of_sum(given, known):
        return words
    if near(given * right, 1) and not near(abs(right), 1):
        return look_up("numerator and denominator are exchanged")
    return ""


def _of_a_function(given: float, right: float, unit: str) -> str:
    """Return that a number is the square, the root, the sine, the cosine or the tangent of the right one."""
    if unit == "rad":
        for name, words in _FUNCTIONS.items():
            if near(given, getattr(np, name)(right)) and abs(right) > _SMALL:
                return written(
                    "this is the {function} of the angle: the angle itself is asked", function=look_up(words)
                )
    if near(abs(right), 1) or near(abs(given), 1):
        return ""
    if near(given, right**2):
        return look_up("this is the square of what is asked")
    return look_up("this is the root: its square is asked") if right > 0 and near(given, np.sqrt(right)) else ""


def _of_a_count(given: float, right: np.ndarray, k: int, is_count: bool) -> str:
    """Return how many too many or too few a count says, or that it is none."""
    if not is_count or not all(map(float.is_integer, right.tolist())) or not right.max() > 1 or right[k] < 0:
        return ""
    if not float(given).is_integer():
        return look_up("a whole number is asked")
    if given < 0:
        return look_up("a number of things is not negative")
    more = int(given - right[k])
    if abs(more) > _MOST_ASTRAY:
        return ""
    return counted("one too many", "{number} too many", more) if more > 0 else counted("one too few", "{number} too few", -more)  # fmt: skip


def _of_reach(given: float, known: Mapping[str, float], unit: str) -> str:
    """Return that no sum of all given lengths is so long."""
    longest = sum(map(abs, known.values()))
    if unit != "m" or not 0 < longest < abs(given):
        return ""
    return written(
        "even {names} is only {longest:g}: the arm does not reach that far", names=" + ".join(known), longest=longest
    )


def _of_another(given: float, own: float, right: np.ndarray, labels: Sequence[str]) -> str:
    """Return of which other label a number would be right, where it is no count."""
    for power, words in ((1, noted("this is {other}")), (2, noted("this is the square of {other}"))):
        others = [
            label
            for label, value in zip(labels, right.tolist(), strict=True)
            if near(given, value**power) and not near(value, own)
        ]
        if len(others) == 1 and not float(given).is_integer():
            return written(look_up(words), other=others[0])
    return ""


def _of_two_others(given: float, right: np.ndarray, labels: Sequence[str]) -> str:
    """Return of which two labels a number would be the sum or the difference."""
    known = {label: value for label, value in zip(labels, right.tolist(), strict=True) if value}
    if len(known) > 2:
        for (one, a), (other, b) in combinations(known.items(), 2):
            for sign, joint, value in (("", "+", a + b), ("", "−", a - b), ("−", "+", b - a), ("−", "−", -a - b)):
                if given and near(given, value):
                    return written("this is {other}", other=f"{sign}{one} {joint} {other}")
    return ""


def _of_stated(given: float, stated: Sequence[float], unit: str) -> str:
    """Return which number of the text was copied, or which two were put together."""
    close = partial(np.isclose, given, rtol=_DIGITS, atol=_TOLERANCE)
    if float(given).is_integer() or unit == "rad":  # what is given is in metres, and makes no angle
        return ""
    for value in stated:
        if close(value):
            return written("{value:g} is given for something else", value=value)
    signs = "+-" if unit == "m" and len(stated) > 2 else _TWO
    pairs = [(sign, *pair) for sign in signs for pair in permutations(stated, 2)]
    for sign, one, other in [*pairs, *(("·", each, each) for each in stated if "·" in signs)]:
        if close(_TWO[sign](one, other)):
            return written("this is {one:g} {sign} {other:g}", one=one, sign=sign, other=other)
    for one, other in combinations(stated, 2):
        if close(np.hypot(one, other)):
            return written("this is the root of {one:g}² + {other:g}²", one=one, other=other)
    for one, other, third in combinations(stated, 3):
        if close(np.sqrt(one**2 + other**2 + third**2)):
            return written("this is the root of {one:g}² + {other:g}² + {third:g}²", one=one, other=other, third=third)
    return ""


def _of_factor(given: float, right: float) -> str:
    """Return by which whole factor a number is too large or too small."""
    factor = _common_factor(np.array([given]), np.array([right])) if given and right else 0
    return written("wrong by a factor of {factor}", factor=factor) if factor else ""


def _by_size(given: float, right: float, is_only: bool) -> str:
    """Return how large a number is beside the right one, and that the others are right, where nothing else is known of it."""
    if not right:
        return look_up("zero belongs there")
    if given * right < 0:
        return look_up("the sign and the size are wrong")
    size = look_up("zero would mean that there is none") if not given else _size(given / right)
    return written("{size}; all else is right", size=size) if is_only else size


def _size(ratio: float) -> str:
    """Return how large a number is in words that leave the rest to the student."""
    if close := next((words for most, words in _CLOSE if abs(ratio - 1) < most), ""):
        size = noted("too large by less than {share}") if ratio > 1 else noted("too small by less than {share}")
        return written(size, share=look_up(close))
    if ratio > 1:
        return look_up("much too large: more than double") if ratio > 2 else look_up("too large, but less than double")
    return look_up("much too small: less than half") if ratio < 1 / 2 else look_up("too small, but more than half")


def _of_parts(given: float, right: float, parts: Mapping[str, float]) -> str:
    """Return which part a number is, or has too much or too little."""
    close = partial(np.isclose, rtol=_DIGITS, atol=_TOLERANCE)
    for name, value in parts.items():
        if close(given, value):
            return written("this is {name} alone", name=name)
    for name, value in parts.items():
        if close(given + value, right):
            return written("{name} is missing", name=name)
        if close(given - value, right):
            return written("{name} does not belong in it", name=name)
    return ""


def _of_sum(given: float, known: Mapping[str, float]) -> str:
    """Return of which three or four given values a number is the sum."""
    for count in (3, 4):
        for names in combinations(known, count):
            if count < len(known) and np.isclose(
                given, sum(known[name] for name in names), rtol=_DIGITS, atol=_TOLERANCE
            ):
                return written("this is {other}", other=" + ".join(names))
    return ""


def _pairs(known: Mapping[str, float]) -> dict[str, float]:
    """Return the sums and differences of two given values, and their doubles."""
    pairs = list(combinations(known, 2))
    sums = {f"{one} + {other}": known[one] + known[other] for one, other in pairs}
    differences = {f"{one} - {other}": known[one] - known[other] for one, other in pairs}
    return {**sums, **differences, **{f"2 {name}": 2 * value for name, value in known.items()}}
