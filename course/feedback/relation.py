"""How a wrong answer relates to what is asked, by values: the words where no slip of the pen explains it."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from functools import reduce
from itertools import combinations, pairwise, permutations

import numpy as np

from armproof.course.feedback.claim import ANGLE
from armproof.course.feedback.outcome import MOST_PLACES, place
from armproof.models.errors import ArmproofError, counted, written
from armproof.models.language import look_up, noted, number_text, separator
from armproof.verification.findings import Kind, say
from armproof.verification.findings.finding import Audience, write
from armproof.verification.latex.writer import symbol_as_latex

Letters = Mapping[str, np.ndarray]  # each letter's values at the samples
Values = Callable[[Letters], np.ndarray]  # what letters give, (samples, rows, columns)
Said = Callable[[], str]  # looks for one relation; empty where it does not hold

NUMBER_UPSIDE_DOWN = noted("the number in front is upside down: its reciprocal belongs there")
ENTRY_BY_ENTRY = noted("the matrices are multiplied entry by entry, as `*` does: `@` multiplies matrices")
HALF_TURN = noted("half a turn off everywhere: of `atan2` both arguments have the wrong sign, or π does not belong")
NO_QUADRANT = noted("right up to half a turn: `atan2` keeps the quadrant, `arctan` does not")
SINE_ALONE = noted("the sine is right, the angle is not: `arcsin` gives no angle beyond a quarter turn")
COSINE_SIGN = noted("the sine of the angle is right, its cosine has the wrong sign")
_JOINT_ANGLE = re.compile(r"theta_\d$")
ENOUGH = 5  # samples at which both sides have a value, so that a chance agreement is none
_TOLERANCE = 1e-8
_MOST_FACTORS = 4
_SMALL = 0.1  # rad: below it an angle and its tangent are nearly one
_LARGEST = 64  # denominator of a number in a product
_GROWN = 1.5  # by which a letter, or all of one unit, is changed to see what follows it
_MOST_LETTERS = 8
_ROUNDED = 0.005  # by which a rounded number makes an answer wrong
_MOST_OF_THREE = 6  # letters of which three may have changed places
_MOST_MATRICES = 4
_DRAWN = 48  # values of each letter


def first_said(relations: Iterable[Said]) -> str:
    """Return the words of the first relation that holds; one that cannot be evaluated does not."""
    for said in relations:
        try:
            if words := said():
                return words
        except ArmproofError:
            continue
    return ""


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
    wrong = wrong_entries(asked(at), given(at))
    words = _letter_astray(asked, given, at, wrong)
    if not words and wrong.sum() > 1 and (alien := _alien_letter(asked, given, at)):
        return alien
    places = np.argwhere(wrong).tolist()
    if not words or wrong.all() or (len(places) > 1 and _letter_astray(asked, given, at, np.ones_like(wrong)) == words):
        return words
    if len(places) > MOST_PLACES:
        return written("in each of the wrong entries: {words}", words=words)
    return by_places({(row, column): words for row, column in places})  # noqa: C420 – lists are no keys


def letters_astray_in_each(asked: Values, given: Values, at: Letters) -> str:
    """Say of each wrong entry of a matrix which letters are exchanged in it, missing, or do not belong there."""
    wrong = wrong_entries(asked(at), given(at))
    told = {}
    for row, column in np.argwhere(wrong).tolist()[:MOST_PLACES]:
        only = np.zeros_like(wrong)
        only[row, column] = True
        if words := _letter_astray(asked, given, at, only):
            told[row, column] = words
    return by_places(told)


def _letter_astray(asked: Values, given: Values, at: Letters, wrong: np.ndarray) -> str:
    obtained, few = given(at), list(at)[:_MOST_LETTERS]
    if any(not np.nan_to_num(np.abs(side[:, wrong])).max(initial=0) > _TOLERANCE for side in (asked(at), obtained)):
        return ""  # that zero stands there, or belongs there, is said in its own words
    if exchanged := letters_exchanged(asked, given, at, wrong):
        return exchanged
    threes = list(combinations(few, 3)) if len(few) <= _MOST_OF_THREE else []
    orders = [dict(zip(three, order, strict=True)) for three in threes for order in list(permutations(three))[1:]]
    moved = at_each(asked, [{**at, **{name: at[other] for name, other in order.items()}} for order in orders])
    for order, true in zip(orders, moved, strict=True):
        if same(true[:, wrong], obtained[:, wrong]):
            letters = separator([*order]).join(map(symbol_as_latex, order))
            return written("{letters} stand in each other's places", letters=letters)
    angles = [name for name in at if _JOINT_ANGLE.match(name)]
    if len(angles) > 1:
        absolute = {name: at[name] - at[before] for before, name in pairwise(angles)}
        if same(asked({**at, **absolute})[:, wrong], obtained[:, wrong]):
            return look_up("each angle is taken as absolute, from the base: sums of angles are missing")
    theirs, mine = (_followed(side, at, few, wrong) for side in (asked, given))
    if missing := [name for name, needed, own in zip(few, theirs, mine, strict=True) if needed.all() and not own.any()]:
        return _missing_letters(missing)
    return _alien_letter(asked, given, at, wrong)


def letters_exchanged(asked: Values, given: Values, at: Letters, wrong: np.ndarray) -> str:
    """Say which two letters are exchanged in the wrong entries; empty where none are."""
    pairs, obtained = list(combinations(list(at)[:_MOST_LETTERS], 2)), given(at)
    exchanged = at_each(asked, [{**at, one: at[other], other: at[one]} for one, other in pairs])
    for (one, other), true in zip(pairs, exchanged, strict=True):
        if same(true[:, wrong], obtained[:, wrong]):
            shown = symbol_as_latex(one), symbol_as_latex(other)
            needed = [places.any() for places in _followed(asked, at, (one, other), wrong)]
            if needed == [True, True]:
                return written("{one} and {other} are exchanged", one=shown[0], other=shown[1])
            right, stray = shown if needed[0] else shown[::-1]
            return written("{stray} where {right} belongs", stray=stray, right=right)
    return ""


def _alien_letter(asked: Values, given: Values, at: Letters, wrong: np.ndarray | None = None) -> str:
    """Say which letter an answer follows, and what is asked does not, in none of these entries or in none at all."""
    entries = wrong if wrong is not None else np.ones(asked(at).shape[1:], dtype=bool)
    few = list(at)[:_MOST_LETTERS]
    followed = zip(few, *(_followed(side, at, few, entries) for side in (given, asked)), strict=True)
    for name, mine, theirs in followed:
        if not theirs.any() and (mine.all() if wrong is not None else mine.any()):
            return written("what is asked does not depend on {name}, your answer does", name=symbol_as_latex(name))
    return ""


def _missing_letters(names: Sequence[str]) -> str:
    """Say which letters an answer does not follow, all of them."""
    shown = [symbol_as_latex(name) for name in names]
    return counted(
        "{letters} is missing: what is asked depends on it, your answer does not",
        "{letters} have no effect in your answer: what is asked depends on them",
        len(shown), letters=separator(shown).join(shown),
    )  # fmt: skip


def _followed(side: Values, at: Letters, names: Sequence[str], wrong: np.ndarray) -> list[np.ndarray]:
    """Return which of the wrong entries change with each of some letters."""
    before = side(at)[:, wrong]
    grown = at_each(side, [{**at, name: at[name] * _GROWN} for name in names])
    return [
        np.array([not same(after[:, wrong][:, [k]], before[:, [k]]) for k in range(before.shape[1])]) for after in grown
    ]


def angle_astray(asked: Values, given: Values, at: Letters) -> str:
    """Say which angle is taken the other way, or counted from a direction a quarter or half a turn away; empty where none is."""
    obtained = given(at)
    wrong = wrong_entries(asked(at), obtained)
    for name in filter(ANGLE.match, at):
        shown = symbol_as_latex(name)
        sets = [-at[name], *(at[name] + turn * np.pi / 2 for turn in (-1, 1, 2))]
        mirrored, *others = (true[:, wrong] for true in at_each(asked, [{**at, name: values} for values in sets]))
        turned = dict(zip((-1, 1, 2), others, strict=True))
        if same(mirrored, obtained[:, wrong]):
            return written("the sign of {name} is wrong: it is taken the other way", name=shown)
        if same(turned[2], obtained[:, wrong]):
            return written("{name} is counted from the opposite direction: half a turn away", name=shown)
        if any(same(sign * turned[turn], obtained[:, wrong]) for turn in (-1, 1) for sign in (1, -1)):
            return written("{name} is counted from another direction: a quarter turn away", name=shown)
    return ""


def transform_astray(true: np.ndarray, obtained: np.ndarray, origin_alone: bool) -> str:
    """Say which parts of a homogeneous transform are those of its inverse, or only half inverted; empty where none is.

    Args:
        origin_alone: whether to say so of the origin where the rotation is right.
    """
    if true.shape[1:] != (4, 4) or obtained.shape != true.shape or not same(true[:, 3], np.eye(4)[[3] * len(true)]):
        return ""
    other = np.linalg.inv(true)
    (R, p), (R_right, p_right), (R_other, p_other) = ((X[:, :3, :3], X[:, :3, 3]) for X in (obtained, true, other))
    rotation = look_up("the rotation is that of the inverse: it is still to be transposed")
    if same(R, R_right):
        rotation = ""
        if not origin_alone:
            is_inverse = same(p, p_other) and wrong_entries(p[..., None], p_right[..., None]).sum() > 1
            return look_up("the origin is that of the inverse") if is_inverse else ""
    elif not same(R, R_other):
        return ""
    origins = {
        "": p_right,
        look_up("the origin is that of the inverse, only negated: it is still to be turned"): -p_other,
        look_up("the origin is that of the inverse"): p_other,
        look_up("the origin has the wrong sign"): -p_right,
        look_up("the origin is turned by the transpose of the rotation that belongs there"): -(
            R_other @ p_other[..., None]
        )[..., 0],
    }
    origin = next((words for words, values in origins.items() if same(p, values)), None)
    return "" if origin is None else look_up("; ").join(filter(None, [rotation, origin]))


def factors_astray(asked: Values, given: Values, at: Letters) -> str:
    """Say that the matrices of single letters are multiplied in another order, left out, added, or are too many; empty where they are not.

    Each factor is what is asked with all other letters zero: R_z(φ), R_y(θ), R_x(ψ) of their product.
    """
    true, obtained, names = asked(at), given(at), list(at)
    if true.shape != obtained.shape or true.shape[1] != true.shape[2] or not 1 < len(names) <= _MOST_MATRICES:
        return ""
    none = {name: np.zeros_like(at[name]) for name in names}
    factors = {name: asked({**none, name: at[name]}) for name in names}
    if not all(np.isfinite(each).all() for each in factors.values()):
        return ""
    orders = [order for order in permutations(names) if same(reduce(np.matmul, map(factors.__getitem__, order)), true)]
    if not orders:
        return ""
    if same(np.sum(list(factors.values()), axis=0), obtained):
        return look_up("the factors are added: they are to be multiplied")
    if same(np.prod(list(factors.values()), axis=0), obtained):
        return look_up(ENTRY_BY_ENTRY)
    for order in permutations(names):
        if order not in orders and same(reduce(np.matmul, map(factors.__getitem__, order)), obtained):
            right, wrong = (", ".join(map(symbol_as_latex, each)) for each in (orders[0], order))
            return written("the factors stand in the order {wrong}, not {right}", wrong=wrong, right=right)
    for name in names:
        rest = [factors[other] for other in orders[0] if other != name]
        if same(reduce(np.matmul, rest), obtained):
            return written("the factor with {name} is missing", name=symbol_as_latex(name))
    return ""


def axis_astray(true: np.ndarray, obtained: np.ndarray) -> str:
    """Say that a rotation turns by the same angle about another axis of the frame; empty where it does not."""
    if true.shape != obtained.shape or true.shape[1:] not in ((3, 3), (4, 4)):
        return ""
    sides = [side[:, :3, :3] for side in (true, obtained)]
    asked, given = map(_axis_of, sides)
    if not asked or not given or asked == given or not same(*(np.trace(R, axis1=1, axis2=2) for R in sides)):
        return ""
    return written("this turns about {given}, not about {asked}", given=given, asked=asked)


def inverse_astray(true: np.ndarray, obtained: np.ndarray) -> str:
    """Say that each entry of a matrix is inverted by itself where the inverse of the matrix is asked; empty where it is not."""
    if true.shape != obtained.shape or true.shape[1] != true.shape[2] or true.shape[1] < 2:
        return ""
    good = np.isfinite(obtained).all(axis=(1, 2)) & (np.abs(np.nan_to_num(np.linalg.det(true))) > _TOLERANCE)
    if good.sum() < ENOUGH:
        return ""
    matrix = np.linalg.inv(true[good])
    filled = np.abs(matrix).max(axis=0) > _TOLERANCE
    if filled.sum() < 2 or not same((obtained[good] * matrix)[:, filled], np.ones_like(matrix[:, filled])):
        return ""
    return look_up("each entry is inverted by itself: that is not the inverse of the matrix")


def _axis_of(R: np.ndarray) -> str:
    """Return the axis of the frame about which rotations turn; empty where there is none."""
    identity = np.broadcast_to(np.eye(3), R.shape)
    if not same(R @ R.transpose(0, 2, 1), identity) or not same(np.linalg.det(R), np.ones(len(R))):
        return ""
    turn = np.stack([R[:, 2, 1] - R[:, 1, 2], R[:, 0, 2] - R[:, 2, 0], R[:, 1, 0] - R[:, 0, 1]], axis=1)
    along = np.flatnonzero(np.abs(turn).max(axis=0) > _TOLERANCE)
    return "xyz"[int(along[0])] if len(along) == 1 else ""


def units_astray(asked: Values, given: Values, at: Letters, units: Sequence[Sequence[str]]) -> str:
    """Say if an answer is of another unit than what is asked, or adds terms of several; `units`: letters of one unit each."""
    wrong = wrong_entries(asked(at), given(at))
    if words := _of_units(asked, given, at, units, wrong):
        return words
    told = {}
    for row, column in np.argwhere(wrong).tolist() if wrong.sum() > 1 else ():
        only = np.zeros_like(wrong)
        only[row, column] = True
        if words := _of_units(asked, given, at, units, only):
            told[row, column] = words
    return by_places(told)


def _of_units(asked: Values, given: Values, at: Letters, units: Sequence[Sequence[str]], wrong: np.ndarray) -> str:
    return next(filter(None, (_units(asked, given, at, names, wrong) for names in units if names)), "")


def letter_at_fault(asked: Values, given: Values, at: Letters) -> str:
    """Say for which letter an answer is right at zero: the mistake is in how that letter comes in."""
    wrong = wrong_entries(asked(at), given(at))
    few = list(at)[:_MOST_LETTERS]
    several = [*((name,) for name in few), *combinations(few, 2)]
    without = [{**at, **{name: np.zeros_like(at[name]) for name in names}} for names in several]
    for names, true, obtained in zip(several, at_each(asked, without), at_each(given, without), strict=True):
        if same(obtained[:, wrong], true[:, wrong]) and np.nanmax(np.abs(true[:, wrong])) > _TOLERANCE:
            shown = [symbol_as_latex(name) for name in names]
            if len(names) == 1:
                return written(
                    "the mistake is in how {name} comes in: for {name} = 0 your answer is right", name=shown[0]
                )
            return written(
                "the mistake is in how {one} and {other} come in: for {one} = {other} = 0 your answer is right",
                one=shown[0],
                other=shown[1],
            )
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
    return degree if same(ratio, np.full_like(ratio, _GROWN**degree)) else None


def _told(true: np.ndarray, obtained: np.ndarray, words_of: Callable[[np.ndarray, np.ndarray], str]) -> str:
    """Return the words on all wrong entries, if they are the same, or on those that have some."""
    places = np.argwhere(wrong_entries(true, obtained)).tolist()
    found = {(r, c): words_of(true[:, r, c], obtained[:, r, c]) for r, c in places}
    said = {at: words for at, words in found.items() if words}
    is_everywhere = len(found) == np.count_nonzero(np.nan_to_num(np.abs(true)).max(axis=0) > _TOLERANCE)
    if (len(found) > 1 and is_everywhere and len(set(found.values())) == 1) or true[0].size == 1:
        return next(iter(found.values()), "")
    return by_places(said)


def by_places(said: Mapping[tuple[int, int], str]) -> str:
    """Return what is said of entries, each sentence once with its places."""
    places: dict[str, list[str]] = {}
    for (row, column), words in list(said.items())[:MOST_PLACES]:
        places.setdefault(words, []).append(place(row + 1, column + 1))
    return look_up("; ").join(
        counted("entry {places}: {words}", "entries {places}: {words}", len(where), places=", ".join(where), words=words)
        for words, where in places.items()
    )  # fmt: skip


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
    if same(obtained, -true):
        yield look_up("the sign is wrong")
    if same(obtained**2, true):
        yield look_up("your answer is the root: its square is asked")
    if same(obtained, true**2):
        yield look_up("your answer is the square of what is asked")
    if same(obtained * true, np.ones_like(true)):
        yield look_up("numerator and denominator are exchanged")
    if same(obtained**2 + true**2, np.ones_like(true)):
        yield look_up("a sine stands where the cosine of the same angle belongs, or a cosine where its sine does")
    for function, name in ((np.cos, look_up("cosine")), (np.sin, look_up("sine"))):
        if same(function(obtained), true):
            yield written("your answer is the angle: its {function} is asked", function=name)
    if same(np.sin(obtained), np.tan(true)) or same(np.cos(obtained), np.tan(true)):
        yield look_up("the tangent of the angle is known: `atan2` belongs there, not `arcsin` or `arccos`")
    if same(np.sin(obtained), np.sin(true)):
        if same(np.cos(obtained), -np.cos(true)):
            yield look_up(COSINE_SIGN)
        yield look_up(SINE_ALONE)
    for of, name in (
        (np.tan(true), look_up("tangent")),
        (np.sin(true), look_up("sine")),
        (np.cos(true), look_up("cosine")),
    ):
        if same(of, obtained) and np.abs(true).max() > _SMALL:
            yield written("your answer is the {function} of what is asked", function=name)
    if same(np.exp(1j * (obtained + true)), np.ones(len(true))) and not same(obtained, -true):
        yield look_up("the sign of the angle is wrong")
    if same(np.exp(1j * (obtained + true)), np.full(len(true), 1j)):
        yield look_up("the arguments of `atan2` are exchanged: first the side across, then the side along")
    if same(np.exp(4j * (obtained - true)), np.ones(len(true))) and not same(
        np.exp(2j * (obtained - true)), np.ones(len(true))
    ):
        yield look_up("right up to a quarter turn: the angle is counted from another direction")
    turns = (obtained - true) / np.pi
    if same(turns, np.round(turns)) and (np.round(turns) % 2 == 1).all():
        yield look_up(HALF_TURN)
    if same(turns, np.round(turns)) and (np.round(turns) % 2 == 1).any():
        yield look_up(NO_QUADRANT)
    if same(np.exp(2j * (obtained + true)), np.full(len(true), -1 + 0j)):
        yield look_up(
            "the quotient in the arctangent is upside down: the side across stands above; and `atan2` keeps the quadrant"
        )
    if same(np.abs(obtained), np.abs(true)) and np.ptp(np.sign(obtained * true)) > 0:
        yield look_up("right but for the sign, and for some values only: it must hold in all quadrants")


def _multiple(true: np.ndarray, obtained: np.ndarray, factors: Letters) -> str:
    """Say by which product an answer is too large, or which product of letters it has too much or too little."""
    good = (np.abs(true) > _TOLERANCE) & (np.abs(obtained) > _TOLERANCE)
    if good.sum() < ENOUGH:
        return ""
    ratio = obtained[good] / true[good]
    if same(ratio, np.full_like(ratio, ratio[0])):
        return _by_number(float(ratio[0]), true[good], {name: values[good] for name, values in factors.items()})
    known = {name: values[good] for name, values in factors.items()}
    if times := _product(ratio, known):
        return _by_product(times, _product(1 / ratio, known), ratio, known)
    difference = obtained[good] - true[good]
    if (more := _product(difference, known)).startswith("-"):
        return written("your answer is what is asked minus {product}", product=more[1:])
    if more:
        return written("your answer is what is asked plus {product}", product=more)
    return ""


def squares_astray(true: np.ndarray, obtained: np.ndarray, factors: Letters) -> str:
    """Say by which product the squares of an answer and of what is asked differ; empty where they differ by none."""

    def words_of(asked: np.ndarray, given: np.ndarray) -> str:
        good = np.isfinite(asked) & np.isfinite(given) & (np.abs(asked) > _TOLERANCE) & (np.abs(given) > _TOLERANCE)
        more = (
            _product(given[good] ** 2 - asked[good] ** 2, {name: values[good] for name, values in factors.items()})
            if good.sum() >= ENOUGH
            else ""
        )
        return more and written(
            "the square of your answer differs from that of what is asked by {product}", product=more
        )

    return _told(true, obtained, words_of)


def _by_product(times: str, missing: str, ratio: np.ndarray, factors: Letters) -> str:
    """Say that a product is missing, or by which product an answer is too large; of a square what may be behind it."""
    if "/" not in missing:
        return written("a factor {product} is missing", product=missing)
    words = written("your answer is {product} times what is asked", product=times)
    powers, number = _powers(ratio, factors) or ({}, 0.0)
    if _is_sum_for_product(powers, number):
        return write(say(Kind.SUM_FOR_PRODUCT), Audience.STUDENT)
    if exchanged := _exchanged_functions(powers):
        sign = look_up(", and the sign is wrong") if number < 0 else ""
        return written("sine and cosine of {angles} are exchanged", angles=separator(exchanged).join(exchanged)) + sign
    if abs(number - 1) > _TOLERANCE or any(power % 2 or power < 0 for power in powers.values()):
        return words
    root = " ".join(_power(name, power // 2) for name, power in powers.items())
    return words + look_up("; ") + written("does {product} stand above the line where it belongs below?", product=root)


def _is_sum_for_product(powers: Mapping[str, int], number: float) -> bool:
    """Whether a ratio is (a + b) / (a b), or that upside down: a sum of two letters in the place of their product."""
    if len(powers) != 3 or abs(number - 1) > _TOLERANCE:
        return False
    total, *letters = sorted(powers, key=len, reverse=True)
    return (
        {*total.split(" + ")} == {*letters}
        and abs(powers[total]) == 1
        and all(powers[each] == -powers[total] for each in letters)
    )


def _exchanged_functions(powers: Mapping[str, int]) -> list[str]:
    """Return the angles whose sine stands for the cosine or the other way round, where a ratio is nothing else."""
    angles = [name.removeprefix("sin ") for name in powers if name.startswith("sin ")]
    pairs = {f"{function} {angle}": sign * powers[f"sin {angle}"] for angle in angles for function, sign in (("sin", 1), ("cos", -1))}  # fmt: skip
    return angles if pairs == powers and {*map(abs, pairs.values())} == {1} else []


def _product(values: np.ndarray, factors: Letters) -> str:
    """Return values as a product of powers of factors; empty where they are none, or one of many factors."""
    powers, exactly = _powers(values, factors) or ({}, 0.0)
    number = Fraction(exactly).limit_denominator(_LARGEST)
    if (
        not same(np.array([exactly] * ENOUGH), np.array([float(number)] * ENOUGH))
        or not 0 < len(powers) <= _MOST_FACTORS
    ):
        return ""
    over, under = ([_power(name, abs(power)) for name, power in powers.items() if power * sign > 0] for sign in (1, -1))
    sign = "-" if number < 0 else ""
    over = [str(abs(number.numerator))] * (abs(number.numerator) != 1 or not over) + over
    under = [str(number.denominator)] * (number.denominator != 1) + under
    below = f" / ({' '.join(under)})" if len(under) > 1 else " / " + "".join(under)
    return f"{sign}{' '.join(over)}{below if under else ''}"


def _powers(values: np.ndarray, factors: Letters) -> tuple[dict[str, int], float] | None:
    """Return which powers of factors, and which number, make values as a product; None where none do.

    Letters alone come first: of many factors there may be more than samples.
    """
    letters = {name: each for name, each in factors.items() if not re.search("[ +-]", name)}
    return _powers_of(values, letters) or _powers_of(values, factors)


def _powers_of(values: np.ndarray, factors: Letters) -> tuple[dict[str, int], float] | None:
    """Return which powers of factors, and which number, make values as a product; None where none do."""
    factors = {name: each for name, each in factors.items() if (np.abs(each) > _TOLERANCE).all()}
    if len(values) < len(factors) + ENOUGH or not (np.abs(values) > _TOLERANCE).all():
        return None
    logarithms = np.column_stack([np.log(np.abs(each)) for each in factors.values()] + [np.ones(len(values))])
    powers = np.round(np.linalg.lstsq(logarithms, np.log(np.abs(values)), rcond=None)[0][:-1]).astype(int)
    rest = values / np.prod(
        [each**power for each, power in zip(factors.values(), powers.tolist(), strict=True)], axis=0
    )
    number = float(np.median(rest))
    if not same(rest, np.full_like(rest, number)):
        return None
    return {name: power for name, power in zip(factors, powers.tolist(), strict=True) if power}, number


def _power(name: str, power: int) -> str:
    """Return a power of a factor as text; a sum or a function of an angle in brackets."""
    shown = f"({name})" if "+" in name or "-" in name or (" " in name and power != 1) else name
    return shown if power == 1 else f"{shown}^{power}"


def _by_number(factor: float, true: np.ndarray, factors: Letters) -> str:
    """Say by which number an answer is too large or too small, and what makes it so, where that shows."""
    size = max(abs(factor), 1 / abs(factor))
    if abs(size - 1) < _TOLERANCE:
        return look_up("the sign is wrong")
    if factor < 0:
        return written("{words}, and the sign is wrong", words=_by_number(-factor, true, factors))
    if abs(size - 180 / np.pi) < _TOLERANCE * size:
        return look_up("in degrees? Radians are asked for") if abs(factor) > 1 else look_up("radians are asked for: no π / 180")  # fmt: skip
    number = _number_in(true, factors)
    if number and abs(factor * number**2 - 1) < _TOLERANCE:
        return look_up(NUMBER_UPSIDE_DOWN)
    if size - 1 < _ROUNDED:
        return look_up("close, but a number in it is rounded: hand over the fraction or the root itself")
    if number and abs(number - 1) > _TOLERANCE and abs(factor * number - 1) < _TOLERANCE:
        return look_up("the number in front is missing")
    shown = _as_root(size) or number_text(size, ".4g")
    large, small = noted("your answer is {factor} times too large"), noted("your answer is {factor} times too small")
    words = written(large if abs(factor) > 1 else small, factor=shown)
    if number and abs(number - 1) > _TOLERANCE and not _as_root(size) and abs(size - round(size)) > _TOLERANCE:
        return written("the number in front is wrong: {words}", words=words)
    return words


def _number_in(values: np.ndarray, factors: Letters) -> float:
    """Return the number in a product of letters; 0 where values are none."""
    (_, number) = _powers(values, factors) or ({}, 0.0)
    return number


def _as_root(size: float) -> str:
    """Return a number as the root of a whole one; empty where it is whole, or no root."""
    square = round(size**2)
    is_root = abs(size - math.sqrt(square)) < _TOLERANCE * size and math.isqrt(square) ** 2 != square
    return f"√{square}" if is_root and square <= _LARGEST else ""


def wrong_entries(true: np.ndarray, obtained: np.ndarray) -> np.ndarray:
    """Return which entries differ at any sample, (rows, columns)."""
    good = np.isfinite(true) & np.isfinite(obtained)
    return np.asarray((good & (np.abs(true - obtained) > _TOLERANCE * (1 + np.abs(true)))).any(axis=0))


def same(one: np.ndarray, other: np.ndarray) -> bool:
    """Whether two arrays agree wherever both have a value, at samples enough."""
    good = np.isfinite(one) & np.isfinite(other)
    return bool(good.sum() >= ENOUGH and (np.abs(one - other) <= _TOLERANCE * (1 + np.abs(other)))[good].all())


def random_values(names: Sequence[str], count: int = _DRAWN) -> Letters:
    """Return values of letters at random: angles of either sign; of other letters one half is positive."""
    return {name: _drawn(name, seed, count) for seed, name in enumerate(names)}


def _drawn(name: str, seed: int, count: int) -> np.ndarray:
    rng = np.random.default_rng([seed, _DRAWN])
    if ANGLE.match(name):
        return rng.uniform(-2.6, 2.6, count)
    values = rng.uniform(0.3, 2.2, count)
    values[count // 2 :] *= rng.choice([-1, 1], count - count // 2)
    return values


def but_there(asked: Values, given: Values, wrong: np.ndarray, at: Letters) -> np.ndarray:
    """Return an answer whose entries are those of what is asked but where it is wrong."""
    true, obtained = asked(at), given(at)
    return np.where(wrong, obtained, true) if true.shape == obtained.shape else obtained


def at_each(side: Values, sets: Sequence[Letters]) -> list[np.ndarray]:
    """Return values at several sets of letters, worked out together: that takes little longer than at one of them."""
    if not sets:
        return []
    joined = side({name: np.concatenate([each[name] for each in sets]) for name in sets[0]})
    return np.split(joined, len(sets))


def remembered(side: Values) -> Values:
    """Return values that are worked out once: the relations try the same letters again for each entry."""
    known: dict[tuple[bytes, ...], np.ndarray] = {}

    def values(at: Letters) -> np.ndarray:
        key = tuple(each.tobytes() for each in at.values())
        if key not in known:
            known[key] = side(at)
        return known[key]

    return values
