"""An answer as a claim: "what is asked = the answer", checked as a display of a handout is."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np

from armproof.course.errors import AnswerError, LessonError
from armproof.course.feedback.answer import as_latex, is_number
from armproof.course.feedback.outcome import ASKED, Feedback, Outcome, Row, place, said_of, told, without_asked
from armproof.models.arm import Arm
from armproof.models.errors import ArmproofError, written
from armproof.models.language import look_up
from armproof.verification.algebra.budget import Budget
from armproof.verification.algebra.matrix import Matrix, as_scalar
from armproof.verification.algebra.ring import Scalar
from armproof.verification.check import SECONDS_TO_DECIDE, DocumentChecker, load_arm_of
from armproof.verification.diagnosis.counterexample import Remembering
from armproof.verification.document import Display, Document
from armproof.verification.equations.sides import Member
from armproof.verification.errors import ReadError, TooComplex, UnboundName
from armproof.verification.evaluation.evaluator import Evaluator
from armproof.verification.evaluation.sampled import SampledAlgebra
from armproof.verification.findings import Finding, Kind, say
from armproof.verification.findings.finding import write_all
from armproof.verification.latex import nodes as n
from armproof.verification.latex.greek import ANGLES, one_of
from armproof.verification.latex.writer import symbol_as_latex
from armproof.verification.naming.conventions import applied, conventional
from armproof.verification.report.html.figures import Figure, painter_of
from armproof.verification.verdict import Record, Role, Verdict

_FILE = Path("answer")
_LETTER = re.compile(r"\\?[A-Za-z]+(_(\w|\{\w+\}))?")
ANGLE = re.compile(rf"{one_of(ANGLES)}|q(_|$)")  # letters of angles
_WORD = re.compile(r"\\?[A-Za-z]+(?:_\w+)?")
_PARAMETER = re.compile(r"(?:[adlrqt]|alpha|theta)_?\d+")  # of a link or a joint
_READ = (Verdict.DEFINED, Verdict.PROVED, Verdict.CONFIRMED)
_DECIMAL = re.compile(r"\d\.\d|\\frac\{\d+\}\{\d+\}")
_NEAR = 1e-9
_INFINITE = re.compile(r"\\infty|∞|(?<![A-Za-z\\])inf(?![A-Za-z])")
_TREES = 40  # formulas that are kept as they were read
SAMPLES = 200
SEED = 11
_JOINTS = {"revolute": (-2.6, 2.6), "prismatic": (0.1, 0.9)}


@dataclass(frozen=True, eq=False)
class Claim:
    """What a formula is compared with.

    Attributes:
        front: the front matter under which both are read.
        given: displays that come before: names with a meaning.
        truth: the right formula as LaTeX; empty where the front matter binds ASKED to a quantity of the arm.
        unit: of an entry, by row and column (from 0).
        names: whether an answer may name quantities of the arm.
        own: the letters that an answer is made of, beside the arm's; without it, all that the front matter binds.
        cases: values of the letters that a student can imagine; a wrong answer is shown at the first that tells it.
    """

    front: Mapping[str, Any]
    given: tuple[str, ...] = ()
    truth: str = ""
    unit: Callable[[int, int], str] = field(default=lambda row, column: "–")
    names: bool = False
    own: tuple[str, ...] | None = None
    cases: tuple[Mapping[str, float], ...] = ()
    _records: dict[str, Record] = field(default_factory=dict, repr=False)
    _trees: dict[str, n.Node] = field(default_factory=dict, repr=False)

    def judge(self, latex: str) -> Feedback:
        """Return what becomes of a formula."""
        if _INFINITE.search(latex):
            return Feedback(
                Outcome.WRONG, look_up("that is infinite: what is asked has a value for all values of its letters")
            )
        if problem := self._refused(latex):
            return Feedback(Outcome.WRONG, problem)
        record = self.record(latex)
        if record.verdict is Verdict.PROVED:
            if record.says(Kind.TABLE_ANGLES):
                return Feedback(
                    Outcome.WRONG,
                    look_up("that is so for the angles of the table; the joint variable differs by its offset"),
                )
            return Feedback(Outcome.PROVED, look_up("proved for all values"))
        if record.verdict is Verdict.CONFIRMED:
            return Feedback(Outcome.CONFIRMED, record.message or _equal_at(record.samples))
        if record.verdict is Verdict.REFUTED:
            findings = told([each for each in record.findings if not self._names_hidden(each)], record.entries)
            rows, at = self._imagined(latex) or (self._rows(record), record.counterexample)
            outcome = Outcome.LETTERS if self._is_measured(latex) else Outcome.WRONG
            words = self._two_readings(latex) or said_of(findings)
            picture = self._picture(record) if at is record.counterexample else None
            return Feedback(outcome, words, rows, at, picture, findings=findings)
        if record.says(Kind.NUMBERS_FOR_LENGTHS) and self.arm is None and self._has_its_letters(latex):
            return Feedback(Outcome.WRONG, str(say(Kind.UNEQUAL)), findings=(say(Kind.UNEQUAL),))
        if record.says(Kind.NUMBERS_FOR_LENGTHS):
            return Feedback(
                Outcome.WRONG, self._with_letters(look_up("numbers stand for lengths that are to stay letters"))
            )
        if record.verdict is Verdict.DEFINED:
            return Feedback(
                Outcome.ERROR, self._with_letters(look_up("the answer is made of names that mean nothing here"))
            )
        words = self.unbound(latex) or self._with_letters(write_all(without_asked(record.findings)))
        return Feedback(Outcome.ERROR, words)

    def _two_readings(self, latex: str) -> str:
        """Return what is said of a quotient that can be read in two ways, both of them wrong; empty where there is none."""
        quotient = next(
            (node for node in n.walk(self.read(latex)) if isinstance(node, n.Ambiguous) and node.sort == "slash"), None
        )
        return str(say(Kind.TWO_READINGS, text=quotient.text)) if quotient is not None else ""

    def upright(self, latex: str) -> str:
        """Return a row of entries as the column that is asked, as everybody means it; any other formula as it is."""
        try:
            node = self.read(latex)
            shapes = [side.value.shape for side in self._sides(node) if isinstance(side.value, Matrix)]
        except ArmproofError:
            return latex
        if len(shapes) < 2 or shapes[0] != shapes[1][::-1] or shapes[0][1] != 1 or shapes[0][0] < 2:
            return latex
        matrix = n.ungrouped(node)
        if not isinstance(matrix, n.Matrix) or len(matrix.rows) != 1:
            return rf"\left({latex}\right)^T"
        cells = [latex[cell.span[0] : cell.span[1]] for cell in matrix.rows[0]]
        return r"\begin{bmatrix} " + r" \\ ".join(cells) + r" \end{bmatrix}"

    def spread(self, latex: str) -> str:
        """Return a matrix with the scalar before it brought into its cells, where slips are looked for; "" of any other formula."""
        node = n.ungrouped(self.read(latex))
        factors = [n.ungrouped(factor) for factor in node.factors] if isinstance(node, n.Product) else []
        matrices = [factor for factor in factors if isinstance(factor, n.Matrix)]
        scalars = [factor for factor in factors if not isinstance(factor, n.Matrix)]
        if len(matrices) != 1 or len(scalars) != 1 or any(isinstance(part, n.Matrix) for part in n.walk(scalars[0])):
            return ""
        rows = (" & ".join(_times(latex, scalars[0], cell) for cell in row) for row in matrices[0].rows)
        return r"\begin{bmatrix} " + r" \\ ".join(rows) + r" \end{bmatrix}"

    def _has_its_letters(self, latex: str) -> bool:
        """Whether letters of the task that are no angles stand in an answer: its numbers do not stand for all of them then."""
        names = {name.key for name in _names_in(self.read(latex))}
        return {*self.letters} <= names or any(not ANGLE.match(letter) for letter in {*self.letters} & names)

    @property
    def letters(self) -> tuple[str, ...]:
        """The letters that an answer is made of."""
        arm = self.arm
        own = [*(joint.symbol for joint in arm.joints), *arm.lengths, *arm.angles] if arm is not None else []
        return tuple(dict.fromkeys([*(self.front.get("symbols", {}) if self.own is None else self.own), *own]))

    def _names_hidden(self, finding: Finding) -> bool:
        """Whether a finding names a letter by which the task binds its own, and which no student knows."""
        hidden = {*self.front.get("symbols", {})} - {*self.letters}
        said = {part.lstrip("\\") for part in _WORD.findall(str(finding))}
        return bool(self.own is not None and hidden & said)

    def _letters(self) -> str:
        if not self.letters:
            return look_up("the letters are those of the task")
        return written("the letters are {letters}", letters=list(self.letters))

    def unbound(self, latex: str) -> str:
        """Return what is said of a letter in an answer that the task has not; empty where there is none."""
        try:
            self.values_over(latex, {})
        except UnboundName as problem:
            return written("{shown} is no letter of this task; {letters}", shown=problem.name, letters=self._letters())
        except ArmproofError:
            return ""
        return ""

    def _with_letters(self, problem: str) -> str:
        return written("{problem}; {letters}", problem=problem, letters=self._letters())

    def record(self, latex: str) -> Record:
        """Return the verdict on "asked = answer".

        Raises:
            LessonError: the claim itself cannot be read.
        """
        if latex not in self._records:
            self._records.clear()  # the feedback on one answer asks for it several times
            self._records[latex] = self._recorded(latex)
        return self._records[latex]

    def _recorded(self, latex: str) -> Record:
        document = self._document(latex)
        checker = DocumentChecker(document, load_arm_of(document), confirm=False)
        checker.checker.equality.stated.enabled = False
        checker.statements.claims.decision.is_closed = True  # a letter that is none of the task's was refused
        result = checker.run()
        for record in result.equations[:-1]:
            if record.verdict not in _READ and any(each.role is not Role.DEFINITION for each in record.outcomes):
                raise LessonError("the task itself cannot be read: {latex}: {message}", latex=record.latex, message=record.message)  # fmt: skip
        return result.equations[-1]

    def values(self, latex: str) -> np.ndarray:
        """Return a formula at the samples, (N, rows, columns); raises ArmproofError where it cannot be evaluated."""
        node = self.read(latex)
        with self._budget.of(SECONDS_TO_DECIDE), np.errstate(all="ignore"):
            value = Evaluator(self._checker.names, self.samples).evaluate(node)
        return self.samples.stacked(value)

    def values_at(self, latex: str, at: Mapping[str, float]) -> np.ndarray:
        """Return a formula at given values of joints and letters, (rows, columns)."""
        return np.array(self.values_over(latex, {name: np.array([value]) for name, value in at.items()})[0])

    def values_over(self, latex: str, at: Mapping[str, np.ndarray]) -> np.ndarray:
        """Return a formula at values of joints and letters, N of each: (N, rows, columns)."""
        sampled, node = self._sampled(at), self.read(latex)
        with self._budget.of(SECONDS_TO_DECIDE), np.errstate(all="ignore"):
            value = Evaluator(self._checker.names, sampled).evaluate(node)
        return sampled.stacked(value)

    def evaluated_over(self, at: Mapping[str, np.ndarray]) -> Callable[[n.Node], np.ndarray | None]:
        """Return what gives a scalar's tree its values at those of joints and letters, (N,); None where it has none."""
        evaluator = Remembering(self._checker.names, self._sampled(at))

        def value(node: n.Node) -> np.ndarray | None:
            try:
                with self._budget.of(SECONDS_TO_DECIDE), np.errstate(all="ignore"):
                    found = as_scalar(evaluator.evaluate(node))
            except (ArmproofError, TypeError, NotImplementedError):
                return None
            return found if isinstance(found, np.ndarray) and found.ndim == 1 else None

        return value

    def read(self, latex: str) -> n.Node:
        """Return a formula as a tree; the feedback on one answer asks for it many times."""
        if latex not in self._trees:
            if len(self._trees) >= _TREES:
                self._trees.clear()
            self._trees[latex] = self._checker.names.reader.read_expression(latex)
        return self._trees[latex]

    def _sampled(self, at: Mapping[str, np.ndarray]) -> SampledAlgebra:
        joints = self.arm.joints if self.arm is not None else ()
        count = max((len(values) for values in at.values()), default=1)
        rest = np.random.default_rng(SEED).uniform(0.2, 0.8, (len(joints), count)) * (
            count > 1
        )  # no joint is at rest by chance
        q = np.array([at.get(joint.symbol, rest[k]) for k, joint in enumerate(joints)]).reshape(len(joints), count).T
        return SampledAlgebra(self._checker.exact, q, SEED, at)

    @cached_property
    def samples(self) -> SampledAlgebra:
        """The algebra of values at random: of the joints, and of letters that have none of their own."""
        rng = np.random.default_rng(SEED)
        joints = self.arm.joints if self.arm is not None else ()
        columns = [rng.uniform(*_JOINTS[joint.kind], SAMPLES) for joint in joints]
        angles = [name for name in self.front.get("symbols", {}) if ANGLE.match(name)]
        free = {name: rng.uniform(*_JOINTS["revolute"], SAMPLES) for name in angles}
        return SampledAlgebra(self._checker.exact, np.array(columns).reshape(len(joints), SAMPLES).T, SEED, free)

    @cached_property
    def _checker(self) -> DocumentChecker:
        """A checker that has read all but the answer."""
        document = self._document("")
        checker = DocumentChecker(document, self.arm, confirm=False)
        for display in document.displays[:-1]:
            checker.check_display(display)
        return checker

    @cached_property
    def arm(self) -> Arm | None:
        """The arm of the claim, None for a general one."""
        return load_arm_of(self._document(""))

    def _document(self, latex: str) -> Document:
        truth = [f"{ASKED} = {_as_formula(self.truth)}"] if self.truth else []
        known = [Display(k, line, section="") for k, line in enumerate([*self.given, *truth], 1)]
        answer = Display(len(known) + 1, f"{_as_formula(latex)} = {ASKED}", section="", erratum=True)
        return Document(_FILE, dict(self.front), (*known, answer), ())  # an answer defines nothing, and may be no slip

    def _refused(self, latex: str) -> str:
        """Return how the size of an answer differs from what is asked, if it does.

        Raises:
            AnswerError: it cannot be read, or names what is asked instead of working it out.
        """
        try:
            node = self.read(latex)
        except ReadError as error:
            raise AnswerError("the formula cannot be read at character {at}: {reason}", at=error.offset + 1, reason=str(error)) from None  # fmt: skip
        if any(isinstance(part, n.Sum) and {"±", "∓"} & set(_signs(part)) for part in n.walk(node)):
            return look_up("an answer has one value: which of the two signs?")
        self._refuse_unknown(latex, node)
        for name in _names_in(node):
            if name.key == "Xi" or (not self.names and self._is_of_the_arm(name)):
                shown = latex[name.span[0] : name.span[1]]
                if _PARAMETER.fullmatch(name.key):
                    raise self._no_letter(name.key, shown)
                raise AnswerError("work the entries out: the answer may not name {shown} of the arm itself", shown=shown)  # fmt: skip
        return self._size_problem(node)

    def _is_of_the_arm(self, name: n.Name) -> bool:
        """Whether a name, of none of the task's letters, stands for a quantity of the arm, if only by convention."""
        names = self._checker.names
        if name.key in (*self.letters, *names.state.definitions) or self.arm is None:
            return False
        usual = conventional(name, self.arm, names.transforms) or applied(name, self.arm)
        return bool(usual) or self._checker.checker.quantity_of(name) is not None

    def _refuse_unknown(self, latex: str, node: n.Node) -> None:
        """Refuse a letter that would be free in a general document, and is none of the task's."""
        names = self._checker.names
        known = (*self.letters, *names.state.definitions)
        for name in _names_in(node):
            if name.key not in known and (names.is_free(name) or name.key in self.front.get("symbols", {})):
                shown = latex[name.span[0] : name.span[1]]
                raise self._no_letter(name.key, shown)

    def _no_letter(self, key: str, shown: str) -> AnswerError:
        """Return that a letter is none of the task's, and of an angle with several digits which sum to write."""
        if len(angles := _angles_in(key)) > 1 and {*angles} <= {*self.letters}:
            terms = " + ".join(map(symbol_as_latex, angles))
            return AnswerError(
                "write {terms} for {shown}: the letters here are single angles", terms=terms, shown=shown
            )
        return AnswerError("{shown} is no letter of this task; {letters}", shown=shown, letters=self._letters())

    def _size_problem(self, node: n.Node) -> str:
        try:
            sides = self._sides(node)
        except TooComplex:  # the verdict meets it too, and says so
            return ""
        if not all(side.known and isinstance(side.value, Matrix | Scalar) for side in sides):
            return ""
        asked, given = (side.value.size if isinstance(side.value, Matrix) else look_up("a scalar") for side in sides)
        if asked == given:
            return ""
        return written("the result is {given}, what is asked is {asked}", given=given, asked=asked)

    def _sides(self, node: n.Node) -> list[Member]:
        """Return what is asked and an answer, evaluated."""
        with self._budget.of(SECONDS_TO_DECIDE):
            return [self._checker.checker.member(side) for side in (self._asked, node)]

    @property
    def _budget(self) -> Budget:
        return self._checker.ring.budget

    @cached_property
    def _asked(self) -> n.Node:
        return self._checker.names.reader.read_expression(ASKED)

    def _rows(self, record: Record) -> tuple[Row, ...]:
        if record.discrepancy is None:
            return ()
        rows = []
        for entry, (printed, true) in zip(record.entries, record.discrepancy.values, strict=False):
            unit = self.unit((entry.row or 1) - 1, (entry.column or 1) - 1)
            rows.append(Row(place(entry.row, entry.column), true, printed, unit))
        return tuple(rows)

    def _imagined(self, latex: str) -> tuple[tuple[Row, ...], Mapping[str, float]] | None:
        """Return the entries that are wrong at the first case that tells them, and that case."""
        for case in self.cases:
            try:
                true, obtained = (self.values_at(each, case) for each in (ASKED, latex))
            except ArmproofError:  # a/2b is refuted in either reading, and has a value in none
                return None
            if true.shape != obtained.shape:
                continue
            if wrong := np.argwhere(~(np.abs(true - obtained) < _NEAR)).tolist():
                places = [place(r + 1, c + 1) if true.size > 1 else place(None, None) for r, c in wrong]
                values = [(float(true[r, c]), float(obtained[r, c]), self.unit(r, c)) for r, c in wrong]
                return tuple(Row(at, *value) for at, value in zip(places, values, strict=True)), case
        return None

    def _is_measured(self, latex: str) -> bool:
        """Whether an answer is right for the lengths that the arm has, which stand in it as numbers."""
        if self.arm is None or not _DECIMAL.search(latex):
            return False
        true, obtained = (self.values(each) for each in (ASKED, latex))
        return true.shape == obtained.shape and np.allclose(true, obtained, rtol=_NEAR, atol=_NEAR)

    def _picture(self, record: Record) -> Figure | None:
        if record.discrepancy is None or record.discrepancy.drawn is None:
            return None
        painter = painter_of(self.arm, look_up("yours"))
        return painter.at_counterexample(record) if painter is not None else None


