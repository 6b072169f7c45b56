"""The mistake behind wrong numbers: their signs, order, unit, a factor, a given value that is missing or stands alone."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import partial
from itertools import combinations

import numpy as np

from armproof.course.feedback.guesses import Guess, explained, instead, is_short, nearly
from armproof.course.feedback.number_guesses import ELSEWHERE, HALF, OF_ANGLES, TWICE, Asked
from armproof.course.feedback.steps import NO_STEPS, Beside, Steps
from armproof.course.feedback.worked import IN_RADIANS, LETTER, Worked
from armproof.models.errors import counted, written
from armproof.models.language import look_up, noted, number_text, separator
from armproof.verification.latex.greek import NAMES
from armproof.verification.latex.plain import plain_text
from armproof.verification.latex.writer import symbol_as_latex

_TOLERANCE = 1e-6
_LARGEST_FACTOR = 10
_LARGEST_PART = 5  # above and below the line of a share
_MOST_TRUE = 0.1  # of all numbers, those that are told a sum that they are: true where it is chance, too
_ROUND = np.radians(np.arange(-180.0, 180.0, 5.0))
_FOR = noted("this is for {values}")
_ALL = 1.0  # of them, where all that is told was written down by a task's author
_MOST_ASTRAY = 2  # things too many or too few: a larger number would be the answer itself
_POWERS_OF_TEN = (100, 1000)
_TENS = (_LARGEST_FACTOR, *_POWERS_OF_TEN)
_OF_LENGTHS = {
    100: noted("wrong by a factor of 100: is a length in centimetres?"),
    1000: noted("wrong by a factor of 1000: is a length in millimetres?"),
}
_LONE_FACTORS = (2, 3, 4, *_TENS)  # of one number: seven comes by chance
_NEAR = 2e-3  # of numbers that were rounded, where the mistake is sought
_NEAR_SHORT = 1e-4  # of one that has many digits, where the right one has few
_LENGTHS = ("m", "m/s")
_SMALL_ANGLE = 0.1  # rad, of which a length may have the number of degrees
_USUAL_ANGLE = 5  # degrees: of a direction that is taken for another
_NEAR_ANGLE = 0.06  # of it
_NEAR_LENGTH = 0.004  # of coordinates that were rounded to three digits
_ABOUT = 0.04  # of a double or a half that was rounded
_NOT_ZERO = {
    "m": noted("it is not zero: something reaches that way"),
    "m/s": noted("it is not zero: something moves that way"),
    "rad": noted("it is not zero: something has turned"),
    "rad/s": noted("it is not zero: something turns"),
    "–": noted("it is not zero"),
}
_SIGN = r"[A-Za-z](?:_\{?\w+\}?)?"
_GIVEN = re.compile(rf"(?<![\w\\])(?<!dot )({_SIGN}(?: [-+] {_SIGN})*) = (\d+(?:\.\d+)?)(?![\w.^]|\s*\\?°)")
_NUMBER = re.compile(r"(?<![\w.\\^{}_])(?:(?<=[\[, ])-)?\d+(?:\.\d+)?(?![\w.°^}]|\s*\\?°)")
_COUNTED = re.compile(
    r"(?:ax[ie]s|axe|joint|articulation|frame|repère|row|ligne|column|colonne|link|corps|document)\s*$", re.I
)
_CLOSE = ((0.01, noted("a hundredth")), (0.1, noted("a tenth: a slip in the reckoning?")))

near = partial(np.allclose, rtol=_NEAR, atol=_TOLERANCE)


def values_in(text: str) -> dict[str, float]:
    """Return the values that a task's text gives to letters: {"a_1": 0.4} of "$a_1 = 0.4$ m"; not angles in degrees."""
    return {name: float(value) for name, value in _GIVEN.findall(text)}


def numbers_in_text(text: str) -> tuple[float, ...]:
    """Return the numbers that a task's text gives, each once, with its sign: not zero, no indices, exponents or degrees."""
    found = dict.fromkeys(
        float(number[0]) for number in _NUMBER.finditer(text) if not _COUNTED.search(text[: number.start()])
    )
    return tuple(number for number in found if number)


