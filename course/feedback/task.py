"""A task of a lesson: what it asks, the ladder of hints, the right answers, and the wrong ones that are known."""

from __future__ import annotations

import inspect
import textwrap
import time
from collections.abc import Callable, Hashable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cache, lru_cache
from typing import Any, Protocol

import numpy as np

from armproof.course.errors import AnswerError
from armproof.course.feedback.answer import WithSympy, as_latex, is_function, is_missing
from armproof.course.feedback.choice import Number
from armproof.course.feedback.derivation import Derivation
from armproof.course.feedback.formula import Formula
from armproof.course.feedback.hands_on import HandsOn
from armproof.course.feedback.notebook import Portrait, Shown
from armproof.course.feedback.outcome import Feedback, Outcome, nothing, pretty
from armproof.course.feedback.quantity import NOT_DRAWN, NOTHING_YET, Quantity
from armproof.course.feedback.rest import with_the_rest
from armproof.models.errors import ArmproofError, written
from armproof.models.language import look_up, number_text, separator, use


class Question(Hashable, Protocol):
    """What a task asks."""

    def judge(self, answer: Any) -> Feedback:
        """Return what becomes of an answer."""

    def signature(self, answer: Any) -> Any:
        """Return an array or a text by which two answers are told apart, whatever their form."""


@dataclass(frozen=True, eq=False)
class Wrong:
    """A wrong answer that students give.

    Attributes:
        answer: in any of the forms.
        words: what the feedback on it says, at least in part.
        own: whether `words` is the sentence to be shown for every answer that is equal to this one; without it the general
            diagnosis finds the words.
    """

    answer: Any
    words: str
    own: bool = False


