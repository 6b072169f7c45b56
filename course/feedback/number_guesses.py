"""What a wrong number may be instead of the one that is asked: of the other way round, of another unit, a sum with a part too few, …"""

from __future__ import annotations

import operator
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from itertools import chain, combinations, permutations

import numpy as np

from armproof.course.feedback.guesses import (
    Guess,
    alone,
    digits_astray,
    digits_exchanged,
    instead,
    is_short,
    perhaps,
    shortened,
)
from armproof.course.feedback.worked import Worked
from armproof.models.errors import written
from armproof.models.language import look_up, noted, number_text

OF_ANGLES = ("rad", "rad/s")
_CIRCULAR = ("sin", "cos")
_FUNCTIONS = {"sin": noted("sine"), "cos": noted("cosine"), "tan": noted("tangent")}
_INVERSES: Mapping[str, Callable[[float], float]] = {"sin": np.arcsin, "cos": np.arccos, "tan": np.arctan}
_SQUARE = noted("this is the square of what is asked")
_SMALL = 0.1  # rad: below it an angle and its tangent are nearly one
_MOST_STATED = 6
_FEW_STATED = 3  # numbers, of which one is soon taken for the answer
_TWO_LETTERS = 2
_FEW_LETTERS = 4
_NOTHING = 1e-9
_CLOSE = 0.1  # of a number, that is lost with parts that are rounded on the way
_ALONG = 0.01  # the sine of twice an angle that stands along an axis, to two digits
TWICE, HALF = noted("this is twice what is asked"), noted("this is half of what is asked")
_MISSING, _TOO_MUCH = noted("{name} is missing"), noted("{name} does not belong in it")
ELSEWHERE = noted("{value:g} is given for something else")
_TWICE = noted("{name} is counted twice")
_TWO = {"+": operator.add, "·": operator.mul, "/": operator.truediv, "-": operator.sub}