def number_slip(
    given: np.ndarray,
    right: np.ndarray,
    labels: Sequence[str],
    known: Mapping[str, float],
    unit: str = "–",
    stated: Sequence[float] = (),
    way: Steps = NO_STEPS,
    beside: Sequence[str] = (),
) -> str:
    """Return the usual mistake behind wrong numbers, of all of them or of each; empty where none is recognised.

    Args:
        labels: what each number is.
        known: given values, which may be missing in a number, or stand for it.
        stated: numbers that the task's text gives.
        unit: of the numbers; without one, whole numbers are numbers of things, of which none is "not zero".
        way: how the numbers follow from what is given.
        beside: what is given instead of them, as in `Beside`.
    """
    values = dict(zip(labels, right.tolist(), strict=True))
    wrong = np.flatnonzero(wrong_numbers(given, right)).tolist()
    others = [_without(label, values) for label in labels]
    letters = {**known, **way.angles}
    worked = worked_out(right, labels, known, stated, way)
    near_by = Beside(tuple(beside), {**letters, **letters_of(values)})
    own = dict(zip(labels, given.tolist(), strict=True))
    of_angles = [Guess(float(np.degrees(angle)), partial(instead, f"{plain_text(symbol_as_latex(name))} = {np.degrees(angle):g}°"))
                 for name, angle in way.angles.items() if abs(angle) > _SMALL_ANGLE] if unit in ("m", "m/s") else []  # fmt: skip
    is_whole = not any(each.has_powers for each in worked.values())
    sizes = _size_of_all(right, labels, unit)
    asked = {
        k: Asked(float(right[k]), labels[k], unit, others[k], known, tuple(stated), worked.get(k), (*near_by.of_one(k, given, wrong), *of_angles, *sizes), near_by.formulas, is_whole)
        for k in wrong
    }  # fmt: skip
    if whole := (
        near_by.of_all(given, (1.0, -1.0))
        or _in_one_place(given, right, labels)
        or near_by.of_all(given)
        or next(_whole(given, right, unit, bool(worked)), "")
        or _of_another_value(given, right, worked, way.angles)
        or ("" if any(_carried(asked[k], own[labels[k]], own) for k in wrong) else _reordered(given, right, labels))
        or _reordered_with_signs(given, right, asked)
        or _of_any_angle(given, right, worked, way.angles)
        or _turned(given, right, labels)
        or _exchanged({k: float(given[k]) for k in wrong}, worked)
        or (look_up("rounded to too few digits") if _are_all_rounded(given, right) else "")
    ):
        return whole
    of: dict[str, list[str]] = {}
    is_astray = _is_no_direction(given, right) and not all(explained(float(given[k]), float(right[k]), each.beside, _ALL) for k, each in asked.items())  # fmt: skip
    if is_astray:
        return look_up("a direction has the length 1, yours has not")
    for k in wrong:
        words = _of_one(asked[k], float(given[k]), own, len(wrong) == 1)
        of.setdefault(words, []).append(labels[k])
    if len(wrong) == 1:
        return "".join(of)
    return look_up("; ").join(
        written("{label}: {words}", label=separator(labels).join(labels), words=words) for words, labels in of.items() if words
    )  # fmt: skip


def worked_out(
    right: np.ndarray, labels: Sequence[str], known: Mapping[str, float], stated: Sequence[float], way: Steps
) -> dict[int, Worked]:
    """Return how each number follows from what is given and from the others, by its place; nothing of what is not reckoned."""
    values = dict(zip(labels, right.tolist(), strict=True))
    letters, angles = {**known, **way.angles}, frozenset(way.angles)
    return {
        k: Worked(latex, {**letters, **letters_of(_without(labels[k], values))}, tuple(stated), angles)
        for k, latex in enumerate(way.ways)
        if latex
    }


def _without(label: str, values: Mapping[str, float]) -> dict[str, float]:
    return {name: value for name, value in values.items() if name != label}


