"""A task that asks for a formula in named letters: a link matrix, a determinant, one joint of an inverse, a coefficient."""

from __future__ import annotations

import inspect
import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from functools import cache, cached_property, partial
from itertools import combinations
from typing import Any

import numpy as np

from armproof.course.errors import AnswerError, LessonError
from armproof.course.feedback.answer import as_latex, is_function
from armproof.course.feedback.claim import ANGLE, Claim, as_column, judge_formula
from armproof.course.feedback.degrees import degrees_astray
from armproof.course.feedback.outcome import ASKED, Feedback, Outcome, Row, nothing, place
from armproof.course.feedback.rearranged import rearranged
from armproof.course.feedback.relation import (
    COSINE_SIGN,
    HALF_TURN,
    NO_QUADRANT,
    NUMBER_UPSIDE_DOWN,
    SINE_ALONE,
    Letters,
    Said,
    Values,
    angle_astray,
    axis_astray,
    but_there,
    factors_astray,
    first_said,
    inverse_astray,
    letter_at_fault,
    letters_astray,
    letters_astray_in_each,
    letters_exchanged,
    random_values,
    relation,
    remembered,
    same,
    squares_astray,
    transform_astray,
    units_astray,
    wrong_entries,
)
from armproof.course.feedback.rest import has_place, told_of_the_rest
from armproof.course.feedback.rule_slips import arguments_exchanged, roots_astray
from armproof.course.feedback.slips_by_value import slips_by_value
from armproof.course.feedback.terms import terms_astray
from armproof.course.feedback.wholes import part_astray
from armproof.models.errors import ArmproofError, counted, written
from armproof.models.language import look_up
from armproof.verification.errors import ShapeError
from armproof.verification.findings import Kind, say
from armproof.verification.functions.guarded_call import CallError, Guard
from armproof.verification.functions.latex import write_matrix
from armproof.verification.functions.returned import NotAttempted, NotNumbers, read_returned
from armproof.verification.functions.traced_function import trace_function
from armproof.verification.naming.reading import FREE

SECONDS = 2.0  # that a function may run
FEW = 8  # samples by which two answers are told apart
_LONG = 400  # characters of a formula
_TOLERANCE = 1e-9
_OF_ARCS = (  # what is said of an arc function whatever quadrant the samples are in, for what is true of them
    (r"\\arcsin|asin", COSINE_SIGN, SINE_ALONE),
    (r"\\arctan(?!2)|atan(?!2)", HALF_TURN, NO_QUADRANT),
)
_TIME = re.compile(r"t(_|$)")