@dataclass(frozen=True)
class Asked:
    """One of the numbers that are asked.

    Attributes:
        right, label, unit: it, what it is, and its unit.
        others: the other numbers, by what they are.
        known: given values by their letters.
        stated: numbers that the task's text gives.
        worked: how it follows from them; None where that is not known.
        beside: what others give instead.
        further: the formulas among these, in which a slip may stand, too.
        is_whole: whether a number of things is asked, of which none is a fraction, and no factor.
    """

    right: float
    label: str = ""
    unit: str = "–"
    others: Mapping[str, float] = field(default_factory=dict)
    known: Mapping[str, float] = field(default_factory=dict)
    stated: tuple[float, ...] = ()
    worked: Worked | None = None
    beside: tuple[Guess, ...] = ()
    further: tuple[Worked, ...] = ()
    is_whole: bool = True

    def guesses(self, given: float) -> Iterator[Guess]:
        """Yield what mistakes would give, the usual ones first."""
        own, far = self._letters()
        yield from self._as_it_stands()
        if self.label.startswith("tan"):
            yield from chain(self._another(), self._other_functions())
        yield from self._alone(own, given)
        if self.worked is not None and len(own) == _TWO_LETTERS:
            pairs = {**_pairs(own), **_bent(own)} if self.worked.is_short else _sums(own)
            yield from (Guess(value, partial(instead, name), is_exact="√" not in name) for name, value in pairs.items())
        yield from shortened(given, self.right)
        yield from digits_exchanged(given, self.right)
        yield from self._of_parts(own)
        yield from (replace(guess, words=partial(self._and_otherwise, guess, far)) for guess in self._alone(far, given))
        if is_soon := self.worked is None or len(self.stated) <= _FEW_STATED:
            yield from self._copied()
        if self.worked is not None:
            yield from self.worked.parts()
            yield from self.worked.slips()
        yield from self._another()
        if self.worked is not None:
            yield from self.worked.pairs()
            yield from () if is_soon else self._copied()
        yield from self._turned() if self.unit == "rad" else ()
        if self.worked is not None:
            yield from self._of_parts(far) if self.worked.is_short else ()
            yield from self.worked.confusions()
        yield from self.doubled() if self.others else ()
        is_of_others = self.worked is None or bool(self.worked.letters)
        mirrored = (*self._mirrored(),) if self.unit == "rad" else ()
        # beside zero there is no size by which chance is told
        of_others = (*self._of_the_others(),) if self.right else ()
        yield from (*of_others, *mirrored) if is_of_others else (*mirrored, *of_others)
        yield from self._of_the_text() if self.right else ()
        yield from self._of_parts(far)
        yield from self._with_a_value()
        yield from digits_astray(given, self.right)
        if self.worked is not None:
            yield from self._in_degrees() if not self.worked.is_short else ()
            yield from self.worked.misreadings()
        yield from self._of_powers()
        yield from self._of_parts(_pairs(own))
        yield from self._of_sums(own)
        if self.worked is not None:
            yield from self.worked.long_shots()

    def identities(self) -> Iterator[Guess]:
        """Yield sums and differences of given values, and the number with one too many: of a number that is one this is true, chance or not."""
        values = self.known or {number_text(value, "g"): value for value in self.stated}
        if len(values) <= _FEW_LETTERS and self.unit != "rad":  # what is in metres makes no angle
            for sign in "+-":
                for one, other in permutations(values, 2) if sign == "-" else combinations(values, 2):
                    value = _TWO[sign](values[one], values[other])
                    yield Guess(value, partial(perhaps, f"{one} {sign} {other}"), is_exact=True)
        for label, value in self.others.items():
            yield Guess(self.right + value, partial(written, _TOO_MUCH, name=label), is_exact=True)
        for name, value in self.known.items():
            for sign, part in (("+", value), ("-", -value)) if self.worked is not None and self.worked.is_short else ():
                yield Guess(self.right + part, partial(self._with_more, sign, name), is_exact=True)

    def _with_more(self, sign: str, name: str) -> str:
        return instead(f"{self.worked.shown} {sign} {name}") if self.worked is not None else ""

    def _and_otherwise(self, guess: Guess, far: Mapping[str, float]) -> str:
        """Return that a number is a given value of which the formula has nothing, and what else of the same size it may be."""
        slips = self.worked.slips() if self.worked is not None else ()
        words = [each.words() for each in chain(slips, self._of_parts(far)) if abs(each.value - guess.value) < _NOTHING]
        return look_up("; or: ").join(dict.fromkeys([guess.words(), *words][:2]))

    def _letters(self) -> tuple[dict[str, float], dict[str, float]]:
        """Return the given values by their letters, those in the formula and the others; where there is none, all and none."""
        of = (
            {*self.known}
            if self.worked is None
            else {name for name, value in self.known.items() if self.worked.has(name, value)}
        )
        own = {name: value for name, value in self.known.items() if name in of}
        return own, {name: value for name, value in self.known.items() if name not in of}

    def _as_it_stands(self) -> Iterator[Guess]:
        """Yield the number with the other sign, in degrees, upside down; and the angle whose function it is, or its function."""
        right = self.right
        yield Guess(-right, lambda: look_up("the sign is wrong"))
        for label, value in self.others.items():
            if self.label.startswith(_CIRCULAR) and label.startswith(_CIRCULAR):
                yield Guess(1 - value, partial(instead, f"1 − {label}"))
        if self.unit in OF_ANGLES:
            yield Guess(float(np.degrees(right)), lambda: look_up("in degrees? Radians are asked for"))
        for name, words in _FUNCTIONS.items():
            if self.label.startswith(name):
                told = partial(_with_function, noted("this is the angle: its {function} is asked"), words)
                with np.errstate(invalid="ignore"):
                    angle = float(_INVERSES[name](right))
                yield from (Guess(angle, told), Guess(float(np.degrees(angle)), told))
                yield Guess(right**2, lambda: look_up(_SQUARE))
            if self.unit == "rad" and abs(right) > _SMALL:
                told = partial(_with_function, noted("this is the {function} of the angle: the angle itself is asked"), words)  # fmt: skip
                yield Guess(float(getattr(np, name)(right)), told)
        if self.unit == "rad/s":
            yield Guess(right / (2 * np.pi), lambda: look_up("in turns a second? Radians a second are asked for"))
            yield Guess(right * 30 / np.pi, lambda: look_up("in turns a minute? Radians a second are asked for"))
            yield Guess(right / np.pi, lambda: look_up("a factor π is missing"))
            yield Guess(right * np.pi, lambda: look_up("a factor π is too much"))
            yield Guess(right * 2 * np.pi, lambda: look_up("a factor 2π is too much: the rate is in radians already"))
        if right and self.unit not in (*OF_ANGLES, "m") and self.worked is None:  # else its quotient is turned there
            yield Guess(1 / right, lambda: look_up("numerator and denominator are exchanged"))

    def _of_parts(self, parts: Mapping[str, float]) -> Iterator[Guess]:
        """Yield each part, and the number with that part too few or too many."""
        for name, value in parts.items():
            yield Guess(value, partial(alone, name), is_exact=True)
        changes = {name: self._changes(name, value) for name, value in parts.items() if value != self.right}
        for k in range(2):
            for name, of_part in changes.items():
                for words, change in of_part[k : k + 1]:
                    yield Guess(self.right + change, partial(written, words, name=name), is_exact=True)

    def _changes(self, name: str, value: float) -> tuple[tuple[str, float], ...]:
        """Return by how much the number is off with one part too few, then with one too many, and the words for it; nothing of what is no term."""
        if self.worked is None or name not in self.known:
            return (_MISSING, -value), (_TOO_MUCH, value)
        part = self.worked.share_of(name) if name in self.worked.letters else self.worked.term_of(value)
        if abs(part) < _NOTHING:
            return (_TOO_MUCH, value), (_TOO_MUCH, -value)
        if (
            name in self.worked.letters
            and abs(self.worked.with_values({name: 2 * value}) - self.right - part) > _NOTHING
        ):
            return ()
        return (_MISSING, -part), (_TWICE, part)

    def _of_sums(self, known: Mapping[str, float]) -> Iterator[Guess]:
        """Yield the sums of three and of four given values."""
        for count in (3, 4):
            for names in combinations(known, count) if count < len(known) else ():
                yield Guess(sum(known[name] for name in names), partial(instead, " + ".join(names)), is_exact=True)

    def _alone(self, letters: Mapping[str, float], given: float) -> Iterator[Guess]:
        """Yield given values, with the sign of the number that is given."""
        for name, value in letters.items():
            yield Guess(-value, partial(alone, f"-{name}")) if given < 0 < value else Guess(value, partial(alone, name))

    def _another(self) -> Iterator[Guess]:
        """Yield the other numbers that are asked."""
        for label, value in self.others.items():
            yield Guess(value, partial(instead, label))
            yield Guess(-value, partial(instead, f"−{label}"))

    def _other_functions(self) -> Iterator[Guess]:
        """Yield sine and cosine of the angle whose tangent is asked."""
        for name in _CIRCULAR:
            words = partial(
                _with_function, noted("this is the {function} of the angle: its tangent is asked"), _FUNCTIONS[name]
            )
            yield Guess(float(getattr(np, name)(np.arctan(self.right))), words)

    def _turned(self) -> Iterator[Guess]:
        """Yield an angle whole and half turns away, and in other units."""
        right = self.right
        for turn in (2 * np.pi, -2 * np.pi):
            yield Guess(
                right + turn, lambda: look_up("this is the angle and a whole turn: give the one between −π and π")
            )
        for turn in (np.pi / 2, -np.pi / 2):
            yield Guess(right + turn, lambda: look_up("a quarter of a turn off"))
        for turn in (np.pi, -np.pi):
            yield Guess(right + turn, lambda: look_up("half a turn off: the wrong one of two opposite quadrants"))
        yield Guess(right / np.pi, lambda: look_up("a factor π is missing"))
        yield Guess(float(np.radians(right)), lambda: look_up("π / 180 is too much: the value itself is in radians"))

    def _in_degrees(self) -> Iterator[Guess]:
        """Yield what an angle among the given values makes of the number, a small one taken in the other unit."""
        for value in (float(np.radians(self.right)), float(np.degrees(self.right))):
            yield Guess(value, lambda: look_up("off by a factor π / 180: are degrees taken for radians?"))

    def _mirrored(self) -> Iterator[Guess]:
        """Yield the supplement and the complement of an angle that stands along no axis."""
        right = self.right
        for turn in (1, -1) if abs(np.sin(2 * right)) > _ALONG else ():
            yield Guess(
                turn * np.pi - right, lambda: look_up("this is the supplement: the angle on the other side of the line")
            )
            yield Guess(
                turn * np.pi / 2 - right, lambda: look_up("this is the complement: the angle to the other axis")
            )

    def by_hand(self, given: float) -> Iterator[Guess]:
        """Yield what slips of the reckoning give: digits that are not written, carried over, kept on the way, or read right."""
        yield from shortened(given, self.right)
        if self.worked is not None:
            yield from self.worked.miscarried()
            yield from self._rounded(True)
            yield from self.worked.off_by_one()
            yield from self._rounded(False)

    def _rounded(self, is_of_the_rule: bool) -> Iterator[Guess]:
        found = self.worked.rounded(is_of_the_rule) if self.worked is not None else ()
        yield from (guess for guess in found if abs(guess.value - self.right) < _CLOSE * abs(self.right))

    def slips_beside(self) -> Iterator[Guess]:
        """Yield what a formula that others take gives with one thing done otherwise."""
        return chain.from_iterable(worked.asked_slips() for worked in self.further)

    def doubled(self) -> Iterator[Guess]:
        """Yield the double, the half and the square, and what a turn more makes of a number that is no angle."""
        yield Guess(2 * self.right, lambda: look_up(TWICE))
        yield Guess(self.right / 2, lambda: look_up(HALF))
        if self.worked is None or not self.worked.is_short:
            yield Guess(self.right**2, lambda: look_up(_SQUARE))
        if self.unit not in OF_ANGLES:
            yield Guess(2 * np.pi * self.right, lambda: look_up("a factor 2π is too much"))

    def _of_the_others(self) -> Iterator[Guess]:
        """Yield the squares of the other numbers, and the sums and differences of two."""
        others = {label: value for label, value in self.others.items() if value}
        for label, value in others.items() if not is_short(self.right) else ():
            yield Guess(self.right + value, partial(written, _TOO_MUCH, name=label))
            yield Guess(self.right - value, partial(written, _TOO_MUCH, name=label))
        for label, value in others.items():
            yield Guess(value**2, partial(written, noted("this is the square of {other}"), other=label))
        for (one, a), (other, b) in permutations(others.items(), 2) if self.unit == "–" else ():
            yield Guess(a / b, partial(instead, f"{one} / {other}"))
        if len(others) > 1:
            for (one, a), (other, b) in combinations(others.items(), 2):
                for sign, joint, value in (("", "+", a + b), ("", "−", a - b), ("−", "+", b - a), ("−", "−", -a - b)):
                    yield Guess(value, partial(instead, f"{sign}{one} {joint} {other}"))

    def _copied(self) -> Iterator[Guess]:
        """Yield the numbers of the text, where they are few; a whole one may count, and what is in metres makes no angle."""
        stated = self.stated if self.right else {*self.stated, *(-value for value in self.stated)}
        for value in stated if self.unit != "rad" and len(self.stated) <= _MOST_STATED else ():
            if not value.is_integer():
                yield Guess(value, partial(written, ELSEWHERE, value=value))

    def alone(self, given: float) -> Iterator[Guess]:
        """Yield the given values, with the sign of the number that is given."""
        return self._alone(self.known, given)

    def _with_a_value(self) -> Iterator[Guess]:
        """Yield a lone number with a given value more or less, where few are given."""
        if self.worked is None or self.others or len(self.stated) > _TWO_LETTERS:
            return
        for value in self.stated:
            for sign, part in (("+", value), ("-", -value)):
                yield Guess(self.right + part, partial(self._with_more, sign, number_text(value, "g")), is_exact=True)

    def whole_ones(self) -> Iterator[Guess]:
        """Yield the whole numbers of the text, of which one may stand where zero belongs."""
        for value in filter(float.is_integer, self.stated):
            yield Guess(value, partial(written, ELSEWHERE, value=value))

    def _of_the_text(self) -> Iterator[Guess]:
        """Yield two or three numbers of the text put together."""
        if self.unit == "rad" or len(self.stated) > _MOST_STATED:
            return
        for count in (2, 3):
            for some in combinations(self.stated, count):
                yield Guess(float(np.linalg.norm(some)), partial(_root, some))
        pairs = [(sign, *pair) for sign in _TWO for pair in permutations(self.stated, 2)]
        for sign, one, other in [*pairs, *(("·", each, each) for each in self.stated)]:
            yield Guess(_TWO[sign](one, other), partial(_reckoned, one, sign, other))

    def _of_powers(self) -> Iterator[Guess]:
        """Yield the square of a sum, and the root of a number that follows with a power."""
        yield Guess(self.right**2, lambda: look_up(_SQUARE))
        if self.right > 0 and (self.worked is None or self.worked.has_powers):
            yield Guess(float(np.sqrt(self.right)), lambda: look_up("this is the root: its square is asked"))


def _reckoned(one: float, sign: str, other: float) -> str:
    return perhaps(f"{number_text(one, 'g')} {sign} {number_text(other, 'g')}")


def _root(squares: Sequence[float]) -> str:
    shown = " + ".join(f"{number_text(each, 'g')}²" for each in squares)
    return written("this is the root of {squares}", squares=shown)


def _with_function(words: str, function: str) -> str:
    return written(words, function=look_up(function))


def _sums(known: Mapping[str, float]) -> dict[str, float]:
    """Return the sums of two given values."""
    return {f"{one} + {other}": known[one] + known[other] for one, other in combinations(known, 2)}


def _bent(known: Mapping[str, float]) -> dict[str, float]:
    """Return the hypotenuse of two given values, and their product."""
    one, other = known
    a, b = known.values()
    return {f"√({one}² + {other}²)": float(np.hypot(a, b)), f"{one} · {other}": a * b}


def _pairs(known: Mapping[str, float]) -> dict[str, float]:
    """Return the sums of two given values, and their doubles."""
    return {**_sums(known), **{f"2 {name}": 2 * value for name, value in known.items()}}