def _of_another_value(
    given: np.ndarray, right: np.ndarray, worked: Mapping[int, Worked], angles: Mapping[str, float]
) -> str:
    """Return which other value of a letter makes all the numbers what they are: another angle, a factor that is left out."""
    known = {name: value for each in worked.values() for name, value in each.known.items()}
    factors = set() if all(each.is_short for each in worked.values()) else {*known} - {*angles}
    tried: list[tuple[dict[str, float], Callable[[], str]]]
    tried = [({name: value}, _for_value(name, value, name in angles))
             for name in sorted({name for each in worked.values() for name in each.letters} & {*angles, *factors})
             for value in (_other_angles(known[name]) if name in angles else (1.0,))]  # fmt: skip
    if len(angles) > 1:
        forgotten = ", ".join(f"{plain_text(symbol_as_latex(name))} = 0°" for name in angles)
        tried.append((dict.fromkeys(angles, 0.0), partial(written, _FOR, values=forgotten)))
    in_radians = {name: float(np.degrees(value)) for name, value in angles.items()}
    taken = [*({name: value} for name, value in in_radians.items()), in_radians]
    tried += [(values, partial(look_up, IN_RADIANS)) for values in taken]
    for values, words in tried:
        made = right.copy()
        for k, each in worked.items():
            made[k] = each.with_values(values)
        if not near(made, right) and np.isfinite(made).all() and all(map(nearly, given.tolist(), made.tolist())):
            return words()
    return ""


def _of_any_angle(
    given: np.ndarray, right: np.ndarray, worked: Mapping[int, Worked], angles: Mapping[str, float]
) -> str:
    """Return at which angle, a multiple of five degrees, several numbers are what they are, to three digits."""
    for name in angles if np.count_nonzero(wrong_numbers(given, right)) > 1 else ():
        made = np.tile(right, (len(_ROUND), 1))
        for k, each in worked.items():
            made[:, k] = each.over(name, _ROUND)
        found = _ROUND[np.isclose(given, made, rtol=_NEAR, atol=_TOLERANCE).all(axis=1)]
        if found.size:
            return _for_value(name, float(found[0]), True)()
    return ""


def _for_value(name: str, value: float, is_angle: bool) -> Callable[[], str]:
    shown = f"{180 - (180 - np.degrees(value)) % 360:.4g}°" if is_angle else number_text(value, "g")
    return partial(written, _FOR, values=f"{plain_text(symbol_as_latex(name))} = {shown}")


def _other_angles(angle: float) -> tuple[float, ...]:
    turns = (angle + sign * turn for turn in (np.pi / 2, np.pi) for sign in (1, -1))
    return (0.0, -angle, *turns, 2 * angle, angle / 2)


def _exchanged(given: Mapping[int, float], worked: Mapping[int, Worked]) -> str:
    """Return which two given values stand in each other's place, where that makes several wrong numbers what they are."""
    if len(given) < 2 or not given.keys() <= worked.keys():
        return ""
    for one, other in combinations(sorted({name for k in given for name in worked[k].taken}), 2):
        if all(near(worked[k].exchanged(one, other), number) for k, number in given.items()):
            return written("{one} and {other} are exchanged", one=_shown(one), other=_shown(other))
    return ""


def _shown(name: str) -> str:
    return number_text(float(name), "g") if name[0].isdigit() else name


def letters_of(values: Mapping[str, float]) -> dict[str, float]:
    """Return the values of which the label is a letter, by that letter: {"theta_1": 0.4} of "θ_1"."""
    spelt = {"".join(NAMES.get(character, character) for character in label): value for label, value in values.items()}
    return {name: value for name, value in spelt.items() if LETTER.fullmatch(name)}


