"""The second route: what is proved must also hold on samples of the double plant, on every branch or on one."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from itertools import permutations
from typing import TYPE_CHECKING

from armproof.verification.algebra.angles import has_arcs
from armproof.verification.algebra.calculus import leaves_open
from armproof.verification.algebra.matrix import as_scalar
from armproof.verification.algebra.ring import Scalar
from armproof.verification.equations.outcome import Outcome
from armproof.verification.equations.sides import TOO_LARGE, Member, Members
from armproof.verification.errors import EvaluationError
from armproof.verification.findings import Kind, finding_of, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.greek import ANGLES
from armproof.verification.latex.nodes import bare
from armproof.verification.naming.conventions import reads_as_length
from armproof.verification.verdict import Verdict

if TYPE_CHECKING:
    from armproof.verification.equations.sampled_errors import SampledErrors
    from armproof.verification.evaluation.sampled import SampledAlgebra

TOLERANCE = 1e-6  # of the sampled values, scaled by their size; polynomials come out near 1e-15
LARGE = 100  # √((10 − l)²) = 10 − l is right of lengths below 10 alone
ROOTS = ("sqrt", "abs", "norm", "frobenius")
FEWEST = 10  # samples at which a formula has a value; with fewer it is not decided


class SecondRoute:
    """Evaluates equations on the double plant; `enabled` tells whether a proof is confirmed there that needs no samples."""

    def __init__(self, members: Members) -> None:
        self.members = members
        self.names = members.names
        self.exact = members.exact
        self.sampled = members.sampled
        self.enabled = True
        self.weighs = False  # whether what is proved is evidence for a reading, and no verdict

    def confirm(self, outcome: Outcome, branches: bool) -> Outcome:
        """Evaluate a proved equation on the double plant as well: the second route must agree."""
        ring = self.exact.ring
        if self.weighs or not (
            self.enabled or ring.signs_chosen or _holds_arcs(outcome) or self._coordinates(outcome)
        ):  # signs and branches are decided by the samples alone
            return outcome
        errors = self.sampled_errors(outcome, branches)
        if errors is None:
            return outcome
        outcome.samples = errors.samples
        outcome.max_error = errors.largest if errors.samples else None
        if outcome.max_error is not None and outcome.max_error > TOLERANCE:
            if self.on_a_branch(outcome, errors, branches):
                return outcome
            is_of_entries = any(
                isinstance(bare(node), n.Matrix) for node in outcome.nodes
            )  # which may hold each elsewhere
            counts = None if is_of_entries else self._as_signed_distance(outcome, branches)
            if counts is not None:  # r = √(X² + Y²) of X = r cos ψ
                outcome.max_error = None
                return outcome.left_open(say(Kind.SIGNED_DISTANCE, holding=counts[0], configurations=counts[1]))
            self._refute(outcome, errors.wrong(TOLERANCE), branches)
            outcome.findings = outcome.findings or (say(Kind.UP_TO_A_SIGN),)
        elif self._fails_for_lengths(outcome, branches):
            if self.on_a_branch(outcome, errors, branches):
                return outcome
            if (counts := self._on_a_branch_for_others(outcome, branches)) is not None:
                return outcome.left_open(say(Kind.SIGNED_DISTANCE, holding=counts[0], configurations=counts[1]))
            self._refute(outcome, errors.places, branches)
            outcome.findings = outcome.findings or (say(Kind.FOR_THESE_LENGTHS),)
        else:
            self._leave_open_for_signs(outcome, branches)
        return outcome

    def doubt(self, outcome: Outcome, branches: bool) -> Outcome:
        """Where square roots or arc functions leave the normal form open, equal samples still confirm."""
        pair, ring = outcome.pair, self.exact.ring
        assert pair is not None and outcome.true is not None and outcome.printed is not None
        signs = ring.signs_chosen and any(map(self._has_roots, outcome.nodes))
        if not (branches or signs) and not all(
            leaves_open(pair.true.rows[r][c] - pair.printed.rows[r][c]) for r, c in outcome.wrong
        ):
            return outcome
        if self.weighs:
            return outcome.left_open(say(Kind.NOT_SAMPLED))
        errors = self.sampled_errors(outcome, branches)
        if errors is None:
            return outcome
        if not errors.samples and not self._has_values(outcome, branches):
            return outcome.left_open(say(Kind.FEW_VALUES))
        equal = errors.samples >= FEWEST and errors.largest <= TOLERANCE
        if equal and not self._fails_for_lengths(outcome, branches):
            outcome.verdict, outcome.wrong = Verdict.CONFIRMED, []
            outcome.samples, outcome.max_error = errors.samples, errors.largest
            self._leave_open_for_signs(outcome, branches)
        elif not self.on_a_branch(outcome, errors, branches) and signs:
            self._refute(outcome, outcome.wrong, branches)
            outcome.findings = outcome.findings or (say(Kind.ROOTS_POSITIVE),)
        return outcome

    def _has_values(self, outcome: Outcome, branches: bool) -> bool:
        """Whether what is true has values, and what is printed has none."""
        alone = self.sampled_errors(replace(outcome, printed=outcome.true), branches)
        return alone is not None and alone.samples > 0

    def unless_negative(self, outcome: Outcome, branches: bool) -> Outcome:
        """Leave open what is refuted, and holds where a letter is negative: √(a²) = −a of a coordinate a."""
        if outcome.verdict is not Verdict.REFUTED or self.weighs or not any(map(self._has_roots, outcome.nodes)):
            return outcome
        letters = [each for each in self._coordinates(outcome) if self._holds_for_negative(each, outcome, branches)]
        if letters:
            return outcome.left_open(say(Kind.NEGATIVE_ALONE, letters=", ".join(letters)))
        counts = self._as_signed_distance(outcome, branches) or self._chooses_a_root(outcome, branches)
        if counts is None:
            return outcome
        if self._is_law_of_cosines(outcome):
            found = (say(Kind.ON_A_BRANCH, holding=counts[0], configurations=counts[1]),)
            return replace(outcome, verdict=Verdict.CONFIRMED, findings=found, samples=counts[0], wrong=[])
        return outcome.left_open(say(Kind.SIGNED_DISTANCE, holding=counts[0], configurations=counts[1]))

    def _is_law_of_cosines(self, outcome: Outcome) -> bool:
        """Whether squares of distances are told by the cosine of one joint, for which it is to be solved: r² + s² = l_2² + l_3² + 2 l_2 l_3 cos θ_3."""
        for squares, other in permutations(bare(node) for node in outcome.nodes):
            terms = squares.terms if isinstance(squares, n.Sum) else (("+", squares),)
            are_squares = all(sign == "+" and _is_square_of_name(bare(each)) for sign, each in terms)
            if are_squares and isinstance(other, n.Sum) and not any(map(self._is_joint, n.walk(squares))):
                joints = {each for each in n.walk(other) if self._is_joint(each)}
                return [len(each.terms) if isinstance(each, n.JointAngles) else 1 for each in joints] == [1]
        return False

    def _is_joint(self, node: n.Node) -> bool:
        """Whether a tree is a joint's letter, or the angles of the joints of c_{23}."""
        is_letter = isinstance(node, n.Name) and self.names.known_symbol(node.key) in self.names.joints
        return is_letter or isinstance(node, n.JointAngles)

    def _as_signed_distance(self, outcome: Outcome, branches: bool) -> tuple[int, int] | None:
        """Return at how many of how many configurations √(x² + y²) is what is printed; None where it is no branch.

        The arm reaches forwards there, and backwards elsewhere.
        """
        assert outcome.true is not None and outcome.printed is not None
        within = [each for side in (outcome.true, outcome.printed) for each in n.walk(side.node)]
        if any(n.is_call(each, "acos", "asin") for each in within):  # the angle itself has no quadrant then
            within = [outcome.true.node, outcome.printed.node]
        below = map(self._named, within)
        own = self.sampled_errors(outcome, branches) if any(map(is_distance, below)) else None
        if own is None or not all(e.on_a_branch(TOLERANCE) for e in self._for_other_lengths(outcome, branches)):
            return None
        return own.on_a_branch(TOLERANCE)

    def _named(self, node: n.Node) -> n.Node:
        """Return what a name was defined as, else a tree itself."""
        definition = self.names.state.definitions.get(node.key) if isinstance(node, n.Name) else None
        return node if definition is None or definition.formula is None else definition.formula

    def confirm_only(
        self, true: n.Node, printed: n.Node, equation: int, branches: bool, problem: EvaluationError
    ) -> Outcome:
        """Compare on samples alone what the exact algebra does not hold.

        What is too large for it samples only confirm: the rounding of so many terms is no evidence against them.
        """
        outcome = self._on_samples(true, printed, equation, branches, problem)
        if outcome.verdict is Verdict.REFUTED and finding_of(problem).kind in TOO_LARGE:
            left = say(Kind.TOO_LARGE, problem=finding_of(problem))
            return Outcome(Verdict.UNCHECKED, (left,), equation, Member(true), Member(printed))
        return outcome

    def _on_samples(
        self, true: n.Node, printed: n.Node, equation: int, branches: bool, problem: EvaluationError
    ) -> Outcome:
        reason = say(Kind.NOT_EXACT, what=finding_of(problem))
        outcome = Outcome(Verdict.UNCHECKED, (reason,), equation, Member(true), Member(printed))
        errors = self.sampled_errors(outcome, branches)
        if errors is None:
            return outcome
        if errors.samples < FEWEST:
            outcome.also(say(Kind.FEW_VALUES))
            return outcome
        outcome.samples, outcome.max_error = errors.samples, errors.largest
        if outcome.max_error > TOLERANCE:
            if not self.on_a_branch(outcome, errors, branches):
                self._refute(outcome, errors.wrong(TOLERANCE), branches)
        elif self._fails_for_lengths(outcome, branches):
            self._refute(outcome, errors.places, branches)
            outcome.findings = (say(Kind.FOR_THESE_LENGTHS), *outcome.findings)
        else:
            outcome.verdict = Verdict.CONFIRMED
            self._leave_open_for_signs(outcome, branches)
        return outcome

    def _leave_open_for_signs(self, outcome: Outcome, branches: bool) -> None:
        """Leave open what holds for positive letters only, as √(x²) = x, where a letter is not a length by its look."""
        letters = self._coordinates(outcome)
        if len(letters) > 1 and not self._fails_in(self.sampled().of_either_sign(letters), outcome, branches):
            return
        letters = [name for name in letters if self._fails_for_negative(name, outcome, branches)]
        if letters and all(each.partition("_")[0] in ANGLES for each in letters):
            errors = self.sampled_errors(outcome, branches, self.sampled().of_either_sign(letters))
            if errors is not None and self.on_a_branch(outcome, errors, branches):  # θ = atan2(√(1 − r_33²), r_33)
                return
        if letters:
            outcome.verdict, outcome.wrong = Verdict.UNCHECKED, []
            outcome.findings = (say(Kind.POSITIVE_ALONE, letters=", ".join(letters)),)

    def _coordinates(self, outcome: Outcome) -> list[str]:
        """The letters without a value that may be negative; none where no root or arc function asks for their sign."""
        ring = self.exact.ring
        is_rooted = ring.signs_chosen or any(map(self._rests_on_roots, outcome.nodes))
        held = ring.angles if self.names.arm is None and is_rooted else set()  # θ_5 of s_5
        letters = [name for name in sorted(self.names.used | held) if not reads_as_length(name)]
        asks = letters and (ring.signs_chosen or _holds_arcs(outcome) or any(map(self._has_roots, outcome.nodes)))
        return letters if asks else []

    def chooses_branches(self, node: n.Node) -> bool:
        """Whether a square root or an arc function stands in a tree or behind its names: exactly, each has one of its signs."""
        return any(n.is_call(b, *ROOTS, *n.ARCS) or _is_root(b) for b in n.walk(node)) or self._rests_on_roots(node)

    def _rests_on_roots(self, node: n.Node) -> bool:
        """Whether a name in a tree was defined by a square root."""
        named = (self._named(b) for b in n.names(node))
        return any(n.is_call(b, *ROOTS) for each in named for b in n.walk(each))

    def _holds_for_negative(self, letter: str, outcome: Outcome, branches: bool) -> bool:
        """Whether both sides have values where a letter is negative, and the same: arcsin(f/K) has none anywhere."""
        own = self.sampled()
        errors = self.sampled_errors(outcome, branches, own.at({letter: -own.symbol(letter)}))
        return errors is None or (errors.samples >= FEWEST and not errors.wrong(TOLERANCE))

    def _fails_for_negative(self, letter: str, outcome: Outcome, branches: bool) -> bool:
        own = self.sampled()
        return self._fails_in(own.at({letter: -own.symbol(letter)}), outcome, branches)

    def _fails_in(self, sampled: SampledAlgebra, outcome: Outcome, branches: bool) -> bool:
        errors = self.sampled_errors(outcome, branches, sampled)
        return errors is not None and bool(errors.wrong(TOLERANCE))

    def _refute(self, outcome: Outcome, wrong: list[tuple[int, int]], branches: bool) -> None:
        """Refute what fails at samples; where the document says which lengths are larger, it may hold for those."""
        if self.names.state.compares_lengths and any(
            not errors.wrong(TOLERANCE) for errors in self._for_other_lengths(outcome, branches)
        ):
            outcome.verdict, outcome.wrong, outcome.findings = Verdict.UNCHECKED, [], (say(Kind.FOR_SOME_LENGTHS),)
            return
        if self._holds_within_half_a_turn(outcome, branches):
            outcome.verdict, outcome.wrong, outcome.findings = Verdict.UNCHECKED, [], (say(Kind.WITHIN_HALF_A_TURN),)
            return
        if slides := self._positive_alone(outcome, branches):
            outcome.verdict, outcome.wrong = Verdict.UNCHECKED, []
            outcome.findings = (say(Kind.POSITIVE_ALONE, letters=", ".join(slides)),)
            return
        if (counts := self._chooses_a_root(outcome, branches)) is not None:
            outcome.verdict, outcome.wrong = Verdict.UNCHECKED, []
            outcome.findings = (say(Kind.SIGNED_DISTANCE, holding=counts[0], configurations=counts[1]),)
            return
        outcome.verdict, outcome.wrong, outcome.sampled_only, outcome.findings = Verdict.REFUTED, wrong, True, ()

    def _holds_within_half_a_turn(self, outcome: Outcome, branches: bool) -> bool:
        """Whether an equation of half an angle holds where no joint is beyond half a turn, for all lengths: θ_2/2 is not the same a turn on."""
        if not any(map(_holds_part_of_angle, outcome.nodes)):
            return False
        own = self.sampled()
        with self.exact.budget.paused():
            from armproof.verification.equations.sampled_errors import with_lengths, within_half_a_turn

        turning = [symbol for symbol, joint in self.names.joints.items() if joint.kind != "prismatic"]
        for sampled in (own, *with_lengths(own, self.names.state.stated)):
            errors = self.sampled_errors(outcome, branches, within_half_a_turn(sampled, turning))
            if errors is None or errors.samples < FEWEST or errors.wrong(TOLERANCE):
                return False
        return True

    def _positive_alone(self, outcome: Outcome, branches: bool) -> list[str]:
        """Return the sliding joints if an equation holds where they are extended: √(x² + y²) = d_3."""
        slides = [symbol for symbol, joint in self.names.joints.items() if joint.kind == "prismatic"]
        if not slides:
            return []
        own = self.sampled()
        extended = own.at({slide: own.absolute(own.symbol(slide)) for slide in slides})
        errors = self.sampled_errors(outcome, branches, extended)
        return [] if errors is None or errors.wrong(TOLERANCE) else slides

    def _chooses_a_root(self, outcome: Outcome, branches: bool) -> tuple[int, int] | None:
        """Return at how many of how many configurations a coordinate is the root of others that it is printed as: z = l_1 + √(l_2² − x² − y²) above the shoulder."""
        for alone, other in permutations(outcome.nodes, 2):
            name = n.plain_name(alone)
            quantity = self.members.quantity_of(name) if name is not None else None
            is_coordinate = quantity is not None and quantity.kind == "origin" and quantity.scalar
            if (
                is_coordinate
                and name not in n.names(other)
                and any(n.is_call(below, "sqrt") for below in n.walk(other))
            ):
                errors = self.sampled_errors(outcome, branches)
                return errors.on_a_branch(TOLERANCE) if errors is not None else None
        return None

    def on_a_branch(self, outcome: Outcome, errors: SampledErrors, branches: bool) -> bool:
        """Confirm what holds on one branch of its square roots and arc functions, and say at how many configurations; leave open what undoes itself."""
        assert outcome.true is not None and outcome.printed is not None
        left, right = sorted((outcome.true.node, outcome.printed.node), key=lambda node: node.span)
        if (
            _undoes(bare(right), bare(left)) and not self.names.state.told.bounds
        ):  # θ = arccos(cos θ): a line above may say what cos θ is
            outcome.verdict, outcome.wrong, outcome.findings = Verdict.UNCHECKED, [], (say(Kind.UP_TO_A_SIGN),)
            return True
        counts = errors.on_a_branch(TOLERANCE) if self.is_solved_for(left, right) else None
        if counts is None or not all(e.on_a_branch(TOLERANCE) for e in self._for_other_lengths(outcome, branches)):
            return False
        holding = errors.where_equal(TOLERANCE)
        outcome.verdict, outcome.wrong = Verdict.CONFIRMED, []
        outcome.samples, outcome.max_error = holding.samples, holding.largest
        outcome.findings = (say(Kind.ON_A_BRANCH, holding=counts[0], configurations=counts[1]),)
        return True

    def _on_a_branch_for_others(self, outcome: Outcome, branches: bool) -> tuple[int, int] | None:
        """Return at how many of how many configurations it holds for the lengths for which it is a branch; None where for some it is none.

        With ψ = arctan(k_2 / k_1) the sign of k_1, which is that of cos ψ, changes only where l_2 > l_1. Other arc functions have
        no quadrant for any lengths.
        """
        if any(n.is_call(below, "acos", "asin") for node in outcome.nodes for below in n.walk(node)):
            return None
        others = [e for e in self._for_other_lengths(outcome, branches) if e.wrong(TOLERANCE)]
        counts = [e.on_a_branch(TOLERANCE) for e in others]
        return counts[0] if counts and all(counts) else None

    def is_solved_for(self, node: n.Node, by: n.Node) -> bool:
        """Whether a left side is what inverse kinematics solves for: a joint variable, a sum of such, or cos, sin, tan of it.

        Only there a sign or a half-turn is left to the reader; √(sin² θ) = sin θ and x = |x| are identities, and false.
        And where φ is atan2(y, x), and tan⁻¹(y/x) besides.
        """
        node = bare(node)
        if self._is_half_a_turn_away(node, bare(by)):
            return True
        calls = [below for below in n.walk(by) if isinstance(below, n.Call)]
        by_itself = any(below == node for below in n.walk(by)) and not _is_of_both_sides(node, by)
        if by_itself or any(call.function in ("abs", "norm") for call in calls):
            return False
        if n.is_call(node, "cos", "sin", "tan"):
            value = self.members.evaluate(node).value
            same = (self.members.evaluate(call).value for call in calls if call.function == node.function)
            if isinstance(value, Scalar) and any(
                isinstance(v, Scalar) and (v - value).is_zero() for v in same
            ):  # c_1 is cos θ_1
                return False
            node = node.arguments[0]
        plain = n.Name | n.JointAngles | n.Number | n.Sum | n.Product | n.Quotient | n.Group
        return all(
            isinstance(b, plain) and (not isinstance(b, n.Name) or self._is_angle(b) or self._is_free_angle(b))
            for b in n.walk(node)
        )

    def _is_angle(self, name: n.Name) -> bool:
        """Whether a name is a joint variable, θ_{23} for the sum of two, or φ for the angle of a planar arm's frame."""
        quantity = self.members.quantity_of(name)
        if self.members.is_symbol(name) or (quantity is not None and quantity.kind == "angle"):
            return True
        return name.key not in self.names.state.definitions and self.names.angle_sum(name) is not None

    def _is_half_a_turn_away(self, node: n.Node, by: n.Node) -> bool:
        """Whether a letter is defined as atan2(y, x), and what is said of it now is the arctangent of y/x."""
        formula = self._named(node)
        if not (
            isinstance(formula, n.Call)
            and isinstance(by, n.Call)
            and (formula.function, by.function) == ("atan2", "atan")
        ):
            return False
        y, x, ratio = (as_scalar(self.members.evaluate(each).value) for each in (*formula.arguments, *by.arguments))
        both = isinstance(y, Scalar) and isinstance(x, Scalar) and isinstance(ratio, Scalar)
        return both and (ratio * x - y).is_zero()  # type: ignore[operator]

    def _is_free_angle(self, name: n.Name) -> bool:
        """Whether a letter is an angle of a document that is about no arm: φ of Euler's angles."""
        return name.base in ANGLES and self.names.is_free(name) and name.key not in self.names.state.definitions

    def _has_roots(self, node: n.Node) -> bool:
        """Whether a square root stands in a tree, or may stand behind one of its names."""
        return any(
            n.is_call(b, *ROOTS) or (isinstance(b, n.Power) and not isinstance(b.exponent, n.Number))
            or (isinstance(b, n.Name) and b.key in self.names.state.definitions)
            for b in n.walk(node)
        )  # fmt: skip

    def _fails_for_lengths(self, outcome: Outcome, branches: bool) -> bool:
        """Whether what holds at samples is right for the arm's own lengths only, as √((l_1 − l_2)²) = l_1 − l_2 may be."""
        return any(errors.wrong(TOLERANCE) for errors in self._for_other_lengths(outcome, branches))

    def _for_other_lengths(self, outcome: Outcome, branches: bool) -> Iterator[SampledErrors]:
        """Yield the errors for other lengths than the model's; none for a proof in which no sign of a root was chosen."""
        assert outcome.true is not None and outcome.printed is not None
        own = self.sampled()
        with self.exact.budget.paused():
            from armproof.verification.equations.sampled_errors import with_lengths

        signs = self.exact.ring.signs_chosen and any(map(self._has_roots, outcome.nodes))
        if outcome.pair is not None and not (signs or _holds_arcs(outcome)):
            return
        for unit in (1, LARGE):
            for sampled in with_lengths(own, self.names.state.stated, unit):
                self.exact.budget.check()
                errors = self.sampled_errors(outcome, branches, sampled)
                if errors is not None:
                    yield errors if unit == 1 else errors.telling

    def has_idle_sign(self, outcome: Outcome) -> bool:
        """Whether one sign of ± holds nowhere but where the other does too: θ_1 = atan2(y, x) ± atan2(l_2 s_2, l_1 + l_2 c_2)."""
        if self.weighs or not any(map(n.has_branches, outcome.nodes)):
            return False
        own = self.sampled()
        with self.exact.budget.paused():
            from armproof.verification.equations.sampled_errors import with_lengths

        letters = [name for name in sorted(self.names.used) if not reads_as_length(name)]
        alone = {1: False, -1: False}
        for sampled in (own, *with_lengths(own, self.names.state.stated)):
            there = sampled.of_either_sign(letters) if letters else sampled
            errors = {sign: self.sampled_errors(outcome, True, there, sign) for sign in alone}
            if any(each is None or not each.samples for each in errors.values()):
                continue
            holding = {sign: each.holding(TOLERANCE) for sign, each in errors.items() if each is not None}
            for sign in alone:
                alone[sign] |= bool((holding[sign] & ~holding[-sign]).any())
        return alone[1] is not alone[-1]

    def holds_everywhere(self, outcome: Outcome) -> bool:
        """Whether samples say that an equation with ± holds, on one choice of its signs at each."""
        errors = self.sampled_errors(outcome, True)
        return errors is not None and errors.samples >= FEWEST and errors.largest <= TOLERANCE

    def sampled_errors(
        self, outcome: Outcome, branches: bool, sampled: SampledAlgebra | None = None, only: int | None = None
    ) -> SampledErrors | None:
        """Return the errors of an equation on the double plant, with `only` one sign of ±; None where a side cannot be evaluated there."""
        assert outcome.true is not None and outcome.printed is not None
        sampled = sampled or self.sampled()
        with self.exact.budget.paused():
            from armproof.verification.equations.sampled_errors import errors_between

        nodes = outcome.true.node, outcome.printed.node
        return errors_between(self.names, sampled, *nodes, outcome.pair, branches, only)


