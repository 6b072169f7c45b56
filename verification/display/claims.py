"""What an equation claims, with the definitions that it rests on: a doubtful one decides nothing."""

from __future__ import annotations

from collections.abc import Sequence, Set
from dataclasses import replace
from functools import partial
from math import remainder, tau

from armproof.verification.algebra.matrix import Matrix
from armproof.verification.algebra.ring import Scalar
from armproof.verification.conditions.branches import is_of_second
from armproof.verification.conditions.circumstances import Circumstances
from armproof.verification.display.any_values import rests_on_nothing
from armproof.verification.display.at_values import (
    as_usual_at_told_values,
    at_told_values,
    of_worked_example,
    under_given_rates,
)
from armproof.verification.display.decision import Decision
from armproof.verification.display.equal_numbers import unequal_numbers, with_wrong_numbers
from armproof.verification.display.taken_arm import names_in
from armproof.verification.display.two_readings import either_reading, one_or_apart
from armproof.verification.document import Display
from armproof.verification.equations.case_conditions import check_cases
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.equations.differentials import of_small_ones
from armproof.verification.equations.doubts import is_of_arm
from armproof.verification.equations.elementary import axis_of_another_frame
from armproof.verification.equations.forces import balanced_forces
from armproof.verification.equations.general_links import is_sum_of_indices
from armproof.verification.equations.given_targets import asked_of_the_tool
from armproof.verification.equations.given_values import named_sign
from armproof.verification.equations.inequalities import check_relation, parts_of
from armproof.verification.equations.joint_conditions import fixes_joints
from armproof.verification.equations.named_signs import unless_of_a_sign
from armproof.verification.equations.outcome import Outcome
from armproof.verification.equations.readings import counted, second_solutions, side_by_side, without_count
from armproof.verification.equations.under_rates import UnderRates
from armproof.verification.equations.vectors import crossed_letters, of_vectors
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare, bare_key, is_number
from armproof.verification.naming.conventions import AXES
from armproof.verification.naming.state import Key
from armproof.verification.verdict import DECIDED, HOLDS, Role, Verdict

CLOSE = 1e-9  # so near are angles that are the same