def _whole(given: np.ndarray, right: np.ndarray, unit: str, is_reckoned: bool) -> Iterator[str]:
    """Yield what explains all wrong numbers at once."""
    wrong = wrong_numbers(given, right)
    if all(map(_is_rounded, given.tolist(), right.tolist())):
        yield look_up("right, but rounded: hand over the expression itself, such as `np.pi / 2`, or seven digits")
        return
    if near(given, right):  # of more digits than the right one has
        return
    if near(np.abs(given), np.abs(right)):
        yield look_up("the sign is wrong")
    for factor, words in _OF_LENGTHS.items() if unit == "rad/s" and is_reckoned else ():
        if near(given * factor, right) or near(given, right * factor):
            yield look_up(words)
    if (
        right.size > 1
        and not (right.size == 3 and near(np.linalg.norm(right), 1))  # a direction
        and (kinds := sorted(set(right.tolist()))) in ([0, 1], [-1, 1])
        and not set(given.tolist()) <= {*kinds}
    ):
        yield written("each of them is {one:g} or {other:g}", one=kinds[1], other=kinds[0])
    is_long = unit in _LENGTHS
    if (unit not in OF_ANGLES and near(given, 1000 * right)) or (is_long and near(given[wrong], 1000 * right[wrong])):
        yield look_up("in millimetres? Metres are asked for")
    is_fraction = unit not in OF_ANGLES and not near(right, np.round(right))  # 200 may be counted
    if (is_long and near(given[wrong], 100 * right[wrong])) or (is_fraction and near(given, 100 * right)):
        yield look_up("in centimetres? Metres are asked for")
    if unit in ("–", *OF_ANGLES) and near(given, np.degrees(right)) and not near(right, np.round(right)):
        yield look_up("in degrees? Radians are asked for")
    if unit in OF_ANGLES and near(given, np.radians(right)):
        yield look_up("π / 180 is too much: the value itself is in radians")
    if (
        unit in ("–", *OF_ANGLES)
        and near(np.abs(given), np.degrees(np.abs(right)))
        and not near(right, np.round(right))
    ):
        yield look_up("in degrees, where radians are asked for, and a sign is wrong")
    yield from _by_factor(given[wrong], right[wrong], _TENS if np.count_nonzero(wrong) == 1 else ())
    if _is_along_an_axis(right):
        if near(given @ right, 0) and near(np.linalg.norm(given), 1):
            yield look_up("the length is right, the direction is not: yours is at right angles to it")
        return
    is_of_counts = unit == "–" and right.min() >= 0 and near(right, np.round(right))
    if is_of_counts and np.count_nonzero(wrong) > 1 and near(np.abs(given - right)[wrong], 1):
        if (given < right)[wrong].all():
            yield counted("one too few", "{number} too few", 1)
        if (given > right)[wrong].all():
            yield counted("one too many", "{number} too many", 1)


def _is_no_direction(given: np.ndarray, right: np.ndarray) -> bool:
    """Whether a direction along an axis is asked, and no direction is given."""
    return _is_along_an_axis(right) and not near(np.linalg.norm(given), 1)


def _is_along_an_axis(right: np.ndarray) -> bool:
    return bool(right.size == 3 and near(np.linalg.norm(right), 1) and near(right, np.round(right)))


def _reordered(given: np.ndarray, right: np.ndarray, labels: Sequence[str]) -> str:
    """Return which two numbers are exchanged, or that they are in another order."""
    off = np.flatnonzero(~np.isclose(given, right, rtol=_NEAR, atol=_TOLERANCE)).tolist()
    if not off:
        return ""
    if len(off) == 2 and near(given[off], right[off[::-1]]):
        one, other = (labels[k] for k in off)
        return written("{one} and {other} are exchanged", one=one, other=other)
    if near(np.sort(given), np.sort(right)):
        return look_up("the numbers are right, their order is not")
    return ""


def _reordered_with_signs(given: np.ndarray, right: np.ndarray, asked: Mapping[int, Asked]) -> str:
    """Return that numbers are in another order and have other signs, where that is not what slips of each make of them."""
    if given.size < 2 or not near(np.sort(np.abs(given)), np.sort(np.abs(right))):
        return ""
    has_slips = all(each.worked and explained(float(given[k]), each.right, each.guesses(float(given[k]))) for k, each in asked.items())  # fmt: skip
    return "" if has_slips else look_up("the numbers are right, their order and signs are not")


