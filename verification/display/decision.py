"""One reading of an equation, decided: by the arm, by laws that hold of any arm, by what the text around allows."""

from __future__ import annotations

from dataclasses import replace
from functools import cached_property, partial

from armproof.verification.algebra.calculus import symbols_in
from armproof.verification.algebra.matrix import Matrix
from armproof.verification.conditions.branches import never_with_others
from armproof.verification.conditions.circumstances import Circumstances
from armproof.verification.equations.alignment import is_near
from armproof.verification.equations.any_frames import direction_of_any_frames
from armproof.verification.equations.any_jacobian import (
    holds_of_any_jacobian,
    is_step_along_gradient,
    names_its_columns,
    tells_jacobian,
    weighs_forces,
)
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.equations.compositions import is_composition
from armproof.verification.equations.derivative_matrices import is_matrix_of_derivatives
from armproof.verification.equations.differentials import is_of_rates, with_rates
from armproof.verification.equations.each_joint import (
    holds_for_each_joint,
    index_of,
    slip_of_law,
    with_inverses,
    without_letters,
)
from armproof.verification.equations.elementary import is_elementary_rotation
from armproof.verification.equations.general_links import GeneralStatements, of_link_i
from armproof.verification.equations.given_values import GivenValues
from armproof.verification.equations.misreadings import without_misreading
from armproof.verification.equations.order_of_factors import unless_exchanged
from armproof.verification.equations.outcome import Outcome
from armproof.verification.equations.printed_factors import factors_no_rotation, factors_otherwise
from armproof.verification.errors import EvaluationError
from armproof.verification.findings import Finding, Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare_key
from armproof.verification.naming.quantities import is_inverse_link
from armproof.verification.naming.state import Told
from armproof.verification.verdict import HOLDS, Role, Verdict