def _holds_part_of_angle(node: n.Node) -> bool:
    """Whether a part of something stands in a tree: θ_2/2, ½ θ_2."""
    for below in n.walk(node):
        if isinstance(below, n.Quotient) and isinstance(bare(below.denominator), n.Number) and any(n.names(below)):
            return True
        if isinstance(below, n.Product) and any(isinstance(bare(each), n.Quotient) for each in below.factors):
            return True
    return False


def _is_of_both_sides(node: n.Node, by: n.Node) -> bool:
    """Whether an angle is solved for by its sine and its cosine, which were found before: θ_2 = arctan(sin θ_2 / cos θ_2)."""
    by = bare(by)
    quotient = bare(by.arguments[0]) if n.is_call(by, "atan") else None
    sides = (quotient.numerator, quotient.denominator) if isinstance(quotient, n.Quotient) else ()
    calls = [side for side in map(bare, sides) if isinstance(side, n.Call) and side.arguments == (node,)]
    return [call.function for call in calls] == ["sin", "cos"]


def _undoes(arc: n.Node, angle: n.Node) -> bool:
    """Whether a side is the arc function of the function of the angle that is the other side."""
    if not (n.is_call(arc, "acos", "asin", "atan") and len(arc.arguments) == 1):
        return False
    inner = bare(arc.arguments[0])
    return n.is_call(inner, arc.function[1:]) and bare(inner.arguments[0]) == angle