def _turned(given: np.ndarray, right: np.ndarray, labels: Sequence[str]) -> str:
    """Return by how much coordinates are turned that are as far out as the right ones, where the angle is a usual one."""
    lengths = np.linalg.norm(given), np.linalg.norm(right)
    is_as_long = np.isclose(*lengths, rtol=_NEAR_LENGTH)
    if not {label[-1:] for label in labels} <= {*"xyz"} or right.size < 2 or not is_as_long or near(given, right):
        return ""
    angle = float(np.degrees(np.arccos(np.clip(given @ right / np.prod(lengths), -1, 1)))) / _USUAL_ANGLE
    if not round(angle) or abs(angle - round(angle)) > _NEAR_ANGLE:
        return ""
    turn = round(angle) * _USUAL_ANGLE
    return written("the length is right, the direction is not: yours is turned by {angle}°", angle=turn)


def _are_coordinates(right: np.ndarray, labels: Sequence[str]) -> bool:
    """Whether coordinates are asked of which several are not zero."""
    return right.size > 1 and {label[-1:] for label in labels} <= {*"xyz"} and bool(np.count_nonzero(right) > 1)


def _size_of_all(right: np.ndarray, labels: Sequence[str], unit: str) -> tuple[Guess, ...]:
    """Return the speed, the size of a velocity's coordinates together, which may stand for one of them."""
    if unit != "m/s" or not _are_coordinates(right, labels):
        return ()
    size = float(np.linalg.norm(right))
    return (Guess(size, partial(look_up, noted("this is the size of all of them together")), is_short(size)),)


def _in_one_place(given: np.ndarray, right: np.ndarray, labels: Sequence[str]) -> str:
    """Return which coordinate alone is as large as all that are asked together, the others being zero."""
    places = np.flatnonzero(given).tolist()
    if (
        not _are_coordinates(right, labels)
        or len(places) != 1
        or not near(np.linalg.norm(given), np.linalg.norm(right))
    ):
        return ""
    return written("the size is right, the direction is not: all of it stands in {label}", label=labels[places[0]])


def _by_factor(given: np.ndarray, right: np.ndarray, usual: Sequence[int] = ()) -> Iterator[str]:
    """Yield by which whole factor wrong numbers are too large or too small, of some that are usual; of one number not by seven, which comes by chance."""
    for sign, words in ((1, noted("wrong by a factor of {factor}")), (-1, noted("wrong by a factor of {factor}, and in sign"))):  # fmt: skip
        factor = _common_factor(sign * given, right)
        if not factor or factor not in (usual or (_LONE_FACTORS if given.size == 1 else (factor,))):
            continue
        if factor == 2 and sign > 0 and given.size == 1:
            yield look_up(TWICE if abs(given[0]) > abs(right[0]) else HALF)
        else:
            yield written(words, factor=factor)


def wrong_numbers(given: np.ndarray, right: np.ndarray) -> np.ndarray:
    """Return which numbers are wrong, and not only rounded; where none is, those that differ at all."""
    far = ~np.isclose(given, right, rtol=_NEAR, atol=_TOLERANCE)
    far &= ~np.array([_is_rounded(one, other) for one, other in zip(given.tolist(), right.tolist(), strict=True)])
    return far if far.any() else ~np.isclose(given, right, rtol=_TOLERANCE)


def _are_all_rounded(given: np.ndarray, right: np.ndarray) -> bool:
    """Whether several numbers, none of them whole, are the right ones cut off or rounded behind the first or second decimal."""
    off = ~np.isclose(given, right, rtol=_TOLERANCE)
    short = (cut(right * 10**places) / 10**places for places in (1, 2) for cut in (_rounded, np.trunc))
    return int(np.count_nonzero(off)) > 1 and any(bool(near(given, each) and each[off].all()) for each in short)


def _rounded(numbers: np.ndarray) -> np.ndarray:
    """Return numbers rounded as by hand, a half away from zero."""
    return np.asarray(np.sign(numbers) * np.floor(np.abs(numbers) + 0.5 + _TOLERANCE))


def _is_rounded(given: float, right: float) -> bool:
    """Whether a number is the right one to the decimals that it has, two digits at least; or nearly one that has many digits.

    The digits of a number that has many where the right one has few come from rounding on the way, or from another formula:
    they tell the more, the more there are.
    """
    decimals = repr(given).partition(".")[2]
    is_plain = decimals.isdigit() and abs(given) >= 10 ** (1 - len(decimals)) and decimals != "0"
    if given == right or (is_plain and round(right, len(decimals)) == given):
        return True
    most = _NEAR / 2 if float(f"{right:.4g}") != right else _NEAR_SHORT if float(f"{given:.4g}") != given else 0
    return bool(most and np.isclose(given, right, rtol=most))