class Decision:
    """Decides chains of = in the one reading in which they are given.

    Where `is_closed`, all letters have one meaning that is known, as in the answer to a task: none may be meant otherwise.
    """

    is_closed: bool = False

    def __init__(self, checker: ChainChecker) -> None:
        self.checker = checker
        self.names = checker.names
        self.ring = checker.exact.ring
        self.given = GivenValues(checker.equality)

    @cached_property
    def circumstances(self) -> Circumstances:
        """Heeds what the text between displays says; made where it says something."""
        return Circumstances(self.checker, self.given)

    @cached_property
    def general(self) -> GeneralStatements:
        """Checks what is said of any link; made where something is."""
        return GeneralStatements(self.checker)

    def of(self, chain: n.Chain, equation: int, line: int, define: bool) -> list[Outcome]:
        """Return the outcomes of a chain whose letters, relations and lists are read."""
        of_any = of_link_i(chain) if _has_letter_index(chain) else chain
        is_general = any(is_inverse_link(member, self.names.transforms) is not None for member in of_any.members)
        found = self.general.check(chain, equation, line, define) if is_general else None
        for outcome in found or ():
            outcome.role = Role.LAW
        outcomes = found or self._decided(chain, equation, line, define)
        if self.names.arm is None:
            outcomes = unless_exchanged(outcomes, chain, self.names)
        for outcome in outcomes if define else ():
            self.given.remember(outcome.gives, line)
        if self.names.state.told.is_direct:
            outcomes = [self.circumstances.numbers_there(each, line) or each for each in outcomes]
        if define and any(o.tells(Kind.NUMBERS_OF_NOWHERE) for o in outcomes):
            self.circumstances.text.of_display(chain, holds_nowhere=True)
        outcomes = [self._understood(o, chain, define, line) if o.verdict is Verdict.REFUTED else o for o in outcomes]
        if self.names.state.told.is_direct:
            outcomes = [self.circumstances.as_usual_there(each) or each for each in outcomes]
        if self.names.state.told.bounds:
            outcomes = [self.circumstances.within_bounds(outcome) for outcome in outcomes]
        if define and self.names.arm is not None:
            outcomes = [never_with_others(outcome, self.checker, line) for outcome in outcomes]
        if any(outcome.verdict is Verdict.PROVED for outcome in outcomes) and _multiplies_a_matrix(chain):
            outcomes = self._with_factors(chain, outcomes, equation)
        if any(outcome.tells(Kind.NOT_AS_USUAL_BOUND) for outcome in outcomes):
            outcomes = self._with_sign_of_vectors(chain, outcomes, line)
        is_open = bool(outcomes) and all(o.verdict in (Verdict.UNCHECKED, Verdict.DEFINED) for o in outcomes)
        return self._of_any_jacobian(chain, outcomes, define) if is_open else outcomes

    def _of_any_jacobian(self, chain: n.Chain, outcomes: list[Outcome], define: bool) -> list[Outcome]:
        """Prove a law of any Jacobian; refute what is a slip away from one where the document has shown which matrix J is."""
        if names_its_columns(chain, self.names) or is_matrix_of_derivatives(chain, self.names):
            known = (say(Kind.OF_ANY_JACOBIAN),)
            return [replace(each, verdict=Verdict.PROVED, findings=known, role=Role.LAW) for each in outcomes]
        if holds_of_any_jacobian(chain, self.names):
            self.names.state.tells_jacobian |= define and tells_jacobian(chain)
            known = (say(Kind.OF_ANY_JACOBIAN),)
            return [replace(each, verdict=Verdict.PROVED, findings=known, role=Role.LAW) for each in outcomes]
        is_known = self.names.state.tells_jacobian or "J" in self.names.state.shown
        if not is_known or len(outcomes) > 1 or is_step_along_gradient(chain):
            return outcomes
        holds = partial(holds_of_any_jacobian, names=self.names)
        slip = (
            slip_of_law(chain, holds, turns=True, is_meant=lambda each: not weighs_forces(each))
            if not holds(with_inverses(chain))
            else None
        )
        return outcomes if slip is None else self._slip(Kind.SLIP_OF_ANY_JACOBIAN, slip, chain, outcomes, define)

    def _with_factors(self, chain: n.Chain, outcomes: list[Outcome], equation: int) -> list[Outcome]:
        """Leave open a product that holds, and prints another matrix than the factor that it stands for."""
        members = self.checker.members
        behind = factors_otherwise(chain, members) if len(chain.members) > 2 else ()
        found = (*factors_no_rotation(chain, members), *behind)
        others = {equation + place - 1: other for place, other in found}
        return [
            each.left_open(others[each.equation])
            if each.equation in others and each.verdict is Verdict.PROVED
            else each
            for each in outcomes
        ]

    def _with_sign_of_vectors(self, chain: n.Chain, outcomes: list[Outcome], line: int) -> list[Outcome]:
        """Refute z_1 × (p_2 + p_1), which with one sign turned is what usual names say: vectors alone tell of no other arm."""

        def holds(other: n.Chain) -> bool:
            try:
                with self.names.state.unchanged():
                    self.names.forget(key for each in outcomes for key in each.defines)
                    found = self.checker.check(other, 1, line, define=False)
            except (EvaluationError, RecursionError):
                return False
            return bool(found) and all(each.verdict is Verdict.PROVED for each in found)

        slip = slip_of_law(chain, holds, is_meant=self._is_of_vectors)
        wrong = slip and say(Kind.SLIP_AS_VECTORS, change=slip)
        return [
            Outcome(Verdict.REFUTED, (wrong,), each.equation) if wrong and each.tells(Kind.NOT_AS_USUAL_BOUND) else each
            for each in outcomes
        ]

    def _is_of_vectors(self, node: n.Sum) -> bool:
        """Whether names alone stand in a sum, more than one and each of a vector."""
        below = [*n.walk(node)]
        names = [each for each in below if isinstance(each, n.Name)]
        is_plain = len(names) > 1 and not any(isinstance(each, n.JointAngles | n.Call) for each in below)
        return is_plain and all(isinstance(self.checker.member(each).value, Matrix) for each in names)

    def _slip(
        self, kind: Kind, change: Finding, chain: n.Chain, outcomes: list[Outcome], define: bool
    ) -> list[Outcome]:
        """Refute a chain that is a change away from a law: it gives no name its meaning."""
        self.names.forget(key for each in outcomes for key in each.defines if define)
        wrong = (
            Outcome(Verdict.REFUTED, (say(kind, change=change),), each.equation, role=Role.LAW) for each in outcomes
        )
        return [self._understood(each, chain, define) for each in wrong]

    def _understood(self, outcome: Outcome, chain: n.Chain, define: bool, line: int = 0) -> Outcome:
        """Return a refuted outcome, left open where the chain or what the text says may be meant otherwise."""
        outcome = without_misreading(outcome, chain, self.names, not define, self.is_closed)
        if self.names.arm is None and self.names.state.compares_lengths and self.ring.signs_chosen:
            outcome = outcome.unless_refuted(say(Kind.ROOTS_POSITIVE))  # a > b says which sign √((a − b)²) has
        speaks = self.names.state.told != Told() and outcome.verdict is Verdict.REFUTED
        outcome = self.circumstances.judge(outcome, line) if speaks else outcome
        return outcome.left_open(say(Kind.NUMBERS_OF_NOWHERE)) if self._is_at_rest(outcome) else outcome

    def _is_at_rest(self, outcome: Outcome) -> bool:
        """Whether a matrix that moves is printed without any joint, and not by one slip: p_2 = (l_2, l_1) is that of some configuration."""
        if outcome.verdict is not Verdict.REFUTED or outcome.there or outcome.pair is None or self.is_closed:
            return False
        if outcome.pair.is_scalar or is_near(outcome.pair) or self._is_along_axes(outcome):
            return False
        true, printed = (symbols_in(side.cells) for side in (outcome.pair.true, outcome.pair.printed))
        joints, given = {*self.given.joints}, self.given.values_of_all(self.names.state.told.standing).keys()
        return bool(printed) and printed.isdisjoint(joints) and not true.isdisjoint(joints - given)

    def _is_along_axes(self, outcome: Outcome) -> bool:
        """Whether what is printed is a vector along axes of frames, which move though no joint stands in it."""
        names = n.names(outcome.printed.node) if outcome.printed is not None else ()
        found = map(self.names.quantity, names)
        return any(each is not None and each.kind == "axis" for each in found)

    def _decided(self, chain: n.Chain, equation: int, line: int, define: bool) -> list[Outcome]:
        outcomes = self.checker.check(chain, equation, line, define)
        undecided = all(outcome.verdict in (Verdict.UNCHECKED, Verdict.DEFINED) for outcome in outcomes)
        frames = self.names.arm.frames if self.names.arm is not None else ()
        if not (undecided and outcomes):
            return outcomes
        if is_composition(chain, frames) or is_elementary_rotation(self.general, chain, equation, line):
            self.names.state.forget_consulted()  # it holds by its indices, whatever the document says of these names
            return [replace(each, verdict=Verdict.PROVED, findings=(), role=Role.LAW) for each in outcomes]
        if (direction := direction_of_any_frames(self.names, chain)) is not None:
            self.names.state.transforms = (
                direction if define and self.names.arm is None else self.names.state.transforms
            )
            self.names.state.forget_consulted()
            of_any = (say(Kind.OF_ANY_FRAMES),)
            return [
                replace(each, verdict=Verdict.PROVED, findings=of_any, role=Role.LAW, defines=()) for each in outcomes
            ]
        if (rates := with_rates(chain, self.names)) is not None:
            tried = self.checker.check(rates, equation, line, False)
            if all(
                outcome.verdict in HOLDS or (outcome.is_slip and is_of_rates(rates, self.names)) for outcome in tried
            ):
                return tried
        kinds = ("", kind) if (kind := self.names.state.told.kind) else ("",)

        def by_joint(other: n.Chain) -> bool:
            other = without_letters(other, self.names.is_open) if len(other.members) > 2 else other
            return any(holds_for_each_joint(self.checker, other, equation, line, kind) for kind in kinds)

        if by_joint(chain):
            held = (say(Kind.EACH_JOINT),)
            return [
                replace(each, verdict=Verdict.PROVED, findings=held, role=Role.LAW, defines=()) for each in outcomes
            ]
        if len(outcomes) == 1 and index_of(chain) and (slip := slip_of_law(chain, by_joint)) is not None:
            return self._slip(Kind.SLIP_FOR_EACH_JOINT, slip, chain, outcomes, define)
        if self.names.arm is not None and (found := self.general.product(chain, equation, line)):
            return found
        if self.names.arm is not None and (found := self._behind_name(chain, equation, line)):
            return [*outcomes[:1], *found]
        open_alone = all(outcome.verdict is Verdict.UNCHECKED and not outcome.defines for outcome in outcomes)
        if self.names.arm is not None and open_alone:
            return self.general.identity(chain, equation, line) or outcomes
        return outcomes

    def _behind_name(self, chain: n.Chain, equation: int, line: int) -> list[Outcome] | None:
        """R = R_z(φ) R_y(θ) R_x(ψ) = […]: whatever is named there, what stands behind it is an identity or wrong."""
        if len(chain.members) < 3 or bare_key(chain.members[0]) is None:
            return None
        rest = replace(chain, members=chain.members[1:], relations=chain.relations[1:])
        return self.general.identity(rest, equation + 1, line)


def _has_letter_index(chain: n.Chain) -> bool:
    """Whether a name in a chain has a letter for its index, as what is said of any link does: A_n, {}^jT_{j+1}; or α has none."""
    names = n.names(chain)
    if any(name.base == "alpha" and not name.sub for name in names):
        return True
    return any(script[:1] in {*"ijkn"} for name in names for script in (name.sub, name.pre_sub))


def _multiplies_a_matrix(chain: n.Chain) -> bool:
    """Whether a matrix that is printed is a factor in a chain."""
    products = (below for below in n.walk(chain) if isinstance(below, n.Product))
    return any(isinstance(n.bare(factor), n.Matrix) for product in products for factor in product.factors)
