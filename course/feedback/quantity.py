"""A task that asks for a quantity of an arm: a pose, an origin, a Jacobian."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from functools import cache, cached_property, partial
from typing import Any

import numpy as np

from armproof.course.errors import AnswerError
from armproof.course.feedback.answer import as_latex, is_function
from armproof.course.feedback.claim import Claim, as_column, judge_formula
from armproof.course.feedback.degrees import degrees_astray
from armproof.course.feedback.hands_on import HandsOn
from armproof.course.feedback.notebook import Portrait, Shown
from armproof.course.feedback.outcome import ASKED, OF_FUNCTION, Feedback, Outcome, Row, place, said_of, told
from armproof.course.feedback.picture import call_at, draw_answer
from armproof.course.feedback.rearranged import rearranged
from armproof.course.feedback.relation import (
    Letters,
    Said,
    Values,
    but_there,
    first_said,
    letter_at_fault,
    letters_astray,
    letters_astray_in_each,
    random_values,
    relation,
    remembered,
    squares_astray,
)
from armproof.course.feedback.rest import told_of_the_rest
from armproof.course.feedback.slips_by_value import slips_by_value
from armproof.course.feedback.terms import terms_astray
from armproof.course.feedback.wholes import no_rotation, part_astray, planar_astray
from armproof.models.arm import Arm
from armproof.models.catalogue import load_arm
from armproof.models.errors import ArmproofError, written
from armproof.models.language import look_up, noted
from armproof.verification.algebra.quantity_kinds import kind_of
from armproof.verification.errors import ShapeError
from armproof.verification.findings import Kind
from armproof.verification.findings.finding import write_all
from armproof.verification.functions import check_function
from armproof.verification.functions.arguments import read_layout
from armproof.verification.functions.asked import read_asked
from armproof.verification.functions.function_check import FunctionVerdict
from armproof.verification.functions.guarded_call import Guard
from armproof.verification.functions.latex import write_matrix
from armproof.verification.functions.returned import NotAttempted
from armproof.verification.functions.traced_function import trace_function
from armproof.verification.latex.writer import symbol_as_latex

FEW = 8  # samples by which two answers are told apart
SECONDS = 2.0  # that a function may run
MANY = 32  # by which the relation of a wrong answer to the right one is found
NOT_DRAWN = noted("`{task}`: only a function that gives a pose, an origin or a Jacobian can be drawn.")
NOTHING_YET = noted("`{task}`: no answer yet, nothing to draw.")
_LONGEST = 1500  # characters of an answer in which slips and terms are sought
_OF_PRODUCTS = {Kind.LINKS_SWAPPED, Kind.LINKS_OF_ROW_BELOW, Kind.LINKS_OF_ROW_ABOVE}
_OF_SUMS = {Kind.WRONG_LINK, Kind.FIRST_WRONG_LINK, Kind.ANGLES_SUMMED_TWICE, Kind.JOINT_SUMMED}  # of skew axes, too
_FEW_ENTRIES = 3
_USUAL = (0.5, -0.9, 1.1, 0.7, -0.6, 0.8)  # rad; of a slide a third of it, in metres


def _has_another_reading(feedback: Feedback) -> bool:
    """Whether products of links are said to be wrong where a few entries are, as if nobody had multiplied any."""
    kinds = {found.kind for found in feedback.findings}
    return 0 < len(feedback.rows) <= _FEW_ENTRIES and bool(kinds) and kinds <= _OF_PRODUCTS


@dataclass(frozen=True, eq=False)
class Quantity:
    """A quantity of an arm, as a document's front matter writes it.

    Attributes:
        arm: the name of an arm, or a DH table as in a document's front matter.
        quantity: {"pose": 4}, {"jacobian": 4, "rows": [1, 2, 3]}, …
        symbols: letters that an answer in LaTeX may use for the arm's.
        transforms: which index of T^i_j names the reference frame in such an answer.
        names: whether an answer may name other quantities of the arm (a product of link matrices).
    """

    arm: Any
    quantity: Mapping[str, Any]
    symbols: Mapping[str, str] = field(default_factory=dict)
    transforms: str = "upper"
    names: bool = False

    @cached_property
    def loaded(self) -> Arm:
        """The arm."""
        return load_arm(self.arm)

    @cached_property
    def claim(self) -> Claim:
        """What a formula is compared with."""
        front = {
            "arm": self.arm,
            "symbols": dict(self.symbols),
            "transforms": self.transforms,
            "quantities": {ASKED: dict(self.quantity)},
        }
        (asked,) = read_asked(self.loaded, self.quantity)
        kind = kind_of(asked.quantity)
        return Claim(front, unit=partial(kind.unit, asked.quantity, self.loaded), names=self.names)

    def judge(self, answer: Any, known: Callable[[], str] = str) -> Feedback:
        """Return what becomes of an answer: a function of the joint values, or a formula.

        Args:
            known: what is said of it where it is a known wrong one: then nothing else is sought.
        """
        if not is_function(answer) and (column := self.claim.upright(row := as_latex(answer))) != row:
            return as_column(self.judge(column, known))
        feedback = self._judge_function(answer) if is_function(answer) else judge_formula(self.claim, answer)
        if feedback.outcome is not Outcome.WRONG:
            return feedback
        if feedback.findings and not is_function(answer) and (unknown := self.claim.unbound(as_latex(answer))):
            return Feedback(Outcome.ERROR, unknown)
        if known():
            return feedback
        answer, was_function = self._readable(answer), is_function(answer)
        if words := (self._rearranged(answer) if feedback.is_piecemeal else "") or self._as_a_whole(answer, feedback):
            return replace(feedback, message=words, findings=())
        if feedback.is_general and was_function and (formula := self._as_formula(answer)) is not None:
            feedback = replace(feedback, message=formula.message, findings=formula.findings)
        if feedback.is_general and (words := self._relation(answer)):
            feedback = replace(feedback, message=words)
        words = self._relation(answer) if _has_another_reading(feedback) else ""
        told = replace(feedback, message=words) if words else feedback
        told = told_of_the_rest(told, self._shape, partial(self._relation, answer))
        return replace(told, message=told.message + look_up("; or: ") + feedback.message) if words else told

    def _readable(self, answer: Any) -> Any:
        """Return a function as LaTeX where it can be traced and read: that has its values many times quicker."""
        if not is_function(answer):
            return answer
        try:
            latex = self._written(answer)
            self.claim.values_over(latex, self._letters)
        except ArmproofError:
            return answer
        return latex

    def _as_a_whole(self, answer: Any, feedback: Feedback) -> str:
        """Return what the answer is instead: a part of what is asked; that of a planar arm, no rotation where no one mistake explains it."""
        try:
            at = self._letters
            asked, given = partial(self.claim.values_over, ASKED), partial(self._values_over, answer)
            if (true := asked(at)).shape != (obtained := given(at)).shape:
                return part_astray(true, obtained)
            lengths = {name: np.full(MANY, value) for name, value in self.loaded.lengths.items()}  # in numbers, perhaps
            if words := degrees_astray(self.claim, self._written(answer), {**at, **lengths}):
                return words
            is_of_sums = any(found.kind in _OF_SUMS for found in feedback.findings)
            if (feedback.is_piecemeal or is_of_sums) and (words := planar_astray(self.loaded, asked, given, at)):
                return words
            return no_rotation(true, obtained) if feedback.is_general else ""
        except ArmproofError:
            return ""

    def _rearranged(self, answer: Any) -> str:
        """Return which rows or columns are exchanged, and what is wrong besides."""
        try:
            true, obtained = self.claim.values_over(ASKED, self._letters), self._values_over(answer, self._letters)
            return rearranged(self.claim, self._written(answer), true, obtained, self.judge)
        except ArmproofError:
            return ""

    @property
    def _letters(self) -> Letters:
        """Values of joints and lengths; of lengths at random, since two of an arm's may be equal, or four times each other."""
        joints = {joint.symbol: q for joint, q in zip(self.loaded.joints, self.claim.samples.q[:MANY].T, strict=True)}
        return {**joints, **random_values([*self.loaded.lengths], MANY)}

    def _as_formula(self, answer: Any) -> Feedback | None:
        """Return what is said of a function's result as a formula, in which slips are looked for entry by entry; None where no slip is found."""
        try:
            feedback = self.claim.judge(self._written(answer))
        except ArmproofError:
            return None
        return None if feedback.is_general or feedback.outcome is not Outcome.WRONG else feedback

    def _written(self, answer: Any) -> str:
        """Return an answer as LaTeX, of a function what it gives for letters."""
        if not is_function(answer):
            return as_latex(answer)
        layout = read_layout(self.loaded, answer)
        passed = [symbol for symbol in layout.lengths if symbol not in layout.defaults]

        def call(function: Callable[..., Any], make: Callable[[str], Any]) -> Any:
            positional, named = layout.arguments(make, passed)
            return function(*positional, **named)

        with Guard(SECONDS) as guard:
            traced = guard.call(lambda: write_matrix(np.array(trace_function(answer, call), dtype=object)))
        if traced.error is not None:
            raise AnswerError("the answer has no values")
        return str(traced.value)

    def _relation(self, answer: Any, only: np.ndarray | None = None) -> str:
        """Return how an answer with no known slip relates to what is asked, in its letters and in values; of some entries alone."""
        try:
            return first_said(self._relations(answer, only))
        except ShapeError as problem:  # c_{23} of an arm without an angle 3
            return str(problem)
        except ArmproofError:
            return ""

    def _relations(self, answer: Any, only: np.ndarray | None) -> Iterator[Said]:
        """Yield the relations."""
        at = self._letters
        asked: Values = remembered(partial(self.claim.values_over, ASKED))
        given: Values = remembered(partial(self._values_over, answer))
        if only is not None:
            given = partial(but_there, asked, given, only)
        true, obtained = asked(at), given(at)
        if true.shape == obtained.shape:
            yield partial(letters_astray, asked, given, at)
            yield partial(relation, true, obtained, self._factors(at))
            yield partial(letters_astray_in_each, asked, given, at)
            latex = cache(lambda: self._written(answer))
            if len(latex()) <= _LONGEST:
                yield lambda: slips_by_value(self.claim, latex(), at, only=only)
                yield lambda: terms_astray(self.claim, latex(), at, only)
            yield partial(squares_astray, true, obtained, self._factors(at))
            yield partial(letter_at_fault, asked, given, at)

    def _factors(self, at: Letters) -> Letters:
        """Return what may be a factor too many: lengths, the way of a slide, sines and cosines of the joints' angles."""
        turning = {joint.symbol: at[joint.symbol] for joint in self.loaded.joints if joint.kind == "revolute"}
        factors = {symbol_as_latex(symbol): values for symbol, values in at.items() if symbol not in turning}
        for symbol, q in turning.items():
            factors |= {f"sin {symbol_as_latex(symbol)}": np.sin(q), f"cos {symbol_as_latex(symbol)}": np.cos(q)}
        return factors

    def _values_over(self, answer: Any, at: Letters) -> np.ndarray:
        """Return an answer at values of joints and lengths."""
        if not is_function(answer):
            return self.claim.values_over(as_latex(answer), at)
        rows = zip(*(values.tolist() for values in at.values()), strict=True)
        found = np.array([call_at(self.loaded, answer, dict(zip(at, row, strict=True))) for row in rows])
        shape = self._shape
        return found.reshape(len(found), *shape) if found[0].size == np.prod(shape) else found

    @cached_property
    def _shape(self) -> tuple[int, ...]:
        """The rows and columns of what is asked."""
        return self.claim.values(ASKED).shape[1:]

    def signature(self, answer: Any) -> np.ndarray:
        """Return the values of an answer at the samples, by which two answers are told apart."""
        return self._values(answer, FEW)

    def _values(self, answer: Any, count: int) -> np.ndarray:
        if not is_function(answer):
            return self.claim.values(as_latex(answer))[:count]
        at = [dict(zip(self._symbols, row, strict=True)) for row in self.claim.samples.q[:count].tolist()]
        return np.array([call_at(self.loaded, answer, each) for each in at])

    def show(self, task: str, function: Any, at: Mapping[str, float]) -> Shown | Portrait:
        """Return what a function gives drawn over the arm, or a polite sentence why it is not.

        Args:
            task: what the answer is called.
            at: values of joints; every joint that is not named has one of its own, none of them zero.
        """
        if not is_function(function):
            return Shown(written(NOT_DRAWN, task=task))
        joints = {joint.symbol: joint for joint in self.loaded.joints}
        if unknown := sorted(set(at) - set(joints)):
            raise AnswerError("no joint '{joint}'; the joints are {joints}", joint=unknown[0], joints=list(joints))
        usual = {
            symbol: value if joint.kind == "revolute" else abs(value) / 3
            for (symbol, joint), value in zip(joints.items(), _USUAL, strict=False)
        }
        at = {**usual, **at}
        try:
            call_at(self.loaded, function, at)
        except NotAttempted:
            return Shown(written(NOTHING_YET, task=task))
        except ArmproofError as problem:
            return Shown(written("`{task}`: the answer cannot be drawn: {reason}", task=task, reason=str(problem)))
        figure = draw_answer(self.loaded, self.quantity, function, at)
        if figure is None:
            return Shown(written("`{task}`: this answer cannot be drawn: it is no pose, point or Jacobian in the base frame.", task=task))  # fmt: skip
        return Portrait((figure,))

    def move(self, answer: Any, in_3d: bool, lang: str) -> HandsOn:
        """Return the arm with its sliders, and the answer, a function or a formula, over it."""
        if answer is None:
            return HandsOn(self.loaded, in_3d=in_3d, lang=lang)
        if is_function(answer):
            return HandsOn(self.loaded, self.quantity, partial(call_at, self.loaded, answer), in_3d, lang)
        return HandsOn(self.loaded, self.quantity, partial(self.claim.values_at, as_latex(answer)), in_3d, lang)

    @cached_property
    def _symbols(self) -> list[str]:
        return [joint.symbol for joint in self.loaded.joints]

    def _judge_function(self, function: Callable[..., Any]) -> Feedback:
        check = check_function(self.loaded, function, dict(self.quantity))
        rows = tuple(Row(place(row.row, row.column), row.expected, row.obtained, row.unit) for row in check.table)
        is_wrong = check.verdict is FunctionVerdict.REFUTED
        findings = told(check.findings, check.entries) if is_wrong else check.findings
        message = said_of(findings) if is_wrong else write_all(findings)
        picture = None
        if not check.is_right and check.counterexample:
            picture = draw_answer(self.loaded, self.quantity, function, check.counterexample)
        return Feedback(
            OF_FUNCTION[check.verdict], message, rows, check.counterexample, picture,
            check.notes, check.error, check.printed, findings=findings,
        )  # fmt: skip