class Claims:
    """What equations claim, each in the readings that it allows, and what leaves open what one of them decides."""

    def __init__(self, checker: ChainChecker) -> None:
        self.checker = checker
        self.names = checker.names
        self.decision = Decision(checker)
        self.given = self.decision.given
        self.displays: Sequence[
            Display
        ] = ()  # of the document: one gives a target, and others the numbers that reach it

    @property
    def circumstances(self) -> Circumstances:
        """Heeds what the text between displays says."""
        return self.decision.circumstances

    def claim(self, chain: n.Chain, equation: int, line: int, define: bool) -> list[Outcome]:
        """Return the outcomes of a chain that is no condition: numbers may be those of given values, and of rates in a column."""
        state = self.names.state
        if rates := self.given.rates_of_column(chain):
            stated = state.configuration
            state.configuration = {**self.given.stated(rates), **stated}
            outcomes = self._at_values(chain, equation, line, define)
            state.configuration = stated
            return outcomes
        under = UnderRates(self.checker.members, state.told)
        if self.names.arm is None or not n.has_rates(chain) or not under.concerns(chain):
            return self._at_values(chain, equation, line, define)
        before = state.copy()
        outcomes = self._at_values(chain, equation, line, define)
        is_open = not outcomes or any(outcome.verdict not in HOLDS for outcome in outcomes)
        if not is_open or any(outcome.verdict is Verdict.REFUTED for outcome in outcomes):
            return outcomes
        return under_given_rates(state, self.chain, under, chain, before, equation, line) or outcomes

    def _at_values(self, chain: n.Chain, equation: int, line: int, define: bool) -> list[Outcome]:
        self.begin()
        if _is_of_rank(chain):
            return self.circumstances.of_ranks(chain, self.chain(chain, equation, line, define), line)
        told, there = self.names.state.told, list[Outcome]()
        if told.standing or self.names.state.told_lengths:
            values = self.circumstances.text.told_values()
            number = self.checker.members.number
            there = at_told_values(self.names.state, values, self._read, number, chain, equation, line)
            there = there or as_usual_at_told_values(self.names, values, self._read, chain, equation, line)
        if any(outcome.verdict in DECIDED for outcome in there):
            return [replace(self.unless_doubted(outcome), uses=self.consulted()) for outcome in there]
        outcomes = self.chain(chain, equation, line, define)
        is_open = any(each.verdict not in HOLDS for each in outcomes) and not any(
            each.verdict is Verdict.REFUTED and each.true is not None and not is_number(each.true.node)
            for each in outcomes
        )
        if is_open and self.names.state.given_last:
            worked = of_worked_example(self.names.state, self._read, chain, equation, line)
            if worked:
                return [replace(self.unless_doubted(each), uses=self.consulted()) for each in worked]
        has_open = any(each.verdict is Verdict.UNCHECKED for each in outcomes)
        if is_open and has_open and (worked := self._at_targets(chain, outcomes, equation, line)):
            return worked
        if has_open:
            outcomes = with_wrong_numbers(self.decision.of, chain, outcomes, equation, line)
        for outcome in outcomes if there else ():
            if outcome.tells(Kind.NUMBERS_OF_NOWHERE):
                outcome.findings = there[0].findings
        return outcomes

    def _at_targets(self, chain: n.Chain, before: Sequence[Outcome], equation: int, line: int) -> list[Outcome]:
        """Return the outcomes of numbers where a target of the document is reached; [] where they are none of that."""
        holds_digits = any(isinstance(below, n.Number) for below in n.walk(chain.members[-1]))
        if not self.displays or not holds_digits or not chain.relations:
            return []
        with self.checker.exact.budget.paused():  # few documents need it: the import is none of its time
            from armproof.verification.display.at_targets import AtTargets
            from armproof.verification.display.worked_targets import WorkedTargets
        targets = WorkedTargets(self.displays, self.checker.members)
        own = {key for outcome in before for key in outcome.defines}
        return AtTargets(self.checker, self.circumstances, targets, self._read).outcomes(chain, equation, line, own)

    def chain(self, chain: n.Chain, equation: int, line: int, define: bool) -> list[Outcome]:
        """Return the outcomes of a chain, each with the definitions that it rests on."""
        self.begin()
        before = self.names.state.copy() if self.names.state.zeros else None
        outcomes = self._read(chain, equation, line, define)
        again = partial(self._read, chain, equation, line, False)
        if self.names.state.signs.read:
            outcomes = unless_of_a_sign(self.names, outcomes, again)
        if self.names.state.given():
            outcomes = asked_of_the_tool(self.names, outcomes, again)
        if self.names.offset_joints:
            outcomes = self.checker.angles.settled(chain, outcomes, define, again)
        if define:
            outcomes = self.checker.zeros.heed_display(chain, outcomes, line)
        if before is not None:
            outcomes = self.checker.zeros.settled(chain, outcomes, before, self.displays, again)
        of_jacobian = self.checker.members.speaks_of_jacobian(chain)
        if of_jacobian and (doubt := self.checker.rows.others((chain,), outcomes, again)) is not None:
            outcomes = [outcome.left_open(doubt) for outcome in outcomes]
        if not chain.relations and not outcomes:
            return [] if _is_label(chain) else [Outcome(Verdict.DEFINED, (say(Kind.NO_EQUATION),), equation)]
        outcomes = [self._of_own_sums(outcome, chain) for outcome in outcomes]
        if any(isinstance(below, n.Dots) for below in n.walk(chain)):
            unwritten = say(Kind.TERMS_UNWRITTEN, text="…")
            outcomes = [
                each if each.tells(Kind.OF_ANY_JACOBIAN) else each.unless_refuted(unwritten) for each in outcomes
            ]
        if not n.letters(chain).isdisjoint(AXES) and (doubt := axis_of_another_frame(chain)) is not None:
            outcomes = [each.left_open(doubt) if each.verdict in HOLDS else each for each in outcomes]
        foreign = self.names.state.foreign()
        for outcome in outcomes if foreign else ():
            if outcome.verdict is Verdict.REFUTED:
                other = say(Kind.OTHER_EXERCISE, name=foreign[0][0], line=foreign[0][1])
                outcome.verdict, outcome.findings = Verdict.UNCHECKED, (other,)
        own = {key for outcome in outcomes for key in outcome.defines}
        outcomes = [self.unless_doubted(outcome, _defined_beside(outcome, own, line)) for outcome in outcomes]
        if by_table := self.names.state.from_table():
            doubt = say(Kind.ENTRY_BY_INDEX, name=by_table[0])
            outcomes = [each.unless_slip(doubt) for each in outcomes]
        if text := [
            each for each in self.names.state.from_text() if each not in balanced_forces(self.names)
        ]:  # it may speak of one case: only a slip in what follows from it is refuted
            outcomes = [each.unless_slip(say(Kind.AS_TEXT_SAYS, name=text[0])) for each in outcomes]
        is_of_any = rests_on_nothing(self.names, chain, outcomes, again)
        defined = {(key, line) for outcome in outcomes for key in outcome.defines}
        for outcome in outcomes:  # c_3 = … := D names what is decided beside it
            met = {key for key in self.consulted() if key[0] not in outcome.defines and key != outcome.repeats}
            is_arithmetic = all(map(is_number, outcome.nodes))  # r = 0.4 + 0.3 = 0.7 tells nothing of r
            outcome.uses = frozenset(met | defined if outcome.verdict in DECIDED and not is_arithmetic else met)
            at = (outcome.equation or equation) - equation
            if outcome.verdict in HOLDS and (
                is_of_any or all(map(is_number, chain.members[at : at + 2]))
            ):  # nor of what r was before
                outcome.uses = frozenset()
            if define and outcome.verdict in HOLDS:
                self.names.state.held |= outcome.uses
        return outcomes

    def unless_doubted(self, outcome: Outcome, beside: Set[Key] = frozenset()) -> Outcome:
        """Leave open what a definition that may be a mistake decides: it proves nothing, and may be the mistake itself.

        What is only defined beside it, R of R = R_z(φ) R_y(θ) = […], is none of its sides. The last of two meanings is no mistake where a joint or a quantity of the arm is what it then says.
        """
        if outcome.verdict not in DECIDED or self.decision.is_closed:
            return outcome
        doubted = [key for key in self.names.state.doubted() if key not in beside]
        of_two = self.names.state.with_two_meanings()
        if of_two and (outcome.verdict is Verdict.REFUTED or not is_of_arm(outcome, self.names)):
            doubted = doubted or of_two
        if not doubted:
            return outcome
        kind = Kind.RESTS_ON_DOUBT if outcome.verdict is Verdict.REFUTED else Kind.FOLLOWS_FROM_DOUBT
        return outcome.left_open(say(kind, name=doubted[0][0], line=doubted[0][1]))

    def begin(self) -> None:
        """Forget what was consulted: what follows is another equation."""
        self.names.state.forget_consulted()

    def consulted(self) -> frozenset[tuple[str, int]]:
        """Return the definitions and the named signs that were met since the last beginning."""
        signs = self.names.state.signs
        return frozenset(self.names.state.consulted) | {(key, signs.lines.get(key, 0)) for key in signs.read}

    def _of_own_sums(self, outcome: Outcome, chain: n.Chain) -> Outcome:
        """A θ_{34} that the document says to be θ_3 - θ_4 is what it says: that is no claim, and what then fails is left open."""
        digits = next(filter(None, map(self.names.own_sum, n.walk(chain))), "")
        alone = [each.arguments[0] if isinstance(each, n.Call) else each for each in map(bare, chain.members)]
        says_so = any(self.names.own_sum(each) for each in alone)
        if not digits or not (outcome.verdict is Verdict.REFUTED or (says_so and outcome.verdict is Verdict.PROVED)):
            return outcome
        return outcome.left_open(say(Kind.OWN_SUM, digits=digits))

    def _read(self, chain: n.Chain, equation: int, line: int, define: bool) -> list[Outcome]:
        """Return the outcomes of a chain in the reading in which it holds."""
        chain = self._with_bars(chain)
        unclear = [below for below in n.walk(chain) if isinstance(below, n.Ambiguous)]
        if unclear:
            return either_reading(self._read_clear, chain, unclear, equation, line, define)
        if self.names.arm is None and (letters := crossed_letters(self.names, chain)):
            check = partial(self._read_clear, chain, equation, line)
            return of_vectors(self.names, chain, letters, line, define, check)
        if parts := side_by_side(chain):
            return one_or_apart(self._read_clear, chain, parts, equation, line, define)
        return self._read_clear(chain, equation, line, define)

    def _with_bars(self, chain: n.Chain) -> n.Chain:
        """Let |J| of a square matrix be its determinant or the size of that."""
        for below in [*n.walk(chain)]:
            if n.is_call(below, "abs") and self._is_square(below.arguments[0]):
                size = replace(below, arguments=(n.Call("det", below.arguments, span=below.span),))
                unclear = n.Ambiguous(
                    (below, size), f"|{bare_key(below.arguments[0]) or '…'}|", "bars", span=below.span
                )
                chain = n.substitute(chain, below, unclear)  # type: ignore[assignment]
        return chain

    def _is_square(self, node: n.Node) -> bool:
        value = self.checker.members.evaluate(node).value
        return isinstance(value, Matrix) and value.shape[0] == value.shape[1] > 1

    def _read_clear(self, chain: n.Chain, equation: int, line: int, define: bool) -> list[Outcome]:
        if (plain := without_count(chain, self.names)) is not None:
            outcomes = self._read_clear(plain, equation, line, False)
            seconds = second_solutions(chain, self.names)
            if (
                outcomes
                and all(outcome.verdict in HOLDS for outcome in outcomes)
                and (not seconds or is_of_second(seconds, outcomes, self.checker, line))
            ):
                outcomes[0].also(say(Kind.COUNTS_SOLUTIONS))
                self.decision.of(chain, equation, line, define)  # what is said of that solution from here on
                return outcomes
        if (said := self._stated(chain, equation, line, define)) is not None:
            return [said, *self._numbers_behind(chain, said, equation, line)]
        if any(relation != "=" for relation in chain.relations):
            parts = [(equation + at, part) for at, part in parts_of(chain)]
            return [outcome for number, part in parts for outcome in self._related(part, number, line, define)]
        if any(isinstance(member, n.Cases) for member in chain.members):
            return check_cases(self.checker, chain, equation, line, define)
        return self.decision.of(chain, equation, line, define)

    def _stated(self, chain: n.Chain, equation: int, line: int, define: bool) -> Outcome | None:
        """Return what becomes of a chain that claims nothing: a sign, a configuration, a condition, a doubt; else None."""
        sign = named_sign(chain)
        if sign is not None and self.names.defines_sign(sign):
            if define:
                self.names.state.signs.name(sign, line)
            return Outcome(Verdict.DEFINED, (say(Kind.SIGN, name=sign),), equation, defines=(sign,))
        if any(relation != "=" for relation in chain.relations):
            return None
        if isinstance(bare(chain.members[-1]), n.Call) and is_sum_of_indices(chain):
            return Outcome(Verdict.PROVED, (), equation, role=Role.LAW)
        if (doubt := counted(chain, self.names)) is not None:
            return Outcome(Verdict.UNCHECKED, (doubt,), equation)
        if (known := self.circumstances.vanishes_there(chain, equation)) is not None:
            return known
        if (given := self.given.read(chain, line, define)) is not None:
            return Outcome(Verdict.DEFINED, (say(Kind.CONFIGURATION),), equation, defines=given)
        if fixes_joints(chain, self.checker.members, self.names):
            return Outcome(Verdict.DEFINED, (say(Kind.CONDITION),), equation)
        if not self.given.is_condition(chain):
            return None
        if (known := self._holds_there(chain, equation, line)) is not None:
            return known
        if define:
            self._relate(chain, line)
        return Outcome(Verdict.DEFINED, (say(Kind.CONDITION),), equation)

    def _holds_there(self, chain: n.Chain, equation: int, line: int) -> Outcome | None:
        """Return θ_1 + θ_2 = π/2 as a claim behind values of θ_1 and θ_2 with which it holds: it ends no configuration."""
        symbols = {self.names.known_symbol(each.key) for m in chain.members for each in n.names(m)}
        if len(chain.members) != 2 or not symbols & set(self.given.joints) <= self.names.state.configuration.keys():
            return None
        outcomes = self.checker.check(chain, equation, line, define=False)
        return outcomes[0] if [each.verdict for each in outcomes] == [Verdict.CONFIRMED] else None

    def _relate(self, chain: n.Chain, line: int) -> None:
        """Keep what joints, or lengths, are said to be: l_1 = l_2, of which l may be the letter."""
        related = self.given.related(chain)
        if not related:
            return
        self.circumstances.text.of_display(
            replace(chain, members=tuple(related), relations=("=",) * (len(related) - 1))
        )
        for letter in (bare_key(each) for each in chain.members if each not in related):
            self.names.define(str(letter), self.checker.members.meaning(related[0]), line, node=related[0])

    def _numbers_behind(self, chain: n.Chain, said: Outcome, equation: int, line: int) -> list[Outcome]:
        """θ_1 = atan2(1, 0) = 90°: the numbers of a value that is given are to be equal."""
        if len(chain.members) < 3 or said.role is not Role.CLAIM or not all(map(is_number, chain.members[1:])):
            return []
        found = unequal_numbers(self.decision.of, chain, 1, equation, line)
        return [each for each in found if not (self.given.places_joints(chain) and self._are_turns_apart(each))]

    def _related(self, part: n.Chain, equation: int, line: int, define: bool) -> list[Outcome]:
        if part.relations[0] == "=":
            return self._read_clear(part, equation, line, define)
        if (small := of_small_ones(part, self.names)) is not None:
            near = self.decision.of(small, equation, line, False)
            if all(each.verdict in DECIDED for each in near):
                near[0].also(say(Kind.FIRST_ORDER))
                return near
        return [check_relation(self.checker, part, equation)]

    def _are_turns_apart(self, outcome: Outcome) -> bool:
        """Whether two numbers are the same angle: -90° = 270°."""
        pair = outcome.pair
        return pair is not None and pair.is_scalar and self._is_turn(pair.true.rows[0][0] - pair.printed.rows[0][0])

    def _is_turn(self, apart: Scalar) -> bool:
        return abs(remainder(self.checker.members.number(apart), tau)) < CLOSE


def _defined_beside(outcome: Outcome, own: Set[str], line: int) -> Set[Key]:
    """Return what a chain defines that is on no side of one of its equations."""
    return {(key, line) for key in own - {name.key for name in names_in(outcome)}} if own else frozenset()


def _is_label(chain: n.Chain) -> bool:
    """Whether a number in brackets stands alone, as equations are numbered: (3)."""
    (member,) = chain.members
    return isinstance(member, n.Group) and isinstance(member.inner, n.Number)


def _is_of_rank(chain: n.Chain) -> bool:
    """Whether a rank stands in a chain that does not say itself at which values."""
    below = [*n.walk(chain)]
    return any(map(n.is_rank, below)) and not any(isinstance(each, n.At) for each in below)