def judge_formula(claim: Claim, answer: Any) -> Feedback:
    """Return what becomes of a formula in any form; numbers are no formula where what is asked depends on letters."""
    feedback = claim.judge(as_latex(answer))
    if feedback.outcome is Outcome.WRONG and is_number(answer) and np.ptp(claim.values(ASKED), axis=0).max() > 0:
        return replace(feedback, message=look_up("these are the values for one case, and what is asked changes with its letters: hand over a formula, or a function itself, without brackets behind it"), findings=())  # fmt: skip
    return feedback


def as_column(feedback: Feedback) -> Feedback:
    """Return the feedback on a row that was read as the column that is asked."""
    return replace(feedback, notes=(*feedback.notes, look_up("read as a column: what is asked has one entry a row")))


def _times(latex: str, scalar: n.Node, cell: n.Node) -> str:
    """Return a cell times a scalar, as both are written; over its denominator where that is all of it."""
    factor, text = (latex[node.span[0] : node.span[1]] for node in (scalar, cell))
    if text.strip() == "0":
        return "0"
    if isinstance(scalar, n.Quotient) and isinstance(scalar.numerator, n.Number) and scalar.numerator.value == 1:
        return rf"\frac{{{text}}}{{{latex[scalar.denominator.span[0] : scalar.denominator.span[1]]}}}"
    return rf"{factor} \left({text}\right)"


def _equal_at(samples: int) -> str:
    return written("equal at {samples:,} configurations", samples=samples)


def _as_formula(latex: str) -> str:
    """Return a letter alone as a product, so that the equation is a claim about it and does not define it."""
    return rf"{latex} \cdot 1" if _LETTER.fullmatch(latex.strip()) else latex


def _signs(node: n.Sum) -> list[str]:
    return [sign for sign, _ in node.terms]


def _names_in(node: n.Node) -> Iterator[n.Name]:
    """Yield the names in a tree, without the z of Rot_z, which is no letter."""
    calls = [call for call in n.walk(node) if n.is_call(call, "Rot", "Trans")]
    axes = [id(call.arguments[0]) for call in calls]
    yield from (name for name in n.names(node) if id(name) not in axes)


def _angles_in(key: str) -> list[str]:
    """Return the angles whose sum the name of an angle with several digits would be: theta_1, theta_2 of theta_12."""
    name, _, digits = key.partition("_")
    return [f"{name}_{digit}" for digit in digits] if ANGLE.match(key) and digits.isdigit() else []
