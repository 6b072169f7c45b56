"""Tasks that ask for a choice or for numbers: predictions, ranks, the number of postures."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

import numpy as np

from armproof.course.errors import AnswerError
from armproof.course.feedback.answer import is_function
from armproof.course.feedback.derivation import Derivation, Line
from armproof.course.feedback.guesses import nearly
from armproof.course.feedback.number_guesses import OF_ANGLES
from armproof.course.feedback.number_slips import number_slip, numbers_in_text, values_in, wrong_numbers
from armproof.course.feedback.numbers import numbers_in
from armproof.course.feedback.outcome import Feedback, Outcome
from armproof.course.feedback.steps import Steps
from armproof.models.errors import ArmproofError, counted, written
from armproof.models.language import look_up, separator
from armproof.verification.latex.greek import NAMES

_ASIDE = (
    "and",
    "et",
    "option",
    "options",
    "axis",
    "axes",
    "axe",
    "answer",
    "answers",
    "réponse",
    "réponses",
)  # beside keys
_MOST_TURNS = 2  # whole ones: beyond them an angle is one of degrees
_TOLERANCE = 1e-6
_FOUR_DIGITS = 1e-4
_THREE_DIGITS = 3


@dataclass(frozen=True, eq=False)
class Choice:
    """One or several of stated options.

    Attributes:
        options: each option's key and its words.
        right: the key of the right option, or the keys of them all.
        because: what to say of a wrong option that is chosen, by key.
        missing: what to say of a right option that is not, by key.
    """

    options: Mapping[str, str]
    right: str | frozenset[str]
    because: Mapping[str, str] = field(default_factory=dict)
    missing: Mapping[str, str] = field(default_factory=dict)

    def judge(self, answer: Any) -> Feedback:
        """Return what becomes of a key, or of a list of keys."""
        if is_function(answer) or not isinstance(answer, str | int | Iterable):
            return Feedback(Outcome.ERROR, written("the answer is one of {keys}, or a list of them", keys=self._keys()))
        chosen = frozenset(self._chosen(answer))
        right = frozenset([self.right]) if isinstance(self.right, str) else self.right
        if unknown := sorted(chosen - set(self.options)):
            no_such = written(
                "there is no option '{key:.30}'; the options are {keys}", key=unknown[0], keys=self._keys()
            )
            return Feedback(Outcome.ERROR, no_such)
        if not chosen:  # words alone that stand beside keys: "axis"
            return Feedback(Outcome.ERROR, written("the answer is one of {keys}, or a list of them", keys=self._keys()))
        if chosen == right:
            return Feedback(Outcome.PROVED, "")
        if isinstance(self.right, str) and len(chosen) > 1:
            return Feedback(Outcome.WRONG, written("one of them is asked for, not {number}", number=len(chosen)))
        for key in sorted(chosen - right):
            if key in self.because:
                return Feedback(Outcome.WRONG, self.because[key])
        if left_out := [self.missing[key] for key in sorted(right - chosen) if key in self.missing]:
            return Feedback(Outcome.WRONG, left_out[0])
        if chosen < right:
            return Feedback(Outcome.WRONG, look_up("what is named is right, but there is more"))
        return Feedback(Outcome.WRONG, written("{keys}: that is not so", keys=sorted(chosen - right)))

    def signature(self, answer: Any) -> str:
        """Return the chosen keys in order, by which two answers are told apart."""
        return ",".join(sorted(self._chosen(answer)))

    def _chosen(self, answer: Any) -> list[str]:
        """Return the keys of an answer: a list, or a text with commas, blanks or "and" between them, in either case."""
        items = [answer] if isinstance(answer, int) else answer
        if isinstance(items, str) and (key := self._said.get(items.strip().lower())) is not None:
            return [key]
        words = re.split(r"[,;&+\s]+", items) if isinstance(items, str) else [str(item).strip() for item in items]
        words = [word for word in words if word and (word.lower() not in _ASIDE or word in self.options)]
        known = {_bare(key): key for key in self.options}
        known = {**self._by_digit, **{_bare(words): key for words, key in self._said.items()}, **known}
        words = [known.get(_bare(word), known.get(_bare(word).replace("omega", "w"), word)) for word in words]
        if len(words) == 1 and words[0] not in self.options and set(words[0].lower()) <= set(known):
            return [known[letter] for letter in words[0].lower()]
        return words

    @property
    def _said(self) -> dict[str, str]:
        """The key of each option by its words."""
        return {words.strip().lower(): key for key, words in self.options.items()}

    @property
    def _by_digit(self) -> dict[str, str]:
        """The key of each option by its digit alone, where all keys are one letter with digits of their own."""
        digits = {digit[0]: key for key in self.options if (digit := re.findall(r"\d+$", key))}
        letters = {re.sub(r"\d+$", "", key) for key in self.options}
        return digits if len(digits) == len(self.options) and len(letters) == 1 else {}

    def _keys(self) -> str:
        return ", ".join(repr(key) for key in self.options)


@dataclass(frozen=True, eq=False)
class Number:
    """A number, or several in order; exact ones are compared exactly up to rounding, one part in a million.

    Attributes:
        value: the right number or numbers.
        unit: theirs.
        labels: what each of them is.
        stated: numbers that the text gives.
        known: lengths that are given, by their letters (m): one may be missing in an answer, or stand for it.
        steps: how the numbers follow from what is given, lines of LaTeX as in `Steps`; one a number at least, "" where there is
            nothing to reckon.
        beside: what students give instead, lines of LaTeX as in `Beside`.
    """

    value: float | tuple[float, ...]
    unit: str = "–"
    labels: tuple[str, ...] = ()
    known: Mapping[str, float] = field(default_factory=dict)
    stated: tuple[float, ...] = ()
    steps: tuple[str, ...] = ()
    beside: tuple[str, ...] = ()

    @cached_property
    def way(self) -> Steps:
        """How the numbers follow from what is given."""
        return Steps(self.steps, int(np.size(self.value)))

    @property
    def is_of_counts(self) -> bool:
        """Whether whole numbers without a unit are asked."""
        return self.unit == "–" and all(float(value).is_integer() for value in np.atleast_1d(self.value).tolist())

    @property
    def derivation(self) -> Derivation:
        """The lines on the way to the numbers, which a solution opens one by one before it gives them."""
        return Derivation(tuple(Line("", latex) for latex in self.way.shown))

    def told_in(self, text: str) -> Number:
        """Return the question with the lengths that its text gives to letters."""
        known = {**values_in(text), **self.known} if self.unit in ("m", "m/s") else self.known
        known = {**known, **self.way.given}
        return replace(self, known=known, stated=() if self.is_of_counts else numbers_in_text(text))

    def is_like(self, given: np.ndarray, wrong: np.ndarray) -> bool:
        """Whether an answer is a known wrong one, which may have been rounded."""
        right = np.atleast_1d(np.array(self.value, dtype=float))
        if given.shape != wrong.shape or (given.shape == right.shape and ((given == right) & (wrong != right)).any()):
            return False
        return all(map(nearly, given.tolist(), wrong.tolist())) or all(
            map(_to_its_digits, given.tolist(), wrong.tolist())
        )

    def judge(self, answer: Any) -> Feedback:
        """Return what becomes of a number or a list of numbers."""
        right = np.atleast_1d(np.array(self.value, dtype=float))
        try:
            given = numbers_in(self._in_order(answer), self.unit, right.size)
        except AnswerError as problem:
            return Feedback(Outcome.WRONG, str(problem))
        except (TypeError, ValueError, ArmproofError):
            wanted = counted(
                "the answer is a number, not {given}",
                "the answer is a list of {number} numbers, [{places}], not {given}",
                len(right), places=", ".join("…" * len(right)), given=f"{answer!r:.40}",
            )  # fmt: skip
            return Feedback(Outcome.ERROR, wanted)
        if given.shape != right.shape:
            size = counted(
                "the answer is one number, not {given}", "the answer is {number} numbers, not {given}",
                len(right), given=len(given),
            )  # fmt: skip
            return Feedback(Outcome.WRONG, size)
        if not np.isfinite(given).all():
            return Feedback(Outcome.WRONG, look_up("not infinite: what is asked is a number"))
        wrong = ~(np.abs(given - right) <= _TOLERANCE * (1 + np.abs(right)))
        if not wrong.any():
            return Feedback(Outcome.PROVED, "")
        if all(map(_to_its_digits, given.tolist(), right.tolist())) or (
            self.unit in OF_ANGLES and _in_degrees(answer, given, right)
        ):
            return Feedback(Outcome.CONFIRMED, look_up("right, as far as the digits go"))
        if self.unit == "rad" and (less := _without_turns(given, right)) is not None and self.judge(less).is_right:
            return Feedback(Outcome.CONFIRMED, look_up("right up to whole turns"))
        told = [
            written("{label} is not {given:g}", label=self._label(k), given=float(given[k]))
            for k in np.flatnonzero(_listed(given, right, wrong)).tolist()
        ]
        labels = [self._label(k) for k in range(right.size)]
        with np.errstate(all="ignore"):
            slip = number_slip(given, right, labels, self.known, self.unit, self.stated, self.way, self.beside)
        if slip and len(told) == 1:
            return Feedback(Outcome.WRONG, written("{said}: {slip}", said=told[0], slip=slip))
        return Feedback(Outcome.WRONG, separator(told).join(told) + (look_up("; ") + slip if slip else ""))

    def _in_order(self, answer: Any) -> Any:
        """Return the numbers of a mapping, {"x": 0.25, …}, in the order in which they are asked."""
        named = {str(name).lower(): value for name, value in answer.items()} if isinstance(answer, Mapping) else {}
        labels = [label.lower() for label in self.labels]
        return [named[label] for label in labels] if named and {*named} == {*labels} else answer

    def shown(self) -> str:
        """Return the right numbers, each with what it is and how it follows from what is given, Markdown."""
        right = np.atleast_1d(np.array(self.value, dtype=float)).tolist()
        ways = (*self.way.last, *[""] * len(right))
        values = [_followed(way, value, self.unit) for value, way in zip(right, ways, strict=False)]
        if len(right) == 1:
            return values[0]
        labelled = (written("{label}: {words}", label=self._label(k), words=each) for k, each in enumerate(values))
        return "\n".join(f"- {each}" for each in labelled)

    def signature(self, answer: Any) -> np.ndarray:
        """Return the numbers, by which two answers are told apart."""
        return numbers_in(answer, self.unit, np.size(self.value))

    def _label(self, index: int) -> str:
        if index < len(self.labels):
            return self.labels[index]
        return look_up("the number") if np.ndim(self.value) == 0 else written("number {number}", number=index + 1)


def _followed(way: str, value: float, unit: str) -> str:
    """Return a number in its unit, behind the formula that gives it, in dollars."""
    shown = f"{value:.4g}"
    equal = "=" if abs(float(shown) - value) < _TOLERANCE else r"\approx"
    return (f"${way} {equal} {shown}$" if way else f"${shown}$") + (f" {unit}" if unit != "–" else "")


def _to_its_digits(given: float, right: float) -> bool:
    """Whether a number is right to three or more digits, of one that has no fewer."""
    if abs(given - right) <= _TOLERANCE * (1 + abs(right)):
        return True
    four, three = float(f"{right:.4g}"), float(f"{right:.3g}")
    if three != right and given == three and len(f"{abs(given):g}".replace(".", "").lstrip("0")) >= _THREE_DIGITS:
        return True
    return four != right and (given == four or abs(given - right) <= _FOUR_DIGITS * abs(right))


def _without_turns(given: np.ndarray, right: np.ndarray) -> np.ndarray | None:
    """Return angles without the whole turns that they have too many, one or two; None where they have none, or are in degrees."""
    turns = np.round((given - right) / (2 * np.pi))
    return given - 2 * np.pi * turns if turns.any() and np.abs(turns).max() <= _MOST_TURNS else None


def _in_degrees(answer: Any, given: np.ndarray, right: np.ndarray) -> bool:
    """Whether numbers are right to four digits, and were given in degrees, of which no whole number is a short one in radians."""
    return (
        isinstance(answer, str)
        and ("°" in answer or "deg" in answer)
        and np.allclose(given, right, rtol=_FOUR_DIGITS, atol=_TOLERANCE)
    )


def _bare(word: str) -> str:
    """Return a key or a word without what students put around it: (b), z_4 for z4, α_0 for alpha_0."""
    spelt = "".join(NAMES.get(character, character) for character in word)
    return re.sub(r"[\s_(){}\[\]\\'\".:]", "", spelt).lower()


def _listed(given: np.ndarray, right: np.ndarray, wrong: np.ndarray) -> np.ndarray:
    """Return which wrong numbers to name: where some are wrong indeed, not those that are only rounded."""
    far = wrong & wrong_numbers(given, right)
    return far if far.any() else wrong