@dataclass(frozen=True, eq=False)
class Formula:
    """A formula, a scalar or a matrix.

    Attributes:
        latex: the right one; with an arm it may name the arm's quantities, `\\det J_v`.
        arguments: the letters it is made of, in the order in which a function takes them.
        arm: the arm whose joints, lengths and quantities the letters are; none for a general formula.
        given: names with a meaning, such as {"D": r"\\frac{…}{…}"}; an answer may use them, and a function takes those that
            stand among the arguments as they are.
        quantities, symbols, transforms: as in a document's front matter.
        unit: of the entries.
        names: whether an answer may name quantities of the arm.
        cases: values of the letters that a student can imagine, at which a wrong answer is shown.
    """

    latex: str
    arguments: tuple[str, ...]
    arm: Any = None
    given: Mapping[str, str] = field(default_factory=dict)
    quantities: Mapping[str, Any] = field(default_factory=dict)
    symbols: Mapping[str, str] = field(default_factory=dict)
    transforms: str = "upper"
    unit: str = "–"
    names: bool = False
    cases: tuple[Mapping[str, float], ...] = ()

    @cached_property
    def claim(self) -> Claim:
        """What an answer is compared with."""
        front: dict[str, Any] = {"transforms": self.transforms, "quantities": dict(self.quantities)}
        if self.arm is not None:
            front["arm"] = self.arm
        front["symbols"] = {**self._free(), **self.symbols}
        given = tuple(f"{_as_latex(name)} = {value}" for name, value in self.given.items())
        aliases = [name for name, symbol in self.symbols.items() if symbol != FREE]
        own = tuple(dict.fromkeys([*self.arguments, *self.given, *aliases]))
        return Claim(front, given, self.latex, lambda row, column: self.unit, self.names, own, self.cases)

    def _free(self) -> dict[str, str]:
        """Bind each argument that is no symbol of the arm as a free letter."""
        from armproof.models.catalogue import load_arm

        arm = load_arm(self.arm) if self.arm is not None else None
        known = {joint.symbol for joint in arm.joints} | {*arm.lengths, *arm.angles} if arm is not None else set()
        return {name: FREE for name in self.arguments if name not in known and name not in self.given}

    def judge(self, answer: Any, known: Callable[[], str] = str) -> Feedback:
        """Return what becomes of an answer: a function of the arguments, or a formula.

        Args:
            known: what is said of it where it is a known wrong one: then nothing else is sought.
        """
        if not is_function(answer) and (column := self.claim.upright(row := self._as_latex(answer))) != row:
            return as_column(self.judge(column, known))
        feedback = (
            self._judge_function(answer)
            if is_function(answer)
            else self._judge_latex(
                self._as_latex(answer),
                judge_formula(self.claim, self._as_latex(answer) if isinstance(answer, str) else answer),
            )
        )
        is_read = feedback.outcome is Outcome.WRONG and feedback.findings and not is_function(answer)
        if is_read and (unknown := self.claim.unbound(self._as_latex(answer))):
            return Feedback(Outcome.ERROR, unknown)
        if not is_function(answer) and feedback.is_piecemeal and (spread := self.claim.spread(self._as_latex(answer))):
            in_cells = self.judge(spread, known)
            return in_cells if in_cells.outcome is Outcome.WRONG else feedback
        if feedback.outcome is Outcome.WRONG and not known():
            feedback = self._related(self._readable(answer), feedback)
        if feedback.at and set(self.given) & set(self.arguments):
            return replace(feedback, at=self._at_arguments(feedback.at))
        return feedback

    def _related(self, answer: Any, feedback: Feedback) -> Feedback:
        """Return feedback that says how a wrong answer relates to what is asked, where no one mistake explains it."""
        if (
            words := self._as_part(answer)
            or self._in_degrees_within(answer)
            or self._of_inverse(answer, feedback.is_general)
        ):
            feedback = replace(feedback, message=words, findings=())
        if feedback.is_piecemeal and (
            words := self._rearranged(answer) or self._exchanged(answer) or self._multiplied(answer, feedback)
        ):
            feedback = replace(feedback, message=words, findings=())
        if any(found.kind is Kind.WRONG_NUMBER for found in feedback.findings) and (words := self._of_a_number(answer)):
            feedback = replace(feedback, message=words, findings=())
        if feedback.is_general and (words := self._relation(answer)):
            feedback = replace(feedback, message=words)
        return told_of_the_rest(feedback, self._true.shape[1:], partial(self._relation, answer))

    def _readable(self, answer: Any) -> Any:
        """Return a function as LaTeX where it can be traced and read: that has its values many times quicker."""
        if not is_function(answer):
            return answer
        try:
            latex = self._written(answer)
            self.claim.values_over(latex, random_values(self.arguments, FEW))
        except ArmproofError:
            return answer
        return latex

    def _as_latex(self, answer: Any) -> str:
        """Return an answer as LaTeX; in a text typed as in Python px is p_x, where p x can be no product of the task's letters."""
        if not isinstance(answer, str) or "\\" in answer:
            return as_latex(answer)
        bare = {name.replace("_", ""): name for name in self.arguments if "_" in name and not name[-1].isdigit()}
        bare = {short: name for short, name in bare.items() if not {*short} <= {*self.arguments}}
        return as_latex(re.sub(r"(?<![\w\\])[A-Za-z]+(?!\w)", lambda found: bare.get(found[0], found[0]), answer))

    def _judge_latex(self, latex: str, feedback: Feedback) -> Feedback:
        """Return what becomes of a formula: of angles, whole turns too many are no mistake, once they are taken away and it is proved."""
        if feedback.outcome is not Outcome.WRONG or self.unit != "rad" or not (turns := self._whole_turns(latex)):
            return feedback
        less = self.claim.judge(f"{latex} - {turns}")
        return replace(less, notes=(*less.notes, look_up("right up to whole turns"))) if less.is_right else feedback

    def _whole_turns(self, latex: str) -> str:
        """Return the turns that an answer has too many, as LaTeX; empty where it differs by anything else."""
        true, obtained = self._true, self.claim.values(latex)
        if true.shape != obtained.shape:
            return ""
        turns = (obtained - true)[self._with_value] / (2 * np.pi)
        if not np.isfinite(turns).all() or np.ptp(turns, axis=0).max() > _TOLERANCE:
            return ""
        whole = np.round(turns[0]).astype(int)
        if not whole.any() or np.abs(turns[0] - whole).max() > _TOLERANCE:
            return ""
        rows = r" \\ ".join(" & ".join(rf"{2 * turn}\pi" for turn in row) for row in whole.tolist())
        return rf"\begin{{bmatrix}} {rows} \end{{bmatrix}}" if whole.size > 1 else f"({rows})"

    def _at_arguments(self, at: Mapping[str, float]) -> Mapping[str, float]:
        """Return the values of the arguments where a counterexample has those of the joints that give them."""
        if set(at) == set(self.arguments):
            return at
        try:
            return {name: float(self.claim.values_at(_as_latex(name), at)[0, 0]) for name in self.arguments}
        except ArmproofError:
            return at

    def signature(self, answer: Any) -> np.ndarray:
        """Return the values of an answer at the samples, by which two answers are told apart; angles within one turn."""
        values = self._values_of(answer)
        return values - 2 * np.pi * np.round(values / (2 * np.pi)) if self.unit == "rad" else values

    def _values_of(self, answer: Any) -> np.ndarray:
        if not is_function(answer):
            return self.claim.values(self._as_latex(answer))[:FEW]
        answer = self._in_order(answer)
        with Guard(SECONDS) as guard:
            calls = [guard.call(lambda k=k: answer(*self._arguments(k))) for k in range(FEW)]  # type: ignore[misc]
        if any(call.error is not None for call in calls):
            raise AnswerError("the answer has no values")
        return np.array([read_returned(call.value, 1)[0] for call in calls])

    # -- relations -----------------------------------------------------------------------------------------------------

    def _as_part(self, answer: Any) -> str:
        """Return which part of what is asked an answer of another size is."""
        try:
            given = (
                self._called(answer) if is_function(answer) else partial(self.claim.values_over, self._as_latex(answer))
            )
            drawn = {name: values[:FEW] for name, values in self._drawn.items()}
            return part_astray(self.claim.values_over(ASKED, drawn), given(drawn))
        except ArmproofError:
            return ""

    def _in_degrees_within(self, answer: Any) -> str:
        """Return that a number of degrees stands in a sine or cosine."""
        try:
            return degrees_astray(self.claim, self._written(answer), random_values(self.arguments))
        except ArmproofError:
            return ""

    def _of_inverse(self, answer: Any, origin_alone: bool) -> str:
        """Return about which axis a rotation turns, or which parts of a transform are those of its inverse: what entry by entry is many slips."""
        try:
            true, obtained = (
                self._true[:FEW],
                self._values_of(answer) if self._true[0].size in (4, 9, 16) else np.zeros(0),
            )
            if obtained.size != true.size:
                return ""
            obtained = obtained.reshape(true.shape)
            return (
                transform_astray(true, obtained, origin_alone)
                or axis_astray(true, obtained)
                or inverse_astray(true, obtained)
            )
        except ArmproofError:
            return ""

    def _rearranged(self, answer: Any) -> str:
        """Return which rows or columns are exchanged, and what is wrong besides."""
        try:
            true, obtained = self._true[:FEW], self._values_of(answer)
            if obtained.size != true.size or true[0].size == 1:
                return ""
            return rearranged(self.claim, self._written(answer), true, obtained.reshape(true.shape), self.judge)
        except ArmproofError:
            return ""

    def _exchanged(self, answer: Any) -> str:
        """Return which two letters are exchanged in several wrong entries, or which factor is missing, where that explains them all."""
        try:
            at = random_values(self.arguments)
            given = self._called(answer) if is_function(answer) else partial(self.claim.values_over, self._as_latex(answer))  # fmt: skip
            asked = partial(self.claim.values_over, ASKED)
            wrong = wrong_entries(asked(at), given(at))
            if wrong.sum() < 2:
                return ""
            return letters_exchanged(asked, given, at, wrong) or factors_astray(asked, given, at)
        except (ArmproofError, ValueError):
            return ""

    def _multiplied(self, answer: Any, feedback: Feedback) -> str:
        """Return what all entries are too large or too small by, where that is one factor for all: entry by entry it looks like several slips."""
        if len({found.kind for found in feedback.findings}) < 2:
            return ""
        try:
            at = random_values(self.arguments)
            given = self._called(answer) if is_function(answer) else partial(self.claim.values_over, self._as_latex(answer))  # fmt: skip
            true, obtained = self.claim.values_over(ASKED, at), given(at)
        except (ArmproofError, ValueError):
            return ""
        words = relation(true, obtained, self._factors(at)) if true.shape == obtained.shape and true[0].size > 1 else ""
        return "" if has_place(words) else words

    def _of_a_number(self, answer: Any) -> str:
        """Return what may be behind a wrong number: a root that is missing, too many or on the wrong side of the line; its reciprocal."""
        try:
            words = slips_by_value(self.claim, self._written(answer), random_values(self.arguments), edits=roots_astray)
        except ArmproofError:
            return ""
        related = words or self._relation(answer)
        return related if words or related == look_up(NUMBER_UPSIDE_DOWN) else ""

    def _relation(self, answer: Any, only: np.ndarray | None = None) -> str:
        """Return how an answer with no known slip relates to what is asked, in values and in its letters; of some entries alone."""
        try:
            words = self._as_bound(answer) if only is None and set(self.arguments) & set(self.given) else ""
            return words or first_said(self._unbound._relations(answer, self._drawn, only))
        except ShapeError as problem:  # c_{23} of an arm without an angle 3
            return str(problem)
        except ArmproofError:
            return ""

    def _as_bound(self, answer: Any) -> str:
        """Return how an answer relates to what is asked where the arguments are what the task gives."""
        latex = self._written(answer)
        if words := slips_by_value(self._unbound.claim, latex, self._drawn, with_turns=self._has_angles, edits=arguments_exchanged):  # fmt: skip
            return words
        words = relation(self._true[:FEW], self._values_of(answer), {})
        for arc, of_samples, always in _OF_ARCS:
            if look_up(of_samples) in words and re.search(arc, latex):
                words = words.replace(look_up(of_samples), look_up(always))
        return words

    @cached_property
    def _unbound(self) -> Formula:
        """The same question with arguments that are free, each of its own."""
        given = {name: value for name, value in self.given.items() if name not in self.arguments}
        return self if len(given) == len(self.given) else replace(self, given=given)

    def _relations(self, answer: Any, bound: Letters, only: np.ndarray | None) -> Iterator[Said]:
        at = random_values(self.arguments)
        asked = remembered(partial(self.claim.values_over, ASKED))
        given = remembered(
            self._called(answer) if is_function(answer) else partial(self.claim.values_over, self._as_latex(answer))
        )
        wrong = self._wrong(asked, given, bound) & (only if only is not None else True)
        given = partial(but_there, asked, given, wrong)
        true, obtained = asked(at), given(at)
        if true.shape == obtained.shape:
            factors, half = self._factors(at), len(true) // 2  # in the half letters that are no angles are positive
            positive = {name: values[:half] for name, values in factors.items()}
            drawn = {name: values[: len(true)] for name, values in bound.items()}
            yield partial(factors_astray, asked, given, at)
            yield partial(letters_astray, asked, given, at)
            latex = cache(lambda: self._written(answer))
            yield lambda: slips_by_value(self.claim, latex(), at, drawn, only=wrong, edits=roots_astray)
            yield partial(relation, true, obtained, factors)
            yield partial(angle_astray, asked, given, at)
            if true[0].size > 1:
                yield partial(letters_astray_in_each, asked, given, at)
            units = cache(lambda: units_astray(asked, given, at, self._units))
            yield lambda: units() and slips_by_value(self.claim, latex(), at, drawn, only=wrong, most=1)
            yield units
            yield partial(relation, true[:half], obtained[:half], positive)
            if only is None or len(latex()) <= _LONG:  # of the rest of a long answer no slip is sought as well
                yield lambda: slips_by_value(self.claim, latex(), at, drawn, only=wrong, with_turns=self._has_angles)
                yield lambda: terms_astray(self.claim, latex(), at, wrong)
            yield partial(squares_astray, true[:half], obtained[:half], positive)
            yield partial(letter_at_fault, asked, given, at)

    def _wrong(self, asked: Values, given: Values, bound: Letters) -> np.ndarray:
        """Return which entries are wrong at letters that are as the task binds them: free, others may differ as well."""
        few = {name: values[:FEW] for name, values in bound.items()}
        true, obtained = asked(few), given(few)
        if true.shape != obtained.shape:
            return np.ones(true.shape[1:], dtype=bool)
        places = np.ndindex(*true.shape[1:])
        return np.array([not same(obtained[:, r, c], true[:, r, c]) for r, c in places]).reshape(true.shape[1:])

    def _written(self, answer: Any) -> str:
        """Return an answer as LaTeX, of a function what it gives for letters."""
        if not is_function(answer):
            return self._as_latex(answer)
        with Guard(SECONDS) as guard:
            traced = guard.call(lambda: write_matrix(self._trace(self._in_order(answer))))
        if traced.error is not None:
            raise AnswerError("the answer has no values")
        return str(traced.value)

    def _called(self, function: Callable[..., Any]) -> Values:
        """Return a function of single values as one of arrays."""
        function = self._in_order(function)

        def values(at: Letters) -> np.ndarray:
            with Guard(SECONDS) as guard, np.errstate(all="ignore"):
                rows = zip(*(at[name].tolist() for name in self.arguments), strict=True)
                calls = [guard.call(lambda row=row: function(*row)) for row in rows]  # type: ignore[misc]
            if any(call.error is not None for call in calls):
                raise AnswerError("the answer has no values")
            found = np.array([read_returned(call.value, 1)[0] for call in calls])
            return found.reshape(len(found), *self._true.shape[1:]) if found[0].size == self._true[0].size else found

        return values

    @cached_property
    def _drawn(self) -> dict[str, np.ndarray]:
        """The values of the arguments at the samples where what is asked has a value; what is given binds them."""
        return {name: self._values[name][self._with_value] for name in self.arguments}

    @cached_property
    def _units(self) -> tuple[tuple[str, ...], ...]:
        """The letters of one unit each: times, angles of a motion, and the lengths that are left."""
        times = tuple(name for name in self.arguments if _TIME.match(name))
        motion = tuple(name for name in self.arguments if name.startswith("q_"))
        lengths = tuple(name for name in self.arguments if name not in times and not ANGLE.match(name))
        return tuple(dict.fromkeys([lengths, times, motion, lengths + times]))

    def _factors(self, at: Letters) -> Letters:
        """Return what may be a factor too many: letters, sums and differences of a unit, sines and cosines of angles."""
        pairs = [pair for unit in self._units[:3] for pair in combinations(unit, 2)]
        angles = {_as_latex(name): at[name] for name in at if ANGLE.match(name) and not name.startswith("q_")}
        sums = {f"({one} + {other})": angles[one] + angles[other] for one, other in combinations(angles, 2)}
        return {
            **{_as_latex(name): values for name, values in at.items()},
            **{
                f"1 + {_as_latex(name)}^2": 1 + values**2
                for name, values in at.items()
                if _as_latex(name) not in angles
            },
            **{f"sin {name}": np.sin(values) for name, values in {**angles, **sums}.items()},
            **{f"cos {name}": np.cos(values) for name, values in {**angles, **sums}.items()},
            **{f"{_as_latex(one)} + {_as_latex(other)}": at[one] + at[other] for one, other in pairs},
            **{f"{_as_latex(other)} - {_as_latex(one)}": at[other] - at[one] for one, other in pairs},
        }

    # -- functions -----------------------------------------------------------------------------------------------------

    def _judge_function(self, function: Callable[..., Any]) -> Feedback:
        problem = self._cannot_be_called(function)
        if problem:
            return Feedback(Outcome.ERROR, problem)
        function = self._in_order(function)
        with Guard(SECONDS) as guard:
            first = guard.call(lambda: function(*self._arguments(self._with_value[0])))
            if (stopped := _stopped(first.value, first.error)) is not None:
                return stopped
            traced = guard.call(lambda: write_matrix(self._trace(function)))
            if traced.error is None:
                feedback = self._judge_latex(traced.value, self.claim.judge(traced.value))
            else:
                feedback = self._compare(function, guard, traced.error.message)
            if not feedback.is_right and (degrees := self._in_degrees(function, guard)):
                return replace(feedback, outcome=Outcome.WRONG, message=degrees, findings=())
            return feedback

    def _in_order(self, function: Callable[..., Any]) -> Callable[..., Any]:
        """Return a function that takes the arguments in their order, from one that has them by the same names in another."""
        try:
            names = list(inspect.signature(function).parameters)
        except ValueError:
            return function
        bare = {name.replace("_", "").lower(): name for name in names}
        wanted = [name.replace("_", "").lower() for name in self.arguments]
        if len(bare) != len(names) or set(bare) != set(wanted) or list(bare) == wanted:
            return function
        places = [wanted.index(name) for name in bare]
        return lambda *values: function(*(values[place] for place in places))

    def _in_degrees(self, function: Callable[..., Any], guard: Guard) -> str:
        """Say if the function is right but for degrees, in its arguments or in its result."""
        for scales, scale, words in self._degree_slips():
            for k in self._with_value[:FEW]:
                values = [value * factor for value, factor in zip(self._arguments(k), scales, strict=True)]
                call = guard.call(lambda values=values: function(*values))  # type: ignore[misc]
                if call.error is not None:
                    break
                obtained = read_returned(call.value, 1)[0].ravel() * scale
                if not self._are_equal(obtained, self._true[k].ravel()):
                    break
            else:
                return words
        return ""

    def _degree_slips(self) -> Iterator[tuple[list[float], float, str]]:
        degrees = [180 / np.pi if ANGLE.match(name) else 1.0 for name in self.arguments]
        if max(degrees, default=1.0) > 1:
            yield degrees, 1.0, look_up("the angles are taken as degrees: they are in radians already")
            yield (
                [1 / each for each in degrees],
                1.0,
                look_up("the angles are turned into degrees: sine and cosine take radians"),
            )
        if self._has_angles:
            yield [1.0] * len(degrees), np.pi / 180, look_up("the result is in degrees; give radians")

    @cached_property
    def _has_angles(self) -> bool:
        """Whether what is asked is an angle, which counts up to whole turns."""
        return self.unit == "rad" or re.search(r"atan|arc", " ".join([self.latex, *self.given.values()])) is not None

    def _are_equal(self, obtained: np.ndarray, true: np.ndarray) -> bool:
        return obtained.shape == true.shape and not self._differ(obtained, true).any()

    def _differ(self, obtained: np.ndarray, true: np.ndarray) -> np.ndarray:
        off = np.abs(obtained - true)
        if self._has_angles:
            turns = np.round((obtained - true) / (2 * np.pi))
            off = np.minimum(off, np.abs(obtained - true - 2 * np.pi * turns))
        return np.asarray(~(off <= _TOLERANCE * (1 + np.abs(true))))

    def _trace(self, function: Callable[..., Any]) -> np.ndarray:
        def call(function: Callable[..., Any], make: Callable[[str], Any]) -> Any:
            return function(*(make(name) for name in self.arguments))

        return np.array(trace_function(function, call), dtype=object)

    def _cannot_be_called(self, function: Callable[..., Any]) -> str:
        try:
            inspect.signature(function).bind(*self.arguments)
        except TypeError:
            name, arguments = getattr(function, "__name__", look_up("the function")), list(self.arguments)
            return counted(
                "{name} is to take 1 argument: {arguments}", "{name} is to take {number} arguments: {arguments}",
                len(arguments), name=name, arguments=arguments,
            )  # fmt: skip
        except ValueError:  # a function written in C
            pass
        return ""

    def _arguments(self, sample: int) -> list[float]:
        return [float(self._values[name][sample]) for name in self.arguments]

    @cached_property
    def _values(self) -> dict[str, np.ndarray]:
        """The values of the arguments at the samples."""
        try:
            return {name: self.claim.values(_as_latex(name))[:, 0, 0] for name in self.arguments}
        except ArmproofError as problem:
            raise LessonError("the arguments of the task have no values: {reason}", reason=problem) from None

    @cached_property
    def _true(self) -> np.ndarray:
        return self.claim.values(ASKED)

    @cached_property
    def _with_value(self) -> list[int]:
        """The samples at which what is asked has a value."""
        good = np.flatnonzero(np.isfinite(self._true).all(axis=(1, 2)))
        if not len(good):
            raise LessonError("the formula of the task has a value nowhere: {latex}", latex=self.latex)
        return [int(k) for k in good]

    def _compare(self, function: Callable[..., Any], guard: Guard, reason: str) -> Feedback:
        """Compare a function that cannot be traced with the formula, value by value."""
        for values, true in self._trials():
            call = guard.call(lambda values=values: function(*values))  # type: ignore[misc]
            if (stopped := _stopped(call.value, call.error)) is not None:
                return stopped
            (obtained,) = read_returned(call.value, 1)
            if obtained.size != true.size:
                asked = "×".join(map(str, true.shape))
                told = written(
                    "the result has {size} numbers, what is asked is {asked}", size=obtained.size, asked=asked
                )
                return Feedback(Outcome.WRONG, told)
            wrong = self._differ(obtained.reshape(true.shape), true)
            if wrong.any():
                return Feedback(
                    Outcome.WRONG, look_up("the values differ from what is asked"),
                    self._rows(true, obtained.reshape(true.shape), wrong),
                    dict(zip(self.arguments, values, strict=True)),
                    findings=(say(Kind.UNEQUAL),),
                )  # fmt: skip
        why = reason if "Error" not in reason else look_up("it computes with numbers only")
        return Feedback(
            Outcome.CONFIRMED,
            written(
                "equal at {count} random values; not proved, since {reason}", count=len(self._with_value), reason=why
            ),
        )

    def _trials(self) -> Iterator[tuple[list[float], np.ndarray]]:
        """Yield values of the arguments with what is asked there: the cases that a student can imagine, then random ones."""
        for case in self.cases:
            values = [float(self.claim.values_at(_as_latex(name), case)[0, 0]) for name in self.arguments]
            yield values, self.claim.values_at(ASKED, case)
        for k in self._with_value:
            yield self._arguments(k), self._true[k]

    def _rows(self, true: np.ndarray, obtained: np.ndarray, wrong: np.ndarray) -> tuple[Row, ...]:
        return tuple(
            Row(
                place(r + 1, c + 1) if true.size > 1 else look_up("value"),
                float(true[r, c]),
                float(obtained[r, c]),
                self.unit,
            )
            for r, c in np.argwhere(wrong).tolist()
        )


def _stopped(value: Any, error: CallError | None) -> Feedback | None:
    """Return the feedback on a call that gave no numbers; None where it gave some."""
    if error is not None:
        if error.type == "NotImplementedError":
            return nothing()
        where = written(" in line {line}", line=error.line) if error.line else ""
        power = look_up(" (a power is ** in Python)") if "for ^" in error.message else ""
        return Feedback(Outcome.ERROR, f"{error.type}{where}: {error.message}{power}", error=error)
    try:
        read_returned(value, 1)
    except NotAttempted:
        return nothing()
    except NotNumbers as problem:
        return Feedback(Outcome.ERROR, str(problem))
    return None


def _as_latex(name: str) -> str:
    from armproof.verification.latex.writer import symbol_as_latex

    return name if "\\" in name else symbol_as_latex(name)