def _common_factor(given: np.ndarray, right: np.ndarray) -> int:
    """Return the whole number by which all numbers are too large, or too small; 0 where there is none."""
    if (right == 0).any() or np.abs(given / right).min() <= _TOLERANCE or not near(given / right, given[0] / right[0]):
        return 0
    ratio = float(given[0] / right[0])
    if ratio < 0:
        return 0
    factor = max(ratio, 1 / ratio)
    whole = right * round(factor) if ratio > 1 else right / round(factor)
    return (
        round(factor)
        if all(map(nearly, given.tolist(), whole.tolist()))
        and (1 < round(factor) <= _LARGEST_FACTOR or round(factor) in _POWERS_OF_TEN)
        else 0
    )


def _of_one(asked: Asked, given: float, own: Mapping[str, float], is_only: bool) -> str:
    """Return what is behind one wrong number; where nothing is recognised how large it is, and what would have to be given."""
    right, is_count = asked.right, asked.unit == "–"
    if is_count and (float(right).is_integer() or not right) and float(given).is_integer():
        soon = _counted_otherwise(given, asked) or (_of_another(given, asked) if given > _MOST_ASTRAY else "")
        return soon or _of_a_count(given, asked) or _of_another(given, asked) or _by_size(asked, given, is_only)
    if not given:
        missing = asked.worked.missing if asked.worked is not None else ""
        return missing or look_up(_NOT_ZERO.get(asked.unit, _NOT_ZERO["–"]))
    is_copied = not given.is_integer() and abs(given) in {*map(abs, (*asked.known.values(), *asked.stated))}
    if beside := explained(given, right, _to_the_digit(asked.beside, is_copied), _ALL):
        return beside
    if not right:
        said = explained(given, right, asked.guesses(given), _MOST_TRUE)
        return said or explained(given, right, asked.whole_ones(), _ALL) or look_up("zero belongs there")
    return (
        _of_a_count(given, asked)
        or _carried(asked, given, own)
        or explained(given, right, asked.guesses(given))
        or next(_by_factor(np.array([given]), np.array([right]), (2, *_TENS)), "")
        or explained(given, right, asked.doubled())
        or _of_another(given, asked)
        or explained(given, right, asked.identities(), _MOST_TRUE)
        or explained(given, right, asked.alone(given), _ALL)
        or next((guess.words() for guess in asked.by_hand(given) if nearly(given, guess.value, guess.is_exact)), "")
        or explained(given, right, _to_the_digit(asked.slips_beside(), is_copied))
        or _factor_of_one(given, asked)
        or _of_reach(given, asked)
        or (written(ELSEWHERE, value=abs(given)) if is_copied else "")
        or _by_size(asked, given, is_only)
    )


def _to_the_digit(guesses: Iterable[Guess], is_copied: bool) -> Iterator[Guess]:
    """Yield guesses that a number copied from the text meets in all digits only: 0.2 is not the arcsine of 0.2, rounded."""
    return (replace(guess, is_exact=guess.is_exact or is_copied) for guess in guesses)


def _factor_of_one(given: float, asked: Asked) -> str:
    """Return by which factor a number is too large or too small, of several only by two and powers of ten."""
    usual = (2, *_TENS) if asked.others and not (given.is_integer() and asked.right.is_integer()) else _LONE_FACTORS
    return next(_by_factor(np.array([given]), np.array([asked.right]), usual), "")


def _carried(asked: Asked, given: float, own: Mapping[str, float]) -> str:
    """Return that a number follows from others of the answer, which are wrong."""
    worked, letters = asked.worked, letters_of(own)
    if worked is None:
        return ""
    astray = {name for name in worked.letters & {*letters} if not near(letters[name], worked.known[name])}
    if not astray:
        return ""
    labels = [label for label in own if letters_of({label: 0.0}).keys() & astray]
    names = separator(labels).join(labels)
    followed = replace(worked, known={**worked.known, **{name: letters[name] for name in astray}})
    if near(given, followed.value):
        return written("this follows from your {names}: nothing else is wrong with it", names=names)
    if near(given, worked.value) or not np.isfinite(followed.value):
        return ""
    words = explained(given, followed.value, followed.slips())
    return written("with your {names}: {words}", names=names, words=words) if words else ""


