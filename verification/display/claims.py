"""What an equation claims: it is read in each way that it may be meant, and decided in the one that holds."""

from __future__ import annotations

from collections.abc import Sequence, Set
from dataclasses import replace
from functools import cached_property, partial
from itertools import pairwise, takewhile
from math import remainder, tau

from armproof.verification.algebra.matrix import Matrix
from armproof.verification.algebra.ring import Scalar
from armproof.verification.conditions.circumstances import Circumstances
from armproof.verification.display.taken_arm import names_in
from armproof.verification.equations.any_frames import direction_of_any_frames
from armproof.verification.equations.any_jacobian import holds_of_any_jacobian, is_step_along_gradient, tells_jacobian
from armproof.verification.equations.at_stated_values import MANY, is_mostly_right
from armproof.verification.equations.case_conditions import check_cases
from armproof.verification.equations.chain import ChainChecker
from armproof.verification.equations.compositions import is_composition
from armproof.verification.equations.differentials import is_of_rates, of_small_ones, with_rates
from armproof.verification.equations.doubts import is_of_arm
from armproof.verification.equations.each_joint import holds_for_each_joint, index_of, slip_of_law, with_inverses
from armproof.verification.equations.elementary import axis_of_another_frame, is_elementary_rotation
from armproof.verification.equations.general_links import GeneralStatements, is_sum_of_indices, of_link_i
from armproof.verification.equations.given_targets import asked_of_the_tool
from armproof.verification.equations.given_values import GivenValues, named_sign
from armproof.verification.equations.inequalities import check_relation, is_numbers, parts_of
from armproof.verification.equations.misreadings import without_misreading
from armproof.verification.equations.named_signs import unless_of_a_sign
from armproof.verification.equations.order_of_factors import unless_exchanged
from armproof.verification.equations.outcome import Outcome, hold
from armproof.verification.equations.printed_factors import factors_no_rotation, factors_otherwise
from armproof.verification.equations.readings import counted, side_by_side, without_count
from armproof.verification.equations.under_rates import JACOBIAN, UnderRates
from armproof.verification.equations.vectors import crossed_letters, of_vectors
from armproof.verification.equations.worked_numbers import tells_values, unitless
from armproof.verification.errors import EvaluationError
from armproof.verification.findings import Finding, Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare, bare_key, is_number
from armproof.verification.naming.conventions import AXES
from armproof.verification.naming.quantities import is_inverse_link
from armproof.verification.naming.state import DocumentState, Key, Told
from armproof.verification.verdict import DECIDED, HOLDS, Role, Verdict

CLOSE = 1e-9  # so near are angles that are the same