@dataclass(eq=False)
class Task:
    """A task.

    Attributes:
        name: its name in the lesson, a Python identifier.
        title: in a few words.
        text: what is asked, as Markdown with mathematics between dollars.
        asks: a Quantity, Formula, Table, Number or Choice.
        hints: a ladder, from a nudge to nearly the answer.
        right: right answers in several forms; the first is the solution that is shown.
        wrong: wrong answers, from real mistakes.
        derivation: the way to the solution, line by line.
        own: makes the task of a seed, with numbers of its own; see `drawn`.
        numbers: those numbers, by their letters (m).
        usual: makes the task with the numbers that the lesson prints, where this one has others.
        printed: what the lesson prints for a seed, by what it prints usually.
        lesson, lang: the name of its lesson and its language, given when the lesson takes it.
    """

    name: str
    title: str
    text: str
    asks: Question
    hints: tuple[str, ...]
    right: tuple[Any, ...]
    wrong: tuple[Wrong, ...] = ()
    derivation: Derivation = field(default_factory=Derivation)
    own: Callable[[str], Task] | None = None
    numbers: Mapping[str, float] = field(default_factory=dict)
    usual: Callable[[], Task] | None = None
    printed: Mapping[str, str] = field(default_factory=dict)
    lesson: str = ""
    lang: str = ""
    on_feedback: Callable[[Feedback], None] = field(default=lambda feedback: None, repr=False)
    was_tried: Callable[[], bool] = field(default=lambda: False, repr=False)
    _opened: int = field(default=0, repr=False)
    _given: int = field(default=0, repr=False)
    _is_tried: bool = field(default=False, repr=False)
    _tried: dict[str, None] = field(default_factory=dict, repr=False)

    def check(self, answer: Any = ...) -> Feedback:
        """Return what becomes of an answer: a function, a SymPy expression, LaTeX, numbers; `...` is no answer yet."""
        started = time.perf_counter()
        with use(self.lang):
            feedback = self._in_stages(self._judge(answer))
        seconds = time.perf_counter() - started
        self._is_tried |= feedback.outcome is not Outcome.NOT_ATTEMPTED
        feedback = replace(feedback, task=self.name, lesson=self.lesson, lang=self.lang, seconds=seconds)
        self.on_feedback(feedback)
        return feedback

    def _in_stages(self, feedback: Feedback) -> Feedback:
        """Hold the values expected back until a second answer is wrong, and say what helps on."""
        own = self._own_numbers()
        if feedback.outcome is not Outcome.WRONG:
            return feedback if feedback.is_right else replace(feedback, advice=own)
        self._tried[repr((feedback.message, feedback.rows))] = None  # the same answer again is no second try
        is_first = len(self._tried) == 1
        held = look_up("The values expected are shown at your next answer.") if is_first and feedback.rows else ""
        return replace(feedback, is_first=is_first, advice=" ".join(filter(None, [own, held, self._way_on()])))

    def _own_numbers(self) -> str:
        if not self.numbers:
            return ""
        values = [f"{name} = {number_text(value, 'g')}" for name, value in self.numbers.items()]
        return written("Your numbers (m): {values}.", values=pretty(separator(values).join(values)))

    def _way_on(self) -> str:
        if self._given < len(self.hints):
            return written("`lesson.{task}.hint()` gives a hint.", task=self.name)
        return written("`lesson.{task}.solution()` shows the solution.", task=self.name)

    def hint(self) -> Shown:
        """Return the next hint of the ladder; after the last one, the last again."""
        index = min(self._given, len(self.hints) - 1)
        self._given += 1
        with use(self.lang):
            if index < 0:
                return Shown(look_up("There is no hint for this task."))
            last = written(" There are no more; `lesson.{task}.solution()` shows the answer.", task=self.name)
            more = last if index + 1 == len(self.hints) else ""
            head = written("**Hint {number} of {count}.**", number=index + 1, count=len(self.hints))
        return Shown(f"{head} {self.hints[index]}{more}")

    def solution(self) -> Shown:
        """Return the derivation, one line more at each call, then the solution; nothing before an answer was tried."""
        with use(self.lang):
            if not (self._is_tried or self.was_tried()):
                return Shown(written("Try an answer first: `lesson.{task}.check(…)`. Then the solution opens.", task=self.name))  # fmt: skip
            self._opened += 1
            derivation = self.asks.derivation if isinstance(self.asks, Number) else self.derivation
            count, lines = self._opened, len(derivation.lines)
            shown = derivation.opened(count)
            if count < lines:
                more = written("Line {number} of {count}. Can you go on? If not: `lesson.{task}.solution()`.", number=count, count=lines, task=self.name)  # fmt: skip
                return Shown(f"{shown}\n\n{more}")
            return Shown("\n\n".join([shown, *self._answer()] if shown else self._answer()))

    def _answer(self) -> list[str]:
        """Return the first of the right answers, and the first formula among them."""
        parts = [written("**{title}: solution.**", title=self.title)]
        if isinstance(self.asks, Number):
            return [*parts, self.asks.shown()]
        functions = [answer for answer in self.right if is_function(answer)]
        formulas = [answer for answer in self.right if isinstance(answer, str)]
        if formulas and not hasattr(self.asks, "options"):
            parts.append(f"$$ {as_latex(formulas[0])} $$")
        if functions:
            parts.append(f"```python\n{textwrap.dedent(inspect.getsource(functions[0])).strip()}\n```")
        return parts if len(parts) > 1 else [*parts, f"`{self.right[0]!r}`"]

    def show(self, answer: Any = ..., **at: float) -> Shown | Portrait:
        """Return the answer drawn over the arm as Drake has it, at a configuration given by joint symbols; or why it is not.

        Every joint that is not named has a value of its own, none of them zero.
        """
        with use(self.lang):
            if is_missing(answer):
                return Shown(written(NOTHING_YET, task=self.name))
            if (show := getattr(self.asks, "show", None)) is None:
                return Shown(written(NOT_DRAWN, task=self.name))
            try:
                shown: Shown | Portrait = show(self.name, answer, at)
            except AnswerError as problem:
                return Shown(written("`{task}`: the answer cannot be drawn: {reason}", task=self.name, reason=problem))
            return shown

    def move(self, answer: Any = ..., *, in_3d: bool = False) -> Shown | HandsOn:
        """Return the arm with a slider a joint: the answer beside the truth, what the tool can do there, and det J.

        Args:
            in_3d: whether Drake's Meshcat viewer shows the arm too.
        """
        if isinstance(self.asks, Quantity):
            return self.asks.move(None if is_missing(answer) else answer, in_3d, self.lang)
        with use(self.lang):
            return Shown(written(NOT_DRAWN, task=self.name))

    def _judge(self, answer: Any) -> Feedback:
        if isinstance(answer, WithSympy):
            answer = answer.value()
        if is_missing(answer):
            return nothing()
        asks, own = self._asked(), cache(lambda: self._own_words(answer))
        try:
            feedback = asks.judge(answer, own) if isinstance(asks, Formula | Quantity) else asks.judge(answer)
        except AnswerError as problem:
            return Feedback(Outcome.ERROR, str(problem))
        if feedback.outcome in (Outcome.WRONG, Outcome.LETTERS) and own():
            return replace(feedback, message=own())
        if feedback.outcome is Outcome.WRONG and isinstance(asks, Number) and self.usual is not None and self.usual().asks.judge(answer).is_right:  # fmt: skip
            return replace(feedback, message=look_up("right with the numbers that the lesson prints: yours are others"))
        return with_the_rest(feedback)

    def _asked(self) -> Question:
        """Return the question, which may have to know values that the text gives."""
        return self.asks.told_in(self.text) if isinstance(self.asks, Number) else self.asks

    def _own_words(self, answer: Any) -> str:
        """Return the sentence of the known wrong answer that this one is equal to."""
        own = [wrong for wrong in self.wrong if wrong.own]
        if not own:
            return ""
        try:
            given = self.asks.signature(answer)
        except ArmproofError:
            return ""
        known = [(_signature_of(self.asks, wrong), wrong.words) for wrong in own]
        exact = [words for signature, words in known if _are_equal(given, signature)]
        if not exact and isinstance(self.asks, Number):
            exact = [words for signature, words in known if self.asks.is_like(given, signature)][:1]
        return look_up("; or: ").join(dict.fromkeys(exact)) or self._several(given, known)

    def _several(self, given: Any, known: Sequence[tuple[Any, str]]) -> str:
        """Return the sentences of known wrong answers of which each is wrong elsewhere, and that together make this one."""
        if (
            not self.right
            or not isinstance(given, np.ndarray)
            or not isinstance(self.asks, Number | Formula | Quantity)
        ):
            return ""
        right, given = _entries(_signature_of(self.asks, Wrong(self.right[0], ""))), _entries(given)
        if right is None or given is None or right.shape != given.shape or right.shape[1] < 2:
            return ""
        left, told = _differing(given, right), []
        for signature, words in known:
            other = _entries(signature)
            if other is not None and other.shape == given.shape:
                wrong = _differing(other, right)
                if wrong.any() and (wrong <= left).all() and not (wrong & _differing(given, other)).any():
                    told.append(words)
                    left = left & ~wrong
        if told and left.any() and isinstance(self.asks, Number) and not np.array_equal(np.sort(given), np.sort(right)):
            told.append(self.asks.judge(np.where(left, given, right)[0]).message)
            left &= False
        return look_up("; ").join(told) if told and not left.any() else ""

    def __repr__(self) -> str:
        return f"{self.title}\n\n{self.text}\n\nlesson.{self.name}.check(answer), .hint(), .solution()"

    def _repr_markdown_(self) -> str:
        end = "" if self.title.endswith(("?", "!")) else "."
        return f"**{self.title}{end}** {self.text}"


@lru_cache(maxsize=4096)
def _signature_of(asks: Question, wrong: Wrong) -> Any:
    try:
        return asks.signature(wrong.answer)
    except ArmproofError:
        return None


def _entries(signature: Any) -> np.ndarray | None:
    """Return the numbers of a signature, (samples, entries); None of a text."""
    if not isinstance(signature, np.ndarray) or not signature.size:
        return None
    return signature.reshape(1 if signature.ndim == 1 else len(signature), -1)


def _differing(one: np.ndarray, other: np.ndarray) -> np.ndarray:
    """Return which entries differ at any sample."""
    return np.asarray((~np.isclose(one, other, rtol=1e-8, atol=1e-9, equal_nan=True)).any(axis=0))


def _are_equal(one: Any, other: Any) -> bool:
    if isinstance(one, np.ndarray) and isinstance(other, np.ndarray):
        return one.size == other.size and np.allclose(one.ravel(), other.ravel(), rtol=1e-8, atol=1e-9, equal_nan=True)
    return type(one) is type(other) and bool(one == other)