def _share(given: float, right: float) -> str:
    """Return which fraction of small numbers a number is of the right one, where that is no whole number."""
    share = Fraction(given / right).limit_denominator(_LARGEST_PART)
    if not (1 < share.numerator <= _LARGEST_PART and share.denominator > 1 and near(given, float(share) * right)):
        return ""
    return written("this is {share} of what is asked", share=share)


def _of_a_count(given: float, asked: Asked) -> str:
    """Return how many too many or too few a count says, or that it is none."""
    values = (asked.right, *asked.others.values())
    if asked.unit != "–" or not all(map(float.is_integer, values)) or not max(values) > 1 or asked.right < 0:
        return ""
    if not float(given).is_integer():
        return look_up("a whole number is asked") if asked.is_whole else ""
    if given < 0:
        return look_up("a number of things is not negative")
    more = int(given - asked.right)
    if abs(more) > _MOST_ASTRAY:
        return ""
    return counted("one too many", "{number} too many", more) if more > 0 else counted("one too few", "{number} too few", -more)  # fmt: skip


def _counted_otherwise(given: float, asked: Asked) -> str:
    """Return what a count is instead: what others give, a part of it, or it with a part left out."""
    parts = asked.worked.counted_otherwise() if asked.worked is not None else ()
    found = (guess.words() for guess in (*asked.beside, *parts) if guess.value == given != asked.right)
    return next(found, "")


def _of_another(given: float, asked: Asked) -> str:
    """Return which other numbers that are asked a number is, where they are not nearly all alike."""
    labels = [label for label, value in asked.others.items() if value == given and value]
    is_among_others = len({*asked.others.values(), asked.right}) > 2
    return instead(separator(labels).join(labels)) if labels and is_among_others else ""


def _of_reach(given: float, asked: Asked) -> str:
    """Return that no sum of all given lengths is so long."""
    longest = sum(map(abs, asked.known.values()))
    is_of_lengths = asked.unit == "m" and (asked.worked is None or asked.worked.is_short)
    if not is_of_lengths or not 0 < longest < abs(given):
        return ""
    return written(
        "even {names} is only {longest:g}: the arm does not reach that far",
        names=" + ".join(asked.known),
        longest=longest,
    )


def _by_size(asked: Asked, given: float, is_only: bool) -> str:
    """Return how large a number is beside the right one, what would have to be given, and that the others are right."""
    right = asked.right
    if not right:
        return look_up("zero belongs there")
    if given and (factor := _factor_of_one(given, asked)):
        return factor
    if given * right < 0:
        size = look_up("the sign and the size are wrong")
    else:
        is_count = float(right).is_integer() and float(given).is_integer()
        size = (not is_count and _share(given, right)) or (_size(given / right) if given else look_up("zero would mean that there is none"))  # fmt: skip
    size = (asked.worked.instead(given) if asked.worked is not None and is_only else "") or size
    return written("{size}; all else is right", size=size) if is_only and asked.others else size


def _size(ratio: float) -> str:
    """Return how large a number is in words that leave the rest to the student."""
    if close := next((words for most, words in _CLOSE if abs(ratio - 1) < most), ""):
        size = noted("too large by less than {share}") if ratio > 1 else noted("too small by less than {share}")
        return written(size, share=look_up(close))
    if max(ratio, 1 / ratio) < 2 * (1 + _ABOUT) and max(ratio, 1 / ratio) > 2 * (1 - _ABOUT):
        return look_up("about twice what is asked") if ratio > 1 else look_up("about half of what is asked")
    if ratio > 1:
        return look_up("much too large: more than double") if ratio > 2 else look_up("too large, but less than double")
    return look_up("much too small: less than half") if ratio < 1 / 2 else look_up("too small, but more than half")