def is_distance(node: n.Node) -> bool:
    """Whether a tree is the root of a sum of squares, of which others may be taken, or that beside lengths: √(x² + y² − d²) − a."""
    node = bare(node)
    if isinstance(node, n.Sum):
        roots = [(sign, each) for sign, each in node.terms if not isinstance(bare(each), n.Name | n.Number)]
        return [sign for sign, _ in roots] == ["+"] and is_distance(roots[0][1])
    inner = bare(node.arguments[0]) if n.is_call(node, "sqrt") else None
    terms = inner.terms if isinstance(inner, n.Sum) else ()
    squares = [isinstance(bare(t), n.Power) and bare(t).exponent == n.Number(Fraction(2)) for _, t in terms]  # type: ignore[attr-defined]
    return all(squares) and sum(sign == "+" for sign, _ in terms) > 1


def _is_square_of_name(node: n.Node) -> bool:
    """Whether a tree is the square of a name: r²."""
    return isinstance(node, n.Power) and isinstance(bare(node.base), n.Name) and node.exponent == n.Number(Fraction(2))


def _is_root(node: n.Node) -> bool:
    """Whether a power is none of a whole number."""
    return isinstance(node, n.Power) and not (
        isinstance(node.exponent, n.Number) and node.exponent.value.denominator == 1
    )


def _holds_arcs(outcome: Outcome) -> bool:
    pair = outcome.pair
    return pair is None or any(map(has_arcs, (*pair.true.cells, *pair.printed.cells)))