class Claims:
    """What equations claim, each in the readings that it allows, and what leaves open what one of them decides.

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

    def claim(self, chain: n.Chain, equation: int, line: int, define: bool) -> list[Outcome]:
        """Return the outcomes of a chain that is no condition: numbers may be those of given values, and of rates in a column."""
        if rates := self.given.rates_of_column(chain):
            stated = self.names.state.configuration
            self.names.state.configuration = {**self.given.stated(rates), **stated}
            outcomes = self._at_values(chain, equation, line, define)
            self.names.state.configuration = stated
            return outcomes
        under = UnderRates(self.checker.members, self.names.state.told)
        if self.names.arm is None or not n.has_rates(chain) or not under.concerns(chain):
            return self._at_values(chain, equation, line, define)
        before = self.names.state.copy()
        outcomes = self._at_values(chain, equation, line, define)
        is_open = not outcomes or any(outcome.verdict not in HOLDS for outcome in outcomes)
        if not is_open or any(outcome.verdict is Verdict.REFUTED for outcome in outcomes):
            return outcomes
        return self._under_rates(under, chain, before, equation, line) or outcomes

    def _under_rates(
        self, under: UnderRates, chain: n.Chain, before: DocumentState, equation: int, line: int
    ) -> list[Outcome]:
        """Return what becomes of an equation under the rates or the velocity that are given, where it holds or is a slip away; else nothing."""
        for reading, meanings in under.readings(chain):
            after = self.names.state.copy()
            self.names.state.become(before)
            self.names.state.inferred |= meanings
            self.names.state.told = under.told_besides
            tried = self.chain(reading, equation, line, False)
            self.names.state.become(before)
            wrong = [each for each in tried if each.verdict not in HOLDS]
            is_meant = before.told.has_shown or before.told.line in (0, line)
            if tried and (not wrong or (is_meant and all(each.verdict is Verdict.REFUTED for each in wrong))):
                tried = [under.unless_data(each) for each in tried] if len(tried) == 1 else tried
                tried = [each.unless_slip(say(Kind.OTHER_AS_TOLD)) for each in tried]
                for each in tried:
                    each.read_as = each.read_as if JACOBIAN.key not in each.read_as else ""
                    if each.verdict in HOLDS:
                        each.also(say(Kind.UNDER_RATES))
                self.names.state.told = replace(before.told, has_shown=True)
                return tried
            self.names.state.become(after)
        return []

    def chain(self, chain: n.Chain, equation: int, line: int, define: bool) -> list[Outcome]:
        """Return the outcomes of a chain, each with the definitions that it rests on."""
        self.begin()
        outcomes = self._read_chain(chain, equation, line, define)
        again = partial(self._read_chain, chain, equation, line, False)
        if self.names.state.signs.read:
            outcomes = unless_of_a_sign(self.names, outcomes, again)
        if self.names.state.given():
            outcomes = asked_of_the_tool(self.names, outcomes, again)
        if self.names.offset_joints:
            outcomes = self.checker.angles.settled(chain, outcomes, define, again)
        of_jacobian = self.checker.members.speaks_of_jacobian(chain)
        if of_jacobian and (doubt := self.checker.rows.others((chain,), outcomes, again)) is not None:
            outcomes = [outcome.left_open(doubt) for outcome in outcomes]
        if not chain.relations and not outcomes:
            return [] if _is_label(chain) else [Outcome(Verdict.DEFINED, (say(Kind.NO_EQUATION),), equation)]
        outcomes = [self._of_own_sums(outcome, chain) for outcome in outcomes]
        if any(isinstance(below, n.Dots) for below in n.walk(chain)):
            unwritten = say(Kind.TERMS_UNWRITTEN, text="…")
            outcomes = [each.unless_refuted(unwritten) for each in outcomes]
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
        if (
            text := self.names.state.from_text()
        ):  # it may speak of one case: only a slip in what follows from it is refuted
            outcomes = [each.unless_slip(say(Kind.AS_TEXT_SAYS, name=text[0])) for each in outcomes]
        defined = {(key, line) for outcome in outcomes for key in outcome.defines}
        for outcome in outcomes:  # c_3 = … := D names what is decided beside it
            met = {key for key in self.consulted() if key[0] not in outcome.defines and key != outcome.repeats}
            outcome.uses = frozenset(met | defined if outcome.verdict in DECIDED else met)
            if define and outcome.verdict in HOLDS:
                self.names.state.held |= outcome.uses
        return outcomes

    def unless_doubted(self, outcome: Outcome, beside: Set[Key] = frozenset()) -> Outcome:
        """Leave open what a definition that may be a mistake decides: it proves nothing, and may be the mistake itself.

        What is only defined beside it, R of R = R_z(φ) R_y(θ) = […], is none of its sides. The last of two meanings is no mistake where a joint or a quantity of the arm is what it then says.
        """
        if outcome.verdict not in DECIDED or self.is_closed:
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
        self.names.state.consulted.clear()
        self.names.state.signs.read.clear()

    def consulted(self) -> frozenset[tuple[str, int]]:
        """Return the definitions and the named signs that were met since the last beginning."""
        signs = self.names.state.signs
        return frozenset(self.names.state.consulted) | {(key, signs.lines.get(key, 0)) for key in signs.read}

    def _at_values(self, chain: n.Chain, equation: int, line: int, define: bool) -> list[Outcome]:
        self.begin()
        if _is_of_rank(chain):
            return self.circumstances.of_ranks(chain, self.chain(chain, equation, line, define), line)
        there = self._at_told_values(chain, equation, line)
        if any(outcome.verdict in DECIDED for outcome in there):
            return [replace(self.unless_doubted(outcome), uses=self.consulted()) for outcome in there]
        outcomes = self.chain(chain, equation, line, define)
        is_open = any(each.verdict not in HOLDS for each in outcomes) and not any(
            each.verdict is Verdict.REFUTED and each.true is not None and not is_number(each.true.node)
            for each in outcomes
        )
        if is_open and (worked := self._of_worked_example(chain, equation, line)):
            return worked
        outcomes = self._with_wrong_numbers(chain, outcomes, equation, line)
        for outcome in outcomes if there else ():
            if outcome.tells(Kind.NUMBERS_OF_NOWHERE):
                outcome.findings = there[0].findings
        return outcomes

    def _of_worked_example(self, chain: n.Chain, equation: int, line: int) -> list[Outcome]:
        """Return the outcomes of numbers that hold at the values given last, under whatever heading; [] where some do not.

        What is "Given" in centimetres is often worked out without a unit. Only one number of a matrix is refuted there, of which
        many others are right: else the numbers may be of other values.
        """
        state = self.names.state
        if not state.given_last or set(chain.relations) != {"="} or not any(map(tells_values, chain.members)):
            return []
        before = state.copy()
        for given in unitless(state.given_last):
            state.configuration = {key: replace(each, section=state.section) for key, each in given.items()}
            self.begin()
            steps = [replace(chain, members=pair, relations=("=",)) for pair in pairwise(chain.members)]
            outcomes = [o for k, step in enumerate(steps) for o in self._read_chain(step, equation + k, line, False)]
            held = [each for each in outcomes if each.verdict in HOLDS]
            slips = [each for each in outcomes if each not in held and is_mostly_right(each, MANY)]
            tells = any(each.tells(Kind.TO_DECIMALS_THERE) for each in held) or slips
            if outcomes and tells and len(held) + len(slips) == len(outcomes):
                state.configuration = before.configuration
                return [replace(self.unless_doubted(each), uses=self.consulted()) for each in outcomes]
            state.become(before)
        return []

    def _at_told_values(self, chain: n.Chain, equation: int, line: int) -> list[Outcome]:
        """Return what becomes of numbers at the values that the text before gives; [] where there are none.

        What is not decided there leaves no trace. Only few numbers of many are refuted there, and fewer still that do not stand right behind the text.
        """
        state = self.names.state
        speaks = state.told.standing or state.told_lengths
        if not speaks or len(chain.members) < 2 or not any(map(is_numbers, chain.members)):
            return []
        before = state.copy()
        state.configuration = self.circumstances.told_values() | state.configuration
        outcomes = self._read_chain(chain, equation, line, False)
        wrong = [each for each in outcomes if each.verdict not in HOLDS]
        times = 1 if state.told.line == line else MANY
        if not wrong or all(is_mostly_right(each, times) for each in wrong):
            state.configuration = before.configuration
            return outcomes
        state.become(before)
        return [each.left_open(say(Kind.OTHER_AS_TOLD)) for each in wrong if each.verdict is Verdict.REFUTED]

    def _of_own_sums(self, outcome: Outcome, chain: n.Chain) -> Outcome:
        """A θ_{34} that the document says to be θ_3 - θ_4 is what it says: that is no claim, and what then fails is left open."""
        digits = next(filter(None, map(self.names.own_sum, n.walk(chain))), "")
        alone = [each.arguments[0] if isinstance(each, n.Call) else each for each in map(bare, chain.members)]
        says_so = any(self.names.own_sum(each) for each in alone)
        if not digits or not (outcome.verdict is Verdict.REFUTED or (says_so and outcome.verdict is Verdict.PROVED)):
            return outcome
        return outcome.left_open(say(Kind.OWN_SUM, digits=digits))

    def _read_chain(self, chain: n.Chain, equation: int, line: int, define: bool) -> list[Outcome]:
        unclear = [below for below in n.walk(chain) if isinstance(below, n.Ambiguous)]
        if unclear:
            return self._either_reading(chain, unclear, equation, line, define)
        if self.names.arm is None and (letters := crossed_letters(self.names, chain)):
            check = partial(self._clear_chain, chain, equation, line)
            return of_vectors(self.names, chain, letters, line, define, check)
        if parts := side_by_side(chain):
            return self._side_by_side(chain, parts, equation, line, define)
        return self._clear_chain(chain, equation, line, define)

    def _side_by_side(
        self, chain: n.Chain, parts: Sequence[n.Chain], equation: int, line: int, define: bool
    ) -> list[Outcome]:
        """A = […] B = […] is two equations, unless it holds as one: what is wrong in one reading alone is left open."""
        as_one = self._clear_chain(chain, equation, line, False)
        if hold(as_one):
            return self._clear_chain(chain, equation, line, define)
        apart = [o for k, part in enumerate(parts) for o in self._clear_chain(part, equation + k, line, define)]
        if any(outcome.verdict is Verdict.REFUTED for outcome in as_one):
            return apart
        doubt = say(Kind.SIDE_BY_SIDE, name=parts[1].members[0].text)  # type: ignore[attr-defined]
        return [outcome.unless_refuted(doubt) for outcome in apart]

    def _either_reading(
        self, chain: n.Chain, unclear: list[n.Ambiguous], equation: int, line: int, define: bool
    ) -> list[Outcome]:
        """Take the reading of a/2b under which the equation holds; the message names the choice."""
        chains = []
        for k in (0, 1):
            read = chain
            for below in unclear:
                read = n.substitute(read, below, below.readings[k])  # type: ignore[assignment]
            chains.append(read)
        tried = [self._clear_chain(read, equation, line, False) for read in chains]
        good = [all(o.verdict not in (Verdict.REFUTED, Verdict.UNCHECKED) for o in outcomes) for outcomes in tried]
        chosen = 1 if good[1] and not good[0] else 0
        outcomes = self._clear_chain(chains[chosen], equation, line, define)
        whole = isinstance(unclear[0].readings[chosen], n.Quotient)
        choice = Kind.SLASH_OVER_ALL if whole else Kind.SLASH_OVER_NEXT
        for outcome in outcomes:
            outcome.also(say(choice if any(good) else Kind.SLASH_UNCLEAR, text=unclear[0].text))
        return outcomes

    def _clear_chain(self, chain: n.Chain, equation: int, line: int, define: bool) -> list[Outcome]:
        if (plain := without_count(chain, self.names)) is not None:
            outcomes = self._clear_chain(plain, equation, line, False)
            if outcomes and all(outcome.verdict in HOLDS for outcome in outcomes):
                outcomes[0].also(say(Kind.COUNTS_SOLUTIONS))
                self._claimed(chain, equation, line, define)  # what is said of that solution from here on
                return outcomes
        if (said := self._stated(chain, equation, line, define)) is not None:
            return [said, *self._numbers_behind(chain, said, equation, line)]
        if any(relation != "=" for relation in chain.relations):
            parts = [(equation + at, part) for at, part in parts_of(chain)]
            return [outcome for number, part in parts for outcome in self._related(part, number, line, define)]
        if any(isinstance(member, n.Cases) for member in chain.members):
            return check_cases(self.checker, chain, equation, line, define)
        return self._claimed(chain, equation, line, define)

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
        if (given := self.given.read(chain, line, define)) is not None:
            return Outcome(Verdict.DEFINED, (say(Kind.CONFIGURATION),), equation, defines=given)
        if not self.given.is_condition(chain):
            return None
        if (known := self._holds_there(chain, equation, line)) is not None:
            return known
        if define:
            self._relate(chain, line)
        return Outcome(Verdict.DEFINED, (say(Kind.CONDITION),), equation)

    def _holds_there(self, chain: n.Chain, equation: int, line: int) -> Outcome | None:
        """Return θ_1 + θ_2 = π/2 as a claim behind values of θ_1 and θ_2 with which it holds: it ends no configuration."""
        symbols = {
            self.names.known_symbol(each.key) for m in chain.members for each in n.walk(m) if isinstance(each, n.Name)
        }
        if len(chain.members) != 2 or not symbols & set(self.given.joints) <= self.names.state.configuration.keys():
            return None
        outcomes = self.checker.check(chain, equation, line, define=False)
        return outcomes[0] if [each.verdict for each in outcomes] == [Verdict.CONFIRMED] else None

    def _relate(self, chain: n.Chain, line: int) -> None:
        """Keep what joints, or lengths, are said to be: l_1 = l_2, of which l may be the letter."""
        related = self.given.related(chain)
        if not related:
            return
        self.circumstances.of_display(replace(chain, members=tuple(related), relations=("=",) * (len(related) - 1)))
        for letter in (bare_key(each) for each in chain.members if each not in related):
            self.names.define(str(letter), self.checker.members.meaning(related[0]), line, node=related[0])

    def _numbers_behind(self, chain: n.Chain, said: Outcome, equation: int, line: int) -> list[Outcome]:
        """θ_1 = atan2(1, 0) = 90°: the numbers of a value that is given are to be equal."""
        if len(chain.members) < 3 or said.role is not Role.CLAIM or not all(map(is_number, chain.members[1:])):
            return []
        found = self._unequal(chain, 1, equation, line)
        return [each for each in found if not (self.given.places_joints(chain) and self._are_turns_apart(each))]

    def _with_wrong_numbers(self, chain: n.Chain, outcomes: list[Outcome], equation: int, line: int) -> list[Outcome]:
        """φ = θ_1 + θ_2 = 30° + 45° = 85°: numbers at the end of a chain are to be equal, of whatever values they are."""
        is_open = {each.equation for each in outcomes if each.verdict is Verdict.UNCHECKED}
        if not is_open or set(chain.relations) != {"="}:
            return outcomes
        first = len(chain.members) - len(list(takewhile(is_number, reversed(chain.members))))
        if first < 1 or len(chain.members) - first < 2:
            return outcomes
        if not any(map(tells_values, chain.members[first:])):
            return outcomes
        wrong = {each.equation: each for each in self._unequal(chain, first, equation, line)}
        return [wrong.get(each.equation, each) if each.equation in is_open else each for each in outcomes]

    def _unequal(self, chain: n.Chain, first: int, equation: int, line: int) -> list[Outcome]:
        """Return what is refuted among the numbers from a member on."""
        rest = replace(chain, members=chain.members[first:], relations=chain.relations[first:])
        found = self._claimed(rest, equation + first, line, False)
        return [each for each in found if each.verdict is Verdict.REFUTED]

    def _are_turns_apart(self, outcome: Outcome) -> bool:
        """Whether two numbers are the same angle: -90° = 270°."""
        pair = outcome.pair
        return pair is not None and pair.is_scalar and self._is_turn(pair.true.rows[0][0] - pair.printed.rows[0][0])

    def _is_turn(self, apart: Scalar) -> bool:
        return abs(remainder(self.checker.members.number(apart), tau)) < CLOSE

    def _related(self, part: n.Chain, equation: int, line: int, define: bool) -> list[Outcome]:
        if part.relations[0] == "=":
            return self._clear_chain(part, equation, line, define)
        if (small := of_small_ones(part, self.names)) is not None:
            near = self._claimed(small, equation, line, False)
            if all(each.verdict in DECIDED for each in near):
                near[0].also(say(Kind.FIRST_ORDER))
                return near
        return [check_relation(self.checker, part, equation)]

    def _claimed(self, chain: n.Chain, equation: int, line: int, define: bool) -> list[Outcome]:
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
        if define and any(o.tells(Kind.NUMBERS_OF_NOWHERE) for o in outcomes):
            self.circumstances.of_display(chain, holds_nowhere=True)
        outcomes = [self._understood(o, chain, define) if o.verdict is Verdict.REFUTED else o for o in outcomes]
        if self.names.state.told.bounds:
            outcomes = [self.circumstances.within_bounds(outcome) for outcome in outcomes]
        if any(outcome.verdict is Verdict.PROVED for outcome in outcomes) and _multiplies_a_matrix(chain):
            outcomes = self._with_factors(chain, outcomes, equation)
        if any(outcome.tells(Kind.NOT_AS_USUAL_BOUND) for outcome in outcomes):
            outcomes = self._with_sign_of_vectors(chain, outcomes, line)
        is_open = bool(outcomes) and all(o.verdict in (Verdict.UNCHECKED, Verdict.DEFINED) for o in outcomes)
        return self._of_any_jacobian(chain, outcomes, define) if is_open else outcomes

    def _of_any_jacobian(self, chain: n.Chain, outcomes: list[Outcome], define: bool) -> list[Outcome]:
        """Prove a law of any Jacobian; refute what is a slip away from one where the document has shown which matrix J is."""
        if holds_of_any_jacobian(chain, self.names):
            self.names.state.tells_jacobian |= define and tells_jacobian(chain)
            known = (say(Kind.OF_ANY_JACOBIAN),)
            return [replace(each, verdict=Verdict.PROVED, findings=known, role=Role.LAW) for each in outcomes]
        is_known = self.names.state.tells_jacobian or "J" in self.names.state.shown
        if not is_known or len(outcomes) > 1 or is_step_along_gradient(chain):
            return outcomes
        holds = partial(holds_of_any_jacobian, names=self.names)
        slip = slip_of_law(chain, holds, turns=True) if not holds(with_inverses(chain)) else None
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

    def _understood(self, outcome: Outcome, chain: n.Chain, define: bool) -> Outcome:
        """Return a refuted outcome, left open where the chain or what the text says may be meant otherwise."""
        outcome = without_misreading(outcome, chain, self.names, not define, self.is_closed)
        if self.names.arm is None and self.names.state.compares_lengths and self.ring.signs_chosen:
            outcome = outcome.unless_refuted(say(Kind.ROOTS_POSITIVE))  # a > b says which sign √((a − b)²) has
        speaks = self.names.state.told != Told() and outcome.verdict is Verdict.REFUTED
        return self.circumstances.judge(outcome) if speaks else outcome

    def _decided(self, chain: n.Chain, equation: int, line: int, define: bool) -> list[Outcome]:
        outcomes = self.checker.check(chain, equation, line, define)
        undecided = all(outcome.verdict in (Verdict.UNCHECKED, Verdict.DEFINED) for outcome in outcomes)
        frames = self.names.arm.frames if self.names.arm is not None else ()
        if not (undecided and outcomes):
            return outcomes
        if is_composition(chain, frames) or is_elementary_rotation(self.general, chain, equation, line):
            return [replace(each, verdict=Verdict.PROVED, findings=(), role=Role.LAW) for each in outcomes]
        if (direction := direction_of_any_frames(self.names, chain)) is not None:
            self.names.state.transforms = (
                direction if define and self.names.arm is None else self.names.state.transforms
            )
            self.begin()  # it rests on nothing that the document says of these names
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


def _defined_beside(outcome: Outcome, own: Set[str], line: int) -> Set[Key]:
    """Return what a chain defines that is on no side of one of its equations."""
    return {(key, line) for key in own - {name.key for name in names_in(outcome)}} if own else frozenset()


def _is_of_rank(chain: n.Chain) -> bool:
    """Whether a rank stands in a chain that does not say itself at which values."""
    below = [*n.walk(chain)]
    return any(map(n.is_rank, below)) and not any(isinstance(each, n.At) for each in below)


def _is_label(chain: n.Chain) -> bool:
    """Whether a number in brackets stands alone, as equations are numbered: (3)."""
    (member,) = chain.members
    return isinstance(member, n.Group) and isinstance(member.inner, n.Number)


def _has_letter_index(chain: n.Chain) -> bool:
    """Whether a name in a chain has a letter for its index, as what is said of any link does: A_n, {}^jT_{j+1}; or α has none."""
    names = [below for below in n.walk(chain) if isinstance(below, n.Name)]
    if any(name.base == "alpha" and not name.sub for name in names):
        return True
    return any(script[:1] in {*"ijkn"} for name in names for script in (name.sub, name.pre_sub))


def _multiplies_a_matrix(chain: n.Chain) -> bool:
    """Whether a matrix that is printed is a factor in a chain."""
    products = (below for below in n.walk(chain) if isinstance(below, n.Product))
    return any(isinstance(n.bare(factor), n.Matrix) for product in products for factor in product.factors)
